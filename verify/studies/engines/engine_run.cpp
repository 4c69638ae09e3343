#include "engine_run.hpp"

#include <console/child.hpp>
#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/scratch.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <locale>
#include <numbers>
#include <sstream>
#include <utility>

#include <unistd.h>

namespace ricochet::verify::engines {

namespace fs = std::filesystem;
using calibration::Engine;
using console::shortest;

namespace {

std::optional<std::string> on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const auto file = fs::path(folder) / program; !folder.empty() && access(file.c_str(), X_OK) == 0)
      return file.string();
  return std::nullopt;
}

std::optional<std::string> beside_us(const std::string& program) {
  std::error_code none;
  const auto file = fs::read_symlink("/proc/self/exe", none).parent_path() / program;
  if (!none && access(file.c_str(), X_OK) == 0) return file.string();
  return std::nullopt;
}

/// What every deck is made of: half the distance of the centres at the start, and the number of steps.
struct Start {
  double half_distance;
  long steps;
};

Start start_of(const Encounter& pair, double step) {
  return {pair.radius + 0.5 * steps_before_touch * step * pair.velocity, std::lround(pair.duration / step)};
}

std::string box(double half_size, const char* units) {
  std::string sides;
  for (int i = 0; i < 3; ++i) sides += fmt::format(" -{} {}", shortest(half_size), shortest(half_size));
  return fmt::format("region box block{}{}\ncreate_box 1 box\n", sides, units);
}

std::string grains(const Encounter& pair, const Start& start, const char* units) {
  const std::string half = shortest(0.5 * pair.velocity);
  return fmt::format(
      "create_atoms 1 single -{x} 0 0{units}\ncreate_atoms 1 single {x} 0 0{units}\n"
      "set group all diameter {diameter} density {density}\nset atom 1 vx {half}\nset atom 2 vx -{half}\n",
      fmt::arg("x", shortest(start.half_distance)), fmt::arg("units", units),
      fmt::arg("diameter", shortest(2 * pair.radius)), fmt::arg("density", shortest(pair.density)),
      fmt::arg("half", half));
}

/// The time steps of both engines, whose trajectory goes into the file `out`; LAMMPS wants the word "line" before a
/// format.
std::string stepping(double step, const std::string& out, const char* line, const Start& start) {
  return fmt::format(
      "timestep {}\nfix integrate all nve/sphere\nthermo 100000000\ndump out all custom 1 {} id x vx fx\n"
      "dump_modify out sort id format {}\"%d %.17g %.17g %.17g\"\nrun {}\n",
      shortest(step), out, line, start.steps);
}

std::string lammps_run(const Encounter& pair, double step, const std::string& out) {
  const Start start = start_of(pair, step);
  return fmt::format(
      "units si\natom_style sphere\natom_modify map array sort 0 0\nnewton off\ncomm_modify vel yes\n"
      "boundary f f f\n{}{}include snippet\nneighbor {} bin\nneigh_modify delay 0 every 1 check yes\n{}",
      box(10 * pair.radius, ""), grains(pair, start, ""), shortest(pair.radius), stepping(step, out, "line ", start));
}

std::string liggghts_run(const Encounter& pair, double step, const std::string& out) {
  const Start start = start_of(pair, step);
  return fmt::format(
      "atom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\n"
      "communicate single vel yes\nunits si\n{}neighbor {} bin\nneigh_modify delay 0\ninclude snippet\n{}{}",
      box(10 * pair.radius, " units box"), shortest(pair.radius), grains(pair, start, " units box"),
      stepping(step, out, "", start));
}

/// The dump of both: per step a header that ends in "ITEM: ATOMS", then one line a sphere.
Trajectory read_dump(const std::string& text, const Encounter& pair, double step) {
  Trajectory trajectory;
  std::istringstream lines(text);
  lines.imbue(std::locale::classic());
  long number = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("ITEM: TIMESTEP")) lines >> number;
    if (!line.starts_with("ITEM: ATOMS")) continue;
    double id = 0, x[2]{}, v[2]{}, f[2]{};
    for (int i = 0; i < 2; ++i) lines >> id >> x[i] >> v[i] >> f[i];
    trajectory.push_back({static_cast<double>(number) * step, 2 * pair.radius - (x[1] - x[0]), v[0] - v[1], f[1]});
  }
  return trajectory;
}

/// Run i writes the file <i>.
std::string yade_script(const Encounter& pair, const std::vector<double>& steps) {
  std::string script =
      "from yade import *\nexec(open('snippet').read())\n"
      "def encounter(i, dt, count, x, r, v, density):\n"
      "  O.reset()\n"
      "  material.density = density\n"
      "  O.materials.append(material)\n"
      "  ids = [O.bodies.append(utils.sphere((s * x, 0, 0), r, material=material)) for s in (-1, 1)]\n"
      "  a, b = [O.bodies[n] for n in ids]\n"
      "  a.state.vel, b.state.vel = (v / 2, 0, 0), (-v / 2, 0, 0)\n"
      "  O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=r / 2),\n"
      "    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [ip2], [law2]), NewtonIntegrator(damping=0)]\n"
      "  O.dt = dt\n"
      "  with open(str(i), 'w') as out:\n"
      "    for n in range(count):\n"
      "      xa, xb, va, vb = a.state.pos[0], b.state.pos[0], a.state.vel[0], b.state.vel[0]\n"
      "      O.step()\n"
      "      out.write(f'{n * dt!r} {2 * r - (xb - xa)!r} {va - vb!r} {O.forces.f(ids[1])[0]!r}\\n')\n";
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Start start = start_of(pair, steps[i]);
    script += fmt::format("encounter({}, {}, {}, {}, {}, {}, {})\n", i, shortest(steps[i]), start.steps,
                          shortest(start.half_distance), shortest(pair.radius), shortest(pair.velocity),
                          shortest(pair.density));
  }
  return script;
}

Trajectory read_columns(const std::string& text) {
  Trajectory trajectory;
  std::istringstream lines(text);
  lines.imbue(std::locale::classic());
  for (Instant at{}; lines >> at.time >> at.overlap >> at.rate >> at.force;) trajectory.push_back(at);
  return trajectory;
}

/// Engines start slowly, above all their MPI: one process does all runs.
std::string script_of(Engine engine, const Encounter& pair, const std::vector<double>& steps) {
  if (engine == Engine::yade) return yade_script(pair, steps);
  std::string script;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i > 0) script += "clear\n";
    script += (engine == Engine::lammps ? lammps_run : liggghts_run)(pair, steps[i], std::to_string(i));
  }
  return script;
}

/// The last line of a log that isn't empty: where engines say what went wrong.
std::string last_words(const std::string& log) {
  std::istringstream lines(log);
  std::string last, error;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("ERROR") != std::string::npos || line.find("Error") != std::string::npos) error = line;
    if (line.find_first_not_of(" \t") != std::string::npos) last = line;
  }
  return error.empty() ? last : error;
}

/// Runs the program in the folder.
void run_in(const console::ScratchFolder& folder, std::vector<std::string> arguments, const char* what) {
  const console::Ran ran = console::run(
      {std::move(arguments), folder.path(), {}, {"QT_QPA_PLATFORM=offscreen", "OMPI_MCA_ess_singleton_isolated=1"}});
  if (!ran.found || ran.status != 0)
    throw console::Failed(fmt::format("{}: {}", what, last_words(ran.out + "\n" + ran.err)));
}

}  // namespace

double Encounter::mass_eff() const { return 2.0 / 3.0 * std::numbers::pi * radius * radius * radius * density; }

std::optional<EngineProgram> EngineProgram::find(Engine engine, bool fractional) {
  std::optional<std::string> command;
  if (engine == Engine::lammps && !fractional) command = on_path("lmp");
  if (engine == Engine::yade && !fractional) command = on_path("yade");
  if (engine == Engine::liggghts && !fractional) command = on_path("liggghts");
  if (engine == Engine::liggghts && fractional) {
    command = beside_us("liggghts-ricochet");
    if (!command) command = on_path("liggghts-ricochet");
  }
  if (!command) return std::nullopt;
  return EngineProgram(engine, *command);
}

std::vector<Trajectory> EngineProgram::run(const std::string& snippet, const Encounter& pair,
                                           const std::vector<double>& steps) const {
  const console::ScratchFolder folder;
  folder.write("snippet", snippet);
  const bool yade = engine_ == Engine::yade;
  const std::string script = yade ? "script.py" : "script";  // Yade goes by the ending
  folder.write(script, script_of(engine_, pair, steps));
  run_in(folder,
         yade ? std::vector<std::string>{command_, "-n", "-x", script}
              : std::vector<std::string>{command_, "-in", script, "-log", "none"},
         text(engine_).data());
  std::vector<Trajectory> trajectories;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string written = folder.read(std::to_string(i));
    trajectories.push_back(yade ? read_columns(written) : read_dump(written, pair, steps[i]));
  }
  return trajectories;
}

}  // namespace ricochet::verify::engines
