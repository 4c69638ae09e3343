#include <ricochet/motion/column.hpp>

#include <ricochet/motion/engine/column_engine.hpp>

#include <charconv>
#include <stdexcept>
#include <string>

namespace ricochet {

namespace {

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

std::string three_digits(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 3).ptr};
}
// Such that a value of three digits that a message names is accepted.
std::string at_least(double value) { return "at least " + three_digits(1.005 * value); }
std::string at_most(double value) { return "at most " + three_digits(0.995 * value); }

MemoryKernel kernel_for(double alpha, const ColumnOptions& options) {
  const double shortest = options.shortest_memory > 0 ? options.shortest_memory : options.step;
  const double longest = std::max(
      shortest, options.longest_memory > 0 ? options.longest_memory : std::min(options.duration, 1e5 * shortest));
  const double tolerance = options.memory_tolerance;
  support::require(tolerance >= 1e-12 && tolerance <= 0.1, "memory_tolerance", tolerance, "in [1e-12, 0.1]");
  support::require(longest <= 1e6 * shortest, "longest_memory", longest,
                   "at most 1e6 of the shortest, that is of the step by default");
  MemoryKernel kernel = affordable_kernel(alpha, {shortest, longest, tolerance}, FractionalArms::max_arms);
  if (kernel.error() > tolerance) {
    const std::string accepted = at_least(kernel.error()) + " at alpha = " + three_digits(alpha) +
                                 " with a longest memory of " + three_digits(longest / shortest) + " shortest ones";
    support::reject("memory_tolerance", tolerance, accepted.c_str());
  }
  return kernel;
}

void check(const Column& column, const AnyLaw& plate, const AnyLaw& pair, const ColumnOptions& options) {
  support::require_positive("step", options.step);
  support::require_positive("duration", options.duration);
  support::require_not_negative("shortest_memory", options.shortest_memory);
  support::require_not_negative("longest_memory", options.longest_memory);
  const double largest = largest_step(column, plate, pair);
  if (options.step > largest)
    support::reject("step", options.step, (at_most(largest) + " s for these masses and laws").c_str());
}

ColumnResult run_fractional(const Column& column, const Fractional& plate, const Fractional& pair,
                            const ColumnOptions& options) {
  const MemoryKernel of_plate = kernel_for(plate.alpha(), options);
  const MemoryKernel of_pair = pair.alpha() == plate.alpha() ? of_plate : kernel_for(pair.alpha(), options);
  return run(column, FractionalArms(plate, of_plate, options.step), FractionalArms(pair, of_pair, options.step),
             options);
}

}  // namespace

Column equal_column(std::size_t beads, double mass, double gap, double velocity) {
  return {std::vector<double>(beads, mass), std::vector<double>(beads, gap), std::vector<double>(beads, velocity)};
}

double kinetic_energy_ratio(const Column& column, const std::vector<double>& velocity) {
  double before = 0, after = 0;
  for (std::size_t i = 0; i < column.mass.size(); ++i) {
    before += column.mass[i] * column.velocity[i] * column.velocity[i];
    after += column.mass[i] * velocity[i] * velocity[i];
  }
  return before > 0 ? after / before : 0.0;
}

namespace motion {

void check(const Column& column) {
  const std::size_t beads = column.mass.size();
  support::require_positive("beads", static_cast<double>(beads));
  support::require(column.gap.size() == beads, "number of gaps", static_cast<double>(column.gap.size()),
                   "that of the masses");
  support::require(column.velocity.size() == beads, "number of velocities", static_cast<double>(column.velocity.size()),
                   "that of the masses");
  support::require_not_negative("gravity", column.gravity);
  for (const double mass : column.mass) support::require_positive("mass", mass);
  for (const double gap : column.gap) support::require_not_negative("gap", gap);
  for (const double velocity : column.velocity)
    support::require(std::isfinite(velocity), "velocity", velocity, "finite");
}

}  // namespace motion

ColumnResult run_column(const Column& column, const AnyLaw& plate, const AnyLaw& pair, const ColumnOptions& options) {
  return std::visit(
      [&]<class Law>(const Law& plate_law) -> ColumnResult {
        const Law* pair_law = std::get_if<Law>(&pair);
        if (!pair_law)
          throw std::invalid_argument("pair = " + std::string(name(pair)) + ": must be of the plate's kind, " +
                                      std::string(name(plate)));
        check(column, plate, pair, options);
        if constexpr (std::same_as<Law, Fractional>) {
          return run_fractional(column, plate_law, *pair_law, options);
        } else {
          return run(column, plate_law, *pair_law, options);
        }
      },
      plate);
}

}  // namespace ricochet
