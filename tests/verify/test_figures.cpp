// The numbers that the figures draw, against closed forms.
#include "../../verify/studies/figures/drawings.hpp"
#include "../../verify/studies/figures/panels.hpp"
#include "../../verify/studies/paper.hpp"
#include "../../verify/studies/sphere/restitution.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/power_law_sphere.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::verify;

namespace {

/// The fields of the line that begins so.
std::vector<std::string> line_of(const std::string& csv, const std::string& beginning) {
  const auto at = csv.find("\n" + beginning);
  if (at == std::string::npos) return {};
  std::vector<std::string> fields;
  std::istringstream line(csv.substr(at + 1, csv.find('\n', at + 1) - at - 1));
  for (std::string field; std::getline(line, field, ',');) fields.push_back(field);
  return fields;
}

double number(const std::string& text) { return std::stod(text); }

}  // namespace

TEST_CASE("over the degree: at alpha = 0 half a period of the spring in microseconds, and nothing lost") {
  const auto figure = figures::degree_figure(figures::sweep_degrees());
  const std::string& csv = figure.data.at(0).bytes;
  CHECK(csv.starts_with("alpha,t_col [1e-6 s],e_n\n-0.5,"));
  const auto spring = line_of(csv, "0,");
  REQUIRE(spring.size() == 3);
  const double tcol = std::numbers::pi * std::sqrt(paper::pair.impact.mass_eff / paper::alpha_study_k);
  CHECK(number(spring[1]) == Approx(1e6 * tcol).epsilon(1e-9));
  CHECK(number(spring[2]) == Approx(1).epsilon(1e-9));
  const auto lossy = line_of(csv, "0.5,");
  REQUIRE(lossy.size() == 3);
  CHECK(number(lossy[2]) == Approx(fractional_contact(0.5).en).epsilon(1e-9));
}

TEST_CASE("a figure's file has time, overlap, velocity and force, in the units of its head") {
  const std::vector<figures::Path> paths{{"one", {{1e-6, 2e-6, 3, 4}, {5e-6, 6e-6, 7, 8}}, "lines", 0}};
  const auto figure = figures::panels("toy", "A toy.", paths, figures::over_time, {{"all", "top right", 1}});
  CHECK(figure.data.at(0).bytes ==
        "curve,t [1e-6 s],overlap [1e-6 m],velocity [m/s],force [N]\n\"one\",1,2,3,4\n\"one\",5,6,7,8\n");
  CHECK(console::script_of(figure.plot).find("'toy.csv' skip 1 every ::0::1 using 2:4 with lines") !=
        std::string::npos);
}

TEST_CASE("the laws of Table II stand from the greatest overlap at the end to none") {
  const auto laws = figures::table2_laws();
  const auto sorted = figures::by_end_overlap(laws);
  REQUIRE(sorted.size() == 5);
  CHECK(sorted.front()->name == "hysteretic");
  CHECK(sorted.back()->name == "linear1");
  CHECK(sorted.back()->collision.overlap_end == 0);
  // Unloaded along k₂ from the greatest overlap ζ_m: k₂ (ζ_m − ζ_end) = k₁ ζ_m.
  const double k1 = paper::table2.hysteretic.k1, k2 = paper::table2.hysteretic.k2;
  const double deepest = paper::pair.impact.velocity * std::sqrt(paper::pair.impact.mass_eff / k1);
  CHECK(sorted.front()->collision.overlap_end == Approx(deepest * (1 - k1 / k2)).epsilon(1e-9));
  const std::string finding = figures::figure5(laws).finding;
  CHECK(finding.find("µm for hysteretic") < finding.find("µm for fractional"));
  CHECK(finding.find("0.0 µm for linear, ended by overlap") != std::string::npos);
  for (const auto& law : laws) CHECK(LawKind::named(law.title.substr(0, law.title.find(','))));
}

TEST_CASE("what each law misses of the sphere stands in its own column") {
  const auto figure = sphere::figure();
  const std::string& csv = figure.data.at(0).bytes;
  const auto half = line_of(csv, "0.5,");
  REQUIRE(half.size() == 8);
  const double ting = power_law_sphere(0.5).en, linear = fractional_contact(0.5).en;
  CHECK(number(half[1]) == Approx(ting).epsilon(1e-5));
  CHECK(number(half[2]) == Approx(linear).epsilon(1e-5));
  CHECK(number(half[5]) == Approx(100 * (linear / ting - 1)).epsilon(1e-3));
  // As computed beforehand by another program: 0.285653 by D^α ζ^{3/2}.
  CHECK(number(half[3]) == Approx(0.285653).epsilon(1e-5));
  CHECK(number(half[6]) == Approx(100 * (0.285653 / ting - 1)).epsilon(1e-3));
  CHECK(csv.starts_with("alpha,sphere,linear,derivative of power,power of derivative,linear [%],"));
}
