#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::half_step {

/// What a contact model tells the user of an engine of the run that it is in: a time step too coarse for its
/// collisions or other than that of the run before, grains too soft for their loads, contacts that lost their memory.
/// Each warning once a run; the model hands it on in its engine's way.
class RunWatch {
 public:
  /// Collision times over time steps: fewer than the first are warned of, than the second refused. Twenty keep e_n to
  /// 1 % from e_n = 0.1 on; calibrate advises no fewer (calibrate/advice.hpp).
  static constexpr int advised_steps = 20, least_steps = 4;
  /// A pair's collision time is known to 1e-4 (pair_law.hpp): a step that was chosen as the twentieth part of it by
  /// somebody who knows it better is not warned of.
  static constexpr double known_to = 1e-3;
  /// Overlaps of more than this part of the smaller radius are warned of.
  static constexpr double soft_overlap = 0.1;

  struct Remark {
    std::string text;
    bool refuses = false;  ///< the run must not go on
  };

  /// Of a later run than the one whose time step `chosen_for` the contacts' memory kernel was chosen for.
  static std::optional<Remark> look_at_kernel(double chosen_for, double dt);

  /// Before a run from step `first` to step `last` with contacts of so many kinds.
  void begin_run(std::size_t kinds, std::int64_t first, std::int64_t last);

  /// Whether a pair is lighter than all pairs of its kind that were looked at.
  bool is_lightest(std::size_t kind, double mass_eff) const noexcept { return mass_eff < lightest_[kind]; }
  /// Looks at such a pair, whose collision takes tcol [s].
  std::optional<Remark> look_at_step(std::size_t kind, double mass_eff, double tcol, double dt);

  bool is_soft(double overlap, double radius) const noexcept { return !soft_said_ && overlap > soft_overlap * radius; }
  /// Of such an overlap; `radius` is the smaller grain's.
  Remark soft(double overlap, double radius);

  /// Of a contact that remembers an earlier step than the last, met at step `now`.
  std::optional<Remark> look_at_memory(std::int64_t now);

 private:
  std::vector<double> lightest_;
  std::int64_t first_ = 0, next_first_ = -1;  // steps at which this run and, unless it is reset, the next begin
  bool was_reset_ = false, coarse_said_ = false, soft_said_ = false;
};

}  // namespace ricochet::half_step
