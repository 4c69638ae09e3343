#include <ricochet/collision/scale_and_loss.hpp>

#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/require.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace ricochet {
namespace {

using std::numbers::pi;
using support::require;
using support::require_positive;

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_impact(const Impact& impact) {
  require_positive("velocity", impact.velocity);
  require_positive("mass_eff", impact.mass_eff);
}

void require_solid(const ElasticSolid& solid) {
  require_positive("young", solid.young);
  require(solid.poisson > -1 && solid.poisson <= 0.5, "poisson", solid.poisson, "in (-1, 0.5]");
}

/// A measure of loss in the eyes of one law: has it one, up to where, and what e_n is it?
template <class Law, class Measure>
struct LossOf {
  static constexpr bool known = false;
};

template <class Law>
struct LossOf<Law, loss::Restitution> {
  static constexpr bool known = true;
  static double limit(ContactEnd) { return infinity; }
  static double en(const loss::Restitution& loss, ContactEnd) { return loss.en; }
};

template <class Form>
struct LossOf<PowerLaw<Form>, loss::DampingRatio> {
  static constexpr bool known = std::isfinite(PowerLaw<Form>::overdamped_from);
  static double limit(ContactEnd end) { return end == ContactEnd::force ? infinity : 1; }
  static double en(const loss::DampingRatio& loss, ContactEnd end) { return restitution_of_damping(loss.ratio, end); }
};

double degree_of(const loss::LossFactor& loss) { return 2 / pi * std::atan(loss.tan_delta); }
double degree_of(const loss::ConversionDegree& loss) { return loss.alpha; }
double limit_in(const loss::LossFactor&, double alpha) { return std::tan(pi / 2 * alpha); }
double limit_in(const loss::ConversionDegree&, double alpha) { return alpha; }

template <class Measure>
requires requires(const Measure& loss) { degree_of(loss); }
struct LossOf<Fractional, Measure> {
  static constexpr bool known = true;
  static double limit(ContactEnd end) {
    return end == ContactEnd::force ? infinity : limit_in(Measure{}, overlap_limit);
  }
  static double en(const Measure& loss, ContactEnd end) {
    const double alpha = degree_of(loss);
    // Nearer to 1 rounding leaves nothing of 1 − α, with which e_n goes.
    return 1 - alpha < 1e-15 ? 0 : fractional_contact(alpha, end).en;
  }
};

double value_of(const loss::Restitution& loss) {
  require(loss.en > 0 && loss.en <= 1, "en", loss.en, "in (0, 1]");
  return loss.en;
}
double value_of(const loss::LossFactor& loss) {
  support::require_not_negative("loss_factor", loss.tan_delta);
  return loss.tan_delta;
}
double value_of(const loss::ConversionDegree& loss) {
  require(loss.alpha >= 0 && loss.alpha < 1, "alpha", loss.alpha, "in [0, 1)");
  return loss.alpha;
}
double value_of(const loss::DampingRatio& loss) {
  support::require_not_negative("damping_ratio", loss.ratio);
  return loss.ratio;
}

/// f(LossOf<…>, the measure) of the law's own type, `otherwise` where it has no such loss.
template <class R, class F>
R with_loss(LawKind law, const Loss& loss, R otherwise, const F& f) {
  return std::visit(
      [&]<class Measure>(const Measure& measure) {
        return law.visit([&]<class Law>(std::type_identity<Law>) -> R {
          if constexpr (LossOf<Law, Measure>::known)
            return f(LossOf<Law, Measure>{}, measure);
          else
            return otherwise;
        });
      },
      loss);
}

/// Eq. for k of each shape of spring, told by the power of the metre in its unit: ζ has none, ζ^{3/2} m^{−1/2}.
double stiffness_of(LawKind law, const scale::Moduli& moduli, const Impact& impact) {
  require(moduli.soften >= 1 && std::isfinite(moduli.soften), "soften", moduli.soften, "finite and >= 1");
  const double k = hertz_stiffness(contact_modulus(moduli.first, moduli.second) / moduli.soften, moduli.radius_eff);
  const int metre = law.parameters().front().dimension.metre;
  if (metre == -2) return k;
  if (metre == 0) return linear_stiffness(k, impact, moduli.linear);
  throw std::invalid_argument("moduli: must be of a law with a spring in overlap or overlap^(3/2), not " +
                              std::string(law.name()));
}

/// A parameter is its value in the units of the impact times m^a v₀^b t^{b+c}; solved for t.
double time_of(double k, double unit_k, Dimension dimension, const Impact& impact) {
  const double unit =
      unit_k * std::pow(impact.mass_eff, dimension.kilogram / 4.0) * std::pow(impact.velocity, dimension.metre / 4.0);
  return std::pow(k / unit, 4.0 / (dimension.metre + dimension.second));
}

}  // namespace

double contact_modulus(const ElasticSolid& first, const ElasticSolid& second) {
  require_solid(first);
  require_solid(second);
  const auto softness = [](const ElasticSolid& s) { return (1 - s.poisson) * (1 + s.poisson) / s.young; };
  return 1 / (softness(first) + softness(second));
}

double hertz_stiffness(double contact_modulus, double radius_eff) {
  require_positive("contact_modulus", contact_modulus);
  require_positive("radius_eff", radius_eff);
  return 4.0 / 3 * contact_modulus * std::sqrt(radius_eff);
}

double hertz_overlap(double stiffness, const Impact& impact) {
  require_positive("stiffness", stiffness);
  require_impact(impact);
  return std::pow(1.25 * impact.mass_eff * impact.velocity * impact.velocity / stiffness, 0.4);
}

double hertz_time(double stiffness, const Impact& impact) {
  constexpr double constant = 2.94327518432470466;  // (4/5) √π Γ(2/5)/Γ(9/10)
  return constant * hertz_overlap(stiffness, impact) / impact.velocity;
}

double linear_stiffness(double hertz_stiffness, const Impact& impact, LinearMatch match) {
  const double root = match == LinearMatch::time ? pi / hertz_time(hertz_stiffness, impact)
                                                 : impact.velocity / hertz_overlap(hertz_stiffness, impact);
  return impact.mass_eff * root * root;
}

bool has_loss(LawKind law, const Loss& loss) noexcept {
  return with_loss(law, loss, false, [](auto, const auto&) { return true; });
}

double loss_limit(LawKind law, ContactEnd end, const Loss& loss) noexcept {
  return with_loss(law, loss, infinity, [&](auto of, const auto&) { return of.limit(end); });
}

std::optional<double> restitution(LawKind law, ContactEnd end, const Loss& loss) {
  if (const auto* kept = std::get_if<loss::Restitution>(&loss)) return value_of(*kept);
  const double value = std::visit([](const auto& measure) { return value_of(measure); }, loss);
  if (!has_loss(law, loss))
    throw std::invalid_argument("loss: must be a restitution for the law " + std::string(law.name()));
  const double en = with_loss(
      law, loss, 0.0, [&](auto of, const auto& measure) { return value < of.limit(end) ? of.en(measure, end) : 0; });
  return en > 0 ? std::optional(en) : std::nullopt;
}

std::optional<double> stiffness(LawKind law, const Scale& scale, const Impact& impact) {
  require_impact(impact);
  if (const auto* own = std::get_if<scale::Stiffness>(&scale)) {
    require_positive("stiffness", own->k);
    return own->k;
  }
  if (const auto* moduli = std::get_if<scale::Moduli>(&scale)) return stiffness_of(law, *moduli, impact);
  return std::nullopt;
}

std::optional<double> collision_time(LawKind law, ContactEnd end, const Scale& scale, double en, const Impact& impact,
                                     const Held& held) {
  const UnitLaws unit_laws = [&](LawKind kind, double kept, ContactEnd by) {
    const auto unit = unit_law(kind, kept, by, held);
    return unit ? std::optional(unit->law) : std::nullopt;
  };
  return collision_time(law, end, scale, en, impact, unit_laws);
}

std::optional<double> collision_time(LawKind law, ContactEnd end, const Scale& scale, double en, const Impact& impact,
                                     const UnitLaws& unit_laws) {
  require_impact(impact);
  if (const auto* time = std::get_if<scale::CollisionTime>(&scale)) {
    require_positive("tcol", time->tcol);
    return time->tcol;
  }
  std::optional<double> time;
  if (const auto* overlap = std::get_if<scale::MaxOverlap>(&scale)) {
    require_positive("max_overlap", overlap->length);
    if (const auto unit = unit_laws(law, en, end))
      time = overlap->length / (impact.velocity * collide(*unit, {1, 1}, {end}).max_overlap);
  } else {
    const double k = stiffness(law, scale, impact).value();
    // The fractional law's k is linear's.
    const bool held = law == kind_of<Fractional>;
    const auto unit = held ? unit_laws(kind_of<Linear>, en, ContactEnd::force) : unit_laws(law, en, end);
    if (unit) time = time_of(k, values(*unit).front(), LawKind::of(*unit).parameters().front().dimension, impact);
  }
  return time && std::isnormal(*time) ? time : std::nullopt;
}

}  // namespace ricochet
