#include "motion.hpp"

#include <console/exit.hpp>
#include <ricochet/motion/engine/surface.hpp>
#include <ricochet/motion/periodic.hpp>
#include <simulate/view.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

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

std::vector<SeenPair> overlapping(const SeenFrame& frame, const Periodic& periodic) {
  std::vector<Vec3> positions;
  std::vector<double> radii;
  for (const SeenGrain& g : frame.grains) positions.push_back(g.position), radii.push_back(g.radius);
  std::vector<SeenPair> pairs;
  for (const auto& [i, j] : near_pairs(positions, radii, 0, periodic)) pairs.push_back({i, j});
  return pairs;
}

std::vector<SeenTouch> touching(const SeenFrame& frame, const std::vector<motion::Surface>& walls) {
  std::vector<SeenTouch> touches;
  for (const motion::Surface& wall : walls)
    for (std::uint32_t i = 0; i < frame.grains.size(); ++i) {
      const ContactGeometry g = wall.meet(frame.grains[i].position, frame.grains[i].radius, frame.time);
      if (g.overlap > 0) touches.push_back({i, g.normal});
    }
  return touches;
}

/// Who is who in all frames.
class Cast {
 public:
  explicit Cast(ShownMotion& shown) : shown_(shown) {}
  void see(const SeenFrame& frame) {
    std::vector<std::uint32_t> present;
    present.reserve(frame.grains.size());
    for (const SeenGrain& g : frame.grains) {
      const auto [known, fresh] = places_.emplace(g.id, static_cast<std::uint32_t>(shown_.cast.size()));
      if (fresh) shown_.cast.push_back(g);
      if (shown_.cast[known->second].radius != g.radius)
        throw console::BadInput(
            fmt::format("trajectory.xyz: sphere {} has another radius at {} s than before", g.id, frame.time));
      present.push_back(known->second);
    }
    shown_.present.push_back(present);
  }

 private:
  ShownMotion& shown_;
  std::unordered_map<std::uint64_t, std::uint32_t> places_;
};

std::array<double, 3> by_axis(Vec3 v) { return {v.x, v.y, v.z}; }

}  // namespace

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

ShownMotion read_motion(TrajectoryFile& file, const ClusterSetup& setup, std::size_t most) {
  ShownMotion shown;
  shown.frames_written = file.size();
  std::size_t grains = 0;
  for (std::size_t k = 0; k < file.size(); ++k) grains = std::max(grains, file.grains(k));
  if (grains == 0) throw NothingToShow("trajectory.xyz: no frame holds a sphere");
  const std::size_t kept = std::min(file.size(), std::max<std::size_t>(2, most / grains));
  const std::vector<motion::Surface> walls(setup.walls.begin(), setup.walls.end());
  Cast cast(shown);
  for (const std::size_t number : evenly_spread(file.size(), kept)) {
    shown.frames.push_back(file.frame(number));
    const SeenFrame& frame = shown.frames.back();
    cast.see(frame);
    shown.pairs.push_back(overlapping(frame, setup.periodic));
    shown.touches.push_back(touching(frame, walls));
  }
  shown.species = file.species();
  return shown;
}

}  // namespace ricochet::simulate
