#include "../../verify/studies/paper.hpp"
#include "../console/temporary_folder.hpp"

#include <console/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace ricochet;
using namespace ricochet::verify;

namespace {

std::string data(const std::string& file) { return read_file(RICOCHET_SOURCE_DIR "/data/" + file); }

/// Fields of the rows below the header; lines that begin with '#' are remarks.
std::vector<std::vector<std::string>> rows(const std::string& file) {
  std::vector<std::vector<std::string>> all;
  std::istringstream text(data(file));
  bool header = true;
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    if (!header) all.emplace_back();
    for (std::string field; !header && std::getline(fields, field, ',');) all.back().push_back(field);
    header = false;
  }
  return all;
}

double table2_value(const std::string& law, const std::string& parameter) {
  for (const auto& row : rows("table2.csv"))
    if (row[0] == law && row[3] == parameter) return std::stod(row[4]);
  FAIL("no " << law << ", " << parameter);
  return 0;
}

console::Json scene(const std::string& file) { return console::Json::parse(data("scenes/" + file)); }

}  // namespace

TEST_CASE("the paper's header and the data of Table I name one collision time") {
  for (const auto& row : rows("table1.csv")) {
    const double steps = std::stod(row[0]), dt = std::stod(row[1]);
    if (steps > 0) CHECK(steps * dt == Approx(paper::steel.tcol).epsilon(1e-12));
  }
  CHECK(data("table1.csv").find("t_col = 38.6e-6 s") != std::string::npos);
}

TEST_CASE("the paper's header and the data of Table II hold the same coefficients") {
  using paper::table2;
  CHECK(table2_value("linear1", "k") == table2.linear1.k);
  CHECK(table2_value("linear1", "c") == table2.linear1.c);
  CHECK(table2_value("linear2", "k") == table2.linear2.k);
  CHECK(table2_value("linear2", "c") == table2.linear2.c);
  CHECK(table2_value("nonlinear", "k") == table2.nonlinear.k);
  CHECK(table2_value("nonlinear", "c") == table2.nonlinear.c);
  CHECK(table2_value("hysteretic", "k1") == table2.hysteretic.k1);
  CHECK(table2_value("hysteretic", "k2") == table2.hysteretic.k2);
  CHECK(table2_value("fractional", "k") == table2.fractional.k);
  CHECK(table2_value("fractional", "c") == table2.fractional.c);
  CHECK(table2_value("fractional", "alpha") == table2.fractional.alpha);
  CHECK(rows("table2.csv").size() == 11);
  // The effective mass is that of the radius and density, to the printed digits: m/2 = (2/3) π r³ ρ.
  const auto& pair = paper::pair;
  CHECK(2.0 / 3 * std::numbers::pi * pair.density * pair.radius * pair.radius * pair.radius ==
        Approx(pair.impact.mass_eff).margin(0.5e-11));
}

TEST_CASE("the paper's header holds every constant of data/paper.csv, with a place in print") {
  namespace p = paper;
  std::vector<std::pair<std::string, double>> ours{{"steel.radius", p::steel.radius},
                                                   {"steel.density", p::steel.density},
                                                   {"steel.other_density", p::steel.other_density},
                                                   {"steel.velocity", p::steel.velocity},
                                                   {"steel.k", p::steel.k},
                                                   {"steel.c", p::steel.c},
                                                   {"steel.alpha", p::steel.alpha},
                                                   {"steel.tcol", p::steel.tcol},
                                                   {"steel.tcol_estimate", p::steel.tcol_estimate},
                                                   {"steps", p::steps},
                                                   {"pair.radius", p::pair.radius},
                                                   {"pair.density", p::pair.density},
                                                   {"pair.velocity", p::pair.impact.velocity},
                                                   {"pair.mass_eff", p::pair.impact.mass_eff},
                                                   {"pair.tcol", p::pair.tcol},
                                                   {"pair.en", p::pair.en},
                                                   {"alpha_study_k", p::alpha_study_k},
                                                   {"alpha_study_c", p::alpha_study_c},
                                                   {"no_rebound_shown", p::no_rebound_shown},
                                                   {"estimate_factor", p::estimate_factor},
                                                   {"column.bead_mass", p::column.bead_mass},
                                                   {"column.velocity", p::column.velocity},
                                                   {"column.en", p::column.en},
                                                   {"column.tcol", p::column.tcol},
                                                   {"column.alpha", p::column.alpha},
                                                   {"five_spheres.sequence_axis", p::five_spheres.sequence_axis}};
  for (const double degree : p::no_rebound_degrees) ours.emplace_back("no_rebound_degrees", degree);
  for (const double time : p::five_spheres.durations) ours.emplace_back("five_spheres.durations", time);
  std::vector<std::pair<std::string, double>> printed;
  for (const auto& row : rows("paper.csv")) {
    CHECK(row.at(3).size() > 5);
    printed.emplace_back(row[0], std::stod(row[1]));
  }
  for (auto* both : {&ours, &printed}) std::sort(both->begin(), both->end());
  CHECK(ours == printed);
}

TEST_CASE("the paper's header and the scenes hold the same five spheres") {
  for (const auto& [file, alpha] : {std::pair{"five_spheres_strong.json", paper::five_spheres.strong_alpha},
                                    std::pair{"five_spheres_weak.json", paper::five_spheres.weak_alpha}}) {
    const auto json = scene(file);
    const auto& law = json["interactions"][0]["law"];
    const auto& friction = json["interactions"][0]["friction"];
    CHECK(law["k"] == paper::five_spheres.k);
    CHECK(law["c"] == paper::five_spheres.c);
    CHECK(law["alpha"] == alpha);
    CHECK(friction["mu_static"] == paper::five_spheres.mu_static);
    CHECK(friction["mu_dynamic"] == paper::five_spheres.mu_dynamic);
    CHECK(friction["decay"] == paper::five_spheres.decay);
    CHECK(friction["rolling_arm"] == paper::five_spheres.rolling_arm);
    REQUIRE(json["spheres"].size() == paper::five_spheres.balls.size());
    for (std::size_t i = 0; i < 5; ++i) {
      const auto& ball = paper::five_spheres.balls[i];
      const auto& sphere = json["spheres"][i];
      CHECK(sphere["radius"] == ball.radius);
      CHECK(sphere["density"] == ball.density);
      CHECK(sphere["velocity"][2] == ball.velocity_z);
      for (std::size_t c = 0; c < 3; ++c) CHECK(sphere["position"][c] == ball.position[c]);
    }
  }
}

TEST_CASE("the paper's header and the scene of the column name one case") {
  const auto json = scene("column.json");
  const double density = json["materials"]["bead"]["density"], radius = json["spheres"][0]["radius"];
  // Printed to three digits.
  CHECK(4.0 / 3 * std::numbers::pi * density * radius * radius * radius ==
        Approx(paper::column.bead_mass).margin(0.5e-7));
  CHECK(json["spheres"][0]["velocity"][2] == -paper::column.velocity);
  CHECK(double(json["spheres"][0]["position"][2]) - radius == Approx(paper::column.gap));
  CHECK(double(json["spheres"][1]["position"][2]) - double(json["spheres"][0]["position"][2]) - 2 * radius ==
        Approx(paper::column.gap));
  const std::string title = json["title"];
  CHECK(title.find("t_col = 1e-4 s, e_n = 0.945") != std::string::npos);
}
