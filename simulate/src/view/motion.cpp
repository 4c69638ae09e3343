#include "motion.hpp"

#include <console/exit.hpp>
#include <ricochet/motion/linked_cells.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ricochet::simulate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::size_t> evenly_spread(std::size_t frames, std::size_t kept) {
  std::vector<std::size_t> numbers;
  numbers.reserve(kept);
  for (std::size_t k = 0; k < kept; ++k)
    numbers.push_back(kept == 1 ? 0 : (k * (frames - 1) + (kept - 1) / 2) / (kept - 1));
  return numbers;
}

std::vector<SeenPair> overlapping(const SeenFrame& frame) {
  std::vector<Vec3> positions;
  std::vector<double> radii;
  for (const SeenGrain& g : frame.grains) positions.push_back(g.position), radii.push_back(g.radius);
  std::vector<SeenPair> pairs;
  for (const auto& [i, j] : near_pairs(positions, radii, 0)) pairs.push_back({i, j});
  return pairs;
}

std::vector<SeenTouch> touching(const SeenFrame& frame, const std::vector<Wall>& walls) {
  std::vector<SeenTouch> touches;
  for (const Wall& wall : walls) {
    const Vec3 inward = wall.inward / norm(wall.inward);
    for (std::uint32_t i = 0; i < frame.grains.size(); ++i)
      if (dot(frame.grains[i].position - wall.point, inward) < frame.grains[i].radius) touches.push_back({i, -inward});
  }
  return touches;
}

// Spheres are known by their place in the frame: a page cannot follow a sphere that changes it.
void check_same(const SeenFrame& a, const SeenFrame& b) {
  for (std::size_t i = 0; i < std::min(a.grains.size(), b.grains.size()); ++i)
    if (a.grains[i].radius != b.grains[i].radius)
      throw console::BadInput(fmt::format(
          "trajectory.xyz: sphere {} has another radius at {} s than before: only spheres that stay the same are shown",
          i + 1, b.time));
}

std::array<double, 3> by_axis(Vec3 v) { return {v.x, v.y, v.z}; }

}  // namespace

const SeenFrame& ShownMotion::fullest() const {
  return *std::max_element(frames.begin(), frames.end(),
                           [](const auto& a, const auto& b) { return a.grains.size() < b.grains.size(); });
}

Region ShownMotion::centres() const {
  Region all{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const SeenFrame& frame : frames)
    for (const SeenGrain& g : frame.grains) {
      all.low = {std::min(all.low.x, g.position.x), std::min(all.low.y, g.position.y),
                 std::min(all.low.z, g.position.z)};
      all.high = {std::max(all.high.x, g.position.x), std::max(all.high.y, g.position.y),
                  std::max(all.high.z, g.position.z)};
    }
  return all;
}

Region ShownMotion::focus() const {
  // A sphere far out would leave nothing to see of the others. What is out by more than the extent of all but a
  // hundredth at either end is left out.
  std::array<std::vector<double>, 3> values;
  double radius = 0;
  for (const SeenFrame& frame : frames)
    for (const SeenGrain& g : frame.grains) {
      const auto at = by_axis(g.position);
      for (std::size_t a = 0; a < 3; ++a) values[a].push_back(at[a]);
      radius = std::max(radius, g.radius);
    }
  std::array<double, 3> low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    std::sort(values[a].begin(), values[a].end());
    const auto quantile = [&](double q) {
      return values[a][static_cast<std::size_t>(q * static_cast<double>(values[a].size() - 1))];
    };
    const double margin = quantile(0.99) - quantile(0.01) + 2 * radius;
    low[a] = std::max(values[a].front(), quantile(0.01) - margin) - radius;
    high[a] = std::min(values[a].back(), quantile(0.99) + margin) + radius;
  }
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

ShownMotion read_motion(TrajectoryFile& file, const std::vector<Wall>& walls, std::size_t most) {
  ShownMotion shown;
  shown.frames_written = file.size();
  std::size_t grains = 0;
  for (std::size_t k = 0; k < file.size(); ++k) grains = std::max(grains, file.grains(k));
  if (grains == 0) throw console::BadInput("trajectory.xyz: no frame holds a sphere");
  const std::size_t kept = std::min(file.size(), std::max<std::size_t>(2, most / grains));
  for (const std::size_t number : evenly_spread(file.size(), kept)) {
    shown.frames.push_back(file.frame(number));
    const SeenFrame& frame = shown.frames.back();
    check_same(shown.fullest(), frame);
    shown.pairs.push_back(overlapping(frame));
    shown.touches.push_back(touching(frame, walls));
  }
  shown.species = file.species();
  return shown;
}

}  // namespace ricochet::simulate
