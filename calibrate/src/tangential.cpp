#include <calibrate/tangential.hpp>

#include "mindlin_spring.hpp"
#include "tangential_search.hpp"

#include <ricochet/collision/scale_and_loss.hpp>
#include <ricochet/collision/tangential_restitution.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace ricochet::calibration {
namespace {

using std::numbers::pi;

/// An elastic spring whose repulsion lasts t_col: what sticks does not know the normal law.
Linear lasting(double tcol, double mass_eff) { return Linear(mass_eff * std::pow(pi / tcol, 2), 0); }

/// Says where the contact itself does otherwise than one that sticks for all of t_col.
void tell_of_end(TangentialCalibration& out, ContactEnd end) {
  const bool overlap = end == ContactEnd::overlap;
  if (std::abs(out.achieved - out.beta0) < (overlap ? 1e-9 : 1e-6)) return;
  out.remarks.push_back(
      fmt::format("beta0 is that of a contact that sticks for all of tcol; this one's repulsion{}, where beta0 is {}",
                  overlap ? ", and friction with it, ends before its overlap does"
                          : fmt::format(" falls so low before it ends that even friction of mu = {} slides",
                                        support::shortest(endless_friction)),
                  support::significant(out.achieved, 4)));
}

/// The search's difference, and a remark where it is more than the collision's own error explains.
void cross_check(TangentialCalibration& out, const Searched& found) {
  out.cross_difference = apart(out.law, found.law);
  if (*out.cross_difference <= 1e-6) return;
  out.remarks.push_back(fmt::format(
      "the search ends at parameters that differ by up to {} and miss by {}: beta0 hardly tells them from these",
      support::significant(*out.cross_difference, 1), support::significant(found.miss, 1)));
}

TangentialOutcome of_linear_form(const TangentialRequest& request, const AnyLaw& normal, ContactEnd end,
                                 const Target& target) {
  const double beta0 = *request.beta0, m = target.impact.mass_eff;
  if (auto missed = out_of_form(request.form, beta0, LawKind::of(normal), end)) return *missed;
  const auto form = request.form == TangentialForm::linear ? StickingForm::damped : StickingForm::undamped;
  const LinearTangential law = tangential_for(beta0, target.tcol, m, form);
  TangentialCalibration out{.form = request.form, .law = law, .mu = request.mu, .beta0 = beta0};
  out.algorithm = "closed form";
  out.achieved = Sticking(normal, end, target.impact, target.tcol)(law).beta;
  const AnyLaw elastic = lasting(target.tcol, m);
  const Sticking stuck(elastic, ContactEnd::force, target.impact, target.tcol);
  const double unit_k = stuck.mass() / (target.tcol * target.tcol);
  // Without a dashpot β₀ = −cos(√(k_t/m_t) t_col) falls again beyond half a period.
  const double highest = form == StickingForm::undamped ? 2 * std::log(pi) : std::numeric_limits<double>::infinity();
  cross_check(out, searched(request.form, beta0, unit_k, law, highest, stuck));
  out.evaluations = stuck.evaluations();
  return out;
}

TangentialOutcome of_mindlin(const TangentialRequest& request, const AnyLaw& normal, ContactEnd end,
                             const Target& target) {
  const Sticking stuck(normal, end, target.impact, target.tcol);
  TangentialCalibration out{.form = request.form, .law = MindlinTangential(1), .mu = request.mu};
  if (!request.beta0) {
    out.law = MindlinTangential(request.mindlin.value());
    out.achieved = out.beta0 = stuck(out.law).beta;
    out.algorithm = "moduli";
    return out;
  }
  out.beta0 = *request.beta0;
  out.algorithm = "bracketed root";
  if (request.mindlin) {
    const auto found = dashpot_for(out.beta0, *request.mindlin, normal, end, stuck);
    if (const auto* missed = std::get_if<Infeasible>(&found)) return *missed;
    out.law = std::get<MindlinTangential>(found);
    out.achieved = stuck(out.law).beta;
    return out;
  }
  const double deepest = collide(normal, target.impact, {.end = end}).max_overlap;
  const double unit_k = stuck.mass() / (target.tcol * target.tcol * std::sqrt(deepest));
  const auto found = spring_for(out.beta0, normal, end, stuck, unit_k);
  if (const auto* missed = std::get_if<Infeasible>(&found)) return *missed;
  const auto& spring = std::get<MindlinSpring>(found);
  out.law = spring.law;
  out.achieved = stuck(out.law).beta;
  const Sticking again(normal, end, target.impact, target.tcol);
  cross_check(out, searched(request.form, out.beta0, unit_k, out.law, spring.log_top, again));
  out.evaluations = again.evaluations();
  return out;
}

}  // namespace

std::string_view text(TangentialForm form) noexcept {
  constexpr std::string_view words[] = {"linear", "linear-undamped", "mindlin"};
  return words[static_cast<std::size_t>(form)];
}

std::optional<TangentialForm> tangential_form(std::string_view name) noexcept {
  for (const auto form : {TangentialForm::linear, TangentialForm::undamped, TangentialForm::mindlin})
    if (text(form) == name) return form;
  return std::nullopt;
}

std::optional<Infeasible> out_of_form(TangentialForm form, double beta0, LawKind normal, ContactEnd end) {
  if (form == TangentialForm::mindlin) return std::nullopt;
  const bool damped = form == TangentialForm::linear;
  const double lowest = damped ? 0 : -1;
  if (beta0 > lowest && beta0 <= 1) return std::nullopt;
  return Infeasible{.law = normal,
                    .end = end,
                    .reason = damped ? "a spring and a dashpot after half a period; linear-undamped goes down to -1"
                                     : "-1 is no spring at all, 1 a full reversal",
                    .quantity = "beta0",
                    .asked = beta0,
                    .lowest = lowest,
                    .highest = 1,
                    .low_open = true};
}

std::span<const Parameter> parameters_of(TangentialForm form) noexcept {
  if (form == TangentialForm::mindlin) return MindlinTangential::parameters;
  return LinearTangential::parameters;
}

double mindlin_stiffness(double young, double poisson, double young2, double poisson2, double radius_eff) {
  contact_modulus({young, poisson}, {young2, poisson2});  // which checks the moduli
  support::require_positive("radius_eff", radius_eff);
  const auto softness = [](double e, double nu) { return (2 - nu) * 2 * (1 + nu) / e; };
  return 8 / (softness(young, poisson) + softness(young2, poisson2)) * std::sqrt(radius_eff);
}

TangentialOutcome calibrate_tangential(const TangentialRequest& request, const AnyLaw& normal, ContactEnd end,
                                       const Target& target) {
  if (request.mu) support::require_not_negative("mu", *request.mu);
  if (!request.beta0 && !(request.form == TangentialForm::mindlin && request.mindlin))
    throw std::invalid_argument("beta0: missing: must be given");
  TangentialOutcome outcome = request.form == TangentialForm::mindlin ? of_mindlin(request, normal, end, target)
                                                                      : of_linear_form(request, normal, end, target);
  if (auto* found = std::get_if<TangentialCalibration>(&outcome)) tell_of_end(*found, end);
  return outcome;
}

}  // namespace ricochet::calibration
