// Collisions of the laws of real solids: the values of independent computations, each method against another, limits.

#include "oblique_cases.hpp"

#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/oblique.hpp>
#include <ricochet/collision/reach.hpp>
#include <ricochet/collision/reduction.hpp>
#include <ricochet/collision/solvers/solid_series.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>
#include <vector>

using namespace ricochet;

namespace {

constexpr Impact unit{.velocity = 1, .mass_eff = 1};
constexpr CollideOptions numerical{.method = CollideMethod::numerical};

void check_ends(const Collision& got, double tcol, double en, double bound) {
  CAPTURE(got.tcol, got.en, tcol, en);
  REQUIRE(got.separated());
  CHECK(std::abs(got.tcol - tcol) <= bound * tcol);
  CHECK(std::abs(got.en - en) <= bound * en);
}

void check_agree(const Collision& got, const Collision& other, double bound) {
  REQUIRE(got.status == other.status);
  check_ends(got, other.tcol, other.en, bound);
  CHECK(std::abs(got.max_overlap - other.max_overlap) <= bound * other.max_overlap);
  CHECK(std::abs(got.max_force - other.max_force) <= bound * other.max_force);
  CHECK(std::abs(got.overlap_end - other.overlap_end) <= bound * other.max_overlap);
  CHECK(std::abs(got.time_max_overlap - other.time_max_overlap) <= std::sqrt(bound) * other.tcol);
  CHECK(std::abs(got.time_max_force - other.time_max_force) <= std::sqrt(bound) * other.tcol);
}

using Real = boost::multiprecision::cpp_bin_float_100;

/// The fractional-hertz motion by its series: with α = p/q everything is a power series in u = t^{1/(2q)},
///   x = t Σ a_n u^n,  f = x^{3/2} = t^{3/2} Σ b_n u^n,
/// a by I²f + g I^{2−α}f, b from 2 x f' = 3 x' f; summed by Padé's approximants (Wynn's epsilon) in 100 digits.
class HertzianSeries {
 public:
  HertzianSeries(double spring, double pot, int p, int q, int terms) : per_time_(2 * q) {
    const int to_spring = 5 * q, to_pot = 5 * q - 2 * p;
    std::vector<Real>& a = a_;
    std::vector<Real> b;
    for (int n = 0; n < terms; ++n) {
      Real next = n == 0 ? 1 : 0;
      const auto take = [&](int back, double factor, const Real& order) {
        if (n < back || factor == 0) return;
        const Real power = Real(3) / 2 + Real(n - back) / per_time_;
        next -= factor * b[static_cast<std::size_t>(n - back)] * exp(lgamma(power + 1) - lgamma(power + 1 + order));
      };
      take(to_spring, spring, 2);
      take(to_pot, pot, 2 - Real(p) / q);
      a.push_back(next);
      // b of a^{3/2}: n a₀ b_n = Σ_{k=1}^{n} (3k/2 − (n − k)) a_k b_{n−k}
      Real sum = n == 0 ? 1 : 0;
      for (int k = 1; k <= n; ++k)
        sum += (Real(3 * k) / 2 - (n - k)) * a[static_cast<std::size_t>(k)] * b[static_cast<std::size_t>(n - k)] / n;
      b.push_back(sum);
    }
  }
  double rate(double t) const { return value(t, 1); }
  double force(double t) const { return -value(t, 2); }

 private:
  /// The derivative of x, by the epsilon algorithm over its partial sums.
  double value(double t, int derivative) const {
    const Real u = pow(Real(t), Real(1) / per_time_);
    std::vector<Real> column, before;
    Real sum = 0;
    for (std::size_t n = 0; n < a_.size(); ++n) {
      if (a_[n] == 0) continue;  // the series is sparse in u
      Real factor = a_[n];
      for (int d = 0; d < derivative; ++d) factor *= 1 + Real(n) / per_time_ - d;
      sum += factor * pow(u, Real(n)) * pow(Real(t), Real(1 - derivative));
      if (factor != 0) column.push_back(sum);
    }
    before.assign(column.size() + 1, 0);
    Real best = column.back();
    for (int k = 1; column.size() > 1; ++k) {
      std::vector<Real> next;
      for (std::size_t i = 0; i + 1 < column.size(); ++i) {
        const Real difference = column[i + 1] - column[i];
        if (difference == 0) return static_cast<double>(best);
        next.push_back(before[i + 1] + 1 / difference);
      }
      before = std::move(column);
      column = std::move(next);
      if (k % 2 == 0) best = column.back();
    }
    return static_cast<double>(best);
  }

  int per_time_;
  std::vector<Real> a_;
};

double bisect(const auto& f, double low, double high) {
  for (int i = 0; i < 48; ++i) (f(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

}  // namespace

TEST_CASE("solid collisions have the values of other computations") {
  // By series with Padé or inverse Laplace transforms of 40 digits.
  const auto kelvin_voigt = [](double g, double alpha, ContactEnd end) {
    return collide(FractionalKelvinVoigt(1, g, alpha), unit, {end});
  };
  check_ends(kelvin_voigt(0.5, 0.5, ContactEnd::force), 2.489833431848, 0.7016741548288, 1e-12);
  check_ends(kelvin_voigt(1, 0.5, ContactEnd::force), 2.068085982719, 0.5660168764213, 1e-12);
  check_ends(kelvin_voigt(0.5, 0.25, ContactEnd::force), 2.504411640990, 0.8443239715506, 1e-12);
  check_ends(kelvin_voigt(0.5, 0.5, ContactEnd::overlap), 2.774035704256, 0.6636432700993, 1e-12);
  check_ends(kelvin_voigt(1, 0.5, ContactEnd::overlap), 2.519347682702, 0.4698858598635, 1e-12);
  check_ends(kelvin_voigt(0.5, 0.25, ContactEnd::overlap), 2.638438965071, 0.8331564688078, 1e-12);
  const auto hertz = [](double k, double c, double alpha) { return collide(FractionalHertz(k, c, alpha), unit); };
  check_ends(hertz(1, 0.5, 0.5), 2.53903632686, 0.679172198859, 2e-12);
  check_ends(hertz(1, 1, 0.5), 2.164148712927, 0.5441635565531, 1e-12);
  check_ends(hertz(1, 0.36, 1), 2.9324650753, 0.5739153602, 1e-10);
  check_ends(hertz(0, 1, 0.25), 2.8422870976, 0.57164767998, 2e-11);
  check_ends(hertz(0, 1, 0.5), 2.732897244996, 0.285653122776, 1e-12);
  const auto zener = [](double k1, double tau) { return collide(FractionalZener(1, k1, tau, 0.5), unit); };
  check_ends(zener(1, 1), 2.47982650114, 0.84945221114, 1e-11);
  check_ends(zener(4, 0.2), 1.91550721613, 0.67295252788, 1e-11);
}

TEST_CASE("fractional-hertz is its own series, summed by Padé") {
  for (const auto& [spring, pot] : {std::pair{1.0, 0.5}, {1.0, 1.0}, {0.0, 1.0}}) {
    CAPTURE(spring, pot);
    const Collision got = collide(FractionalHertz(spring, pot, 0.5), unit);
    const HertzianSeries series(spring, pot, 1, 2, 400);
    CHECK(std::abs(series.force(got.tcol)) <= 1e-10 * got.tcol);  // whose slope is about 1 there
    CHECK(std::abs(series.rate(got.tcol) + got.en) <= 1e-10 * got.en);
  }
}

TEST_CASE("Kelvin-Voigt by its transform is what its Volterra equation says") {
  for (const double alpha : {1e-4, 0.1, 0.5, 0.9, 0.999})
    for (const double g : {1e-6, 0.3, 3.0, 1e4}) {
      const FractionalKelvinVoigt law(2e4, g * std::pow(2e4, 1 - alpha / 2) * std::pow(3e-5, alpha / 2), alpha);
      const Impact impact{0.4, 3e-5};
      CAPTURE(alpha, g);
      const Collision closed = collide(law, impact);
      check_agree(collide(law, impact, numerical), closed, 1e-11 + 1e-14 / closed.en);
    }
}

TEST_CASE("the linear laws by their transforms are their power series") {
  for (const double alpha : {0.1, 0.33, 0.5, 0.9, 1.0})
    for (const double scale : {0.3, 1.0, 3.0}) {
      CAPTURE(alpha, scale);
      const FractionalKelvinVoigt voigt(1, scale, alpha);
      const SeriesRebound v = series_rebound(voigt);
      check_ends(collide(voigt, unit), v.tcol, v.en, 2e-12);
      const FractionalZener zener(1, 2 * scale, 0.5, alpha);
      const SeriesRebound z = series_rebound(zener);
      check_ends(collide(zener, unit), z.tcol, z.en, 2e-12);
    }
  CHECK_THROWS_WITH(series_rebound(FractionalKelvinVoigt(1, 1, 0.123)), Catch::Contains("alpha = 0.123"));
  CHECK_THROWS_WITH(series_rebound(FractionalKelvinVoigt(1e-4, 1e-6, 0.5)), Catch::Contains("tcol = 10"));
}

TEST_CASE("Zener by its transform is what its Maxwell arms say") {
  for (const double alpha : {0.1, 0.5, 0.9, 1.0})
    for (const auto& [k1, tau] : {std::pair{0.5, 1.0}, {100.0, 1e-3}, {20.0, 10.0}}) {
      CAPTURE(alpha, k1, tau);
      const FractionalZener law(1, k1, tau, alpha);
      check_agree(collide(law, unit, numerical), collide(law, unit), 1e-7);
    }
}

TEST_CASE("Zener at α = 1 is the standard solid, three exponentials") {
  // X(s) = (s + a)/(s³ + as² + (1 + k₁)s + a), a = 1/τ: one real zero in (−a, 0) and two others.
  for (const auto& [k1, tau] : {std::pair{4.0, 0.2}, {1.0, 1.0}, {30.0, 0.5}}) {
    CAPTURE(k1, tau);
    const double a = 1 / tau, b = 1 + k1;
    const double real = bisect([&](double s) { return -(((s + a) * s + b) * s + a); }, -a, 0);
    const double sum = a + real, product = -a / real;  // s² + sum·s + product
    const std::complex<double> root = std::sqrt(std::complex<double>(sum * sum / 4 - product));
    const std::array<std::complex<double>, 3> zeros{real, -sum / 2 + root, -sum / 2 - root};
    const auto motion = [&](double t, int derivative) {
      std::complex<double> x = 0;
      for (const auto& s : zeros)
        x += (s + a) / ((3.0 * s + 2 * a) * s + b) * std::pow(s, derivative) * std::exp(s * t);
      return x.real();
    };
    const Collision got = collide(FractionalZener(1, k1, tau, 1), unit);
    const double tcol = bisect([&](double t) { return -motion(t, 2); }, 0.8 * got.tcol, 1.2 * got.tcol);
    check_ends(got, tcol, -motion(tcol, 1), 1e-12);
    CHECK(got.overlap_end == Approx(motion(tcol, 0)).epsilon(1e-11));
  }
}

TEST_CASE("the laws of real solids have the limits that they say") {
  const Impact impact{0.3, 2e-5};
  const auto spring = [&](double k) { return collide(Linear(k, 0), impact); };
  check_agree(collide(FractionalKelvinVoigt(5000, 0.2, 1), impact), collide(Linear(5000, 0.2), impact), 1e-15);
  check_agree(collide(FractionalKelvinVoigt(5000, 700, 0), impact), spring(5700), 1e-15);
  check_agree(collide(FractionalKelvinVoigt(5000, 0, 0.3), impact), spring(5000), 1e-15);
  check_agree(collide(FractionalZener(5000, 0, 1, 0.3), impact), spring(5000), 1e-15);
  check_agree(collide(FractionalZener(5000, 800, 1, 0), impact), spring(5400), 1e-15);
  check_agree(collide(FractionalZener(5000, 800, 1e-30, 0.7), impact), spring(5000), 1e-11);
  check_agree(collide(FractionalZener(5000, 800, 1e20, 0.7), impact), spring(5800), 1e-11);
  check_agree(collide(FractionalHertz(1e6, 20, 1), impact), collide(KuwabaraKono(1e6, 30), impact), 1e-15);
  check_agree(collide(FractionalHertz(1e6, 5e5, 0), impact), collide(KuwabaraKono(1.5e6, 0), impact), 1e-15);
  check_agree(collide(FractionalHertz(1e6, 0, 0.4), impact), collide(KuwabaraKono(1e6, 0), impact), 1e-15);
  // Just beside the limits the same, but for what the distance does.
  CHECK(collide(FractionalKelvinVoigt(5000, 0.2, 1 - 1e-9), impact).en ==
        Approx(collide(Linear(5000, 0.2), impact).en).epsilon(1e-7));
  CHECK(collide(FractionalHertz(1e6, 20, 1 - 1e-9), impact).en ==
        Approx(collide(KuwabaraKono(1e6, 30), impact).en).epsilon(1e-7));
  // A springpot that outweighs its spring is the fractional law; of Hertz's e_n no longer depends on the velocity.
  for (const double alpha : {0.2, 0.7})
    CHECK(collide(FractionalKelvinVoigt(1e-12, 1, alpha), unit).en ==
          Approx(fractional_contact(alpha).en).epsilon(1e-10));
  CHECK(collide(FractionalHertz(0, 30, 0.3), {0.1, 2e-5}).en ==
        Approx(collide(FractionalHertz(0, 7, 0.3), {9, 1}).en).epsilon(1e-11));
}

TEST_CASE("a Hertzian dashpot alone comes to rest") {
  const Impact impact{0.3, 2e-5};
  const Collision out = collide(FractionalHertz(0, 5, 1), impact);
  CHECK(out.status == CollisionStatus::permanent_contact);
  // m v = c ζ^{3/2}, up to 1 % of the velocity
  CHECK(out.max_overlap == Approx(std::pow(0.99 * 2e-5 * 0.3 / 5, 2.0 / 3)).epsilon(1e-13));
  const double top = std::pow(0.25 * 2e-5 * 0.3 / 5, 2.0 / 3);
  CHECK(out.max_force == Approx(1.5 * 5 * std::sqrt(top) * 0.75 * 0.3).epsilon(1e-12));
  CHECK(out.tcol > out.time_max_force);
  CHECK(collide(FractionalHertz(0, 5, 1), impact, {.breakage_energy = 1e-9}).status == CollisionStatus::breakage);
}

TEST_CASE("an overlap that never returns, scales that no double carries and ends that are none") {
  CHECK(collide(FractionalKelvinVoigt(1, 100, 0.9), unit, {ContactEnd::overlap}).status ==
        CollisionStatus::no_separation);
  CHECK(collide(FractionalKelvinVoigt(1e-300, 1e200, 0.5), unit).status == CollisionStatus::out_of_range);
  CHECK_THROWS_WITH(collide(FractionalHertz(1, 1, 0.5), unit, {ContactEnd::overlap}),
                    Catch::StartsWith("end = overlap"));
  CHECK_THROWS_WITH(collide(FractionalHertz(1, 1, 0.5), unit, {.method = CollideMethod::closed_form}),
                    Catch::StartsWith("method = closed_form"));
  CHECK_THROWS_WITH(collide(FractionalZener(1, 1, 1, 0.5), {0, 1}), Catch::StartsWith("velocity = 0"));
}

TEST_CASE("the least rebounds keep their digits where dashpots are strong") {
  // Between the linear law and nearly it: d ln e/dα is of order ln g there.
  for (const double g : {20.0, 1e3, 1e6}) {
    CAPTURE(g);
    const double exact = collide(Linear(1, g), unit).en;
    CHECK(collide(FractionalKelvinVoigt(1, g, 1 - 0x1p-52), unit).en == Approx(exact).epsilon(1e-4));
    const Collision near = collide(FractionalKelvinVoigt(1, g, 1 - 1e-3), unit);
    CHECK(near.en > exact);
  }
}

TEST_CASE("the reductions of the laws of real solids keep e_n, at what is held of them") {
  const Impact impact{0.4, 3e-5};
  const auto check = [&]<class Law>(std::type_identity<Law>, double en, ContactEnd end, const Held& held) {
    const auto found = Reduction<Law>::unit(en, end, held);
    CAPTURE(Law::name, en, held.alpha);
    REQUIRE(found);
    CHECK(found->law.alpha() == held.alpha);
    check_ends(collide(found->law, unit, {end}), 1, en, 2e-11);
    const auto in_si = Reduction<Law>::in_si(found->law, 2e-4, impact);
    REQUIRE(in_si);
    check_ends(collide(*in_si, impact, {end}), 2e-4, en, 2e-11);
  };
  for (const double en : {1.0, 0.9, 0.6})
    for (const double alpha : {0.3, 0.5, 1.0}) {
      check(std::type_identity<FractionalKelvinVoigt>{}, en, ContactEnd::force, {.alpha = alpha});
      check(std::type_identity<FractionalHertz>{}, en, ContactEnd::force, {.alpha = alpha});
      if (en > 0.6 || alpha > 0.3)
        check(std::type_identity<FractionalZener>{}, en, ContactEnd::force, {.alpha = alpha, .stiffening = 40});
    }
  check(std::type_identity<FractionalKelvinVoigt>{}, 0.7, ContactEnd::overlap, {});
  CHECK_FALSE(
      Reduction<FractionalKelvinVoigt>::unit(0.3, ContactEnd::force));  // the fractional law of 0.5 keeps 0.3002
  CHECK_FALSE(Reduction<FractionalHertz>::unit(0.28, ContactEnd::force));
  CHECK_FALSE(Reduction<FractionalZener>::unit(0.35, ContactEnd::force));
  CHECK_THROWS_WITH(Reduction<FractionalHertz>::unit(0.5, ContactEnd::force, {.alpha = 2}),
                    "alpha = 2: must be in [0, 1]");
}

TEST_CASE("Zener's τ is the shorter of two, continuing Kelvin and Voigt's") {
  const Held held{.alpha = 0.5, .stiffening = 1e8};
  const auto zener = Reduction<FractionalZener>::unit(0.7, ContactEnd::force, held);
  const auto kelvin_voigt = Reduction<FractionalKelvinVoigt>::unit(0.7, ContactEnd::force);
  REQUIRE((zener && kelvin_voigt));
  CHECK(zener->law.k1() * std::sqrt(zener->law.tau()) == Approx(kelvin_voigt->law.c()).epsilon(1e-4));
  CHECK(zener->law.k() == Approx(kelvin_voigt->law.k()).epsilon(1e-4));
}

TEST_CASE("no less is kept than by a springpot alone, or at Zener's worst", "[reach]") {
  const auto bound = [](LawKind law, double alpha, ContactEnd end = ContactEnd::force) {
    return restitution_bound(law, end, {.alpha = alpha});
  };
  // The fractional law, and K D^α ζ^{3/2}, of the same α.
  CHECK(bound(kind_of<FractionalKelvinVoigt>, 0.5) == Approx(fractional_contact(0.5).en).epsilon(1e-14));
  CHECK(bound(kind_of<FractionalHertz>, 0.25) == Approx(0.57164767998).epsilon(1e-10));
  CHECK(bound(kind_of<FractionalHertz>, 0.5) == Approx(0.285653122776).epsilon(1e-11));
  CHECK(bound(kind_of<FractionalKelvinVoigt>, 0.5, ContactEnd::overlap) == 0);
  CHECK(bound(kind_of<FractionalKelvinVoigt>, 0.2, ContactEnd::overlap) ==
        Approx(fractional_contact(0.2, ContactEnd::overlap).en));
  for (const auto law : {kind_of<FractionalKelvinVoigt>, kind_of<FractionalHertz>, kind_of<FractionalZener>}) {
    CAPTURE(LawKind(law).name());
    const double least = least_restitution(law, ContactEnd::force, 0.01, 1e-4, {0.5, 7e-6});
    CHECK(least >= bound(law, 0.5));
    CHECK(least < bound(law, 0.5) + 1e-3);
    CHECK(reaches(law, ContactEnd::force, least, 1e-4, {0.5, 7e-6}));
    CHECK_FALSE(reaches(law, ContactEnd::force, bound(law, 0.5) - 1e-6, 1e-4, {0.5, 7e-6}));
    CHECK(bound(law, 0) == 1);  // springs alone
    CHECK(least_restitution(law, ContactEnd::force, 0.5, 1e-4, {0.5, 7e-6}, reach_tolerance, {.alpha = 0}) == 1);
  }
  CHECK(bound(kind_of<FractionalKelvinVoigt>, 1) == 0);
  CHECK(bound(kind_of<Linear>, 0.5) == 0);
}

TEST_CASE("a k that is given leaves one alpha", "[reduction]") {
  using Solid = Reduction<FractionalKelvinVoigt>;
  for (const auto end : {ContactEnd::force, ContactEnd::overlap})
    for (const double alpha : {0.35, 0.5, 0.8})
      for (const double g : {0.05, 0.5}) {
        CAPTURE(static_cast<int>(end), alpha, g);
        const Collision out = collide(FractionalKelvinVoigt(1, g, alpha), unit, {end});
        const auto found = Solid::degree(out.tcol * out.tcol, out.en, end);
        REQUIRE(found);
        CHECK(*found == Approx(alpha).epsilon(1e-9));
      }
  const double linear = unit_law(kind_of<Linear>, 0.5, ContactEnd::force)->law.index() == 0
                            ? std::get<Linear>(unit_law(kind_of<Linear>, 0.5, ContactEnd::force)->law).k()
                            : 0;
  CHECK(Solid::degree(linear, 0.5, ContactEnd::force) == 1.0);
  CHECK(Solid::degree(1e-8 * linear, 0.5, ContactEnd::force).value() == Approx(conversion_degree(0.5)).epsilon(1e-6));
  CHECK_FALSE(Solid::degree(1.001 * linear, 0.5, ContactEnd::force));
  CHECK_FALSE(Solid::degree(linear, 1, ContactEnd::force));
  CHECK_THROWS_WITH(Solid::degree(-1, 0.5, ContactEnd::force), "k = -1: must be finite and > 0");
}

namespace {

const ObliqueImpact skew = oblique::at_angle(25, {0, 30, 0});
const TangentialContact gripping{LinearTangential(1.48e7, 0.2), Friction(0.1, 0.1, 0)};

void check_oblique(const ObliqueCollision& got, const ObliqueCollision& exact, double bound) {
  REQUIRE(got.separated());
  CHECK(got.normal.en == Approx(exact.normal.en).epsilon(bound));
  CHECK(got.velocity_i.x == Approx(exact.velocity_i.x).epsilon(bound));
  CHECK(got.spin_i.y == Approx(exact.spin_i.y).epsilon(bound));
}

/// The law's own path against steps of its arms.
template <class Law>
void check_by_arms(const Law& law) {
  CAPTURE(Law::name);
  const ObliqueCollision own = collide(law, gripping, skew);
  REQUIRE(own.separated());
  check_oblique(collide(arms_of_collision(law, own.normal.tcol), gripping, skew), own, 1e-7);
}

}  // namespace

TEST_CASE("an oblique impact of a solid is that of the law it becomes, and of its arms") {
  check_oblique(collide(FractionalKelvinVoigt(1.72e7, 15, 1), gripping, skew),
                collide(Linear(1.72e7, 15), gripping, skew), 1e-12);
  check_oblique(collide(FractionalHertz(1e10, 3e3, 1), gripping, skew),
                collide(KuwabaraKono(1e10, 4.5e3), gripping, skew), 1e-12);
  // Nearly so: α = 1 − 1e-9.
  check_oblique(collide(FractionalKelvinVoigt(1.72e7, 15, 1 - 1e-9), gripping, skew),
                collide(Linear(1.72e7, 15), gripping, skew), 1e-7);
  check_oblique(collide(FractionalHertz(1e10, 3e3, 1 - 1e-9), gripping, skew),
                collide(KuwabaraKono(1e10, 4.5e3), gripping, skew), 1e-7);
  // Whose first stick is long beside what the arms' kernel resolves.
  check_by_arms(FractionalKelvinVoigt(1.5e7, 1e4, 0.5));
  check_by_arms(FractionalHertz(1e10, 1e7, 0.5));
  check_by_arms(FractionalZener(1.5e7, 1.5e8, 1e-7, 0.5));
}
