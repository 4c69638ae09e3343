#include <ricochet/collision/reduction.hpp>

#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include <numbers>
#include <stdexcept>

namespace ricochet {

namespace collision {
namespace {

/// How much more than the target a loss loses; counts the collisions.
struct Losses {
  const std::function<Collision(double)>& collide_at;
  double target = 0;  // −ln e_n
  std::size_t collisions = 0;

  /// ln(lost/target), which is close to linear in the loss; positive where the bodies do not part.
  double operator()(double loss) {
    ++collisions;
    const auto out = collide_at(loss);
    if (!out.separated() || out.en <= 0) return 1e3;
    return std::log(std::max(-std::log(out.en), 1e-300) / target);
  }
};

/// Widens [low, high] around the guess until the loss crosses the target between them; false when none loses enough.
bool bracket(Losses& losses, double guess, double& low, double& high, double& at_low, double& at_high) {
  constexpr double farthest = 240;
  low = high = guess;
  at_low = at_high = losses(guess);
  for (double step = 1; at_low > 0 && guess - low < farthest; step *= 1.6) at_low = losses(low -= step);
  for (double step = 1; at_high < 0 && high - guess < farthest; step *= 1.6) at_high = losses(high += step);
  return at_low <= 0 && at_high >= 0;
}

}  // namespace

std::optional<LossFound> find_loss(const std::function<Collision(double)>& collide_at, double en) {
  Losses losses{collide_at, -std::log(en)};
  double low = 0, high = 0, at_low = 0, at_high = 0;
  if (!bracket(losses, std::log(losses.target), low, high, at_low, at_high)) return std::nullopt;
  // The bracket's end that loses less: past the other one, maybe, nothing parts.
  const double root =
      support::root_bracket([&](double loss) { return losses(loss); }, low, high, at_low, at_high).first;
  const auto out = collide_at(root);
  // What brackets no root is the loss past which no collision is followed.
  if (!out.separated() || std::abs(out.en - en) > 1e-9 * en) return std::nullopt;
  return LossFound{root, losses.collisions + 1};
}

}  // namespace collision

template <class Form>
std::optional<UnitLaw<PowerLaw<Form>>> Reduction<PowerLaw<Form>>::unit(double en, ContactEnd end) {
  using Generic = GenericReduction<Law>;
  if constexpr (std::same_as<Law, Linear>) {
    const double loss = 0 - std::log(en);  // not −0
    if (end == ContactEnd::overlap) {
      const auto law = representable<Law>(Reduction::values_by_overlap(loss));
      return law ? std::optional(UnitLaw<Law>{*law, 0, true}) : std::nullopt;
    }
  }
  if constexpr (std::isfinite(Form::overdamped_from))
    return Generic::unit_at(Form::overdamped_from * damping_of_restitution(en, end), end, {0, true});
  if (en == 1) return Generic::unit_at(0, end, {0, true});
  return Generic::unit(en, end);
}

template struct Reduction<Linear>;
template struct Reduction<KuwabaraKono>;
template struct Reduction<Tsuji>;

Hysteretic Reduction<Hysteretic>::at(const Coordinates& x) {
  const double scale = std::exp(x.scale);
  return {scale, scale * (1 + std::exp(x.loss))};
}

std::optional<UnitLaw<Hysteretic>> Reduction<Hysteretic>::unit(double en, ContactEnd) {
  const auto values = unit_values(en);
  if (!std::isfinite(values[1])) return std::nullopt;
  return UnitLaw<Hysteretic>{Hysteretic::from(values), 0, true};
}

namespace {

/// α from its logit; 0 at −∞.
double degree_at(double loss) { return 1 / (1 + std::exp(-loss)); }

Fractional unit_fractional(const FractionalContact& contact) { return {contact.z_star, contact.z_star, contact.alpha}; }

}  // namespace

Fractional Reduction<Fractional>::at(const Coordinates& x) {
  const double scale = std::exp(x.scale);
  return {scale, scale, degree_at(x.loss)};
}

Coordinates Reduction<Fractional>::with_unit_tcol(double loss, double tcol) {
  return {(2 - degree_at(loss)) * std::log(tcol), loss};
}

std::optional<UnitLaw<Fractional>> Reduction<Fractional>::unit(double en, ContactEnd end) {
  if (en < least_restitution(end)) return std::nullopt;
  return UnitLaw<Fractional>{unit_fractional(fractional_contact(conversion_degree(en, end), end)), 1, true};
}

Fractional Reduction<Fractional>::of_degree(double alpha) { return unit_fractional(fractional_contact(alpha)); }

std::optional<Fractional> Reduction<Fractional>::in_si(const Fractional& unit, double tcol, const Impact& impact) {
  const double coefficient = unit.coefficient() * (impact.mass_eff * std::pow(tcol, unit.alpha() - 2));
  return representable<Fractional>({coefficient, coefficient, unit.alpha()});
}

std::optional<Fractional> Reduction<Fractional>::holding(double k, double coefficient, double alpha, double tcol,
                                                         double mass_eff) {
  if (alpha == 0) return Fractional(k, std::sqrt(k * mass_eff), 0);
  const double ratio = coefficient * mass_eff / (k * tcol * tcol);
  const double c = k * tcol * std::exp(std::log(ratio) / alpha);
  if (!std::isnormal(c)) return std::nullopt;
  return Fractional(k, c, alpha);
}

bool holds_degree(LawKind kind) noexcept {
  return kind.visit([]<class Law>(std::type_identity<Law>) { return HoldsDegree<Law>; });
}

AnyLaw scaled_law(LawKind kind, const Coordinates& x, const Held& held) {
  return kind.visit([&]<class Law>(std::type_identity<Law>) -> AnyLaw {
    if constexpr (HoldsDegree<Law>)
      return Reduction<Law>::at(x, held);
    else
      return Reduction<Law>::at(x);
  });
}

Coordinates with_unit_tcol(LawKind kind, double loss, double tcol) {
  return kind.visit([&]<class Law>(std::type_identity<Law>) { return Reduction<Law>::with_unit_tcol(loss, tcol); });
}

std::optional<UnitLaw<AnyLaw>> unit_law(LawKind kind, double en, ContactEnd end, const Held& held) {
  support::require(en > 0 && en <= 1, "en", en, "in (0, 1]");
  if (!kind.ends().offer(end))
    throw std::invalid_argument("end = overlap: must be force for the law " + std::string(kind.name()));
  return kind.visit([&]<class Law>(std::type_identity<Law>) -> std::optional<UnitLaw<AnyLaw>> {
    const auto found = [&] {
      if constexpr (HoldsDegree<Law>)
        return Reduction<Law>::unit(en, end, held);
      else
        return Reduction<Law>::unit(en, end);
    }();
    return found ? std::optional(UnitLaw<AnyLaw>{found->law, found->collisions, found->closed_form}) : std::nullopt;
  });
}

std::optional<AnyLaw> at_impact(const AnyLaw& unit_law, double tcol, const Impact& impact) {
  support::require_positive("tcol", tcol);
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  return std::visit(
      [&]<class Law>(const Law& law) -> std::optional<AnyLaw> { return Reduction<Law>::in_si(law, tcol, impact); },
      unit_law);
}

double rounding_error(const AnyLaw& unit_law, ContactEnd end, double en) {
  return std::visit([&]<class Law>(const Law& law) { return Reduction<Law>::rounding_error(law, end, en); }, unit_law);
}

double numerical_error(LawKind kind, ContactEnd end, double en) {
  return kind.visit([&]<class Law>(std::type_identity<Law>) { return Reduction<Law>::numerical_error(end, en); });
}

namespace {

AnyLaw carried(const std::optional<AnyLaw>& law) {
  if (!law) throw std::overflow_error("tuned_law: a parameter is no normal double, or en out of reach");
  return *law;
}

}  // namespace

Fractional tuned_fractional(double alpha, double tcol, double mass_eff) {
  support::require(alpha > 0 && alpha < 0.97, "alpha", alpha, "between 0 and 0.97");
  return std::get<Fractional>(carried(at_impact(Reduction<Fractional>::of_degree(alpha), tcol, {1, mass_eff})));
}

AnyLaw tuned_law(LawKind kind, double tcol, double en, const Impact& impact, ContactEnd end, const Held& held) {
  support::require_positive("tcol", tcol);
  support::require(std::isfinite(en) && en >= 1e-3 && en < 1, "en", en, "in [0.001, 1)");
  const auto found = unit_law(kind, en, end, held);
  return carried(found ? at_impact(found->law, tcol, impact) : std::nullopt);
}

}  // namespace ricochet
