#include "disc_resistance.hpp"

#include <ricochet/contact/friction.hpp>
#include <ricochet/support/root.hpp>

namespace ricochet::contact {
namespace {

// Beyond this ratio λ is as good as 0 or ∞ in double precision.
constexpr double far = 1e12;

}  // namespace

std::optional<Speeds> resisted(Speeds start, double alpha, double beta) noexcept {
  const double X = start.x, Y = start.y;
  if (X * beta + 1.5 * Y * alpha <= alpha * beta) return std::nullopt;  // the chord under the limit curve
  if (Y * far <= X)
    return X > alpha ? std::optional(Speeds{X - alpha, Y / (1 + beta / (4 * (X - alpha)))}) : std::nullopt;
  if (X * far <= Y) {
    const double y = Y - 2.0 / 3 * beta;
    return y > 0 ? std::optional(Speeds{X / (1 + alpha / y), y}) : std::nullopt;
  }
  const auto mismatch = [&](double lambda) {
    const DiscFriction f = disc_friction(lambda);
    return (X - alpha * f.force) - lambda * (Y - beta * f.torque);
  };
  // Widen from λ = X/Y until the root is bracketed: mismatch > 0 towards λ = 0 and < 0 towards λ = ∞.
  double low = X / Y, high = low, at_low = mismatch(low), at_high = at_low;
  while (at_low < 0 && low > 1 / (far * far)) high = low, at_high = at_low, low /= 4, at_low = mismatch(low);
  while (at_high > 0 && high < far * far) low = high, at_low = at_high, high *= 4, at_high = mismatch(high);
  double lambda = at_low == 0 ? low : high;
  if (at_low > 0 && at_high < 0) lambda = support::root(mismatch, low, high, at_low, at_high, {.relative = 0x1p-49});
  const DiscFriction f = disc_friction(lambda);
  const Speeds end{X - alpha * f.force, Y - beta * f.torque};
  return end.x > 0 && end.y > 0 ? std::optional(end) : std::nullopt;
}

bool admits_stick(double force, double torque) noexcept {
  if (force > 1 || torque > 2.0 / 3) return false;
  if (force + 1.5 * torque <= 1) return true;
  // Motion along (force, torque) itself would be resisted by less: outside for certain. Most cases end here.
  const DiscFriction f = disc_friction(force / torque);
  if (force * force + torque * torque > force * f.force + torque * f.torque) return false;
  return !resisted({force, torque}, 1, 1);
}

}  // namespace ricochet::contact
