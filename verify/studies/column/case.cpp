#include "case.hpp"

#include <ricochet/motion/event_driven_column.hpp>

#include <console/exit.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::verify::column {

namespace {

ColumnResult run(const AnyLaw& plate, const AnyLaw& pair, std::size_t beads, const ColumnCase& c, ContactEnd end,
                 const std::string& id) {
  ColumnOptions options;
  options.step = c.tcol / c.steps;
  // No bound in effect: free flight is jumped over, and beads that creep towards each other may take hours.
  options.duration = 1e8;
  options.negligible_approach = 1e-4;  // moves E/E0 by less than 1e-8, and ends columns of a thousand beads
  options.end = end;
  // Contacts in a column last as long as a wave takes to come back, about t_col/3 a bead.
  const double contacts = c.memory_contacts > 0 ? c.memory_contacts : 20.0 + static_cast<double>(beads);
  options.longest_memory = c.tcol * std::min(1e5 / c.steps, contacts);
  options.memory_tolerance = c.memory_tolerance;
  ColumnResult result =
      run_column(equal_column(beads, paper::column.bead_mass, c.gap, -paper::column.velocity), plate, pair, options);
  if (result.end == ColumnEnd::broke_down)
    throw console::Failed(
        fmt::format("column of {} beads, {}: the motion broke down; more steps a contact are needed", beads, id));
  if (result.end == ColumnEnd::out_of_time)
    throw console::Failed(
        fmt::format("column of {} beads, {}: contacts are not over after {} steps", beads, id, result.steps));
  return result;
}

}  // namespace

const std::vector<ColumnLaw>& column_laws() {
  static const std::vector<ColumnLaw> laws{{"linear1", kind_of<Linear>, ContactEnd::overlap},
                                           {"linear2", kind_of<Linear>, ContactEnd::force},
                                           {"kuwabara-kono", kind_of<KuwabaraKono>, ContactEnd::force},
                                           {"tsuji", kind_of<Tsuji>, ContactEnd::force},
                                           {"hysteretic", kind_of<Hysteretic>, ContactEnd::force},
                                           {"fractional", kind_of<Fractional>, ContactEnd::force}};
  return laws;
}

const ColumnLaw* find_column_law(const std::string& id) {
  const auto& laws = column_laws();
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const ColumnLaw& law) {
    return id == law.id || (id == "linear" && law.end == ContactEnd::overlap);
  });
  return found == laws.end() ? nullptr : &*found;
}

ColumnResult run_case(const ColumnLaw& law, std::size_t beads, const ColumnCase& c) {
  const AnyLaw plate = tuned_law(law.kind, c.tcol, c.en, {paper::column.velocity, paper::column.bead_mass}, law.end);
  const AnyLaw pair = tuned_law(law.kind, c.tcol, c.en, {paper::column.velocity, paper::column.bead_mass / 2}, law.end);
  return run(plate, pair, beads, c, law.end, law.id);
}

ColumnResult run_fractional(double alpha, std::size_t beads, const ColumnCase& c) {
  return run(tuned_fractional(alpha, c.tcol, paper::column.bead_mass),
             tuned_fractional(alpha, c.tcol, paper::column.bead_mass / 2), beads, c, ContactEnd::force, "fractional");
}

std::optional<double> event_driven_share(std::size_t beads, const ColumnCase& c) {
  // Without collapse nc beads meet some nc² times.
  const std::size_t limit = 100 * beads * beads;
  const EventDrivenResult hard = event_driven_column(
      equal_column(beads, paper::column.bead_mass, std::max(c.gap, 1e-9), -paper::column.velocity), c.en, limit);
  if (hard.status == EventDrivenResult::Status::collapsed) return std::nullopt;
  return 1 - hard.energy_ratio;
}

}  // namespace ricochet::verify::column
