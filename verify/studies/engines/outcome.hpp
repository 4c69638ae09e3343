#pragma once

#include "contacts.hpp"

#include <verify/gate.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace ricochet::verify::engines {

inline constexpr int resolutions[] = {25, 50, 100, 200, 400};  ///< steps in tcol
inline constexpr std::size_t at_200 = 3, finest = 4;

struct Measured {
  double en, tcol;
};

/// What came out of the engine.
struct Outcome {
  Contact what;
  std::vector<Measured> at;  ///< over resolutions
  Measured limit{};  ///< extrapolated from the two finest steps, for errors of first order, by a driver of second
  std::optional<double> repeated = {};  ///< greatest relative difference of en from the engine's stepping repeated
  double error(std::size_t i) const { return std::abs(at[i].en / what.en - 1); }
};

/// Runs the contact in the engine with every step. Throws as EngineProgram::run, and console::Failed when no trajectory
/// comes back.
Outcome run(const EngineProgram& program, const Contact& what);

/// What the study asks of it.
void add_gates(std::vector<Gate>& gates, const Outcome& outcome);

}  // namespace ricochet::verify::engines
