#include <calibrate/given_law.hpp>

#include "solution.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::calibration {
namespace {

/// Laws with closed forms are followed numerically as well; the others have only been so.
void confirm(const AnyLaw& law, const Impact& impact, const Collision& known, ContactEnd end) {
  const Collision other = collide(law, impact, {end, CollideMethod::numerical});
  if (!other.separated()) return;  // what so small an e_n or so great a damping hides from it
  const double apart =
      std::max(std::abs(other.tcol / known.tcol - 1), known.en > 0 ? std::abs(other.en / known.en - 1) : 0);
  const double bound = rounding_error(law, end, known.en) + numerical_error(LawKind::of(law), end, known.en);
  if (apart > std::max(1e-10, bound))
    throw NotConverged(fmt::format("{}, ended by {}: closed form and numerical collision differ by {}", name(law),
                                   text(end), support::significant(apart, 2)));
}

std::string what_happened(const Collision& out) {
  if (out.status == CollisionStatus::no_separation) return "the bodies do not part so: too much damping for this end";
  if (out.status == CollisionStatus::permanent_contact)
    return fmt::format("the bodies stay together: a permanent contact, at rest to 1 % after {} s",
                       support::significant(out.tcol, 6));
  return "the collision leaves the range of doubles";
}

}  // namespace

Held held_of(const AnyLaw& law) {
  Held held;
  if (const auto* l = std::get_if<FractionalKelvinVoigt>(&law)) held.alpha = l->alpha();
  if (const auto* l = std::get_if<FractionalHertz>(&law)) held.alpha = l->alpha();
  if (const auto* l = std::get_if<FractionalZener>(&law)) held = {l->alpha(), l->k1() / l->k()};
  return held;
}

Outcome answer(const AnyLaw& law, ContactEnd asked, const Impact& impact) {
  const LawKind kind = LawKind::of(law);
  // Below α = 0 the force repels until the overlap is gone, whatever is asked for.
  const auto* const gains = std::get_if<Fractional>(&law);
  const ContactEnd end = gains && gains->alpha() < 0 ? ContactEnd::overlap : asked;
  require_request({kind, end, {1, 1, impact}});
  const Collision out = collide(law, impact, {end});
  if (out.status == CollisionStatus::budget_spent)
    throw NotConverged(
        fmt::format("{}, ended by {}: the numerical collision does not come to an end", name(law), text(end)));
  if (!out.separated()) return Infeasible{kind, end, what_happened(out), "", 0, 0, 0};
  confirm(law, impact, out, end);
  Calibration answer{.request = {kind, end, {out.tcol, out.en, impact}},
                     .law = law,
                     .end = end,
                     .achieved = out,
                     .tcol_residual = 0,
                     .en_residual = 0,
                     .tcol_estimate = {},
                     .method = Method::direct,
                     .algorithm = out.evaluations ? "numerical collision" : "closed form",
                     .evaluations = 1,
                     .cross_method = Method::direct,
                     .cross_difference = 0};
  answer.request.held = held_of(law);
  const auto* fractional = std::get_if<Fractional>(&law);
  if (out.en > 1) answer.remarks.push_back("it leaves faster than it came: below alpha = 0 the law makes energy");
  if (fractional) answer.request.stiffness = fractional->k();
  if (fractional && end == ContactEnd::force && fractional->alpha() >= 0)
    answer.tcol_estimate = tcol_estimate(fractional->coefficient() / impact.mass_eff, fractional->alpha());
  return answer;
}

}  // namespace ricochet::calibration
