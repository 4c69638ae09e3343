// Any text as the state of a small scene, with the checksum that belongs to it: a state from which the scene goes on,
// or one line that says what is wrong with it.

#include "../../simulate/src/state_file.hpp"

#include <console/exit.hpp>
#include <console/node.hpp>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

using namespace ricochet;
using console::Json;

namespace {

/// Three grains on a plate that lean on each other, contacts of laws with and without memory, springs and rigid
/// friction; a fourth is poured, and whoever falls through leaves.
const simulate::Scene& scene() {
  static const simulate::Scene read = simulate::read_scene("scene.json", R"({"duration": 0.01, "step": 2e-6,
"gravity": [0, 0, -9.81], "materials": {"plate": {}, "a": {"density": 2000}, "b": {"density": 1000}},
"interactions": [
{"between": ["a", "plate"], "law": {"name": "hysteretic", "k1": 2000, "k2": 4000}, "friction": {"mu_static": 0.5}},
{"between": ["b", "plate"], "law": {"name": "fractional", "k": 4000, "c": 1, "alpha": 0.3},
 "friction": {"mu_static": 0.5, "model": "linear", "k_t": 2500, "c_t": 0.2, "torsion": true, "mu_rolling": 0.1}},
{"between": ["a", "b"], "law": {"name": "kuwabara-kono", "k": 200000, "c": 30}, "friction": {"mu_static": 0.3}},
{"between": ["a", "a"], "law": {"name": "linear", "k": 3000, "c": 0.3}},
{"between": ["b", "b"], "law": {"name": "tsuji", "k": 200000, "c": 2}}],
"spheres": [
{"radius": 0.01, "material": "a", "position": [0, 0, 0.01], "velocity": [0.1, 0, -0.1]},
{"radius": 0.01, "material": "b", "position": [0.02, 0, 0.01], "velocity": [-0.1, 0.2, -0.2], "spin": [20, -30, 40]},
{"radius": 0.01, "material": "a", "position": [0.01, 0, 0.0273205081], "velocity": [0, 0, -0.3]}],
"pour": [{"number": 2, "material": "b", "radius": 0.005, "rate": 1000, "begin": 0.0005,
          "region": {"low": [-0.1, -0.1, 0.1], "high": [0.1, 0.1, 0.2]}}],
"outlets": [{"point": [0, 0, -0.02], "inward": [0, 0, 1]}],
"walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "plate"}]})");
  return read;
}

void go_on(const simulate::Checkpoint& from) {
  ClusterSetup setup = scene().setup;
  setup.spheres.clear();
  for (const std::uint32_t k : from.present) setup.spheres.push_back(scene().sphere(k));
  if (setup.spheres.empty()) return;
  ClusterOptions options = scene().options;
  options.skin = 0.001;
  Cluster cluster(setup, options);
  cluster.restore(from.state);
  if (!std::isfinite(cluster.energy().total())) return;
  cluster.advance(3);
  static_cast<void>(cluster.breakthrough());
}

void take(const std::string& text) {
  try {
    go_on(simulate::read_checkpoint("state.json", text, scene()));
  } catch (const console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  take(text);
  Json state;
  try {
    state = console::parse_json("state.json", text, "docs/scenes.md");
  } catch (const console::BadInput&) {
    return 0;
  }
  if (!state.is_object()) return 0;
  state["scene"] = scene().fingerprint;
  try {
    state["checksum"] = simulate::checksum(state);
  } catch (const Json::exception&) {  // bytes that are no UTF-8
    return 0;
  }
  take(state.dump());
  return 0;
}
