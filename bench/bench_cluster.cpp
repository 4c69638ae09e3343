// Contact-steps per second of a packing at rest, one core: linear law against fractional arms.
#include "workloads.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace ricochet;

// Settles, then steps.
void packed(benchmark::State& state, const AnyLaw& law, const Friction& friction) {
  const ClusterSetup setup =
      workloads::packing(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), law, friction);
  Cluster cluster(setup, workloads::packing_options());
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
void smooth_kelvin_voigt(benchmark::State& state) { packed(state, FractionalKelvinVoigt(1e5, 1e3, 0.5), smooth); }
void smooth_zener(benchmark::State& state) { packed(state, FractionalZener(1e5, 1e7, 1e-8, 0.5), smooth); }
void smooth_hertz(benchmark::State& state) { packed(state, FractionalHertz(3e7, 3e5, 0.5), smooth); }
void rough_linear(benchmark::State& state) { packed(state, Linear(1e5, 15), rough); }
void rough_fractional(benchmark::State& state) { packed(state, Fractional(1e5, 15, 0.2), rough); }
BENCHMARK(smooth_linear)->Args({10, 10})->Args({22, 21})->Unit(benchmark::kMicrosecond);
BENCHMARK(smooth_fractional)->Args({10, 10})->Args({22, 21})->Unit(benchmark::kMicrosecond);
BENCHMARK(smooth_kelvin_voigt)->Args({10, 10})->Unit(benchmark::kMicrosecond);
BENCHMARK(smooth_zener)->Args({10, 10})->Unit(benchmark::kMicrosecond);
BENCHMARK(smooth_hertz)->Args({10, 10})->Unit(benchmark::kMicrosecond);
BENCHMARK(rough_linear)->Args({10, 10})->Args({22, 21})->Unit(benchmark::kMicrosecond);
BENCHMARK(rough_fractional)->Args({10, 10})->Args({22, 21})->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
