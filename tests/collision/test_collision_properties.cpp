#include <catch2/catch.hpp>
#include <rapidcheck.h>
#include <ricochet/ricochet.hpp>

#include <cmath>

using namespace ricochet;

namespace {

/// Uniform in the logarithm over [10^low, 10^high].
rc::Gen<double> decades(double low, double high) {
  constexpr int steps = 1'000'000;
  return rc::gen::map(rc::gen::inRange(0, steps + 1),
                      [=](int i) { return std::pow(10, low + (high - low) * i / steps); });
}

Impact any_impact() { return {*decades(-4, 2), *decades(-9, 1)}; }
ContactEnd any_end() { return *rc::gen::element(ContactEnd::force, ContactEnd::overlap); }
double any_alpha() { return *rc::gen::inRange(0, 96) / 100.0; }

/// A numerical collision is good to 1e-11, so two of them differ by twice that, and a little for what else is rounded.
constexpr double two_collisions = 3e-11;

void close(double a, double b) { RC_ASSERT(std::abs(a - b) <= two_collisions * std::max(std::abs(a), std::abs(b))); }

/// Coefficients whose dimensionless damping c v^b T^{b+1}/m, T = (m/(k v^{a−1}))^{1/(a+1)}, is of the order of `group`.
template <class Law>
Law any_law(const Impact& impact, double a, double b) {
  const auto [v, m] = impact;
  const double k = *decades(0, 10), unit = std::pow(m / (k * std::pow(v, a - 1)), 1 / (a + 1));
  return Law(k, *decades(-3, 1) * m / (std::pow(v, b) * std::pow(unit, b + 1)));
}

struct AnyCase {
  AnyLaw law;
  Impact impact;
};

AnyCase any_case() {
  const Impact impact = any_impact();
  switch (*rc::gen::inRange(0, 5)) {
    case 0: return {any_law<Linear>(impact, 1, 0), impact};
    case 1: return {any_law<KuwabaraKono>(impact, 1.5, 0.5), impact};
    case 2: return {any_law<Tsuji>(impact, 1.5, 0.25), impact};
    case 3: {
      const double k1 = *decades(0, 10);
      return {Hysteretic(k1, k1 * (1 + *decades(-3, 2))), impact};
    }
    default: return {Fractional(*decades(0, 10), *decades(-6, 6), any_alpha()), impact};
  }
}

/// The same law in other units of length, time and mass (each the number of old units in a new one, inverted).
struct Units {
  double length, time, mass;
  double stiffness() const { return mass / (time * time); }
  double damping() const { return mass / time; }

  AnyLaw operator()(const Linear& l) const { return Linear(l.k() * stiffness(), l.c() * damping()); }
  AnyLaw operator()(const KuwabaraKono& l) const {
    return KuwabaraKono(l.k() * stiffness() / std::sqrt(length), l.c() * damping() / std::sqrt(length));
  }
  AnyLaw operator()(const Tsuji& l) const {
    return Tsuji(l.k() * stiffness() / std::sqrt(length), l.c() * damping() / std::pow(length, 0.25));
  }
  AnyLaw operator()(const Hysteretic& l) const { return Hysteretic(l.k1() * stiffness(), l.k2() * stiffness()); }
  AnyLaw operator()(const Fractional& l) const { return Fractional(l.k() * stiffness(), l.c() * damping(), l.alpha()); }
  double pot(double alpha) const { return stiffness() * std::pow(time, alpha); }
  AnyLaw operator()(const FractionalKelvinVoigt& l) const {
    return FractionalKelvinVoigt(l.k() * stiffness(), l.c() * pot(l.alpha()), l.alpha());
  }
  AnyLaw operator()(const FractionalHertz& l) const {
    const double root = std::sqrt(length);
    return FractionalHertz(l.k() * stiffness() / root, l.c() * pot(l.alpha()) / root, l.alpha());
  }
  AnyLaw operator()(const FractionalZener& l) const {
    return FractionalZener(l.k() * stiffness(), l.k1() * stiffness(), l.tau() * time, l.alpha());
  }
  Impact operator()(const Impact& i) const { return {i.velocity * length / time, i.mass_eff * mass}; }
};

template <class Law>
void check_speed_does_not_matter(const Law& law, const Impact& impact, ContactEnd end) {
  const double faster = impact.velocity * *decades(-3, 3);
  const auto slow = collide(law, impact, {end, CollideMethod::numerical});
  const auto fast = collide(law, {faster, impact.mass_eff}, {end, CollideMethod::numerical});
  RC_ASSERT(slow.status == fast.status);
  close(slow.en, fast.en);
}

}  // namespace

TEST_CASE("a collision does not depend on the units it is written in") {
  CHECK(rc::check([] {
    const auto [law, impact] = any_case();
    const Units units{*decades(-6, 6), *decades(-6, 6), *decades(-6, 6)};
    const CollideOptions options{ContactEnd::force, CollideMethod::numerical};
    const auto here = collide(law, impact, options);
    const auto there = collide(std::visit(units, law), units(impact), options);
    RC_ASSERT(here.status == there.status);
    close(here.en, there.en);
    close(here.tcol * units.time, there.tcol);
    close(here.max_overlap * units.length, there.max_overlap);
    close(here.max_force * units.mass * units.length / (units.time * units.time), there.max_force);
  }));
}

TEST_CASE("the restitution of the linear, Tsuji and fractional laws does not depend on the speed") {
  CHECK(rc::check([] {
    const Impact impact = any_impact();
    check_speed_does_not_matter(any_law<Linear>(impact, 1, 0), impact, ContactEnd::force);
    check_speed_does_not_matter(any_law<Tsuji>(impact, 1.5, 0.25), impact, ContactEnd::force);
    check_speed_does_not_matter(Fractional(*decades(0, 10), *decades(-6, 6), any_alpha()), impact, ContactEnd::force);
  }));
}

TEST_CASE("no collision gains energy, and none stores more than it was given") {
  CHECK(rc::check([] {
    const auto [law, impact] = any_case();
    const ContactEnd end = any_end();
    const auto out = collide(law, impact, {end, CollideMethod::numerical});
    RC_ASSERT(out.status != CollisionStatus::budget_spent);
    RC_ASSERT(out.en >= 0);
    RC_ASSERT(out.en <= 1 + 1e-12);
    if (!out.separated()) return;
    RC_ASSERT(out.time_max_overlap < out.tcol);
    RC_ASSERT(out.max_overlap <= impact.velocity * out.time_max_overlap * (1 + 1e-12));
    RC_ASSERT(out.overlap_end < out.max_overlap);
  }));
}

TEST_CASE("more damping gives less restitution") {
  CHECK(rc::check([] {
    const double c = *decades(-6, 1), more = c * (1 + *decades(-3, 1));
    RC_ASSERT(collide(Linear(1, c), {1, 1}).en >= collide(Linear(1, more), {1, 1}).en);
    RC_ASSERT(collide(KuwabaraKono(1, c), {1, 1}).en >= collide(KuwabaraKono(1, more), {1, 1}).en);
    RC_ASSERT(collide(Tsuji(1, c), {1, 1}).en >= collide(Tsuji(1, more), {1, 1}).en);
    RC_ASSERT(collide(Hysteretic(1, 1 + c), {1, 1}).en >= collide(Hysteretic(1, 1 + more), {1, 1}).en);
    const double alpha = any_alpha();
    RC_ASSERT(collide(Fractional(1, 1, alpha), {1, 1}).en > collide(Fractional(1, 1, alpha + 0.01), {1, 1}).en);
  }));
}
