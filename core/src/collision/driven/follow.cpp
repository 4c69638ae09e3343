// The collision of any contact law, by its force and the steps of its memory alone.

#include <ricochet/collision/collision.hpp>
#include <ricochet/support/require.hpp>

#include "../closed_forms.hpp"
#include "limit.hpp"
#include "scout.hpp"
#include "stretch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace ricochet::collision {
namespace {

/// Change of the limits, relative to them, at which the steps are doubled no more: a tenth of the bound promised.
constexpr double enough = 1e-10;
constexpr int first_steps = 16, most_steps = 1 << 16;

/// What one pass over the collision found, with as many steps up to the turning point as from there to the end.
struct Pass {
  Instant turn, strongest, end;
  bool by_overlap = false;
};

/// A length that the next pass should find, and how far it may be off.
struct Guess {
  double length, doubt;

  void now(double found, double next) { *this = {next, 0.3 * std::abs(found - length) + 1e-14 * found}; }
};

double rate(const Instant& at) { return at.rate; }
double overlap(const Instant& at) { return at.overlap; }
/// Carried on below overlap 0 by a spring, as some laws have no force there to tell how far beyond the end it is.
double force(const Instant& at) { return at.force + std::min(0.0, at.overlap); }

/// Passes with 16, 32, 64, … steps a stretch and the limits that they tend to.
class Doubling {
 public:
  Doubling(ScaledContact& contact, const CollideOptions& options, const Scouted& scouted)
      : contact_(contact),
        options_(options),
        rebounds_(scouted.status != CollisionStatus::no_separation),
        may_end_by_overlap_(scouted.by_overlap),
        loading_{scouted.turn, 0.01 * scouted.turn},
        rebound_{scouted.end - scouted.turn, 0.01 * (scouted.end - scouted.turn)} {}

  /// Whether the limits settled before the budget was spent.
  bool run();
  /// What is known then of the extremes and, if the pair rebounds, of the end.
  void write(Collision& out) const;

 private:
  enum Quantity { turn, turn_overlap, max_force, end, en, end_overlap };

  std::optional<Pass> pass(int steps);
  std::optional<Instant> find_end(Stretch& unloading, bool& by_overlap);
  bool settled(const Pass& found);
  double limit(Quantity q) const { return limits_[q].value(); }

  ScaledContact& contact_;
  const CollideOptions& options_;
  bool rebounds_, may_end_by_overlap_;
  Guess loading_, rebound_;
  std::array<Limit, 6> limits_;
  Pass last_;
};

bool Doubling::run() {
  for (int steps = first_steps; steps <= most_steps && contact_.evaluations() < options_.max_evaluations; steps *= 2) {
    const std::optional<Pass> found = pass(steps);
    // A mesh too coarse for the motion may miss its end; one that sees another kind of end starts anew.
    if (!found || found->by_overlap != last_.by_overlap) limits_ = {};
    if (!found) continue;
    if (settled(*found)) return true;
  }
  return false;
}

bool Doubling::settled(const Pass& found) {
  last_ = found;
  const std::array values{found.turn.time, found.turn.overlap, found.strongest.force,
                          found.end.time,  -found.end.rate,    found.by_overlap ? 0 : found.end.overlap};
  bool all = true;
  for (std::size_t q = 0; q < (rebounds_ ? values.size() : 3); ++q) {
    limits_[q].add(values[q]);
    const double scale = limit(q == end_overlap ? turn_overlap : static_cast<Quantity>(q));
    all = all && limits_[q].doubt() <= enough * std::abs(scale);
  }
  const double next_turn = limits_[turn].next();
  loading_.now(found.turn.time, next_turn);
  if (rebounds_) rebound_.now(found.end.time - found.turn.time, limits_[end].next() - next_turn);
  return all;
}

std::optional<Pass> Doubling::pass(int steps) {
  Stretch loading(contact_, contact_.touch(), Graded::at_start, steps);
  contact_.mark();
  const auto top = loading.run_to(rate, loading_.length, loading_.doubt, options_.max_evaluations);
  if (!top) return std::nullopt;
  Pass found{.turn = *top, .strongest = loading.peak_force(), .end = {}};
  if (!rebounds_) return found;
  contact_.mark();
  Stretch unloading(contact_, *top, Graded::at_end, steps);
  const auto last = find_end(unloading, found.by_overlap);
  if (!last) return std::nullopt;
  found.end = *last;
  const Instant peak = unloading.peak_force();
  if (peak.force > found.strongest.force) found.strongest = peak;
  return found;
}

/// By force, unless that keeps repelling until the overlap is gone.
std::optional<Instant> Doubling::find_end(Stretch& unloading, bool& by_overlap) {
  const auto run_to = [&](double (*event)(const Instant&)) {
    return unloading.run_to(event, rebound_.length, rebound_.doubt, options_.max_evaluations);
  };
  by_overlap = true;
  if (options_.end == ContactEnd::overlap) return run_to(overlap);
  if (may_end_by_overlap_) {
    const auto apart = run_to(overlap);
    if (!apart) return std::nullopt;
    const auto& path = unloading.path();
    if (std::all_of(path.begin(), path.end() - 1, [](const Instant& at) { return at.force > 0; })) return apart;
  }
  by_overlap = false;
  return run_to(force);
}

void Doubling::write(Collision& out) const {
  if (limits_[turn].empty()) return;
  out.max_overlap = limit(turn_overlap);
  out.time_max_overlap = limit(turn);
  if (rebounds_ || limit(max_force) > out.max_force || out.time_max_force <= limit(turn)) {
    out.max_force = limit(max_force);
    out.time_max_force = last_.strongest.time;
  }
  if (!out.separated()) return;
  out.tcol = limit(end);
  out.en = limit(en);
  out.overlap_end = limit(end_overlap);
}

}  // namespace

Collision follow(DrivenLaw& law, const Impact& impact, const CollideOptions& options, double load) {
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  support::require(options.breakage_energy >= 0, "breakage_energy", options.breakage_energy, ">= 0");
  if (options.method == CollideMethod::closed_form)
    throw std::invalid_argument("method = closed_form: the " + std::string(law.name()) + " law has none");
  const std::optional<double> unit = time_scale(law, impact);
  if (!unit) return {.status = CollisionStatus::no_separation};
  ScaledContact contact(law, impact, *unit, load);
  const Scouted scouted = scout(contact, options.end, options.max_evaluations);
  Collision out{.status = scouted.status,
                .max_overlap = scouted.deepest.overlap,
                .time_max_overlap = scouted.deepest.time,
                .max_force = scouted.strongest.force,
                .time_max_force = scouted.strongest.time};
  if (scouted.status == CollisionStatus::permanent_contact) {
    out.tcol = scouted.rest.time;
    out.overlap_end = scouted.rest.overlap;
    if (energy_at_rest(impact) >= options.breakage_energy) out.status = CollisionStatus::breakage;
  } else if (scouted.turn > 0) {
    Doubling doubling(contact, options, scouted);
    if (!doubling.run() && out.separated()) out.status = CollisionStatus::budget_spent;
    doubling.write(out);
  }
  out.evaluations = contact.evaluations();
  return in_units(out, impact, *unit);
}

bool parts_under(DrivenLaw& law, const Impact& impact, double load) {
  const std::optional<double> unit = time_scale(law, impact);
  if (!unit) return false;
  ScaledContact contact(law, impact, *unit, load);
  constexpr std::size_t budget = 100'000;
  return scout(contact, ContactEnd::force, budget).status == CollisionStatus::ended_by_force;
}

void walk(DrivenLaw& law, const Impact& impact, const Visit& visit) {
  const std::optional<double> unit = time_scale(law, impact);
  if (!unit) return;
  ScaledContact contact(law, impact, *unit);
  const double length = impact.velocity * *unit, force_unit = impact.mass_eff * impact.velocity / *unit;
  scout(contact, ContactEnd::force, 100'000, [&](const Instant& at) {
    visit({at.time * *unit, at.overlap * length, at.rate * impact.velocity, at.force * force_unit});
  });
}

}  // namespace ricochet::collision
