#pragma once

#include <ricochet/motion/column_memory.hpp>

#include <algorithm>
#include <array>

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

  void advance_step(std::size_t j, Approach before, Approach after) noexcept {
    advance_by(steps_[kind_[j]], j, (after.overlap - before.overlap) / step_);
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
      sum += whole.of_arm[2 * stride_ + a] * q;
    }
    from_arms_[j] = sum;
  }

 private:
  static constexpr std::size_t block = 4;

  /// A whole step at a constant rate.
  struct Step {
    double spring, resistance;   // force per mean overlap [N/m], per rate [N s/m]
    std::vector<double> of_arm;  // decay of each, then gain [s] of each, then mean force per elongation [N/m] of each
  };

  Step make_step(const FractionalArms& law) const {
    Step s{law.spring(), law.dashpot(), std::vector<double>(3 * stride_, 0.0)};
    for (std::size_t a = 0; a < law.arms(); ++a) {
      const SteadyArm arm = steady_arm(law.relaxation_rate(a), step_);
      s.of_arm[a] = arm.decay;
      s.of_arm[stride_ + a] = arm.gain;
      s.of_arm[2 * stride_ + a] = law.stiffness(a) * arm.mean_before;
      s.resistance += law.stiffness(a) * arm.mean_gain;
    }
    return s;
  }

  void advance_by(const Step& s, std::size_t j, double rate) noexcept {
    double* __restrict q = &elongation_[j * stride_];
    const double* __restrict decay = s.of_arm.data();
    const double* __restrict gain = decay + stride_;
    const double* __restrict weight = gain + stride_;
    std::array<double, block> sum{};
    for (std::size_t a = 0; a < stride_; a += block)
      for (std::size_t lane = 0; lane < block; ++lane) {
        const double next = decay[a + lane] * q[a + lane] + gain[a + lane] * rate;
        q[a + lane] = next;
        sum[lane] += weight[a + lane] * next;
      }
    from_arms_[j] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }

  std::span<const FractionalArms> laws_;
  std::span<const std::uint32_t> kind_;
  double step_;
  std::size_t stride_ = 0;
  std::vector<Step> steps_;
  std::vector<double> elongation_, from_arms_;
};

}  // namespace ricochet::detail
