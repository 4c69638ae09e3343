#include <catch2/catch.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/collision.hpp>

#include "scenes.hpp"

#include <numbers>

using namespace ricochet;
using namespace ricochet::test;

namespace {

struct Outcome {
  double en, tcol;
  double energy_error;  // worst |total − initial|/initial
};

// Two spheres head on along (1, 2, 2)/3, the gap such that the touch falls inside a step.
Outcome head_on(const AnyLaw& law, ContactEnd end, double step, double duration) {
  ClusterSetup setup = with_law(law, {}, end);
  const Vec3 e{1.0 / 3, 2.0 / 3, 2.0 / 3};
  const double r = 1.5e-3, v0 = 0.5;
  setup.spheres.push_back({r, 1000, {}, 0.5 * v0 * e});
  setup.spheres.push_back({r, 1000, (2 * r + 2.37e-7) * e, -0.5 * v0 * e});
  Cluster cluster(setup, {.step = step, .longest_contact = duration});
  const double start = cluster.energy().total();
  Outcome o{0, 0, 0};
  double begin = 0, end_time = Encounter::never;
  while (cluster.time() < duration && end_time == Encounter::never) {
    cluster.step();
    for (const ContactState& c : cluster.contacts()) begin = c.record.begin, end_time = c.record.end;
    for (const Encounter& e : cluster.take_finished()) begin = e.begin, end_time = e.end;
    o.energy_error = std::max(o.energy_error, std::abs(cluster.energy().total() / start - 1));
  }
  REQUIRE(end_time < duration);
  o.en = dot(cluster.velocity(1) - cluster.velocity(0), e) / v0;
  o.tcol = end_time - begin;
  return o;
}

constexpr double mass_eff = 7.068583470577035e-06;  // (4/3)π(1.5e-3)³·1000/2

// The worst error of e_n, t_col and the energy balance at tcol/step = n, 2n, 4n, over places of the touch in a step.
std::array<double, 3> errors(const AnyLaw& law, ContactEnd end, double en, double tcol, int n, int places) {
  std::array<double, 3> worst{};
  for (std::size_t k = 0; k < worst.size(); ++k)
    for (int place = 0; place < places; ++place) {
      const double step = (1 + 0.013 * place) * tcol / (n << k);
      const Outcome o = head_on(law, end, step, 5 * tcol);
      worst[k] = std::max({worst[k], std::abs(o.en - en), std::abs(o.tcol / tcol - 1), o.energy_error});
    }
  return worst;
}

void check_order(const std::array<double, 3>& error, double least) {
  CAPTURE(error[0], error[1], error[2]);
  const double order = std::log2(error[0] / error[2]) / 2;
  CHECK(order > least - 0.2);
  CHECK(order < 2.2);
  CHECK(error[2] < 1e-3);
}

}  // namespace

TEST_CASE("two spheres head on reproduce the binary collision at second order") {
  const auto [law, end] = GENERATE(table<AnyLaw, ContactEnd>({{Linear(5211.5, 0.098), ContactEnd::force},
                                                              {Linear(7316, 0.098), ContactEnd::overlap},
                                                              {Linear(5000, 0), ContactEnd::force},
                                                              {Hysteretic(3924, 15697), ContactEnd::force},
                                                              {KuwabaraKono(1389289, 33.845), ContactEnd::force},
                                                              {Tsuji(1389289, 1.5), ContactEnd::force}}));
  CAPTURE(std::string(name(law)));
  const Collision exact = std::visit(
      [&, how = end]<class Law>(const Law& l) {
        if constexpr (std::same_as<Law, Fractional>)
          return Collision{};
        else
          return collide(l, {0.5, mass_eff}, {.end = how});
      },
      law);
  check_order(errors(law, end, exact.en, exact.tcol, 50, 12), 2);
}

// The step of the touch, where a dashpot is all there is: m v' = −c v from t_b on, hence v = v₀ e^{−X}. Its six parts,
// x_k = X (2k − 1)/36 long, take the mean force at the rate half-way, which leaves 1 − x + x²/2 of the rate: too much
// by x³/6 (1 + 3x/4) each, and by X³/6 Σ(2k − 1)³/36³ = 0.0548 X³/6 of v in the end, of which the greatest x makes 7 %
// more at most. A guess at either end of a part is off by x²/2.
TEST_CASE("the step of the touch takes the dashpot at the rate half-way through each of its parts") {
  const double r = 1.5e-3, v0 = 0.5, step = 1e-5, before = 0.25, exponent = 0.3;
  ClusterSetup setup = with_law(Linear(1e-6, exponent * mass_eff / ((1 - before) * step)));
  setup.spheres.push_back({r, 1000, {}, {0.5 * v0, 0, 0}});
  setup.spheres.push_back({r, 1000, {2 * r + before * step * v0, 0, 0}, {-0.5 * v0, 0, 0}});
  Cluster cluster(setup, {.step = step});
  cluster.step();
  const double rate = cluster.velocity(0).x - cluster.velocity(1).x;
  const double error = rate / (v0 * std::exp(-exponent)) - 1, expected = 0.0548 * std::pow(exponent, 3) / 6;
  CHECK(error > 0.9 * expected);
  CHECK(error < 1.1 * expected);
}

// Contacts are passed in blocks, each law's own together: four laws that take turns in one block, against each alone.
TEST_CASE("laws side by side are each their own") {
  const std::vector<NormalLaw> laws{Tsuji(1389289, 1.5), Linear(5211.5, 0.098), Hysteretic(3924, 15697),
                                    KuwabaraKono(1389289, 33.845)};
  const std::vector<std::size_t> order{2, 0, 3, 1, 0, 2, 1, 3};
  const double r = 1.5e-3;
  const auto add_pair = [&](ClusterSetup& setup, std::size_t material, double y) {
    setup.spheres.push_back({r, 1000, {0, y, 0}, {0.25, 0, 0}, {}, material});
    setup.spheres.push_back({r, 1000, {2 * r + 1e-7, y, 0}, {-0.25, 0, 0}, {}, material});
  };
  ClusterSetup together;
  for (std::size_t a = 0; a < laws.size(); ++a)
    for (std::size_t b = 0; b <= a; ++b) together.interactions.insert({{b, a}, {laws[a], {}, ContactEnd::force}});
  for (std::size_t n = 0; n < order.size(); ++n) add_pair(together, order[n], 0.01 * static_cast<double>(n));
  Cluster all(together, {.step = 1e-6});
  std::vector<Cluster> alone;
  for (const std::size_t law : order) {
    ClusterSetup setup = with_law(laws[law]);
    add_pair(setup, 0, 0);
    alone.emplace_back(setup, ClusterOptions{.step = 1e-6});
  }
  for (int step = 0; step < 200; ++step) {
    all.step();
    for (std::size_t n = 0; n < order.size(); ++n) {
      alone[n].step();
      REQUIRE(all.velocity(2 * n).x == alone[n].velocity(0).x);
    }
  }
  for (std::size_t n = 0; n < order.size(); ++n) CHECK(all.velocity(2 * n).x < 0);
}

TEST_CASE("what a hysteretic pair loses never comes back, also where it pulls") {
  ClusterSetup setup = with_law(Hysteretic(1e4, 3e4), {}, ContactEnd::overlap);
  const double r = 1.5e-3, tcol = 1.6e-4 * std::sqrt(0.5);
  setup.spheres.push_back({r, 1000, {}, {0.25, 0, 0}});
  setup.spheres.push_back({r, 1000, {2 * r + 1e-7, 0, 0}, {-0.25, 0, 0}});
  Cluster cluster(setup, {.step = tcol / 400});
  const double energy = cluster.energy().total();
  double lost = 0, fall = 0, drift = 0;
  for (int n = 0; n < 1200; ++n) {
    cluster.step();
    const ClusterEnergy e = cluster.energy();
    fall = std::max(fall, lost - e.lost_normal);
    drift = std::max(drift, std::abs(e.total() - energy));
    lost = e.lost_normal;
  }
  // A spring k₂ swings about ζ₀ for ever, with k₁/k₂ = 1/3 of the energy. All is of second order in 400 steps, 6e-6.
  CHECK(fall < 1e-4 * energy);
  CHECK(drift < 1e-4 * energy);
}

// The force starts like t^{1−α}: order 2−α at worst, 2 as long as that error is the smaller one (see cluster.hpp).
TEST_CASE("fractional spheres head on reproduce the closed form at order 2-alpha or better") {
  const double alpha = GENERATE(0.01, 0.3196786, 0.7, 0.97);
  CAPTURE(alpha);
  const FractionalContact exact = fractional_contact(alpha);
  const double tcol = 1e-4, coefficient = mass_eff * exact.z_star / std::pow(tcol, 2 - alpha);
  // k = c in their units makes c^α k^{1−α} that coefficient.
  check_order(errors(Fractional(coefficient, coefficient, alpha), ContactEnd::force, exact.en, tcol, 100, 2),
              2 - alpha);
}

TEST_CASE("a setup or option that makes no sense is named") {
  ClusterSetup setup = with_law(Linear(1000, 1));
  setup.spheres.push_back({0.01, 1000, {}, {}, {}, 0});
  CHECK_THROWS_WITH(Cluster(setup, {}), "step = 0: must be finite and > 0");
  setup.spheres.push_back({-0.01, 1000, {}, {}, {}, 0});
  CHECK_THROWS_WITH(Cluster(setup, {.step = 1e-5}), "sphere 2 radius = -0.01: must be finite and > 0");
  setup.spheres.back() = {0.01, 1000, {}, {}, {}, 1};
  CHECK_THROWS_WITH(Cluster(setup, {.step = 1e-5}), Catch::Contains("materials 0 and 1"));
  CHECK_THROWS_AS(box_walls({0, 0, 0}, {1, 1, 0}), std::invalid_argument);
}

TEST_CASE("a cluster tells how well it keeps the memory of fractional contacts") {
  const auto error = [](const AnyLaw& law, double longest, double tolerance) {
    ClusterSetup setup = with_law(law);
    setup.spheres.push_back({0.01, 1000, {}, {}, {}, 0});
    return Cluster(setup, {.step = 1e-6, .longest_contact = longest, .kernel_tolerance = tolerance}).kernel_error();
  };
  const Fractional mild(1000, 1, 0.3), strong(1000, 1, 0.97);
  CHECK(error(Linear(1000, 1), 1e-3, 1e-8) == 0);
  const double kept = error(mild, 1e-3, 1e-8);
  CHECK(kept > 0);
  CHECK(kept <= 1e-8);
  // 4·10⁵ steps at α = 0.97 ask for more arms than a contact carries: the tolerance gives way, by no more than tenfold
  // too much.
  const double loosened = error(strong, 0.4, 1e-8);
  CHECK(loosened > 1e-6);
  CHECK(loosened <= 1e-5);
  CHECK_THROWS_WITH(error(mild, 1e-3, 0), "kernel_tolerance = 0: must be in [1e-12, 0.1]");
  CHECK_THROWS_WITH(error(mild, 1, 1e-8), Catch::Contains("longest_contact = 1: must be at most 5e5 steps"));
}

TEST_CASE("the literal reading lets a pair fall silent until it has separated, the default repels again") {
  // A third sphere from behind pushes the first back into the second, whose force has just fallen to zero.
  const auto run = [](Reclosing reclosing) {
    double greatest = 0;
    for (double gap : {2e-5, 6e-5, 1.2e-4}) {
      ClusterSetup setup = with_law(Linear(5000, 0.5));
      const double r = 1.5e-3;
      setup.spheres.push_back({r, 1000, {0, 0, 0}, {0.5, 0, 0}});
      setup.spheres.push_back({r, 1000, {2 * r + 1e-7, 0, 0}, {}});
      setup.spheres.push_back({r, 1000, {-2 * r - gap, 0, 0}, {0.9, 0, 0}});
      Cluster cluster(setup, {.step = 5e-7, .reclosing = reclosing});
      for (int n = 0; n < 2000; ++n) {
        cluster.step();
        for (const ContactState& c : cluster.contacts())
          if (c.record.i == 0 && c.record.j == 1 && c.record.end < cluster.time() - 1e-6)
            greatest = std::max(greatest, c.normal_impulse);
      }
    }
    return greatest;
  };
  CHECK(run(Reclosing::silent) == 0);
  CHECK(run(Reclosing::repels) > 0);
}

TEST_CASE("a dashpot pair ends in permanent contact or in breakage, where 1 % of its approach is left") {
  // v = v₀ exp(−ct/m): t_e = (m/c) ln 100 from the touch. The scheme errs by the midpoint rule's (h c/m)²/12 of the
  // decay, ln 100 times m/c long.
  const double c = 0.1, v0 = 0.5, r = 1.5e-3, time = mass_eff / c, h = time / 50;
  const auto run = [&](double energy, Reclosing reclosing) {
    ClusterSetup setup = with_law(Fractional(5000, c, 1));
    setup.interactions.begin()->second.breakage_energy = energy;
    setup.spheres.push_back({r, 1000, {}, {0.5 * v0, 0, 0}});
    setup.spheres.push_back({r, 1000, {2 * r + 1.3e-7, 0, 0}, {-0.5 * v0, 0, 0}});
    Cluster cluster(setup, {.step = h, .longest_contact = 20 * time, .reclosing = reclosing});
    REQUIRE(cluster.advance(500));
    // The force goes on after t_e, under either reading of what follows an end by force.
    CHECK(std::abs(cluster.velocity(0).x - cluster.velocity(1).x) < 1e-3 * v0);
    REQUIRE(cluster.contacts().size() == 1);
    const Encounter e = cluster.contacts()[0].record;
    CHECK((e.end - e.begin) / (time * std::log(100)) == Approx(1).epsilon(3 * (h / time) * (h / time)));
    CHECK(cluster.take_finished().empty());
    return e.how;
  };
  const double impact_energy = 0.5 * mass_eff * v0 * v0;
  const auto reclosing = GENERATE(Reclosing::repels, Reclosing::silent);
  CHECK(run(Encounter::never, reclosing) == EncounterEnd::permanent_contact);
  CHECK(run(1.001 * impact_energy, reclosing) == EncounterEnd::permanent_contact);
  CHECK(run(0.999 * impact_energy, reclosing) == EncounterEnd::breakage);
  ClusterSetup wrong = with_law(Linear(1000, 1));
  wrong.interactions.begin()->second.breakage_energy = -1;
  wrong.spheres = {{0.01, 1000, {}, {}, {}, 0}, {0.01, 1000, {1, 0, 0}, {}, {}, 0}};
  CHECK_THROWS_WITH(Cluster(wrong, {.step = 1e-5}), "breakage_energy = -1: must be >= 0");
}

TEST_CASE("a pair below alpha = 1 never ends in permanent contact") {
  for (const double alpha : {0.97, 0.999}) {
    ClusterSetup setup = with_law(Fractional(5000, 0.1, alpha));
    setup.spheres.push_back({1.5e-3, 1000, {}, {0.25, 0, 0}});
    setup.spheres.push_back({1.5e-3, 1000, {3.0001e-3, 0, 0}, {-0.25, 0, 0}});
    Cluster cluster(setup, {.step = 2e-6, .longest_contact = 4e-3});
    REQUIRE(cluster.advance(2000));
    const auto finished = cluster.take_finished();
    const Encounter e = finished.empty() ? cluster.contacts().front().record : finished.front();
    CHECK(e.how == EncounterEnd::deformed_rebound);
  }
}

TEST_CASE("the turning point of a collision is located inside its step") {
  // Without damping it lies at half the contact. The scheme's own error is below (π²/12)(h/t_col)², far below a step.
  const double tcol = std::numbers::pi * std::sqrt(mass_eff / 5000);
  for (int place = 0; place < 7; ++place) {
    const int n = 100 + place;
    ClusterSetup setup = with_law(Linear(5000, 0));
    const double r = 1.5e-3;
    setup.spheres.push_back({r, 1000, {}, {0.25, 0, 0}});
    setup.spheres.push_back({r, 1000, {2 * r + 3.1e-7 * place, 0, 0}, {-0.25, 0, 0}});
    Cluster cluster(setup, {.step = tcol / n});
    REQUIRE(cluster.advance(2 * n));
    const auto finished = cluster.take_finished();
    REQUIRE(finished.size() == 1);
    const double turned = finished[0].phase_begin[std::size_t(Phase::decompression)];
    CHECK((turned - finished[0].begin) / tcol == Approx(0.5).margin(1.0 / (n * n)));
  }
}

TEST_CASE("the work of a constant force on a free sphere is its kinetic energy, to rounding") {
  ClusterSetup setup = with_law(Linear(5000, 0));
  setup.spheres.push_back({1.5e-3, 1000, {}, {0.2, 0, -0.1}});
  const Vec3 force{1e-4, -2e-4, 3e-4};
  setup.long_range = [&](double, std::span<const Vec3> positions, std::span<Vec3> forces) {
    REQUIRE(positions.size() == forces.size());
    forces[0] += force;
  };
  Cluster cluster(setup, {.step = 1e-3});
  const double before = cluster.energy().kinetic, m = setup.spheres[0].mass();
  REQUIRE(cluster.advance(10));
  CHECK(norm(cluster.velocity(0) - (setup.spheres[0].velocity + 0.01 / m * force)) < 1e-13);
  CHECK(cluster.energy().long_range_work == Approx(cluster.energy().kinetic - before).epsilon(1e-13));
}

TEST_CASE("it does not matter where in a step a repulsive force ends") {
  // e_n is wrong by E/n² at n steps a contact. While n grows by one, the end moves once through a step: E may change by
  // terms of third order alone, some units over n. A force cut off half a step beside its zero, where R' = kζ', would
  // make E jump by ½ (h/2)² k e_n/m n² = k t_col² e_n/(8 m): 0.46 here.
  const double n0 = 200, v0 = 0.5, r = 1.5e-3;
  const Linear law(5211.5, 0.098);
  const Collision exact = collide(law, {v0, mass_eff});
  double low = 1e300, high = -1e300;
  for (int phase = 0; phase < 12; ++phase) {
    const double n = n0 + phase / 12.0;
    ClusterSetup setup = with_law(law);
    setup.spheres.push_back({r, 1000, {}, {0.5 * v0, 0, 0}});
    setup.spheres.push_back({r, 1000, {2 * r + 1e-9, 0, 0}, {-0.5 * v0, 0, 0}});
    Cluster cluster(setup, {.step = exact.tcol / n});
    REQUIRE(cluster.advance(450));
    const double en = (cluster.velocity(1) - cluster.velocity(0)).x / v0;
    low = std::min(low, (en - exact.en) * n * n), high = std::max(high, (en - exact.en) * n * n);
  }
  CAPTURE(low, high);
  CHECK(high - low < 4 / n0);
}
