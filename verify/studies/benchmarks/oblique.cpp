#include "oblique.hpp"

#include "impact.hpp"
#include "solid.hpp"

#include <verify/study.hpp>

#include <console/csv.hpp>
#include <console/number.hpp>
#include <ricochet/collision/oblique.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ricochet::verify::benchmarks {

namespace {

constexpr Solid alumina{"alumina", 3.8e11, 0.23, 4000}, aluminium{"aluminium alloy", 7e10, 0.33, 2700},
    steel{"steel", 2.08e11, 0.3, 7850}, polyethylene{"polyethylene", 1e9, 0.4, 1400}, nylon{"nylon", 2.5e9, 0.4, 1000},
    copper{"copper", 1.2e11, 0.35, 8900};

/// Sphere i, at i.velocity with i.spin, against j or, where that has no radius, a rigid plane: E* and G* are those of
/// one body, or two of the same.
struct Case {
  Solid solid;
  double mu = 0, en = 1;
  Sphere i{}, j{};

  bool wall() const { return j.radius == 0; }
  double radius_eff() const { return wall() ? i.radius : i.radius * j.radius / (i.radius + j.radius); }
  Vec3 normal() const { return wall() ? Vec3{0, 0, -1} : Vec3{1, 0, 0}; }
  Impact impact() const {
    const double mass = wall() ? i.mass() : i.mass() * j.mass() / (i.mass() + j.mass());
    return {dot(i.velocity - j.velocity, normal()), mass};
  }
  AnyLaw law() const {
    const ElasticSolid like = wall() ? solid.as_on_rigid() : solid.elastic();
    const scale::Moduli moduli{.first = like, .second = like, .radius_eff = radius_eff()};
    const double tcol = collision_time(kind_of<Tsuji>, ContactEnd::force, moduli, en, impact()).value();
    return at_impact(unit_law(kind_of<Tsuji>, en, ContactEnd::force)->law, tcol, impact()).value();
  }
  TangentialContact tangential() const {
    const double compliance = (wall() ? 1 : 2) * solid.shear_compliance();
    return {.law = MindlinTangential::of(1 / compliance, radius_eff()), .friction = Friction(mu, mu, 0)};
  }
};

/// How a case is to be met: by which laws.
struct Laws {
  AnyLaw normal;
  TangentialContact tangential;
};

ObliqueCollision exact(const Case& c, const Laws& laws) {
  const auto body = [](const Sphere& s) {
    return s.radius > 0 ? ImpactBody{s.mass(), s.radius, s.velocity, s.spin} : ImpactBody::wall();
  };
  return collide(laws.normal, laws.tangential, {c.normal(), body(c.i), body(c.j)}, {.arm = ContactArm::contact_point});
}

ClusterSetup setup_of(const Case& c, const Laws& laws) {
  Interaction interaction{laws.normal, laws.tangential.friction};
  interaction.tangential = laws.tangential.law;
  return c.wall() ? against_wall(c.i, interaction) : against_sphere(c.i, c.j, interaction);
}

/// A number that is made of velocity and spin of sphere i afterwards.
struct Quantity {
  std::string name, unit;
  double scale;
  std::function<double(Vec3 velocity, Vec3 spin)> of;
  std::optional<double> published = {};
  double reading = 0;
};

/// Tsuji's dashpot starts like t^{1/4}, Mindlin's spring like √t: order 5/4 or 3/2 in the limit. A plane keeps its
/// normal; two spheres turn about each other by v_t t_col/(r_i + r_j), which the exact solution leaves out.
std::vector<Row> rows_of(const std::string& test, const Case& c, const Laws& laws, std::vector<Quantity> quantities,
                         double least_order, Check check = Check::order) {
  const ObliqueCollision found = exact(c, laws);
  std::vector<Asked> asked;
  asked.reserve(quantities.size());
  for (const Quantity& q : quantities)
    asked.push_back({.test = test,
                     .quantity = q.name,
                     .unit = q.unit,
                     .exact = q.of(found.velocity_i, found.spin_i),
                     .scale = q.scale,
                     .order = {least_order, 2},
                     .check = check,
                     .published = q.published,
                     .reading = q.reading});
  const ClusterSetup setup = setup_of(c, laws);
  return measure(asked, found.normal.tcol, [&](double step) {
    const Meeting m = meet(setup, step);
    std::vector<double> values;
    values.reserve(quantities.size());
    for (const Quantity& q : quantities) values.push_back(q.of(m.velocity, m.spin));
    return values;
  });
}

Laws laws_of(const Case& c) { return {c.law(), c.tangential()}; }

/// Sphere on a plane at `speed`, `degrees` from its normal.
Case oblique(const Solid& solid, double radius, double speed, double degrees, double mu, double en) {
  const double angle = degrees * std::numbers::pi / 180;
  return {solid, mu, en, {radius, solid.density, {}, {speed * std::sin(angle), 0, -speed * std::cos(angle)}}};
}

constexpr double speed4 = 3.9, radius4 = 2.5e-3, mu4 = 0.092;

// What slides throughout is off by the error of e_n alone, at e = 0.98 the small difference of two.
std::vector<Row> test4(const Solid& solid, double degrees) {
  const Case c = oblique(solid, radius4, speed4, degrees, mu4, 0.98);
  const double vt = c.i.velocity.x;
  return rows_of(fmt::format("Chung & Ooi 4, {}, {} deg", solid.name, degrees), c, laws_of(c),
                 {{"e_t of the centre", "", 1, [vt](Vec3 v, Vec3) { return v.x / vt; }},
                  {"spin", "1/s", speed4 / radius4, [](Vec3, Vec3 w) { return w.y; }}},
                 1.25, degrees < 40 ? Check::order : Check::size);
}

/// v_t/(μ v_n) = x.
Case test5_case(const Solid& solid, double x) {
  constexpr double mu = 0.3, vn = 5;
  return {solid, mu, 1, {1e-5, solid.density, {}, {x * mu * vn, 0, -vn}}};
}

std::vector<Row> test5(const Solid& solid, double x) {
  const Case c = test5_case(solid, x);
  const double unit = c.mu * -c.i.velocity.z, r = c.i.radius;
  return rows_of(
      fmt::format("Chung & Ooi 5, {}, x = {}", solid.name, x), c, laws_of(c),
      {{"r omega'/(mu v_n)", "", std::max(1.0, x), [=](Vec3, Vec3 w) { return r * w.y / unit; }},
       {"u_t'/(mu v_n')", "", std::max(1.0, x), [=](Vec3 v, Vec3 w) { return (v.x - r * w.y) / (c.mu * v.z); }}},
      1.5);
}

/// (7/2) μ (1+e) v_n/v_st = x: a rigid sphere that slides throughout has β = x − 1.
double slip6(double x) { return 3.5 * 0.4 * 1.5 * 0.2 / x; }
Case test6_case(const Solid& solid, double x) {
  constexpr double r = 0.1;
  return {solid, 0.4, 0.5, {r, solid.density, {}, {0, 0, -0.2}, {0, -slip6(x) / r, 0}}};
}

std::vector<Row> test6(const Solid& solid, double x) {
  const Case c = test6_case(solid, x);
  const double slip = slip6(x), r = c.i.radius;
  return rows_of(fmt::format("Chung & Ooi 6, {}, x = {}", solid.name, x), c, laws_of(c),
                 {{"beta", "", 1, [=](Vec3 v, Vec3 w) { return -(v.x - r * w.y) / slip; }}}, 1.25);
}

/// Like spheres with opposite spins have no slip, and keep them: the paper's line ω' = ω.
std::vector<Row> test7(const Solid& solid, double spin) {
  constexpr double r = 0.1, v = 0.2;
  const Case c{solid,
               0.4,
               0.5,
               {r, solid.density, {}, {v, 0, 0}, {0, spin, 0}},
               {r, solid.density, {}, {-v, 0, 0}, {0, -spin, 0}}};
  const std::string test = fmt::format("Chung & Ooi 7, {}, {} 1/s", solid.name, spin);
  const std::vector<Asked> asked{{.test = test,
                                  .quantity = "spin",
                                  .unit = "1/s",
                                  .exact = spin,
                                  .scale = spin,
                                  .check = Check::rounding,
                                  .published = spin,
                                  .reading = 1e-8},
                                 {.test = test,
                                  .quantity = "velocity across",
                                  .unit = "m/s",
                                  .exact = 0,
                                  .scale = v,
                                  .check = Check::rounding,
                                  .published = 0.0,
                                  .reading = 1e-8}};
  const ClusterSetup setup = setup_of(c, laws_of(c));
  return measure(asked, exact(c, laws_of(c)).normal.tcol, [&](double step) {
    const Meeting m = meet(setup, step);
    return std::vector<double>{m.spin.y, m.velocity.z};
  });
}

/// As test 6, against a sphere five times as large and a thousand times as dense.
std::vector<Row> test8(const Solid& solid, double x) {
  constexpr double r = 0.1;
  const Case c{
      solid, 0.4, 0.5, {r, solid.density, {}, {0.2, 0, 0}, {0, -slip6(x) / r, 0}}, {5 * r, 1000 * solid.density}};
  const double slip = slip6(x);
  return rows_of(fmt::format("Chung & Ooi 8, {}, x = {}", solid.name, x), c, laws_of(c),
                 {{"beta", "", 1, [=](Vec3 v, Vec3 w) { return -(v.z - r * w.y) / slip; }}}, 1.25);
}

/// Linear springs, arm r there, the paper's r − ζ/2 here: 0.3 % of r at most.
std::vector<Row> dem05() {
  constexpr std::array columns{console::CsvColumn{"angle", "deg", true}, console::CsvColumn{"et", "", true},
                               console::CsvColumn{"omega", "1/s", true}};
  console::CsvReader file(data_folder() + "/mfix_dem05_reference.csv", columns);
  std::vector<Row> rows;
  while (file.next()) {
    const Case c = oblique(alumina, radius4, speed4, file.number(0), mu4, 1);
    const double vt = c.i.velocity.x;
    // MFiX's steps put it off by 0.01 and 3 1/s at 5 degrees, less above.
    const Laws laws{Linear(1.72e7, 0), {.law = LinearTangential(1.48e7), .friction = Friction(mu4, mu4, 0)}};
    const auto more =
        rows_of(fmt::format("MFiX DEM05, {} deg", file.number(0)), c, laws,
                {{"e_t of the centre", "", 1, [vt](Vec3 v, Vec3) { return v.x / vt; }, file.number(1), 0.02},
                 {"spin", "1/s", speed4 / radius4, [](Vec3, Vec3 w) { return w.y; }, file.number(2), 10}},
                2);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

/// Greatest difference of test 4, alumina, from the paper's reference curves: e_t and spin [1/s].
std::pair<double, double> curve4(double from_degrees) {
  constexpr std::array columns{
      console::CsvColumn{"angle1", "deg", true}, console::CsvColumn{"et", "", true},
      console::CsvColumn{"angle2", "deg", true}, console::CsvColumn{"omega", "1/s", true},
      console::CsvColumn{"angle3", "deg", true}, console::CsvColumn{"rebound_angle", "deg", true}};
  console::CsvReader file(data_folder() + "/chung_ooi2011_test4_reference.csv", columns);
  double et = 0, spin = 0;
  const auto at = [](double degrees) {
    const Case c = oblique(alumina, radius4, speed4, degrees, mu4, 0.98);
    return std::pair(c.i.velocity.x, exact(c, laws_of(c)));
  };
  while (file.next()) {
    if (file.number(0) < from_degrees) continue;
    const auto [vt, first] = at(file.number(0));
    et = std::max(et, std::abs(first.velocity_i.x / vt - file.number(1)));
    spin = std::max(spin, std::abs(at(file.number(2)).second.spin_i.y + file.number(3)));
  }
  return {et, spin};
}

/// The same of test 5 from x on, and of test 6 up to x.
double curve5(double from) {
  constexpr std::array columns{console::CsvColumn{"material", "", false}, console::CsvColumn{"x", "", true},
                               console::CsvColumn{"y", "", true}};
  console::CsvReader file(data_folder() + "/chung_ooi2011_test5_spin.csv", columns);
  double worst = 0;
  while (file.next()) {
    if (file.number(1) < from) continue;
    const Case c = test5_case(file.text(0) == "steel" ? steel : polyethylene, file.number(1));
    const double spin = exact(c, laws_of(c)).spin_i.y * c.i.radius / (c.mu * -c.i.velocity.z);
    worst = std::max(worst, std::abs(spin - file.number(2)));
  }
  return worst;
}

double curve6(double up_to) {
  constexpr std::array columns{console::CsvColumn{"x", "", true}, console::CsvColumn{"beta", "", true}};
  console::CsvReader file(data_folder() + "/chung_ooi2011_test6_restitution.csv", columns);
  double worst = 0;
  while (file.next()) {
    if (file.number(0) > up_to) continue;
    const Case c = test6_case(aluminium, file.number(0));
    const ObliqueCollision found = exact(c, laws_of(c));
    const double beta = -(found.velocity_i.x - c.i.radius * found.spin_i.y) / slip6(file.number(0));
    worst = std::max(worst, std::abs(beta - file.number(1)));
  }
  return worst;
}

}  // namespace

std::vector<Row> oblique_rows() {
  std::vector<Row> rows;
  const auto append = [&rows](const std::vector<Row>& more) { rows.insert(rows.end(), more.begin(), more.end()); };
  for (const Solid& solid : {alumina, aluminium})
    for (const double degrees : {5.0, 20.0, 40.0, 60.0}) append(test4(solid, degrees));
  for (const Solid& solid : {steel, polyethylene})
    for (const double x : {1.0, 3.0, 10.0}) append(test5(solid, x));
  for (const Solid& solid : {aluminium, nylon})
    for (const double x : {0.4, 1.5, 6.0}) append(test6(solid, x));
  for (const Solid& solid : {aluminium, copper})
    for (const double spin : {2.0, 10.0}) append(test7(solid, spin));
  for (const Solid& solid : {aluminium, nylon})
    for (const double x : {0.4, 1.5}) append(test8(solid, x));
  append(dem05());
  return rows;
}

void add_curve_gates(std::vector<Gate>& gates) {
  // Curves printed a few centimetres high, read off by eye: 2 % of their axes.
  const auto [et, spin] = curve4(10);
  gates.push_back(at_most("Chung & Ooi 4, from 10 deg: e_t, the paper's curve", et, 0.02));
  gates.push_back(at_most("Chung & Ooi 4, from 10 deg: spin, the paper's curve [1/s]", spin, 0.02 * 700));
  gates.push_back(at_most("Chung & Ooi 5, sliding: r omega/(mu v_n), the paper's curve", curve5(7), 0.02 * 6));
  gates.push_back(at_most("Chung & Ooi 6, sliding: beta, the paper's curve", curve6(0.8), 0.02 * 1.6));
}

std::string curve_remark() {
  using console::significant;
  return fmt::format(
      "The paper's curves are compared where no spring is left in them. In test 4 its reference and ours differ by {} "
      "in "
      "e_t from 10° on, but by {} at 5°, where it lies above what is measured, too. In test 5, of spheres that slide "
      "throughout, they differ by {}, of others by up to {}: there the paper's DEM turns back three quarters of the "
      "slip "
      "at every v_t, its finite elements and ours less the smaller it is. In test 6 β differs by {} where all slide, "
      "by "
      "up to {} where the springs of the paper, which the sources read here do not give, have a say.",
      significant(curve4(10).first, 2), significant(curve4(0).first, 2), significant(curve5(7), 2),
      significant(curve5(0), 2), significant(curve6(0.8), 2), significant(curve6(100), 2));
}

}  // namespace ricochet::verify::benchmarks
