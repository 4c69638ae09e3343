// Any text as a scene that is run for at most 40 steps: files in which every number is finite and a state that --resume
// takes up, or one line that says why not.

#include <console/exit.hpp>
#include <console/input.hpp>
#include <console/node.hpp>
#include <simulate/run.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

using namespace ricochet;
namespace fs = std::filesystem;

namespace {

/// Few enough that only a hang takes long.
bool small(const std::string& text) {
  const console::Json json = console::parse_json("scene.json", text, "docs/scenes.md");
  std::size_t grains = 0;
  for (const char* const key : {"lattice", "pour"}) {
    if (!json.is_object() || !json.contains(key) || !json[key].is_array()) continue;
    for (const auto& entry : json[key])
      if (entry.is_object() && entry.contains("number") && entry["number"].is_number())
        grains = std::max(grains, entry["number"] > 50 ? std::size_t{1000} : grains + 1);
  }
  return grains < 1000;
}

/// In memory where the system has such a folder: nobody waits for a disc.
fs::path folder() {
  const fs::path in = fs::exists("/dev/shm") ? "/dev/shm" : fs::temp_directory_path();
  return in / ("ricochet-fuzz-" + std::to_string(::getpid()));
}

void run_shortly(const std::string& text) {
  if (!small(text)) return;
  simulate::Scene scene = simulate::read_scene("scene.json", text);
  if (scene.sphere_count() > 50 || scene.setup.walls.size() > 50) return;
  scene.steps = std::min<std::uint64_t>(scene.steps, 40);
  scene.output_every = std::min<std::uint64_t>(scene.output_every, 15);
  scene.options.longest_contact = 40 * scene.options.step;
  scene.options.kernel_tolerance = 1e-3;
  const fs::path out = folder();
  fs::remove_all(out);
  try {
    if (simulate::run(
            scene, out, false, [] {}, simulate::Format::vtk) != 0)
      throw std::logic_error("stopped by nobody");
    if (simulate::run(scene, out, true) != 0) throw std::logic_error("not finished");
  } catch (const console::Failed&) {
    if (fs::exists(out / "state.json")) {
      try {
        simulate::run(scene, out, true);  // to the same end, or to another of 40 steps
      } catch (const console::Failed&) {
      }
    }
  }
  for (const char* const file : {"trajectory.xyz", "energy.csv", "contacts.csv"})
    if (fs::exists(out / file))
      for (const char* const word : {"inf", "nan"})
        if (console::read_input(out / file).find(word) != std::string::npos)
          throw std::logic_error(std::string(file) + " holds " + word);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    run_shortly(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
  fs::remove_all(folder());
  return 0;
}
