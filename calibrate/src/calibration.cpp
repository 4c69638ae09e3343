#include "confirmation.hpp"
#include "reach.hpp"
#include "solution.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::calibration {
namespace {

using support::require;
using support::significant;

void require_ordinary(const char* name, double value) {
  require(value >= least_scale && value <= greatest_scale, name, value, range_of_scales);
}

void require_settings(const Settings& settings) {
  require(settings.tolerance >= 1e-11 && settings.tolerance <= 0.1, "tolerance", settings.tolerance, "in [1e-11, 0.1]");
  const auto& known = algorithms();
  if (std::find(known.begin(), known.end(), settings.algorithm) == known.end()) {
    throw std::invalid_argument(
        fmt::format("algorithm = {}: must be one of {}", settings.algorithm, fmt::join(known, ", ")));
  }
}

/// k of the linear law that hits the target by force, what the paper gives the fractional law to hold.
double held_stiffness(const Request& request) {
  if (request.law != kind_of<Fractional>) return 0;
  if (request.stiffness) return *request.stiffness;
  const auto linear = unit_law(kind_of<Linear>, request.target.en, ContactEnd::force);
  const double unit = request.target.impact.mass_eff / (request.target.tcol * request.target.tcol);
  return std::get<Linear>(linear.value().law).k() * unit;
}

/// The direct solution, unless rounding keeps it from the tolerance.
std::optional<Solution> reduced(const Request& request, double tolerance) {
  const double en = request.target.en;
  const auto solved = unit_law(request.law, en, request.end, request.held);
  if (!solved || rounding_error(solved->law, request.end, en) > tolerance) return std::nullopt;
  return Solution{solved->law, solved->closed_form ? "closed form" : "bracketed root", solved->collisions};
}

/// The k that would give c^α k^{1−α} its value alone, at α = 0 [kg/s²].
double stiffness_alone(const Request& request, const Fractional& scaled) {
  return scaled.coefficient() * request.target.impact.mass_eff / (request.target.tcol * request.target.tcol);
}

/// Can the held k go with some c? A spring (α = 0) leaves it no choice.
bool fits(const Request& request, const AnyLaw& scaled, double held, double tolerance) {
  const auto* law = std::get_if<Fractional>(&scaled);
  return !law || law->alpha() > 0 || std::abs(held / stiffness_alone(request, *law) - 1) <= tolerance;
}

/// What the fractional law's held k must be for c^α k^{1−α} to take the value that the target asks for.
Infeasible unfit_stiffness(const Request& request, const Fractional& scaled, double held) {
  const double tcol = request.target.tcol, alpha = scaled.alpha(), elastic = stiffness_alone(request, scaled);
  if (alpha == 0)
    return {request.law, request.end, "at en = 1 the law is a spring (alpha = 0) and tcol alone fixes its k",
            "stiffness", held,        elastic,
            elastic};
  // ln c = ln t + ln(elastic)/α + (1 − 1/α) ln k falls with k, and must stay within the range of a double.
  const auto stiffness_at = [&](double log_c) {
    return std::exp((log_c - std::log(tcol) - std::log(elastic) / alpha) / (1 - 1 / alpha));
  };
  return {request.law,       request.end, "the c that goes with the k to hold is not a number that a double can carry",
          "stiffness",       held,        stiffness_at(700),
          stiffness_at(-700)};
}

/// k that the springs of either law have, which is all that is left of it at e_n = 1 [kg/s²].
double elastic_stiffness(const Target& target) {
  return std::pow(std::numbers::pi / target.tcol, 2) * target.impact.mass_eff;
}

/// The k of a Kelvin–Voigt law that no α goes with.
Infeasible unfit_degree(const Request& request) {
  const Target& target = request.target;
  Infeasible out{request.law, request.end, "at en = 1 the law is a spring and tcol alone fixes its k", "stiffness",
                 *request.stiffness};
  if (target.en == 1) {
    out.lowest = out.highest = elastic_stiffness(target);
    return out;
  }
  const auto linear = unit_law(request.law, target.en, request.end, {.alpha = 1});
  if (!linear) return out_of_reach(request, Settings{}.tolerance);
  out.reason = "as alpha goes from that of the fractional law to 1, the k that keeps en goes from 0 to linear's";
  out.highest = std::get<FractionalKelvinVoigt>(at_impact(linear->law, target.tcol, target.impact).value()).k();
  out.low_open = true;
  return out;
}

double greatest_relative_difference(const AnyLaw& law, const AnyLaw& other) {
  const auto ours = identifiable(law), theirs = identifiable(other);
  double greatest = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double size = std::max(std::abs(ours[i].value), std::abs(theirs[i].value));
    if (size > 0) greatest = std::max(greatest, std::abs(ours[i].value - theirs[i].value) / size);
  }
  return greatest;
}

/// Eq. (57), which is about the force's zero.
std::optional<double> estimate(const AnyLaw& law, const Impact& impact, ContactEnd end) {
  const auto* fractional = std::get_if<Fractional>(&law);
  if (fractional && end == ContactEnd::force)
    return tcol_estimate(fractional->coefficient() / impact.mass_eff, fractional->alpha());
  return std::nullopt;
}

/// Greatest relative miss of the target, 1 where the bodies do not part.
double miss(const Collision& out, double tcol, double en) {
  return out.separated() ? std::max(std::abs(out.tcol - tcol) / tcol, std::abs(out.en - en) / en) : 1;
}

/// How far the parameters of a law may be off where ln t_col and ln L, L = −ln e_n, are off by `tolerance`: they go
/// with t_col^{−2} at most, with L where little is lost, and where much is with e^{2L} at most.
double allowance(double tolerance, double en) { return tolerance * 2 * (1 - std::log(en)); }

/// Does a point of the search do what the search wanted of it?
bool hits(const Solution& found, const Request& request, double tolerance) {
  return miss(collide(found.law, {1, 1}, {request.end}), 1, request.target.en) <= tolerance;
}

std::string called(const Request& request) {
  return fmt::format("{}, ended by {}", request.law.name(), text(request.end));
}

/// Runs the answer through the numerical collision, and says so where that cannot confirm it to the tolerance.
void check(Calibration& out, const Request& request, double tolerance) {
  const auto& [tcol, en, impact] = request.target;
  out.achieved = collide(out.law, impact, {request.end, CollideMethod::numerical});
  const double bound = rounding_error(out.law, request.end, en) + numerical_error(request.law, request.end, en);
  if (!out.achieved.separated()) {
    const auto status = out.achieved.status;
    out.achieved = collide(out.law, impact, {request.end});
    if (status == CollisionStatus::no_separation || !out.achieved.separated())
      throw NotConverged(fmt::format("{}: the numerical collision does not part", called(request)));
    out.remarks.push_back("the numerical collision does not resolve so small an en; achieved is by the closed form");
  } else if (const double left = miss(out.achieved, tcol, en);
             confirmed(left, tolerance, bound) == Confirmation::missed) {
    throw NotConverged(
        fmt::format("{}: the numerical collision misses the target by {}", called(request), significant(left, 2)));
  } else if (confirmed(left, tolerance, bound) == Confirmation::within_error) {
    out.remarks.push_back(fmt::format("confirmed to {} only, within the numerical collision's own error of {}",
                                      significant(left, 2), significant(bound, 2)));
  }
  out.tcol_residual = (out.achieved.tcol - tcol) / tcol;
  out.en_residual = (out.achieved.en - en) / en;
}

/// A law in the units of the target brought to SI; `held` is the fractional law's k [kg/s²]. nullopt where a parameter,
/// such as the c that goes with the held k, is no normal double.
std::optional<AnyLaw> in_si(const AnyLaw& scaled, const Target& target, double held) {
  if (const auto* fractional = std::get_if<Fractional>(&scaled))
    return Reduction<Fractional>::holding(held, fractional->coefficient(), fractional->alpha(), target.tcol,
                                          target.impact.mass_eff);
  return at_impact(scaled, target.tcol, target.impact);
}

/// The direct solution in the units of the target.
std::variant<AnyLaw, Infeasible> of_target(const std::optional<Solution>& direct, const Request& request,
                                           double tolerance) {
  if (!direct) return out_of_reach(request, tolerance);
  const double held = held_stiffness(request);
  const auto law = in_si(direct->law, request.target, held);
  if (law && fits(request, direct->law, held, tolerance)) return *law;
  const auto* fractional = std::get_if<Fractional>(&direct->law);
  return fractional ? unfit_stiffness(request, *fractional, held) : out_of_reach(request, tolerance);
}

}  // namespace

std::optional<AnyLaw> brought_to(const AnyLaw& scaled, const Request& request) {
  return in_si(scaled, request.target, held_stiffness(request));
}

void require_request(const Request& request) {
  const auto& [tcol, en, impact] = request.target;
  require_ordinary("tcol", tcol);
  require(en > 0 && en <= 1, "en", en, "in (0, 1]");
  require_ordinary("velocity", impact.velocity);
  require_ordinary("mass_eff", impact.mass_eff);
  if (request.stiffness) require_ordinary("stiffness", *request.stiffness);
  require(domains::degree.contains(request.held.alpha), "alpha", request.held.alpha, domains::degree.accepted);
  require_ordinary("stiffening", request.held.stiffening);
  if (!request.law.ends().offer(request.end))
    throw std::invalid_argument(fmt::format("end = {}: must be {} for the law {}", text(request.end),
                                            request.end == ContactEnd::force ? "overlap" : "force",
                                            request.law.name()));
}

std::variant<Request, Infeasible> with_degree(const Request& request) {
  const auto& [tcol, en, impact] = request.target;
  if (request.law != kind_of<FractionalKelvinVoigt> || !request.stiffness) return request;
  const double k = *request.stiffness * tcol * tcol / impact.mass_eff;
  if (en == 1 && std::abs(*request.stiffness / elastic_stiffness(request.target) - 1) < 1e-10) return request;
  const auto alpha = Reduction<FractionalKelvinVoigt>::degree(k, en, request.end);
  if (!alpha) return unfit_degree(request);
  Request found = request;
  found.held.alpha = *alpha;
  return found;
}

std::variant<AnyLaw, Infeasible> calibrate_directly(const Request& asked, double tolerance) {
  const auto request = with_degree(asked);
  if (const auto* missed = std::get_if<Infeasible>(&request)) return *missed;
  return of_target(reduced(std::get<Request>(request), tolerance), std::get<Request>(request), tolerance);
}

Outcome calibrate(const Request& asked, const Settings& settings) {
  require_request(asked);
  require_settings(settings);
  const auto whole = with_degree(asked);
  if (const auto* missed = std::get_if<Infeasible>(&whole)) return *missed;
  const Request& request = std::get<Request>(whole);
  const auto direct = reduced(request, settings.tolerance);
  const auto law = of_target(direct, request, settings.tolerance);
  if (const auto* missed = std::get_if<Infeasible>(&law)) return *missed;
  const Solution found = search(request, settings.algorithm, settings.tolerance);
  const auto found_law = in_si(found.law, request.target, held_stiffness(request));
  const bool hit = found_law && hits(found, request, settings.tolerance);
  const double apart = greatest_relative_difference(direct->law, found.law);
  const bool agrees = apart <= allowance(settings.tolerance, request.target.en);
  const bool by_search = settings.method == Method::nlopt && hit && agrees;
  const Solution& chosen = by_search ? found : direct.value();
  Calibration out{.request = request,
                  .law = by_search ? *found_law : std::get<AnyLaw>(law),
                  .end = request.end,
                  .achieved = {},
                  .tcol_residual = 0,
                  .en_residual = 0,
                  .tcol_estimate = {},
                  .method = by_search ? Method::nlopt : Method::direct,
                  .algorithm = chosen.algorithm,
                  .evaluations = chosen.evaluations,
                  .cross_method = by_search ? Method::direct : Method::nlopt,
                  .cross_difference = apart};
  out.tcol_estimate = estimate(out.law, request.target.impact, request.end);
  const bool searched = settings.method == Method::nlopt;
  if (!hit)
    out.remarks.push_back(searched
                              ? fmt::format("{} missed the tolerance; the direct solution is answered", found.algorithm)
                              : fmt::format("the cross-check by {} missed the tolerance", found.algorithm));
  else if (!agrees)
    out.remarks.push_back(
        fmt::format("so many laws meet the target within rounding that {} is off by {} in a parameter{}",
                    found.algorithm, significant(apart, 2), searched ? "; the direct solution is answered" : ""));
  check(out, request, settings.tolerance);
  return out;
}

}  // namespace ricochet::calibration
