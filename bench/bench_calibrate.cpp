#include <benchmark/benchmark.h>
#include <calibrate/direct_calibrator.hpp>

#include <random>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

/// Targets in random order over the range of the tables.
std::vector<Request> requests(LawName law, ContactEnd end) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> en(0.01, 0.99), decades(-7, -2);
  std::vector<Request> all;
  for (int i = 0; i < 1024; ++i)
    all.push_back({law, end, {std::pow(10, decades(random)), en(random), {0.5, 7.06858e-6}}});
  return all;
}

void direct(benchmark::State& state, LawName law, ContactEnd end) {
  const DirectCalibrator calibrator;
  const auto all = requests(law, end);
  calibrator(all[0]);  // makes the table
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(calibrator(all[i++ % all.size()]));
  state.SetItemsProcessed(state.iterations());
}

void table(benchmark::State& state, LawName law, ContactEnd end) {
  const auto all = requests(law, end);
  for (auto _ : state) benchmark::DoNotOptimize(DirectCalibrator()(all[0]));
}

void single(benchmark::State& state, LawName law, ContactEnd end) {
  const auto all = requests(law, end);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(calibrate(all[i++ % all.size()]));
}

}  // namespace

BENCHMARK_CAPTURE(direct, linear_overlap, LawName::linear, ContactEnd::overlap);
BENCHMARK_CAPTURE(direct, linear_force, LawName::linear, ContactEnd::force);
BENCHMARK_CAPTURE(direct, hysteretic, LawName::hysteretic, ContactEnd::force);
BENCHMARK_CAPTURE(direct, kuwabara_kono, LawName::kuwabara_kono, ContactEnd::force);
BENCHMARK_CAPTURE(direct, tsuji_overlap, LawName::tsuji, ContactEnd::overlap);
BENCHMARK_CAPTURE(direct, tsuji_force, LawName::tsuji, ContactEnd::force);
BENCHMARK_CAPTURE(direct, fractional, LawName::fractional, ContactEnd::force);
BENCHMARK_CAPTURE(table, kuwabara_kono, LawName::kuwabara_kono, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(table, tsuji_force, LawName::tsuji, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(table, fractional, LawName::fractional, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, linear_force, LawName::linear, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, kuwabara_kono, LawName::kuwabara_kono, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, tsuji_force, LawName::tsuji, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, hysteretic, LawName::hysteretic, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, fractional, LawName::fractional, ContactEnd::force)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
