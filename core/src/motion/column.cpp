#include <ricochet/motion/column.hpp>

#include <ricochet/support/text.hpp>

#include <stdexcept>
#include <string>

namespace ricochet {

namespace {

// Such that a value of three digits that a message names is accepted.
std::string at_least(double value) { return "at least " + support::significant(1.005 * value, 3); }
std::string at_most(double value) { return "at most " + support::significant(0.995 * value, 3); }

MemoryKernel kernel_for(double alpha, const ColumnOptions& options, std::size_t most_arms) {
  const double shortest = options.shortest_memory > 0 ? options.shortest_memory : options.step;
  const double longest = std::max(
      shortest, options.longest_memory > 0 ? options.longest_memory : std::min(options.duration, 1e5 * shortest));
  const double tolerance = options.memory_tolerance;
  support::require(tolerance >= 1e-12 && tolerance <= 0.1, "memory_tolerance", tolerance, "in [1e-12, 0.1]");
  support::require(longest <= 1e6 * shortest, "longest_memory", longest,
                   "at most 1e6 of the shortest, that is of the step by default");
  MemoryKernel kernel = affordable_kernel(alpha, {shortest, longest, tolerance}, most_arms);
  if (kernel.error() > tolerance) {
    const std::string accepted = at_least(kernel.error()) + " at alpha = " + support::significant(alpha, 3) +
                                 " with a longest memory of " + support::significant(longest / shortest, 3) +
                                 " shortest ones";
    support::reject("memory_tolerance", tolerance, accepted.c_str());
  }
  return kernel;
}

template <RemembersAll Law>
ColumnResult run_on_arms(const Column& column, const Law& plate, const Law& pair, const ColumnOptions& options) {
  using Arms = typename Law::Arms;
  const auto kernel = [&](double alpha) { return kernel_for(alpha, options, Arms::max_kernel_arms); };
  const MemoryKernel of_plate = kernel(plate.alpha());
  const MemoryKernel of_pair = pair.alpha() == plate.alpha() ? of_plate : kernel(pair.alpha());
  return motion::run(column, Arms(plate, of_plate, options.step), Arms(pair, of_pair, options.step), options);
}

}  // namespace

Column equal_column(std::size_t beads, double mass, double gap, double velocity) {
  return {std::vector<double>(beads, mass), std::vector<double>(beads, gap), std::vector<double>(beads, velocity)};
}

double kinetic_energy_ratio(const Column& column, const std::vector<double>& velocity) {
  // In units of the greatest mass and speed, whose squares need not be doubles.
  double mass = 0, speed = 0;
  for (std::size_t i = 0; i < column.mass.size(); ++i) {
    mass = std::max(mass, column.mass[i]);
    speed = std::max(speed, std::abs(column.velocity[i]));
  }
  if (speed == 0) return 0;
  double before = 0, after = 0;
  for (std::size_t i = 0; i < column.mass.size(); ++i) {
    const double share = column.mass[i] / mass, was = column.velocity[i] / speed, is = velocity[i] / speed;
    before += share * was * was;
    after += share * is * is;
  }
  return after / before;
}

namespace motion {

void check(const ColumnOptions& options) {
  support::require_positive("step", options.step);
  support::require_positive("duration", options.duration);
  support::require_not_negative("shortest_memory", options.shortest_memory);
  support::require_not_negative("longest_memory", options.longest_memory);
}

void check_step(double step, double largest) {
  if (step > largest) support::reject("step", step, (at_most(largest) + " s for these masses and laws").c_str());
}

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

template ColumnResult run_column(const Column&, const Linear&, const Linear&, const ColumnOptions&);
template ColumnResult run_column(const Column&, const KuwabaraKono&, const KuwabaraKono&, const ColumnOptions&);
template ColumnResult run_column(const Column&, const Tsuji&, const Tsuji&, const ColumnOptions&);
template ColumnResult run_column(const Column&, const Hysteretic&, const Hysteretic&, const ColumnOptions&);

ColumnResult run_column(const Column& column, const AnyLaw& plate, const AnyLaw& pair, const ColumnOptions& options) {
  return std::visit(
      [&]<class Law>(const Law& plate_law) -> ColumnResult {
        const Law* pair_law = std::get_if<Law>(&pair);
        if (!pair_law)
          throw std::invalid_argument("pair = " + std::string(name(pair)) + ": must be of the plate's kind, " +
                                      std::string(name(plate)));
        if constexpr (RemembersAll<Law>) {
          motion::check(options);
          motion::check_step(options.step, largest_step(column, plate, pair));
          return run_on_arms(column, plate_law, *pair_law, options);
        } else {
          return run_column<Law>(column, plate_law, *pair_law, options);
        }
      },
      plate);
}

}  // namespace ricochet
