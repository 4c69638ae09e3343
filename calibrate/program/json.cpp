#include "report.hpp"

#include <console/json.hpp>

namespace ricochet::calibration {
namespace {

using console::Json;

Json units_of(const AnyLaw& law) {
  Json units = Json::object();
  for (const auto& p : parameters(law))
    if (!p.unit.empty()) units[p.name] = p.unit;
  return units;
}

Json named_values(const std::vector<NamedValue>& values) {
  Json object = Json::object();
  for (const auto& p : values) object[p.name] = p.value;
  return object;
}

Json identifiable_names(const AnyLaw& law) {
  Json names = Json::array();
  for (const auto& p : identifiable(law)) names.push_back(p.name);
  return names;
}

Json json_of(const Calibration& r) {
  Json out;
  out["law"] = name(r.law);
  out["end"] = text(r.end);
  out["parameters"] = named_values(parameters(r.law));
  out["units"] = units_of(r.law);
  out["achieved"] = {{"tcol", r.achieved.tcol}, {"en", r.achieved.en}};
  out["residual"] = {{"tcol", r.tcol_residual}, {"en", r.en_residual}};
  out["max_overlap"] = r.achieved.max_overlap;
  out["max_force"] = r.achieved.max_force;
  out["overlap_end"] = r.achieved.overlap_end;
  if (r.tcol_estimate) out["tcol_estimate"] = *r.tcol_estimate;
  out["evaluations"] = r.evaluations;
  out["method"] = text(r.method);
  out["algorithm"] = r.algorithm;
  out["cross_check"] = {{"method", text(r.cross_method)}, {"max_relative_difference", r.cross_difference}};
  out["identifiable"] = identifiable_names(r.law);
  if (!r.remarks.empty()) out["remarks"] = r.remarks;
  return out;
}

Json json_of(const std::vector<EngineStep>& steps) {
  Json all = Json::array();
  for (const EngineStep& s : steps)
    all.push_back({{"engine", s.engine}, {"error_en", s.error_en}, {"step", s.step ? Json(*s.step) : Json()}});
  return all;
}

Json json_of(const Infeasible& missed) {
  Json reachable = Json::object();
  if (!missed.quantity.empty()) reachable[missed.quantity] = {missed.lowest, missed.highest};
  return {{"law", missed.law.name()}, {"end", text(missed.end)}, {"reason", missed.reason}, {"reachable", reachable}};
}

}  // namespace

std::string json_of(const Report& report) {
  const auto& target = report.job.target;
  Json out;
  out["schema"] = "ricochet/calibration/1";
  out["target"] = {{"tcol", target.tcol},
                   {"en", target.en},
                   {"velocity", target.impact.velocity},
                   {"mass_eff", target.impact.mass_eff}};
  out["units"] = {{"tcol", "s"},          {"velocity", "m/s"},    {"mass_eff", "kg"},
                  {"max_overlap", "m"},   {"overlap_end", "m"},   {"max_force", "N"},
                  {"tcol_estimate", "s"}, {"timestep.step", "s"}, {"hertz_time", "s"}};
  out["assumed"] = report.job.assumptions;
  out["results"] = Json::array();
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    Json result = json_of(report.results[i]);
    result["timestep"] = json_of(report.steps[i]);
    if (const auto time = hertz_time_of(report.results[i].law, target.impact)) result["hertz_time"] = *time;
    out["results"].push_back(result);
  }
  out["infeasible"] = Json::array();
  for (const auto& missed : report.infeasible) out["infeasible"].push_back(json_of(missed));
  for (const auto& failure : report.failed)
    out["failed"].push_back({{"law", failure.law.name()}, {"end", text(failure.end)}, {"reason", failure.reason}});
  return console::document(out);
}

}  // namespace ricochet::calibration
