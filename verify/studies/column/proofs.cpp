#include "proofs.hpp"

#include "case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ricochet::verify::column {

namespace {

using console::Notation;

double squared(double x) { return x * x; }

void one_bead(std::vector<Gate>& gates) {
  const ColumnCase c;
  for (const ColumnLaw& law : column_laws())
    gates.push_back(near(fmt::format("one bead, {}: E/E0 is en^2", law.id), run_case(law, 1, c).energy_ratio,
                         squared(c.en), stated_error(c)));
}

void wide_gaps(std::vector<Gate>& gates) {
  // Kuwabara and Kono's restitution depends on the velocity, so it has no event-driven limit of one e_n.
  constexpr std::size_t beads = 10;
  ColumnCase c;
  c.gap = 1;
  const double hard = *event_driven_share(beads, c);
  for (const ColumnLaw& law : column_laws())
    if (law.kind != kind_of<KuwabaraKono>)
      gates.push_back(near(fmt::format("10 beads with gaps of 1 m, {}: share of the event-driven column", law.id),
                           share(run_case(law, beads, c)), hard, static_cast<double>(beads) * stated_error(c)));
}

console::Table known_energies(std::vector<Gate>& gates) {
  struct Known {
    std::size_t beads;
    double ratio;
  };
  constexpr Known known[] = {{2, 0.840066}, {5, 0.879607}, {10, 0.905986}, {20, 0.929928}};
  console::Table table({{"nc"}, {"E/E0", "", {Notation::Kind::fixed, 6}}, {"known", "", {Notation::Kind::fixed, 6}}},
                       "Touching beads, linear law ended by overlap, en = 0.9");
  for (const Known& k : known) {
    const double ratio = run_case(*find_column_law("linear1"), k.beads, {.gap = 0, .en = 0.9}).energy_ratio;
    table.row({static_cast<std::int64_t>(k.beads), ratio, k.ratio});
    gates.push_back(near(fmt::format("touching linear beads, en 0.9, nc {}: E/E0", k.beads), ratio, k.ratio, 1e-4));
  }
  table.note("known: one independent calculation, to 1e-4.");
  return table;
}

console::Table observed_orders(std::vector<Gate>& gates) {
  constexpr std::size_t beads = 10;
  console::Table table({{"law"},
                        {"100 to 200", "", {Notation::Kind::scientific, 2}},
                        {"200 to 400", "", {Notation::Kind::scientific, 2}},
                        {"400 to 800", "", {Notation::Kind::scientific, 2}},
                        {"order", "", {Notation::Kind::fixed, 3}}},
                       "Change of E/E0 of 10 beads, gap 1e-6 m, as the steps a collision time double (stated order 2)");
  for (const ColumnLaw& law : column_laws()) {
    double ratio[4];
    for (int i = 0; i < 4; ++i)
      ratio[i] =
          run_case(law, beads, {.steps = 100 << i, .memory_tolerance = 1e-7, .memory_contacts = 15}).energy_ratio;
    const double first = ratio[1] - ratio[0], last = ratio[3] - ratio[2];
    const double order = 0.5 * std::log2(std::abs(first / last));
    table.row({std::string(law.id), first, ratio[2] - ratio[1], last, order});
    gates.push_back(between(fmt::format("order in E/E0, {}", law.id), order, 1.85, 2.15));
  }
  return table;
}

}  // namespace

ColumnProofs column_proofs() {
  std::vector<Gate> gates;
  one_bead(gates);
  wide_gaps(gates);
  console::Table known = known_energies(gates), orders = observed_orders(gates);
  return {std::move(gates), std::move(known), std::move(orders)};
}

}  // namespace ricochet::verify::column
