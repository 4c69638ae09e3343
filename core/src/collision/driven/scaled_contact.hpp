#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/driven_law.hpp>
#include <ricochet/collision/instant.hpp>

#include <cstddef>
#include <optional>

namespace ricochet::collision {

/// The collision x'' + f = p, x(0) = 0, x'(0) = 1, p a constant load that presses the bodies together, in the units of
/// its impact: velocity v₀, a time T, length v₀T, force m v₀/T. Steps it by the implicit trapezoid
///   w₁ = w₀ + h p − h (f₀ + f₁)/2,  x₁ = x₀ + h (w₀ + w₁)/2,
/// with the memory advanced along the rate that is linear from w₀ to w₁. The step is its own inverse when time runs
/// backwards, as `advance` is exact for such a rate: errors over a smooth mesh are a series in even powers of 1/N.
/// Overlaps below 0 are shown to the law as 0: it need not be defined there.
class ScaledContact {
 public:
  /// `load` in N.
  ScaledContact(DrivenLaw& law, const Impact& impact, double unit, double load = 0)
      : law_(law), impact_(impact), unit_(unit), load_(scaled(load)) {}

  /// Begins at the first touch.
  Instant touch();
  /// One step of length h from `now`; the memory stays at `now` until `accept`.
  Instant step(const Instant& now, double h);
  void accept() { law_.accept(); }
  void mark() { law_.mark(); }
  void back() { law_.back(); }

  std::size_t evaluations() const noexcept { return evaluations_; }
  double unit() const noexcept { return unit_; }

 private:
  Approach in_units(double x, double w) const noexcept;
  double scaled(double force) const noexcept { return force * (unit_ / (impact_.mass_eff * impact_.velocity)); }

  DrivenLaw& law_;
  Impact impact_;
  double unit_;           // T [s]
  double load_;           // p
  double stiffness_ = 0;  // rise of f₁ with w₁ in the last step, over its length: where the next one starts
  std::size_t evaluations_ = 0;
};

/// A time [s] in which the law takes some part of the momentum m v₀ from a body that keeps its velocity; none when no
/// time up to 1e100 s is long enough.
std::optional<double> time_scale(DrivenLaw& law, const Impact& impact);

}  // namespace ricochet::collision
