#include <calibrate/known.hpp>

#include "reach.hpp"

#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace ricochet::calibration {
namespace {

double value_of(const Loss& loss) {
  struct Value {
    double operator()(const loss::Restitution& l) const { return l.en; }
    double operator()(const loss::LossFactor& l) const { return l.tan_delta; }
    double operator()(const loss::DampingRatio& l) const { return l.ratio; }
    double operator()(const loss::ConversionDegree& l) const { return l.alpha; }
  };
  return std::visit(Value{}, loss);
}

/// The measure of loss that comes to this e_n.
double measure_of(const Loss& loss, double en, ContactEnd end) {
  struct Measure {
    double en;
    ContactEnd end;
    double operator()(const loss::Restitution&) const { return en; }
    double operator()(const loss::LossFactor&) const {
      return std::tan(std::numbers::pi / 2 * conversion_degree(en, end));
    }
    double operator()(const loss::DampingRatio&) const { return damping_of_restitution(en, end); }
    double operator()(const loss::ConversionDegree&) const { return conversion_degree(en, end); }
  };
  return std::visit(Measure{en, end}, loss);
}

/// To six digits, downwards: what is told of a range can be reached.
double rounded_down(double x) {
  const double unit = std::pow(10, 5 - std::floor(std::log10(x)));
  return std::isfinite(unit) ? std::floor(x * unit) / unit : x;
}

Request request_for(LawKind law, ContactEnd end, const Known& known, const Target& target) {
  return {.law = law, .end = end, .target = target, .held = known.held};
}

/// The loss is more than the law can have and yet end so, or leaves no number of the velocity.
Infeasible lost(LawKind law, ContactEnd end, const Known& known) {
  const double limit = loss_limit(law, end, known.loss);
  if (value_of(known.loss) < limit) {
    constexpr double least = 1e-300;
    return in_terms_of(out_of_reach(request_for(law, end, known, {1, least, known.impact}), Settings{}.tolerance),
                       known.loss);
  }
  return {.law = law,
          .end = end,
          .reason = "from there on the overlap never returns to zero",
          .quantity = std::string(name(known.loss)),
          .asked = value_of(known.loss),
          .lowest = 0,
          .highest = limit,
          .open = true};
}

double value_of(const Scale& scale) {
  struct Value {
    double operator()(const scale::CollisionTime& s) const { return s.tcol; }
    double operator()(const scale::Stiffness& s) const { return s.k; }
    double operator()(const scale::Moduli& s) const { return s.first.young; }
    double operator()(const scale::MaxOverlap& s) const { return s.length; }
  };
  return std::visit(Value{}, scale);
}

void require_time(const Scale& scale, double tcol) {
  if (tcol >= least_scale && tcol <= greatest_scale) return;
  support::reject(
      name(scale), value_of(scale),
      fmt::format("such that the collision time is {} s, not {}", range_of_scales, support::significant(tcol, 3)));
}

std::variant<Request, Infeasible> request_with(LawKind law, ContactEnd end, const Known& known,
                                               const UnitLaws& unit_laws) {
  const auto en = restitution(law, end, known.loss);
  if (!en) return lost(law, end, known);
  const auto tcol = collision_time(law, end, known.scale, *en, known.impact, unit_laws);
  if (!tcol)
    return in_terms_of(out_of_reach(request_for(law, end, known, {1, *en, known.impact}), Settings{}.tolerance),
                       known.loss);
  require_time(known.scale, *tcol);
  Request request = request_for(law, end, known, {*tcol, *en, known.impact});
  if (law == kind_of<Fractional>) request.stiffness = stiffness(law, known.scale, known.impact);
  return request;
}

}  // namespace

double sphere_mass(double radius, double density) noexcept {
  return 4 * std::numbers::pi / 3 * radius * radius * radius * density;
}

std::string_view name(const Scale& scale) noexcept {
  constexpr std::array<std::string_view, std::variant_size_v<Scale>> names{"tcol", "stiffness", "young", "max_overlap"};
  return names[scale.index()];
}

std::string_view name(const Loss& loss) noexcept {
  constexpr std::array<std::string_view, std::variant_size_v<Loss>> names{"en", "loss_factor", "damping_ratio",
                                                                          "alpha"};
  return names[loss.index()];
}

Infeasible in_terms_of(Infeasible missed, const Loss& loss) {
  if (missed.quantity != "en" || std::holds_alternative<loss::Restitution>(loss)) return missed;
  missed.quantity = name(loss);
  missed.asked = value_of(loss);
  missed.highest = rounded_down(measure_of(loss, missed.lowest, missed.end));
  missed.lowest = 0;
  return missed;
}

std::variant<Request, Infeasible> request_of(LawKind law, ContactEnd end, const Known& known) {
  return request_with(law, end, known, [&](LawKind kind, double en, ContactEnd by) {
    const auto unit = unit_law(kind, en, by, known.held);
    return unit ? std::optional(unit->law) : std::nullopt;
  });
}

std::variant<Request, Infeasible> request_of(LawKind law, ContactEnd end, const Known& known,
                                             const DirectCalibrator& calibrator) {
  return request_with(law, end, known, [&](LawKind kind, double en, ContactEnd by) {
    const auto unit = calibrator(request_for(kind, by, known, {1, en, {1, 1}}));
    const auto* found = std::get_if<AnyLaw>(&unit);
    return found ? std::optional(*found) : std::nullopt;
  });
}

Outcome calibrate(LawKind law, ContactEnd end, const Known& known, const Settings& settings) {
  const auto request = request_of(law, end, known);
  if (const auto* missed = std::get_if<Infeasible>(&request)) return *missed;
  Outcome outcome = calibrate(std::get<Request>(request), settings);
  if (const auto* missed = std::get_if<Infeasible>(&outcome)) return in_terms_of(*missed, known.loss);
  return outcome;
}

}  // namespace ricochet::calibration
