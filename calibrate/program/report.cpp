#include "report.hpp"

#include <calibrate/given_law.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

namespace ricochet::calibration {
namespace {

Outcome outcome_of(const Job& job, const Wanted& wanted, const Settings& settings) {
  if (job.given) return answer(*job.given, wanted.end, job.known.impact);
  const auto asked = request_of(wanted.law, wanted.end, job.known);
  if (const auto* missed = std::get_if<Infeasible>(&asked)) return *missed;
  Request request = std::get<Request>(asked);
  if (wanted.law == kind_of<Fractional> && job.stiffness) request.stiffness = job.stiffness;
  return calibrate(request, settings);
}

}  // namespace

Report run(const Job& job, const Settings& settings) {
  Report report{job, {}, {}};
  for (const Wanted& wanted : job.wanted) {
    try {
      const Outcome outcome = outcome_of(job, wanted, settings);
      if (const auto* result = std::get_if<Calibration>(&outcome)) report.results.push_back(*result);
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

std::vector<EngineStep> steps_of(const Calibration& c) {
  if (c.request.target.en > 1) return {};
  return engine_steps(c.law, c.end, c.request.target);
}

std::string explained(const Infeasible& missed) {
  if (missed.quantity.empty()) return missed.reason;
  using console::significant;
  const std::string range = missed.lowest == missed.highest ? console::shortest(missed.lowest)
                                                            : fmt::format("in [{}, {}]", significant(missed.lowest, 6),
                                                                          significant(missed.highest, 6));
  return fmt::format("{} = {}: must be {}: {}", missed.quantity, console::shortest(missed.asked), range, missed.reason);
}

std::string render(const Report& report, console::Format format) {
  if (format == console::Format::json) return json_of(report);
  if (format == console::Format::csv) return csv_of(report).csv();
  return console::render_all(tables_of(report), format);
}

}  // namespace ricochet::calibration
