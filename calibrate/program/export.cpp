#include "report.hpp"

#include <calibrate/export.hpp>
#include <calibrate/tangential.hpp>
#include <console/exit.hpp>
#include <console/json.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::calibration {
namespace {

using console::Json;

/// What is known of two grains that meet each other instead of the wall: what `found` was found from.
Known between_grains(Known known, const Calibration& found) {
  known.impact.mass_eff *= 0.5;
  known.loss = loss::Restitution{found.request.target.en};
  if (std::holds_alternative<scale::CollisionTime>(known.scale))
    known.scale = scale::CollisionTime{found.request.target.tcol};
  if (auto* moduli = std::get_if<scale::Moduli>(&known.scale)) {
    moduli->second = moduli->first;
    moduli->radius_eff *= 0.5;
  }
  return known;
}

/// A result with its tangential law, where one is asked for.
struct Found {
  Calibration normal;
  std::optional<TangentialPart> tangential = {};
};

/// Nothing, too, where the friction is not known.
std::optional<TangentialPart> tangential_of(const Report& report, std::size_t result) {
  if (report.tangential.empty()) return std::nullopt;
  const TangentialCalibration& found = report.tangential[result].found;
  return found.mu ? std::optional(TangentialPart{found.law, *found.mu}) : std::nullopt;
}

/// What the laws of two grains are where those of a grain and the wall were found; nothing where there are none.
std::optional<Found> laws_between_grains(const Job& job, const Calibration& found) {
  Job grains = job;
  grains.known = between_grains(job.known, found);
  if (const auto* moduli = std::get_if<scale::Moduli>(&grains.known.scale);
      moduli && job.tangential && job.tangential->mindlin)
    grains.tangential->mindlin = mindlin_stiffness(moduli->first.young, moduli->first.poisson, moduli->second.young,
                                                   moduli->second.poisson, moduli->radius_eff) /
                                 moduli->soften;
  grains.wanted = {{LawKind::of(found.law), found.end}};
  grains.left_out.clear();
  const Report report = run(grains, {.method = Method::direct});
  if (report.results.empty()) return std::nullopt;
  return Found{report.results.front(), tangential_of(report, 0)};
}

/// The contact that was calibrated; with a wall also that of two such grains, which an engine has to know as well:
/// calibrated the same way at their own effective mass. nullopt where they cannot reach it.
std::optional<ContactSet> contacts_of(const Report& report, std::size_t result) {
  const Calibration& found = report.results[result];
  const Job& job = report.job;
  const Target& target = found.request.target;
  PairCase asked{0, 0, found.law, target.tcol, target.en, target.impact, job.radius_eff, tangential_of(report, result)};
  ContactSet set{found.end, {{.name = "grain", .density = job.density}}, {}};
  set.step = job.step;
  const auto* moduli = std::get_if<scale::Moduli>(&job.known.scale);
  if (moduli) set.kinds.front().poisson = moduli->first.poisson;  // then Young's moduli come out as they were given
  if (!job.wall) {
    set.pairs.push_back(asked);
    return set;
  }
  asked.b = 1;
  set.kinds.push_back({.name = "wall", .wall = true});
  if (moduli) set.kinds.back().poisson = moduli->second.poisson;
  set.pairs.push_back(asked);
  const auto grains = laws_between_grains(job, found);
  if (!grains) return std::nullopt;
  const Target& theirs = grains->normal.request.target;
  set.pairs.push_back(
      {0, 0, grains->normal.law, theirs.tcol, theirs.en, theirs.impact, 0.5 * *asked.radius_eff, grains->tangential});
  set.notes.push_back(
      job.given
          ? "Not asked for, but every engine wants it: two such grains meet by this very law, whose numbers give "
            "another collision time and restitution at their own effective mass."
          : "Not asked for, but every engine wants it: two such grains meet by the same law, found the same way at "
            "their own effective mass.");
  return set;
}

std::vector<Snippet> snippets_of(const Report& report, Engine engine) {
  std::vector<Snippet> snippets;
  for (std::size_t result = 0; result < report.results.size(); ++result)
    if (auto snippet = snippet_of(report, result, engine)) snippets.push_back(*std::move(snippet));
  return snippets;
}

Json json_of(const Snippet& snippet) {
  Json json{{"law", name(snippet.law)}, {"end", text(snippet.end)}, {"fidelity", text(snippet.fidelity)}};
  json["gives"] = nullptr;
  if (!snippet.gives.empty() && snippet.gives.front().separated())
    json["gives"] = {{"tcol", snippet.gives.front().tcol}, {"en", snippet.gives.front().en}};
  json["remarks"] = snippet.remarks;
  json["text"] = snippet.text;
  return json;
}

std::string document_of(const std::vector<Snippet>& snippets, Engine engine) {
  Json json{{"schema", "ricochet/export/1"},
            {"engine", text(engine)},
            {"version", version(engine)},
            {"snippets", Json::array()}};
  for (const Snippet& snippet : snippets) json["snippets"].push_back(json_of(snippet));
  return console::document(json);
}

void require_exportable(console::Format format) {
  if (format != console::Format::table && format != console::Format::json)
    throw console::BadInput("--format", format == console::Format::csv ? "csv" : "markdown",
                            "table (the engine's own language) or json with --export");
}

/// Throws console::Unreachable where there are laws and the engine can be given none of them.
void require_one(const std::vector<Snippet>& snippets, Engine engine) {
  std::vector<std::string> reasons;
  for (const Snippet& s : snippets) {
    if (s.fidelity != Fidelity::absent) return;
    reasons.push_back(fmt::format("{}, ended by {}: {}", name(s.law), text(s.end), why_absent(s)));
  }
  if (!reasons.empty())
    throw console::Unreachable(
        fmt::format("--export {}: nothing to write: {}", text(engine), fmt::join(reasons, "; ")));
}

std::string text_of(const Report& report, const std::vector<Snippet>& snippets, Engine engine) {
  std::string all = combine(snippets);
  for (const Infeasible& missed : report.infeasible)
    all += "\n" + comment(engine, fmt::format("Ricochet: the {} law ended by {} can't reach the target.",
                                              missed.law.name(), text(missed.end)));
  for (const Failure& failure : report.failed)
    all += "\n" + comment(engine, fmt::format("Ricochet: failed: {}.", failure.reason));
  return all;
}

}  // namespace

std::optional<Snippet> snippet_of(const Report& report, std::size_t result, Engine engine) {
  const auto set = contacts_of(report, result);
  return set ? std::optional(export_contacts(engine, *set)) : std::nullopt;
}

std::string why_absent(const Snippet& snippet) {
  std::string reason = snippet.remarks.empty() ? "that contact never separates there" : snippet.remarks.front();
  if (const std::string mark = "NOT WRITTEN: "; reason.starts_with(mark)) reason.erase(0, mark.size());
  if (reason.ends_with('.')) reason.pop_back();
  return reason;
}

std::string exported(const std::vector<Snippet>& snippets, Engine engine, console::Format format) {
  require_exportable(format);
  require_one(snippets, engine);
  return format == console::Format::json ? document_of(snippets, engine) : combine(snippets);
}

std::string exported(const Report& report, const std::string& name_of_engine, console::Format format) {
  require_exportable(format);
  const Engine engine = engine_named(name_of_engine).value();
  const auto snippets = snippets_of(report, engine);
  require_one(snippets, engine);
  return format == console::Format::json ? document_of(snippets, engine) : text_of(report, snippets, engine);
}

}  // namespace ricochet::calibration
