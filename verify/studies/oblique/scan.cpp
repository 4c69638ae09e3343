#include "scan.hpp"

#include <ricochet/collision/oblique.hpp>

#include <console/progress.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace ricochet::verify::oblique {

namespace {

/// Numbers that are the same on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}

  double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double within(double low, double high) { return low + (high - low) * share(); }
  double decades(double low, double high) { return std::pow(10, within(low, high)); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(share() * static_cast<double>(n)); }
  bool coin() { return below(2) == 1; }
  Vec3 vector(double size) {
    const double x = within(-size, size), y = within(-size, size);
    return {x, y, within(-size, size)};
  }

 private:
  std::mt19937_64 bits_;
};

/// For masses and speeds about 1.
AnyLaw any_law(Dice& dice) {
  switch (dice.below(5)) {
    case 0: return Linear(1, dice.coin() ? 0 : dice.within(0, 3));
    case 1: return KuwabaraKono(1, dice.within(0, 2));
    case 2: return Tsuji(1, dice.within(0, 2));
    case 3: return Hysteretic(1, dice.within(1, 10));
    default: return Fractional(1, 1, dice.within(0, 0.9));
  }
}

TangentialContact any_tangential(Dice& dice) {
  TangentialContact contact;
  const double k = dice.decades(-1, 1), c = dice.coin() ? 0 : dice.within(0.02, 0.5);
  switch (dice.below(3)) {
    case 0: break;
    case 1: contact.law = LinearTangential(k, c); break;
    default: contact.law = MindlinTangential(k, c);
  }
  const double mu = dice.within(0.01, 1);
  contact.friction = Friction(mu, dice.coin() ? mu : 0.5 * mu, dice.within(0, 1));
  if (dice.below(4) == 0) contact.torsion = {Torsion::Limit::separate, {dice.decades(-2, 0), 0}};
  if (dice.below(8) == 0) contact.rolling = {0.05, {dice.decades(-2, -1), 0}};
  return contact;
}

ObliqueImpact any_impact(Dice& dice) {
  const auto body = [&] {
    const double mass = dice.decades(-0.5, 0.5), radius = dice.decades(0.7, 1.3);
    const Vec3 velocity = dice.vector(1);
    return ImpactBody{mass, radius, velocity, dice.vector(0.3)};
  };
  ObliqueImpact impact{.normal = dice.vector(1), .i = body()};
  if (dice.coin()) impact.j = body();
  // A speed of approach below 1, so that the overlap stays well below a radius.
  const Vec3 e = impact.normal / norm(impact.normal);
  impact.i.velocity += (dice.decades(-2, 0) - dot(impact.i.velocity - impact.j.velocity, e)) * e;
  return impact;
}

double energy(const ImpactBody& b, Vec3 velocity, Vec3 spin) {
  if (b.is_wall()) return 0;
  const double inertia = b.inertia_ratio * b.mass * b.radius * b.radius;
  return 0.5 * b.mass * dot(velocity, velocity) + 0.5 * inertia * dot(spin, spin);
}

void look(Scan& found, const ObliqueImpact& impact, const ObliqueCollision& out, double mu) {
  const double before =
      energy(impact.i, impact.i.velocity, impact.i.spin) + energy(impact.j, impact.j.velocity, impact.j.spin);
  const double after = energy(impact.i, out.velocity_i, out.spin_i) + energy(impact.j, out.velocity_j, out.spin_j);
  found.most_gained = std::max(found.most_gained, (after - before) / before);
  found.worst_balance = std::max(found.worst_balance, std::abs(before - after - out.lost.sum()) / before);
  for (const double loss :
       {out.lost.normal, out.lost.dashpot, out.lost.sliding, out.lost.torsion, out.lost.rolling, out.lost.stored})
    found.most_negative = std::max(found.most_negative, -loss / before);
  found.worst_limit = std::max(found.worst_limit, out.impulse_ratio / mu);
}

}  // namespace

Scan scan(std::size_t impacts) {
  console::Progress progress("random oblique impacts", impacts);
  Scan found{.impacts = impacts, .most_gained = -1};
  for (std::size_t n = 0; n < impacts; ++n, progress.advance()) {
    Dice dice(n);
    const AnyLaw law = any_law(dice);
    const TangentialContact tangential = any_tangential(dice);
    const ObliqueImpact impact = any_impact(dice);
    const ObliqueCollision out = collide(law, tangential, impact);
    if (!out.separated())
      ++found.failed;
    else
      look(found, impact, out, tangential.friction.mu_static());
  }
  return found;
}

}  // namespace ricochet::verify::oblique
