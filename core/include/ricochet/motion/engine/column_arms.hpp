#pragma once

#include <ricochet/contact/arms_block.hpp>
#include <ricochet/motion/engine/column_memory.hpp>

#include <algorithm>

namespace ricochet::motion {

/// Of laws on Maxwell arms: those of all contacts side by side, as many doubles a contact as there are arms (rounded up
/// to whole lanes), stepped by ArmsBlock.
template <ArmsLaw Law>
class ColumnMemory<Law> {
 public:
  using Memory = MaxwellArms::Memory;
  static constexpr bool remembers = true;

  ColumnMemory(std::span<const Law> laws, std::span<const std::uint32_t> kind, double step)
      : laws_(laws), kind_(kind), step_(step) {
    std::size_t most = 0;
    for (const Law& law : laws) most = std::max(most, law.arms());
    stride_ = (most + ArmsBlock::lanes - 1) / ArmsBlock::lanes * ArmsBlock::lanes;
    for (const Law& law : laws) blocks_.emplace_back(law, step, stride_);
    elongation_.assign(kind.size() * stride_, 0.0);
    held_.assign(kind.size(), 0.0);
    if constexpr (stretches) from_ = to_ = held_;
  }

  const Law& law(std::size_t j) const noexcept { return laws_[kind_[j]]; }

  Memory memory(std::size_t j) const noexcept {
    Memory m;
    std::copy_n(arms_of(j), law(j).arms(), m.elongation.begin());
    return m;
  }

  /// Arms relax for ever.
  bool may_wake(std::size_t /*contact*/, Approach /*now*/) const noexcept { return true; }

  void reset(std::size_t j) noexcept {
    std::fill_n(arms_of(j), stride_, 0.0);
    held_[j] = 0;
  }

  /// The overlap is the one that contact j was last advanced to.
  double step_mean(std::size_t j, double overlap, double rate) const noexcept {
    if constexpr (stretches) rate = (stretched(overlap + rate * step_) - stretched(overlap)) / step_;
    return held_[j] + blocks_[kind_[j]].slope() * rate;
  }

  double mean(std::size_t j, double overlap, double rate, double dt) const noexcept {
    return mean_force(law(j), overlap, rate, memory(j), dt);
  }

  /// Whole steps of the neighbouring contacts first … last − 1, which follow one law, from overlaps `before` to
  /// `after`.
  void advance_steps(std::size_t first, std::size_t last, const double* before, const double* after) noexcept {
    if constexpr (stretches) {
      for (std::size_t j = first; j < last; ++j) from_[j] = stretched(before[j]), to_[j] = stretched(after[j]);
      before = from_.data(), after = to_.data();
    }
    blocks_[kind_[first]].advance(last - first, arms_of(first), before + first, after + first, &held_[first]);
  }

  void advance(std::size_t j, Approach before, Approach after, double dt) noexcept {
    const double to = stretched(after.overlap);
    const double rate = dt > 0 ? (to - stretched(before.overlap)) / dt : 0.0;
    for (std::size_t a = 0; dt > 0 && a < law(j).arms(); ++a) {
      const SteadyArm arm = steady_arm(law(j).relaxation_rate(a), dt);
      double& q = arms_of(j)[a];
      q = arm.decay * q + arm.gain * rate;
    }
    held_[j] = blocks_[kind_[j]].held(arms_of(j), to);
  }

 private:
  static constexpr bool stretches = requires(Approach a) { Law::stretched(a); };
  /// What stretches the arms: the overlap, or a function of it that the law has.
  static double stretched(double overlap) noexcept {
    if constexpr (stretches) return Law::stretched({overlap, 0}).overlap;
    return overlap;
  }
  double* arms_of(std::size_t j) noexcept { return elongation_.data() + j * stride_; }
  const double* arms_of(std::size_t j) const noexcept { return elongation_.data() + j * stride_; }

  std::span<const Law> laws_;
  std::span<const std::uint32_t> kind_;
  double step_;
  std::size_t stride_ = 0;
  std::vector<ArmsBlock> blocks_;
  std::vector<double> elongation_, held_;
  std::vector<double> from_, to_;  // stretched, of laws that stretch
};

}  // namespace ricochet::motion
