#pragma once

#include <algorithm>

namespace ricochet::collision {

/// The normal motion at one place of its path.
struct NormalInstant {
  double pace = 0;     ///< dt/ds [s]
  double overlap = 0;  ///< ζ > 0 [m]
  double rate = 0;     ///< ζ' [m/s]
  double force = 0;    ///< R ≥ 0 [N]
  double slope = 0;    ///< dR/dt [N/s]
};

/// ζ shortly before it returns to 0, where ζ itself is a difference of nothing but rounding: the time that is left
/// times the mean rate until then. Relative error (rest/t_col)²: used for the last 1e-4 of a collision.
inline double last_overlap(double rest, double rate, double rate_at_end) noexcept {
  return -0.5 * rest * (rate + rate_at_end);
}

/// ζ, ζ', R of a normal motion from the touch to the end of its repulsion, along a parameter 0 ≤ s ≤ `length` in which
/// they are smooth, apart from the turning point at most: time itself would have ζ^{1/2} and t^{1−α} at the ends.
class NormalPath {
 public:
  virtual ~NormalPath() = default;
  NormalPath(const NormalPath&) = delete;
  NormalPath& operator=(const NormalPath&) = delete;

  double length() const noexcept { return length_; }
  double turn() const noexcept { return turn_; }        ///< s of the greatest overlap
  bool closes() const noexcept { return closes_; }      ///< whether the overlap ends at 0
  bool complete() const noexcept { return complete_; }  ///< it was not given up on the way
  /// Of the length, at either end: what is nearer is shown as what is there, as stiffnesses may be 0 and slopes
  /// infinite beyond, and nothing happens any more.
  double margin() const noexcept { return margin_; }
  double noise() const noexcept { return noise_; }  ///< of R, relative to the greatest
  /// At the turning point, where paths may have a kink, as seen from before it or after.
  virtual NormalInstant at(double s, bool loading) const = 0;

 protected:
  NormalPath() = default;
  NormalPath(double turn, double length, bool closes) noexcept : turn_(turn), length_(length), closes_(closes) {}

  double inside(double s) const noexcept { return std::clamp(s, margin_ * length_, (1 - margin_) * length_); }

  double turn_ = 0, length_ = 0, margin_ = 1e-12, noise_ = 1e-15;
  bool closes_ = false, complete_ = true;
};

}  // namespace ricochet::collision
