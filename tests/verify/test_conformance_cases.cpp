#include "../console/temporary_folder.hpp"
#include "conformance_cases.hpp"

#include "../../verify/conformance/case_json.hpp"
#include "../../verify/conformance/half_step.hpp"
#include "../../verify/conformance/ricochet_run.hpp"
#include "../../verify/conformance/solvers.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>

using namespace ricochet;
using namespace ricochet::verify::conformance;

namespace {

const Answer& answer(const std::vector<Answer>& all, Quantity quantity, std::size_t body = 1) {
  return *std::find_if(all.begin(), all.end(),
                       [&](const Answer& a) { return a.quantity == quantity && a.body == body; });
}

double value(const std::string& name, Quantity quantity, std::size_t body = 1) {
  return answer(answers(case_named(name)), quantity, body).value;
}

}  // namespace

TEST_CASE("conformance: every case can be named, run and graded") {
  std::set<std::string> names;
  for (const Case& c : all_cases()) {
    INFO(c.name);
    CHECK(names.insert(c.name).second);
    CHECK(c.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-.") == std::string::npos);
    CHECK_FALSE(c.source.empty());
    CHECK_FALSE(c.how.empty());
    // Others' set-ups are answered here.
    const bool published = c.name.starts_with("chung-ooi") || c.name.starts_with("dem0");
    CHECK(c.source.starts_with("set-up of ") == published);
    CHECK(c.how.starts_with("computed here, not the publication's printed numbers: ") == published);
    CHECK(c.steps.size() >= fewest_runs);
    CHECK(c.law.has_value() == (c.bodies.size() > 1));
    CHECK(c.wall_law.has_value() == !c.walls.empty());
    if (norm(c.gravity) > 0) {
      // A state between two steps would say nothing of a height.
      CHECK(c.flight_steps == 0);
      const double scales = c.duration / c.time_scale;
      CHECK(scales == Approx(std::round(scales)).epsilon(1e-12));
    }
    for (const Answer& a : answers(c)) {
      CHECK(std::isfinite(a.value));
      CHECK(a.scale > 0);
      CHECK(a.error >= 0);
      CHECK(a.error < 5e-3 * a.scale);
    }
  }
  CHECK(names.size() == 55);
}

TEST_CASE("conformance: a run has the steps that the file says, whatever rounding does to a quotient") {
  Case c = case_named("normal-linear-force");
  CHECK(c.steps_of_run(100) == 175);  // 1.5 + 173 = 174.5
  CHECK(c.end_of_run(100) == Approx(173.5 * c.time_scale / 100).epsilon(1e-12));
  c.flight_steps = 0, c.duration = 0.3 * c.time_scale;  // 0.3·10 is above 3 by rounding or below
  CHECK(c.steps_of_run(10) == 3);
  c.duration = (0.3 + 1e-5) * c.time_scale;
  CHECK(c.steps_of_run(10) == 4);
  const Case moving = case_named("oblique-sticking");
  const Body at = moving.start(50).front();
  CHECK(at.position.x == Approx(moving.bodies[0].position.x + 1.5e-3 * moving.time_scale / 50));
  CHECK(at.position.y < 0);
}

TEST_CASE("conformance: the order of a stepping that locates the touch is that of the force's root there") {
  const auto located = [](const char* name) { return double(to_json(case_named(name))["expected_order"]["located"]); };
  for (const char* name :
       {"normal-linear-force", "normal-hysteretic-force", "normal-fractional-force", "dem01-fall", "chung-ooi-1-glass"})
    CHECK(located(name) == 2);
  for (const char* name :
       {"normal-tsuji-force", "normal-tsuji-overlap", "unequal-radii", "chung-ooi-3-alumina", "oblique-mindlin"})
    CHECK(located(name) == 1.25);
  CHECK(located("normal-kuwabara-kono-force") == 1.5);
  // Measured in our own stepping of many bodies, which locates it.
  for (const auto& [name, steps] :
       {std::pair("normal-tsuji-overlap", 400), std::pair("normal-kuwabara-kono-force", 12800)}) {
    const Case c = case_named(name);
    const double exact = value(name, Quantity::vx);
    const auto off = [&](int n) { return std::abs(run_ricochet(c, n).bodies[0].velocity.x - exact); };
    CHECK(std::log2(off(steps) / off(2 * steps)) == Approx(c.orders.located).margin(0.05));
  }
}

TEST_CASE("conformance: published numbers of Chung and Ooi's first test") {
  CHECK(std::abs(value("chung-ooi-1-glass", Quantity::max_overlap) - 2.741127e-4) <= 0.5e-10);
  CHECK(std::abs(value("chung-ooi-1-glass", Quantity::contact_time) - 4.033946e-5) <= 0.5e-11);
  CHECK(value("chung-ooi-1-glass", Quantity::vx) == Approx(-10).epsilon(1e-10));
  CHECK(value("chung-ooi-3-alumina", Quantity::vx) == Approx(0.6 * 3.9).epsilon(1e-10));
  CHECK(value("chung-ooi-7-copper", Quantity::wz) == 10);
}

TEST_CASE("conformance: what is closed elsewhere is what the solvers give") {
  const double pi = std::numbers::pi;
  SECTION("bounces leave powers of e") {
    for (const char* name : {"re-contact-linear", "re-contact-fractional"})
      CHECK(value(name, Quantity::vx) == Approx(0.5 * std::pow(0.8, 5)).epsilon(1e-10));
  }
  SECTION("a sphere laid on a floor is a damped oscillator") {
    const Case c = case_named("resting-floor");
    const double zeta = 0.3, w = pi / c.time_scale, wd = w * std::sqrt(1 - zeta * zeta), t = c.duration, sag = 1e-6;
    const double swing = std::exp(-zeta * w * t) * (std::cos(wd * t) + zeta * w / wd * std::sin(wd * t));
    CHECK(value(c.name, Quantity::x) == Approx(c.bodies[0].radius - sag * (1 - swing)).epsilon(1e-12));
  }
  SECTION("a slope: rolling with a swinging spring, and sliding") {
    const Case c = case_named("slope-rolling");
    // m v' = m g sin θ − k ξ, ξ'' = g sin θ − (7/2)(k/m) ξ: v = (5/7) g sin θ t + (2/7) g sin θ sin(Ωt)/Ω.
    const double pull = 9.81 * std::sin(20 * pi / 180), omega = pi / c.time_scale;  // (7/2)(2/7) k/m
    const double t = c.duration;
    CHECK(value(c.name, Quantity::vy) ==
          Approx(5.0 / 7 * pull * t + 2.0 / 7 * pull * std::sin(omega * t) / omega).epsilon(1e-9));
    const Case s = case_named("slope-sliding");
    const double g = 9.81 / std::sqrt(2);
    // The spring is loaded within a swing, a time scale, so the law of sliding bodies holds but for that.
    CHECK(value(s.name, Quantity::vy) == Approx(g * (1 - 0.2) * s.duration).epsilon(1e-2));
    CHECK(value(s.name, Quantity::wz) == Approx(2.5 * 0.2 * g * s.duration / 1e-3).epsilon(5e-2));
  }
  SECTION("a sliding sphere rolls with 5/7 of its speed, a rolling one is slowed by (5/7) μ_r g") {
    CHECK(value("dem04-sliding-to-rolling", Quantity::vy) == Approx(5.0 / 7 * 0.5).epsilon(1e-3));
    const Case c = case_named("rolling-resistance");
    CHECK(0.05 - value(c.name, Quantity::vy) == Approx(5.0 / 7 * 0.1 * 9.81 * c.duration).epsilon(5e-2));
  }
  SECTION("gross sliding") {
    const Case c = case_named("oblique-sliding");
    const double vt = c.bodies[0].velocity.y;
    // But for the first loading of the spring.
    CHECK(value(c.name, Quantity::vy) == Approx(vt - 0.3 * 1.8 * 1e-3).epsilon(1e-2));
  }
  SECTION("a disc's torsion takes (2/3) μ a R of the spin all the time") {
    // R = k ζ + c ζ', e = 0.8; with ∫R dt = 1.8 m v and a ≤ √(2 r ζ_max) the loss of spin has a bound.
    const double lost = 0.02 - value("torsion-spin-down", Quantity::wx);
    const Case c = case_named("torsion-spin-down");
    const Body& b = c.bodies[0];
    const double deepest = std::sqrt(2 * b.radius * 1e-3 * c.time_scale / pi);
    CHECK(lost > 0);
    CHECK(lost < 2.0 / 3 * 0.3 * deepest * 1.8 * b.mass * 1e-3 / b.inertia());
    CHECK(lost > 0.5 * 2.0 / 3 * 0.3 * deepest * 1.8 * b.mass * 1e-3 / b.inertia());
  }
}

TEST_CASE("conformance: the solver on a line and the binary collision agree") {
  for (const char* name : {"normal-linear-force", "normal-linear-overlap", "normal-kuwabara-kono-force",
                           "normal-tsuji-force", "normal-tsuji-overlap", "unequal-radii", "wall-linear-force",
                           "wall-linear-overlap", "chung-ooi-1-glass", "chung-ooi-3-alumina"}) {
    INFO(name);
    const Case c = case_named(name);
    const Solution line = on_a_line(c, ContactArm::radius), exact = one_collision(c, ContactArm::radius);
    for (std::size_t i = 0; i < c.bodies.size(); ++i)
      CHECK(line.bodies[i].velocity.x == Approx(exact.bodies[i].velocity.x).epsilon(1e-7));
  }
}

TEST_CASE("conformance: conserved quantities of many bodies") {
  const Solution chain = on_a_line(case_named("chain-five-beads"), ContactArm::radius);
  double momentum = 0;
  for (const Body& b : chain.bodies) momentum += b.mass * b.velocity.x;
  CHECK(momentum == Approx(chain.bodies[0].mass * 0.5).epsilon(1e-11));
  CHECK(energy(chain.bodies, {}) == Approx(0.5 * chain.bodies[0].mass * 0.25).epsilon(1e-7));
  const Body at{1, 2, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}};
  CHECK(energy({at}, {-10, 0, 0}) == Approx(4 + 0.5 * 0.8 + 60));
}

TEST_CASE("conformance: an engine's rule that is ours gives our answers") {
  // The rule that keeps force and strain as asked, without a dashpot; a fine leapfrog is good to 1e-5.
  for (const char* name : {"oblique-sticking", "oblique-mixed", "oblique-mindlin", "oblique-unequal-pair",
                           "chung-ooi-6-aluminium", "chung-ooi-8-nylon"}) {
    INFO(name);
    const Case c = case_named(name);
    const Solution rule = by_rule(c, {}, {}).value(), exact = one_collision(c, ContactArm::radius);
    for (const Asked& asked : c.asked) CHECK(std::abs(number(rule, asked) - number(exact, asked)) < 2e-5 * asked.scale);
  }
  const Case deep = case_named("dem05");
  const Solution inside = by_rule(deep, {}, {0.5, 0.5}).value(), exact = one_collision(deep, ContactArm::contact_point);
  for (const Asked& asked : deep.asked)
    CHECK(std::abs(number(inside, asked) - number(exact, asked)) < 2e-5 * asked.scale);
  const Case torsion = case_named("torsion-spin-down");
  const Solution twisted = by_rule(torsion, {}, {}).value(), asked = one_collision(torsion, ContactArm::radius);
  for (const Asked& q : torsion.asked) CHECK(std::abs(number(twisted, q) - number(asked, q)) < 2e-5 * q.scale);
  CHECK_FALSE(by_rule(case_named("slope-rolling"), {}, {}));
  CHECK_FALSE(by_rule(case_named("normal-linear-force"), {}, {}));
}

TEST_CASE("conformance: a case names the source of what it has, not of another") {
  const auto source = [](const char* name) { return case_named(name).source; };
  // The paper's Table II has these laws at this impact.
  for (const char* name : {"normal-linear-force", "normal-linear-overlap", "normal-kuwabara-kono-force",
                           "normal-hysteretic-force", "normal-fractional-force"})
    CHECK(source(name).ends_with("Table II"));
  for (const Case& c : all_cases())
    if (c.source.find("Table II") != std::string::npos) CHECK(c.name.starts_with("normal-"));
  for (const char* name : {"normal-tsuji-force", "normal-tsuji-overlap", "unequal-radii"})
    CHECK(source(name).find("Tsuji, T. Tanaka, T. Ishida, Powder Technol. 71, 239 (1992)") != std::string::npos);
  for (const char* name : {"unequal-masses", "unequal-radii"})
    CHECK(source(name).starts_with("m ζ'' = −F with m = m₁m₂/(m₁+m₂): L. D. Landau"));
  for (const char* name : {"wall-linear-force", "wall-linear-overlap"})
    CHECK(source(name).starts_with("m ζ'' = −F with the sphere's m"));
}

TEST_CASE("conformance: a case says the rule of its tangential contact in full") {
  const auto rule = [](const char* name) { return std::string(to_json(case_named(name))["tangential"]["rule"]); };
  const auto has = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  for (const Case& c : all_cases())
    if (c.tangential) CHECK(has(rule(c.name.c_str()), "then xi = (c xi/dt - T)/K"));
  CHECK(has(rule("oblique-mindlin"), "k_t sqrt(overlap)"));
  CHECK_FALSE(has(rule("oblique-damped"), "sqrt"));
  CHECK(has(rule("torsion-spin-down"), "Torsion: "));
  CHECK(has(rule("rolling-resistance"), "Rolling: "));
  CHECK_FALSE(has(rule("rolling-free"), "Rolling: "));

  // Stepped by these words, the case with a dashpot converges to its answer at first order.
  const Case c = case_named("oblique-damped");
  const std::vector<double> law = values(c.wall_law->law), spring = values(c.tangential->law);
  const double k = spring[0], damping = spring[1], mu = c.tangential->friction.mu_static();
  const auto tangential_velocity = [&](int n) {
    const double dt = c.step(n), m = c.bodies[0].mass, r = c.bodies[0].radius;
    const double big = k + damping / dt;
    double x = r, vx = c.bodies[0].velocity.x, vy = c.bodies[0].velocity.y, w = 0, xi = 0;
    for (long i = 0; i < std::lround(c.duration / dt); ++i) {
      x += 0.5 * dt * vx;
      if (x < r) {
        const double force = std::max(0.0, law[0] * (r - x) - law[1] * vx), u = vy - r * w;
        double t = -k * xi - big * u * dt;
        if (std::abs(t) > mu * force) t = std::copysign(mu * force, t);
        xi = (damping * xi / dt - t) / big;
        vx += dt / m * force, vy += dt / m * t, w -= dt * 2.5 / (m * r) * t;
      }
      x += 0.5 * dt * vx;
    }
    return vy;
  };
  const Answer vy = answer(answers(c), Quantity::vy);
  const double coarse = tangential_velocity(4000), fine = tangential_velocity(8000);
  CHECK(std::abs(fine - vy.value) < 1e-3 * vy.scale);
  CHECK(std::abs(2 * fine - coarse - vy.value) < 2e-5 * vy.scale);
}

TEST_CASE("conformance: every key of a case is described") {
  std::string text = read_file(RICOCHET_SOURCE_DIR "/docs/conformance.md");
  const std::size_t begin = text.find("## A case");
  text = text.substr(begin, text.find("\n## Results") - begin);
  std::set<std::string> keys;
  const std::function<void(const console::Json&)> collect = [&](const console::Json& json) {
    for (const auto& [key, value] : json.items()) {
      if (json.is_object() && key != "schema") keys.insert(key);
      // A law's parameters are the law's.
      if (value.is_structured() && key != "parameters") collect(value);
    }
  };
  for (const Case& c : all_cases()) collect(to_json(c));
  CHECK(keys.size() > 30);
  for (const std::string& key : keys) {
    INFO(key);
    CHECK((text.find("`" + key + "`") != std::string::npos || text.find("`" + key + "[]`") != std::string::npos));
  }
}

TEST_CASE("conformance: a case's file says all of it") {
  for (const Case& c : all_cases()) {
    INFO(c.name);
    const console::Json json = console::Json::parse(console::document(to_json(c)));
    CHECK(json["schema"] == "ricochet/case/1");
    CHECK(json["case"] == c.name);
    const auto vec = [](const console::Json& j) { return Vec3{j[0], j[1], j[2]}; };
    REQUIRE(json["bodies"].size() == c.bodies.size());
    for (std::size_t i = 0; i < c.bodies.size(); ++i) {
      const auto& b = json["bodies"][i];
      CHECK(b["radius"] == c.bodies[i].radius);
      CHECK(b["mass"] == c.bodies[i].mass);
      CHECK(b["inertia"] == 0.4 * c.bodies[i].mass * c.bodies[i].radius * c.bodies[i].radius);
      CHECK(vec(b["position"]) == c.bodies[i].position);
      CHECK(vec(b["velocity"]) == c.bodies[i].velocity);
      CHECK(vec(b["spin"]) == c.bodies[i].spin);
    }
    for (std::size_t i = 0; i < c.walls.size(); ++i) CHECK(vec(json["walls"][i]["normal"]) == c.walls[i].normal);
    CHECK(vec(json["gravity"]) == c.gravity);
    for (const auto& [key, meeting] : {std::pair("law", c.law), std::pair("wall_law", c.wall_law)}) {
      if (!meeting) {
        CHECK(json[key].is_null());
        continue;
      }
      std::vector<double> v;
      for (const auto& [name, number] : json[key]["parameters"].items()) v.push_back(number);
      CHECK(values(LawKind::named(std::string(json[key]["name"])).value().with(v)) == values(meeting->law));
      CHECK((json[key]["end"] == "force") == (meeting->end == ContactEnd::force));
    }
    CHECK(json["tangential"].is_null() == !c.tangential);
    if (c.tangential) {
      std::vector<double> v;
      for (const auto& [name, number] : json["tangential"]["parameters"].items()) v.push_back(number);
      CHECK(values(tangential_law(std::string(json["tangential"]["name"]), v).value()) == values(c.tangential->law));
      CHECK(json["tangential"]["mu"] == c.tangential->friction.mu_static());
      CHECK(json["tangential"]["mu_rolling"] == c.tangential->rolling.mu);
      CHECK(json["tangential"]["torsion"].is_object() == (c.tangential->torsion.limit != Torsion::Limit::none));
    }
    CHECK(json["flight_steps"] == c.flight_steps);
    CHECK(json["duration"] == c.duration);
    CHECK(json["steps"] == console::Json(c.steps));
    const std::vector<Answer> all = answers(c);
    REQUIRE(json["answers"].size() == all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      CHECK(json["answers"][i]["quantity"] == name(all[i].quantity));
      CHECK(json["answers"][i]["value"] == all[i].value);
      CHECK(json["answers"][i]["required"] == all[i].required);
    }
  }
}
