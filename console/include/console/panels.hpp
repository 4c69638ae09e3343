#pragma once

#include <console/plot.hpp>

#include <string>
#include <vector>

namespace ricochet::console {

/// One moment of a collision, SI units.
struct Moment {
  double time, overlap, velocity, force;
};

struct Motion {
  std::string title;
  std::vector<Moment> moments;
};

/// Several collisions over time in three panels (overlap, velocity, force) and a key in the fourth. The CSV is in SI
/// units, the axes carry the prefix that suits the data.
Figure collision_panels(const std::string& name, const std::string& caption, const std::vector<Motion>& motions);

}  // namespace ricochet::console
