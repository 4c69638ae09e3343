#pragma once

#include <ricochet/motion/linked_cells.hpp>

#include <cmath>
#include <span>
#include <vector>

namespace ricochet {

/// Space that repeats itself: whoever leaves the cell on one side is at the same place on the other, and bodies meet
/// across. No period (0) along an axis: space has no end there. Positions are not brought back into the cell.
struct Periodic {
  Vec3 period{};  ///< [m], ≥ 0

  bool any() const noexcept { return period != Vec3{}; }
  /// The shortest way between two points that `way` leads between.
  Vec3 shortest(Vec3 way) const noexcept {
    const auto fold = [](double x, double L) { return L > 0 ? x - L * std::nearbyint(x / L) : x; };
    return {fold(way.x, period.x), fold(way.y, period.y), fold(way.z, period.z)};
  }
};

/// near_pairs where space repeats: pairs that are near across a border are listed too, each once. Periods must be more
/// than 4 r_max + 2 skin (or 0), so that two spheres are near in one way only; throws std::invalid_argument else, and
/// as near_pairs does. Linear in the number of spheres, as those near a border are looked at once more for each.
std::vector<NearPair> near_pairs(std::span<const Vec3> positions, std::span<const double> radii, double skin,
                                 const Periodic& periodic);

}  // namespace ricochet
