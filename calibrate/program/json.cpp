#include "real_sphere.hpp"
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

Json json_of(const scale::Moduli& m) {
  return {{"young", {m.first.young, m.second.young}},
          {"poisson", {m.first.poisson, m.second.poisson}},
          {"radius_eff", m.radius_eff},
          {"soften", m.soften},
          {"match", m.linear == LinearMatch::time ? "time" : "overlap"}};
}

/// tcol and en where they were asked for, else null and what was asked for instead.
Json target_of(const Job& job) {
  if (job.given) return nullptr;
  const Known& known = job.known;
  const auto* time = std::get_if<scale::CollisionTime>(&known.scale);
  const auto* en = std::get_if<loss::Restitution>(&known.loss);
  Json out{{"tcol", time ? Json(time->tcol) : Json(nullptr)},
           {"en", en ? Json(en->en) : Json(nullptr)},
           {"velocity", known.impact.velocity},
           {"mass_eff", known.impact.mass_eff}};
  if (const auto* s = std::get_if<scale::Stiffness>(&known.scale)) out["stiffness"] = s->k;
  if (const auto* s = std::get_if<scale::MaxOverlap>(&known.scale)) out["max_overlap"] = s->length;
  if (const auto* s = std::get_if<scale::Moduli>(&known.scale)) out["moduli"] = json_of(*s);
  if (const auto* l = std::get_if<loss::LossFactor>(&known.loss)) out["loss_factor"] = l->tan_delta;
  if (const auto* l = std::get_if<loss::DampingRatio>(&known.loss)) out["damping_ratio"] = l->ratio;
  if (const auto* l = std::get_if<loss::ConversionDegree>(&known.loss)) out["alpha"] = l->alpha;
  if (job.load) out["load"] = *job.load;
  if (job.tangential && job.tangential->beta0) out["beta0"] = *job.tangential->beta0;
  if (job.tangential && job.tangential->mu) out["mu"] = *job.tangential->mu;
  return out;
}

/// What was held of a law of real solids: its α, or the k by which α was found; and Zener's k1/k.
Json held_of(const Calibration& r) {
  const Request& request = r.request;
  if (request.stiffness) return {{"k", *request.stiffness}};
  Json out{{"alpha", request.held.alpha}};
  if (request.law == kind_of<FractionalZener>) out["k1/k"] = request.held.stiffening;
  return out;
}

/// How the parameters were found: nothing where they were given.
void add_search(Json& out, const Calibration& r) {
  out["evaluations"] = r.evaluations;
  out["method"] = text(r.method);
  out["algorithm"] = r.algorithm;
  out["cross_check"] = {{"method", text(r.cross_method)}, {"max_relative_difference", r.cross_difference}};
}

Json json_of(const Calibration& r, bool given) {
  Json out;
  out["law"] = name(r.law);
  out["end"] = text(r.end);
  out["parameters"] = named_values(parameters(r.law));
  out["units"] = units_of(r.law);
  out["target"] = given ? Json(nullptr) : Json{{"tcol", r.request.target.tcol}, {"en", r.request.target.en}};
  out["achieved"] = {{"tcol", r.achieved.tcol}, {"en", r.achieved.en}};
  out["residual"] = given ? Json(nullptr) : Json{{"tcol", r.tcol_residual}, {"en", r.en_residual}};
  out["max_overlap"] = r.achieved.max_overlap;
  out["max_force"] = r.achieved.max_force;
  out["overlap_end"] = r.achieved.overlap_end;
  if (r.tcol_estimate) out["tcol_estimate"] = *r.tcol_estimate;
  if (!given) add_search(out, r);
  out["identifiable"] = identifiable_names(r.law);
  if (!given && holds_degree(LawKind::of(r.law))) out["held"] = held_of(r);
  if (!r.remarks.empty()) out["remarks"] = r.remarks;
  if (const auto& u = r.under_load)
    out["under_load"] = {{"load", u->load}, {"least_velocity", u->least_velocity}, {"clears", u->clears}};
  return out;
}

Json json_of(const Tangential& t) {
  Json out{{"law", text(t.found.form)}};
  const auto all = parameters_of(t.found.law);
  const auto of_law = values(t.found.law);
  for (std::size_t i = 0; i < all.size(); ++i) {
    out["parameters"][std::string(all[i].name)] = of_law[i];
    out["units"][std::string(all[i].name)] = all[i].unit();
  }
  out["parameters"]["mu"] = t.found.mu ? Json(*t.found.mu) : Json();
  out["beta0"] = t.found.beta0;
  out["achieved"] = {{"beta0", t.found.achieved}};
  out["algorithm"] = t.found.algorithm;
  if (t.found.cross_difference)
    out["cross_check"] = {{"method", "nlopt"},
                          {"max_relative_difference", *t.found.cross_difference},
                          {"evaluations", t.found.evaluations}};
  if (!t.found.remarks.empty()) out["remarks"] = t.found.remarks;
  if (t.rebounds.empty()) return out;
  out["units"]["angle"] = out["units"]["rebound_angle"] = "rad";
  out["rebounds"] = Json::array();
  for (const ObliqueRebound& r : t.rebounds)
    out["rebounds"].push_back({{"angle", r.angle},
                               {"et", r.et},
                               {"beta", r.beta},
                               {"rebound_angle", r.rebound_angle},
                               {"impulse_ratio", r.impulse_ratio}});
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
  Json out{{"law", missed.law.name()}, {"end", text(missed.end)}, {"reason", missed.reason}, {"reachable", reachable}};
  if (missed.open || missed.low_open) {
    Json ends = Json::array();
    if (missed.low_open) ends.push_back(missed.lowest);
    if (missed.open) ends.push_back(missed.highest);
    out["excluded"] = {{missed.quantity, ends}};
  }
  return out;
}

}  // namespace

Json document_of(const Report& report) {
  StepAdvisor advisor;
  return document_of(report, advisor);
}

Json document_of(const Report& report, StepAdvisor& advisor) {
  Json out;
  out["schema"] = "ricochet/calibration/1";
  out["target"] = target_of(report.job);
  if (report.job.given)
    out["impact"] = {{"velocity", report.job.known.impact.velocity}, {"mass_eff", report.job.known.impact.mass_eff}};
  out["units"] = {{"tcol", "s"},        {"velocity", "m/s"},   {"mass_eff", "kg"},     {"max_overlap", "m"},
                  {"overlap_end", "m"}, {"max_force", "N"},    {"tcol_estimate", "s"}, {"timestep.step", "s"},
                  {"hertz_time", "s"},  {"rayleigh_time", "s"}};
  out["assumed"] = report.job.assumptions;
  out["results"] = Json::array();
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    const Calibration& r = report.results[i];
    Json result = json_of(r, report.job.given.has_value());
    if (!report.tangential.empty()) result["tangential"] = json_of(report.tangential[i]);
    result["timestep"] = json_of(steps_of(r, advisor));
    if (report.job.step) {
      const auto error = asked_step_error(report.job, r);
      result["timestep_asked"] = {{"error_en", error ? Json(*error) : Json()}, {"step", *report.job.step}};
    }
    if (const auto time = hertz_time_of(r.law, report.job.known.impact)) result["hertz_time"] = *time;
    if (const auto sphere = real_sphere(report.job, r))
      result["real_sphere"] = {{"en", sphere->en}, {"relative_difference", sphere->difference}};
    out["results"].push_back(result);
  }
  if (const auto time = rayleigh_of(report.job)) out["rayleigh_time"] = *time;
  out["infeasible"] = Json::array();
  for (const auto& missed : report.infeasible) out["infeasible"].push_back(json_of(missed));
  for (const auto& failure : report.failed)
    out["failed"].push_back({{"law", failure.law.name()}, {"end", text(failure.end)}, {"reason", failure.reason}});
  return out;
}

std::string json_of(const Report& report) { return console::document(document_of(report)); }

}  // namespace ricochet::calibration
