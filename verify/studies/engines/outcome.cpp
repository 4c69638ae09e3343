#include "outcome.hpp"

#include <console/exit.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::engines {

namespace {

/// Time of the first zero after the touch at `begin`: of the overlap between two instants; of the force beyond the last
/// two that repel, because clipped forces have no sign to bracket.
double end_of_contact(const Trajectory& path, double begin, ContactEnd end) {
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Instant &a = path[i - 1], &b = path[i], &c = path[i + 1];
    if (b.time <= begin) continue;
    if (end == ContactEnd::overlap && b.overlap > 0 && c.overlap <= 0)
      return b.time + (c.time - b.time) * b.overlap / (b.overlap - c.overlap);
    if (end == ContactEnd::force && a.force > 0 && b.force > 0 && c.force <= 0)
      return b.time + (b.time - a.time) * b.force / (a.force - b.force);
  }
  return begin;
}

Measured measure(const Trajectory& path, double step, const Contact& what) {
  const double begin = steps_before_touch * step;
  return {-path.back().rate / what.who.velocity, end_of_contact(path, begin, what.end) - begin};
}

/// What all three engines do: leapfrog, with the force at the new position and the velocity of half a step before. The
/// lag makes damping, and so the restitution, first order in the step.
template <class Law>
Trajectory repeat_stepping(const Law& law, ContactEnd end, double step, const Encounter& who) {
  Trajectory path;
  double overlap = -steps_before_touch * step * who.velocity, rate = who.velocity;
  for (long n = 0; n <= std::lround(who.duration() / step); ++n) {
    double force = overlap > 0 ? law.force({overlap, rate}, {}) : 0;
    if (end == ContactEnd::force) force = std::max(0.0, force);
    path.push_back({static_cast<double>(n) * step, overlap, rate, force});
    rate -= force / who.mass_eff() * step;
    overlap += rate * step;
  }
  return path;
}

std::optional<Trajectory> repeat_stepping(const AnyLaw& law, ContactEnd end, double step, const Encounter& who) {
  if (const auto* l = std::get_if<Linear>(&law)) return repeat_stepping(*l, end, step, who);
  if (const auto* l = std::get_if<KuwabaraKono>(&law)) return repeat_stepping(*l, end, step, who);
  if (const auto* l = std::get_if<Tsuji>(&law)) return repeat_stepping(*l, end, step, who);
  return std::nullopt;
}

}  // namespace

Outcome run(const EngineProgram& program, const Contact& what) {
  std::vector<double> steps;
  for (const int n : resolutions) steps.push_back(what.who.tcol / n);
  Outcome outcome{.what = what, .at = {}};
  const auto paths = program.run(what.snippet, what.who, steps);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (paths[i].size() < 3) throw console::Failed(fmt::format("no trajectory came back of {}", what.name));
    outcome.at.push_back(measure(paths[i], steps[i], what));
    if (!what.law) continue;
    if (const auto path = repeat_stepping(*what.law, what.end, steps[i], what.who))
      outcome.repeated =
          std::max(outcome.repeated.value_or(0), std::abs(outcome.at[i].en / measure(*path, steps[i], what).en - 1));
  }
  const Measured &coarse = outcome.at[at_200], &fine = outcome.at[finest];
  // Half the step makes the error half as large; of contacts whose ends are located, a quarter.
  const double less = what.fractional ? 4 : 2;
  outcome.limit = {(less * fine.en - coarse.en) / (less - 1), (less * fine.tcol - coarse.tcol) / (less - 1)};
  return outcome;
}

}  // namespace ricochet::verify::engines
