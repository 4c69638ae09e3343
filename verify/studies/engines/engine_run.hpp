#pragma once

#include <calibrate/export.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify::engines {

/// One instant of a head-on collision of two equal spheres.
struct Instant {
  double time;     ///< from the start of the run [s]
  double overlap;  ///< [m]
  double rate;   ///< of the overlap [m/s]; in Yade, whose velocities are half a step behind, that of half a step before
  double force;  ///< repulsion [N]
};
using Trajectory = std::vector<Instant>;

/// Two equal spheres that fly at each other with half the velocity each.
struct Encounter {
  double radius;    ///< of each [m]
  double density;   ///< [kg/m³]
  double velocity;  ///< relative [m/s]
  double duration;  ///< of the run [s]

  double mass_eff() const;
  double radius_eff() const { return 0.5 * radius; }
};

/// Before the first touch the spheres fly this many steps. Not a whole number: engines meet a contact inside a step.
constexpr double steps_before_touch = 1.5;

/// An engine that is installed on this machine.
class EngineProgram {
 public:
  /// Looks for `lmp`, `liggghts`, `yade` on the PATH, and for `liggghts-ricochet`, which knows the fractional law, also
  /// beside this program. Nothing when it isn't there, or when the engine has no program that we can run.
  static std::optional<EngineProgram> find(calibration::Engine engine, bool fractional = false);

  const std::string& command() const { return command_; }

  /// Runs the encounter once for each time step [s], with the contact that the snippet sets up. Throws console::Failed
  /// with the engine's last words when it doesn't end well.
  std::vector<Trajectory> run(const std::string& snippet, const Encounter& pair,
                              const std::vector<double>& steps) const;

 private:
  EngineProgram(calibration::Engine engine, std::string command) : engine_(engine), command_(std::move(command)) {}

  calibration::Engine engine_;
  std::string command_;
};

}  // namespace ricochet::verify::engines
