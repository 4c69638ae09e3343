#include <simulate/run.hpp>
#include <simulate/view.hpp>

#include <console/exit.hpp>
#include <console/input.hpp>
#include <console/number.hpp>
#include <console/output.hpp>
#include <console/program.hpp>
#include <console/signals.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

namespace {

using namespace ricochet;

/// "1 wall", "3 walls"
std::string counted(std::size_t number, const char* noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

void announce(const simulate::Scene& scene) {
  const double tcol = scene.stiffest.tcol;
  const std::string shortest = tcol > 0
                                   ? fmt::format(", the {} about {} s",
                                                 scene.stiffest.tangential ? "fastest tangential spring swings back in"
                                                                           : "shortest collision takes",
                                                 console::significant(tcol, 3))
                                   : "";
  console::complain("simulate", fmt::format("{}, {}, {} steps of {} s{}", counted(scene.sphere_count(), "sphere"),
                                            counted(scene.setup.walls.size(), "wall"), scene.steps,
                                            console::significant(scene.options.step, 4), shortest));
  if (!scene.remark.empty()) console::complain("simulate", scene.remark);
}

/// The page that --view names: it can be written before the run begins, and is whatever comes of the run.
class View {
 public:
  View(const std::string& scene_file, const std::string& folder, const std::string& path) {
    if (path.empty()) return;
    std::vector<console::NamedFile> outputs;
    outputs.reserve(std::size(simulate::run_files) + 2);
    for (const char* const name : simulate::run_files) outputs.push_back({"-o", fmt::format("{}/{}", folder, name)});
    outputs.push_back({"-o", folder});
    outputs.push_back({"--view", path});
    console::require_apart({{{"SCENE", scene_file}}}, outputs);
    file_.emplace(path);
  }
  void write(const simulate::Scene& scene, const std::string& folder) {
    if (!file_) return;
    try {
      file_->write(simulate::view_page(scene, folder));
      file_->commit();
    } catch (const simulate::NothingToShow& nothing) {
      console::complain("simulate", fmt::format("--view: no page: {}", nothing.what()));
    }
  }

 private:
  std::optional<console::AtomicFile> file_;
};

struct Asked {
  std::string folder;
  bool resume;
  simulate::Format format;
};

int run_and_show(const simulate::Scene& scene, const Asked& asked, View& view) {
  int signal = 0;
  try {
    signal = simulate::run(
        scene, asked.folder, asked.resume, [&] { announce(scene); }, asked.format);
  } catch (const console::CannotWrite&) {
    throw;
  } catch (const console::Failed&) {
    view.write(scene, asked.folder);  // where a run broke down is worth a look
    throw;
  }
  view.write(scene, asked.folder);
  return signal;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Moves the spheres of a scene file and writes trajectories, collisions and energies.\n"
      "Writes trajectory.xyz (extended XYZ, opened by OVITO), contacts.csv, energy.csv and state.json.\n"
      "docs/scenes.md describes scene files; data/scenes/ holds some.",
      "simulate"};
  console::add_version(app);
  std::string file, folder, page;
  bool resume = false;
  std::optional<unsigned> threads;
  std::string format = "xyz";
  app.footer(
      "Exit code 0: done; 2: bad input; 4: the computation, or writing its result, failed; 130: interrupted, all "
      "written.");
  app.add_option("SCENE", file, "the scene file (JSON)")->required();
  app.add_option("-o,--output", folder, "the folder to write to, made if missing")->required();
  app.add_flag("--resume", resume, "go on with an interrupted run in that folder");
  console::add_count(app, "--threads", threads, 256,
                     "that share the work where no friction is rigid; results are the same to the bit");
  app.add_option("--format", format,
                 "xyz, or vtk: a file a frame for ParaView as well, in DIR/vtk; a resumed run keeps its own")
      ->check(CLI::IsMember({"xyz", "vtk"}))
      ->capture_default_str();
  app.add_option("--view", page,
                 "also write a page that plays the run, for a browser; with --resume, of a finished run nothing else");
  return console::run_program(app, argc, argv, [&] {
    simulate::Scene scene = simulate::read_scene(file, console::read_input(file));
    scene.options.threads = static_cast<int>(threads.value_or(1));
    View view(file, folder, page);
    const Asked asked{folder, resume, format == "vtk" ? simulate::Format::vtk : simulate::Format::xyz};
    const int signal = run_and_show(scene, asked, view);
    if (signal == 0) return console::Exit::done;
    console::complain(
        "simulate", fmt::format("stopped, all written; go on with: {} {} -o {} --resume{}",
                                console::run_as(app.get_name()), console::shell_word(file), console::shell_word(folder),
                                page.empty() ? "" : " --view " + console::shell_word(page)));
    console::end_by(signal);
  });
}
