#include "oblique_cases.hpp"

#include <catch2/catch.hpp>
#include <ricochet/collision/tangential_restitution.hpp>

#include <array>
#include <string>
#include <vector>

using namespace oblique;

namespace {

const LinearTangential engine_spring(1.48e7);
const Friction measured(0.092, 0.092, 0);
/// Holds whatever comes, but in the last 1e-9 of a collision or so.
const Friction holds(1e9, 1e9, 0);

}  // namespace

TEST_CASE("the centre's restitution and spin of a sphere on a wall are those of a plain stepping, converged") {
  // Leapfrog at t_col/320000, to all of its printed digits: linear k_n = 1.72e7, k_t = 1.48e7 N/m, mu = 0.092, e_n = 1.
  struct Row {
    double angle, et, spin;
  };
  const std::array rows{Row{0.5, 0.900117, 3.399360},   Row{2.5, 0.865117, 22.945770}, Row{5, 0.806425, 65.797683},
                        Row{7.5, 0.726165, 139.396342}, Row{10, 0.651813, 235.802206}, Row{15, 0.594091, 409.722045},
                        Row{20, 0.593122, 542.726029},  Row{25, 0.621716, 623.491715}, Row{30, 0.681303, 621.459830},
                        Row{40, 0.780717, 549.713492},  Row{60, 0.893768, 358.800000}};
  for (const Row& row : rows) {
    const auto out = collide(Linear(1.72e7, 0), {engine_spring, measured}, at_angle(row.angle));
    CAPTURE(row.angle);
    REQUIRE(out.separated());
    CHECK(*out.et == Approx(row.et).margin(5.1e-7));
    CHECK(-out.spin_i.y == Approx(row.spin).margin(2e-6));
  }
}

namespace {

/// Linear springs along and across the normal, without loss, on a wall: every phase in closed form, one after another.
/// ζ = (v/w) sin wt; slide: q = ±μR, m_t u' = −q; stick: u, q of an oscillator with W² = k_t/m_t.
class ClosedPhases {
 public:
  ClosedPhases(const ObliqueImpact& impact, double k, double k_t, double mu)
      : k_t_(k_t),
        m_t_(2.0 / 7 * impact.i.mass),
        w_(std::sqrt(k / impact.i.mass)),
        grip_(mu * impact.i.mass * w_ * impact.i.velocity.z),
        u_(impact.i.velocity.x + radius * impact.i.spin.y) {}

  /// u at the end.
  double run() {
    bool sticks = k_t_ * u_ < grip_ * w_;  // the spring's force and the limit grow from 0 together
    const double end = std::numbers::pi / w_;
    while (time_ < end) {
      sign_ = sticks ? 0 : q_ < 0 || (q_ == 0 && u_ < 0) ? -1 : 1;
      const double next = first_event(end);
      const State then = at(next);
      u_ = then.u, q_ = then.q, time_ = next;
      sticks = !sticks;
    }
    return u_;
  }

 private:
  struct State {
    double u, q;
  };
  double limit(double t) const { return grip_ * std::sin(w_ * t); }

  State at(double t) const {
    if (sign_ != 0)
      return {u_ - sign_ * grip_ / (w_ * m_t_) * (std::cos(w_ * time_) - std::cos(w_ * t)), sign_ * limit(t)};
    const double W = std::sqrt(k_t_ / m_t_), angle = W * (t - time_), c = std::cos(angle), s = std::sin(angle);
    return {u_ * c - q_ / (m_t_ * W) * s, q_ * c + u_ * m_t_ * W * s};
  }
  /// > 0 while the phase holds: the slider's speed, or what is left to the limit.
  double margin(double t) const {
    const State s = at(t);
    return sign_ != 0 ? sign_ * s.u - grip_ * w_ * std::cos(w_ * t) / k_t_ : limit(t) - std::abs(s.q);
  }
  double first_event(double end) const {
    constexpr int parts = 20000;
    const double h = (end - time_) / parts;
    for (int n = 1; n < parts; ++n) {
      double low = time_ + n * h, high = low + h;
      if (!(margin(low) > 0 && margin(high) <= 0)) continue;
      for (int halving = 0; halving < 60; ++halving) (margin(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
      return low;
    }
    return end;
  }

  double k_t_, m_t_, w_, grip_, u_, q_ = 0, time_ = 0;
  int sign_ = 0;  // of sliding; 0: sticks
};

}  // namespace

TEST_CASE("sticking and sliding in turn is what the closed forms of its phases give") {
  for (const double degrees : {0.5, 2.5, 5.0, 7.5, 10.0, 15.0, 20.0, 25.0, 29.0, 35.0})
    for (const double spin : {0.0, -200.0}) {
      const ObliqueImpact impact = at_angle(degrees, {0, spin, 0});
      if (impact.i.velocity.x + radius * spin <= 0) continue;
      const auto out = collide(Linear(1.72e7, 0), {engine_spring, measured}, impact);
      const double slip = ClosedPhases(impact, 1.72e7, 1.48e7, 0.092).run();
      CAPTURE(degrees, spin);
      CHECK(out.velocity_i.x + radius * out.spin_i.y ==
            Approx(slip).margin(1e-9 * (impact.i.velocity.x + radius * std::abs(spin))));
    }
}

namespace {

/// What friction at its limit throughout makes of an impact with a spin of 100 1/s.
void check_slides_throughout(const ObliqueImpact& impact, const ObliqueCollision& out) {
  REQUIRE(out.separated());
  const double change = 0.092 * (1 + out.normal.en) * impact.i.velocity.z;
  CHECK(out.velocity_i.x == Approx(impact.i.velocity.x - change).epsilon(1e-9));
  CHECK(out.velocity_i.z == Approx(-out.normal.en * impact.i.velocity.z).epsilon(1e-9));
  CHECK((out.spin_i.y - 100) * radius == Approx(-2.5 * change).epsilon(1e-9));
  CHECK(out.impulse_ratio == Approx(0.092).epsilon(1e-9));
  CHECK(out.stick_time == 0);
  CHECK(out.switches == 0);
}

}  // namespace

TEST_CASE("gross sliding is exact, whatever the laws") {
  // u_t > (7/2) μ(1+e_n)v_n, and the limit is passed as the bodies touch: at once by a dashpot with c u > μR, or where
  // k u > μR', as R begins like ζ. Then the impulse is μ(1+e_n) m v_n.
  const ObliqueImpact impact = at_angle(70, {0, 100, 0});
  for (const TangentialLaw tangential : {TangentialLaw(RigidTangential{}), TangentialLaw(LinearTangential(1.48e7, 15)),
                                         TangentialLaw(MindlinTangential(4e9, 15))})
    each_law([&](const auto& law) {
      CAPTURE(law.name, name(tangential));
      check_slides_throughout(impact, collide(law, {tangential, measured}, impact));
    });
  check_slides_throughout(impact, collide(Linear(1.72e7, 0), {engine_spring, measured}, impact));
  check_slides_throughout(impact, collide(Hysteretic(1.2e7, 2.4e7), {engine_spring, measured}, impact));
}

TEST_CASE("a repulsion that begins faster than a tangential spring is strained lets the contact stick at first") {
  // R(0) = c v_n: it sticks until k u t = μR, over which the force is on the mean half its limit: the impulse is less
  // than gross sliding's by μ²c²v_n²/(2 k u) and what R gains meanwhile.
  const ObliqueImpact impact = at_angle(80);
  const auto out = collide(Linear(1.72e7, 0.12), {engine_spring, measured}, impact);
  const double v = impact.i.velocity.z, first = std::pow(0.092 * 0.12 * v, 2) / (2 * 1.48e7 * impact.i.velocity.x);
  const double lacking =
      0.092 * impact.i.mass * (1 + out.normal.en) * v - impact.i.mass * (impact.i.velocity.x - out.velocity_i.x);
  // Until the meeting R grows by R'/(k u/μ − R') of itself, R' = k_n v.
  const double slower = 1 - 0.092 * 1.72e7 * v / (1.48e7 * impact.i.velocity.x);
  CHECK(lacking == Approx(first / slower).epsilon(2e-3));
  CHECK(out.switches == 1);
}

TEST_CASE("a contact that sticks from touch to end is an oscillator that the normal law does not enter") {
  for (const LinearTangential spring : {engine_spring, LinearTangential(1.48e7, 15), LinearTangential(1e6, 800)})
    each_law([&](const auto& law) {
      const ObliqueImpact impact = at_angle(20, {0, -50, 0});
      const auto out = collide(law, {spring, holds}, impact);
      CAPTURE(law.name, spring.c_t());
      REQUIRE(out.separated());
      // Fast damped sticking contacts slide for some 1e-9 of the collision at its start: c u > μR.
      const double beta = sticking_restitution(spring, out.normal.tcol, impact.i.mass);
      CHECK(*out.beta == Approx(beta).margin(2e-8));
      const double slip = impact.i.velocity.x - 50 * radius;
      CHECK(out.velocity_i.x == Approx(impact.i.velocity.x - 2.0 / 7 * (1 + beta) * slip).epsilon(2e-8));
    });
}

TEST_CASE("the spring that is asked to have a tangential restitution has it in a collision") {
  for (const double beta0 : {0.2, 0.7, 1.0}) {
    const ObliqueImpact impact = at_angle(10);
    const double tcol = collide(Linear(1.72e7, 12), {speed, impact.i.mass}).tcol;
    for (const auto form : {StickingForm::damped, StickingForm::undamped}) {
      const auto spring = tangential_for(beta0, tcol, impact.i.mass, form);
      CHECK(*collide(Linear(1.72e7, 12), {spring, holds}, impact).beta == Approx(beta0).margin(2e-8));
    }
  }
}

TEST_CASE("rigid friction takes the smaller of sliding and sticking, the three-parameter model with beta0 = 0") {
  // O. R. Walton; Foerster et al., Phys. Fluids 6, 1108 (1994).
  for (const double degrees : {0.01, 1.0, 10.0, 25.0, 32.0, 33.0, 60.0, 89.0})
    each_law([&](const auto& law) {
      const ObliqueImpact impact = at_angle(degrees);
      const auto out = collide(law, {RigidTangential{}, measured}, impact);
      const double slides = 0.092 * (1 + out.normal.en) * impact.i.velocity.z, sticks = 2.0 / 7 * impact.i.velocity.x;
      CAPTURE(law.name, degrees);
      CHECK(impact.i.velocity.x - out.velocity_i.x == Approx(std::min(slides, sticks)).epsilon(1e-9));
      CHECK(out.switches == (sticks < slides ? 1 : 0));
    });
}

TEST_CASE("rolling resistance that nothing overcomes keeps a sphere from turning") {
  // Then u = V: sliding takes all of it, or μ(1+e_n)v_n, and the spin stays.
  for (const double degrees : {5.0, 80.0}) {
    TangentialContact contact{RigidTangential{}, measured};
    contact.rolling.mu = 100;
    const ObliqueImpact impact = at_angle(degrees);
    const auto out = collide(Linear(1.72e7, 0), contact, impact);
    const double most = 2 * 0.092 * impact.i.velocity.z;
    CHECK(out.velocity_i.x == Approx(std::max(0.0, impact.i.velocity.x - most)).margin(1e-9));
    CHECK(std::abs(out.spin_i.y) * radius < 1e-9);
  }
}

TEST_CASE("rigid friction stops the slip when its impulse has been passed, which the closed form dates") {
  // ζ' = v cos wt: the impulse m v (1 − cos wt) μ reaches (2/7) m u at cos wt = 1 − 2u/(7μv).
  const ObliqueImpact impact = at_angle(15);
  const auto out = collide(Linear(1.72e7, 0), {RigidTangential{}, measured}, impact);
  const double share = 2 * impact.i.velocity.x / (7 * 0.092 * impact.i.velocity.z);
  CHECK(out.slip_time == Approx(std::acos(1 - share) * std::sqrt(impact.i.mass / 1.72e7)).epsilon(1e-9));
  CHECK(out.slip_time + out.stick_time == Approx(out.normal.tcol).epsilon(1e-10));
}

TEST_CASE("springs and dashpots have no say in rigid torsion and rolling, which stop what turns for good") {
  TangentialContact rigid{.friction = {0.7, 0.4, 0.7}, .torsion = {Torsion::Limit::separate}, .rolling = {.mu = 0.05}};
  TangentialContact sprung = rigid;
  sprung.torsion.spring = {0.01, 0.01}, sprung.rolling.spring = {0.03, 0.02};
  const ObliqueImpact impact{.i = {1.4, 6.4, {-0.3, 0.2, 0.4}, {0.05, -0.1, -0.0136}}};
  const auto bare = collide(Tsuji(1, 0.176), rigid, impact), out = collide(Tsuji(1, 0.176), sprung, impact);
  REQUIRE(out.separated());
  CHECK(out.spin_i == bare.spin_i);
  CHECK(out.velocity_i == bare.velocity_i);
  CHECK(out.lost.sum() == bare.lost.sum());
  CHECK(std::abs(out.spin_i.z) <= 1e-14);  // torsion has stopped it half-way, at the event's rounding
  CHECK(out.lost.torsion == Approx(0.5 * inertia(impact.i) * std::pow(impact.i.spin.z, 2)).epsilon(1e-9));
}

TEST_CASE("ever stiffer springs without loss go over into full reversals of the slip, or into sliding, not rigid") {
  // Where k_t grows, the contact point swings back and forth at the frequency of k_t: the centre's mean loss is rigid
  // friction's, the strain never stays at rest. A damped one comes to rest: the limit is the rigid law.
  const ObliqueImpact impact = at_angle(20);
  const double rigid = *collide(Linear(1.72e7, 0), {RigidTangential{}, measured}, impact).et;
  const auto off = [&](double k) {
    const double critical = 2 * std::sqrt(k * 2.0 / 7 * impact.i.mass);
    return std::abs(*collide(Linear(1.72e7, 0), {LinearTangential(k, critical), measured}, impact).et - rigid);
  };
  CHECK(off(1e9) < 2e-2);
  CHECK(off(1e11) < 0.3 * off(1e9));
}

TEST_CASE("a law has the same oblique collision on its own path and on the generic one") {
  const auto check = [](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    for (const double degrees : {3.0, 17.0, 50.0})
      for (const TangentialLaw tangential :
           {TangentialLaw(engine_spring), TangentialLaw(MindlinTangential(4e9)), TangentialLaw(RigidTangential{}),
            TangentialLaw(LinearTangential(1.48e7, 15))}) {
        const TangentialContact contact{tangential, measured};
        const auto own = collide(law, contact, at_angle(degrees)),
                   other = collide<Law>(law, contact, at_angle(degrees));
        CAPTURE(Law::name, degrees, name(tangential));
        CHECK(*own.et == Approx(*other.et).epsilon(2e-9));
        CHECK(*own.beta == Approx(*other.beta).margin(2e-9));
        CHECK(own.lost.sum() == Approx(other.lost.sum()).margin(2e-9 * energy(at_angle(degrees))));
      }
  };
  check(Linear(1.72e7, 0));
  check(Linear(1.72e7, 12));
  check(KuwabaraKono(4e9, 1500));
  check(Tsuji(4e9, 150));
  check(Hysteretic(1.2e7, 2.4e7));
}

TEST_CASE("a hysteretic law that loses nothing, a fractional one of degree 0 and a spring are one") {
  const TangentialContact contact{MindlinTangential(4e9, 15), measured};
  const auto spring = collide(Linear(1.72e7, 0), contact, at_angle(12));
  for (const auto& other : {collide(Hysteretic(1.72e7, 1.72e7), contact, at_angle(12)),
                            collide(Fractional(1.72e7, 1, 0), contact, at_angle(12))}) {
    CHECK(*other.et == Approx(*spring.et).epsilon(1e-10));
    CHECK(other.lost.sum() == Approx(spring.lost.sum()).epsilon(1e-8));
  }
}

TEST_CASE("tangential forces end with the repulsion, also where the normal motion is ended by overlap") {
  const Linear law(1.72e7, 12);
  const TangentialContact contact{engine_spring, measured};
  const auto force = collide(law, contact, at_angle(12)),
             overlap = collide(law, contact, at_angle(12), {ContactEnd::overlap});
  CHECK(overlap.normal.status == CollisionStatus::ended_by_overlap);
  CHECK(overlap.normal.en < force.normal.en);
  CHECK(*overlap.et == Approx(*force.et).epsilon(1e-11));
  CHECK(overlap.slip_time + overlap.stick_time == Approx(force.normal.tcol).epsilon(1e-10));
}

TEST_CASE("a grazing impact keeps the digits of its small change") {
  for (const double ratio : {1e-3, 1e-6, 1e-9}) {
    const ObliqueImpact impact{.i = sphere({1, 0, ratio})};
    const auto out = collide(Linear(1.72e7, 0), {engine_spring, measured}, impact);
    CHECK(out.impulse_ratio == Approx(0.092).epsilon(1e-9));
    CHECK(norm(out.impulse) ==
          Approx(impact.i.mass * ratio * (1 + out.normal.en) * std::hypot(1, 0.092)).epsilon(1e-9));
  }
}

TEST_CASE("an impact without slip or without friction is the normal one") {
  const TangentialContact contact{engine_spring, measured};
  const auto head_on = collide(Linear(1.72e7, 12), contact, {.i = sphere({0, 0, 2})});
  CHECK_FALSE(head_on.et);
  CHECK_FALSE(head_on.beta);
  CHECK(head_on.impulse_ratio == 0);
  // Rolling on the wall as it touches: u = v − ωr… = 0.
  const auto rolls = collide(Linear(1.72e7, 12), contact, {.i = sphere({1, 0, 2}, {0, -1 / radius, 0})});
  CHECK_FALSE(rolls.beta);
  CHECK(*rolls.et == 1);
  const auto smooth = collide(Linear(1.72e7, 12), {engine_spring, Friction{}}, at_angle(30, {1, 2, 3}));
  CHECK(*smooth.et == 1);
  CHECK(smooth.spin_i == Vec3{1, 2, 3});
}

TEST_CASE("bodies and laws outside their domains are refused by name") {
  const Linear law(1e6, 0);
  const TangentialContact contact{engine_spring, measured};
  const auto message = [&](const ObliqueImpact& impact, const TangentialContact& c) -> std::string {
    try {
      collide(law, c, impact);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  CHECK(message({.i = sphere({1, 0, -1})}, contact) == "speed of approach = -1: must be > 0");
  CHECK(message({.normal = {}, .i = sphere({1, 0, 1})}, contact) == "normal = 0: must be longer than 0");
  CHECK(message({.i = ImpactBody::wall({0, 0, 1})}, contact) == "mass = inf: must be finite and > 0");
  CHECK(message({.i = {1, 0, {0, 0, 1}, {}}}, contact) == "radius = 0: must be finite and > 0");
  CHECK(message({.i = {1, 1, {0, 0, 1}, {}, 0.7}}, contact) == "inertia_ratio = 0.7: must be > 0 and <= 2/3");
  CHECK(message({.i = sphere({NAN, 0, 1})}, contact) == "velocity = nan: must be finite");
  TangentialContact loose = contact;
  loose.torsion = {Torsion::Limit::disc};
  CHECK(message(at_angle(10), loose).substr(0, 21) == "torsion stiffness = 0");
}

TEST_CASE("what is no separation along the normal is none obliquely") {
  const TangentialContact contact{engine_spring, measured};
  const auto stays = collide(Fractional(1e6, 1, 1.0), contact, at_angle(10));
  CHECK(stays.status == CollisionStatus::permanent_contact);
  CHECK_FALSE(stays.separated());
  CHECK(collide(Linear(1.72e7, 0), contact, at_angle(10), {.max_evaluations = 50}).status ==
        CollisionStatus::budget_spent);
}

TEST_CASE("a damping so small that the force is back past the overlap's end within a step hides no end") {
  // y² + γ w > 0 again for y < 0: the last root lies 2√γ or so apart.
  for (const double c : {1e-12, 1e-9, 1e-6, 1e-5, 1.08775e-4, 3.26521e-4, 1e-3}) {
    const auto out = collide(Linear(1, c), {LinearTangential(1), measured}, {.i = {1, 10, {0.3, 0, 0.1}, {}}});
    CAPTURE(c);
    CHECK(out.separated());
    CHECK(out.impulse_ratio > 0.05);
  }
}

namespace {

/// A rigid disc that slides and spins under R = kζ, ζ = (v/w) sin wt, by steps of `friction_impulse`, of order 2.
struct StepwiseDisc {
  Vec3 slip;
  double spin = 0, spins = 0;  // how long [s], to a step
};
StepwiseDisc disc_by_steps(const ObliqueImpact& impact, double k, int steps) {
  const ImpactBody& b = impact.i;
  const double w = std::sqrt(k / b.mass), h = std::numbers::pi / w / steps, v = b.velocity.z;
  const double turns = 1 / inertia(b);
  double spins = 0;
  FrictionProblem p;
  p.mobility = {3.5 / b.mass, radius * turns, turns};
  SlipMotion motion{{b.velocity.x + radius * b.spin.y, b.velocity.y - radius * b.spin.x, 0}, b.spin.z, {}};
  for (int n = 0; n < steps; ++n) {
    p.normal_impulse = b.mass * v * (std::cos(w * h * n) - std::cos(w * h * (n + 1)));
    const double overlap = v / w * std::sin(w * h * (n + 0.5));
    p.contact_radius = std::sqrt(overlap * (2 * radius - overlap));
    p.before = p.free = motion;
    const FrictionSolution s = friction_impulse(measured, p, {});
    motion.slip += p.mobility.slip * s.impulse.sliding;
    motion.spin += turns * s.impulse.torsion;
    if (std::abs(motion.spin) > 1e-9 * std::abs(b.spin.z)) spins = h * (n + 1);
  }
  return {motion.slip, motion.spin, spins};
}

}  // namespace

TEST_CASE("a rigid disc that slides and spins is what steps of its friction tend to") {
  TangentialContact contact{RigidTangential{}, measured};
  contact.torsion.limit = Torsion::Limit::disc;
  for (const double degrees : {4.0, 60.0})
    for (const double spin : {300.0, 3000.0}) {
      const ObliqueImpact impact = at_angle(degrees, {50, 80, spin});
      const auto out = collide(Linear(1.72e7, 0), contact, impact);
      const auto coarse = disc_by_steps(impact, 1.72e7, 4000), fine = disc_by_steps(impact, 1.72e7, 8000);
      const Vec3 slip = out.velocity_i + radius * cross(out.spin_i, Vec3{0, 0, 1});
      CAPTURE(degrees, spin);
      CHECK(slip.x == Approx(fine.slip.x + (fine.slip.x - coarse.slip.x) / 3).margin(1e-6));
      CHECK(slip.y == Approx(fine.slip.y + (fine.slip.y - coarse.slip.y) / 3).margin(1e-6));
      CHECK(out.spin_i.z == Approx(fine.spin + (fine.spin - coarse.spin) / 3).epsilon(1e-7));
      CHECK(out.lost.torsion > 0);
    }
}

TEST_CASE("a rigid disc slips, ever less, as long as it spins, and sticks from then on") {
  TangentialContact contact{RigidTangential{}, measured};
  contact.torsion.limit = Torsion::Limit::disc;
  constexpr int steps = 8000;
  for (const double degrees : {0.5, 4.0})
    for (const double spin : {3.0, 30.0, 300.0}) {
      const ObliqueImpact impact = at_angle(degrees, {0, 0, spin});
      const auto out = collide(Linear(1.72e7, 0), contact, impact);
      const StepwiseDisc stepped = disc_by_steps(impact, 1.72e7, steps);
      const bool stops = spin < 300;
      CAPTURE(degrees, spin);
      CHECK(out.switches == (stops ? 1 : 0));
      CHECK((out.stick_time > 0) == stops);
      CHECK(out.slip_time == Approx(stepped.spins).margin(1.5 * out.normal.tcol / steps));
    }
}

TEST_CASE("springs that share the disc's limit slide as the rigid disc does, the nearer the stiffer they are") {
  const ObliqueImpact impact = at_angle(60, {0, 0, 3000});
  TangentialContact rigid{RigidTangential{}, measured};
  rigid.torsion.limit = Torsion::Limit::disc;
  const auto limit = collide(Linear(1.72e7, 0), rigid, impact);
  const auto off = [&](double k) {
    TangentialContact contact{LinearTangential(k), measured};
    contact.torsion = {Torsion::Limit::disc, {k * 1e-9, 0}};
    const auto out = collide(Linear(1.72e7, 0), contact, impact);
    CHECK(std::abs(energy(impact) - energy(after(impact, out)) - out.lost.sum()) < 1e-6 * energy(impact));
    return std::abs(out.spin_i.z - limit.spin_i.z);
  };
  const double soft = off(1.48e8), stiff = off(1.48e10);
  CHECK(soft < 30);
  CHECK(stiff < 0.1 * soft);
}

TEST_CASE("a spin too small to matter leaves a shared limit to the sliding") {
  for (const double degrees : {5.0, 20.0, 40.0}) {
    TangentialContact contact{MindlinTangential(4e9, 5), measured};
    const auto alone = collide(Tsuji(4e9, 150), contact, at_angle(degrees));
    contact.torsion = {Torsion::Limit::disc, {0.01, 0}};
    const auto shared = collide(Tsuji(4e9, 150), contact, at_angle(degrees, {0, 0, 1e-9}));
    CAPTURE(degrees);
    CHECK(*shared.et == Approx(*alone.et).epsilon(1e-6));
    CHECK(*shared.beta == Approx(*alone.beta).margin(1e-6));
    CHECK(shared.lost.sum() == Approx(alone.lost.sum()).margin(1e-6 * energy(at_angle(degrees))));
  }
}

TEST_CASE("two bodies whose springs share the disc's limit turn each other as action and reaction, rolling too") {
  const ObliqueImpact impact{.normal = {0, 0, 1},
                             .i = {1.4, 6.4, {-0.3, 0.2, 0.4}, {0.05, -0.1, -0.02}},
                             .j = {0.7, 4.0, {0.1, 0.1, 0}, {-0.06, 0.03, 0.04}}};
  TangentialContact contact{LinearTangential(0.3, 0.02), Friction(0.5, 0.5, 0)};
  contact.torsion = {Torsion::Limit::disc, {0.3, 0.01}};
  contact.rolling = {0.05, {0.1, 0.02}};
  const auto out = collide(Linear(1, 0.1), contact, impact);
  REQUIRE(out.separated());
  const ObliqueImpact later = after(impact, out);
  CHECK(std::abs(energy(impact) - energy(later) - out.lost.sum()) < 1e-6 * energy(impact));
  CHECK(out.lost.rolling > 0);
  // About the contact point, a radius from either centre.
  const auto angular = [](const ObliqueImpact& o) {
    return cross({0, 0, -o.i.radius}, o.i.mass * o.i.velocity) + inertia(o.i) * o.i.spin +
           cross({0, 0, o.j.radius}, o.j.mass * o.j.velocity) + inertia(o.j) * o.j.spin;
  };
  CHECK(norm(angular(later) - angular(impact)) < 1e-9 * norm(angular(impact)));
  CHECK(norm(impact.i.mass * (later.i.velocity - impact.i.velocity) +
             impact.j.mass * (later.j.velocity - impact.j.velocity)) < 1e-12);
  const auto other = collide(Linear(1, 0.1), contact, {-impact.normal, impact.j, impact.i});
  CHECK(norm(other.velocity_j - out.velocity_i) < 1e-9);
  CHECK(norm(other.spin_j - out.spin_i) < 1e-9);
  CHECK(norm(other.spin_i - out.spin_j) < 1e-9);
}
