// The reductions of the laws of real solids.

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/reduction.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet {
namespace {

void require_held(const Held& held) {
  support::require(domains::degree.contains(held.alpha), "alpha", held.alpha, domains::degree.accepted);
  support::require_positive("k1/k", held.stiffening);
}

/// The law at a loss, found by `find_loss` and brought to the collision time 1; past `most` nothing is looked for.
template <class Law>
std::optional<UnitLaw<Law>> unit_of(double en, ContactEnd end, const Held& held,
                                    double most = std::numeric_limits<double>::infinity()) {
  require_held(held);
  std::size_t collisions = 1;
  double loss = -std::numeric_limits<double>::infinity();
  if (en < 1) {
    const auto found = collision::find_loss(
        [&](double at) {
          return at > most ? Collision{} : collide(Reduction<Law>::at({0, at}, held), {1, 1}, {end});
        },
        en);
    if (!found) return std::nullopt;
    loss = found->loss;
    collisions += found->collisions;
  }
  const Law law = Reduction<Law>::at({0, loss}, held);
  const Collision out = collide(law, {1, 1}, {end});
  if (!out.separated()) return std::nullopt;
  const auto unit = Reduction<Law>::in_si(law, 1 / out.tcol, {1, 1});
  return unit ? std::optional(UnitLaw<Law>{*unit, collisions, false}) : std::nullopt;
}

}  // namespace

FractionalKelvinVoigt Reduction<FractionalKelvinVoigt>::at(const Coordinates& x, const Held& held) {
  return {std::exp(x.scale), std::exp(x.loss + (1 - 0.5 * held.alpha) * x.scale), held.alpha};
}

std::optional<UnitLaw<FractionalKelvinVoigt>> Reduction<FractionalKelvinVoigt>::unit(double en, ContactEnd end,
                                                                                     const Held& held) {
  return unit_of<FractionalKelvinVoigt>(en, end, held);
}

std::optional<FractionalKelvinVoigt> Reduction<FractionalKelvinVoigt>::in_si(const FractionalKelvinVoigt& unit,
                                                                             double tcol, const Impact& impact) {
  const double scale = impact.mass_eff / tcol / tcol;
  return representable<FractionalKelvinVoigt>(
      {unit.k() * scale, unit.c() * scale * std::pow(tcol, unit.alpha()), unit.alpha()});
}

// Of the springpot alone.
double Reduction<FractionalKelvinVoigt>::restitution_bound(ContactEnd end, const Held& held) {
  require_held(held);
  const double greatest = end == ContactEnd::force ? 1 : overlap_limit;
  return held.alpha < greatest ? fractional_contact(held.alpha, end).en : 0;
}

std::optional<double> Reduction<FractionalKelvinVoigt>::degree(double k, double en, ContactEnd end) {
  support::require_positive("k", k);
  if (en == 1 || en < least_restitution(end)) return std::nullopt;
  const double least = conversion_degree(en, end);
  const auto linear = unit(en, end, {.alpha = 1});
  if (!linear) return std::nullopt;
  constexpr double rounding = 1e-13, weaker = -1e3;  // what no double tells from no spring
  const auto stiffer = [&](double alpha) {
    const auto found = unit(en, end, {.alpha = alpha});
    return found ? std::log(found->law.k() / k) : weaker;
  };
  const double at_one = std::log(linear->law.k() / k);
  if (at_one < rounding) return at_one > -rounding ? std::optional(1.0) : std::nullopt;
  return support::root(stiffer, least, 1, weaker, at_one);
}

FractionalHertz Reduction<FractionalHertz>::at(const Coordinates& x, const Held& held) {
  return {std::exp(x.scale), std::exp(x.loss + (1 - 0.4 * held.alpha) * x.scale), held.alpha};
}

std::optional<UnitLaw<FractionalHertz>> Reduction<FractionalHertz>::unit(double en, ContactEnd end, const Held& held) {
  return unit_of<FractionalHertz>(en, end, held);
}

std::optional<FractionalHertz> Reduction<FractionalHertz>::in_si(const FractionalHertz& unit, double tcol,
                                                                 const Impact& impact) {
  const double scale = impact.mass_eff / std::sqrt(impact.velocity) / (tcol * tcol * std::sqrt(tcol));
  return representable<FractionalHertz>(
      {unit.k() * scale, unit.c() * scale * std::pow(tcol, unit.alpha()), unit.alpha()});
}

double Reduction<FractionalHertz>::restitution_bound(ContactEnd end, const Held& held) {
  require_held(held);
  if (held.alpha == 0) return 1;
  return collide(FractionalHertz(0, 1, held.alpha), {1, 1}, {end}).en;
}

// At α = 0 τ has no part in it, and without loss no arm has: any τ will do.
FractionalZener Reduction<FractionalZener>::at(const Coordinates& x, const Held& held) {
  if (std::isinf(x.loss)) return {std::exp(x.scale), 0, std::exp(-0.5 * x.scale), held.alpha};
  const double k = std::exp(x.scale), in_units = held.alpha > 0 ? (x.loss - std::log(held.stiffening)) / held.alpha : 0;
  const double tau = std::exp(in_units - 0.5 * x.scale);
  return {k, k * held.stiffening, std::max(tau, std::numeric_limits<double>::min()), held.alpha};
}

// Loss is greatest near where the arm's spring and its springpot take even parts: between where the pot begins to be
// felt beside k, and where it is rigid at the pace of k₁.
double Reduction<FractionalZener>::lossiest(const Held& held) {
  const double stiffening = std::log(held.stiffening);
  const double low = std::min(0.0, stiffening) - 3, high = std::max(stiffening, 0.0) + 3;
  const auto kept = [&](double loss) { return collide(at({0, loss}, held), {1, 1}, {}).en; };
  return boost::math::tools::brent_find_minima(kept, low, high, 26).first;
}

double Reduction<FractionalZener>::restitution_bound(ContactEnd end, const Held& held) {
  require_held(held);
  return collide(at({0, lossiest(held)}, held), {1, 1}, {end}).en;
}

std::optional<UnitLaw<FractionalZener>> Reduction<FractionalZener>::unit(double en, ContactEnd end, const Held& held) {
  require_held(held);
  return unit_of<FractionalZener>(en, end, held, lossiest(held));
}

}  // namespace ricochet
