#include "engine_run.hpp"

#include <console/child.hpp>
#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/scratch.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <numbers>
#include <sstream>
#include <string_view>
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

/// What every deck is made of: the places of a and b, their velocities along the normal x and across it, and the number
/// of steps. A wall stands at 0 where a meets it, and out of reach otherwise. Two grains are beside each other in the
/// middle of the contact.
struct Start {
  double x[2]{}, v[2]{};
  long steps = 0;
  double y[2]{}, w[2]{};
};

Start start_of(const Encounter& pair, double step) {
  const double gap = steps_before_touch * step * pair.velocity;
  const long steps = std::lround(pair.duration() / step);
  if (!pair.b) return {{pair.reach() + gap, 0}, {-pair.velocity, 0}, steps, {}, {pair.across, 0}};
  const double back = 0.5 * pair.across * (steps_before_touch * step + 0.5 * pair.tcol);
  return {{-pair.a.radius - 0.5 * gap, pair.b->radius + 0.5 * gap},
          {0.5 * pair.velocity, -0.5 * pair.velocity},
          steps,
          {-back, back},
          {0.5 * pair.across, -0.5 * pair.across}};
}

double half_box(const Encounter& pair) { return 10 * std::max(pair.a.radius, pair.b ? pair.b->radius : 0.0); }
double wall_at(const Encounter& pair, std::size_t wall) {
  return pair.b || wall != pair.met ? -0.8 * half_box(pair) : 0;
}

std::string box(const Encounter& pair, int types, const char* units) {
  std::string sides;
  for (int i = 0; i < 3; ++i) sides += fmt::format(" -{} {}", shortest(half_box(pair)), shortest(half_box(pair)));
  return fmt::format("region box block{}{}\ncreate_box {} box\n", sides, units, types);
}

std::string grains(const Encounter& pair, const Start& start, const char* units) {
  std::string text;
  int id = 0;
  const auto add = [&](const Grain& grain, double x, double y, double v, double w) {
    text += fmt::format(
        "create_atoms {type} single {x} {y} 0{units}\nset atom {id} diameter {diameter} density {density}\n"
        "set atom {id} vx {v} vy {w}\n",
        fmt::arg("type", grain.type), fmt::arg("x", shortest(x)), fmt::arg("y", shortest(y)), fmt::arg("units", units),
        fmt::arg("id", ++id), fmt::arg("diameter", shortest(2 * grain.radius)),
        fmt::arg("density", shortest(grain.density)), fmt::arg("v", shortest(v)), fmt::arg("w", shortest(w)));
  };
  add(pair.a, start.x[0], start.y[0], start.v[0], start.w[0]);
  if (pair.b) add(*pair.b, start.x[1], start.y[1], start.v[1], start.w[1]);
  // LIGGGHTS wants atoms of the first type: one that stands aside.
  if (Grain aside = pair.a; aside.type > 1) {
    aside.type = 1;
    add(aside, 0.5 * half_box(pair), 0.8 * half_box(pair), 0, 0);
  }
  return text;
}

/// Where the walls of the snippet stand, in the variables that it leaves as they are: `place` is the wall's own words,
/// of its number and position.
template <class F>
std::string walls(const Encounter& pair, const F& place) {
  std::string text;
  for (std::size_t i = 0; i < pair.walls.size(); ++i)
    text += fmt::format("variable ricochet_wall{} index \"{}\"\n", pair.walls[i], place(i, shortest(wall_at(pair, i))));
  return text;
}

/// The time steps of both engines, whose trajectory goes into the file `out`; LAMMPS wants the word "line" before a
/// format.
std::string stepping(double step, const std::string& out, const char* line, const Start& start) {
  return fmt::format(
      "timestep {}\nfix integrate all nve/sphere\nthermo 100000000\ndump out all custom 1 {} id x vx fx vy omegaz\n"
      "dump_modify out sort id format {}\"%d %.17g %.17g %.17g %.17g %.17g\"\nrun {}\n",
      shortest(step), out, line, start.steps);
}

std::string lammps_run(const Encounter& pair, double step, const std::string& out) {
  const Start start = start_of(pair, step);
  const auto place = [](std::size_t, const std::string& x) { return fmt::format("xplane {} NULL", x); };
  return fmt::format(
      "units si\natom_style sphere\natom_modify map array sort 0 0\nnewton off\ncomm_modify vel yes\n"
      "boundary f f f\n{}{}{}include snippet\nneighbor {} bin\nneigh_modify delay 0 every 1 check yes\n{}",
      box(pair, pair.grain_types, ""), grains(pair, start, ""), walls(pair, place), shortest(pair.a.radius),
      stepping(step, out, "line ", start));
}

std::string liggghts_run(const Encounter& pair, double step, const std::string& out) {
  const Start start = start_of(pair, step);
  const int types = pair.grain_types + static_cast<int>(pair.walls.size());
  const auto place = [&](std::size_t i, const std::string& x) {
    return fmt::format("primitive type {} xplane {}", pair.grain_types + static_cast<int>(i) + 1, x);
  };
  return fmt::format(
      "atom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\n"
      "communicate single vel yes\nunits si\n{}neighbor {} bin\nneigh_modify delay 0\n{}include snippet\n{}{}",
      box(pair, types, " units box"), shortest(pair.a.radius), walls(pair, place), grains(pair, start, " units box"),
      stepping(step, out, "", start));
}

/// The dump of both: per step a header that ends in "ITEM: ATOMS", then one line a grain.
Trajectory read_dump(const std::string& text, const Encounter& pair, double step) {
  Trajectory trajectory;
  std::istringstream lines(text);
  lines.imbue(std::locale::classic());
  long number = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("ITEM: TIMESTEP")) lines >> number;
    if (!line.starts_with("ITEM: ATOMS")) continue;
    double id = 0, x[2]{}, v[2]{}, f[2]{}, w[2]{}, spin[2]{};
    for (int i = 0; i < (pair.b ? 2 : 1); ++i) lines >> id >> x[i] >> v[i] >> f[i] >> w[i] >> spin[i];
    const double time = static_cast<double>(number) * step;
    if (pair.b)
      trajectory.push_back({time, pair.reach() - (x[1] - x[0]), v[0] - v[1], f[1], w[0] - w[1], spin[0]});
    else
      trajectory.push_back({time, pair.reach() - x[0], -v[0], f[0], w[0], spin[0]});
  }
  return trajectory;
}

/// Grain i in Yade's words: (x, v, radius, density, its material's name, y, w).
std::string yade_grain(const Grain& grain, const Start& start, int i) {
  return fmt::format("({}, {}, {}, {}, '{}', {}, {})", shortest(start.x[i]), shortest(start.v[i]),
                     shortest(grain.radius), shortest(grain.density), grain.material, shortest(start.y[i]),
                     shortest(start.w[i]));
}

/// Run i writes the file <i>.
std::string yade_script(const Encounter& pair, const std::vector<double>& steps) {
  std::string script =
      "from yade import *\n"
      "def encounter(i, dt, count, grains, walls, reach):\n"
      "  O.reset()\n"
      "  exec(open('snippet').read(), globals())\n"
      "  if material_of(grains[0]).id < 0: O.materials.append(material_of(grains[0]))\n"
      "  bodies = []\n"
      "  for g in grains:\n"
      "    material_of(g).density = g[3]\n"
      "    O.bodies.append(utils.sphere((g[0], g[5], 0), g[2], material=material_of(g)))\n"
      "    bodies.append(O.bodies[-1])\n"
      "    bodies[-1].state.vel = (g[1], g[6], 0)\n"
      "  for x, name in walls: O.bodies.append(utils.wall((x, 0, 0), axis=0, material=globals()[name]))\n"
      "  O.engines = [ForceResetter(),\n"
      "    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=grains[0][2] / 2),\n"
      "    InteractionLoop(globals().get('ig2', [Ig2_Sphere_Sphere_ScGeom()]), [ip2], [law2]),\n"
      "    NewtonIntegrator(damping=0)]\n"
      "  O.dt = dt\n"
      "  last = bodies[-1]\n"
      "  with open(str(i), 'w') as out:\n"
      "    for n in range(count):\n"
      "      x, v = last.state.pos[0], last.state.vel[0]\n"
      "      w, spin = bodies[0].state.vel[1], bodies[0].state.angVel[2]\n"
      "      if len(bodies) == 2:\n"
      "        x, v, w = x - bodies[0].state.pos[0], v - bodies[0].state.vel[0], w - last.state.vel[1]\n"
      "      O.step()\n"
      "      out.write(f'{n * dt!r} {reach - x!r} {-v!r} {O.forces.f(last.id)[0]!r} {w!r} {spin!r}\\n')\n"
      "def material_of(grain): return globals()[grain[4]]\n";
  std::string walls;
  for (std::size_t i = 0; i < pair.walls.size(); ++i)
    walls += fmt::format("({}, 'wall_material{}'), ", shortest(wall_at(pair, i)), pair.walls[i]);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Start start = start_of(pair, steps[i]);
    std::string grains = yade_grain(pair.a, start, 0);
    if (pair.b) grains += ", " + yade_grain(*pair.b, start, 1);
    script += fmt::format("encounter({}, {}, {}, [{}], [{}], {})\n", i, shortest(steps[i]), start.steps, grains, walls,
                          shortest(pair.reach()));
  }
  return script;
}

Trajectory read_columns(const std::string& text) {
  Trajectory trajectory;
  std::istringstream lines(text);
  lines.imbue(std::locale::classic());
  for (Instant at{}; lines >> at.time >> at.overlap >> at.rate >> at.force >> at.across >> at.spin;)
    trajectory.push_back(at);
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

/// How a file begins to say why it stops, in LAMMPS, which can ask for its own version.
constexpr std::string_view refusal = "Ricochet: ";

void throw_refusal(const std::string& log) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(refusal)) throw Refused(line.substr(refusal.size()));
}

/// Runs the program in the folder.
void run_in(const console::ScratchFolder& folder, std::vector<std::string> arguments, const char* what) {
  const console::Ran ran = console::run(
      {std::move(arguments), folder.path(), {}, {"QT_QPA_PLATFORM=offscreen", "OMPI_MCA_ess_singleton_isolated=1"}});
  if (ran.found && ran.status != 0) throw_refusal(ran.out);
  if (!ran.found || ran.status != 0)
    throw console::Failed(fmt::format("{}: {}", what, last_words(ran.out + "\n" + ran.err)));
}

}  // namespace

double Grain::mass() const { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density; }

std::optional<EngineProgram> EngineProgram::find(Engine engine, bool fractional) {
  std::optional<std::string> command;
  if (fractional) {
    const std::string driver(calibration::driver(engine));
    if (driver.empty()) return std::nullopt;
    command = beside_us(driver);
    if (!command) command = on_path(driver);
  } else {
    if (engine == Engine::lammps) command = on_path("lmp");
    if (engine == Engine::yade) command = on_path("yade");
    if (engine == Engine::liggghts) command = on_path("liggghts");
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
