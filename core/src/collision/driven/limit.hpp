#pragma once

#include <vector>

namespace ricochet::collision {

/// The limit of values computed with N, 2N, 4N, … steps, by two extrapolations: Romberg's, for an error in even powers
/// of 1/N, and Wynn's epsilon, which finds the powers itself and so serves those that a law brings along (the t^{1−α}
/// of a memory). Either is trusted once it has stood still twice.
class Limit {
 public:
  void add(double value);
  bool empty() const noexcept { return romberg_.empty(); }
  /// The better of the two.
  double value() const noexcept { return value_; }
  /// What the next value to be added should be, if Romberg's limit is right.
  double next() const;
  /// How far the last two values of it lay from the ones before; infinite before there are three.
  double doubt() const noexcept { return doubt_; }

 private:
  void judge(double estimate, std::vector<double>& past);

  std::vector<double> romberg_, wynn_, of_romberg_, of_wynn_;  // last rows of the tables; estimates so far
  double value_ = 0, doubt_ = 0;
};

}  // namespace ricochet::collision
