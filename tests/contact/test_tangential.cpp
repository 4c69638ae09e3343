#include <catch2/catch.hpp>
#include <rapidcheck.h>
#include <ricochet/contact/tangential.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace ricochet;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double at_once = std::numeric_limits<double>::infinity();

rc::Gen<double> within(double low, double high) {
  constexpr int parts = 1'000'000;
  return rc::gen::map(rc::gen::inRange(0, parts + 1), [=](int i) { return low + (high - low) * i / parts; });
}

/// Rotates about a fixed skew axis by the shortest turn of one unit vector into another, or mirrors.
struct Frame {
  Vec3 x, y, z;
  Vec3 operator()(Vec3 a) const { return a.x * x + a.y * y + a.z * z; }
};

Frame any_frame() {
  const double a = *within(0, 6.28), b = *within(0, 6.28);
  const Vec3 z{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
  const Vec3 x{std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), -std::sin(a)};
  return {x, cross(z, x), z};
}

TangentialContact any_contact() {
  TangentialContact c;
  const double damping = *rc::gen::element(0.0, 0.3, 5.0);
  if (*rc::gen::arbitrary<bool>())
    c.law = LinearTangential(*within(0.1, 10), damping);
  else
    c.law = MindlinTangential(*within(0.1, 10), damping);
  const double slow = *within(0, 1), fast = slow * *within(0, 1);
  c.friction = Friction(slow, fast, *within(0, 2), *rc::gen::element(0.0, 1.0));
  c.torsion = {*rc::gen::element(Torsion::Limit::none, Torsion::Limit::separate, Torsion::Limit::disc),
               {*within(0.01, 1), *rc::gen::element(0.0, 0.1)},
               *within(0, 1)};
  c.rolling = {*rc::gen::element(0.0, 0.2), {*within(0.01, 1), *rc::gen::element(0.0, 0.1)}};
  check(c);
  return c;
}

Vec3 any_tangent() { return {*within(-1, 1), *within(-1, 1), 0}; }
SlipMotion any_motion() { return {any_tangent(), *within(-1, 1), any_tangent()}; }
Pressing any_pressing() { return {*within(0, 2), *within(0, 0.5), *within(0, 0.5), 1.0}; }

double work(const Traction& t, const SlipMotion& m, double dt) {
  return dt * (dot(t.sliding, m.slip) + t.torsion * m.spin + dot(t.rolling, m.roll));
}

/// How far (force, torque), in units of μR and μRa, lies beyond the disc's curve: the greatest excess over its support
/// lines F x + 𝒯 y ≤ F F + 𝒯 𝒯, by sampling.
double beyond_the_disc(double force, double torque) {
  double most = -1;
  for (int n = 0; n <= 2000; ++n) {
    const double angle = 1.5707963267948966 * n / 2000, x = std::sin(angle), y = std::cos(angle);
    const DiscFriction f = disc_friction(y > 0 ? x / y : std::numeric_limits<double>::infinity());
    // (F, 𝒯) is the gradient of the mean speed Φ(x, y), so Φ = xF + y𝒯 supports the curve in direction (x, y).
    most = std::max(most, x * (force - f.force) + y * (torque - f.torque));
  }
  return most;
}

}  // namespace

TEST_CASE("a tangential law says what it is: its name, parameters and their domains") {
  CHECK(tangential_names() == std::vector<std::string_view>{"rigid", "linear", "mindlin"});
  const std::array<double, 2> v{3, 0.5};
  for (const auto name : {"linear", "mindlin"}) {
    const auto law = tangential_law(name, v);
    REQUIRE(law);
    CHECK(ricochet::name(*law) == name);
    CHECK(values(*law) == std::vector<double>{3, 0.5});
    CHECK(compliant(*law));
    CHECK(parameters_of(*law).data() == tangential_parameters(name)->data());
  }
  CHECK(tangential_parameters("linear")->front().unit() == "kg/s^2");
  CHECK(tangential_parameters("mindlin")->front().unit() == "kg/(s^2 m^(1/2))");
  CHECK_FALSE(compliant(*tangential_law("rigid", {})));
  CHECK_FALSE(tangential_law("loose", v));
  CHECK_FALSE(tangential_parameters("loose"));
  CHECK_THROWS_WITH(tangential_law("rigid", v), "rigid: takes 0 parameters, not 2");
  CHECK_THROWS_WITH(LinearTangential(0), "k_t = 0: must be finite and > 0");
  CHECK_THROWS_WITH(MindlinTangential(1, -1), "c_t = -1: must be finite and >= 0");
}

TEST_CASE("Mindlin's stiffness is 8 G* a") {
  const double radius_eff = 0.003, shear = 2e9, overlap = 1e-6;
  const Spring s = MindlinTangential::of(shear, radius_eff).spring(overlap);
  CHECK(s.stiffness == Approx(8 * shear * std::sqrt(radius_eff * overlap)).epsilon(4 * epsilon));
  CHECK(MindlinTangential(1).spring(-1).stiffness == 0);
}

TEST_CASE("a limit without a spring is refused by name") {
  TangentialContact c{.law = LinearTangential(1), .friction = Friction(0.5, 0.5, 0)};
  CHECK_NOTHROW(check(c));
  c.torsion.limit = Torsion::Limit::separate;
  CHECK_THROWS_WITH(check(c), Catch::Contains("torsion stiffness = 0"));
  c.torsion.limit = Torsion::Limit::none;
  c.rolling.mu = 0.1;
  CHECK_THROWS_WITH(check(c), Catch::Contains("rolling stiffness = 0"));
  c.rolling.mu = -1;
  CHECK_THROWS_WITH(check(c), Catch::Contains("mu_rolling = -1"));
}

TEST_CASE("no history makes energy, and every step's balance closes") {
  CHECK(rc::check([] {
    const TangentialContact contact = any_contact();
    Elongation e;
    Pressing before = any_pressing();
    double stored = 0, done = 0;
    for (int n = 0; n < 60; ++n) {
      const Pressing after = any_pressing();
      const SlipMotion motion = any_motion();
      const double dt = *within(0.01, 1);
      const TangentialStep step = tangential_step(contact, e, motion, before, after, dt);
      const TangentialState now = tangential_state(contact, after, norm(motion.slip));
      const double taken = -work(step.answer.traction, motion, dt);
      for (const TangentialEnergy& burnt : {step.dashpots, step.sliders})
        RC_ASSERT(burnt.sliding >= 0 && burnt.torsion >= 0 && burnt.rolling >= 0);
      // What is left over is ½k(Δξ)² of the implicit rule.
      const double left = taken - (step.stored.sum() - stored) - step.dashpots.sum() - step.sliders.sum();
      const double scale = 20 * (now.sliding.stiffness + now.torsion.stiffness + now.rolling.stiffness) + stored;
      RC_ASSERT(left >= -100 * epsilon * scale);
      done += taken;
      RC_ASSERT(done >= step.stored.sum() - 1e-12 * scale);
      stored = step.stored.sum();
      e = step.elongation;
      before = after;
    }
  }));
}

TEST_CASE("the traction never exceeds its limits, and a law of springs alone is left to them") {
  CHECK(rc::check([] {
    const TangentialContact contact = any_contact();
    const Pressing pressing = any_pressing();
    const SlipMotion motion = any_motion();
    const Elongation e{any_tangent(), *within(-1, 1), any_tangent()};
    const TangentialState s = tangential_state(contact, pressing, norm(motion.slip));
    const TangentialStep step = tangential_step(contact, e, motion, pressing, pressing, 0.1);
    const Traction& t = step.answer.traction;
    const double slack = 1 + 10 * epsilon;
    RC_ASSERT(norm(t.sliding) <= s.sliding_limit * slack);
    RC_ASSERT(std::abs(t.torsion) <= s.torsion_limit * slack);
    RC_ASSERT(norm(t.rolling) <= s.rolling_limit * slack);
    if (s.disc_radius > 0 && s.sliding_limit > 0)
      RC_ASSERT(beyond_the_disc(norm(t.sliding) / s.sliding_limit,
                                std::abs(t.torsion) / (s.sliding_limit * s.disc_radius)) < 1e-12);
    // A contact without area holds no strain.
    if (!step.answer.slides && s.sliding.stiffness > 0)
      RC_ASSERT(norm(step.elongation.slide - e.slide - 0.1 * motion.slip) < 1e-14);
  }));
}

TEST_CASE("a spin alone is held by 2/3 a mu R or another arm, rolling by (rho a + mu_r R*) R") {
  const Pressing pressing{.force = 7, .overlap = 0.1, .contact_radius = 0.3, .radius_eff = 0.4};
  TangentialContact contact{.law = LinearTangential(1), .friction = Friction(0.5, 0.5, 0, 2)};
  contact.rolling = {0.05, {1, 0}};
  contact.torsion = {Torsion::Limit::separate, {1, 0}};
  const double mu_r = 0.5 * 7;
  CHECK(tangential_state(contact, pressing, 0).torsion_limit == Approx(2.0 / 3 * 0.3 * mu_r));
  CHECK(tangential_state(contact, pressing, 0).rolling_limit == Approx((2 * 0.3 + 0.05 * 0.4) * 7));
  contact.torsion.arm = 0.1;
  CHECK(tangential_state(contact, pressing, 0).torsion_limit == Approx(0.1 * 0.3 * mu_r));
  contact.torsion.limit = Torsion::Limit::none;
  CHECK(tangential_state(contact, pressing, 0).torsion_limit == 0);
}

TEST_CASE("beyond the disc's curve the nearest admissible traction is taken") {
  // The nearest point p of a convex set to w, in the metric 1/K: (w − p)·(p' − p)/K ≤ 0 for every admissible p'.
  CHECK(rc::check([] {
    TangentialContact contact{.law = LinearTangential(*within(0.1, 10)), .friction = Friction(0.5, 0.5, 0)};
    contact.torsion = {Torsion::Limit::disc, {*within(0.01, 1), 0}};
    const TangentialState s = tangential_state(contact, {2, 0.1, 0.3, 1}, 0);
    const Traction wanted{any_tangent() * 5, *within(-1, 1), {}};
    const auto [p, slides, twists, rolls] = limited(s, wanted, at_once);
    RC_ASSERT(slides == twists);
    // All around the curve in the plane of what is wanted, where the nearest lies, and somewhere off it.
    const Vec3 along = norm(wanted.sliding) > 0 ? wanted.sliding / norm(wanted.sliding) : Vec3{1, 0, 0};
    const double angle = *within(0, 6.28);
    for (int n = 0; n <= 400; ++n) {
      const DiscFriction f = disc_friction(std::tan(1.57 * n / 400));
      for (const Vec3 way : {along, -1.0 * along, Vec3{std::cos(angle), std::sin(angle), 0}})
        for (const double side : {-1.0, 1.0}) {
          const Vec3 other = s.sliding_limit * f.force * way;
          const double torque = side * s.sliding_limit * s.disc_radius * f.torque;
          const double product = dot(wanted.sliding - p.sliding, other - p.sliding) / s.sliding.stiffness +
                                 (wanted.torsion - p.torsion) * (torque - p.torsion) / s.torsion.stiffness;
          RC_ASSERT(product <= 1e-10);
        }
    }
  }));
}

TEST_CASE("neither rotation nor mirror changes the answer") {
  CHECK(rc::check([] {
    const TangentialContact contact = any_contact();
    const Pressing before = any_pressing(), after = any_pressing();
    const SlipMotion m = any_motion();
    const Elongation e{any_tangent(), *within(-1, 1), any_tangent()};
    const Frame turn = any_frame();
    const double mirror = *rc::gen::element(-1.0, 1.0);  // along the contact's own y: spins about e change sign
    const auto image = [&](Vec3 a) { return turn({a.x, mirror * a.y, a.z}); };
    const TangentialStep here = tangential_step(contact, e, m, before, after, 0.2);
    const TangentialStep there = tangential_step(contact, {image(e.slide), mirror * e.twist, image(e.roll)},
                                                 {image(m.slip), mirror * m.spin, image(m.roll)}, before, after, 0.2);
    const auto near = [](Vec3 a, Vec3 b) { return norm(a - b) <= 1e-12 * (1 + norm(a)); };
    RC_ASSERT(near(image(here.answer.traction.sliding), there.answer.traction.sliding));
    RC_ASSERT(near(image(here.answer.traction.rolling), there.answer.traction.rolling));
    RC_ASSERT(std::abs(mirror * here.answer.traction.torsion - there.answer.traction.torsion) <= 1e-12);
    RC_ASSERT(near(image(here.elongation.slide), there.elongation.slide));
    RC_ASSERT(std::abs(here.sliders.sum() - there.sliders.sum()) <= 1e-12 * (1 + here.sliders.sum()));
  }));
}

TEST_CASE("the traction is continuous where the limit is reached") {
  // It changes no faster than the springs and dashpots do: |ΔT| ≤ K|Δu| dt, K = k + c/dt.
  CHECK(rc::check([] {
    TangentialContact contact = any_contact();
    contact.torsion.limit = Torsion::Limit::none;
    contact.friction = Friction(0.3, 0.3, 0);
    const Pressing pressing = any_pressing();
    const double dt = 0.1;
    const SlipMotion m = any_motion();
    SlipMotion other = m;
    other.slip += 1e-3 * any_tangent();
    const Elongation e{any_tangent(), 0, {}};
    const auto force = [&](const SlipMotion& motion) {
      return tangential_step(contact, e, motion, pressing, pressing, dt).answer.traction.sliding;
    };
    const Spring s = spring(contact.law, pressing.overlap);
    const double stiffness = s.stiffness * dt + s.damping;
    RC_ASSERT(norm(force(other) - force(m)) <= stiffness * norm(other.slip - m.slip) * (1 + 1e-9) + 1e-14);
  }));
}

TEST_CASE("Mindlin's contact makes no energy in closed cycles of load and shear, where a plain spring k(a) does") {
  // Sheared by x under ζ₁, loaded to ζ₂, sheared back, unloaded to ζ₁. A spring that stiffens with the strain in it
  // would return ½k₂x² for the ½k₁x² it took. Here loading keeps the force k₁x, and the way back gives
  // ∫ (k₁x − k₂s) ds = k₁x² − ½k₂x², so that the cycle takes ½k₁x² − k₁x² + ½k₂x² = ½(k₂ − k₁)x².
  const double low = 0.01, high = 0.04, x = 1e-3;
  TangentialContact contact{.law = MindlinTangential(1e3), .friction = Friction(10, 10, 0)};
  const auto at = [](double overlap) { return Pressing{1e3, overlap, 0.1, 1}; };
  const double k1 = spring(contact.law, low).stiffness, k2 = spring(contact.law, high).stiffness;
  REQUIRE(k2 == Approx(2 * k1));
  const auto cycle = [&](int n) {
    Elongation e;
    double taken = 0;
    const auto move = [&](double shear, double from, double to) {
      for (int k = 0; k < n; ++k) {
        const SlipMotion motion{{shear / n, 0, 0}, 0, {}};
        const auto step = tangential_step(contact, e, motion, at(from + (to - from) * k / n),
                                          at(from + (to - from) * (k + 1) / n), 1);
        CHECK_FALSE(step.answer.slides);
        taken -= work(step.answer.traction, motion, 1);
        e = step.elongation;
      }
    };
    move(x, low, low), move(0, low, high), move(-x, high, high), move(0, high, low);
    return std::pair{taken, e.slide.x};
  };
  const double exact = 0.5 * (k2 - k1) * x * x;
  const auto [coarse, unused] = cycle(100);
  const auto [fine, strain] = cycle(200);
  CHECK(2 * fine - coarse == Approx(exact).epsilon(1e-10));  // order 1, and exactly so: the rule adds ½kx²/n a shear
  CHECK(strain == Approx(-0.5 * x).epsilon(1e-12));          // k₁x/k₂ − x, kept while the contact shrinks
  CHECK(coarse - exact == Approx(0.5 * (k1 + k2) * x * x / 100).epsilon(1e-9));
}

TEST_CASE("a slider behind spring and dashpot lets them relax to the limit") {
  // R and u constant, started unstrained with c u > μR: c ξ' + k ξ = μR, ξ = (μR/k)(1 − exp(−k t/c)).
  const double k = 3, c = 2, limit = 0.5, time = 0.8;
  const TangentialContact contact{.law = LinearTangential(k, c), .friction = Friction(0.5, 0.5, 0)};
  const double exact = limit / k * (1 - std::exp(-k / c * time));
  const auto error = [&](int n) {
    Elongation e;
    for (int i = 0; i < n; ++i) {
      const auto step = tangential_step(contact, e, {{0, 1, 0}, 0, {}}, {1, 0.1, 0.1, 1}, {1, 0.1, 0.1, 1}, time / n);
      CHECK(step.answer.traction.sliding.y == Approx(-limit));
      CHECK(step.answer.slides);
      e = step.elongation;
    }
    return std::abs(e.slide.y - exact);
  };
  const double coarse = error(100), fine = error(200);
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.02));
  // The rule's (1 + λh)^{−n} is e^{−λt}(1 + λ²ht/2 + …).
  const double rate = k / c;
  CHECK(fine == Approx(limit / k * std::exp(-rate * time) * 0.5 * rate * rate * time * time / 200).epsilon(0.01));
}

TEST_CASE("without a dashpot the strain is set back to the limit at once") {
  const TangentialContact contact{.law = LinearTangential(4), .friction = Friction(0.5, 0.5, 0)};
  const auto step = tangential_step(contact, {}, {{3, 4, 0}, 0, {}}, {2, 0.1, 0.1, 1}, {2, 0.1, 0.1, 1}, 1);
  CHECK(norm(step.elongation.slide - Vec3{0.6, 0.8, 0} / 4) < 1e-15);
  CHECK(step.sliders.sliding == Approx(1 * (5 - 0.25)));
  const TangentialState s = tangential_state(contact, {2, 0.1, 0.1, 1}, 0);
  CHECK(set_back(s, {}, step.answer.traction, at_once) == step.elongation);
}

TEST_CASE("an elongation turns with the normal: lengths stay, and the way back undoes it") {
  CHECK(rc::check([] {
    const Frame frame = any_frame(), other = any_frame();
    const Elongation e{frame(any_tangent()), 0.3, frame(any_tangent())};
    const Elongation there = turned(e, frame.z, other.z), back = turned(there, other.z, frame.z);
    if (1 + dot(frame.z, other.z) < 1e-3) return;
    RC_ASSERT(std::abs(dot(there.slide, other.z)) < 1e-12);
    RC_ASSERT(std::abs(norm(there.slide) - norm(e.slide)) < 1e-12);
    RC_ASSERT(std::abs(dot(there.slide, there.roll) - dot(e.slide, e.roll)) < 1e-11);
    RC_ASSERT(there.twist == e.twist);
    RC_ASSERT(norm(back.slide - e.slide) < 1e-12 && norm(back.roll - e.roll) < 1e-12);
  }));
  const Elongation e{{1, 0, 0}, 0, {0, 1, 0}};
  CHECK(turned(e, {0, 0, 1}, {0, 0, -1}) == e);
}
