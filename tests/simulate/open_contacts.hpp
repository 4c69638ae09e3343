#pragma once

#include <simulate/scene.hpp>

#include <iterator>
#include <string>

namespace ricochet::test {

/// Five grains on a plate, a sixth on the first two: contacts of every law, each of them sliding, spinning and rolling,
/// by rigid friction and by springs of every kind.
/// The plate's contacts have the first five laws, those of neighbours the last four.
/// They touch at the start and stay in contact for 2 ms at least.
inline simulate::Scene open_contacts() {
  const std::string laws[] = {R"({"name": "linear", "k": 3000, "c": 0.3})",
                              R"({"name": "kuwabara-kono", "k": 200000, "c": 30})",
                              R"({"name": "tsuji", "k": 200000, "c": 2})",
                              R"({"name": "hysteretic", "k1": 2000, "k2": 4000})",
                              R"({"name": "fractional", "k": 4000, "c": 1, "alpha": 0.3})",
                              R"({"name": "fractional-kelvin-voigt", "k": 3000, "c": 1, "alpha": 0.5})",
                              R"({"name": "fractional-zener", "k": 3000, "k1": 30000, "tau": 0.001, "alpha": 0.5})",
                              R"({"name": "fractional-hertz", "k": 200000, "c": 30, "alpha": 0.3})"};
  const std::string coulomb = R"("friction": {"mu_static": 0.5, "mu_dynamic": 0.3, "decay": 2, )";
  const std::string models[] = {
      R"("rolling_arm": 0.7})", R"("model": "linear", "k_t": 2500, "c_t": 0.2, "torsion": true, "mu_rolling": 0.1})",
      R"("model": "mindlin", "k_t": 30000, "velocity": 0.3, "torsion": true, "rolling_arm": 0.7})"};
  std::string materials = R"("plate": {})", interactions, spheres;
  const auto meet = [&](const std::string& a, const std::string& b, const std::string& law, int model) {
    interactions += (interactions.empty() ? "" : ",\n") + (R"({"between": [")" + a + R"(", ")" + b + R"("], "law": )") +
                    law + ", " + coulomb + models[model % 3] + "}";
  };
  const auto add = [&](const std::string& material, const std::string& position, const std::string& velocity) {
    spheres += (spheres.empty() ? "" : ",\n") + (R"({"radius": 0.01, "material": ")" + material) +
               R"(", "position": )" + position + R"(, "velocity": )" + velocity + R"(, "spin": [20, -35, 50]})";
  };
  for (int k = 0; k < 5; ++k) {
    const std::string grain = "grain" + std::to_string(k);
    materials += ", \"" + grain + R"(": {"density": 2000})";
    meet(grain, "plate", laws[k], k);
    for (int l = k; l < 5; ++l) meet(grain, "grain" + std::to_string(l), laws[(4 + k) % std::size(laws)], k + l);
    const double x = k > 0 ? 1e-5 + 0.01999 * k : 0;  // the first is not pressed by its neighbour, but by the sixth
    add(grain, "[" + std::to_string(x) + ", 0, 0.01]", "[0.02, 0.3, -0." + std::to_string(k + 1) + "]");
  }
  add("grain4", "[0.01, 0, 0.0273205081]", "[0, -0.2, -0.4]");
  const std::string text = R"({"duration": 0.006, "output_interval": 0.0002, "step": 2e-6, "gravity": [0.5, 0.2, -9.81],
"materials": {)" + materials +
                           "},\n\"interactions\": [" + interactions + "],\n\"spheres\": [" + spheres +
                           R"(], "walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "plate"}]})";
  return simulate::read_scene("open_contacts.json", text);
}

}  // namespace ricochet::test
