#include "../paper.hpp"
#include "coverage.hpp"

#include <verify/registry.hpp>

#include <console/csv.hpp>
#include <console/exit.hpp>
#include <console/gnuplot.hpp>
#include <console/number.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::verify {

namespace {

using calibration::Fit;
using calibration::Measurement;
using console::Table;

// Any mass will do where there are no collision times: e_n then depends on the combinations that the fit reports.
constexpr double mass = paper::pair.impact.mass_eff;

struct Source {
  std::string file, label;
};
const std::array sources{
    Source{"restitution_ice_bridges1984", "frosted ice, 210 K (Bridges et al. 1984, their fit)"},
    Source{"restitution_ice_hatzes1988", "compacted frost, 123 K (Hatzes et al. 1988, their fit)"},
    Source{"restitution_ice_supulver1995", "frost-free ice, 100 K (Supulver et al. 1995, their fit)"}};

std::vector<Measurement> read(const std::string& file) {
  constexpr std::array columns{console::CsvColumn{"velocity", "m/s", true}, console::CsvColumn{"en", "", true}};
  console::CsvReader source(data_folder() + "/" + file + ".csv", columns);
  std::vector<Measurement> data;
  while (source.next()) data.push_back({source.number(0), source.number(1)});
  return data;
}

std::vector<Fit> all_fits(const std::vector<Measurement>& data) {
  std::vector<Fit> fits;
  for (const LawKind law :
       {kind_of<Linear>, kind_of<KuwabaraKono>, kind_of<Tsuji>, kind_of<Hysteretic>, kind_of<Fractional>})
    fits.push_back(fit_law({law, ContactEnd::force, mass}, data));
  fits.push_back(fit_law({kind_of<Fractional>, ContactEnd::force, mass, true}, data));
  return fits;
}

bool said_to_misfit(const Fit& fit) {
  return std::any_of(fit.findings.begin(), fit.findings.end(),
                     [](const std::string& f) { return f.starts_with("misfit"); });
}

bool constant(const Fit& fit) { return fit.request.law != kind_of<KuwabaraKono> && !fit.request.alpha_of_speed; }

Table table_of(const Source& source, const std::vector<Fit>& fits) {
  const auto best =
      std::min_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.aic < b.aic; });
  Table table({{"law"},
               {"parameter"},
               {"value"},
               {"standard error", "", {.digits = 3}},
               {"unit"},
               {"scatter in en", "", {.digits = 3}},
               {"AIC over the best", "", {.digits = 4}}},
              fmt::format("Laws fitted to {}", source.label));
  for (const Fit& fit : fits)
    for (const auto& p : fit.parameters)
      table.row({fit_name(fit.request), p.name, p.value, p.error, p.unit,
                 std::sqrt(fit.chi2 / static_cast<double>(fit.freedom)), fit.aic - best->aic});
  return table;
}

console::Figure figure_of(const Source& source, const std::vector<Measurement>& data, const std::vector<Fit>& fits) {
  const std::string file = source.file + ".csv";
  std::vector<console::Column> columns{{"velocity", "m/s"}, {"en"}};
  std::vector<console::Curve> curves{
      {.file = file, .what = "1:2", .style = "points pt 7 lc rgb 'black'", .title = "published fit, sampled"}};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
    columns.push_back({fit_name(fits[i].request)});
    curves.push_back({.file = file,
                      .what = fmt::format("1:{}", columns.size()),
                      .style = fmt::format("lines lt {} lw 2", curves.size()),
                      .title = i == 0 ? "laws of constant restitution" : fit_name(fits[i].request)});
  }
  Table table(columns);
  for (std::size_t i = 0; i < data.size(); ++i)
    table.row({data[i].velocity, data[i].en, fits[0].predictions[i].en, fits[1].predictions[i].en,
               fits[5].predictions[i].en});
  const console::Panel panel{.x = {.label = "impact velocity [m/s]", .log = true},
                             .y = {.label = "restitution", .range = std::pair(0.0, 1.0)},
                             .curves = curves};
  return {source.file,
          fmt::format("Laws fitted to {}.", source.label),
          console::script_of(console::with_key_below(panel, 2, 0.26)),
          {{file, table.csv()}}};
}

/// Fisher's test of an α that follows the speed against the constant one that it contains: what the further parameters
/// take off the sum of squares, each, over what is left a degree of freedom. By chance alone it passes once in 1000.
Gate speed_matters(const std::string& file, const Fit& constant, const Fit& of_speed) {
  const auto more = static_cast<double>(constant.freedom - of_speed.freedom);
  const auto left = static_cast<double>(of_speed.freedom);
  const double f = (constant.chi2 - of_speed.chi2) / more / (of_speed.chi2 / left);
  return at_least(file + ": F of alpha(v) over constant alpha, against its 0.1 % point", f,
                  gsl_cdf_fdist_Qinv(1e-3, more, left));
}

/// What the sources show: gates, tables and figures go to `result`; the greatest scatter of α(v) over that of a
/// constant α.
double fit_sources(StudyResult& result) {
  double greatest = 0;
  for (const Source& source : sources) {
    const auto data = read(source.file);
    const auto fits = all_fits(data);
    result.tables.push_back(table_of(source, fits));
    result.figures.push_back(figure_of(source, data, fits));
    double mean = 0;
    for (const Measurement& m : data) mean += m.en / static_cast<double>(data.size());
    for (const Fit& fit : fits)
      if (constant(fit)) {
        // Least squares of a constant is the mean; the forward model is good to 1e-9, Gauss-Newton to more.
        const std::string which = fmt::format("{}: {}", source.file, fit_name(fit.request));
        result.gates.push_back(near(which + " has the mean restitution", fit.predictions[0].en, mean, 1e-8));
        result.gates.push_back(holds(which + " is said to misfit", said_to_misfit(fit)));
      }
    result.gates.push_back(speed_matters(source.file, fits[4], fits[5]));
    greatest = std::max(greatest, std::sqrt(fits[5].chi2 / fits[4].chi2));
  }
  return greatest;
}

std::string case_name(const CoverageCase& one) {
  return fit_name(one.request) + (one.with_times ? ", with times" : ", without times");
}

/// Least and greatest share of 95 % intervals that hold the truth, but for the chance of four standard deviations of a
/// normal variable on either side (3.2e-5): quantiles of the binomial distribution.
std::pair<double, double> plausible_shares(int trials) {
  const auto n = static_cast<unsigned>(trials);
  const double chance = gsl_cdf_ugaussian_Q(4);
  unsigned least = 0, greatest = n;
  while (gsl_cdf_binomial_P(least, 0.95, n) < chance) ++least;
  while (gsl_cdf_binomial_Q(greatest - 1, 0.95, n) < chance) --greatest;
  return {static_cast<double>(least) / n, static_cast<double>(greatest) / n};
}

/// Shares that held the truth, lowest and highest; a gate a case on the share farthest from 0.95.
std::pair<double, double> cover(StudyResult& result, int trials) {
  const auto [least, greatest] = plausible_shares(trials);
  Table table(
      {{"law"},
       {"times"},
       {"parameter"},
       {"truth"},
       {"stated error / truth", "", {.digits = 3}},
       {"share of intervals that hold the truth", "", {.digits = 4}}},
      fmt::format("Synthetic measurements, fitted {} times: value +- 1.96 standard errors against the truth", trials));
  const auto cases = coverage_cases();
  console::Progress progress("verify fit", cases.size());
  double lowest = 1, highest = 0;
  for (const CoverageCase& one : cases) {
    double farthest = 0.95;
    for (const Coverage& c : coverage_of(one, trials)) {
      table.row({fit_name(c.request), c.with_times, c.parameter, c.truth, c.relative_error, c.share});
      if (std::abs(c.share - 0.95) > std::abs(farthest - 0.95)) farthest = c.share;
      lowest = std::min(lowest, c.share);
      highest = std::max(highest, c.share);
    }
    result.gates.push_back(
        between(case_name(one) + ": share of intervals that hold the truth", farthest, least, greatest));
    progress.advance();
  }
  result.tables.push_back(table);
  return {lowest, highest};
}

class FitStudy : public Study {
 public:
  std::string name() const override { return "fit"; }
  std::string title() const override { return "Laws from measured rebounds"; }
  std::string claim() const override {
    return "Fits to restitution against speed find the parameters that the data tell, within the errors that they "
           "state";
  }

  StudyResult run(const RunOptions& options) override {
    StudyResult result;
    const double scatter = fit_sources(result);
    const int trials = options.thorough ? 2000 : 300;
    const auto [lowest, highest] = cover(result, trials);
    const auto failed = std::count_if(result.gates.begin(), result.gates.end(), [](const Gate& g) { return !g.pass; });
    result.verdict = fmt::format(
        "An alpha that follows the speed leaves at most {} of the scatter about a constant restitution; 95 % intervals "
        "held the truth in {:.1f} to {:.1f} % of {} trials each{}.",
        console::significant(scatter, 2), 100 * lowest, 100 * highest, trials,
        failed == 0 ? "" : fmt::format("; gates that failed: {}", failed));
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> fit_study() { return std::make_unique<FitStudy>(); }

}  // namespace ricochet::verify
