// A law of a user's own, the one of docs/adding-a-law.md, in a cluster.

#include "../../docs/examples/standard_solid.hpp"
#include "scenes.hpp"

#include <ricochet/motion/engine/column_engine.hpp>

#include <catch2/catch.hpp>

#include <numbers>

using namespace ricochet;
using namespace ricochet::test;

namespace {

constexpr double radius = 1.5e-3, density = 1000, velocity = 0.5, tcol = 1e-4;
const double mass = 4.0 / 3 * std::numbers::pi * radius * radius * radius * density;
const double k = mass * (std::numbers::pi / tcol) * (std::numbers::pi / tcol);
const StandardSolid law(k, k, 0.2 * tcol);

/// A ball that falls onto a plate, from a gap of its own.
ClusterSetup ball_on_plate(const NormalLaw& normal, double gap) {
  ClusterSetup setup = with_law(normal);
  setup.spheres.push_back({radius, density, {0, 0, radius + gap}, {0, 0, -velocity}});
  setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
  return setup;
}

struct Rebound {
  double en = 0, tcol = 0, energy_error = 0;
};

Rebound in_cluster(const NormalLaw& normal, double step, double gap) {
  Cluster cluster(ball_on_plate(normal, gap), {.step = step});
  const double start = cluster.energy().total();
  Rebound r;
  std::vector<Encounter> finished;
  while (finished.empty() && cluster.time() < 10 * tcol) {
    cluster.step();
    r.energy_error = std::max(r.energy_error, std::abs(cluster.energy().total() / start - 1));
    finished = cluster.take_finished();
  }
  REQUIRE(finished.size() == 1);
  r.tcol = finished[0].end - finished[0].begin;
  r.en = cluster.velocity(0).z / velocity;
  return r;
}

/// The same by another engine, which knows nothing of clusters.
double restitution_in_column(double step) {
  ColumnEngine<StandardSolid> engine(equal_column(1, mass, 0, -velocity), law, law,
                                     {.step = step, .duration = 10 * tcol});
  while (!engine.finished() && engine.time() < 10 * tcol) engine.step();
  REQUIRE(engine.finished());
  return engine.velocity(0) / velocity;
}

/// Kelvin–Voigt with a dashpot in ζ'|ζ'|, not affine in the rate: a law for which the slope must be found.
class Squared {
 public:
  using Memory = NoMemory;
  static constexpr std::string_view name = "squared";
  double force(Approach a, const Memory&) const noexcept { return k * a.overlap + c * a.rate * std::abs(a.rate); }
  void advance(Memory&, Approach, Approach, double) const noexcept {}
  double stored_energy(Approach a, const Memory&) const noexcept { return 0.5 * k * a.overlap * a.overlap; }
  double dissipated_power(Approach a, const Memory&) const noexcept { return c * a.rate * a.rate * std::abs(a.rate); }

 private:
  static constexpr double c = 0.5;
};

/// Kuwabara-Kono under another name, so that nothing made for the original applies.
class Disguised : public KuwabaraKono {
 public:
  using KuwabaraKono::KuwabaraKono;
};

}  // namespace

TEST_CASE("a law of one's own rebounds in a cluster as in the column engine, at second order, its balance closed") {
  const double exact = restitution_in_column(tcol / 51200);
  // Where in a step the contact starts matters: averaged over starts.
  const auto mean = [&](double step) {
    Rebound sum;
    for (int i = 0; i < 16; ++i) {
      const Rebound r = in_cluster(law, step, (i + 0.5) / 16 * velocity * step);
      sum.en += std::abs(r.en - exact) / 16, sum.energy_error += r.energy_error / 16;
    }
    return sum;
  };
  const Rebound coarse = mean(tcol / 100), fine = mean(tcol / 400);
  CAPTURE(exact, coarse.en, fine.en, coarse.energy_error, fine.energy_error);
  CHECK(std::log2(coarse.en / fine.en) / 2 == Approx(2).margin(0.25));
  CHECK(std::log2(coarse.energy_error / fine.energy_error) / 2 == Approx(2).margin(0.25));
}

TEST_CASE("a law that is not affine in the rate is stepped to second order") {
  const double exact = in_cluster(Squared(), tcol / 25600, 1e-9).en;
  const auto mean = [&](double step) {
    double sum = 0;
    for (int i = 0; i < 16; ++i)
      sum += std::abs(in_cluster(Squared(), step, (i + 0.5) / 16 * velocity * step).en - exact) / 16;
    return sum;
  };
  CHECK(std::log2(mean(tcol / 100) / mean(tcol / 400)) / 2 == Approx(2).margin(0.25));
}

TEST_CASE("what serves any law differs from what is made for the project's laws in the first step alone") {
  // There the mean force of a part is the midpoint's instead of the exact one. A force like t^{1/2} makes that an
  // impulse of order h^{3/2}. The slopes, differences instead of formulas, differ by rounding.
  const KuwabaraKono original(1389289, 33.845);
  const Disguised copy(1389289, 33.845);
  const auto apart = [&](double step) {
    const double gap = 0.5 * velocity * step;
    return std::abs(in_cluster(copy, step, gap).en - in_cluster(original, step, gap).en);
  };
  const double coarse = apart(tcol / 100), fine = apart(tcol / 400);
  CAPTURE(coarse, fine);
  CHECK(std::log2(coarse / fine) / 2 == Approx(1.5).margin(0.1));
}

TEST_CASE("a cluster with a law of one's own is saved and restored in the middle of a contact") {
  const ClusterSetup setup = ball_on_plate(law, 1e-7);
  const ClusterOptions options{.step = tcol / 200};
  Cluster whole(setup, options), half(setup, options), rest(setup, options);
  REQUIRE(whole.advance(300));
  REQUIRE(half.advance(100));
  const ClusterState state = half.state();
  REQUIRE(state.memories.size() == 1);
  CHECK(state.memories[0].law == "standard-solid");
  REQUIRE(state.memories[0].values.size() == 1);
  CHECK(state.memories[0].values[0] > 0);
  rest.restore(state);
  CHECK(rest.state().memories[0].values == state.memories[0].values);
  REQUIRE(rest.advance(200));
  CHECK(rest.velocity(0) == whole.velocity(0));
  CHECK(rest.position(0) == whole.position(0));
  CHECK(rest.energy().lost_normal == whole.energy().lost_normal);
}

TEST_CASE("a state with a memory of another law or length is refused by name, and nothing is changed") {
  const ClusterSetup setup = ball_on_plate(law, 1e-7);
  Cluster cluster(setup, {.step = tcol / 200});
  REQUIRE(cluster.advance(50));
  const ClusterState good = cluster.state();
  const auto refused = [&](auto&& change) {
    ClusterState state = good;
    change(state);
    CHECK_THROWS_AS(cluster.restore(state), std::invalid_argument);
    CHECK(cluster.state().memories.at(0).values == good.memories[0].values);
    try {
      cluster.restore(state);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string accepted = ": must be standard-solid with 1 numbers";
  CHECK(refused([](ClusterState& s) { s.memories[0].law = "linear"; }) ==
        "state: memory of bodies 0 and 1 = linear with 1 numbers" + accepted);
  CHECK(refused([](ClusterState& s) { s.memories[0].values.push_back(0); }) ==
        "state: memory of bodies 0 and 1 = standard-solid with 2 numbers" + accepted);
  CHECK(refused([](ClusterState& s) { s.memories.clear(); }) == "state: must have one memory a contact");
  CHECK(refused([](ClusterState& s) { s.contacts[0].record.j = 2; }).find("of the same spheres and walls") !=
        std::string::npos);
  CHECK(refused([](ClusterState& s) { s.spins.pop_back(); }) == "state: must be of the same spheres and walls");
}

TEST_CASE("a step resolves the collisions of a law of one's own") {
  // π m v/R_max is at most π times the collision's duration, and that of a linear one without damping exactly; the
  // greatest force is met to some 10 %.
  class Spring : public Linear {
   public:
    using Linear::Linear;
  };
  const auto resolved = [](const NormalLaw& normal, double speed) { return normal.resolved_time(mass, speed); };
  CHECK(resolved(Spring(k, 0), velocity) == Approx(tcol).epsilon(0.1));
  CHECK(resolved(Spring(k, 0), 1e-6 * velocity) == Approx(tcol).epsilon(0.1));
  // A dashpot alone: π m/c, its greatest force at the touch.
  CHECK(resolved(Spring(1e-6 * k, 0.5), velocity) == Approx(std::numbers::pi * mass / 0.5).epsilon(0.1));
  CHECK(resolved(law, velocity) < std::numbers::pi * in_cluster(law, tcol / 200, 1e-9).tcol);
  // R_max is at most that of both springs together, √(2km) v: π m v/R_max at least t_col/√2.
  CHECK(resolved(law, velocity) > 0.9 * tcol / std::sqrt(2));
  CHECK(std::isinf(resolved(law, 0)));
  CHECK(stiffest_contact(ball_on_plate(law, 1e-7)).tcol == resolved(law, velocity));
}

TEST_CASE("contacts of a law without memory are no larger than those need, and memories lie apart") {
  CHECK(sizeof(ContactState) <= 288);
  CHECK(NormalLaw(Linear(k, 0)).memory_size() == 0);
  CHECK(NormalLaw(Hysteretic(k, k)).memory_size() == 1);
  CHECK(NormalLaw(law).memory_size() == 1);
  CHECK(NormalLaw(Fractional(k, 1, 0.3)).memory_size() == FractionalArms::max_arms);
  CHECK(NormalLaw(AnyLaw(Hysteretic(k, k))).name() == "hysteretic");
  struct Mixed {
    double a;
    float b, c;
  };
  struct Whole {
    long a;
  };
  static_assert(motion::MemoryOfDoubles<FractionalArms::Memory> && motion::MemoryOfDoubles<StandardSolid::Memory>);
  static_assert(!motion::MemoryOfDoubles<Mixed> && !motion::MemoryOfDoubles<Whole>);
  static_assert(!motion::MemoryOfDoubles<std::vector<double>>);
}
