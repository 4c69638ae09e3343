#include <ricochet/motion/column_engine.hpp>
#include <ricochet/motion/tuned_law.hpp>

#include <benchmark/benchmark.h>

#include <chrono>
#include <stdexcept>

// Contact-steps per second of a column in which every contact is active: the beads are pressed together at a uniform
// rate, and only the first steps of the collision are timed.

namespace {

using namespace ricochet;

constexpr double mass = 1.41e-5, tcol = 1e-4, en = 0.945, step = tcol / 200;
constexpr int timed_steps = 30;

Column pressed(std::size_t beads) {
  Column column = equal_column(beads, mass, 0, 0);
  for (std::size_t i = 0; i < beads; ++i) column.velocity[i] = -0.5 * static_cast<double>(i + 1);
  return column;
}

template <class Law>
Law tuned(LawKind kind, double mass_eff) {
  return std::get<Law>(tuned_law(kind, tcol, en, {0.5, mass_eff}));
}

/// The loosest kernel with the given number of arms.
MemoryKernel kernel_of(std::size_t arms, double alpha) {
  for (double tolerance = 1e-2; tolerance > 1e-12; tolerance /= 1.5) {
    MemoryKernel kernel = memory_kernel(alpha, step, 1000 * step, tolerance);
    if (kernel.arms().size() == arms) return kernel;
  }
  throw std::runtime_error("no kernel with so many arms");
}

template <class Law>
void run(benchmark::State& state, const Law& plate, const Law& pair) {
  using Clock = std::chrono::steady_clock;
  const auto beads = static_cast<std::size_t>(state.range(0));
  const Column column = pressed(beads);
  const ColumnOptions options{.step = step, .duration = 1};
  for (auto _ : state) {
    ColumnEngine<Law> engine(column, plate, pair, options);
    for (int i = 0; i < 3; ++i) engine.step();
    const auto start = Clock::now();
    for (int i = 0; i < timed_steps; ++i) engine.step();
    state.SetIterationTime(std::chrono::duration<double>(Clock::now() - start).count());
    if (engine.contacts() != beads) state.SkipWithError("not every contact is active");
  }
  const double contact_steps = static_cast<double>(state.iterations()) * timed_steps * static_cast<double>(beads);
  state.counters["contact_steps/s"] = benchmark::Counter(contact_steps, benchmark::Counter::kIsRate);
  state.counters["s/contact_step"] =
      benchmark::Counter(contact_steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void column_linear(benchmark::State& state) {
  run(state, tuned<Linear>(LawKind::linear, mass), tuned<Linear>(LawKind::linear, mass / 2));
}

void column_hysteretic(benchmark::State& state) {
  run(state, tuned<Hysteretic>(LawKind::hysteretic, mass), tuned<Hysteretic>(LawKind::hysteretic, mass / 2));
}

void column_tsuji(benchmark::State& state) {
  run(state, tuned<Tsuji>(LawKind::tsuji, mass), tuned<Tsuji>(LawKind::tsuji, mass / 2));
}

void column_fractional_12_arms(benchmark::State& state) {
  const auto plate = tuned<Fractional>(LawKind::fractional, mass), pair = tuned<Fractional>(LawKind::fractional, mass / 2);
  const MemoryKernel kernel = kernel_of(12, pair.alpha());
  run(state, FractionalArms(plate, kernel, step), FractionalArms(pair, kernel, step));
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int beads : {10, 100, 1000, 10000, 100000}) b->Arg(beads);
  b->UseManualTime()->MinTime(0.2);
}

BENCHMARK(column_linear)->Apply(sizes);
BENCHMARK(column_fractional_12_arms)->Apply(sizes);
BENCHMARK(column_hysteretic)->Apply(sizes);
BENCHMARK(column_tsuji)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
