// The path of the damped power laws: their scaled motion, recorded step by step.

#include <ricochet/collision/oblique.hpp>

#include "../damped_power.hpp"
#include "../steps.hpp"
#include "normal_path.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace ricochet::collision {
namespace {

/// The linear law in y = √ζ, in which also Mindlin's √ζ is smooth. The other two laws have whole powers of √ζ already.
using SmoothLinearMotion = DampedPower<2, 0, 2>;

template <class Motion>
class PowerPath final : public NormalPath {
 public:
  using State = typename Motion::State;

  PowerPath(const Motion& motion, const Impact& impact, double unit)
      : motion_(motion),
        unit_(unit),
        length_unit_(impact.velocity * unit),
        rate_unit_(impact.velocity),
        force_unit_(impact.mass_eff * impact.velocity / unit) {
    closes_ = motion.elastic();
    record();
  }

  NormalInstant at(double s, bool) const override {
    const State y = state(inside(s));
    State change;
    motion_(y, change, 0.0);
    const double slope = change[2] > 0 ? force_slope(y) / change[2] : 0;
    return {change[2] * unit_, std::max(1e-100, motion_.overlap(y)) * length_unit_, motion_.rate(y) * rate_unit_,
            std::max(0.0, motion_.force(y)) * force_unit_, slope * force_unit_ / unit_};
  }

 private:
  /// d(force)/dσ.
  double force_slope(const State& y) const {
    constexpr int q = Motion::force_power;
    return (q > 0 ? Motion::power(y[0], q - 1) : 1.0) * motion_.force_slope(y);
  }

  /// Where the last step ends the motion: where the force falls to 0, looked for up to where the overlap does, as past
  /// that y^R has it positive again; where nothing damps, at the overlap's end.
  std::optional<double> end_in(Steps<Motion>& steps) const {
    const auto apart = steps.fall([](const State& y) { return y[0]; }, steps.taken());
    if (motion_.elastic()) return apart;
    const auto force = [this](const State& y) { return motion_.reduced_force(y); };
    const auto slack = steps.fall(force, apart.value_or(steps.taken()));
    return slack ? slack : apart;
  }

  void record() {
    Steps<Motion> steps(motion_, motion_.start(), budget, first_step / (1 + motion_.gamma));
    complete_ = false;
    while (!complete_ && steps.advance()) {
      const double s = length_;
      starts_.push_back(s);
      states_.push_back(steps.before());
      if (const auto turn = steps.fall([this](const State& y) { return motion_.rate(y); }, steps.taken()))
        turn_ = s + *turn;
      const auto end = end_in(steps);
      length_ = s + end.value_or(steps.taken());
      complete_ = end.has_value();
    }
  }

  State state(double s) const {
    const auto next = std::upper_bound(starts_.begin() + 1, starts_.end(), s);
    const auto n = static_cast<std::size_t>(next - starts_.begin()) - 1;
    State y = states_[n];
    boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
    stepper.do_step(std::cref(motion_), y, 0.0, s - starts_[n]);
    return y;
  }

  static constexpr std::size_t budget = 1'000'000;
  static constexpr double first_step = 0.05;

  Motion motion_;
  double unit_, length_unit_, rate_unit_, force_unit_;
  std::vector<double> starts_;
  std::vector<State> states_;
};

/// Past this γ the reduced force is followed instead of the velocity, of which it would be a small difference.
constexpr double strong = 2;

template <class Motion>
struct StrongOf;
template <int P, int Q, int R>
struct StrongOf<DampedPower<P, Q, R>> {
  using type = StronglyDampedPower<P, Q, R>;
};

template <class Motion, class Law>
std::shared_ptr<const NormalPath> path(const Law& law, const Impact& impact) {
  using Strong = typename StrongOf<Motion>::type;
  const double unit = time_unit<Motion>(law.k(), impact.velocity, impact.mass_eff);
  const Motion motion{damping_group<Motion>(law.c(), impact.velocity, impact.mass_eff, unit)};
  if (motion.gamma > strong) return std::make_shared<PowerPath<Strong>>(Strong(motion), impact, unit);
  return std::make_shared<PowerPath<Motion>>(motion, impact, unit);
}

}  // namespace

std::shared_ptr<const NormalPath> normal_path(const Linear& law, const Impact& impact, const Collision&) {
  return path<SmoothLinearMotion>(law, impact);
}

std::shared_ptr<const NormalPath> normal_path(const KuwabaraKono& law, const Impact& impact, const Collision&) {
  return path<KuwabaraKonoMotion>(law, impact);
}

std::shared_ptr<const NormalPath> normal_path(const Tsuji& law, const Impact& impact, const Collision&) {
  return path<TsujiMotion>(law, impact);
}

}  // namespace ricochet::collision
