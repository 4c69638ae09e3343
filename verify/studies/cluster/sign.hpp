#pragma once

#include <verify/study.hpp>

#include <vector>

namespace ricochet::verify::cluster {

/// How much the paper's regularised sgn (61) lets a contact slip that should stick.
struct SignCase {
  double eps2 = 0;       ///< ε₂ [m/s]; ε₁ is a tenth of it; 0: the rigid law
  double slip_left = 0;  ///< at the end [m/s]
  double stated = 0;     ///< what it must be
  double creep = 0;      ///< how far the contact slips in a second then [m]
  double step = 0;       ///< the longest stable explicit step [s]; for the rigid law the one taken
};

/// A sphere slides down a slope on which it can roll without slip. The rigid law first, then (61) with shrinking ε.
std::vector<SignCase> sign_cases();
console::Table sign_table(const std::vector<SignCase>& cases);
std::vector<Gate> sign_gates(const std::vector<SignCase>& cases);

}  // namespace ricochet::verify::cluster
