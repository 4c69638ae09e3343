#pragma once

#include "../paper.hpp"

#include <ricochet/collision/reduction.hpp>
#include <ricochet/motion/column.hpp>

#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify::column {

/// A column of the paper's beads, of r = 1.5e-3 m, all falling at once, no gravity. Every contact, of a pair and of the
/// plate, is made for the same t_col and e_n; as it stands, the case of Fig. 6.
struct ColumnCase {
  double gap = paper::column.gap;  ///< under each bead [m]
  double en = paper::column.en;
  double tcol = paper::column.tcol;  ///< [s]
  int steps = 200;                   ///< a t_col
  double memory_tolerance = 1e-6;    ///< of the fractional law's kernel
  double memory_contacts = 0;        ///< its longest time [t_col]; 0: 20 + the number of beads
};

/// A law as Fig. 6 names it.
struct ColumnLaw {
  const char* id = "";
  LawKind kind{};
  ContactEnd end = ContactEnd::force;
};

/// linear1, linear2, kuwabara-kono, tsuji, hysteretic, fractional.
const std::vector<ColumnLaw>& column_laws();

/// By id, and "linear" for linear1; nullptr for another word.
const ColumnLaw* find_column_law(const std::string& id);

/// Runs `beads` beads with the law made for the case. Throws console::Failed if contacts are not over in the time
/// allowed.
ColumnResult run_case(const ColumnLaw& law, std::size_t beads, const ColumnCase& c);

/// The same with the fractional law of another conversion degree, at the case's t_col; e_n is what α makes of it.
ColumnResult run_fractional(double alpha, std::size_t beads, const ColumnCase& c);

/// Dissipated share (62) of the event-driven column; nothing if it collapses.
std::optional<double> event_driven_share(std::size_t beads, const ColumnCase& c);

/// What a step h may do to E/E0 in one collision. Where a contact begins or ends a share θ into a step, the trapezoid
/// rule misses kv h²θ(1−θ)/2 of the ramp's impulse, at most kv h²/8, a share (ωh)²/8 of the momentum with ω t_col = π;
/// twice that of the energy, at each of the two ends: π²/2 (h/t_col)². In between the rule's error is that times the
/// energy lost, and smaller.
inline double stated_error(const ColumnCase& c) {
  return std::numbers::pi * std::numbers::pi / 2 / (static_cast<double>(c.steps) * c.steps);
}

/// Dissipated share (62).
inline double share(const ColumnResult& result) { return 1 - result.energy_ratio; }

}  // namespace ricochet::verify::column
