#include "../paper.hpp"
#include "../selection.hpp"
#include "drawings.hpp"
#include "solids.hpp"
#include "third_group.hpp"

#include <verify/registry.hpp>

#include <console/exit.hpp>
#include <console/number.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
              "Where the curves of Fig. 5 end, from the greatest overlap to the least");
  for (const PrintedLaw* law : figures::by_end_overlap(laws))
    table.row({law->name, law->collision.tcol * 1e4, law->collision.en, law->collision.overlap_end * 1e6,
               law->points.back().force});
  table.note("linear1 ends where its overlap does: its force has turned attractive before.");
  return table;
}

std::string how(CollisionStatus status) {
  switch (status) {
    case CollisionStatus::ended_by_force: return "force 0 (25)";
    case CollisionStatus::ended_by_overlap: return "overlap 0 (24)";
    case CollisionStatus::permanent_contact: return "at rest (26)";
    default: return "";
  }
}

Table degrees(const std::vector<double>& alphas, const char* caption) {
  Table table({{"alpha", "", {Notation::Kind::fixed, 2}},
               {"ends with"},
               {"t_col", "1e-6 s", {Notation::Kind::significant, 5}},
               {"e_n", "", {Notation::Kind::fixed, 4}},
               {"overlap at the end", "1e-6 m", {Notation::Kind::significant, 4}}},
              caption);
  for (const double alpha : alphas) {
    const Collision c = figures::alpha_collision(alpha);
    table.row({alpha, how(c.status), c.tcol * 1e6, c.en, c.overlap_end * 1e6});
  }
  table.note(fmt::format(
      "(26) says no time: from alpha = 1 on t_col is where {} % of the impact velocity is left, the force then tending "
      "to zero for ever (a permanent contact, Definition 7).",
      100 * at_rest));
  return table;
}

/// (30) has no force at overlap 0, and (24) ends the contact there: numbers as computed from the series of Eq. (51).
struct GainingEnd {
  double alpha = 0, tcol = 0, en = 0;
};
constexpr GainingEnd gaining_ends[] = {{-0.1, 111.55e-6, 1.186}, {-0.25, 104.63e-6, 1.450}, {-0.5, 97.68e-6, 1.858}};

void add_gaining(std::vector<Gate>& all) {
  for (const GainingEnd& expected : gaining_ends) {
    const std::string at = fmt::format("Figs. 3, 4, alpha = {}: ", expected.alpha);
    const Collision closed = figures::alpha_collision(expected.alpha),
                    numerical = figures::alpha_collision(expected.alpha, CollideMethod::numerical);
    const bool by_overlap = closed.status == CollisionStatus::ended_by_overlap && numerical.status == closed.status;
    all.push_back(holds(at + "ends where the overlap returns, on both paths", by_overlap));
    all.push_back(near(at + "t_col [1e-6 s]", 1e6 * closed.tcol, 1e6 * expected.tcol, 5e-3));
    all.push_back(near(at + "e_n", closed.en, expected.en, 5e-4));
    all.push_back(
        at_most(at + "t_col and e_n by collocation, relative difference",
                std::max(std::fabs(numerical.tcol / closed.tcol - 1), std::fabs(numerical.en / closed.en - 1)), 1e-11));
  }
}

/// "Larger negative values of the conversion degree decrease the collisional time", "within 0 <= alpha < 1 the
/// collisional time increases": the least change of t_col from one hundredth of alpha to the next.
void add_monotone(std::vector<Gate>& all, const figures::DegreeSweep& sweep) {
  double below = std::numeric_limits<double>::infinity(), above = below;
  for (std::size_t i = 1; i < sweep.alpha.size(); ++i) {
    double& least = sweep.alpha[i] <= 0 ? below : above;
    const double rise = 1e6 * (sweep.tcol[i] - sweep.tcol[i - 1]);
    if (!(rise >= least)) least = rise;
  }
  all.push_back(at_least("alpha from -0.5 to 0: least rise of t_col [1e-6 s]", below, 0));
  all.push_back(at_least("alpha from 0 to 0.97: least rise of t_col [1e-6 s]", above, 0));
}

void add_laws(std::vector<Gate>& all, const std::vector<PrintedLaw>& laws) {
  for (const PrintedLaw& law : laws) {
    const Collision& c = law.collision;
    // The printed coefficients carry four digits: Table II, checked in table2.
    all.push_back(near(fmt::format("Fig. 5, {}: t_col / 1e-4 s", law.name), c.tcol / pair.tcol, 1, 2e-3));
    all.push_back(near(fmt::format("Fig. 5, {}: e_n / 0.5", law.name), c.en / pair.en, 1, 2e-3));
    all.push_back(near(fmt::format("Fig. 5, {}: the curve's last velocity / -e_n v0", law.name),
                       law.points.back().rate / (-c.en * pair.impact.velocity), 1, 1e-3));
  }
}

/// "The greatest overlap is for the hysteretic law and decreases for the fractional through the nonlinear to the linear
/// one", of which linear1 ends at no overlap at all.
void add_order(std::vector<Gate>& all, const std::vector<PrintedLaw>& laws) {
  const std::string order[] = {"hysteretic", "fractional", "nonlinear", "linear2", "linear1"};
  const auto overlap = [&](const std::string& name) {
    const auto found = std::find_if(laws.begin(), laws.end(), [&](const PrintedLaw& l) { return l.name == name; });
    return 1e6 * found->collision.overlap_end;
  };
  for (std::size_t i = 1; i < std::size(order); ++i)
    all.push_back(at_least(fmt::format("Fig. 5: overlap at the end, {} over {} [1e-6 m]", order[i - 1], order[i]),
                           overlap(order[i - 1]) - overlap(order[i]), 0));
}

std::vector<Gate> gates(const std::vector<PrintedLaw>& laws, const figures::DegreeSweep& sweep) {
  std::vector<Gate> all;
  add_laws(all, laws);
  add_order(all, laws);
  add_gaining(all);
  add_monotone(all, sweep);
  // Second order with 30 steps: 1/900.
  all.push_back(at_most("Figs. 3, 4: solver with 30 steps from the closed form, of v0", figures::solver_distance(),
                        3.0 / (paper::steps * paper::steps)));
  // At the point of no velocity the direction jumps: of 160000 parts a few dozen about it count by their middles alone.
  all.push_back(at_most("F and T from their sums over the disc, absolute", figures::disc_distance(), 1e-3));
  return all;
}

/// The degrees that a reader asks for, and the size of their picture.
class Chosen {
 public:
  void add_options(CLI::App& app) {
    app.add_option_function<std::vector<std::string>>(
           "--alpha", [this](const std::vector<std::string>& fields) { alphas_ = numbers("--alpha", fields); },
           "also the collision of Figs. 3 and 4 at these conversion degrees: up to 10 in [-0.5, 2)")
        ->type_name("A,A,…")
        ->delimiter(',');
    app.add_option("--size", size_, "of their figure, for: paper (default), talk")->type_name("SIZE");
  }

  void check() const {
    for (const double alpha : alphas_)
      if (!(alpha >= -0.5 && alpha < 2)) throw console::BadInput("--alpha", console::shortest(alpha), "in [-0.5, 2)");
    if (alphas_.size() > most)
      throw console::BadInput("--alpha", fmt::format("{} degrees", alphas_.size()), "at most 10");
    if (!size_.empty() && size_ != "paper" && size_ != "talk")
      throw console::BadInput("--size", size_, "paper or talk");
    if (!size_.empty() && alphas_.empty()) throw console::BadInput("--size", size_, "given with --alpha");
  }

  void add_to(StudyResult& result) const {
    if (alphas_.empty()) return;
    result.tables.push_back(degrees(alphas_, "How the collision of Figs. 3 and 4 ends at the degrees asked for"));
    result.figures.push_back(figures::chosen_degrees(alphas_, size_));
  }

 private:
  static constexpr std::size_t most = 10;
  std::vector<double> alphas_;
  std::string size_;
};

class Figures : public Study {
 public:
  std::string name() const override { return "figures"; }
  std::string title() const override { return "One collision seen closely: Figs. 2 to 5"; }
  std::string claim() const override {
    return "Figs. 2-5: the collision over time and in phase, what ends it at every alpha, and friction's F and T";
  }
  void add_options(CLI::App& app) override { chosen_.add_options(app); }
  StudyResult run(const RunOptions&) override {
    chosen_.check();
    const auto laws = figures::table2_laws();
    const figures::DegreeSweep sweep = figures::sweep_degrees();
    StudyResult result;
    const auto third = figures::third_group();
    result.tables = {ends(laws), degrees(figures::drawn_degrees(), "How the collisions of Figs. 3 and 4 end"),
                     figures::table(third)};
    result.gates = gates(laws, sweep);
    for (Gate& gate : figures::gates(third)) result.gates.push_back(std::move(gate));
    for (Gate& gate : figures::solids_gates()) result.gates.push_back(std::move(gate));
    result.figures = {
        figures::figure2(),     figures::figure3(),     figures::figure4(),      figures::degree_figure(sweep),
        figures::figure5(laws), figures::disc_figure(), figures::solids_figure()};
    result.verdict = fmt::format(
        "Figs. 2-5 with their data; the printed coefficients of Table II end within 0.2 % of t_col = 1e-4 s and e_n = "
        "0.5. Below alpha = 0 the overlap ends the collision, the sooner the smaller alpha: t_col falls from {:.2f} µs "
        "at 0 to {:.2f} µs at -0.5.",
        1e6 * figures::alpha_collision(0).tcol, 1e6 * figures::alpha_collision(-0.5).tcol);
    chosen_.add_to(result);
    return result;
  }

 private:
  Chosen chosen_;
};

}  // namespace

std::unique_ptr<Study> figures_study() { return std::make_unique<Figures>(); }

}  // namespace ricochet::verify
