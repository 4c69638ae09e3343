// Any text as a trajectory: frames for the page that plays a run, and spheres from which a scene starts; or one line
// that says what is wrong with it.

#include "../../simulate/src/view/trajectory_file.hpp"

#include "memory_file.hpp"

#include <console/exit.hpp>
#include <simulate/scene.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

using namespace ricochet;

namespace {

template <class Read>
void try_to(Read&& read) {
  try {
    read();
  } catch (const console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
}

void view(const std::string& path) {
  simulate::TrajectoryFile file(path);
  for (std::size_t k = 0; k < file.size(); ++k) {
    const simulate::SeenFrame frame = file.frame(k);
    if (frame.grains.size() != file.grains(k)) throw std::logic_error("a grain that was lost");
    for (const simulate::SeenGrain& g : frame.grains)
      if (g.species >= file.species().size() || !std::isfinite(norm(g.position) + g.radius) || !(g.radius > 0))
        throw std::logic_error("an impossible grain");
  }
}

void start(const std::string& path) {
  const simulate::Scene scene = simulate::read_scene("scene.json", R"({"duration": 1,
    "materials": {"glass": {"density": 2500}, "steel": {"density": 7800}}, "interactions": [
    {"between": ["glass", "glass"], "law": {"name": "linear", "k": 1000, "c": 0}},
    {"between": ["glass", "steel"], "law": {"name": "linear", "k": 1000, "c": 0}},
    {"between": ["steel", "steel"], "law": {"name": "linear", "k": 1000, "c": 0}}],
    "start": {"trajectory": ")" + path + "\"}}");
  for (const Sphere& s : scene.setup.spheres)
    if (!(s.radius > 0 && s.mass() > 0)) throw std::logic_error("an impossible sphere");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  try_to([&] { view(file.path()); });
  try_to([&] { start(file.path()); });
  return 0;
}
