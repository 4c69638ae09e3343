// The largest step that ColumnEngine's scheme bears.
#include <ricochet/motion/column.hpp>

#include "steepest.hpp"

#include <ricochet/support/require.hpp>

#include <limits>
#include <stdexcept>

namespace ricochet {
namespace {

// Root h of w·h·g(h) = 1/2, g the rise of a step's mean force with the rate: kh/2 + c; w in 1/kg.
template <class Law>
double stable_step(const Law& law, double w, double mass, double speed) {
  const motion::Steepest at = motion::steepest(law, mass, speed);
  return 1 / (w * at.damping + std::sqrt(w * at.damping * w * at.damping + w * at.stiffness));
}
// The same with g = c^α k^{1−α} h^{1−α}/Γ(3−α), the mean of D^α over a step of constant rate.
double stable_step(const Fractional& law, double w, double, double) {
  return std::pow(std::tgamma(3 - law.alpha()) / (2 * w * law.coefficient()), 1 / (2 - law.alpha()));
}

// The greatest speed at which the initial velocities let two bodies meet.
double meeting_speed(const Column& column) {
  const auto [slowest, fastest] = std::minmax_element(column.velocity.begin(), column.velocity.end());
  return std::max(*fastest - *slowest, -*slowest);
}

}  // namespace

double largest_step(const Column& column, const AnyLaw& plate, const AnyLaw& pair) {
  motion::check(column);
  const double speed = meeting_speed(column);
  const std::size_t beads = column.mass.size();
  const auto inverse_mass = [&](std::size_t body) { return body == 0 ? 0.0 : 1 / column.mass[body - 1]; };
  double largest = std::numeric_limits<double>::infinity();
  for (std::size_t j = 1; j <= beads; ++j) {
    // Gershgorin's bound: contact j feels its own force through both its bodies, a neighbour's through the one they
    // share.
    const double below = inverse_mass(j - 1), above = inverse_mass(j);
    const double w = (j > 1 ? 2 : 1) * below + (j < beads ? 2 : 1) * above, mass = 1 / (below + above);
    const double step =
        std::visit([&](const auto& law) { return stable_step(law, w, mass, speed); }, j == 1 ? plate : pair);
    largest = std::min(largest, step);
  }
  return largest;
}

}  // namespace ricochet
