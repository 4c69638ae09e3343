#include "workloads.hpp"

#include <benchmark/benchmark.h>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/fractional_contact_table.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>

#include <vector>

namespace {

using ricochet::workloads::arguments;

void prepared(benchmark::State& state, double a, double b, double low, double high) {
  const ricochet::MittagLeffler e(a, b);
  const std::vector<double> x = arguments(low, high);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(e(x[i++ % x.size()]));
}

void cold(benchmark::State& state, double a, double b, double low, double high) {
  const std::vector<double> x = arguments(low, high);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(ricochet::mittag_leffler(a, b, x[i++ % x.size()]));
}

void construction(benchmark::State& state, double a, double b) {
  for (auto _ : state) benchmark::DoNotOptimize(ricochet::MittagLeffler(a, b));
}

void contact(benchmark::State& state) {
  const std::vector<double> alpha = arguments(0, 0.97);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(ricochet::fractional_contact(alpha[i++ % alpha.size()]));
}

void degree(benchmark::State& state) {
  const std::vector<double> en = arguments(0.006, 1);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(ricochet::conversion_degree(en[i++ % en.size()]));
}

void table(benchmark::State& state) {
  const ricochet::FractionalContactTable contacts;
  const std::vector<double> en = arguments(0.006, 1);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(contacts(en[i++ % en.size()]));
}

void table_construction(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(ricochet::FractionalContactTable());
}

}  // namespace

BENCHMARK_CAPTURE(prepared, contact_b1, 1.68, 1.0, -10.0, 0.0);
BENCHMARK_CAPTURE(prepared, contact_b2, 1.68, 2.0, -10.0, 0.0);
BENCHMARK_CAPTURE(prepared, contact_ba, 1.03, 1.03, -10.0, 0.0);
BENCHMARK_CAPTURE(prepared, far_a_1_5, 1.5, 1.0, -1e4, -16.0);
BENCHMARK_CAPTURE(prepared, far_a_2_5, 2.5, 2.5, -1e4, -16.0);
BENCHMARK_CAPTURE(prepared, far_a_1_01, 1.01, 1.0, -1e3, -16.0);
BENCHMARK_CAPTURE(prepared, small_a, 0.5, 1.0, -100.0, 0.0);
BENCHMARK_CAPTURE(prepared, small_a_growing, 0.5, 1.0, 0.0, 5.0);
BENCHMARK_CAPTURE(cold, contact_b1, 1.68, 1.0, -10.0, 0.0);
BENCHMARK_CAPTURE(cold, contact_ba, 1.68, 1.68, -10.0, 0.0);
BENCHMARK_CAPTURE(cold, contact_near_one, 1.03, 1.03, -10.0, 0.0);
BENCHMARK_CAPTURE(cold, any_near_one, 1.03, 0.93, -10.0, 0.0);
BENCHMARK_CAPTURE(cold, any_b, 1.3, 0.7, -100.0, 0.0);
BENCHMARK_CAPTURE(cold, large_b, 1.3, 7.7, -100.0, 0.0);
BENCHMARK_CAPTURE(cold, small_a, 0.5, 1.0, -100.0, 0.0);
BENCHMARK_CAPTURE(cold, growing, 2.5, 1.0, 0.0, 5.0);
BENCHMARK_CAPTURE(construction, a_1_5, 1.5, 1.0);
BENCHMARK(contact);
BENCHMARK(degree);
BENCHMARK(table);
BENCHMARK(table_construction);
BENCHMARK_MAIN();
