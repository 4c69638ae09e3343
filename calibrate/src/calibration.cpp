#include "solution.hpp"

#include <ricochet/contact/fractional_contact.hpp>
#include <ricochet/detail/require.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::calibration {
namespace {

using detail::require;

/// SI values whose powers and products stay within the range of a double.
void require_ordinary(const char* name, double value) {
  require(value >= 1e-30 && value <= 1e30, name, value, "in [1e-30, 1e30]");
}

void require_settings(const Settings& settings) {
  require(settings.tolerance >= 1e-11 && settings.tolerance <= 0.1, "tolerance", settings.tolerance, "in [1e-11, 0.1]");
  const auto& known = algorithms();
  if (std::find(known.begin(), known.end(), settings.algorithm) == known.end()) {
    std::string list;
    for (const auto& name : known) list += (list.empty() ? "" : ", ") + name;
    throw std::invalid_argument("algorithm = " + settings.algorithm + ": must be one of " + list);
  }
}

/// k of the linear law that hits the target by force, what the paper gives the fractional law to hold.
double held_stiffness(const Request& request) {
  if (request.stiffness) return *request.stiffness;
  const auto linear = solve_directly(LawName::linear, ContactEnd::force, request.target.en);
  const double unit = request.target.impact.mass_eff / (request.target.tcol * request.target.tcol);
  return std::exp(linear.value().x.scale) * unit;
}

/// The law of the direct reduction, where the numerical collision confirms that it hits the target to the tolerance.
std::optional<Solution> reduced(const Request& request, double en, double tolerance) {
  const auto solved = solve_directly(request.law, request.end, en);
  if (!solved) return std::nullopt;
  const auto out = collide(scaled_law(request.law, solved->x), {1, 1}, {request.end, CollideMethod::numerical});
  // With room to spare, so that what is called reachable does not hang on the luck of the last digits.
  const double share = 0.25 * tolerance;
  const bool hit = out.separated() && std::abs(out.tcol - 1) <= share && std::abs(out.en - en) <= share * en;
  return hit ? solved : std::nullopt;
}

/// The smallest e_n that `reduced` reaches, by bisection of ln e_n.
Infeasible out_of_reach(const Request& request, double tolerance) {
  double missed = std::log(request.target.en), reached = 0;
  for (int halving = 0; halving < 20; ++halving) {
    const double middle = 0.5 * (missed + reached);
    (reduced(request, std::exp(middle), tolerance) ? reached : missed) = middle;
  }
  return {request.law, request.end, "nearer to the end of its range, rounding keeps the law from the tolerance", "en",
          request.target.en, std::exp(reached), 1};
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
    return {request.law, request.end, "at en = 1 the law is a spring (alpha = 0) and tcol alone fixes its k", "stiffness",
            held, elastic, elastic};
  // ln c = ln t + ln(elastic)/α + (1 − 1/α) ln k falls with k, and must stay within the range of a double.
  const auto stiffness_at = [&](double log_c) {
    return std::exp((log_c - std::log(tcol) - std::log(elastic) / alpha) / (1 - 1 / alpha));
  };
  return {request.law, request.end, "the c that goes with the k to hold is not a number that a double can carry",
          "stiffness", held, stiffness_at(700), stiffness_at(-700)};
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

/// The chosen solution in SI, run through the numerical collision and held against the other one.
Calibration checked(const Request& request, const Settings& settings, const AnyLaw& law, const Solution& chosen,
                    double cross_difference) {
  const auto& [tcol, en, impact] = request.target;
  Calibration out{law, request.end, collide(law, impact, {request.end, CollideMethod::numerical}), 0, 0,
                  estimate(law, impact, request.end), settings.method, chosen.algorithm, chosen.evaluations,
                  settings.method == Method::nlopt ? Method::direct : Method::nlopt, cross_difference};
  out.tcol_residual = (out.achieved.tcol - tcol) / tcol;
  out.en_residual = (out.achieved.en - en) / en;
  if (!out.achieved.separated() || std::abs(out.tcol_residual) > settings.tolerance ||
      std::abs(out.en_residual) > settings.tolerance)
    throw NotConverged(std::string(text(request.law)) + ", ended by " + std::string(text(request.end)) + ": " +
                       chosen.algorithm + " missed the tolerance");
  return out;
}

}  // namespace

void require_request(const Request& request) {
  const auto& [tcol, en, impact] = request.target;
  require_ordinary("tcol", tcol);
  require(en > 0 && en <= 1, "en", en, "in (0, 1]");
  require_ordinary("velocity", impact.velocity);
  require_ordinary("mass_eff", impact.mass_eff);
  if (request.stiffness) require_ordinary("stiffness", *request.stiffness);
  if (!offers(request.law, request.end))
    throw std::invalid_argument("end = " + std::string(text(request.end)) + ": must be " +
                                (request.end == ContactEnd::force ? "overlap" : "force") + " for the law " +
                                std::string(text(request.law)));
}

std::variant<AnyLaw, Infeasible> calibrate_directly(const Request& request, double tolerance) {
  const auto direct = reduced(request, request.target.en, tolerance);
  if (!direct) return out_of_reach(request, tolerance);
  const AnyLaw scaled = scaled_law(request.law, direct->x);
  const double held = request.law == LawName::fractional ? held_stiffness(request) : 0;
  const auto law = in_si(scaled, request.target, held);
  if (!law || !fits(request, scaled, held, tolerance))
    return unfit_stiffness(request, std::get<Fractional>(scaled), held);
  return *law;
}

Outcome calibrate(const Request& request, const Settings& settings) {
  require_request(request);
  require_settings(settings);
  const double en = request.target.en;
  const auto direct = reduced(request, en, settings.tolerance);
  if (!direct) return out_of_reach(request, settings.tolerance);
  const Solution found = search(request.law, request.end, en, settings.algorithm, settings.tolerance);

  const double held = request.law == LawName::fractional ? held_stiffness(request) : 0;
  const auto& chosen = settings.method == Method::nlopt ? found : *direct;
  const auto& other = settings.method == Method::nlopt ? *direct : found;
  const auto law = in_si(scaled_law(request.law, chosen.x), request.target, held);
  const auto cross = in_si(scaled_law(request.law, other.x), request.target, held);
  if (!law || !cross || !fits(request, scaled_law(request.law, direct->x), held, settings.tolerance))
    return unfit_stiffness(request, std::get<Fractional>(scaled_law(request.law, chosen.x)), held);
  return checked(request, settings, *law, chosen, greatest_relative_difference(*law, *cross));
}

}  // namespace ricochet::calibration
