#include <benchmark/benchmark.h>
#include <calibrate/direct_calibrator.hpp>

#include <random>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

/// Targets in random order over the range of the tables.
std::vector<Request> requests(LawKind law, ContactEnd end) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> en(0.01, 0.99), decades(-7, -2);
  std::vector<Request> all;
  for (int i = 0; i < 1024; ++i)
    all.push_back({law, end, {std::pow(10, decades(random)), en(random), {0.5, 7.06858e-6}}});
  return all;
}

void direct(benchmark::State& state, LawKind law, ContactEnd end) {
  const DirectCalibrator calibrator;
  const auto all = requests(law, end);
  calibrator(all[0]);  // makes the table
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(calibrator(all[i++ % all.size()]));
  state.SetItemsProcessed(state.iterations());
}

void table(benchmark::State& state, LawKind law, ContactEnd end) {
  const auto all = requests(law, end);
  for (auto _ : state) benchmark::DoNotOptimize(DirectCalibrator()(all[0]));
}

void single(benchmark::State& state, LawKind law, ContactEnd end) {
  const auto all = requests(law, end);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(calibrate(all[i++ % all.size()]));
}

}  // namespace

BENCHMARK_CAPTURE(direct, linear_overlap, kind_of<Linear>, ContactEnd::overlap);
BENCHMARK_CAPTURE(direct, linear_force, kind_of<Linear>, ContactEnd::force);
BENCHMARK_CAPTURE(direct, hysteretic, kind_of<Hysteretic>, ContactEnd::force);
BENCHMARK_CAPTURE(direct, kuwabara_kono, kind_of<KuwabaraKono>, ContactEnd::force);
BENCHMARK_CAPTURE(direct, tsuji_overlap, kind_of<Tsuji>, ContactEnd::overlap);
BENCHMARK_CAPTURE(direct, tsuji_force, kind_of<Tsuji>, ContactEnd::force);
BENCHMARK_CAPTURE(direct, fractional, kind_of<Fractional>, ContactEnd::force);
BENCHMARK_CAPTURE(table, kuwabara_kono, kind_of<KuwabaraKono>, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(table, tsuji_force, kind_of<Tsuji>, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(table, fractional, kind_of<Fractional>, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, linear_force, kind_of<Linear>, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, kuwabara_kono, kind_of<KuwabaraKono>, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, tsuji_force, kind_of<Tsuji>, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, hysteretic, kind_of<Hysteretic>, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, fractional, kind_of<Fractional>, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
