#include <verify/registry.hpp>

#include "../solvers.hpp"

#include <console/number.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

namespace {

using console::Json;
using console::Notation;
using console::Table;

/// The work-precision comparison is drawn for one order; the convergence table has them all.
constexpr double drawn_alpha = 0.25;
constexpr std::size_t paper_steps = 30;  // the ΔN that the paper settles for

std::vector<std::size_t> work_steps(FractionalScheme scheme) {
  if (scheme == FractionalScheme::collocation) return {4, 6, 8, 10, 12, 16, 20, 24};
  return {5, 10, 20, paper_steps, 40, 80, 160, 320, 640, 1280};
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
  Table table({{"scheme"},
               {"N"},
               {"error of e_n", "", error},
               {"worst offset", "", error},
               {"error of t_col", "", error},
               {"error of overlap_end", "", error},
               {"multiplications", "", count},
               {"kernel evaluations", "", count}},
              "Work and precision at alpha = " + console::shortest(drawn_alpha) +
                  ": relative errors, mean of 16 offsets of the mesh");
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

console::Figure work_figure(const std::vector<SolverConvergence>& all) {
  std::string csv = "scheme,N,multiplications,error of e_n\n";
  std::string script =
      "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset xlabel 'multiplications a collision'\n"
      "set ylabel 'relative error of e_n'\nset key outside right top\nset xrange [10:2e7]\n"
      "set yrange [1e-15:2]\n";
  std::string plot;
  int block = 0;
  for (const SolverConvergence& s : all) {
    if (block > 0) csv += "\n\n";
    for (std::size_t i = 0; i < s.en.steps.size(); ++i) {
      if (!(s.en.errors[i] > 0)) continue;
      csv += '"' + std::string(name(s.scheme)) + "\"," + std::to_string(s.en.steps[i]) + "," +
             console::shortest(s.multiplications[i]) + "," + console::shortest(s.en.errors[i]) + "\n";
    }
    const std::string at = "'collision-work.csv' index " + std::to_string(block) + (block == 0 ? " skip 1" : "");
    const std::string style = " pt " + std::to_string(block + 4) + " lc " + std::to_string(block + 1);
    plot += (block == 0 ? "plot " : ", \\\n  ") + at + " using 3:4 with linespoints lw 2 ps 0.8" + style + " title '" +
            std::string(name(s.scheme)) + "'";
    plot += ", \\\n  " + at + " using 3:($2 == " + std::to_string(paper_steps) + " && " + std::to_string(block) +
            " < 5 ? $4 : NaN) with points pt 6 ps 2 lc rgb 'black' " +
            (block == 0 ? "title 'N = 30, the choice of the paper'" : "notitle");
    ++block;
  }
  return {.name = "collision-work",
          .caption =
              "Error of the restitution against the multiplications a collision costs, for every solver at "
              "alpha = 0.25; circles: 30 steps a contact.",
          .script = script + plot + "\n",
          .data = {{"collision-work.csv", csv}},
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
  const auto at = std::find(s.en.steps.begin(), s.en.steps.end(), paper_steps);
  return at == s.en.steps.end() ? std::nan("") : s.en.errors[static_cast<std::size_t>(at - s.en.steps.begin())];
}

/// The least error that each solver reaches with ten thousand multiplications.
std::string work_finding(const std::vector<SolverConvergence>& all) {
  std::string text = "For at most ten thousand multiplications a collision the least errors of e_n are";
  for (const SolverConvergence& s : all) {
    double least = 1;
    for (std::size_t i = 0; i < s.en.steps.size(); ++i)
      if (s.multiplications[i] <= 1e4) least = std::min(least, s.en.errors[i]);
    if (least < 1) text += " " + console::scientific(least, 0) + " (" + std::string(name(s.scheme)) + "),";
  }
  text.back() = '.';
  return text;
}

class CollisionStudy : public Study {
 public:
  std::string name() const override { return "collision"; }
  std::string claim() const override {
    return "The paper takes 30 steps a contact: what that buys in e_n, t_col and the overlap at the end with each "
           "solver, "
           "wherever the contact starts between two mesh points";
  }
  StudyResult run(const RunOptions& options) override {
    std::vector<Convergence> all;
    for (const FractionalScheme scheme : stepping_schemes)
      for (const double alpha : studied_orders) {
        SolverConvergence s = measure(scheme, alpha, options.thorough ? 4096 : 2048);
        for (Convergence* c : {&s.en, &s.tcol, &s.overlap_end}) all.push_back(std::move(*c));
      }
    const std::vector<SolverConvergence> work = work_precision();

    StudyResult result;
    result.tables.push_back(
        to_table(all, "Observed order of the solvers of the fractional collision, 16 offsets each"));
    result.tables.push_back(work_table(work));
    result.rows = to_rows(all);
    result.gates = to_gates(all);
    result.gates.push_back(collocation_gate());
    result.figures.push_back(work_figure(work));
    result.figures.back().finding = work_finding(work);
    result.verdict = "At alpha = " + console::shortest(drawn_alpha) + " thirty steps give e_n with a relative error of";
    for (const SolverConvergence& s : work)
      if (const double e = error_at_paper_steps(s); std::isfinite(e)) {
        result.extra["error_of_en_at_30_steps"][std::string(ricochet::name(s.scheme))] = e;
        result.verdict += " " + console::scientific(e, 1) + " (" + std::string(ricochet::name(s.scheme)) + "),";
      }
    result.verdict.back() = '.';
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> collision_study() { return std::make_unique<CollisionStudy>(); }

}  // namespace ricochet::verify
