#include "groups.hpp"

#include "show.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::verify::conformance {

namespace {

/// All that a page shows of an engine's cases.
std::string shown_of(const EngineGrade& e) {
  std::string all;
  for (const CaseGrade& c : e.cases) {
    const Graded* worst = c.worst();
    const auto error = [&](std::size_t run) { return console::significant(c.error_at(run), 2); };
    all += fmt::format("{}|{}|{}\n", text(c.verdict), in_short(c), why(c));
    if (worst) all += fmt::format("{}|{}\n", error(0), error(worst->error.size() - 1));
  }
  return all;
}

std::vector<std::string> cases_for(const EngineGrade& e, const std::string& reason, const std::vector<Verdict>& taken) {
  std::vector<std::string> names;
  for (const CaseGrade& c : e.cases)
    if (std::find(taken.begin(), taken.end(), c.verdict) != taken.end() && cause_of(c) == reason)
      names.push_back(c.of->name);
  return names;
}

}  // namespace

std::vector<EngineGroup> grouped(const std::vector<EngineGrade>& engines) {
  std::vector<EngineGroup> groups;
  std::vector<std::string> shown;
  for (const EngineGrade& e : engines) {
    const std::string now = shown_of(e);
    const auto same = std::find(shown.begin(), shown.end(), now);
    if (same != shown.end()) {
      groups[static_cast<std::size_t>(same - shown.begin())].push_back(&e);
    } else {
      groups.push_back({&e}), shown.push_back(now);
    }
  }
  return groups;
}

std::string labels(const EngineGroup& group) {
  std::string all;
  const EngineGrade* before = nullptr;
  for (const EngineGrade* e : group) {
    const bool same = before && before->results.engine == e->results.engine;
    all += same ? ", " + e->results.version : (before ? "; " : "") + label(e->results);
    before = e;
  }
  return all;
}

std::vector<Reason> reasons(const std::vector<EngineGrade>& engines, const std::vector<Verdict>& taken) {
  std::vector<Reason> all;
  for (const EngineGrade& e : engines) {
    std::vector<std::string> seen;
    for (const CaseGrade& c : e.cases) {
      const std::string what = cause_of(c);
      if (std::find(taken.begin(), taken.end(), c.verdict) == taken.end()) continue;
      if (std::find(seen.begin(), seen.end(), what) != seen.end()) continue;
      seen.push_back(what);
      Reason reason{what, cases_for(e, what, taken), {&e}};
      const auto known = std::find_if(
          all.begin(), all.end(), [&](const Reason& r) { return r.what == reason.what && r.cases == reason.cases; });
      if (known != all.end())
        known->engines.push_back(&e);
      else
        all.push_back(std::move(reason));
    }
  }
  return all;
}

}  // namespace ricochet::verify::conformance
