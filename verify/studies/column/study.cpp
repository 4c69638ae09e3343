#include "conversion_fit.hpp"
#include "figure.hpp"
#include "proofs.hpp"

#include <verify/registry.hpp>

#include <ricochet/collision/fractional_contact.hpp>

#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/program.hpp>
#include <console/progress.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace ricochet::verify {

namespace {

using console::Json;
using console::Notation;
using console::Table;

constexpr double paper_alpha = 0.0258;  // of the paper's curve with constant α

/// Shares of every law over the numbers of beads.
struct Figure6 {
  std::vector<std::size_t> beads;
  std::vector<ShareCurve> curves;
  const ShareCurve& curve(const std::string& id) const {
    return *std::find_if(curves.begin(), curves.end(), [&](const ShareCurve& c) { return c.id == id; });
  }
  double at(const std::string& id, std::size_t n) const {
    const auto where = std::find(beads.begin(), beads.end(), n);
    return *curve(id).share[static_cast<std::size_t>(where - beads.begin())];
  }
};

Figure6 measure(const std::vector<std::size_t>& beads, const ConversionFit& fit, const ColumnCase& c) {
  Figure6 figure{beads, {{"event-driven", {}}}};
  console::Progress progress("column", beads.size() * (column_laws().size() + 1));
  for (const std::size_t n : beads) figure.curves[0].share.push_back(event_driven_share(n, c));
  const auto add = [&](const std::string& id, auto run) {
    ShareCurve curve{id, {}};
    for (const std::size_t n : beads) {
      curve.share.push_back(run(n));
      progress.advance();
    }
    figure.curves.push_back(std::move(curve));
  };
  using Share = std::optional<double>;
  for (const ColumnLaw& law : column_laws())
    add(law.id, [&](std::size_t n) -> Share { return share(run_case(law, n, c)); });
  add("fractional alpha=0.0258", [&](std::size_t n) -> Share { return share(run_fractional(paper_alpha, n, c)); });
  // Beyond what was fitted α(nc) would leave the range of the closed forms.
  add("fractional alpha(nc)", [&](std::size_t n) -> Share {
    if (n > fit.points.back().beads) return std::nullopt;
    return share(run_fractional(fit.law(n), n, c));
  });
  return figure;
}

Table share_table(const std::string& first, const std::string& unit, const std::vector<double>& x,
                  const std::vector<ShareCurve>& curves, const std::string& caption) {
  std::vector<console::Column> columns{{first, unit}};
  for (const ShareCurve& curve : curves) columns.push_back({curve.id, "", {Notation::Kind::fixed, 4}});
  Table table(columns, caption);
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::vector<console::Cell> cells{x[i]};
    for (const ShareCurve& curve : curves)
      cells.push_back(curve.share[i] ? console::Cell(*curve.share[i]) : console::blank());
    table.row(cells);
  }
  return table;
}

Table fit_table(const ConversionFit& fit) {
  Table table({{"nc"},
               {"event-driven", "", {Notation::Kind::fixed, 4}},
               {"alpha exact", "", {Notation::Kind::fixed, 5}},
               {"s exact", "", {Notation::Kind::fixed, 4}},
               {"alpha(nc)", "", {Notation::Kind::fixed, 5}},
               {"s(nc)", "", {Notation::Kind::fixed, 4}},
               {"share", "", {Notation::Kind::fixed, 4}},
               {"error", "", {Notation::Kind::scientific, 1}}},
              "alpha(nc) = 1 - (1 - alpha_1)^s, s = (1 + a (nc - 1))^b, fitted by NLopt to the event-driven shares");
  for (const ConversionPoint& p : fit.points)
    table.row({static_cast<std::int64_t>(p.beads), p.target, p.exact_alpha, p.exact_exponent, fit.law(p.beads),
               fit.law.exponent(p.beads), p.fitted_share, p.fitted_share - p.target});
  table.note("alpha_1 = " + console::significant(fit.law.first, 7) + ", a = " + console::significant(fit.law.a, 5) +
             ", b = " + console::significant(fit.law.b, 5) + "; greatest error " + console::scientific(fit.worst, 1) +
             ", rms " + console::scientific(fit.rms, 1) + "; with s = nc instead " +
             console::scientific(fit.simple_worst, 1));
  table.note("exact: the alpha whose column loses exactly the event-driven share.");
  return table;
}

/// Claims of the paper and of Luding et al. (1994), for the case of Fig. 6.
void claim_gates(std::vector<Gate>& gates, const Figure6& figure, const ConversionFit& fit) {
  gates.push_back(near("conversion degree of en = 0.945", conversion_degree(0.945), 0.0293504, 5e-8));
  gates.push_back(near("en of the paper's alpha = 0.0258", fractional_contact(paper_alpha).en, 0.951545, 5e-7));
  const double hard = figure.at("event-driven", 20);
  for (const ColumnLaw& law : column_laws()) {
    double nearest = 0;
    for (std::size_t n = 2; n <= 20; ++n)
      nearest = std::max(nearest, figure.at(law.id, n) / figure.at("event-driven", n));
    gates.push_back(
        at_most(std::string(law.id) + " detaches: greatest share over event-driven, nc = 2 to 20", nearest, 0.9));
    gates.push_back(at_most(std::string(law.id) + " detaches: share over event-driven, nc = 20",
                            figure.at(law.id, 20) / hard, 0.5));
  }
  for (const char* id : {"linear1", "linear2"})
    gates.push_back(at_most(std::string(id) + ": more beads lose less, share at nc = 20 over nc = 1",
                            figure.at(id, 20) / figure.at(id, 1), 1));
  gates.push_back(
      at_most("fractional alpha(nc) follows the event-driven column, greatest error of the share", fit.worst, 0.01));
}

std::string verdict(const Figure6& figure, const ConversionFit& fit) {
  const std::size_t last = 20;
  double least = 1, most = 0, apart = 0;
  for (const ColumnLaw& law : column_laws()) {
    least = std::min(least, figure.at(law.id, last));
    most = std::max(most, figure.at(law.id, last));
  }
  for (std::size_t n = 1; n <= last; ++n)
    apart = std::max(apart, std::abs(figure.at("fractional alpha=0.0258", n) - figure.at("hysteretic", n)));
  return "20 beads lose " + console::fixed(figure.at("event-driven", last), 3) +
         " of their energy in single collisions, but " + console::fixed(least, 3) + " to " + console::fixed(most, 3) +
         " under laws with constant parameters: each detaches. With alpha(nc), s = (1 + " +
         console::fixed(fit.law.a, 4) + " (nc - 1))^" + console::fixed(fit.law.b, 4) +
         ", the fractional law follows the event-driven shares to " + console::fixed(fit.worst, 4) +
         ". Constant alpha = 0.0258 stays within " + console::fixed(apart, 3) + " of the hysteretic law.";
}

std::string share_finding(const Figure6& figure) {
  const std::size_t last = figure.beads.back();
  const auto text = [&](const std::string& id) {
    const auto& share = figure.curve(id).share.back();
    return share ? console::fixed(*share, 2) : std::string("an unknown share");
  };
  return "With " + std::to_string(last) + " beads single collisions (event-driven) would take " + text("event-driven") +
         " of the energy, the hysteretic law takes " + text("hysteretic") + ", linear1 " + text("linear1") +
         ", the fractional law with constant α " + text("fractional") + "; with α(nc) it takes " +
         text("fractional alpha(nc)") + ".";
}

Json rows(const Figure6& figure, const ColumnCase& c) {
  Json all = Json::array();
  for (const ShareCurve& curve : figure.curves)
    for (std::size_t i = 0; i < figure.beads.size(); ++i) {
      const auto& value = curve.share[i];
      all.push_back({{"nc", figure.beads[i]},
                     {"gap", c.gap},
                     {"law", curve.id},
                     {"en", c.en},
                     {"tcol", c.tcol},
                     {"share", value ? Json(*value) : Json()},
                     {"energy_ratio", value ? Json(1 - *value) : Json()}});
    }
  return all;
}

/// Least or greatest share at the first abscissa, the event-driven column left out.
double extreme(const std::vector<ShareCurve>& curves, bool greatest) {
  double found = *curves[1].share.front();
  for (std::size_t i = 2; i < curves.size(); ++i)
    found = greatest ? std::max(found, *curves[i].share.front()) : std::min(found, *curves[i].share.front());
  return found;
}

class ColumnStudy : public Study {
 public:
  std::string name() const override { return "column"; }
  std::string claim() const override {
    return "In a falling column of beads (Fig. 6) laws with constant parameters detach; a conversion degree that grows "
           "with the number of beads gives the dissipation of single collisions";
  }

  void add_options(CLI::App& app) override {
    app.add_option("--nc", beads_, "number of beads of one column (default 10), or of the longest one (default 20)")
        ->type_name("N");
    console::add_number(app, "--gap", case_.gap, "gap under each bead [m], in [0, 1] (default 1e-6)");
    console::add_number(app, "--en", case_.en, "restitution that every law is made for, in [0.001, 1) (default 0.945)");
    console::add_number(app, "--tcol", case_.tcol,
                        "collision time that every law is made for [s], in [1e-9, 1] (default 1e-4)");
    app.add_option("--law", law_,
                   "run one column of: linear1 (or linear), linear2, kuwabara-kono, tsuji, hysteretic, fractional");
    app.add_option("--steps", case_.steps, "time steps a collision time (default " + std::to_string(case_.steps) + ")")
        ->type_name("N");
  }

  StudyResult run(const RunOptions& options) override {
    check();
    return law_.empty() ? whole_figure(options) : one_column();
  }

 private:
  bool as_printed() const { return case_.gap == 1e-6 && case_.en == 0.945 && case_.tcol == 1e-4; }

  void check() const {
    const auto reject = [](const char* flag, double value, const char* accepted) {
      throw console::BadInput(flag, console::shortest(value), accepted);
    };
    if (beads_ && (*beads_ < 1 || *beads_ > 100000)) reject("--nc", static_cast<double>(*beads_), "from 1 to 100000");
    if (!(case_.gap >= 0 && case_.gap <= 1)) reject("--gap", case_.gap, "in [0, 1]");
    if (case_.en < 0.001 || case_.en >= 1) reject("--en", case_.en, "in [0.001, 1)");
    if (!(case_.tcol >= 1e-9 && case_.tcol <= 1)) reject("--tcol", case_.tcol, "in [1e-9, 1]");
    if (case_.steps < 10 || case_.steps > 100000) reject("--steps", case_.steps, "from 10 to 100000");
    if (!law_.empty() && !find_column_law(law_))
      throw console::BadInput("--law", law_,
                              "linear1 (or linear), linear2, kuwabara-kono, tsuji, hysteretic or fractional");
  }

  StudyResult one_column() const {
    const std::size_t beads = beads_ ? static_cast<std::size_t>(*beads_) : 10;
    const ColumnResult out = run_case(*find_column_law(law_), beads, case_);
    StudyResult result;
    Table table({{"bead"}, {"velocity", "m/s"}}, "Velocities after all contacts, from the plate upwards");
    for (std::size_t i = 0; i < beads; ++i) table.row({static_cast<std::int64_t>(i + 1), out.velocity[i]});
    table.note("E/E0 = " + console::shortest(out.energy_ratio) + ", dissipated share (62) " +
               console::shortest(share(out)) + ", " + std::to_string(out.contacts) + " contacts, " +
               std::to_string(out.steps) + " steps");
    result.tables = {table};
    result.extra = {{"nc", beads},
                    {"gap", case_.gap},
                    {"law", law_},
                    {"en", case_.en},
                    {"tcol", case_.tcol},
                    {"energy_ratio", out.energy_ratio},
                    {"velocities", out.velocity},
                    {"contacts", out.contacts},
                    {"steps", out.steps}};
    result.gates = {between("energy is lost, not gained: E/E0", out.energy_ratio, 0, 1)};
    result.verdict = std::to_string(beads) + " beads keep " + console::significant(out.energy_ratio, 6) +
                     " of their kinetic energy.";
    return result;
  }

  StudyResult whole_figure(const RunOptions& options) const {
    const std::size_t most = beads_ ? std::clamp<std::size_t>(static_cast<std::size_t>(*beads_), 2, 20) : 20;
    ColumnCase coarse = case_;  // the fit runs hundreds of columns; this moves their share by less than 1e-4
    coarse.steps = std::min(case_.steps, 100);
    coarse.memory_tolerance = 1e-4;
    const ConversionFit fit = fit_conversion(most, options.thorough ? 1 : 3, coarse);

    std::vector<std::size_t> beads(most);
    std::iota(beads.begin(), beads.end(), 1);
    if (options.thorough && !beads_) beads.insert(beads.end(), {30, 50, 100, 200, 500, 1000});
    if (beads_)
      for (std::size_t n = 30; n <= static_cast<std::size_t>(*beads_); n = n * 3 / 2) beads.push_back(n);
    const Figure6 figure = measure(beads, fit, case_);

    StudyResult result;
    Table shares =
        share_table("nc", "", {beads.begin(), beads.end()}, figure.curves,
                    "Dissipated share (62) against the number of beads, gap " + console::shortest(case_.gap) +
                        " m, en " + console::shortest(case_.en) + ", tcol " + console::shortest(case_.tcol) + " s");
    shares.note(
        "-: the event-driven column collapses (infinitely many collisions in a finite time); alpha(nc) is not fitted "
        "there.");
    result.tables = {std::move(shares), fit_table(fit)};
    result.figures = {share_figure(beads, figure.curves)};
    result.figures[0].finding = share_finding(figure);
    if (as_printed() && most == 20) {
      add_gap_dependence(result);
      ColumnProofs proofs = column_proofs();
      result.gates = std::move(proofs.gates);
      result.tables.push_back(std::move(proofs.known));
      result.tables.push_back(std::move(proofs.orders));
      claim_gates(result.gates, figure, fit);
      result.verdict = verdict(figure, fit);
      result.remarks = {
          {"Fig. 6, α for e_n = 0.945",
           "Printed as 0.0258. That α restores " + console::significant(fractional_contact(paper_alpha).en, 6) +
               "; e_n = 0.945 needs α = " + console::significant(conversion_degree(0.945), 6) + "."},
          {"Fig. 6, α(n_c)", "Printed as \"1+exp(−n_c)\", which exceeds 1. Read as 1 − (1 − α_1)^s with s = (1 + " +
                                 console::fixed(fit.law.a, 4) + " (n_c − 1))^" + console::fixed(fit.law.b, 4) +
                                 " it follows the event-driven column to " + console::fixed(fit.worst, 4) + "."}};
    }
    result.rows = rows(figure, case_);
    result.extra = {{"alpha_fit",
                     {{"form", "1 - (1 - alpha_1)^((1 + a (nc - 1))^b)"},
                      {"alpha_1", fit.law.first},
                      {"a", fit.law.a},
                      {"b", fit.law.b},
                      {"worst_error", fit.worst},
                      {"rms_error", fit.rms},
                      {"evaluations", fit.evaluations}}}};
    return result;
  }

  void add_gap_dependence(StudyResult& result) const {
    constexpr std::size_t beads = 10;
    const std::vector<double> gaps{1e-8,   1e-7, 3e-7, 1e-6, 2e-6, 3e-6, 5e-6, 7e-6, 1e-5,
                                   1.5e-5, 2e-5, 3e-5, 5e-5, 7e-5, 1e-4, 1e-3, 1e-2};
    std::vector<ShareCurve> curves{{"event-driven", {}}};
    ColumnCase c = case_;
    for (std::size_t i = 0; i < gaps.size(); ++i) curves[0].share.push_back(event_driven_share(beads, c));
    for (const ColumnLaw& law : column_laws()) {
      ShareCurve curve{law.id, {}};
      for (const double gap : gaps) {
        c.gap = gap;
        curve.share.push_back(share(run_case(law, beads, c)));
      }
      curves.push_back(std::move(curve));
    }
    result.tables.push_back(share_table("gap", "m", gaps, curves, "Dissipated share (62) of 10 beads against the gap"));
    result.figures.push_back(gap_figure(beads, gaps, curves));
    const auto hard = curves[0].share.back();
    result.figures.back().finding =
        "At the widest gap every law takes what single collisions take" +
        (hard ? ", " + console::fixed(*hard, 2) : std::string()) + "; at the narrowest they take between " +
        console::fixed(extreme(curves, false), 2) + " and " + console::fixed(extreme(curves, true), 2) + ".";
  }

  std::optional<int> beads_;
  ColumnCase case_;
  std::string law_;
};

}  // namespace

std::unique_ptr<Study> column_study() { return std::make_unique<ColumnStudy>(); }

}  // namespace ricochet::verify
