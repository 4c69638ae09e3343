#pragma once

#include <ricochet/contact/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ricochet {

struct NearPair {
  std::uint32_t i, j;  ///< i < j
  // NOLINTNEXTLINE(modernize-use-nullptr): seen in the code that clang 14 makes of it
  auto operator<=>(const NearPair&) const = default;
};

/// All pairs of spheres with |x_i − x_j| ≤ r_i + r_j + skin, ordered by (i, j). Space is unbounded: cells exist only
/// where spheres are, found by hashing. Spheres whose radii are within a factor of two share a grid of edge 2 r + skin,
/// r the greatest of them, and each sphere looks into those of its own size and of the larger ones: time and memory
/// linear in the number of spheres (and one sort of the pairs), times the number of such grids, while as many spheres
/// fit side by side as do not overlap. Throws std::invalid_argument for spans of unequal length, a radius not finite
/// and > 0 or a negative skin.
std::vector<NearPair> near_pairs(std::span<const Vec3> positions, std::span<const double> radii, double skin);

/// Keeps near_pairs valid while spheres move. After `update(x)`, every pair that overlaps at x is listed: a pair not
/// listed had a gap > skin when the list was built, no sphere has moved by more than skin/2 since (else the list is
/// rebuilt first), so its gap is still > 0.
class NeighbourList {
 public:
  NeighbourList(std::vector<double> radii, double skin, Vec3 period = {});

  /// Makes the list valid for `positions`; true if it was rebuilt.
  bool update(std::span<const Vec3> positions);
  /// Whether spheres `first` … `last` − 1 allow that: the list is valid if all do.
  bool lists(std::span<const Vec3> positions, std::size_t first, std::size_t last) const noexcept;
  std::span<const NearPair> pairs() const noexcept { return pairs_; }
  double skin() const noexcept { return skin_; }

 private:
  std::vector<double> radii_;
  double skin_;
  Vec3 period_;  // of space, see Periodic
  std::vector<Vec3> built_at_;
  std::vector<NearPair> pairs_;
};

}  // namespace ricochet
