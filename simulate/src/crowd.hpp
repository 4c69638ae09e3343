#pragma once

#include <ricochet/motion/engine/surface.hpp>
#include <ricochet/motion/periodic.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace ricochet::simulate {

/// Overlaps up to this share of a radius are rounding.
inline constexpr double touching = 1e-9;

/// Spheres and walls, to be asked whether there is room for another sphere.
class Crowd {
 public:
  /// `largest`: no sphere that comes has a greater radius. Walls as they are at `time`.
  Crowd(double largest, const Periodic& periodic, std::span<const Wall> walls, double time);

  void add(Vec3 position, double radius);
  bool room_for(Vec3 position, double radius) const;  ///< touching nobody

 private:
  struct Cell {
    std::array<std::int64_t, 3> at;
    bool operator==(const Cell&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Cell& c) const noexcept;
  };
  struct Member {
    Vec3 position;
    double radius = 0;
  };
  Cell cell_of(Vec3 position) const noexcept;

  Periodic periodic_;
  std::vector<motion::Surface> walls_;
  double time_;
  std::array<double, 3> edge_{};
  std::array<std::int64_t, 3> count_{};  // of cells, where space repeats itself; else 0
  std::unordered_map<Cell, std::vector<Member>, Hash> cells_;
};

}  // namespace ricochet::simulate
