#include "lanes.hpp"

#include <ricochet/contact/arms_block.hpp>
#include <ricochet/contact/mean_force.hpp>
#include <ricochet/support/require.hpp>

#include <cstring>
#include <stdexcept>
#include <utility>

#if defined(__x86_64__)
#define RICOCHET_HAS_AVX2 1
// glibc's view of the processor follows GLIBC_TUNABLES, as its own choices in libm do. Its header is no C++ to clang++.
#if !defined(__clang__) && __has_include(<sys/platform/x86.h>)
#include <sys/platform/x86.h>
#endif
#else
#define RICOCHET_HAS_AVX2 0
#endif

namespace ricochet {

namespace {

using contact::load, contact::Pair, contact::pair_at;
using Coefficients = ArmsBlock::Coefficients;
using Run = void (*)(const Coefficients&, std::size_t, double*, const double*, const double*, double*) noexcept;

// Pairs of arms: left to itself g++ vectorises over contacts instead, and transposes every block twice.
template <std::size_t Blocks>
void run_baseline(const Coefficients& s, std::size_t contacts, double* __restrict q, const double* before,
                  const double* after, double* __restrict held) noexcept {
  for (std::size_t j = 0; j < contacts; ++j, q += 4 * Blocks) {
    const double rise = after[j] - before[j];
    Pair sum[2] = {};
    for (std::size_t a = 0; a < 4 * Blocks; a += 2) {
      const Pair next = pair_at(&s.decay[a]) * pair_at(q + a) + pair_at(&s.gain[a]) * rise;
      std::memcpy(q + a, &next, sizeof next);
      sum[a / 2 % 2] += pair_at(&s.weight[a]) * next;
    }
    const Pair total = sum[0] + sum[1];
    held[j] = (total[0] + total[1]) + s.spring * after[j];
  }
}

#if RICOCHET_HAS_AVX2
// The same on four doubles at once. Not one template with the above: g++ splits a vector wider than the function's
// target before it inlines.
template <std::size_t Blocks>
[[gnu::target("avx2")]] void run_avx2(const Coefficients& s, std::size_t contacts, double* __restrict q,
                                      const double* before, const double* after, double* __restrict held) noexcept {
  using Four [[gnu::vector_size(4 * sizeof(double))]] = double;
  for (std::size_t j = 0; j < contacts; ++j, q += 4 * Blocks) {
    const double rise = after[j] - before[j];
    Four sum = {};
    for (std::size_t a = 0; a < 4 * Blocks; a += 4) {
      Four next, decay, gain, weight;
      load(next, q + a), load(decay, &s.decay[a]), load(gain, &s.gain[a]), load(weight, &s.weight[a]);
      next = decay * next + gain * rise;
      std::memcpy(q + a, &next, sizeof next);
      sum += weight * next;
    }
    held[j] = ((sum[0] + sum[2]) + (sum[1] + sum[3])) + s.spring * after[j];
  }
}
#endif

bool has_avx2() noexcept {
#if defined(CPU_FEATURE_ACTIVE)
  return CPU_FEATURE_ACTIVE(AVX2);
#elif RICOCHET_HAS_AVX2
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

/// One loop for each number of blocks, so that it is unrolled.
template <std::size_t... Blocks>
Run choose(std::size_t blocks, [[maybe_unused]] Instructions instructions, std::index_sequence<Blocks...>) noexcept {
#if RICOCHET_HAS_AVX2
  constexpr Run avx2[] = {run_avx2<Blocks>...};
  if (instructions == Instructions::avx2) return avx2[blocks];
#endif
  constexpr Run baseline[] = {run_baseline<Blocks>...};
  return baseline[blocks];
}

}  // namespace

Instructions widest_instructions() noexcept { return has_avx2() ? Instructions::avx2 : Instructions::baseline; }

ArmsBlock::ArmsBlock(const MaxwellArms& law, double step, std::size_t slots, Instructions instructions)
    : slots_(slots), slope_(law.dashpot() + 0.5 * step * law.spring()) {
  support::require_positive("step", step);
  support::require(slots % lanes == 0 && law.arms() <= slots && slots <= MaxwellArms::max_arms, "slots",
                   static_cast<double>(slots), "a multiple of 4 from the number of arms to 24");
  if (instructions == Instructions::avx2 && !has_avx2())
    throw std::invalid_argument("instructions = avx2: this machine does not have them");
  constexpr std::size_t most = MaxwellArms::max_arms / lanes;
  run_ = choose(slots / lanes, instructions, std::make_index_sequence<most + 1>{});
  coefficients_.spring = law.spring();
  for (std::size_t a = 0; a < law.arms(); ++a) {
    const SteadyArm arm = steady_arm(law.relaxation_rate(a), step);
    coefficients_.decay[a] = arm.decay;
    coefficients_.gain[a] = arm.mean_before;
    coefficients_.weight[a] = law.stiffness(a) * arm.mean_before;
    slope_ += law.stiffness(a) * arm.mean_gain;
  }
}

double ArmsBlock::held(const double* elongation, double overlap) const noexcept {
  double sum = coefficients_.spring * overlap;
  for (std::size_t a = 0; a < slots_; ++a) sum += coefficients_.weight[a] * elongation[a];
  return sum;
}

}  // namespace ricochet
