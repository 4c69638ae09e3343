#include "common.hpp"

#include <fmt/format.h>

namespace ricochet::verify::conformance {

namespace {

// So slow that the overlap is 2e-5 of the radius: where the force acts is of no account.
constexpr double radius = 1.5e-3, density = 1000, slow = 1e-3, tcol = 1e-4, en = 0.8, mu = 0.3;

/// Half a reversal: T. Becker and others.
LinearTangential half_reversed(double mass) { return tangential_for(0.5, tcol, mass, StickingForm::undamped); }
/// A half swing in t_col: N. G. Deen and others.
LinearTangential damped(double mass) { return tangential_for(0.5, tcol, mass, StickingForm::damped); }

constexpr const char* deen =
    "k_t and c_t: N. G. Deen et al., Chem. Eng. Sci. 62, 28 (2007); where it slides our own rule, "
    "docs/theory/tangential.md: "
    "the dashpot stands beside the spring, behind the slider, so that no contact makes energy. Engines have other "
    "rules, "
    "docs/engines.md";
constexpr const char* walton = "S. F. Foerster, M. Y. Louge, H. Chang, K. Allia, Phys. Fluids 6, 1108 (1994)";

/// A sphere on the wall x = 0, its velocity turned from the normal towards y, its spin about z.
Case on_wall(std::string name, std::string title, std::string source, Body body, const Meeting& meeting,
             const TangentialContact& tangential) {
  const double speed = norm(body.velocity) + body.radius * norm(body.spin);
  Case c{.name = std::move(name), .family = "oblique", .title = std::move(title), .source = std::move(source)};
  c.how = by_oblique;
  c.bodies = touching_wall(body);
  c.walls = {Plane{}};
  c.wall_law = meeting;
  c.tangential = tangential;
  c.time_scale = collide(meeting.law, Impact{-body.velocity.x, body.mass}, {.end = meeting.end}).tcol;
  c.duration = run_of_one * c.time_scale;
  c.asked = {{Quantity::vy, 1, speed}, {Quantity::wz, 1, speed / body.radius}, {Quantity::vx, 1, speed}};
  c.solver = one_collision;
  return c;
}

Body at_angle(Body body, double speed, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  body.velocity = {-speed * std::cos(angle), speed * std::sin(angle), 0};
  return body;
}

Meeting of_linear(double mass) { return calibrated(kind_of<Linear>, ContactEnd::force, tcol, en, {slow, mass}); }

/// At a given velocity along the normal, so that all take t_col.
Case slow_on_wall(std::string name, std::string title, std::string source, double degrees, const TangentialLaw& law) {
  Body body = Body::of_density(radius, density);
  const double normal = std::cos(degrees * std::numbers::pi / 180);
  body = at_angle(body, slow / normal, degrees);
  const Meeting linear = of_linear(body.mass);
  return on_wall(std::move(name), std::move(title), std::move(source), body, linear, rough(law, mu));
}

void add_angles(std::vector<Case>& cases) {
  const double mass = Body::of_density(radius, density).mass;
  cases.push_back(slow_on_wall("oblique-sticking", "20° from the normal, tangential spring: the contact sticks", becker,
                               20, half_reversed(mass)));
  cases.push_back(slow_on_wall("oblique-damped",
                               "20° from the normal, tangential spring and dashpot, a slider behind both", deen, 20,
                               damped(mass)));
  cases.push_back(slow_on_wall("oblique-mixed", "45° from the normal, tangential spring: it sticks and slides", becker,
                               45, half_reversed(mass)));
  cases.push_back(
      slow_on_wall("oblique-sliding", "70° from the normal: gross sliding", walton, 70, half_reversed(mass)));
  cases.push_back(slow_on_wall("oblique-grazing", "88° from the normal", walton, 88, half_reversed(mass)));
  Body body = at_angle(Body::of_density(radius, density), slow * std::numbers::sqrt2, 45);
  const Meeting tsuji = calibrated(kind_of<Tsuji>, ContactEnd::force, tcol, en, {slow, mass});
  // k_t/k = 8 G*/((4/3) E*) = 3 (1−ν)/(2−ν) at ν = 0.3.
  const MindlinTangential mindlin(3 * 0.7 / 1.7 * values(tsuji.law).front());
  cases.push_back(on_wall("oblique-mindlin", "45° from the normal, Tsuji's law and Mindlin's spring",
                          "R. D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20, 327 (1953); the spring keeps its force "
                          "while the contact grows: C. Thornton, S. J. Cummins, P. W. Cleary, Powder Technol. 233, 30 "
                          "(2013)",
                          body, tsuji, rough(mindlin, mu)));
}

/// A sphere at rest but for its spin meets a larger one obliquely.
Case unequal_pair() {
  Body first = Body::of_density(radius, density), second = Body::of_density(2 * radius, density);
  first.velocity = {0.5 * slow, 0.2 * slow, 0}, second.velocity = {-0.5 * slow, -0.2 * slow, 0};
  first.spin = {0, 0, 0.3 * slow / radius};
  const double mass = mass_eff(first, second);
  Case c{.name = "oblique-unequal-pair", .family = "oblique"};
  c.title = "Two spheres of radii 1 and 2 meet obliquely, one spinning";
  c.source = becker;
  c.how = by_oblique;
  c.bodies = touching(first, second);
  c.law = of_linear(mass);
  c.tangential = rough(half_reversed(mass), mu);
  c.time_scale = tcol;
  c.duration = run_of_one * tcol;
  c.asked = {{Quantity::vy, 1, slow},
             {Quantity::wz, 1, slow / radius},
             {Quantity::vy, 2, slow},
             {Quantity::wz, 2, slow / radius},
             {Quantity::vx, 1, slow}};
  c.solver = one_collision;
  return c;
}

struct Solid {
  double young, poisson, density;
  /// E* on a rigid plane, and G/(2−ν).
  double modulus() const { return young / (1 - poisson * poisson); }
  double shear() const { return young / (2 * (1 + poisson) * (2 - poisson)); }
};
constexpr Solid alumina{3.8e11, 0.23, 4000}, steel{2.08e11, 0.3, 7850}, aluminium{7e10, 0.33, 2700},
    nylon{2.5e9, 0.4, 1000}, copper{1.2e11, 0.35, 8900};

/// Tsuji's law of a restitution and Mindlin's spring; `bodies` of the solid share the compliance.
struct Hertzian {
  Meeting normal;
  double k_t = 0;  ///< of Mindlin's spring
};
Hertzian hertzian(const Solid& s, double radius_eff, double mass, double restitution, int bodies) {
  const double k = hertz_stiffness(s.modulus() / bodies, radius_eff);
  const double c =
      restitution < 1 ? damping_of_restitution(restitution, ContactEnd::force) * std::sqrt(5 * mass * k) : 0;
  return {{Tsuji(k, c)}, MindlinTangential::of(s.shear() / bodies, radius_eff).k_t()};
}

void add_published_on_plane(std::vector<Case>& cases) {
  const auto add = [&](std::string name, std::string title, int test, const Solid& s, Body body, double friction,
                       double restitution) {
    const Hertzian h = hertzian(s, body.radius, body.mass, restitution, 1);
    cases.push_back(published(
        on_wall(std::move(name), std::move(title), "", body, h.normal, rough(MindlinTangential(h.k_t), friction)),
        fmt::format("{}{}", chung_ooi, test)));
  };
  const Body small = Body::of_density(2.5e-3, alumina.density);
  add("chung-ooi-4-alumina", "An alumina sphere on a rigid plane at 5°", 4, alumina, at_angle(small, 3.9, 5), 0.092,
      0.98);
  Body tiny = Body::of_density(1e-5, steel.density);
  tiny.velocity = {-5, 3 * 0.3 * 5, 0};
  add("chung-ooi-5-steel", "A steel sphere on a rigid plane, v_t = 3 μ v_n", 5, steel, tiny, 0.3, 1);
  Body spinning = Body::of_density(0.1, aluminium.density);
  // x = (7/2) μ (1+e) v_n/v_st = 1.5, v_st the slip.
  const double slip = 3.5 * 0.4 * 1.5 * 0.2 / 1.5;
  spinning.velocity = {-0.2, 0, 0}, spinning.spin = {0, 0, -slip / spinning.radius};
  add("chung-ooi-6-aluminium", "A spinning sphere of aluminium alloy meets a rigid plane head on", 6, aluminium,
      spinning, 0.4, 0.5);
}

/// Tests 7 and 8: spinning spheres meet each other, and one that is far larger and heavier.
void add_published_pairs(std::vector<Case>& cases) {
  const auto add = [&](std::string name, std::string title, int test, const Solid& s, const Body& first,
                       const Body& second) {
    const double reduced = first.radius * second.radius / (first.radius + second.radius);
    const double mass = mass_eff(first, second), approach = first.velocity.x - second.velocity.x;
    const Hertzian h = hertzian(s, reduced, mass, 0.5, 2);
    Case c{.name = std::move(name), .family = "oblique", .title = std::move(title)};
    c.how = by_oblique;
    c.bodies = touching(first, second);
    c.law = h.normal;
    c.tangential = rough(MindlinTangential(h.k_t), 0.4);
    c.time_scale = collide(h.normal.law, Impact{approach, mass}).tcol;
    c.duration = run_of_one * c.time_scale;
    const double spin = std::max(norm(first.spin), approach / first.radius);
    c.asked = {{Quantity::wz, 1, spin}, {Quantity::vy, 1, approach}, {Quantity::vx, 1, approach}};
    c.solver = one_collision;
    cases.push_back(published(c, fmt::format("{}{}", chung_ooi, test)));
  };
  Body left = Body::of_density(0.1, copper.density), right = left;
  left.velocity.x = 0.2, right.velocity.x = -0.2, left.spin.z = 10, right.spin.z = -10;
  add("chung-ooi-7-copper", "Two copper spheres that spin against each other: nothing slides", 7, copper, left, right);
  Body light = Body::of_density(0.1, nylon.density);
  light.velocity.x = 0.2, light.spin.z = -3.5 * 0.4 * 1.5 * 0.2 / 1.5 / 0.1;
  add("chung-ooi-8-nylon", "A spinning nylon sphere meets one five times as large and a thousand times as dense", 8,
      nylon, light, Body::of_density(0.5, 1000 * nylon.density));
}

Case dem05() {
  const Body body = at_angle(Body::of_density(2.5e-3, 4000), 3.9, 20);
  return published(on_wall("dem05", "An alumina sphere on a wall at 20°, linear springs", "", body, {Linear(1.72e7, 0)},
                           rough(LinearTangential(1.48e7), 0.092)),
                   std::string(mfix) + "DEM05");
}

/// Spins about the normal; the limit (2/3) μ a R is that of a disc that turns without sliding.
void add_torsion(std::vector<Case>& cases) {
  Body body = Body::of_density(radius, density);
  body.velocity.x = -slow, body.spin.x = 0.02;
  const TangentialContact free = rough(half_reversed(body.mass), mu);
  Case c = on_wall("torsion-none", "A sphere that spins about the normal, no torsional resistance: the spin stays",
                   walton, body, of_linear(body.mass), free);
  c.family = "torsion";
  c.asked = {{Quantity::wx, 1, body.spin.x}, {Quantity::vx, 1, slow}, {Quantity::wz, 1, body.spin.x}};
  cases.push_back(c);
  TangentialContact held = free;
  // It reaches its limit, some 8e-10 N m, within a tenth of the 2e-6 rad that the sphere turns by.
  held.torsion = {Torsion::Limit::separate, {1e-2, 0}};
  c.name = "torsion-spin-down", c.title = "A sphere that spins about the normal, torsion limited by (2/3) μ a R";
  c.source =
      "Z. Farkas, G. Bartels, T. Unger, D. E. Wolf, Phys. Rev. Lett. 90, 248302 (2003); spring and limit as J. S. "
      "Marshall, J. Comput. Phys. 228, 1541 (2009)";
  c.tangential = held;
  cases.push_back(c);
}

}  // namespace

std::vector<Case> oblique_cases() {
  std::vector<Case> cases;
  add_angles(cases);
  cases.push_back(unequal_pair());
  add_published_on_plane(cases);
  add_published_pairs(cases);
  cases.push_back(dem05());
  add_torsion(cases);
  return cases;
}

}  // namespace ricochet::verify::conformance
