#pragma once

#include "deck_run.hpp"

#include <vector>

namespace engines {

/// Two grains that collide while they drift along x through the plane x = 0 between two ranks.
namespace crossing {
inline constexpr double tcol = 1e-4, en = 0.5, dt = tcol / 50, speed = 0.5, radius = 1.5e-3;
inline constexpr int steps = 160;
inline const Box box{{-0.02, -0.01, -0.01}, {0.02, 0.01, 0.01}};

/// Along `axis` of contact (0: one after the other crosses; 1: both at once), with a start such that they cross in the
/// middle of the contact, which begins after ten steps.
std::vector<Grain> pair(int axis, double drift);
/// Steps at which grain `i` is on the other side of x = 0 than the step before, while the force acts.
int crossings_in_contact(const std::vector<Frame>& frames, std::size_t i);
}  // namespace crossing

/// A thousand grains over the floor of a box, a loose lattice, stirred: as it is it would stand on friction alone for a
/// while.
namespace pouring {
inline constexpr double radius = 1.5e-3, spacing = 3.4e-3;
inline constexpr int side = 10;
inline constexpr double width = side * spacing;

std::vector<Grain> loose_lattice();
}  // namespace pouring

}  // namespace engines
