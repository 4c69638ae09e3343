#include "workloads.hpp"

#include <ricochet/motion/engine/column_engine.hpp>

#include <benchmark/benchmark.h>

#include <ctime>

// Contact-steps per second of a column in which every contact is active: the beads are pressed together at a uniform
// rate, and only the first steps of the collision are timed.

namespace {

using namespace ricochet;

using workloads::PressedColumn;
constexpr double step = PressedColumn::step;

/// CPU time of this thread [s]: what others do on the machine counts as little as may be.
double thread_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Law>
void run(benchmark::State& state, const Law& plate, const Law& pair) {
  const auto beads = static_cast<std::size_t>(state.range(0));
  const Column column = PressedColumn::of(beads);
  const ColumnOptions options{.step = step, .duration = 1};
  for (auto _ : state) {
    ColumnEngine<Law> engine(column, plate, pair, options);
    for (int i = 0; i < PressedColumn::first_steps; ++i) engine.step();
    const double start = thread_time();
    for (int i = 0; i < PressedColumn::pressed_steps; ++i) engine.step();
    state.SetIterationTime(thread_time() - start);
    if (engine.contacts() != beads) state.SkipWithError("not every contact is active");
  }
  const double contact_steps =
      static_cast<double>(state.iterations()) * PressedColumn::pressed_steps * static_cast<double>(beads);
  state.counters["contact_steps/s"] = benchmark::Counter(contact_steps, benchmark::Counter::kIsRate);
  state.counters["s/contact_step"] =
      benchmark::Counter(contact_steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void column_linear(benchmark::State& state) {
  run(state, PressedColumn::plate<Linear>(kind_of<Linear>), PressedColumn::pair<Linear>(kind_of<Linear>));
}

void column_hysteretic(benchmark::State& state) {
  run(state, PressedColumn::plate<Hysteretic>(kind_of<Hysteretic>),
      PressedColumn::pair<Hysteretic>(kind_of<Hysteretic>));
}

void column_tsuji(benchmark::State& state) {
  run(state, PressedColumn::plate<Tsuji>(kind_of<Tsuji>), PressedColumn::pair<Tsuji>(kind_of<Tsuji>));
}

template <class Law>
void column_on_12_arms(benchmark::State& state) {
  run(state, workloads::on_12_arms(PressedColumn::plate<Law>(kind_of<Law>), step),
      workloads::on_12_arms(PressedColumn::pair<Law>(kind_of<Law>), step));
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int beads : {10, 100, 1000, 10000, 100000}) b->Arg(beads);
  b->UseManualTime()->MinTime(0.2);
}

BENCHMARK(column_linear)->Apply(sizes);
BENCHMARK(column_on_12_arms<Fractional>)->Apply(sizes);
BENCHMARK(column_on_12_arms<FractionalKelvinVoigt>)->Apply(sizes);
BENCHMARK(column_on_12_arms<FractionalZener>)->Apply(sizes);
BENCHMARK(column_on_12_arms<FractionalHertz>)->Apply(sizes);
BENCHMARK(column_hysteretic)->Apply(sizes);
BENCHMARK(column_tsuji)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
