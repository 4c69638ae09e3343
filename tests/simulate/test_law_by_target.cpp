#include <catch2/catch.hpp>
#include <console/exit.hpp>
#include <ricochet/collision/collision.hpp>
#include <ricochet/motion/cluster.hpp>
#include <simulate/scene.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace ricochet;
using namespace ricochet::simulate;

namespace {

/// Grains of two radii in pairs that meet head-on far from each other, and one that meets a wall, with 0.5 m/s.
std::string scene_with(const std::string& grains, const std::string& wall) {
  return fmt::format(R"({{
  "duration": 0.004, "output_interval": 1e-3, "step": 2e-7,
  "materials": {{"grain": {{"density": 2500}}, "plate": {{}}}},
  "interactions": [
    {{"between": ["grain", "grain"], "law": {}}},
    {{"between": ["grain", "plate"], "law": {}}}
  ],
  "spheres": [
    {{"radius": 0.001, "material": "grain", "position": [0, 0, 0.1], "velocity": [0.5, 0, 0]}},
    {{"radius": 0.001, "material": "grain", "position": [0.0021, 0, 0.1]}},
    {{"radius": 0.001, "material": "grain", "position": [0, 0, 0.2], "velocity": [0.5, 0, 0]}},
    {{"radius": 0.003, "material": "grain", "position": [0.0041, 0, 0.2]}},
    {{"radius": 0.003, "material": "grain", "position": [0, 0, 0.0031], "velocity": [0, 0, -0.5]}}
  ],
  "walls": [{{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "plate"}}]
}})",
                     grains, wall);
}

struct Met {
  double tcol = 0, en = 0;
};

/// What the two pairs and the grain at the wall did.
std::array<Met, 3> collide_all(const std::string& text) {
  const Scene scene = read_scene("s.json", text);
  Cluster cluster(scene.setup, scene.options);
  REQUIRE(cluster.advance(scene.steps));
  std::array<Met, 3> met{};
  for (const Encounter& e : cluster.take_finished()) met.at(e.j == 5 ? 2 : e.j == 3 ? 1 : 0).tcol = e.end - e.begin;
  met[0].en = (cluster.velocity(1).x - cluster.velocity(0).x) / 0.5;
  met[1].en = (cluster.velocity(3).x - cluster.velocity(2).x) / 0.5;
  met[2].en = cluster.velocity(4).z / 0.5;
  return met;
}

std::string complaint(const std::string& law) {
  try {
    read_scene("s.json", scene_with(law, R"({"name": "linear", "k": 1000, "c": 0})"));
  } catch (const console::BadInput& error) {
    const std::string message = error.what();
    return message.substr(message.find("/interactions"));
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a law by target gives every pair the collision time and restitution, whatever its mass") {
  const auto met = collide_all(scene_with(R"({"name": "fractional", "en": 0.6, "tcol": 1e-4})",
                                          R"({"name": "linear", "en": 0.8, "tcol": 2e-4, "end": "overlap"})"));
  for (const int pair : {0, 1}) {
    CHECK(met[pair].tcol == Approx(1e-4).epsilon(1e-4));
    CHECK(met[pair].en == Approx(0.6).epsilon(1e-4));
  }
  CHECK(met[2].tcol == Approx(2e-4).epsilon(1e-4));
  CHECK(met[2].en == Approx(0.8).epsilon(1e-4));
}

TEST_CASE("a law by moduli has Hertz' stiffness of each pair's own radius") {
  const std::string law = R"({"name": "tsuji", "en": 0.5, "young": 1e7, "poisson": 0.3})";
  const auto met = collide_all(scene_with(law, R"({"name": "tsuji", "en": 0.5, "young": 1e7, "poisson": 0.3,
                                                   "young2": 2e8, "poisson2": 0.2})"));
  const auto mass = [](double r) { return 2500 * 4 * std::numbers::pi / 3 * r * r * r; };
  const double like = 1e7 / (2 * (1 - 0.09)), unlike = 1 / ((1 - 0.09) / 1e7 + (1 - 0.04) / 2e8);
  const double masses[] = {mass(1e-3) / 2, 1 / (1 / mass(1e-3) + 1 / mass(3e-3)), mass(3e-3)};
  const double radii[] = {0.5e-3, 0.75e-3, 3e-3}, moduli[] = {like, like, unlike};
  for (int i = 0; i < 3; ++i) {
    const double k = 4.0 / 3 * moduli[i] * std::sqrt(radii[i]), m = masses[i];
    // The share of critical damping that keeps half the velocity where the contact ends by force: exp(-2 psi cot psi).
    double low = 0, high = std::numbers::pi / 2;
    for (int n = 0; n < 60; ++n) {
      const double psi = 0.5 * (low + high);
      (std::exp(-2 * psi / std::tan(psi)) < 0.5 ? low : high) = psi;
    }
    const Collision exact = collide(Tsuji(k, std::cos(low) * std::sqrt(5 * m * k)), {0.5, m});
    CHECK(met[i].en == Approx(0.5).epsilon(1e-4));
    CHECK(met[i].tcol == Approx(exact.tcol).epsilon(1e-4));
  }
}

TEST_CASE("the laws of real solids by target, at what is held of them") {
  const auto scene = [](const std::string& law) { return scene_with(law, law); };
  for (const std::string law : {R"("fractional-kelvin-voigt", "alpha": 0.4)", R"("fractional-hertz", "velocity": 0.5)",
                                R"("fractional-zener", "alpha": 0.6, "stiffening": 50)"}) {
    CAPTURE(law);
    for (const Met& m : collide_all(scene(R"({"en": 0.7, "tcol": 1e-4, "name": )" + law + "}"))) {
      CHECK(m.tcol == Approx(1e-4).epsilon(1e-4));
      CHECK(m.en == Approx(0.7).epsilon(1e-4));
    }
  }
  // Parameters as they are.
  const auto by_number = collide_all(scene(R"({"name": "fractional-zener", "k": 1000, "k1": 4000, "tau": 1e-5,
                                               "alpha": 0.5})"));
  const double mass = 2500 * 4 * std::numbers::pi / 3 * 1e-9 / 2;
  const Collision exact = collide(FractionalZener(1000, 4000, 1e-5, 0.5), {0.5, mass});
  CHECK(by_number[0].tcol == Approx(exact.tcol).epsilon(1e-4));
  CHECK(by_number[0].en == Approx(exact.en).epsilon(1e-4));
}

TEST_CASE("bodies of one size keep their materials, of two sizes get one law a pair") {
  const std::string fixed = R"({"name": "linear", "k": 1000, "c": 0})";
  CHECK(read_scene("s.json", scene_with(fixed, fixed)).setup.interactions.size() == 2);
  // Small and large grains and the plate: three pairs of grains and two with the plate.
  CHECK(read_scene("s.json", scene_with(R"({"name": "linear", "en": 0.5, "tcol": 1e-4})", fixed))
            .setup.interactions.size() == 5);
}

TEST_CASE("a law by target that is not one says where") {
  CHECK(complaint(R"({"name": "tsuji", "en": 0.5})") ==
        "/interactions/0/law: \"tcol\" or \"young\" is missing; one must be given with \"en\"");
  CHECK(complaint(R"({"name": "tsuji", "en": 1.5, "tcol": 1e-4})") ==
        "/interactions/0/law/en = 1.5: must be in (0, 1]");
  CHECK(complaint(R"({"name": "tsuji", "en": 0.5, "tcol": 1e-4})") ==
        "/interactions/0/law: \"velocity\" is missing; this law depends on the impact velocity for which it is made");
  CHECK(complaint(R"({"name": "tsuji", "en": 0.5, "tcol": 1e-4, "velocity": 1, "young": 1})") ==
        "/interactions/0/law/young = 1: must be left out with tcol");
  CHECK(complaint(R"({"name": "tsuji", "en": 0.5, "young": 1e7, "poisson": 0.7})") ==
        "/interactions/0/law/poisson = 0.7: must be in (-1, 0.5]");
  CHECK(complaint(R"({"name": "tsuji", "en": 0.5, "young": 1e7})") ==
        "/interactions/0/law: \"poisson\" is missing; it must be given");
  CHECK(complaint(R"({"name": "tsuji", "en": 0.5, "k": 1e7})") ==
        "/interactions/0/law: unknown key \"k\"; known are name, en, tcol, young, poisson, young2, poisson2, velocity, "
        "end, alpha, stiffening");
  CHECK(complaint(R"({"name": "hysteretic", "en": 0.5, "tcol": 1e-4, "end": "overlap"})") ==
        "/interactions/0/law/end = \"overlap\": must be force with the law hysteretic");
  CHECK(complaint(R"({"name": "tsuji", "en": 0.5, "tcol": 1e-4, "velocity": 1, "alpha": 0.5})") ==
        "/interactions/0/law/alpha = 0.5: must be left out with the law tsuji by target");
  CHECK(complaint(R"({"name": "fractional-zener", "en": 0.5, "tcol": 1e-4, "alpha": 1.5})") ==
        "/interactions/0/law/alpha = 1.5: must be in [0, 1]");
  CHECK(
      complaint(R"({"name": "fractional-kelvin-voigt", "en": 0.2, "tcol": 1e-4})") ==
      "/interactions/0/law/en = 0.2: must be in [0.301, 1] with the law fractional-kelvin-voigt ended by force: below, "
      "no loss leaves less at its alpha = 0.5");
  CHECK(complaint(R"({"name": "fractional-hertz", "en": 0.5, "tcol": 1e-4})") ==
        "/interactions/0/law: \"velocity\" is missing; this law depends on the impact velocity for which it is made");
  // By overlap the fractional law keeps no digit of so small an e_n; by force it does, as every other law.
  CHECK(complaint(R"({"name": "fractional", "en": 0.003, "tcol": 1e-4, "end": "overlap"})") ==
        "/interactions/0/law/en = 0.003: must be in [0.00317, 1] with the law fractional ended by overlap: below, the "
        "rounding of its parameters to doubles leaves another en");
  CHECK(complaint(R"({"name": "fractional", "en": 0.00317, "tcol": 1e-4, "end": "overlap"})") == "accepted");
  CHECK(complaint(R"({"name": "fractional", "en": 0.003, "tcol": 1e-4, "end": "force"})") == "accepted");
  CHECK(complaint(R"({"name": "linear", "en": 0.003, "tcol": 1e-4, "end": "overlap"})") == "accepted");
}
