#pragma once

#include "case.hpp"

namespace ricochet::verify::conformance {

// The families of cases, each in a file of its own.

std::vector<Case> normal_cases();      ///< head-on impacts of pairs and on walls
std::vector<Case> oblique_cases();     ///< with spin and friction; torsion
std::vector<Case> plane_cases();       ///< on a floor under gravity: at rest, sliding, rolling
std::vector<Case> falling_cases();     ///< bouncing, columns, beads between walls
std::vector<Case> again_cases();       ///< contacts that come again: what a contact remembers must be gone
std::vector<Case> first_step_cases();  ///< a touch anywhere inside a step

}  // namespace ricochet::verify::conformance
