#include "report.hpp"

#include <calibrate/given_law.hpp>
#include <calibrate/loaded.hpp>
#include <console/bound.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <cmath>

namespace ricochet::calibration {
namespace {

Outcome outcome_of(const Job& job, const Wanted& wanted, const Settings& settings) {
  if (job.given && job.load) return answer_under_load(*job.given, job.known.impact, *job.load);
  if (job.given) return answer(*job.given, wanted.end, job.known.impact);
  const auto asked = request_of(wanted.law, wanted.end, job.known);
  if (const auto* missed = std::get_if<Infeasible>(&asked)) return *missed;
  Request request = std::get<Request>(asked);
  if (holds_stiffness(wanted.law) && job.stiffness) request.stiffness = job.stiffness;
  Outcome outcome = job.load ? calibrate_under_load(request, *job.load, settings) : calibrate(request, settings);
  if (const auto* missed = std::get_if<Infeasible>(&outcome)) return in_terms_of(*missed, job.known.loss);
  return outcome;
}

std::string range_of(const Infeasible& missed) {
  if (missed.lowest == missed.highest) return console::shortest(missed.lowest);
  return fmt::format("in {}{}, {}{}", missed.low_open ? "(" : "[",
                     console::bound_text(console::Bound::lower, missed.lowest),
                     console::bound_text(console::Bound::upper, missed.highest), missed.open ? ")" : "]");
}

/// The tangential law of a result that was found, or why there is none.
std::variant<Tangential, Infeasible> tangential_of(const TangentialRequest& request, const Calibration& r) {
  const Target& target = r.request.target;
  const auto outcome = calibrate_tangential(request, r.law, r.end, target);
  if (const auto* missed = std::get_if<Infeasible>(&outcome)) return *missed;
  Tangential all{std::get<TangentialCalibration>(outcome)};
  if (!request.mu) return all;
  try {
    all.rebounds = rebounds(all.found.law, *request.mu, r.law, r.end, target.impact, usual_angles());
  } catch (const NotConverged&) {
    all.found.remarks.emplace_back(
        "no rebounds: c_t is so weak beside k_t that its spring relaxes too fast to be followed where the contact "
        "slides");
  }
  return all;
}

/// Adds a result, with its tangential law where one is asked for and can be.
void add(Report& report, const Calibration& result) {
  if (report.job.tangential) {
    const auto outcome = tangential_of(*report.job.tangential, result);
    if (const auto* missed = std::get_if<Infeasible>(&outcome)) {
      report.infeasible.push_back(*missed);
      return;
    }
    report.tangential.push_back(std::get<Tangential>(outcome));
  }
  report.results.push_back(result);
}

}  // namespace

Report run(const Job& job, const Settings& settings) {
  Report report{job, {}, {}};
  for (const Wanted& wanted : job.wanted) {
    try {
      const Outcome outcome = outcome_of(job, wanted, settings);
      if (const auto* result = std::get_if<Calibration>(&outcome)) add(report, *result);
      if (const auto* missed = std::get_if<Infeasible>(&outcome)) report.infeasible.push_back(*missed);
    } catch (const NotConverged& failure) {
      report.failed.push_back({wanted.law, wanted.end, failure.what()});
    }
  }
  report.infeasible.insert(report.infeasible.end(), job.left_out.begin(), job.left_out.end());
  return report;
}

std::optional<double> rayleigh_of(const Job& job) {
  const auto* moduli = std::get_if<scale::Moduli>(&job.known.scale);
  if (job.given || !moduli || !job.density || !job.radius) return std::nullopt;
  // Of two spheres of two materials nobody knows here which is the smaller one's.
  const bool one_material =
      moduli->first.young == moduli->second.young && moduli->first.poisson == moduli->second.poisson;
  if (!job.wall && !one_material) return std::nullopt;
  return rayleigh_time(*job.radius, *job.density, moduli->first.young / moduli->soften, moduli->first.poisson);
}

std::vector<EngineStep> steps_of(const Calibration& c, StepAdvisor& advisor) {
  if (c.request.target.en > 1 || c.under_load) return {};
  return advisor(c.law, c.end, c.request.target);
}

std::optional<double> asked_step_error(const Job& job, const Calibration& c) {
  if (!job.step) return std::nullopt;
  const Target& target = c.request.target;
  const double error = step_error(c.law, c.end, target, target.tcol / *job.step, stepping_of(c.law, c.end));
  return std::isfinite(error) ? std::optional(error) : std::nullopt;
}

std::string explained(const Infeasible& missed, Spelling spelling, const std::string& under) {
  if (missed.quantity.empty()) return missed.reason;
  return fmt::format("{} = {}: must be {}{}: {}", spelled(spelling, missed.quantity), console::shortest(missed.asked),
                     range_of(missed), under, missed.reason);
}

std::string render(const Report& report, console::Format format) {
  if (format == console::Format::json) return json_of(report);
  if (format == console::Format::csv) return csv_of(report).csv();
  return console::render_all(tables_of(report), format);
}

}  // namespace ricochet::calibration
