#include "crowd.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet::simulate {
namespace {

constexpr std::array axes{&Vec3::x, &Vec3::y, &Vec3::z};

std::int64_t wrapped(std::int64_t index, std::int64_t count) noexcept {
  return count > 0 ? (index % count + count) % count : index;
}

}  // namespace

Crowd::Crowd(double largest, const Periodic& periodic, std::span<const Wall> walls, double time)
    : periodic_(periodic), walls_(walls.begin(), walls.end()), time_(time) {
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const double period = periodic.period.*axes[a];
    edge_[a] = 2 * largest;
    if (period == 0) continue;
    count_[a] = std::max<std::int64_t>(1, static_cast<std::int64_t>(period / edge_[a]));
    edge_[a] = period / static_cast<double>(count_[a]);
  }
}

std::size_t Crowd::Hash::operator()(const Cell& c) const noexcept {
  std::uint64_t h = 0;
  for (const std::int64_t index : c.at) h = (h ^ static_cast<std::uint64_t>(index)) * 0x9E3779B97F4A7C15u;
  return static_cast<std::size_t>(h ^ (h >> 29));
}

Crowd::Cell Crowd::cell_of(Vec3 p) const noexcept {
  Cell c{};
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const double index = std::clamp(std::floor(p.*axes[a] / edge_[a]), -1e15, 1e15);
    c.at[a] = wrapped(static_cast<std::int64_t>(index), count_[a]);
  }
  return c;
}

void Crowd::add(Vec3 position, double radius) { cells_[cell_of(position)].push_back({position, radius}); }

bool Crowd::room_for(Vec3 position, double radius) const {
  const bool free = std::ranges::none_of(walls_, [&](const motion::Surface& wall) {
    return wall.meet(position, radius, time_).overlap > touching * radius;
  });
  if (!free) return false;
  const Cell home = cell_of(position);
  for (int k = 0; k < 27; ++k) {
    const std::array<int, 3> step{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
    Cell near = home;
    for (std::size_t a = 0; a < near.at.size(); ++a) near.at[a] = wrapped(home.at[a] + step[a], count_[a]);
    const auto found = cells_.find(near);
    if (found == cells_.end()) continue;
    for (const Member& other : found->second) {
      const Vec3 way = periodic_.shortest(other.position - position);
      const double reach = (radius + other.radius) * (1 - touching);
      if (dot(way, way) < reach * reach) return false;
    }
  }
  return true;
}

}  // namespace ricochet::simulate
