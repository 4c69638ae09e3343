#include "family.hpp"

#include <cmath>

namespace ricochet::calibration {
namespace {

/// kζ^a + cζ^bζ' [D]: exponents of the damped power laws.
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

template <class Law>
Coordinates slowed(double loss, double tcol) {
  constexpr Exponents e = exponents<Law>;
  return {(e.a + 1) * std::log(tcol), loss + (e.b + 1) * std::log(tcol)};
}

/// α from its logit; 0 at −∞.
double conversion_degree_at(double loss) { return 1 / (1 + std::exp(-loss)); }

/// c^α k^{1−α} = k (c/k)^α, solved for c. The elastic α = 0 leaves c free: √(k m) stands for it.
std::optional<AnyLaw> holding(double k, const Fractional& law, const Target& target) {
  const double m = target.impact.mass_eff, alpha = law.alpha();
  if (alpha == 0) return Fractional(k, std::sqrt(k * m), 0);
  const double ratio = law.coefficient() * m / (k * target.tcol * target.tcol);
  const double c = k * target.tcol * std::exp(std::log(ratio) / alpha);
  if (!std::isnormal(c)) return std::nullopt;
  return Fractional(k, c, alpha);
}

}  // namespace

AnyLaw scaled_law(LawName law, const Coordinates& x) {
  const double scale = std::exp(x.scale), loss = std::exp(x.loss);
  switch (law) {
    case LawName::linear: return Linear(scale, loss);
    case LawName::kuwabara_kono: return KuwabaraKono(scale, loss);
    case LawName::tsuji: return Tsuji(scale, loss);
    case LawName::hysteretic: return Hysteretic(scale, scale * (1 + loss));
    case LawName::fractional: break;
  }
  return Fractional(scale, scale, conversion_degree_at(x.loss));
}

Coordinates with_unit_tcol(LawName law, double loss, double tcol) {
  switch (law) {
    case LawName::linear: return slowed<Linear>(loss, tcol);
    case LawName::kuwabara_kono: return slowed<KuwabaraKono>(loss, tcol);
    case LawName::tsuji: return slowed<Tsuji>(loss, tcol);
    case LawName::hysteretic: return {2 * std::log(tcol), loss};
    case LawName::fractional: break;
  }
  return {(2 - conversion_degree_at(loss)) * std::log(tcol), loss};
}

std::optional<AnyLaw> in_si(const AnyLaw& scaled, const Target& target, double held_stiffness) {
  const auto* fractional = std::get_if<Fractional>(&scaled);
  return fractional ? holding(held_stiffness, *fractional, target) : at_impact(scaled, target.tcol, target.impact);
}

}  // namespace ricochet::calibration
