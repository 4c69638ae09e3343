#include "disc_resistance.hpp"

#include <cmath>
#include <limits>

namespace ricochet::contact {
namespace {

// Beyond this ratio λ is as good as 0 or ∞ in double precision.
constexpr double far = 1e12;

// λ by what F and 𝒯 are about λ = ∞, F = 1 and 𝒯 = 1/(4λ), or λ = 0, F = λ and 𝒯 = 2/3.
double likely_ratio(Speeds start, double alpha, double beta) noexcept {
  const double large = (start.x - alpha + 0.25 * beta) / start.y;
  if (large > 1) return large;
  const double small = start.x / (start.y + alpha - 2.0 / 3 * beta);
  return small > 0 && small < 1 ? small : 1;
}

// The root of g(λ) = x − λy, x = X − αF, y = Y − β𝒯, > 0 towards λ = 0 and < 0 towards λ = ∞, by Newton's method, which
// a bracket holds: g is linear in λ at both ends, and g' = −(α + λ²β)F' − y. As x falls and y grows with λ, both are
// below zero at the root where they are so anywhere. F' has but a logarithm's cusp at λ = 1: a step of `small` λ leaves
// 10⁻¹⁶, in λ and in what F and 𝒯 become over it by F'.
std::optional<DiscFriction> by_newton(Speeds start, double alpha, double beta, double lambda) noexcept {
  constexpr int most = 200;  // bisections from one end of the doubles to the other are fewer
  constexpr double small = 1e-9;
  double low = 0, high = std::numeric_limits<double>::infinity();
  for (int n = 0; n < most; ++n) {
    const DiscCurve f = disc_curve(lambda);
    const double x = start.x - alpha * f.force, y = start.y - beta * f.torque, g = x - lambda * y;
    if (x <= 0 && y <= 0) return std::nullopt;
    (g > 0 ? low : high) = lambda;
    double next = lambda + g / ((alpha + lambda * lambda * beta) * f.slope + y);
    if (!(next >= low && next <= high))
      next = low == 0 ? lambda / 4 : high > far * far ? 4 * lambda : std::sqrt(low * high);
    const double on = next - lambda;
    if (std::abs(on) <= small * lambda || !(next > 1 / (far * far) && next < far * far)) {
      const double force = f.force + f.slope * on, torque = f.torque - lambda * f.slope * on;
      // Of one sign, but for rounding where one of them is next to nothing beside the other.
      const bool slides = start.x - alpha * force > 0 || start.y - beta * torque > 0;
      return slides ? std::optional(DiscFriction{force, torque}) : std::nullopt;
    }
    lambda = next;
  }
  return std::nullopt;
}

}  // namespace

std::optional<DiscFriction> resisted(Speeds start, double alpha, double beta, double guess) noexcept {
  const double X = start.x, Y = start.y;
  if (X * beta + 1.5 * Y * alpha <= alpha * beta) return std::nullopt;  // the chord under the limit curve
  if (Y * far <= X) return X > alpha ? std::optional(disc_friction((X - alpha + 0.25 * beta) / Y)) : std::nullopt;
  if (X * far <= Y) {
    const double y = Y - 2.0 / 3 * beta;
    return y > 0 ? std::optional(disc_friction(X / (y + alpha))) : std::nullopt;
  }
  const bool known = guess > 1 / far && guess < far;
  return by_newton(start, alpha, beta, known ? guess : likely_ratio(start, alpha, beta));
}

// As F/𝒯 is 1.5 λ at 0 and 4 λ at ∞; odd in λ, and right at λ = 1.
double ratio_of(DiscFriction friction) noexcept {
  const double r = friction.force / friction.torque, square = 4.0 / 9 * r * r;
  return r > far ? r / 4 : r * (2.0 / 3 + square / 4) / (1 + square);
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
