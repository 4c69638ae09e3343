#include <ricochet/collision/fractional_collocation.hpp>
#include <ricochet/fractional/collocation.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ricochet {

namespace {

/// First zero of f in (from, to], looked for on a grid much finer than the motion oscillates: a tenth of the cells
/// finds the same zeros, of both ends, for all −1 ≤ α < 1.
template <class F>
std::optional<double> first_zero(const F& f, double from, double to) {
  constexpr int cells = 160;
  double left = from, f_left = f(left);
  for (int i = 1; i <= cells; ++i) {
    const double right = from + (to - from) * i / cells, f_right = f(right);
    if (f_right == 0) return right;
    if ((f_left < 0) != (f_right < 0)) return support::root(f, left, right, f_left, f_right);
    left = right;
    f_left = f_right;
  }
  return std::nullopt;
}

constexpr double shortest = 10.5;  // of the intervals in y that the end is looked for on

/// The Chebyshev coefficients of e^{−y} on [0, horizon] fall off past a degree of some horizon, the more slowly the
/// longer it is.
int nodes_on(double horizon, int nodes) {
  return std::min(120, static_cast<int>(std::ceil(nodes * std::max(1.0, 0.625 * horizon / shortest))));
}

struct Events {
  double end, max_overlap;  // y of each
};

std::optional<Events> events(const FractionalMotion& motion, ContactEnd end) {
  const double horizon = motion.rate.end();
  const std::optional<double> turn = first_zero(motion.rate, 0, horizon);
  if (!turn) return std::nullopt;
  if (end == ContactEnd::force) {
    const std::optional<double> zero = first_zero(motion.force, 0, horizon);
    return zero ? std::optional(Events{*zero, *turn}) : std::nullopt;
  }
  // The overlap falls from its maximum to its first minimum, the next zero of the rate. Bracketing by the two finds the
  // zero also for α just below 0.4009, where two zeros of the overlap are about to merge.
  const double minimum =
      first_zero(motion.rate, std::nextafter(*turn, horizon) + 1e-6 * horizon, horizon).value_or(horizon);
  const std::optional<double> zero = first_zero(motion.overlap, *turn, minimum);
  return zero ? std::optional(Events{*zero, *turn}) : std::nullopt;
}

double strongest(const FractionalMotion& motion, double alpha, double end) {
  const ChebyshevSeries slope = motion.force.derivative();
  // d/dt of t^{1−α} force(y) is t^{−α} times this
  return first_zero([&](double y) { return (1 - alpha) * motion.force(y) + (2 - alpha) * y * slope(y); }, 0, end)
      .value_or(end);
}

FractionalSolution summary(const FractionalMotion& motion, double alpha, ContactEnd end, Events at) {
  const auto time = [&](double y) { return std::pow(y, 1 / (2 - alpha)); };
  FractionalSolution s;
  s.status = end == ContactEnd::force ? CollisionStatus::ended_by_force : CollisionStatus::ended_by_overlap;
  s.tcol = time(at.end);
  s.en = -motion.rate(at.end);
  s.overlap_end = s.tcol * motion.overlap(at.end);
  s.time_max_overlap = time(at.max_overlap);
  s.max_overlap = s.time_max_overlap * motion.overlap(at.max_overlap);
  const double y = strongest(motion, alpha, at.end);
  s.time_max_force = time(y);
  s.max_force = std::pow(s.time_max_force, 1 - alpha) * motion.force(y);
  const auto& c = motion.rate.coefficients();
  s.error_estimate = (std::abs(c[c.size() - 1]) + std::abs(c[c.size() - 2])) / std::abs(s.en);
  return s;
}

}  // namespace

FractionalSolution collocate_collision(double alpha, int nodes, ContactEnd asked) {
  support::require(alpha >= -1 && alpha < 2, "alpha", alpha, "in [-1, 2)");
  const ContactEnd end = alpha < 0 ? ContactEnd::overlap : asked;  // the force still repels at the overlap's zero
  FractionalSolution solution;
  // 10.5 holds the end of every collision by force with 0 ≤ α ≤ 0.98; past 70 nothing is left to come.
  for (double horizon = shortest; alpha < 1 && horizon < 70; horizon *= 1.6) {
    const int taken = nodes_on(horizon, nodes);
    const FractionalMotion motion = collocate_motion(alpha, taken, horizon);
    const int solves = solution.solves + 1;
    if (const std::optional<Events> at = events(motion, end)) solution = summary(motion, alpha, end, *at);
    solution.nodes = taken;
    solution.solves = solves;
    solution.evaluations = static_cast<std::size_t>(taken) * static_cast<std::size_t>(solves);
    if (solution.separated()) break;
  }
  return solution;
}

}  // namespace ricochet
