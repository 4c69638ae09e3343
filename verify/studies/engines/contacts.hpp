#pragma once

#include "../paper.hpp"
#include "engine_run.hpp"

#include <calibrate/materials.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify::engines {

inline constexpr double tcol = paper::pair.tcol;

inline constexpr double velocity = paper::pair.impact.velocity;

/// The two spheres of Table II; one of them and a wall.
Encounter two_spheres();
Encounter sphere_and_wall();

/// A contact in an engine: what it is given and what shall come out when the step goes to zero.
struct Contact {
  calibration::Engine engine;
  std::string name;  ///< "tsuji, force" or the engine's own input
  std::string snippet;
  ContactEnd end;  ///< which zero is timed
  double en_asked;
  double en, tcol;            ///< in the limit; tcol 0: not known
  std::optional<AnyLaw> law;  ///< what the engine runs, where its stepping can be repeated with it
  Encounter who;
  bool fractional = false;
};

/// What `calibrate --export` writes of every law that the engine can be given, and the engine's own way to ask for a
/// restitution, against what `verify peers` says it gives.
std::vector<Contact> contacts_of(calibration::Engine engine);

/// Every pair of one file of `calibrate --materials --export`, at the middle of the radii and at the ends of their
/// ranges; none where the engine can't be given the law. All pairs must be reached.
std::vector<Contact> contacts_of(calibration::Engine engine, const calibration::Materials& materials);

}  // namespace ricochet::verify::engines
