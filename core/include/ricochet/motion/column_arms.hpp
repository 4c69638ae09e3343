#pragma once

#include <ricochet/motion/column_memory.hpp>

#include <algorithm>
#include <array>
#include <cstring>

namespace ricochet::detail {

/// The arms of all contacts side by side, as many doubles a contact as there are arms (rounded up to whole blocks).
/// Advancing an arm also adds up what the arms will give on average over the next step, so a step touches an arm once:
/// three multiplications and two additions.
template <>
class ColumnMemory<FractionalArms> {
 public:
  using Memory = FractionalArms::Memory;
  static constexpr bool remembers = true, may_wake = true;

  ColumnMemory(std::span<const FractionalArms> laws, std::span<const std::uint32_t> kind, double step)
      : laws_(laws), kind_(kind), step_(step) {
    std::size_t most = 0;
    for (const FractionalArms& law : laws) most = std::max(most, law.arms());
    stride_ = (most + block - 1) / block * block;
    for (const FractionalArms& law : laws) steps_.push_back(make_step(law));
    elongation_.assign(kind.size() * stride_, 0.0);
    from_arms_.assign(kind.size(), 0.0);
  }

  const FractionalArms& law(std::size_t j) const noexcept { return laws_[kind_[j]]; }

  Memory memory(std::size_t j) const noexcept {
    Memory m;
    std::copy_n(&elongation_[j * stride_], law(j).arms(), m.elongation.begin());
    return m;
  }

  void reset(std::size_t j) noexcept {
    std::fill_n(elongation_.begin() + static_cast<std::ptrdiff_t>(j * stride_), stride_, 0.0);
    from_arms_[j] = 0;
  }

  double step_mean(std::size_t j, double overlap, double rate) const noexcept {
    const Step& s = steps_[kind_[j]];
    return s.spring * (overlap + 0.5 * rate * step_) + s.resistance * rate + from_arms_[j];
  }

  double mean(std::size_t j, double overlap, double rate, double dt) const noexcept {
    return mean_force(law(j), overlap, rate, memory(j), dt);
  }

  /// Whole steps of the neighbouring contacts first … last − 1, which follow one law, from overlaps `before` to `after`.
  void advance_steps(std::size_t first, std::size_t last, const double* before, const double* after) noexcept {
    switch (stride_ / block) {
      case 0: return;
      case 1: return advance_run<block>(first, last, before, after);
      case 2: return advance_run<2 * block>(first, last, before, after);
      case 3: return advance_run<3 * block>(first, last, before, after);
      case 4: return advance_run<4 * block>(first, last, before, after);
      case 5: return advance_run<5 * block>(first, last, before, after);
      default: return advance_run<6 * block>(first, last, before, after);
    }
  }

  void advance(std::size_t j, Approach before, Approach after, double dt) noexcept {
    if (dt <= 0) return;
    const double rate = (after.overlap - before.overlap) / dt;
    const Step& whole = steps_[kind_[j]];
    double sum = 0;
    for (std::size_t a = 0; a < law(j).arms(); ++a) {
      const SteadyArm arm = steady_arm(law(j).relaxation_rate(a), dt);
      double& q = elongation_[j * stride_ + a];
      q = arm.decay * q + arm.gain * rate;
      sum += whole.weight[a] * q;
    }
    from_arms_[j] = sum;
  }

 private:
  static constexpr std::size_t block = 4;
  static_assert(FractionalArms::max_arms == 6 * block);

  /// A whole step at a constant rate.
  struct Step {
    double spring, resistance;  // force per mean overlap [N/m], per rate [N s/m]
    // Of each arm: e^{−x}, elongation per rate [s], mean force in the next step per elongation [N/m].
    alignas(32) std::array<double, FractionalArms::max_arms> decay{}, gain{}, weight{};
  };

  Step make_step(const FractionalArms& law) const {
    Step s{law.spring(), law.dashpot()};
    for (std::size_t a = 0; a < law.arms(); ++a) {
      const SteadyArm arm = steady_arm(law.relaxation_rate(a), step_);
      s.decay[a] = arm.decay;
      s.gain[a] = arm.gain;
      s.weight[a] = law.stiffness(a) * arm.mean_before;
      s.resistance += law.stiffness(a) * arm.mean_gain;
    }
    return s;
  }

  // Two doubles, what every x86-64 and ARM64 holds in a register. Left to itself g++ vectorises over contacts instead,
  // and transposes every block twice.
  using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;
  static Pair load(const double* from) noexcept {
    Pair pair;
    std::memcpy(&pair, from, sizeof pair);
    return pair;
  }

  template <std::size_t Stride>
  void advance_run(std::size_t first, std::size_t last, const double* before, const double* after) noexcept {
    const Step& s = steps_[kind_[first]];
    const double per_step = 1 / step_;
    double* q = &elongation_[first * Stride];
    for (std::size_t j = first; j < last; ++j, q += Stride) {
      const double rate = (after[j] - before[j]) * per_step;
      std::array<Pair, block / 2> sum{};
      for (std::size_t a = 0; a < Stride; a += 2) {
        const Pair next = load(&s.decay[a]) * load(q + a) + load(&s.gain[a]) * rate;
        std::memcpy(q + a, &next, sizeof next);
        sum[a / 2 % 2] += load(&s.weight[a]) * next;
      }
      const Pair total = sum[0] + sum[1];
      from_arms_[j] = total[0] + total[1];
    }
  }

  std::span<const FractionalArms> laws_;
  std::span<const std::uint32_t> kind_;
  double step_;
  std::size_t stride_ = 0;
  std::vector<Step> steps_;
  std::vector<double> elongation_, from_arms_;
};

}  // namespace ricochet::detail
