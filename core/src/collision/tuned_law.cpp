#include <ricochet/collision/tuned_law.hpp>

#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/require.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace ricochet {

namespace {

using std::numbers::pi;

/// kζ^a + cζ^bζ': exponents of the damped power laws.
struct Exponents {
  double a, b;
};
template <class Law>
constexpr Exponents exponents{};
template <>
constexpr Exponents exponents<Linear>{1, 0};
template <>
constexpr Exponents exponents<KuwabaraKono>{1.5, 0.5};
template <>
constexpr Exponents exponents<Tsuji>{1.5, 0.25};

/// nullopt where k or c is neither a normal double nor, for c, 0.
template <class Law>
std::optional<AnyLaw> damped(double k, double c) {
  if (!(std::isnormal(k) && (std::isnormal(c) || c == 0))) return std::nullopt;
  return Law(k, c);
}

/// The damped power law of k = 1 and this c, made to collide in the time 1.
template <class Law>
std::optional<AnyLaw> of_group(double c, ContactEnd end) {
  constexpr Exponents e = exponents<Law>;
  CollideOptions options;
  options.end = end;
  const Collision out = collide(Law(1, c), {1, 1}, options);
  if (!out.separated()) return std::nullopt;
  return damped<Law>(std::pow(out.tcol, e.a + 1), c * std::pow(out.tcol, e.b + 1));
}

std::optional<AnyLaw> unit_linear(double en, ContactEnd end) {
  const double loss = 0 - std::log(en);
  if (end == ContactEnd::overlap) return damped<Linear>(pi * pi + loss * loss, 2 * loss);
  return of_group<Linear>(2 * damping_of_restitution(en, end), end);
}

/// How much more than the target a Kuwabara-Kono group loses; counts the collisions.
struct Losses {
  double target = 0;  // −ln e_n
  std::size_t collisions = 0;

  /// ln(loss/target), which is close to linear in the logarithm of the group; positive where the bodies do not part.
  double operator()(double group) {
    ++collisions;
    const auto out = collide(KuwabaraKono(1, std::exp(group)), {1, 1});
    if (!out.separated() || out.en <= 0) return 1e3;
    return std::log(std::max(-std::log(out.en), 1e-300) / target);
  }
};

/// Widens [low, high] around the guess until the loss crosses the target between them; false when no group loses
/// enough.
bool bracket(Losses& losses, double guess, double& low, double& high, double& at_low, double& at_high) {
  constexpr double farthest = 240;
  low = high = guess;
  at_low = at_high = losses(guess);
  for (double step = 1; at_low > 0 && guess - low < farthest; step *= 1.6) at_low = losses(low -= step);
  for (double step = 1; at_high < 0 && high - guess < farthest; step *= 1.6) at_high = losses(high += step);
  return at_low <= 0 && at_high >= 0;
}

std::optional<UnitLaw> unit_kuwabara_kono(double en) {
  const auto found = [](double c, std::size_t collisions) -> std::optional<UnitLaw> {
    const auto law = of_group<KuwabaraKono>(c, ContactEnd::force);
    return law ? std::optional(UnitLaw{*law, collisions + 1, c == 0}) : std::nullopt;
  };
  if (en == 1) return found(0, 0);
  Losses losses{-std::log(en)};
  double low = 0, high = 0, at_low = 0, at_high = 0;
  // Where little is lost the loss is proportional to the group, so its logarithm is the guess.
  if (!bracket(losses, std::log(losses.target), low, high, at_low, at_high)) return std::nullopt;
  std::uintmax_t trials = 200;
  const auto root = boost::math::tools::toms748_solve([&](double group) { return losses(group); }, low, high, at_low,
                                                      at_high, boost::math::tools::eps_tolerance<double>(), trials);
  const double group = std::exp(root.first);
  const auto out = collide(KuwabaraKono(1, group), {1, 1});
  // What brackets no root is the group past which no collision is followed.
  if (!out.separated() || std::abs(out.en - en) > 1e-9 * en) return std::nullopt;
  return found(group, losses.collisions + 1);
}

/// t = (π/2) √(m/k₁) (1 + e), e = √(k₁/k₂).
std::optional<AnyLaw> unit_hysteretic(double en) {
  const double root = 0.5 * pi * (1 + en), k1 = root * root, k2 = k1 / (en * en);
  if (!std::isfinite(k2)) return std::nullopt;
  return Hysteretic(k1, k2);
}

Fractional unit_fractional(const FractionalContact& contact) { return {contact.z_star, contact.z_star, contact.alpha}; }

std::optional<AnyLaw> unit_fractional(double en, ContactEnd end) {
  if (en < least_restitution(end)) return std::nullopt;
  return unit_fractional(fractional_contact(conversion_degree(en, end), end));
}

struct AtImpact {
  double tcol;
  const Impact& impact;

  template <class Law>
  std::optional<AnyLaw> operator()(const Law& law) const {
    constexpr Exponents e = exponents<Law>;
    const auto& [v, m] = impact;
    return damped<Law>(law.k() * (m * std::pow(v, 1 - e.a) * std::pow(tcol, -e.a - 1)),
                       law.c() * (m * std::pow(v, -e.b) * std::pow(tcol, -e.b - 1)));
  }
  std::optional<AnyLaw> operator()(const Hysteretic& law) const {
    const double unit = impact.mass_eff / (tcol * tcol), k1 = law.k1() * unit, k2 = law.k2() * unit;
    if (!(std::isnormal(k1) && std::isnormal(k2))) return std::nullopt;
    return Hysteretic(k1, k2);
  }
  std::optional<AnyLaw> operator()(const Fractional& law) const {
    const double coefficient = law.coefficient() * (impact.mass_eff * std::pow(tcol, law.alpha() - 2));
    if (!std::isnormal(coefficient)) return std::nullopt;
    return Fractional(coefficient, coefficient, law.alpha());
  }
};

std::optional<UnitLaw> closed(const std::optional<AnyLaw>& law, std::size_t collisions) {
  return law ? std::optional(UnitLaw{*law, collisions, true}) : std::nullopt;
}

void require_end(LawKind kind, ContactEnd end) {
  if (!offers(kind, end))
    throw std::invalid_argument(std::string("end = overlap: must be force for the ") +
                                (kind == LawKind::hysteretic ? "hysteretic" : "Kuwabara-Kono") + " law");
}

AnyLaw carried(const std::optional<AnyLaw>& law) {
  if (!law) throw std::overflow_error("tuned_law: a parameter is no normal double");
  return *law;
}

}  // namespace

bool offers(LawKind kind, ContactEnd end) noexcept {
  return end == ContactEnd::force || (kind != LawKind::kuwabara_kono && kind != LawKind::hysteretic);
}

std::optional<UnitLaw> unit_law(LawKind kind, double en, ContactEnd end) {
  support::require(en > 0 && en <= 1, "en", en, "in (0, 1]");
  require_end(kind, end);
  switch (kind) {
    case LawKind::linear: return closed(unit_linear(en, end), end == ContactEnd::force ? 1 : 0);
    case LawKind::tsuji: return closed(of_group<Tsuji>(std::sqrt(5.0) * damping_of_restitution(en, end), end), 1);
    case LawKind::kuwabara_kono: return unit_kuwabara_kono(en);
    case LawKind::hysteretic: return closed(unit_hysteretic(en), 0);
    case LawKind::fractional: break;
  }
  return closed(unit_fractional(en, end), 1);
}

std::optional<AnyLaw> at_impact(const AnyLaw& unit_law, double tcol, const Impact& impact) {
  support::require_positive("tcol", tcol);
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  return std::visit(AtImpact{tcol, impact}, unit_law);
}

Fractional tuned_fractional(double alpha, double tcol, double mass_eff) {
  support::require(alpha > 0 && alpha < 0.97, "alpha", alpha, "between 0 and 0.97");
  return std::get<Fractional>(carried(at_impact(unit_fractional(fractional_contact(alpha)), tcol, {1, mass_eff})));
}

AnyLaw tuned_law(LawKind kind, double tcol, double en, const Impact& impact, ContactEnd end) {
  support::require_positive("tcol", tcol);
  support::require(std::isfinite(en) && en >= 1e-3 && en < 1, "en", en, "in [0.001, 1)");
  const auto found = unit_law(kind, en, end);
  return carried(found ? at_impact(found->law, tcol, impact) : std::nullopt);
}

}  // namespace ricochet
