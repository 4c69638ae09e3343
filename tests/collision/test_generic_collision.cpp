// The generic collision, asked for by name, against exact ones. Bounds are those of collision.hpp.

#include "../../core/src/collision/driven/stretch.hpp"
#include "../../docs/examples/standard_solid.hpp"

#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/reduction.hpp>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

using namespace ricochet;

namespace {

constexpr Impact impact{.velocity = 0.5, .mass_eff = 7e-6};
constexpr double bound = 1e-9;

void check_agrees(const Collision& got, const Collision& exact) {
  REQUIRE(got.status == exact.status);
  CHECK(std::abs(got.max_overlap - exact.max_overlap) <= bound * exact.max_overlap);
  CHECK(std::abs(got.max_force - exact.max_force) <= bound * exact.max_force);
  CHECK(std::abs(got.time_max_overlap - exact.time_max_overlap) <= bound * exact.time_max_overlap);
  if (!exact.separated()) return;
  CHECK(std::abs(got.tcol - exact.tcol) <= bound * exact.tcol);
  CHECK(std::abs(got.en - exact.en) <= bound * exact.en);
  CHECK(std::abs(got.overlap_end - exact.overlap_end) <= bound * exact.max_overlap);
  CHECK(std::abs(got.time_max_force - exact.time_max_force) <= 1e-5 * exact.tcol);
}

template <class Law>
void check_against_own(const Law& law, ContactEnd end) {
  check_agrees(collide<Law>(law, impact, {.end = end}), collide(law, impact, {.end = end}));
}

/// c of a Hertzian law kζ^{3/2} + cζ^b ζ' with the damping group γ (damped_power.hpp).
double hertzian_damping(double gamma, double k, double b) {
  const double unit = std::pow(impact.mass_eff / (k * std::sqrt(impact.velocity)), 0.4);
  return gamma * impact.mass_eff / (std::pow(impact.velocity, b) * std::pow(unit, b + 1));
}

double bisect(const auto& f, double low, double high) {
  for (int i = 0; i < 200; ++i) (f(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/// x(t) of the standard linear solid: X(s) = v₀ (s + 1/τ)/p(s), p = s³ + s²/τ + (k+κ)s/m + k/(mτ), so
/// x = Σ v₀ (λ+1/τ)/p'(λ) e^{λt} over the three zeros of p, one of them real and in (−1/τ, 0).
class SolidMotion {
 public:
  SolidMotion(double k, double kappa, double tau) {
    const double a = 1 / tau, b = (k + kappa) / impact.mass_eff, c = k / (impact.mass_eff * tau);
    const double real = bisect([&](double s) { return -(((s + a) * s + b) * s + c); }, -a, 0);
    const std::complex<double> half = -0.5 * (a + real), root = std::sqrt(half * half + c / real);
    zero_ = {real, half + root, half - root};
    for (std::size_t i = 0; i < 3; ++i)
      weight_[i] = impact.velocity * (zero_[i] + a) / ((3.0 * zero_[i] + 2 * a) * zero_[i] + b);
  }
  /// The n-th derivative of x.
  double operator()(double t, int n) const {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += weight_[i] * std::pow(zero_[i], n) * std::exp(zero_[i] * t);
    return sum.real();
  }

 private:
  std::array<std::complex<double>, 3> zero_, weight_;
};

/// First time after `from` at which f falls to 0, or that of `stop` turning positive, whichever comes first.
struct First {
  double time;
  bool stopped;
};
First first_fall(const auto& f, const auto& stop, double from, double step) {
  for (double t = from;; t += step) {
    if (f(t + step) <= 0) return {bisect(f, t, t + step), false};
    if (stop(t + step) > 0) return {t, true};
  }
}

Collision exact_solid(double k, double kappa, double tau, ContactEnd end) {
  const SolidMotion motion(k, kappa, tau);
  const double step = 1e-3 * std::sqrt(impact.mass_eff / (k + kappa));
  const auto never = [](double) { return 0.0; };
  const auto slope = [&](double t) { return -motion(t, 3); };
  Collision out;
  out.time_max_overlap = first_fall([&](double t) { return motion(t, 1); }, never, 0, step).time;
  out.max_overlap = motion(out.time_max_overlap, 0);
  out.time_max_force = first_fall(slope, never, 0, step).time;
  out.max_force = -impact.mass_eff * motion(out.time_max_force, 2);
  const bool by_force = end == ContactEnd::force;
  const auto value = [&](double t) { return by_force ? -motion(t, 2) : motion(t, 0); };
  // Inwards again, or creeping along the real zero for ever.
  const auto stays = [&](double t) { return motion(t, 1) + 1e-13 * impact.velocity; };
  const First over = first_fall(value, stays, out.time_max_overlap + step, step);
  if (over.stopped) return out;  // no_separation
  out.status = by_force ? CollisionStatus::ended_by_force : CollisionStatus::ended_by_overlap;
  out.tcol = over.time;
  out.en = -motion(out.tcol, 1) / impact.velocity;
  out.overlap_end = by_force ? motion(out.tcol, 0) : 0;
  return out;
}

/// The arms as ordinary differential equations, by Runge, Kutta and Fehlberg at a step that leaves rounding alone.
class ArmsMotion {
 public:
  explicit ArmsMotion(const FractionalArms& law) : law_(law), state_(law.arms() + 2, 0.0) {
    state_[1] = impact.velocity;
    double fastest = 0;
    for (std::size_t j = 0; j < law.arms(); ++j) fastest = std::max(fastest, law.relaxation_rate(j));
    step_ = 0.5 / fastest;
  }
  Collision to_end_by_force() {
    Collision out{.status = CollisionStatus::ended_by_force, .max_force = force(state_)};
    double time = 0;
    const auto rate = [this](const State& s) { return s[1]; };
    const auto all = [this](const State& s) { return force(s); };
    for (;; time += step_) {
      const State before = state_;
      stepper_.do_step(std::cref(*this), state_, 0.0, step_);
      if (before[1] > 0 && state_[1] <= 0) {
        const auto [when, top] = fall(before, rate);
        out.time_max_overlap = time + when, out.max_overlap = top[0];
      }
      const auto slope = [this](const State& s) { return force_slope(s); };
      if (slope(before) > 0 && slope(state_) <= 0 && force(before) > 0) {
        const auto [when, peak] = fall(before, slope);
        out.time_max_force = time + when, out.max_force = std::max(out.max_force, force(peak));
      }
      if (force(state_) <= 0) {
        const auto [when, end] = fall(before, all);
        out.tcol = time + when, out.en = -end[1] / impact.velocity, out.overlap_end = end[0];
        return out;
      }
    }
  }
  void operator()(const std::vector<double>& s, std::vector<double>& change, double) const {
    change[0] = s[1];
    change[1] = -force(s) / impact.mass_eff;
    for (std::size_t j = 0; j < law_.arms(); ++j) change[2 + j] = s[1] - law_.relaxation_rate(j) * s[2 + j];
  }

 private:
  using State = std::vector<double>;

  double force(const State& s) const {
    double sum = law_.spring() * s[0] + law_.dashpot() * s[1];
    for (std::size_t j = 0; j < law_.arms(); ++j) sum += law_.stiffness(j) * s[2 + j];
    return sum;
  }
  double force_slope(const State& s) const {
    State change(s.size());
    (*this)(s, change, 0);
    return force(change);
  }
  /// Where in the step from `before` a value falls to 0, and the state there.
  template <class Value>
  std::pair<double, State> fall(const State& before, const Value& value) {
    const auto at = [&](double length) {
      State state = before;
      if (length > 0) stepper_.do_step(std::cref(*this), state, 0.0, length);
      return state;
    };
    const double length = bisect([&](double l) { return value(at(l)); }, 0, step_);
    return {length, at(length)};
  }

  const FractionalArms& law_;
  State state_;
  double step_ = 0;
  boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper_;
};

FractionalArms arms_of(double alpha, double tcol, double shortest) {
  return {tuned_fractional(alpha, tcol, impact.mass_eff), memory_kernel(alpha, shortest, tcol, 1e-10), shortest};
}

/// A law that is nothing but a formula without memory.
template <double (*Force)(Approach)>
struct Formula {
  using Memory = NoMemory;
  static constexpr std::string_view name = "formula";
  double force(Approach a, const Memory&) const noexcept { return Force(a); }
  void advance(Memory&, Approach, Approach, double) const noexcept {}
  double stored_energy(Approach, const Memory&) const noexcept { return 0; }
  double dissipated_power(Approach, const Memory&) const noexcept { return 0; }
};
double dashpot(Approach a) { return 0.1 * a.rate; }
double nothing(Approach) { return 0; }
double gives_way(Approach a) { return 0.1 * a.rate * std::max(0.0, 1 - a.overlap / 1e-5); }
double no_number(Approach a) { return a.overlap > 1e-6 ? std::numeric_limits<double>::quiet_NaN() : 7000 * a.overlap; }
constexpr double clamped_damping = 0.05;
double clamped(Approach a) { return std::max(0.0, 5000 * a.overlap + clamped_damping * a.rate); }
double bent(Approach a) { return 7000 * a.overlap + std::max(0.0, 7000 * (a.overlap - 5e-6)); }

// What `collide` takes, at compile time: a law of any kind and AnyLaw itself, but nothing that merely converts to it.
template <class T>
concept Collidable = requires(const T& law) {
  collide(law, impact);
};
struct TurnsIntoAnyLaw {
  operator AnyLaw() const { return Linear(1, 0); }  // NOLINT: implicit, as the constructors of a variant are
};
struct NotQuiteALaw : TurnsIntoAnyLaw {
  static constexpr std::string_view name = "not quite";
};
static_assert(Collidable<AnyLaw> && Collidable<Linear> && Collidable<Fractional> && Collidable<StandardSolid>);
static_assert(std::convertible_to<TurnsIntoAnyLaw, AnyLaw> && !Collidable<TurnsIntoAnyLaw>);
static_assert(!Collidable<NotQuiteALaw>);

}  // namespace

TEST_CASE("the generic collision gives the exact ones of the memoryless laws") {
  const auto end = GENERATE(ContactEnd::force, ContactEnd::overlap);
  for (const double ratio : {0.0, 1e-4, 0.01, 0.1, 0.5, 0.9, 1.0, 1.5, 10.0, 100.0}) {
    CAPTURE(end, ratio);
    check_against_own(Linear(5000, 2 * ratio * std::sqrt(5000 * impact.mass_eff)), end);
  }
  constexpr double k = 1.39e6;
  for (const double gamma : {0.0, 1e-4, 0.1, 0.5, 1.0, 3.0, 30.0}) {
    CAPTURE(end, gamma);
    check_against_own(Tsuji(k, hertzian_damping(gamma, k, 0.25)), end);
    if (gamma < 30 || end == ContactEnd::force)  // else e_n = 2e-7
      check_against_own(KuwabaraKono(k, hertzian_damping(gamma, k, 0.5)), end);
  }
}

TEST_CASE("the generic collision sees the bend of a hysteretic law at the turning point") {
  const auto end = GENERATE(ContactEnd::force, ContactEnd::overlap);
  for (const double stiffening : {1.0, 1.5, 4.0, 100.0, 1e4}) {
    CAPTURE(end, stiffening);
    check_against_own(Hysteretic(4000, 4000 * stiffening), end);
  }
}

TEST_CASE("the generic collision carries a memory: Maxwell arms against their differential equations") {
  constexpr double tcol = 1e-4;
  for (const double alpha : {0.03, 0.2, 0.5, 0.8}) {
    const FractionalArms law = arms_of(alpha, tcol, tcol / 30);
    CAPTURE(alpha);
    check_agrees(collide<FractionalArms>(law, impact), ArmsMotion(law).to_end_by_force());
  }
}

TEST_CASE("a law of a user's own, with memory, collides as its exact solution") {
  constexpr double k = 7000;
  const auto end = GENERATE(ContactEnd::force, ContactEnd::overlap);
  for (const double kappa : {0.1 * k, k, 5 * k})
    for (const double tau : {1e-6, 1e-5, 3e-5, 1e-4, 1e-3}) {
      CAPTURE(end, kappa, tau);
      check_agrees(collide(StandardSolid(k, kappa, tau), impact, {.end = end}), exact_solid(k, kappa, tau, end));
    }
}

TEST_CASE("a law that stays at 0 once it has let go ends where it lets go") {
  check_agrees(collide(Formula<clamped>{}, impact), collide(Linear(5000, clamped_damping), impact));
}

TEST_CASE("the units of a generic collision do not matter") {
  const Collision one = collide(StandardSolid(7000, 7000, 2e-5), impact);
  // Lengths in 1e-3, times in 1e6, masses in 1e9 of what they were.
  const Collision other =
      collide(StandardSolid(7000 * 1e-3, 7000 * 1e-3, 20), {impact.velocity * 1e-9, impact.mass_eff * 1e9});
  CHECK(other.en == Approx(one.en).epsilon(1e-11));
  CHECK(other.tcol == Approx(1e6 * one.tcol).epsilon(1e-11));
  CHECK(other.max_overlap == Approx(1e-3 * one.max_overlap).epsilon(1e-11));
  CHECK(other.max_force == Approx(1e-6 * one.max_force).epsilon(1e-11));
}

TEST_CASE("every generic collision ends, and says how") {
  const auto status = [](const auto& law, ContactEnd end = ContactEnd::force, std::size_t budget = 1'000'000) {
    const Collision out =
        collide<std::remove_cvref_t<decltype(law)>>(law, impact, {.end = end, .max_evaluations = budget});
    CHECK(out.evaluations <= budget + 300'000);
    CHECK(std::isfinite(out.max_overlap + out.max_force + out.tcol + out.en));
    return out.status;
  };
  CHECK(status(Formula<dashpot>{}) == CollisionStatus::permanent_contact);  // stops, and stays
  CHECK(status(Formula<nothing>{}) == CollisionStatus::no_separation);      // flies through
  CHECK(status(Formula<gives_way>{}) == CollisionStatus::no_separation);    // the same, a little slower
  CHECK(status(Formula<no_number>{}) == CollisionStatus::out_of_range);
  CHECK(status(StandardSolid(7000, 7000, 1e-5), ContactEnd::force, 100) == CollisionStatus::budget_spent);
  CHECK(status(StandardSolid(7000, 7000, 1e-5), ContactEnd::force, 5000) == CollisionStatus::budget_spent);
  CHECK(status(Linear(5000, 1000)) == CollisionStatus::budget_spent);  // e_n = 4e-9, below what is promised
  // A law that bends on the way is beyond the promise, not beyond the budget: either answer is true.
  const Collision bend = collide(Formula<bent>{}, impact);
  if (bend.separated())
    CHECK(std::abs(bend.en - 1) < bound);
  else
    CHECK(bend.status == CollisionStatus::budget_spent);
}

TEST_CASE("the generic collision has no closed form and takes no bad impact") {
  const StandardSolid law(7000, 7000, 1e-5);
  CHECK_THROWS_WITH(collide(law, impact, {.method = CollideMethod::closed_form}),
                    "method = closed_form: the standard-solid law has none");
  CHECK_THROWS_WITH(collide(law, {0, 1}), "velocity = 0: must be finite and > 0");
  CHECK_THROWS_WITH(collide(law, {1, -1}), "mass_eff = -1: must be finite and > 0");
}

// The scheme below the extrapolation: symmetric, so errors are c₂/N² + c₄/N⁴ + …, which is order 2 as it stands and
// order 4 after one step of Romberg's; the graded mesh keeps Tsuji's ζ^{1/4} at the touch at N^{−4(1+1/4)}, below both.
TEST_CASE("the generic collision's stretches have an error of orders 2 and 4") {
  const auto orders = [](const auto& law, double exact_turn) {
    collision::Driven driven(law);
    const auto turn = [&](int steps) {
      collision::ScaledContact contact(driven, impact, 1e-5);
      collision::Stretch loading(contact, contact.touch(), collision::Graded::at_start, steps);
      contact.mark();
      const double guess = exact_turn / 1e-5;
      return loading.run_to([](const Instant& at) { return at.rate; }, guess, 0.01 * guess, 10'000'000)->time * 1e-5;
    };
    const double a = turn(64), b = turn(128), c = turn(256);
    const double raw = std::log2((a - exact_turn) / (b - exact_turn));
    const double first = ((4 * b - a) / 3 - exact_turn) / ((4 * c - b) / 3 - exact_turn);
    return std::pair(raw, std::log2(first));
  };
  const auto check = [](std::pair<double, double> order) {
    CHECK(order.first == Approx(2).margin(0.05));
    CHECK(order.second == Approx(4).margin(0.2));
  };
  const Linear linear(5000, 0.1);
  check(orders(linear, collide(linear, impact).time_max_overlap));
  const Tsuji tsuji(1.39e6, hertzian_damping(0.5, 1.39e6, 0.25));
  check(orders(tsuji, collide(tsuji, impact).time_max_overlap));
  const StandardSolid solid(7000, 7000, 2e-5);
  check(orders(solid, exact_solid(7000, 7000, 2e-5, ContactEnd::force).time_max_overlap));
}
