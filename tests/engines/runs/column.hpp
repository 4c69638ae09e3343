#pragma once

#include "deck_run.hpp"

#include <functional>
#include <string>
#include <vector>

namespace engines {

/// A column of ten beads that falls on a plate, z = 0, against our own column engine.
namespace column {
inline constexpr double tcol = 1e-4, en = 0.945, radius = 1.5e-3;
inline constexpr double duration = 40 * tcol, memory = 10 * tcol;
inline const Box box{{-0.01, -0.01, 0}, {0.01, 0.01, 0.05}};

/// At so many steps a collision time the deck of a run, `last` its last step, which it dumps to "dump".
using Deck = std::function<std::string(const Workplace&, const std::vector<Grain>& beads, double dt, int last)>;

/// Runs it at three steps, prints and checks how far its velocities are from ours.
void check(const std::string& name, const Deck& deck);
}  // namespace column

}  // namespace engines
