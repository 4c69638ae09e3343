#include <ricochet/motion/event_driven_column.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>

namespace ricochet {

namespace {

/// Body 0 is the plate; gap j lies between bodies j−1 and j and is kept as it was at `since_[j]`.
class HardColumn {
 public:
  HardColumn(const Column& column, double en)
      : en_(en), inverse_mass_{0}, velocity_{0}, gap_{0}, since_{0}, version_{0} {
    for (std::size_t i = 0; i < column.mass.size(); ++i) {
      inverse_mass_.push_back(1 / column.mass[i]);
      velocity_.push_back(column.velocity[i]);
      gap_.push_back(column.gap[i]);
      since_.push_back(0);
      version_.push_back(0);
      negligible_ = std::max(negligible_, 1e-12 * std::abs(column.velocity[i]));
    }
    for (std::size_t j = 1; j < gap_.size(); ++j) schedule(j, 0);
  }

  /// The next collision; false if there is none.
  bool collide() {
    while (!queue_.empty()) {
      const auto [time, j, version] = queue_.top();
      queue_.pop();
      if (version != version_[j]) continue;
      for (std::size_t k = j - 1; k <= j + 1; ++k)
        if (k > 0 && k < gap_.size()) bring_up(k, time);
      gap_[j] = 0;
      const double impulse = (1 + en_) * approach(j) / (inverse_mass_[j - 1] + inverse_mass_[j]);
      velocity_[j - 1] -= impulse * inverse_mass_[j - 1];
      velocity_[j] += impulse * inverse_mass_[j];
      for (std::size_t k = j - 1; k <= j + 1; ++k)
        if (k > 0 && k < gap_.size()) schedule(k, time);
      time_ = time;
      return true;
    }
    return false;
  }

  double time() const { return time_; }
  std::vector<double> velocities() const { return {velocity_.begin() + 1, velocity_.end()}; }

 private:
  using Collision = std::tuple<double, std::size_t, std::size_t>;  // when, gap, its version

  double approach(std::size_t j) const { return velocity_[j - 1] - velocity_[j]; }
  void bring_up(std::size_t j, double time) {
    gap_[j] = std::max(0.0, gap_[j] - approach(j) * (time - since_[j]));
    since_[j] = time;
  }
  void schedule(std::size_t j, double time) {
    ++version_[j];  // what was scheduled for this gap before no longer holds
    if (approach(j) > negligible_) queue_.emplace(time + gap_[j] / approach(j), j, version_[j]);
  }

  double en_, negligible_ = 0, time_ = 0;
  std::vector<double> inverse_mass_, velocity_, gap_, since_;
  std::vector<std::size_t> version_;
  std::priority_queue<Collision, std::vector<Collision>, std::greater<>> queue_;
};

void check_input(const Column& column, double en) {
  using support::require;
  require(column.gravity == 0, "gravity", column.gravity, "0 in an event-driven column");
  require(std::isfinite(en) && en >= 0 && en <= 1, "en", en, "in [0, 1]");
  motion::check(column);
}

}  // namespace

EventDrivenResult event_driven_column(const Column& column, double en, std::size_t limit) {
  check_input(column, en);
  HardColumn hard(column, en);
  EventDrivenResult result;
  bool more = true;
  while (more && result.collisions < limit) {
    more = hard.collide();
    result.collisions += more;
  }
  result.status = more ? EventDrivenResult::Status::collapsed : EventDrivenResult::Status::separated;
  result.time = hard.time();
  result.velocity = hard.velocities();
  result.energy_ratio = kinetic_energy_ratio(column, result.velocity);
  const bool finite =
      std::all_of(result.velocity.begin(), result.velocity.end(), [](double v) { return std::isfinite(v); });
  if (finite && std::isfinite(result.time) && std::isfinite(result.energy_ratio)) return result;
  EventDrivenResult none;
  none.status = EventDrivenResult::Status::out_of_range;
  return none;
}

}  // namespace ricochet
