// Lattices, pours, the sizes they draw and the random numbers behind them.
#include "complaints.hpp"

#include <catch2/catch.hpp>
#include <simulate/random.hpp>
#include <simulate/scene.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <regex>

using namespace ricochet;
using namespace ricochet::simulate;

namespace {

std::string scene_of(const std::string& bodies) {
  return R"({"duration": 0.01, "materials": {"glass": {"density": 2500}, "steel": {}},
  "interactions": [{"between": ["glass", "glass"], "law": {"name": "linear", "k": 1e5, "c": 1}},
                   {"between": ["glass", "steel"], "law": {"name": "linear", "k": 1e5, "c": 1}}],
  )" + bodies +
         "}";
}

Scene read(const std::string& bodies) { return read_scene("s.json", scene_of(bodies)); }

std::string complaint(const std::string& bodies) { return complaint_of(scene_of(bodies)); }

// Of many in a region without end, as far as sizes go.
std::vector<double> radii(const std::string& sizes, int number = 20000) {
  const Scene scene = read(R"("lattice": [{"number": )" + std::to_string(number) +
                           R"(, "material": "glass", "seed": 11, "region": {"low": [0, 0, 0], "high": [9, 9, 9]},
                           "radius": )" +
                           sizes + "}]");
  std::vector<double> all;
  for (const Sphere& s : scene.setup.spheres) all.push_back(s.radius);
  return all;
}

// The greatest distance between the distribution found and known: below 2.2/√n in all but 1e-4 of samples that have it.
double distance(std::vector<double> found, const std::function<double(double)>& below) {
  std::sort(found.begin(), found.end());
  double greatest = 0;
  const auto n = static_cast<double>(found.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    for (const double share : {static_cast<double>(k) / n, static_cast<double>(k + 1) / n})
      greatest = std::max(greatest, std::abs(below(found[k]) - share));
  return greatest;
}

double gauss(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

// The share of mass below each radius.
double mass_distance(std::vector<double> found, const std::function<double(double)>& below) {
  std::sort(found.begin(), found.end());
  double all = 0, sum = 0, greatest = 0;
  for (const double r : found) all += r * r * r;
  for (const double r : found) sum += r * r * r, greatest = std::max(greatest, std::abs(below(r) - sum / all));
  return greatest;
}

double least_gap(const Scene& scene) {
  double least = 1e300;
  const auto& s = scene.setup.spheres;
  for (std::size_t i = 0; i < s.size(); ++i) {
    for (std::size_t j = i + 1; j < s.size(); ++j)
      least = std::min(least,
                       norm(scene.setup.periodic.shortest(s[j].position - s[i].position)) - s[i].radius - s[j].radius);
    for (const Wall& wall : scene.setup.walls)
      least = std::min(least, -motion::Surface(wall).meet(s[i].position, s[i].radius, 0).overlap);
  }
  return least;
}

}  // namespace

TEST_CASE("random numbers are the same everywhere") {
  Random random(1);
  // As by the generator's authors.
  CHECK(random.bits() == 0x910A2DEC89025CC1u);
  CHECK(random.bits() == 0xBEEB8DA1658EEC67u);
  CHECK(Random(1, 0).bits() != Random(1, 1).bits());
  for (const double x : {-40.0, -3.0, -0.1, 0.0, 0.7, 5.0, 49.0})
    CHECK(exponential(x) == Approx(std::exp(x)).epsilon(1e-13));
}

TEST_CASE("radii have the distribution asked for, by number and by mass") {
  const double sharp = 2.2 / std::sqrt(20000.0);
  const double cut = gauss(3) - gauss(-3);
  const auto within = [&](double z) { return (gauss(z) - gauss(-3)) / cut; };
  CHECK(distance(radii(R"({"distribution": "uniform", "low": 0.001, "high": 0.003})"),
                 [](double r) { return (r - 0.001) / 0.002; }) < sharp);
  CHECK(distance(radii(R"({"distribution": "normal", "mean": 0.002, "deviation": 0.0004})"),
                 [&](double r) { return within((r - 0.002) / 0.0004); }) < sharp);
  CHECK(distance(radii(R"({"distribution": "lognormal", "median": 0.002, "sigma": 0.3})"),
                 [&](double r) { return within(std::log(r / 0.002) / 0.3); }) < sharp);
  // By mass the numbers go as the share of mass over r³; a sample's share of mass has a few times the error.
  CHECK(distance(radii(R"({"distribution": "uniform", "low": 0.001, "high": 0.003, "by": "mass"})"),
                 [](double r) { return (1 - 1e-6 / (r * r)) / (1 - 1.0 / 9); }) < sharp);
  CHECK(mass_distance(radii(R"({"distribution": "normal", "mean": 0.002, "deviation": 0.0004, "by": "mass"})"),
                      [&](double r) { return within((r - 0.002) / 0.0004); }) < 3 * sharp);
  CHECK(mass_distance(radii(R"({"distribution": "lognormal", "median": 0.002, "sigma": 0.3, "by": "mass"})"),
                      [&](double r) { return within(std::log(r / 0.002) / 0.3); }) < 3 * sharp);
  for (const bool mass : {false, true}) {
    const auto all = radii(std::string(R"({"distribution": "table", "table": [[0.001, 3], [0.002, 1]], "by": )") +
                           (mass ? "\"mass\"}" : "\"number\"}"));
    const auto small = static_cast<double>(std::count(all.begin(), all.end(), 0.001));
    const double share = mass ? 3 / (3 + 0.125) : 0.75;
    CHECK(small / 20000 == Approx(share).margin(4 * std::sqrt(share * (1 - share) / 20000)));
  }
  CHECK(radii("0.001", 5) == std::vector<double>(5, 0.001));
}

TEST_CASE("a lattice fills sites x first, and none overlap, jitter or not") {
  const Scene scene = read(R"("lattice": [{"number": 5, "material": "glass", "radius": 0.01, "velocity": [1, 2, 3],
    "spin": [4, 5, 6], "region": {"low": [0, 0, 0], "high": [0.04, 0.04, 0.1]}}])");
  REQUIRE(scene.setup.spheres.size() == 5);
  CHECK(scene.setup.spheres[1].position.x == Approx(0.03));
  CHECK(scene.setup.spheres[2].position.y == Approx(0.03));
  CHECK(scene.setup.spheres[4].position.z == Approx(0.03));
  CHECK(scene.setup.spheres[4].velocity == Vec3{1, 2, 3});
  CHECK(scene.setup.spheres[4].spin == Vec3{4, 5, 6});
  const Scene shaken = read(R"("lattice": [{"number": 400, "material": "glass", "seed": 3, "jitter": 1,
    "radius": {"distribution": "uniform", "low": 0.001, "high": 0.004}, "spacing": 0.0085,
    "region": {"point": [0, 0, 0], "axis": [0, 0, 0.12], "radius": 0.05}}])");
  CHECK(least_gap(shaken) > -1e-12);
  for (const Sphere& s : shaken.setup.spheres)
    CHECK(std::hypot(s.position.x, s.position.y) + s.radius <= 0.05 * (1 + 1e-12));
}

TEST_CASE("a pour finds room at random, beside walls, others and across borders, the same for the same seed") {
  const std::string bodies = R"("periodic": {"x": [-0.02, 0.02]},
    "spheres": [{"radius": 0.008, "material": "glass", "position": [0.02, 0, 0.02]}],
    "cylinders": [{"point": [0, 0, 0.02], "axis": [1, 0, 0], "radius": 0.022, "material": "steel"}],
    "pour": [{"number": 150, "material": "glass", "seed": SEED, "radius": {"distribution": "uniform", "low": 0.001,
      "high": 0.003}, "region": {"low": [-0.02, -0.02, 0], "high": [0.02, 0.02, 0.04]}}])";
  const auto seeded = [&](const std::string& seed) {
    std::string text = bodies;
    return read(text.replace(text.find("SEED"), 4, seed));
  };
  const Scene scene = seeded("1"), again = seeded("1"), other = seeded("2");
  CHECK(scene.setup.spheres.size() == 151);
  CHECK(least_gap(scene) > 0);
  bool across = false;
  for (std::size_t k = 0; k < 151; ++k) {
    CHECK(scene.setup.spheres[k].position == again.setup.spheres[k].position);
    const Sphere& s = scene.setup.spheres[k];
    across = across || (k > 0 && std::abs(s.position.x) + s.radius > 0.02);
  }
  CHECK(across);
  CHECK(scene.setup.spheres[50].position != other.setup.spheres[50].position);
}

TEST_CASE("what does not fit is refused with numbers") {
  const auto pour = [](const std::string& number, const std::string& more = "") {
    return R"("pour": [{"number": )" + number + R"(, "material": "glass", "radius": 0.005)" + more +
           R"(, "region": {"low": [0, 0, 0], "high": [0.05, 0.05, 0.05]}}])";
  };
  CHECK(complaint(pour("40")) == "accepted");
  CHECK(complaint(pour("100")) ==
        "/pour/0/number = 100: must be less: the spheres take 0.419 of the region, and random "
        "places hold 0.4 at most");
  CHECK(
      std::regex_match(complaint(pour("90")),
                       std::regex("/pour/0/number = 90: must be less: [5-8][0-9] found room, a sphere of 0.005 m none "
                                  "at 20000 places; they would take 0.377 of the region")));
  CHECK(complaint(pour("0")).find("/pour/0/number = 0: must be an integer from 1") == 0);
  CHECK(complaint(pour("1", R"(, "begin": 1)")).find("/pour/0/begin: only of a pour with a \"rate\"") == 0);
  CHECK(complaint(pour("1", R"(, "speed": 1)")).find("/pour/0: unknown key \"speed\"; known are number") == 0);
  const auto lattice = [](const std::string& more) {
    return R"("lattice": [{"material": "glass", "radius": 0.005, )" + more +
           R"(, "region": {"low": [0, 0, 0], "high": [0.05, 0.05, 0.05]}}])";
  };
  CHECK(complaint(lattice(R"("number": 126)")).find("at most 125: as many of the 5 x 5 x 5 sites") !=
        std::string::npos);
  CHECK(complaint(lattice(R"("number": 125)")) == "accepted");
  CHECK(complaint(lattice(R"("number": 1, "spacing": 0.009)")) ==
        "/lattice/0/spacing = 0.009: must be at least 0.01 m, twice the greatest radius");
  CHECK(complaint(R"("lattice": [{"material": "glass", "radius": 0.0012345678, "number": 1, "spacing": 0.00246914,
    "region": {"low": [0, 0, 0], "high": [0.05, 0.05, 0.05]}}])")
            .find("at least") == std::string::npos);
  CHECK(complaint(R"("lattice": [{"material": "glass", "radius": 0.0012345672, "number": 1, "spacing": 0.00246913,
    "region": {"low": [0, 0, 0], "high": [0.05, 0.05, 0.05]}}])") ==
        "/lattice/0/spacing = 0.00246913: must be at least 0.0024691344 m, twice the greatest radius");
  CHECK(complaint(lattice(R"("number": 1, "jitter": 2)")) == "/lattice/0/jitter = 2: must be in [0, 1]");
  CHECK(complaint(R"("lattice": [{"number": 1, "material": "glass", "radius": 0.03,
    "region": {"low": [0, 0, 0], "high": [0.05, 0.05, 0.05]}}])") ==
        "/lattice/0/region: has no room for the sphere of radius 0.03 m; it must be larger");
  CHECK(complaint(R"("title": "nobody")").find("\"spheres\" is missing; they, \"start\", \"lattice\" or \"pour\"") !=
        std::string::npos);
  const auto sizes = [&](const std::string& radius) {
    return complaint(R"("lattice": [{"number": 1, "material": "glass", "radius": )" + radius +
                     R"(, "region": {"low": [0, 0, 0], "high": [1, 1, 1]}}])");
  };
  CHECK(sizes("-1") == "/lattice/0/radius = -1: must be a number > 0");
  CHECK(sizes(R"({"distribution": "gamma"})").find("must be uniform or normal or lognormal or table") !=
        std::string::npos);
  CHECK(sizes(R"({"distribution": "uniform", "low": 2, "high": 1})").find("such that low, 2, is less than high, 1") !=
        std::string::npos);
  CHECK(sizes(R"({"distribution": "uniform", "low": 0.1})").find("\"high\" is missing") != std::string::npos);
  CHECK(sizes(R"({"distribution": "normal", "mean": 0.1, "deviation": 0.05})").find("less than a third of the mean") !=
        std::string::npos);
  CHECK(sizes(R"({"distribution": "normal", "mean": 0.1, "deviation": 0.01, "low": 0.19, "high": 0.2})")
            .find("not one of a million radii lies between low and high") != std::string::npos);
  CHECK(sizes(R"({"distribution": "lognormal", "median": 0.1, "sigma": 4})").find("at most 3") != std::string::npos);
  CHECK(sizes(R"({"distribution": "table", "table": []})").find("rows [r, share]") != std::string::npos);
  CHECK(sizes(R"({"distribution": "table", "table": [[1]]})").find("a radius and its share") != std::string::npos);
}
