#include "../paper.hpp"
#include "drawings.hpp"

#include <verify/registry.hpp>

#include <fmt/format.h>

namespace ricochet::verify {

namespace {

using console::Notation;
using console::Table;
using figures::PrintedLaw;
using paper::pair;

Table ends(const std::vector<PrintedLaw>& laws) {
  Table table({{"law"},
               {"t_col", "1e-4 s", {Notation::Kind::fixed, 5}},
               {"e_n", "", {Notation::Kind::fixed, 5}},
               {"overlap at the end", "1e-6 m", {Notation::Kind::fixed, 3}},
               {"force at the end", "N", {Notation::Kind::fixed, 4}}},
              "Where the curves of Fig. 5 end");
  for (const PrintedLaw& law : laws)
    table.row({law.name, law.collision.tcol * 1e4, law.collision.en, law.points.back().overlap * 1e6,
               law.points.back().force});
  table.note("linear1 ends where its overlap does: its force has turned attractive before.");
  return table;
}

std::vector<Gate> gates(const std::vector<PrintedLaw>& laws) {
  std::vector<Gate> all;
  for (const PrintedLaw& law : laws) {
    const Collision& c = law.collision;
    // The printed coefficients carry four digits: Table II, checked in table2.
    all.push_back(near(fmt::format("Fig. 5, {}: t_col / 1e-4 s", law.name), c.tcol / pair.tcol, 1, 2e-3));
    all.push_back(near(fmt::format("Fig. 5, {}: e_n / 0.5", law.name), c.en / pair.en, 1, 2e-3));
    all.push_back(near(fmt::format("Fig. 5, {}: the curve's last velocity / -e_n v0", law.name),
                       law.points.back().rate / (-c.en * pair.impact.velocity), 1, 1e-3));
  }
  // Second order with 30 steps: 1/900.
  all.push_back(at_most("Figs. 3, 4: solver with 30 steps from the closed form, of v0", figures::solver_distance(),
                        3.0 / (paper::steps * paper::steps)));
  return all;
}

class Figures : public Study {
 public:
  std::string name() const override { return "figures"; }
  std::string claim() const override { return "Figs. 2-5: the collision over time and in phase, as data and plots"; }
  StudyResult run(const RunOptions&) override {
    const auto laws = figures::table2_laws();
    StudyResult result;
    result.tables.push_back(ends(laws));
    result.gates = gates(laws);
    result.figures = {figures::figure2(), figures::figure3(), figures::figure4(), figures::figure5(laws)};
    result.verdict =
        "Four figures with their data; the printed coefficients of Table II end within 0.2 % of t_col = 1e-4 s "
        "and e_n = 0.5.";
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> figures_study() { return std::make_unique<Figures>(); }

}  // namespace ricochet::verify
