// The memory-kernel step of a block of contacts with 12 arms each that stays in the first-level cache.
#include "workloads.hpp"

#include <benchmark/benchmark.h>
#include <ricochet/contact/arms_block.hpp>

#include <utility>
#include <vector>

namespace {

using namespace ricochet;

constexpr std::size_t contacts = 200, arms = 12;
constexpr double step = 1e-6;

FractionalArms law() { return {Fractional(5000, 0.3, 0.3), workloads::kernel_of(arms, 0.3, step), step}; }

/// Overlaps [m] at two neighbouring times; steps go to and fro between them.
struct Overlaps {
  std::vector<double> one = workloads::arguments(1e-6, 2e-6, contacts),
                      other = workloads::arguments(2e-6, 3e-6, contacts);
};

void report(benchmark::State& state) {
  state.counters["s/contact"] = benchmark::Counter(static_cast<double>(contacts * state.iterations()),
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void arms_block(benchmark::State& state, Instructions instructions) {
  if (instructions > widest_instructions()) return state.SkipWithError("not on this machine");
  const ArmsBlock block(law(), step, arms, instructions);
  Overlaps overlaps;
  std::vector<double> elongation(contacts * arms), held(contacts);
  for (auto _ : state) {
    block.advance(contacts, elongation.data(), overlaps.one.data(), overlaps.other.data(), held.data());
    std::swap(overlaps.one, overlaps.other);
    benchmark::ClobberMemory();
  }
  report(state);
}

/// One contact after the other as LIGGGHTS has them stepped, the rate linear over the step: one multiplication more.
void arms_one_by_one(benchmark::State& state) {
  const FractionalArms one = law();
  Overlaps overlaps;
  std::vector<double> elongation(contacts * arms), force(contacts);
  for (auto _ : state) {
    for (std::size_t j = 0; j < contacts; ++j) {
      const double rate = (overlaps.other[j] - overlaps.one[j]) / step;
      force[j] = one.advance_step<arms>(&elongation[j * arms], {overlaps.one[j], rate}, {overlaps.other[j], rate});
    }
    std::swap(overlaps.one, overlaps.other);
    benchmark::ClobberMemory();
  }
  report(state);
}

/// The same by the two functions that every law has, as in `simulate`.
void arms_as_any_law(benchmark::State& state) {
  const FractionalArms one = law();
  Overlaps overlaps;
  std::vector<FractionalArms::Memory> memory(contacts);
  std::vector<double> force(contacts);
  for (auto _ : state) {
    for (std::size_t j = 0; j < contacts; ++j) {
      const double rate = (overlaps.other[j] - overlaps.one[j]) / step;
      one.advance(memory[j], {overlaps.one[j], rate}, {overlaps.other[j], rate}, step);
      force[j] = one.force({overlaps.other[j], rate}, memory[j]);
    }
    std::swap(overlaps.one, overlaps.other);
    benchmark::ClobberMemory();
  }
  report(state);
}

/// A kernel that is good to `tolerance` over so many steps.
void kernel_construction(benchmark::State& state, double steps, double tolerance) {
  for (auto _ : state) benchmark::DoNotOptimize(memory_kernel(0.3, step, steps * step, tolerance));
}

}  // namespace

BENCHMARK_CAPTURE(arms_block, baseline, ricochet::Instructions::baseline);
BENCHMARK_CAPTURE(arms_block, avx2, ricochet::Instructions::avx2);
BENCHMARK(arms_one_by_one);
BENCHMARK(arms_as_any_law);
BENCHMARK_CAPTURE(kernel_construction, 1e3_steps_to_1e_6, 1e3, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kernel_construction, 1e3_steps_to_1e_10, 1e3, 1e-10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kernel_construction, 1e5_steps_to_1e_6, 1e5, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kernel_construction, 1e2_steps_to_1e_12, 1e2, 1e-12)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
