#pragma once

#include "scaled_contact.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace ricochet::collision {

enum class Graded { at_start, at_end };

/// One stretch of the motion between two events, stepped over a mesh t_n = T (n/N)^p that is finest at the touch, or at
/// the end as its mirror image: what begins there like t^γ adds errors of order p(1+γ) alone.
class Stretch {
 public:
  Stretch(ScaledContact& contact, const Instant& start, Graded graded, int steps)
      : contact_(contact), start_(start), graded_(graded), steps_(steps) {}

  /// Of the mesh, p.
  static constexpr int grading = 4;

  /// Runs over a length T; leaves the memory at the end.
  Instant run(double length);
  /// Runs up to where `event`, > 0 before, falls to 0; looked for from the length `guess` on, which should be within
  /// `doubt` of it. None where there is no such length up to 4 times the guess, or the budget is spent.
  std::optional<Instant> run_to(const std::function<double(const Instant&)>& event, double guess, double doubt,
                                std::size_t budget);
  /// Of the last run, start and end included.
  const std::vector<Instant>& path() const noexcept { return path_; }
  /// Greatest force of the last run: of the polynomial through nine points of the path, in n.
  Instant peak_force() const;

 private:
  /// Time of mesh point n from the end that the mesh is finest at.
  double from_graded_end(int n, double length) const noexcept;

  ScaledContact& contact_;
  Instant start_;
  Graded graded_;
  int steps_;
  std::vector<Instant> path_;
};

}  // namespace ricochet::collision
