#include <simulate/run.hpp>

#include <console/exit.hpp>
#include <console/input.hpp>
#include <console/number.hpp>
#include <console/program.hpp>
#include <console/signals.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace ricochet;

void announce(const simulate::Scene& scene) {
  const double tcol = scene.stiffest.tcol;
  const std::string shortest =
      tcol > 0 ? fmt::format(", the shortest collision takes about {} s", console::significant(tcol, 3)) : "";
  console::complain("simulate", fmt::format("{} spheres, {} walls, {} steps of {} s{}", scene.sphere_count(),
                                            scene.setup.walls.size(), scene.steps,
                                            console::significant(scene.options.step, 4), shortest));
  if (!scene.remark.empty()) console::complain("simulate", scene.remark);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Moves the spheres of a scene file and writes trajectories, collisions and energies.\n"
      "Writes trajectory.xyz (extended XYZ, opened by OVITO), contacts.csv, energy.csv and state.json.\n"
      "docs/scenes.md describes scene files; data/scenes/ holds some.",
      "simulate"};
  console::add_version(app);
  std::string file, folder;
  bool resume = false;
  std::string format = "xyz";
  app.footer(
      "Exit code 0: done; 2: bad input; 4: the computation, or writing its result, failed; 130: interrupted, all "
      "written.");
  app.add_option("SCENE", file, "the scene file (JSON)")->required();
  app.add_option("-o,--output", folder, "the folder to write to, made if missing")->required();
  app.add_flag("--resume", resume, "go on with an interrupted run in that folder");
  app.add_option("--format", format,
                 "xyz, or vtk: a file a frame for ParaView as well, in DIR/vtk; a resumed run keeps its own")
      ->check(CLI::IsMember({"xyz", "vtk"}))
      ->capture_default_str();
  return console::run_program(app, argc, argv, [&] {
    const simulate::Scene scene = simulate::read_scene(file, console::read_input(file));
    const int signal = simulate::run(
        scene, folder, resume, [&] { announce(scene); },
        format == "vtk" ? simulate::Format::vtk : simulate::Format::xyz);
    if (signal == 0) return console::Exit::done;
    console::complain("simulate", fmt::format("stopped, all written; go on with: {} {} -o {} --resume",
                                              console::run_as(app.get_name()), console::shell_word(file),
                                              console::shell_word(folder)));
    console::end_by(signal);
  });
}
