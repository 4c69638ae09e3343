#pragma once

#include "deck_run.hpp"

#include <functional>
#include <string>
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

/// A grain that flies to and fro between two obstacles a free path `room` apart. Without gravity its speed after n
/// bounces is en^n times the first. The neighbour list's skin is to be wider than the whole path: it is never rebuilt,
/// so that the engine itself never forgets a contact.
namespace bouncing {
inline constexpr double tcol = 1e-4, en = 0.8, dt = tcol / 50, room = 2e-4;
inline const std::string skin = "0.001";
/// The ranks share the path: they meet at x = 0.0016, where the grain's centre passes at each flight.
inline const Box box{{-0.0048, -0.01, -0.01}, {0.008, 0.01, 0.01}};
std::string processors(int ranks);
/// The grain that flies, and behind it the obstacles, if they are grains: at rest, numbers 2 and 3. If not they are
/// planes at x = 0 and 0.0032.
std::vector<Grain> grains(bool obstacles);
int steps_of_run();

/// The deck of so many ranks, in a place of its own.
using Deck = std::function<std::string(const Workplace& place, int ranks)>;
/// Runs it on one rank and on two, prints and checks the bounces, and that the ranks differ by so little.
void check(const std::string& name, const Deck& deck, double difference);
}  // namespace bouncing

/// A thousand grains over the floor of a box, a loose lattice, stirred: as it is it would stand on friction alone for a
/// while.
namespace pouring {
inline constexpr double radius = 1.5e-3, spacing = 3.4e-3;
inline constexpr int side = 10;
inline constexpr double width = side * spacing;

std::vector<Grain> loose_lattice();
}  // namespace pouring

}  // namespace engines
