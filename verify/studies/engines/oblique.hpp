#pragma once

#include "contacts.hpp"
#include "outcome.hpp"

#include <console/table.hpp>
#include <verify/gate.hpp>

#include <string>
#include <vector>

namespace ricochet::verify::engines {

struct ObliqueMeasured {
  double et = 0;    ///< tangential restitution of the centres
  double spin = 0;  ///< |ω| of each sphere after, in units of v/r, v the relative velocity
};

/// An impact at an angle on a contact with a tangential part, as `calibrate --export` writes it, beside ours.
struct ObliqueContact {
  Contact what;
  std::string tangential;  ///< "linear, damped"
  double angle = 0;        ///< of the relative velocity from the normal [°]
  bool exact = false;      ///< the engine is said to have this very law
  ObliqueMeasured ours{};  ///< by our oblique collision
  ObliqueMeasured rule{};  ///< by the engine's own rule as the docs tell it, stepped here, the step going to 0; of the
                           ///< drivers' laws, whose springs have no dashpot here, ours
};

/// A wall and a pair at three angles, for each law of the normal and tangential part that the engine can be given.
std::vector<ObliqueContact> oblique_contacts(calibration::Engine engine);

struct ObliqueOutcome {
  ObliqueContact what;
  std::vector<ObliqueMeasured> at{};  ///< over resolutions
  ObliqueMeasured limit{};            ///< extrapolated from the two finest steps, for errors of first order

  /// Greater of the differences of e_t and of the spin, both in units of the velocity.
  double difference(const ObliqueMeasured& a, const ObliqueMeasured& b) const;
  double error(std::size_t i) const { return difference(at[i], what.rule); }
};

/// Throws as EngineProgram::run.
ObliqueOutcome run(const EngineProgram& program, const ObliqueContact& what);

console::Table oblique_table(const std::vector<ObliqueOutcome>& outcomes);
std::vector<Gate> oblique_gates(const std::vector<ObliqueOutcome>& outcomes);
console::Json oblique_rows(const std::vector<ObliqueOutcome>& outcomes);

}  // namespace ricochet::verify::engines
