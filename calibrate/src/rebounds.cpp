#include "sticking.hpp"

#include <calibrate/tangential.hpp>
#include <ricochet/collision/reduction.hpp>
#include <ricochet/support/require.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ricochet::calibration {

using std::numbers::pi;

std::vector<double> usual_angles() {
  std::vector<double> angles;
  angles.reserve(17);
  for (int degrees = 5; degrees <= 85; degrees += 5) angles.push_back(degrees * pi / 180);
  return angles;
}

std::vector<ObliqueRebound> rebounds(const TangentialLaw& law, double mu, const AnyLaw& normal, ContactEnd end,
                                     const Impact& impact, std::span<const double> angles) {
  const TangentialContact contact = contact_of(law, mu);
  std::vector<ObliqueRebound> all;
  all.reserve(angles.size());
  for (const double angle : angles) {
    support::require(angle > 0 && angle < pi / 2, "angle", angle, "in (0, pi/2)");
    const auto out = collide(normal, contact, impact_at(impact, impact.velocity * std::tan(angle)), {.end = end});
    if (!out.separated()) throw NotConverged("the oblique collision could not be followed");
    all.push_back({.angle = angle,
                   .et = out.et.value(),
                   .beta = out.beta.value(),
                   .rebound_angle = std::atan2(out.velocity_i.x, -out.velocity_i.z),
                   .impulse_ratio = out.impulse_ratio});
  }
  return all;
}

namespace {

/// e_t over the angles of a changed target and request; the tangential law as it is found for them, or `held`.
std::vector<double> changed(const TangentialRequest& request, LawKind kind, ContactEnd end, const Target& target,
                            std::span<const double> angles, const TangentialLaw* held) {
  const auto unit = unit_law(kind, target.en, end);
  const auto normal = unit ? at_impact(unit->law, target.tcol, target.impact) : std::nullopt;
  if (!normal) throw std::invalid_argument("no double carries the changed law");
  TangentialLaw law = RigidTangential{};
  if (held) {
    law = *held;
  } else {
    const TangentialOutcome found = calibrate_tangential(request, *normal, end, target);
    if (!std::holds_alternative<TangentialCalibration>(found)) throw std::invalid_argument("beta0 at its end");
    law = std::get<TangentialCalibration>(found).law;
  }
  std::vector<double> all;
  for (const ObliqueRebound& r : rebounds(law, request.mu.value(), *normal, end, target.impact, angles))
    all.push_back(r.et);
  return all;
}

}  // namespace

std::vector<ObliqueSensitivity> sensitivities(const TangentialCalibration& found, const TangentialRequest& request,
                                              LawKind normal, ContactEnd end, const Target& target,
                                              std::span<const double> angles) {
  constexpr double share = 1e-3, percent = 0.01 / (2 * share);
  std::vector<ObliqueSensitivity> all;
  for (const double angle : angles) all.push_back({.angle = angle});
  const auto add = [&](double ObliqueSensitivity::*member, const TangentialLaw* held, auto change) {
    TangentialRequest up = request, down = request;
    Target target_up = target, target_down = target;
    change(up, target_up, 1 + share);
    change(down, target_down, 1 - share);
    const auto above = changed(up, normal, end, target_up, angles, held);
    const auto below = changed(down, normal, end, target_down, angles, held);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].*member = percent * (above[i] - below[i]);
  };
  const TangentialLaw* law = &found.law;
  add(&ObliqueSensitivity::tcol, law, [](TangentialRequest&, Target& t, double factor) { t.tcol *= factor; });
  add(&ObliqueSensitivity::en, law, [](TangentialRequest&, Target& t, double factor) { t.en *= factor; });
  add(&ObliqueSensitivity::mu, law, [](TangentialRequest& r, Target&, double factor) { *r.mu *= factor; });
  if (request.beta0 && *request.beta0 != 0)
    add(&ObliqueSensitivity::beta0, nullptr, [](TangentialRequest& r, Target&, double factor) { *r.beta0 *= factor; });
  return all;
}

}  // namespace ricochet::calibration
