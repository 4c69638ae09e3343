#include "claims.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::cluster {

namespace {

using console::Notation;
using console::Table;
constexpr const paper::FiveSpheres& five = paper::five_spheres;

constexpr std::uint32_t first = 0, fifth = 4;  // spheres 1 and 5

/// Least ratio of √(ω_ξ²+ω_η²), strong over weak, at the times at which the two collide in both states; infinite
/// where there is no such time.
double least_ratio(const Pair& runs) {
  double least = Encounter::never;
  const auto weak = spins_against(runs.weak, first, fifth);
  for (const LocalSpin& s : spins_against(runs.strong, first, fifth))
    for (const LocalSpin& w : weak)
      if (w.time == s.time) least = std::min(least, tangential(s.spin) / tangential(w.spin));
  return least;
}

bool went_through(const Run& run, Phase phase) {
  const Encounter* e = collision_of(run, first, fifth);
  return e != nullptr && std::isfinite(e->phase_begin[static_cast<std::size_t>(phase)]);
}

double duration(const Encounter& e) { return e.end - e.begin; }

double shortest(const Run& run) {
  double least = Encounter::never;
  for (const Encounter& e : run.collisions) least = std::min(least, duration(e));
  return least;
}

double longest(const Run& run) {
  double most = 0;
  for (const Encounter& e : run.collisions) most = std::max(most, duration(e));
  return most;
}

double last_end(const Run& run) {
  double last = 0;
  for (const Encounter& e : run.collisions) last = std::max(last, e.end);
  return last;
}

bool strong(const Run& run) { return run.law.alpha == five.strong_alpha; }

const Run& at(const std::vector<Run>& runs, double alpha, double k, double c) {
  return *std::find_if(runs.begin(), runs.end(),
                       [&](const Run& r) { return r.law.alpha == alpha && r.law.k == k && r.law.c == c; });
}

const Run& printed(const std::vector<Run>& runs, double alpha) { return at(runs, alpha, five.k, five.c); }

/// Of the weak runs at the printed c, or at the printed k, the one of the greatest other.
const Run& stiffest_weak(const std::vector<Run>& runs) {
  const Run* found = &printed(runs, five.weak_alpha);
  for (const Run& r : runs)
    if (!strong(r) && r.law.c == five.c && r.law.k > found->law.k) found = &r;
  return *found;
}

const Run& most_damped_weak(const std::vector<Run>& runs) {
  const Run* found = &printed(runs, five.weak_alpha);
  for (const Run& r : runs)
    if (!strong(r) && r.law.k == five.k && r.law.c > found->law.c) found = &r;
  return *found;
}

}  // namespace

void spin_gates(std::vector<Gate>& gates, const Pair& printed, const Pair& stiff) {
  // The print says below 1. No such time at all would pass as infinity, so it is bounded by what no spin ratio is.
  for (const Pair* runs : {&printed, &stiff})
    gates.push_back(between(
        fmt::format("1-5, k = {}: strong over weak tangential spin, least while both collide: against the paper",
                    console::significant(runs->strong.law.k, 1)),
        least_ratio(*runs), 1, 1e3));
  const auto mechanism = [&gates](const char* where, const Pair& runs, bool strong_rolls) {
    gates.push_back(
        holds(fmt::format("1-5, {}: strong {}", where,
                          strong_rolls ? "rolls too, against the paper" : "slides with torsion, never rolls"),
              went_through(runs.strong, Phase::rolling) == strong_rolls && went_through(runs.strong, Phase::torsion) &&
                  went_through(runs.strong, Phase::sliding)));
    gates.push_back(holds(fmt::format("1-5, {}: weak rolls", where), went_through(runs.weak, Phase::rolling)));
  };
  mechanism("printed k", printed, true);
  mechanism(fmt::format("k = {}", console::significant(stiff.strong.law.k, 1)).c_str(), stiff, false);
}

Remark spin_remark(const Pair& printed, const Pair& stiff) {
  const auto greatest = [](const Pair& runs) {
    return fmt::format("{:.1f} against {:.1f} 1/s at k = {}", greatest_tangential(runs.strong, first, fifth),
                       greatest_tangential(runs.weak, first, fifth), console::significant(runs.strong.law.k, 1));
  };
  const auto rolls = [](const Run& run) { return went_through(run, Phase::rolling) ? "rolls" : "never rolls"; };
  return {
      "Fig. 8, sphere 1 against 5",
      fmt::format("The paper says that ω_ξ and ω_η of sphere 1 are smaller in the strong state, and takes that for "
                  "torsion with sliding there and rolling in the weak state. Here they are larger whenever both "
                  "states collide, at most {} and {}. At the printed k sphere 1 {} on 5 in the strong and {} in the "
                  "weak state; at k = {} it {} in the strong and {} in the weak state, as the paper says.",
                  greatest(printed), greatest(stiff), rolls(printed.strong), rolls(printed.weak),
                  console::significant(stiff.strong.law.k, 1), rolls(stiff.strong), rolls(stiff.weak))};
}

Table duration_table(const std::vector<Run>& runs) {
  constexpr std::pair<std::uint32_t, std::uint32_t> pairs[] = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {2, 4}};
  const Notation three{Notation::Kind::fixed, 3};
  std::vector<console::Column> columns{
      {"alpha"}, {"k", "kg/s^2", {Notation::Kind::significant, 2}}, {"c", "kg/s", {Notation::Kind::significant, 2}}};
  for (const auto& [i, j] : pairs) columns.push_back({fmt::format("{}-{}", i + 1, j + 1), "ms", three});
  columns.push_back({"last end", "ms", three});
  Table table(columns, "Fig. 9: how long each pair collides, against k and c");
  for (const Run& run : runs) {
    std::vector<console::Cell> cells{run.law.alpha, run.law.k, run.law.c};
    for (const auto& [i, j] : pairs) {
      const Encounter* e = collision_of(run, i, j);
      cells.push_back(console::number_or_blank(e != nullptr ? 1e3 * duration(*e) : Encounter::never));
    }
    cells.push_back(console::number_or_blank(1e3 * last_end(run)));
    table.row(cells);
  }
  std::string legible;
  for (const double d : five.durations) legible += fmt::format("{}{:g}", legible.empty() ? "" : ", ", 1e3 * d);
  table.note(fmt::format("Legible in print: {} ms, on an axis to about {:g} ms.", legible, 1e3 * five.sequence_axis));
  return table;
}

void duration_gates(std::vector<Gate>& gates, const std::vector<Run>& runs) {
  const double legible = *std::max_element(five.durations.begin(), five.durations.end());
  for (const double alpha : {five.strong_alpha, five.weak_alpha})
    gates.push_back(at_least(
        fmt::format("alpha = {}, printed k and c: shortest t_col over the longest legible one, against the paper",
                    alpha),
        shortest(printed(runs, alpha)) / legible, 1));
  const Run &stiff = stiffest_weak(runs), &damped = most_damped_weak(runs);
  const double axis = five.sequence_axis;
  gates.push_back(at_least(fmt::format("weak, k = {}: longest t_col over the printed axis: k alone does not mend it",
                                       console::significant(stiff.law.k, 1)),
                           longest(stiff) / axis, 1));
  gates.push_back(at_most(fmt::format("weak, c = {}: longest t_col over the printed axis", damped.law.c),
                          longest(damped) / axis, 1));
  gates.push_back(at_most(fmt::format("weak, c = {}: shortest t_col over the longest legible one", damped.law.c),
                          shortest(damped) / legible, 1));
}

Remark duration_remark(const std::vector<Run>& runs) {
  const Run &stiff = stiffest_weak(runs), &damped = most_damped_weak(runs);
  const Run &s = printed(runs, five.strong_alpha), &w = printed(runs, five.weak_alpha);
  const auto span = [](const Run& r) {
    return fmt::format("{} to {}", console::significant(1e3 * shortest(r), 2),
                       console::significant(1e3 * longest(r), 2));
  };
  return {
      "Figs. 7-9, k and c",
      fmt::format("Beside its bars Fig. 9 prints durations of about {:g} to {:g} ms, on an axis to about {:g} ms. At "
                  "the printed k and c the collisions last {} ms (strong) and {} ms (weak): k and c look short of a "
                  "factor. Of the weak state's, k alone cannot be it: from {} to {} kg/s² the longest falls as "
                  "k^{:.2f}, to {} ms. At c = {} kg/s they last {} ms.",
                  1e3 * *std::min_element(five.durations.begin(), five.durations.end()),
                  1e3 * *std::max_element(five.durations.begin(), five.durations.end()), 1e3 * five.sequence_axis,
                  span(s), span(w), console::significant(w.law.k, 1), console::significant(stiff.law.k, 1),
                  std::log(longest(stiff) / longest(w)) / std::log(stiff.law.k / w.law.k),
                  console::significant(1e3 * longest(stiff), 2), damped.law.c, span(damped))};
}

}  // namespace ricochet::verify::cluster
