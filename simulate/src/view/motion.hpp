#pragma once

#include "trajectory_file.hpp"

#include <ricochet/motion/bodies.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ricochet::simulate {

/// Two spheres that overlap, by their places in the frame.
struct SeenPair {
  std::uint32_t i = 0, j = 0;
};

/// A sphere that overlaps a wall, and the unit vector from its centre towards the wall.
struct SeenTouch {
  std::uint32_t i = 0;
  Vec3 towards{};
};

/// A box along the axes.
struct Region {
  Vec3 low, high;
};

/// What a page shows of a run: some of its frames, and who overlaps in each.
struct ShownMotion {
  std::size_t frames_written = 0;  ///< of which `frames` are shown
  std::vector<SeenFrame> frames;
  std::vector<std::vector<SeenPair>> pairs;
  std::vector<std::vector<SeenTouch>> touches;
  std::vector<std::string> species;
  /// Every sphere that is there at some time, in the order of coming; of each frame, which of them are there.
  std::vector<SeenGrain> cast;
  std::vector<std::vector<std::uint32_t>> present;

  /// Around all centres.
  Region centres() const;
  /// Around all spheres but a few that went astray: what a picture shall show.
  Region focus() const;
};

/// The most of spheres times frames that a page holds: 16 MB of places, speeds and spins.
inline constexpr std::size_t most_shown = 1'600'000;

/// Reads all frames, or, where these are more than `most` spheres times frames, as many as fit, two at least, evenly
/// spread from the first to the last.
ShownMotion read_motion(TrajectoryFile& file, const ClusterSetup& setup, std::size_t most = most_shown);

}  // namespace ricochet::simulate
