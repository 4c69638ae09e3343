#pragma once

// The templates of column.hpp: the run of a ColumnEngine from start to end, and the largest step that it bears.

#include <ricochet/collision/collision.hpp>
#include <ricochet/motion/column.hpp>
#include <ricochet/motion/engine/column_engine.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace ricochet {

template <ContactLaw Law>
class ColumnEngine;  // for whoever includes that header first

namespace motion {

void check(const ColumnOptions& options);  ///< throws for what needs no column to be seen
void check_step(double step, double largest);

/// Root h of w·h·g(h) = 1/2 for a contact of effective mass `mass` [kg] met at `speed` [m/s], w in 1/kg; see
/// `largest_step`.
double stable_step(const Linear& law, double w, double mass, double speed);
double stable_step(const KuwabaraKono& law, double w, double mass, double speed);
double stable_step(const Tsuji& law, double w, double mass, double speed);
double stable_step(const Hysteretic& law, double w, double mass, double speed);
double stable_step(const Fractional& law, double w, double mass, double speed);
double stable_step(const FractionalKelvinVoigt& law, double w, double mass, double speed);
double stable_step(const FractionalHertz& law, double w, double mass, double speed);
double stable_step(const FractionalZener& law, double w, double mass, double speed);
double stable_step(collision::DrivenLaw& law, double w, double mass, double speed);
template <ContactLaw Law>
double stable_step(const Law& law, double w, double mass, double speed) {
  collision::Driven<Law> driven(law);
  return stable_step(driven, w, mass, speed);
}

/// The least of the contacts'; `of_contact(plate, w, mass, speed)`.
double least_stable_step(const Column& column,
                         const std::function<double(bool plate, double w, double mass, double speed)>& of_contact);

template <ContactLaw Law>
ColumnResult run(const Column& column, const Law& plate, const Law& pair, const ColumnOptions& options) {
  ColumnEngine<Law> engine(column, plate, pair, options);
  ColumnResult result;
  // Looking for the end costs as much as half a step, so it is done now and then, and always while nothing touches.
  constexpr std::size_t patience = 32;
  bool over = engine.finished(), whole = true;
  while (!over && whole && engine.time() < options.duration) {
    if (!engine.any_contact()) engine.skip_free_flight();
    engine.step();
    ++result.steps;
    if (!engine.any_contact() || result.steps % patience == 0) over = engine.finished(), whole = engine.finite();
  }
  ColumnResult broken;
  broken.end = ColumnEnd::broke_down, broken.steps = result.steps;
  if (!engine.finite()) return broken;
  if (over) result.end = engine.resting() ? ColumnEnd::resting : ColumnEnd::separated;
  result.time = engine.time();
  for (std::size_t i = 0; i < engine.beads(); ++i) result.velocity.push_back(engine.velocity(i));
  result.energy_ratio = kinetic_energy_ratio(column, result.velocity);
  result.contacts = engine.contacts();
  result.last_contact_time = engine.last_contact_time();
  result.energy = engine.energy();
  if (!std::isfinite(result.energy_ratio) || (column.gravity == 0 && result.energy_ratio > 1.1)) return broken;
  return result;
}

}  // namespace motion

template <ContactLaw Law>
double largest_step(const Column& column, const Law& plate, const Law& pair) {
  return motion::least_stable_step(column, [&](bool at_plate, double w, double mass, double speed) {
    return motion::stable_step(at_plate ? plate : pair, w, mass, speed);
  });
}

template <ContactLaw Law>
ColumnResult run_column(const Column& column, const Law& plate, const Law& pair, const ColumnOptions& options) {
  motion::check(options);
  motion::check_step(options.step, largest_step(column, plate, pair));
  return motion::run(column, plate, pair, options);
}

// Built once, in the library.
extern template ColumnResult run_column(const Column&, const Linear&, const Linear&, const ColumnOptions&);
extern template ColumnResult run_column(const Column&, const KuwabaraKono&, const KuwabaraKono&, const ColumnOptions&);
extern template ColumnResult run_column(const Column&, const Tsuji&, const Tsuji&, const ColumnOptions&);
extern template ColumnResult run_column(const Column&, const Hysteretic&, const Hysteretic&, const ColumnOptions&);

}  // namespace ricochet
