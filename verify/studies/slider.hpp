#pragma once

#include <ricochet/contact/tangential.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

/// What an engine does with its tangential spring and dashpot (docs/engines.md).
struct Rule {
  bool limits_spring_alone = false;  ///< and leaves the dashpot out of a contact that slides; else it limits their sum
  enum class Keeps {
    asked,   ///< the force while Mindlin's contact grows, the strain while it shrinks
    strain,  ///< both ways
    force    ///< both ways
  } keeps = Keeps::asked;
};

/// Spring, dashpot and limit of one contact, in one direction, as engines step them.
class Slider {
 public:
  explicit Slider(Rule rule) : rule_(rule) {}

  /// The traction of a spring and dashpot that are `now` as they are, after a slip u over dt.
  double act(const Spring& now, double u, double dt, double limit) {
    if (stiffness_ > 0 && rule_.keeps != Rule::Keeps::force) {
      const double grown = now.stiffness / stiffness_;
      force_ *= rule_.keeps == Rule::Keeps::strain ? grown : std::min(1.0, grown);
    }
    stiffness_ = now.stiffness;
    force_ -= now.stiffness * u * dt;
    const double viscous = -now.damping * u, wanted = force_ + viscous;
    if (rule_.limits_spring_alone) {
      if (std::abs(force_) <= limit) return wanted;
      force_ = std::copysign(limit, force_);
      return force_;
    }
    if (std::abs(wanted) <= limit) return wanted;
    force_ = std::copysign(limit, wanted) - viscous;
    return std::copysign(limit, wanted);
  }

 private:
  Rule rule_;
  double force_ = 0, stiffness_ = 0;  ///< of the spring
};

}  // namespace ricochet::verify
