#include "normal.hpp"

#include "impact.hpp"
#include "solid.hpp"

#include <verify/study.hpp>

#include <console/csv.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::verify::benchmarks {

namespace {

/// An elastic meeting by Hertz's law, and its closed form.
struct Elastic {
  ClusterSetup setup;
  double k = 0;
  Impact impact;
};

Elastic two_spheres(const Solid& s) {
  constexpr double radius = 0.01, speed = 10;
  const double k = hertz_stiffness(contact_modulus(s.elastic(), s.elastic()), radius / 2);
  const Sphere left{radius, s.density, {}, {speed, 0, 0}}, right{radius, s.density, {}, {-speed, 0, 0}};
  return {against_sphere(left, right, {Tsuji(k, 0)}), k, {2 * speed, left.mass() / 2}};
}

Elastic on_a_plane(const Solid& s) {
  constexpr double radius = 0.1, speed = 0.2;
  const double k = hertz_stiffness(s.modulus_on_rigid(), radius);
  const Sphere sphere{radius, s.density, {}, {0, 0, -speed}};
  return {against_wall(sphere, {Tsuji(k, 0)}), k, {speed, sphere.mass()}};
}

struct Printed {
  double overlap, force, tcol;  // each to its last digit
};

std::vector<Row> elastic_rows(const std::string& test, const Elastic& e, const Printed* printed) {
  const double overlap = hertz_overlap(e.k, e.impact), force = e.k * std::pow(overlap, 1.5),
               tcol = hertz_time(e.k, e.impact);
  std::vector<Asked> asked{
      {.test = test, .quantity = "greatest overlap", .unit = "m", .exact = overlap, .scale = overlap},
      {.test = test, .quantity = "greatest force", .unit = "N", .exact = force, .scale = force},
      {.test = test, .quantity = "duration", .unit = "s", .exact = tcol, .scale = tcol}};
  if (printed != nullptr) {
    asked[0].published = printed->overlap, asked[0].reading = 0.5e-10;
    asked[1].published = printed->force, asked[1].reading = 0.5e-3;
    asked[2].published = printed->tcol, asked[2].reading = 0.5e-11;
  }
  return measure(asked, tcol, [&](double step) {
    const Meeting m = meet(e.setup, step);
    return std::vector<double>{m.greatest_overlap, m.greatest_force, m.tcol};
  });
}

constexpr Solid glass{"glass", 4.8e10, 0.2, 2800}, limestone{"limestone", 2e10, 0.25, 2500};
constexpr std::array on_planes{Solid{"aluminium alloy", 7e10, 0.3, 2699}, Solid{"magnesium alloy", 4e10, 0.35, 1800}};
constexpr std::array rebounding{Solid{"alumina", 3.8e11, 0.23, 4000}, Solid{"cast iron", 1e11, 0.25, 7000}};
constexpr Printed glass_printed{2.741127e-4, 10696.889, 4.033946e-5};

/// Test 3: the restitution asked for is the restitution obtained.
Row restitution_row(const Solid& s, double en) {
  constexpr double radius = 0.0025, speed = 3.9;
  const Sphere sphere{radius, s.density, {}, {0, 0, -speed}};
  const Impact impact{speed, sphere.mass()};
  const LawKind kind = kind_of<Tsuji>;
  const ElasticSolid like_rigid = s.as_on_rigid();
  const auto tcol =
      collision_time(kind, ContactEnd::force,
                     scale::Moduli{.first = like_rigid, .second = like_rigid, .radius_eff = radius}, en, impact);
  const AnyLaw law = *at_impact(unit_law(kind, en, ContactEnd::force)->law, tcol.value(), impact);
  // Tsuji's dashpot starts like t^{1/4}: order 5/4 in the limit, 2 where the other errors are greater.
  const Asked asked{.test = fmt::format("Chung & Ooi 3, {}, e = {}", s.name, en),
                    .quantity = "restitution",
                    .exact = en,
                    .scale = 1,
                    .order = {1.25, 2},
                    .published = en,
                    .reading = 1e-6};
  const ClusterSetup setup = against_wall(sphere, {law});
  return measure({asked}, *tcol, [&](double step) { return std::vector<double>{meet(setup, step).velocity.z / speed}; })
      .front();
}

void append(std::vector<Row>& rows, const std::vector<Row>& more) { rows.insert(rows.end(), more.begin(), more.end()); }

}  // namespace

std::vector<Row> normal_rows() {
  std::vector<Row> rows = elastic_rows("Chung & Ooi 1, glass", two_spheres(glass), &glass_printed);
  append(rows, elastic_rows("Chung & Ooi 1, limestone", two_spheres(limestone), nullptr));
  for (const Solid& s : on_planes)
    append(rows, elastic_rows(fmt::format("Chung & Ooi 2, {}", s.name), on_a_plane(s), nullptr));
  for (const Solid& s : rebounding)
    for (const double en : {0.2, 0.4, 0.6, 0.8}) rows.push_back(restitution_row(s, en));
  return rows;
}

void add_loading_gate(std::vector<Gate>& gates) {
  constexpr std::array columns{console::CsvColumn{"overlap", "um", true}, console::CsvColumn{"force", "kN", true}};
  console::CsvReader file(data_folder() + "/chung_ooi2011_test1_force_overlap.csv", columns);
  const Elastic e = two_spheres(glass);
  const std::vector<std::pair<double, double>> ours = meet(e.setup, hertz_time(e.k, e.impact) / 1000).loading;
  const double greatest = e.k * std::pow(hertz_overlap(e.k, e.impact), 1.5);
  double worst = 0;
  while (file.next()) {
    const double overlap = 1e-6 * file.number(0), force = 1e3 * file.number(1);
    const auto after = std::find_if(ours.begin(), ours.end(), [&](const auto& at) { return at.first >= overlap; });
    const double there = overlap == 0 || after == ours.end() ? 0 : after->second;
    worst = std::max(worst, std::abs(there - force) / greatest);
  }
  // Read off a printed curve of some hundred line widths in height.
  gates.push_back(
      at_most("Chung & Ooi 1, glass: force against overlap, the paper's curve, share of the greatest", worst, 0.01));
}

}  // namespace ricochet::verify::benchmarks
