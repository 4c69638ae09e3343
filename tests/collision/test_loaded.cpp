#include <catch2/catch.hpp>

#include <ricochet/collision/loaded.hpp>
#include <ricochet/support/root.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace ricochet;

namespace {

constexpr Impact impact{.velocity = 0.5, .mass_eff = 2e-3};
constexpr double stiffness = 4e4;
const double time_unit = std::sqrt(impact.mass_eff / stiffness);
/// The load that is p in the units of the linear law.
double load_of(double p) { return p * impact.mass_eff * impact.velocity / time_unit; }

/// x'' + 2Dx' + x = p from x = 0, x' = 1: swings about p.
struct LoadedOscillator {
  double ratio, load;
  double frequency = std::sqrt(1 - ratio * ratio);
  double cosine = -load, sine = (1 - ratio * load) / frequency;

  double overlap(double t) const {
    return load + std::exp(-ratio * t) * (cosine * std::cos(frequency * t) + sine * std::sin(frequency * t));
  }
  double rate(double t) const {
    return std::exp(-ratio * t) * ((sine * frequency - ratio * cosine) * std::cos(frequency * t) -
                                   (cosine * frequency + ratio * sine) * std::sin(frequency * t));
  }
  double force(double t) const { return overlap(t) + 2 * ratio * rate(t); }
};

}  // namespace

TEST_CASE("No load takes anything from a contact without loss") {
  for (const double p : {0.01, 1.0, 20.0}) {
    const double load = load_of(p);
    CHECK(collide_under_load(Linear(stiffness, 0), impact, load).en == Approx(1).epsilon(1e-9 * (1 + 7 * p)));
    CHECK(collide_under_load(KuwabaraKono(1e7, 0), impact, load).en == Approx(1).epsilon(1e-7));
    CHECK(collide_under_load(Hysteretic(stiffness, stiffness), impact, load).en == Approx(1).epsilon(1e-7));
    CHECK(collide_under_load(Fractional(stiffness, 1, 0), impact, load).en == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("A load moves the linear law as its closed form says") {
  for (const double ratio : {0.1, 0.4})
    for (const double p : {0.0, 0.05, 0.1}) {
      const Linear law(stiffness, 2 * ratio * std::sqrt(stiffness * impact.mass_eff));
      const LoadedOscillator exact{ratio, p};
      double after = 1;
      while (exact.force(after) > 0 && after < 9) after += 0.01;
      const double end = support::root([&](double t) { return exact.force(t); }, after - 0.01, after);
      const Collision out = collide_under_load(law, impact, load_of(p));
      REQUIRE(out.status == CollisionStatus::ended_by_force);
      CHECK(out.tcol == Approx(end * time_unit).epsilon(1e-9));
      CHECK(out.en == Approx(-exact.rate(end)).epsilon(1e-8));
      CHECK(out.overlap_end == Approx(exact.overlap(end) * impact.velocity * time_unit).epsilon(1e-8));
    }
}

TEST_CASE("A load changes nothing of the hysteretic law's restitution") {
  // Up (k1 z - N)^2 = N^2 + m k1 v^2, and back the same with k2: e = sqrt(k1/k2) at any load and speed.
  const Hysteretic law(stiffness, 4 * stiffness);
  for (const double p : {0.1, 1.0, 5.0})
    CHECK(collide_under_load(law, impact, load_of(p)).en == Approx(0.5).epsilon(1e-8));
  CHECK(least_speed_to_part(law, impact.mass_eff, load_of(1)) == 0);
}

TEST_CASE("Without a load nothing changes") {
  const Tsuji tsuji(1e7, 20);
  CHECK(collide_under_load(tsuji, impact, 0).en == Approx(collide(tsuji, impact).en).epsilon(1e-9));
  const Fractional fractional(stiffness, 8, 0.3);
  const Collision loaded = collide_under_load(fractional, impact, 0), free = collide(fractional, impact);
  CHECK(loaded.en == Approx(free.en).epsilon(1e-11));
  CHECK(loaded.tcol == Approx(free.tcol).epsilon(1e-11));
  CHECK(loaded.max_overlap == Approx(free.max_overlap).epsilon(1e-10));
  CHECK(loaded.max_force == Approx(free.max_force).epsilon(1e-7));
  CHECK(loaded.overlap_end == Approx(free.overlap_end).epsilon(1e-10));
}

TEST_CASE("The fractional law under a load is the same in closed form and on arms") {
  for (const double alpha : {0.3, 0.5}) {
    const Fractional law(stiffness, 8, alpha);
    const double tcol = collide(law, impact).tcol, load = 0.05 * impact.mass_eff * impact.velocity / tcol;
    const FractionalArms arms(law, memory_kernel(alpha, tcol / 300, 30 * tcol, 1e-8), tcol / 300);
    const Collision exact = collide_under_load(law, impact, load), stepped = collide_under_load(arms, impact, load);
    REQUIRE(exact.separated());
    REQUIRE(stepped.separated());
    CHECK(stepped.en == Approx(exact.en).epsilon(1e-5));
    CHECK(stepped.tcol == Approx(exact.tcol).epsilon(1e-5));
    CHECK(stepped.overlap_end == Approx(exact.overlap_end).epsilon(1e-5));
    CHECK(exact.en < collide(law, impact).en);
    CHECK(exact.tcol > collide(law, impact).tcol);
  }
}

namespace {

/// The law's own way under a load against steps of its arms, to what their kernel is right.
template <class Law>
void check_by_arms(const Law& law, double share) {
  CAPTURE(Law::name, share);
  const double tcol = collide(law, impact).tcol, load = share * impact.mass_eff * impact.velocity / tcol;
  const auto kernel = affordable_kernel(law.alpha(), {tcol / 300, 30 * tcol, 1e-8}, Law::Arms::max_kernel_arms);
  const Collision exact = collide_under_load(law, impact, load),
                  stepped = collide_under_load(typename Law::Arms(law, kernel, tcol / 300), impact, load);
  REQUIRE(exact.separated());
  REQUIRE(stepped.separated());
  CHECK(stepped.en == Approx(exact.en).epsilon(1e-5));
  CHECK(stepped.tcol == Approx(exact.tcol).epsilon(1e-5));
  CHECK(stepped.max_overlap == Approx(exact.max_overlap).epsilon(1e-5));
  CHECK(stepped.max_force == Approx(exact.max_force).epsilon(1e-5));
  CHECK(stepped.overlap_end == Approx(exact.overlap_end).epsilon(1e-5));
  CHECK(exact.en < collide(law, impact).en);
}

template <class Law>
void check_without_load(const Law& law) {
  const Collision loaded = collide_under_load(law, impact, 0), free = collide(law, impact);
  CHECK(loaded.en == Approx(free.en).epsilon(1e-11));
  CHECK(loaded.tcol == Approx(free.tcol).epsilon(1e-11));
  CHECK(loaded.max_overlap == Approx(free.max_overlap).epsilon(1e-10));
  CHECK(loaded.overlap_end == Approx(free.overlap_end).epsilon(1e-10));
}

}  // namespace

TEST_CASE("The laws of real solids under a load are the same in their own ways and on arms") {
  const FractionalKelvinVoigt kelvin_voigt(stiffness, 100, 0.5);
  const FractionalHertz hertz(1e7, 3e4, 0.5);
  const FractionalZener zener(stiffness, 4 * stiffness, 1e-4, 0.5);
  for (const double share : {0.02, 0.1}) {
    check_by_arms(kelvin_voigt, share);
    check_by_arms(hertz, share);
    check_by_arms(zener, share);
  }
  check_without_load(kelvin_voigt);
  check_without_load(hertz);
  check_without_load(zener);
  // Their limits: no loss, none under any load; α = 1 the linear law and Kuwabara and Kono's.
  const double load = load_of(1);
  CHECK(collide_under_load(FractionalHertz(1e7, 1, 0), impact, load).en == Approx(1).epsilon(1e-7));
  CHECK(collide_under_load(FractionalZener(stiffness, stiffness, 1, 0), impact, load).en == Approx(1).epsilon(1e-7));
  CHECK(collide_under_load(FractionalKelvinVoigt(stiffness, 3, 1), impact, load).en ==
        collide_under_load(Linear(stiffness, 3), impact, load).en);
  CHECK(collide_under_load(FractionalHertz(1e7, 300, 1), impact, load_of(0.1)).en ==
        collide_under_load(KuwabaraKono(1e7, 450), impact, load_of(0.1)).en);
  CHECK_FALSE(collide_under_load(FractionalHertz(0, 300, 1), impact, load).separated());
  for (const AnyLaw& law : {AnyLaw(kelvin_voigt), AnyLaw(hertz), AnyLaw(zener)}) {
    const double heavy = load_of(0.3), least = least_speed_to_part(law, impact.mass_eff, heavy);
    CAPTURE(name(law), least);
    REQUIRE(least > 0);
    CHECK(collide_under_load(law, {1.01 * least, impact.mass_eff}, heavy).separated());
    CHECK_FALSE(collide_under_load(law, {0.99 * least, impact.mass_eff}, heavy).separated());
  }
}

TEST_CASE("Below some speed a load keeps bodies together, if anything is lost") {
  const Linear law(stiffness, 0.4 * std::sqrt(stiffness * impact.mass_eff));
  const double load = load_of(0.1), least = least_speed_to_part(law, impact.mass_eff, load);
  CHECK(collide_under_load(law, {1.01 * least, impact.mass_eff}, load).separated());
  CHECK_FALSE(collide_under_load(law, {0.99 * least, impact.mass_eff}, load).separated());
  // Only N T/(m v) counts.
  CHECK(least_speed_to_part(law, impact.mass_eff, 3 * load) == Approx(3 * least).epsilon(1e-3));
  const Fractional fractional(stiffness, 8, 0.3);
  const double slow = least_speed_to_part(fractional, impact.mass_eff, load);
  CHECK(collide_under_load(fractional, {1.01 * slow, impact.mass_eff}, load).separated());
  CHECK_FALSE(collide_under_load(fractional, {0.99 * slow, impact.mass_eff}, load).separated());
  CHECK(least_speed_to_part(Fractional(stiffness, 8, 0), impact.mass_eff, load) == 0);
}

TEST_CASE("Coming off is not getting clear") {
  const Linear law(stiffness, 0.8 * std::sqrt(stiffness * impact.mass_eff));
  const double least = least_speed_to_part(law, impact.mass_eff, 1);
  const Impact slow{1.02 * least, impact.mass_eff}, fast{100 * least, impact.mass_eff};
  CHECK_FALSE(clears(collide_under_load(law, slow, 1), slow, 1));
  CHECK(clears(collide_under_load(law, fast, 1), fast, 1));
}

TEST_CASE("What a load may not be") {
  CHECK_THROWS_WITH(collide_under_load(Linear(1, 0), impact, -1), "load = -1: must be finite and >= 0");
  CHECK_THROWS_WITH(collide_under_load(Linear(1, 0), impact, std::numeric_limits<double>::infinity()),
                    "load = inf: must be finite and >= 0");
  CHECK_THROWS_WITH(collide_under_load(Fractional(1, 1, 1.2), impact, 1),
                    "alpha = 1.2: must be in [0, 1) under a load");
}
