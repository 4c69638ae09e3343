#pragma once

#include <calibrate/export.hpp>
#include <console/exit.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify::engines {

/// One instant of a collision. Rates are in Yade, whose velocities are half a step behind, those of half a step before.
struct Instant {
  double time = 0;     ///< from the start of the run [s]
  double overlap = 0;  ///< along the normal of the start [m]
  double rate = 0;     ///< of the overlap [m/s]
  double force = 0;    ///< repulsion [N]
  double across = 0;   ///< velocity of a's centre across the normal, relative to b's or the wall's [m/s]
  double spin = 0;     ///< of a about the third axis [1/s]
};
using Trajectory = std::vector<Instant>;

/// A grain as the snippet knows it.
struct Grain {
  double radius = 0, density = 0;     ///< [m], [kg/m³]
  int type = 1;                       ///< in LIGGGHTS and LAMMPS
  std::string material = "material";  ///< in Yade

  double mass() const;
};

/// Two grains that fly at each other with half the velocities each, or one that flies at a wall.
struct Encounter {
  Grain a = {};
  std::optional<Grain> b = {};  ///< none: a wall
  double velocity = 0;          ///< relative [m/s]
  double tcol = 0;              ///< of the collision, roughly [s]; a run takes 1.7 of it
  double across = 0;            ///< relative velocity across the normal [m/s]
  int grain_types = 1;          ///< that the snippet has
  /// What follows ricochet_wall and wall_material in the snippet, of each kind of wall.
  std::vector<std::string> walls = {};
  std::size_t met = 0;  ///< the wall that is met without b

  double duration() const { return 1.7 * tcol; }
  double mass_eff() const { return b ? a.mass() / (1 + a.mass() / b->mass()) : a.mass(); }
  double radius_eff() const { return b ? a.radius / (1 + a.radius / b->radius) : a.radius; }
  /// Distance of the centres, or of a's from the wall, at touch [m].
  double reach() const { return b ? a.radius + b->radius : a.radius; }
};

/// Before the first touch the grains fly this many steps. Not a whole number: engines meet a contact inside a step.
constexpr double steps_before_touch = 1.5;

/// What an engine is without where this version of it has not got what the file asks for: the file says so and stops.
class Refused : public console::Failed {
 public:
  using Failed::Failed;
};

/// An engine that is installed on this machine.
class EngineProgram {
 public:
  /// Looks for `lmp`, `liggghts`, `yade` on the PATH, and for the drivers `liggghts-ricochet` and `lammps-ricochet`,
  /// which know the laws with a memory, first beside this program. Nothing when it isn't there, or when the engine has
  /// no program that we can run.
  static std::optional<EngineProgram> find(calibration::Engine engine, bool fractional = false);

  const std::string& command() const { return command_; }

  /// Runs the encounter once for each time step [s], with the contact that the snippet sets up. Throws Refused where
  /// the snippet says that this version can't, console::Failed with the engine's last words where it ends badly.
  std::vector<Trajectory> run(const std::string& snippet, const Encounter& pair,
                              const std::vector<double>& steps) const;

 private:
  EngineProgram(calibration::Engine engine, std::string command) : engine_(engine), command_(std::move(command)) {}

  calibration::Engine engine_;
  std::string command_;
};

}  // namespace ricochet::verify::engines
