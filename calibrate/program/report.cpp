#include "report.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

namespace ricochet::calibration {
namespace {

Infeasible not_offered(LawKind law) {
  return {law, ContactEnd::overlap, "the law is calibrated for a contact ended by force only", "", 0, 0, 0};
}

}  // namespace

Report run(const Job& job, const Settings& settings) {
  Report report{job, {}, {}};
  for (const auto& request : job.requests) {
    try {
      const Outcome outcome = calibrate(request, settings);
      if (const auto* result = std::get_if<Calibration>(&outcome)) {
        report.results.push_back(*result);
        report.steps.push_back(engine_steps(result->law, result->end, request.target));
      }
      if (const auto* missed = std::get_if<Infeasible>(&outcome)) report.infeasible.push_back(*missed);
    } catch (const NotConverged& failure) {
      report.failed.push_back({request.law, request.end, failure.what()});
    }
  }
  for (const auto law : job.left_out) report.infeasible.push_back(not_offered(law));
  return report;
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
