#include "common.hpp"

#include <fmt/format.h>

namespace ricochet::verify::conformance {

namespace {

// The two spheres of the paper's Table II.
constexpr const char* swing = "m ζ'' = −k ζ: half a swing, and the velocity is turned round";
constexpr double radius = 1.5e-3, density = 1000, speed = 0.5, tcol = 1e-4, en = 0.5;

struct Spheres {
  Body first = Body::of_density(radius, density), second = Body::of_density(radius, density);
  Impact impact() const { return {speed, mass_eff(first, second)}; }
};

Case head_on(std::string name, std::string title, std::string source, std::vector<Body> bodies, const Meeting& meeting,
             const Impact& impact) {
  Case c{.name = std::move(name), .family = "normal", .title = std::move(title), .source = std::move(source)};
  c.how = by_collide;
  c.bodies = std::move(bodies);
  const bool wall = c.bodies.size() == 1;
  (wall ? c.wall_law : c.law) = meeting;
  if (wall) c.walls = {Plane{}};
  const Collision met = collide(meeting.law, impact, {.end = meeting.end});
  c.time_scale = met.tcol;
  c.duration = run_of_one * met.tcol;
  c.asked = asked_of_head_on(c.bodies.size(), impact.velocity, met.tcol, met.max_overlap);
  c.solver = one_collision;
  return c;
}

Case pair(std::string name, std::string title, std::string source, const Meeting& meeting, Spheres spheres = {}) {
  const Impact impact = spheres.impact();
  // The centre of mass rests.
  spheres.first.velocity.x = speed * spheres.second.mass / (spheres.first.mass + spheres.second.mass);
  spheres.second.velocity.x = spheres.first.velocity.x - speed;
  return head_on(std::move(name), std::move(title), std::move(source), touching(spheres.first, spheres.second), meeting,
                 impact);
}

Case on_wall(std::string name, std::string title, std::string source, Body body, double at_speed,
             const Meeting& meeting) {
  body.velocity = {-at_speed, 0, 0};
  return head_on(std::move(name), std::move(title), std::move(source), touching_wall(body), meeting,
                 {at_speed, body.mass});
}

const char* words(ContactEnd end) { return end == ContactEnd::force ? "force" : "overlap"; }

const char* source_of(LawKind kind) {
  if (kind == kind_of<Tsuji>) return by_tsuji;
  const bool real_solid =
      kind == kind_of<FractionalKelvinVoigt> || kind == kind_of<FractionalZener> || kind == kind_of<FractionalHertz>;
  return real_solid ? "the contact models of Y. A. Rossikhin, M. V. Shitikova, Appl. Mech. Rev. 63, 010801 (2010)"
                    : paper;
}

/// Every law by every end that it is made for.
void add_laws(std::vector<Case>& cases) {
  for (const LawKind kind :
       {kind_of<Linear>, kind_of<KuwabaraKono>, kind_of<Tsuji>, kind_of<Hysteretic>, kind_of<Fractional>,
        kind_of<FractionalKelvinVoigt>, kind_of<FractionalHertz>, kind_of<FractionalZener>})
    for (const ContactEnd end : {ContactEnd::force, ContactEnd::overlap}) {
      if (!kind.ends().offer(end)) continue;
      if (!unit_law(kind, en, end)) continue;  // of those with a memory some never end by overlap at e = 0.5
      cases.push_back(pair(fmt::format("normal-{}-{}", kind.name(), words(end)),
                           fmt::format("Two equal spheres, {} law, ended by {}", kind.name(), words(end)),
                           source_of(kind), calibrated(kind, end, tcol, en, Spheres().impact())));
    }
}

/// As the sphere of radius `r` made of `solid` on a rigid plane: E* = E/(1−ν²).
double hertz_on_rigid(double young, double poisson, double r) {
  return hertz_stiffness(young / (1 - poisson * poisson), r);
}

void add_published(std::vector<Case>& cases) {
  const auto add = [&](const Case& c, const std::string& test) { cases.push_back(published(c, chung_ooi + test)); };
  constexpr ElasticSolid glass{4.8e10, 0.2};
  Spheres two{Body::of_density(0.01, 2800), Body::of_density(0.01, 2800)};
  two.first.velocity.x = 10, two.second.velocity.x = -10;
  add(head_on("chung-ooi-1-glass", "Two glass spheres, Hertz's law without loss", "", touching(two.first, two.second),
              {Tsuji(hertz_stiffness(contact_modulus(glass, glass), 0.005), 0)}, {20, mass_eff(two.first, two.second)}),
      "1");
  cases.back().orders.leapfrog = 2;
  add(on_wall("chung-ooi-2-aluminium", "A sphere of aluminium alloy on a rigid plane, Hertz's law", "",
              Body::of_density(0.1, 2699), 0.2, {Tsuji(hertz_on_rigid(7e10, 0.3, 0.1), 0)}),
      "2");
  cases.back().orders.leapfrog = 2;
  const Body alumina = Body::of_density(0.0025, 4000);
  const Impact fast{3.9, alumina.mass};
  const double k = hertz_on_rigid(3.8e11, 0.23, 0.0025);
  const double c = damping_of_restitution(0.6, ContactEnd::force) * std::sqrt(5 * alumina.mass * k);
  add(on_wall("chung-ooi-3-alumina", "An alumina sphere on a rigid plane, Tsuji's law, e = 0.6", "", alumina,
              fast.velocity, {Tsuji(k, c)}),
      "3; damping for the end by force, as D. Antypov, J. A. Elliott, EPL 94, 50004 (2011) for the other");
}

void add_unequal(std::vector<Case>& cases) {
  const Spheres heavy{Body::of_density(radius, density), Body::of_density(radius, 8 * density)};
  cases.push_back(pair("unequal-masses", "Two spheres of masses 1 and 8, linear law",
                       fmt::format("{}; {}", two_bodies, linear_by_force),
                       calibrated(kind_of<Linear>, ContactEnd::force, tcol, en, heavy.impact()), heavy));
  const Spheres large{Body::of_density(radius, density), Body::of_density(3 * radius, density)};
  cases.push_back(pair("unequal-radii", "Two spheres of radii 1 and 3, Tsuji's law",
                       fmt::format("{}; {}", two_bodies, by_tsuji),
                       calibrated(kind_of<Tsuji>, ContactEnd::force, tcol, en, large.impact()), large));
}

void add_walls(std::vector<Case>& cases) {
  const Body sphere = Body::of_density(radius, density);
  const Impact to_wall{speed, sphere.mass};
  for (const ContactEnd end : {ContactEnd::force, ContactEnd::overlap})
    cases.push_back(
        on_wall(fmt::format("wall-linear-{}", words(end)),
                fmt::format("A sphere on a wall, linear law, ended by {}", words(end)),
                fmt::format("{}; {}", wall_body, end == ContactEnd::force ? linear_by_force : linear_by_overlap),
                sphere, speed, calibrated(kind_of<Linear>, end, tcol, en, to_wall)));
  cases.push_back(on_wall("wall-elastic", "A sphere on a wall, linear law without loss: no energy is made", swing,
                          sphere, speed, calibrated(kind_of<Linear>, ContactEnd::force, tcol, 1, to_wall)));
  cases.back().orders.leapfrog = 2;
}

}  // namespace

std::vector<Case> normal_cases() {
  std::vector<Case> cases;
  add_laws(cases);
  const Impact two = Spheres().impact();
  cases.push_back(pair("normal-elastic", "Two equal spheres, linear law without loss: no energy is made", swing,
                       calibrated(kind_of<Linear>, ContactEnd::force, tcol, 1, two)));
  cases.back().orders.leapfrog = 2;
  cases.push_back(pair("normal-much-loss", "Two equal spheres, overdamped linear law ended by force, e = 0.05",
                       linear_by_force, calibrated(kind_of<Linear>, ContactEnd::force, tcol, 0.05, two)));
  add_unequal(cases);
  add_walls(cases);
  add_published(cases);
  return cases;
}

}  // namespace ricochet::verify::conformance
