// Contact-steps per second of a packing at rest, one core: linear law against fractional arms.
#include <ricochet/motion/cluster.hpp>

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace ricochet;

constexpr double radius = 0.005, density = 2500, spacing = 2.04 * radius, step = 6e-6;

// Square layers, each in the hollows of the one below, in a box.
ClusterSetup packing(int across, int layers, const AnyLaw& law, const Friction& friction) {
  ClusterSetup setup;
  setup.gravity = {0, 0, -9.81};
  setup.interactions.insert({{0, 0}, {law, friction}});
  const double rise = std::sqrt(4 * radius * radius - spacing * spacing / 2);
  for (int n = 0; n < layers; ++n)
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < across; ++j) {
        const double shift = n % 2 == 0 ? 0 : spacing / 2;
        setup.spheres.push_back({radius, density, {i * spacing + shift, j * spacing + shift, radius + n * rise}, {}, {}, 0});
      }
  const double side = (across - 0.5) * spacing + radius;
  setup.walls = box_walls({-radius, -radius, 0}, {side, side, 1});
  return setup;
}

// Settles, then steps with one sweep a step: what a contact costs, apart from how often the sweeps repeat.
void packed(benchmark::State& state, const AnyLaw& law, const Friction& friction) {
  const ClusterSetup setup = packing(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), law, friction);
  // 2·10⁻⁶ over 1000 steps is what 12 arms reach.
  Cluster cluster(setup, {.step = step, .longest_contact = 1000 * step, .kernel_tolerance = 2e-6, .max_sweeps = 1});
  cluster.advance(500);
  double contact_steps = 0, steps = 0;
  for (auto _ : state) {
    cluster.step();
    contact_steps += static_cast<double>(cluster.contacts().size());
    ++steps;
  }
  state.counters["contact_steps/s"] = benchmark::Counter(contact_steps, benchmark::Counter::kIsRate);
  state.counters["contacts"] = contact_steps / steps;
  state.counters["grains"] = static_cast<double>(cluster.size());
}

const Friction smooth, rough(0.5, 0.5, 0, 0.1);
void smooth_linear(benchmark::State& state) { packed(state, Linear(1e5, 15), smooth); }
void smooth_fractional(benchmark::State& state) { packed(state, Fractional(1e5, 15, 0.2), smooth); }
void rough_linear(benchmark::State& state) { packed(state, Linear(1e5, 15), rough); }
void rough_fractional(benchmark::State& state) { packed(state, Fractional(1e5, 15, 0.2), rough); }
BENCHMARK(smooth_linear)->Args({10, 10})->Args({22, 21})->Unit(benchmark::kMicrosecond);
BENCHMARK(smooth_fractional)->Args({10, 10})->Args({22, 21})->Unit(benchmark::kMicrosecond);
BENCHMARK(rough_linear)->Args({10, 10})->Args({22, 21})->Unit(benchmark::kMicrosecond);
BENCHMARK(rough_fractional)->Args({10, 10})->Args({22, 21})->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
