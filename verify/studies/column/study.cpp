#include "claims.hpp"
#include "figures.hpp"
#include "proofs.hpp"

#include <verify/registry.hpp>

#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/program.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

namespace ricochet::verify {

namespace column {

namespace {

using console::Table;

class ColumnStudy : public Study {
 public:
  std::string name() const override { return "column"; }
  std::string title() const override { return "A falling column of beads: Fig. 6"; }
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
    app.add_option("--steps", case_.steps, fmt::format("time steps a collision time (default {})", case_.steps))
        ->type_name("N");
  }

  StudyResult run(const RunOptions& options) override {
    check();
    return law_.empty() ? whole_figure(options) : one_column();
  }

 private:
  bool as_printed() const {
    return case_.gap == paper::column.gap && case_.en == paper::column.en && case_.tcol == paper::column.tcol;
  }

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
    table.note(fmt::format("E/E0 = {}, dissipated share (62) {}, {} contacts, {} steps",
                           console::shortest(out.energy_ratio), console::shortest(share(out)), out.contacts,
                           out.steps));
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
    result.verdict =
        fmt::format("{} beads keep {} of their kinetic energy.", beads, console::significant(out.energy_ratio, 6));
    return result;
  }

  /// 1, 2, … `most`, then larger ones as far as is asked for.
  std::vector<std::size_t> numbers_of_beads(std::size_t most, bool thorough) const {
    std::vector<std::size_t> beads(most);
    std::iota(beads.begin(), beads.end(), 1);
    if (thorough && !beads_) beads.insert(beads.end(), {30, 50, 100, 200, 500, 1000});
    if (beads_)
      for (std::size_t n = 30; n <= static_cast<std::size_t>(*beads_); n = n * 3 / 2) beads.push_back(n);
    return beads;
  }

  Table shares_of(const Shares& shares) const {
    Table table = share_table(
        "nc", "", {shares.beads.begin(), shares.beads.end()}, shares.curves,
        fmt::format("Dissipated share (62) against the number of beads, gap {} m, en {}, tcol {} s",
                    console::shortest(case_.gap), console::shortest(case_.en), console::shortest(case_.tcol)));
    table.note(
        "-: the event-driven column collapses (infinitely many collisions in a finite time); alpha(nc) is not fitted "
        "there.");
    return table;
  }

  StudyResult whole_figure(const RunOptions& options) const {
    constexpr std::size_t all = paper::column.most;
    const std::size_t most = beads_ ? std::clamp<std::size_t>(static_cast<std::size_t>(*beads_), 2, all) : all;
    ColumnCase coarse = case_;  // the fit runs hundreds of columns; this moves their share by less than 1e-4
    coarse.steps = std::min(case_.steps, 100);
    coarse.memory_tolerance = 1e-4;
    const ConversionFit fit = fit_conversion(most, options.thorough ? 1 : 3, coarse);
    const Shares shares = measure(numbers_of_beads(most, options.thorough), fit, case_);

    StudyResult result;
    result.tables = {shares_of(shares), fit_table(fit)};
    result.figures = {share_figure(shares.beads, shares.curves)};
    result.figures[0].finding = share_finding(shares);
    if (as_printed() && most == all) add_proofs(result, shares, fit);
    result.rows = rows(shares, case_);
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

  /// What is claimed of the case of Fig. 6.
  void add_proofs(StudyResult& result, const Shares& shares, const ConversionFit& fit) const {
    add_gap_dependence(result);
    ColumnProofs proofs = column_proofs();
    result.gates = std::move(proofs.gates);
    result.tables.push_back(std::move(proofs.known));
    result.tables.push_back(std::move(proofs.orders));
    claim_gates(result.gates, shares, fit);
    result.verdict = verdict(shares, fit);
    result.remarks = remarks(fit);
  }

  void add_gap_dependence(StudyResult& result) const {
    constexpr std::size_t beads = 10;
    const std::vector<double> gaps{1e-8,   1e-7, 3e-7, 1e-6, 2e-6, 3e-6, 5e-6, 7e-6, 1e-5,
                                   1.5e-5, 2e-5, 3e-5, 5e-5, 7e-5, 1e-4, 1e-3, 1e-2};
    const std::vector<ShareCurve> curves = over_gaps(beads, gaps, case_);
    result.tables.push_back(share_table("gap", "m", gaps, curves, "Dissipated share (62) of 10 beads against the gap"));
    result.figures.push_back(gap_figure(beads, gaps, curves));
    result.figures.back().finding = gap_finding(curves);
  }

  std::optional<int> beads_;
  ColumnCase case_;
  std::string law_;
};

}  // namespace

}  // namespace column

std::unique_ptr<Study> column_study() { return std::make_unique<column::ColumnStudy>(); }

}  // namespace ricochet::verify
