#include <ricochet/motion/linked_cells.hpp>
#include <ricochet/motion/periodic.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace ricochet {
namespace {

struct Cell {
  std::int32_t x, y, z;
  bool operator==(const Cell&) const = default;
};

// Whoever flies beyond 10⁹ cells shares the outermost one. Clamping never increases a distance, so two spheres less
// than a cell's edge apart are still in the same or in adjacent cells, whatever their place.
std::int32_t cell_index(double x, double edge) noexcept {
  constexpr double outermost = 1e9;
  const double index = std::floor(x / edge);
  return static_cast<std::int32_t>(index > -outermost ? std::min(index, outermost) : -outermost);
}

Cell cell_of(Vec3 p, double edge) noexcept {
  return {cell_index(p.x, edge), cell_index(p.y, edge), cell_index(p.z, edge)};
}

std::size_t hash(Cell c) noexcept {
  const auto word = [](std::int32_t v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)); };
  std::uint64_t h = word(c.x) * 0x9E3779B97F4A7C15u ^ word(c.y) * 0xC2B2AE3D27D4EB4Fu ^ word(c.z) * 0x165667B19E3779F9u;
  return static_cast<std::size_t>(h ^ (h >> 29));
}

// Spheres of alike sizes, in cells of an edge that two of them reach across; sorted by the bucket of their cell: one
// bucket is one contiguous range.
class Level {
 public:
  Level(std::span<const Vec3> positions, std::span<const std::uint32_t> spheres, double edge)
      : edge_(edge),
        mask_(std::bit_ceil(std::max<std::size_t>(spheres.size(), 1)) - 1),
        begin_(mask_ + 2),
        members_(spheres.size()) {
    for (const std::uint32_t i : spheres) ++begin_[bucket(cell_of(positions[i], edge)) + 1];
    for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (const std::uint32_t i : spheres) {
      const Cell cell = cell_of(positions[i], edge);
      members_[next[bucket(cell)]++] = {cell, i};
    }
  }

  // The spheres within an edge of this place, and some more.
  template <class Visit>
  void visit_around(Vec3 place, Visit&& visit) const {
    const Cell home = cell_of(place, edge_);
    for (std::int32_t x = home.x - 1; x <= home.x + 1; ++x)
      for (std::int32_t y = home.y - 1; y <= home.y + 1; ++y)
        for (std::int32_t z = home.z - 1; z <= home.z + 1; ++z) visit_cell({x, y, z}, visit);
  }

 private:
  struct Member {
    Cell cell;
    std::uint32_t sphere;
  };

  // Strangers of the same bucket are told apart by their cell.
  template <class Visit>
  void visit_cell(const Cell& c, Visit& visit) const {
    const std::size_t b = bucket(c);
    for (std::uint32_t k = begin_[b]; k < begin_[b + 1]; ++k)
      if (members_[k].cell == c) visit(members_[k].sphere);
  }
  std::size_t bucket(const Cell& c) const noexcept { return hash(c) & mask_; }

  double edge_;
  std::size_t mask_;
  std::vector<std::uint32_t> begin_;
  std::vector<Member> members_;
};

using Group = std::vector<std::uint32_t>;

// The spheres by size, each group's within a factor of two, the largest first.
std::vector<Group> by_size(std::span<const double> radii) {
  const double greatest = *std::max_element(radii.begin(), radii.end());
  std::map<int, Group> groups;
  for (std::uint32_t i = 0; i < radii.size(); ++i) groups[std::ilogb(greatest / radii[i])].push_back(i);
  std::vector<Group> sorted;
  sorted.reserve(groups.size());
  for (auto& [size, group] : groups) sorted.push_back(std::move(group));
  return sorted;
}

// A margin of 10⁻⁶ covers the rounding of x/edge up to the outermost cell.
double edge_of(const Group& group, std::span<const double> radii, double skin) {
  double greatest = 0;
  for (const std::uint32_t i : group) greatest = std::max(greatest, radii[i]);
  return (2 * greatest + skin) * (1 + 1e-6);
}

}  // namespace

std::vector<NearPair> near_pairs(std::span<const Vec3> positions, std::span<const double> radii, double skin) {
  if (positions.size() != radii.size()) throw std::invalid_argument("positions and radii must be of equal length");
  support::require_not_negative("skin", skin);
  for (double r : radii) support::require_positive("radius", r);
  std::vector<NearPair> pairs;
  if (positions.empty()) return pairs;
  // A sphere looks for those of its own size, each pair once, and for all the larger ones.
  std::vector<Level> levels;
  for (const Group& group : by_size(radii)) {
    levels.emplace_back(positions, group, edge_of(group, radii, skin));
    for (const std::uint32_t i : group) {
      const std::size_t first = pairs.size();
      for (const Level& level : levels) {
        const bool own = &level == &levels.back();
        level.visit_around(positions[i], [&](std::uint32_t j) {
          if (own && j <= i) return;
          const Vec3 d = positions[j] - positions[i];
          const double reach = radii[i] + radii[j] + skin;
          if (dot(d, d) <= reach * reach) pairs.push_back({std::min(i, j), std::max(i, j)});
        });
      }
      std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end());
    }
  }
  if (levels.size() > 1) std::sort(pairs.begin(), pairs.end());
  return pairs;
}

NeighbourList::NeighbourList(std::vector<double> radii, double skin, Vec3 period)
    : radii_(std::move(radii)), skin_(skin), period_(period) {
  support::require_not_negative("skin", skin);
}

bool NeighbourList::lists(std::span<const Vec3> positions, std::size_t first, std::size_t last) const noexcept {
  if (built_at_.size() != positions.size()) return false;
  // A hair below skin/2, so that rounding of the squares cannot admit a pair that has just begun to overlap.
  const double allowed = 0.25 * skin_ * skin_ * (1 - 1e-9);
  for (std::size_t i = first; i < last; ++i) {
    const Vec3 moved = positions[i] - built_at_[i];
    if (!(dot(moved, moved) <= allowed)) return false;
  }
  return true;
}

bool NeighbourList::update(std::span<const Vec3> positions) {
  if (lists(positions, 0, positions.size())) return false;
  pairs_ = near_pairs(positions, radii_, skin_, Periodic{period_});
  built_at_.assign(positions.begin(), positions.end());
  return true;
}

}  // namespace ricochet
