#include "../convergence_figures.hpp"
#include "../convergence_tables.hpp"
#include "../paper.hpp"
#include "../selection.hpp"
#include "../solvers.hpp"

#include <verify/registry.hpp>

#include <console/gnuplot.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

namespace {

using console::Json;
using console::Notation;
using console::Table;

/// The work-precision comparison is drawn for one order; the convergence table has them all.
constexpr double drawn_alpha = 0.25;

std::vector<std::size_t> work_steps(FractionalScheme scheme) {
  if (scheme == FractionalScheme::collocation) return {4, 6, 8, 10, 12, 16, 20, 24};
  return {5, 10, 20, std::size_t{paper::steps}, 40, 80, 160, 320, 640, 1280};
}

std::vector<SolverConvergence> work_precision() {
  std::vector<SolverConvergence> all;
  for (const FractionalScheme scheme : stepping_schemes)
    all.push_back(measure(scheme, drawn_alpha, work_steps(scheme)));
  all.push_back(measure(FractionalScheme::collocation, drawn_alpha, work_steps(FractionalScheme::collocation)));
  return all;
}

Table work_table(const std::vector<SolverConvergence>& all) {
  const Notation error{Notation::Kind::scientific, 1}, count{Notation::Kind::significant, 3};
  Table table(
      {{"scheme"},
       {"N"},
       {"error of e_n", "", error},
       {"worst offset", "", error},
       {"error of t_col", "", error},
       {"error of overlap_end", "", error},
       {"multiplications", "", count},
       {"kernel evaluations", "", count}},
      fmt::format("Work and precision at alpha = {}: relative errors, mean of 16 offsets of the mesh", drawn_alpha));
  for (const SolverConvergence& s : all)
    for (std::size_t i = 0; i < s.en.steps.size(); ++i)
      table.row({std::string(name(s.scheme)), static_cast<std::int64_t>(s.en.steps[i]),
                 console::number_or_blank(s.en.errors[i]), console::number_or_blank(s.en.worst[i]),
                 console::number_or_blank(s.tcol.errors[i]), console::number_or_blank(s.overlap_end.errors[i]),
                 s.multiplications[i], s.kernel_evaluations[i]});
  table.note(
      "N: steps in a contact; for the collocation its nodes. Rosenbrock keeps one kernel, of delta = t_col/256; "
      "the other arms have delta = the step. Making a kernel is not counted.");
  return table;
}

console::SeriesFile work_file(const std::vector<SolverConvergence>& all) {
  console::SeriesFile file("collision-work.csv", "scheme,N,multiplications,error of e_n");
  for (const SolverConvergence& s : all) {
    file.begin();
    for (std::size_t i = 0; i < s.en.steps.size(); ++i)
      if (s.en.errors[i] > 0)
        file.add(fmt::format("\"{}\",{},{},{}", name(s.scheme), s.en.steps[i], console::shortest(s.multiplications[i]),
                             console::shortest(s.en.errors[i])));
  }
  return file;
}

/// A ring around the point of thirty steps.
console::Curve ring(const console::SeriesFile& file, std::size_t series) {
  return {.file = file.name(),
          .rows = file.rows(series),
          .what = fmt::format("3:($2 == {} ? $4 : NaN)", paper::steps),
          .style = "points pt 6 ps 2 lc rgb 'black'",
          .title = series == 0 ? "N = 30, as many as in the paper" : ""};
}

console::Figure work_figure(const std::vector<SolverConvergence>& all) {
  const console::SeriesFile file = work_file(all);
  console::Panel panel{
      .x = {.label = "multiplications a collision", .log = true, .range = std::pair(10.0, 2e7), .format = "10^{%L}"},
      .y = {.label = "relative error of e_n", .log = true, .range = std::pair(1e-15, 2.0), .format = "10^{%L}"},
      .key = "outside right top"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    panel.curves.push_back({.file = file.name(),
                            .rows = file.rows(i),
                            .what = "3:4",
                            .style = fmt::format("linespoints lw 2 ps 0.8 pt {} lc {}", i + 4, i + 1),
                            .title = std::string(name(all[i].scheme))});
    if (all[i].scheme != FractionalScheme::collocation) panel.curves.push_back(ring(file, i));
  }
  return {.name = "collision-work",
          .caption =
              "Error of the restitution against the multiplications a collision costs, for every solver at "
              "alpha = 0.25; circles: 30 steps a contact.",
          .plot = {.panels = {panel}},
          .data = {file.data()},
          .width = 1000,
          .height = 560};
}

/// Collocation with 24 nodes for every studied order.
Gate collocation_gate() {
  double worst = 0;
  for (const double alpha : studied_orders) {
    const SolverConvergence s = measure(FractionalScheme::collocation, alpha, std::vector<std::size_t>{24});
    for (const double e : {s.en.errors[0], s.tcol.errors[0], s.overlap_end.errors[0]})
      if (!(e <= worst)) worst = e;
  }
  return at_most("collocation, 24 nodes: worst relative error of e_n, t_col, overlap_end", worst, 1e-10);
}

double error_at_paper_steps(const SolverConvergence& s) {
  const auto at = std::find(s.en.steps.begin(), s.en.steps.end(), std::size_t{paper::steps});
  return at == s.en.steps.end() ? std::nan("") : s.en.errors[static_cast<std::size_t>(at - s.en.steps.begin())];
}

/// The least error that each solver reaches with ten thousand multiplications.
std::string work_finding(const std::vector<SolverConvergence>& all) {
  std::string text = "For at most ten thousand multiplications a collision the least errors of e_n are";
  for (const SolverConvergence& s : all) {
    double least = 1;
    for (std::size_t i = 0; i < s.en.steps.size(); ++i)
      if (s.multiplications[i] <= 1e4) least = std::min(least, s.en.errors[i]);
    if (least < 1) text += fmt::format(" {:.0e} ({}),", least, name(s.scheme));
  }
  text.back() = '.';
  return text;
}

/// What thirty steps a contact give with each solver.
void add_paper_steps(StudyResult& result, const std::vector<SolverConvergence>& work) {
  std::string text;
  for (const SolverConvergence& s : work)
    if (const double e = error_at_paper_steps(s); std::isfinite(e)) {
      result.extra["error_of_en_at_30_steps"][std::string(name(s.scheme))] = e;
      text += fmt::format(" {:.1e} ({}),", e, name(s.scheme));
    }
  text.back() = '.';
  result.verdict = fmt::format("At alpha = {} thirty steps give e_n with a relative error of{}", drawn_alpha, text);
}

class CollisionStudy : public Study {
 public:
  std::string name() const override { return "collision"; }
  std::string title() const override { return "What thirty steps a contact buy"; }
  std::string claim() const override {
    return "The paper takes 30 steps a contact: what that buys in e_n, t_col and the overlap at the end with each "
           "solver, "
           "wherever the contact starts between two mesh points";
  }
  void add_options(CLI::App& app) override { wanted_.add_options(app); }
  StudyResult run(const RunOptions& options) override {
    std::vector<std::string> schemes;
    for (const FractionalScheme scheme : studied_schemes) schemes.emplace_back(ricochet::name(scheme));
    wanted_.check(schemes, {"e_n", "t_col", "overlap_end"});
    const std::vector<Convergence> all = measure_all(options.thorough ? 4096 : 2048);
    StudyResult result = convergence_result(all, wanted_, "collision");
    result.verdict += ".";
    if (!wanted_.everything()) return result;
    const std::vector<SolverConvergence> work = work_precision();
    result.gates.push_back(collocation_gate());
    result.figures.insert(result.figures.begin(), work_figure(work));
    result.figures.front().finding = work_finding(work);
    result.tables.insert(result.tables.begin() + 1, work_table(work));
    add_paper_steps(result, work);
    return result;
  }

 private:
  std::vector<Convergence> measure_all(std::size_t finest) const {
    std::vector<Convergence> all;
    for (const FractionalScheme scheme : studied_schemes) {
      if (!wanted_.scheme(std::string(ricochet::name(scheme)))) continue;
      for (const double alpha : wanted_.alphas()) {
        SolverConvergence s = measure(scheme, alpha, wanted_.steps(finest), stated_against(scheme));
        for (Convergence* c : {&s.en, &s.tcol, &s.overlap_end})
          if (!c->steps.empty() && wanted_.function(c->statement.function)) all.push_back(std::move(*c));
      }
    }
    return all;
  }

  Selection wanted_;
};

}  // namespace

std::unique_ptr<Study> collision_study() { return std::make_unique<CollisionStudy>(); }

}  // namespace ricochet::verify
