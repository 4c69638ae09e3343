#include "chance.hpp"
#include "coverage.hpp"
#include "foretold.hpp"

#include <verify/registry.hpp>

#include <console/exit.hpp>
#include <console/gnuplot.hpp>
#include <console/law_colour.hpp>
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

bool said_to_misfit(const Fit& fit) {
  return std::any_of(fit.findings.begin(), fit.findings.end(),
                     [](const std::string& f) { return f.starts_with("misfit"); });
}

Table table_of(const Source& source, const std::vector<Fit>& fits) {
  const Fit& best = fits[calibration::preferred(fits).best.front()];
  Table table({{"law"},
               {"parameter"},
               {"value"},
               {"standard error", "", {.digits = 3}},
               {"unit"},
               {"scatter in en", "", {.digits = 3}},
               {"AIC over the best", "", {.digits = 4}},
               {"AICc over it", "", {.digits = 4}}},
              fmt::format("Laws fitted to {}", source.label));
  for (const Fit& fit : fits)
    for (const auto& p : fit.parameters)
      table.row({fit_name(fit.request), p.name, p.value, p.error, p.unit,
                 std::sqrt(fit.chi2 / static_cast<double>(fit.freedom)), fit.aic - best.aic,
                 fit.aicc.value() - best.aicc.value()});
  table.note(calibration::preference_text(fits));
  return table;
}

/// A line that another one may lie on is dashed, and so is the second of a colour.
const char* dashes(const Fit& fit) {
  return fit.request.law == kind_of<FractionalHertz> || fit.request.alpha_of_speed ? " dt 2" : "";
}

console::Figure figure_of(const Source& source, const std::vector<Measurement>& data, const std::vector<Fit>& fits) {
  const std::string file = source.file + ".csv";
  std::vector<console::Column> columns{{"velocity", "m/s"}, {"en"}};
  std::vector<console::Curve> curves{{.file = file,
                                      .what = "1:2",
                                      .style = "points pt 7 lc rgb 'black'",
                                      .title = source.measured ? "measured" : "published fit, sampled"}};
  const std::array drawn{&fit_of(fits, kind_of<Linear>), &fit_of(fits, kind_of<KuwabaraKono>),
                         &fit_of(fits, kind_of<FractionalHertz>), &fit_of(fits, kind_of<Fractional>, true)};
  for (const Fit* fit : drawn) {
    columns.push_back({fit_name(fit->request)});
    curves.push_back(
        {.file = file,
         .what = fmt::format("1:{}", columns.size()),
         .style = fmt::format("lines lc rgb '{}' lw 2{}", console::law_colour(fit_name(fit->request)), dashes(*fit)),
         .title = fit == drawn[0] ? "laws of constant restitution" : fit_name(fit->request)});
  }
  Table table(columns);
  for (std::size_t i = 0; i < data.size(); ++i) {
    std::vector<console::Cell> row{data[i].velocity, data[i].en};
    for (const Fit* fit : drawn) row.push_back(fit->predictions[i].en);
    table.row(row);
  }
  const auto range = source.measured ? std::nullopt : std::optional(std::pair(0.0, 1.0));
  const console::Panel panel{.x = {.label = "impact velocity [m/s]", .log = true},
                             .y = {.label = "restitution", .range = range},
                             .curves = curves};
  auto plot = console::with_key_below(panel, 3, 0.3);
  plot.layout->left = 0.15;  // restitutions close to 1 are long words
  return {source.file,
          fmt::format("Laws fitted to {}.", source.label),
          plot,
          {{file, table.csv()}},
          640,
          480,
          calibration::preference_text(fits)};
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

/// A law that follows the speed more freely than another never fits worse: α(v) contains the constant restitution, and
/// so does fractional-hertz, whose k = 0 its range ends a per mille of e_n short of.
void gate_nesting(std::vector<Gate>& gates, const std::string& file, const std::vector<Fit>& fits) {
  const double constant = fit_of(fits, kind_of<Fractional>).chi2;
  gates.push_back(at_most(file + ": sum of squares of alpha(v) over that of a constant alpha",
                          fit_of(fits, kind_of<Fractional>, true).chi2 / constant, 1 + 1e-6));
  gates.push_back(at_most(file + ": sum of squares of fractional-hertz over that of a constant restitution",
                          fit_of(fits, kind_of<FractionalHertz>).chi2 / constant, 1 + 1e-3));
}

void gate_constants(std::vector<Gate>& gates, const std::string& file, const std::vector<Fit>& fits,
                    const std::vector<Measurement>& data) {
  double mean = 0;
  for (const Measurement& m : data) mean += m.en / static_cast<double>(data.size());
  for (const Fit& fit : fits) {
    if (follows_speed(fit.request)) continue;
    // Least squares of a constant is the mean; the forward model is good to 1e-9, Gauss-Newton to more.
    gates.push_back(near(fmt::format("{}: {} has the mean restitution", file, fit_name(fit.request)),
                         fit.predictions[0].en, mean, 1e-8));
  }
}

/// One line of a table: which law the AIC prefers, and what α is.
void add_preference(Table& table, const Source& source, const std::vector<Fit>& fits) {
  const auto found = calibration::preferred(fits);
  std::vector<std::string> names;
  for (const std::size_t place : found.best) names.push_back(fit_name(fits[place].request));
  const auto& fractional = fit_of(fits, kind_of<Fractional>).parameters.at(0);
  const auto& hertz = fit_of(fits, kind_of<FractionalHertz>).parameters.at(0);
  table.row({source.file, fmt::format("{}", fmt::join(names, ", ")), found.ahead,
             found.next ? fit_name(fits[*found.next].request) : "", fractional.value, fractional.error, hertz.value,
             hertz.error});
}

/// Fits to two thirds of the speeds against the third: a table, and gates where there is noise to judge by.
void add_foretold(StudyResult& result, Table& table, const Source& source, const std::vector<Measurement>& data,
                  const std::vector<Fit>& fits) {
  for (const Thirds& of : thirds(data)) {
    const Foretold told = foretell(of);
    const std::size_t best = told.preferred(), nearest = told.nearest();
    table.row({source.file, of.left_out, fit_name(told.fits[best].request), told.miss[best], told.miss[0],
               fit_name(told.fits[nearest].request), told.miss[nearest]});
    if (!source.measured) continue;
    const auto [least, greatest] =
        plausible_f(static_cast<double>(of.rest.size()), static_cast<double>(told.fits[best].freedom));
    result.gates.push_back(between(fmt::format("{}: F of the {} third, foretold by {}, between its 0.1 % points",
                                               source.file, of.left_out, fit_name(told.fits[best].request)),
                                   chow(fits[best], told.fits[best]), least, greatest));
  }
}

/// What the sources show: gates, tables and figures go to `result`; the greatest scatter of α(v) over that of a
/// constant α among those that follow the speed.
double fit_sources(StudyResult& result) {
  Table preferences({{"data"},
                     {"the AIC prefers"},
                     {"by", "", {.digits = 4}},
                     {"before"},
                     {"alpha, fractional", "", {.digits = 4}},
                     {"its error", "", {.digits = 2}},
                     {"alpha, fractional-hertz", "", {.digits = 4}},
                     {"its error", "", {.digits = 2}}},
                    "Which law the data prefer");
  Table foretold({{"data"},
                  {"left out"},
                  {"the AIC of the rest prefers"},
                  {"its rms miss of en", "", {.digits = 2}},
                  {"that of a constant", "", {.digits = 2}},
                  {"nearest"},
                  {"its miss", "", {.digits = 2}}},
                 "What fits to two thirds of the speeds foretell of the third that was left out");
  double greatest = 0;
  for (const Source& source : sources()) {
    const auto data = read(source);
    const auto fits = all_fits(data);
    result.tables.push_back(table_of(source, fits));
    result.figures.push_back(figure_of(source, data, fits));
    gate_constants(result.gates, source.file, fits, data);
    gate_nesting(result.gates, source.file, fits);
    add_preference(preferences, source, fits);
    add_foretold(result, foretold, source, data, fits);
    if (source.measured) continue;
    for (const Fit& fit : fits)
      if (!follows_speed(fit.request))
        result.gates.push_back(
            holds(fmt::format("{}: {} is said to misfit", source.file, fit_name(fit.request)), said_to_misfit(fit)));
    const Fit& constant = fit_of(fits, kind_of<Fractional>);
    const Fit& of_speed = fit_of(fits, kind_of<Fractional>, true);
    result.gates.push_back(speed_matters(source.file, constant, of_speed));
    greatest = std::max(greatest, std::sqrt(of_speed.chi2 / constant.chi2));
  }
  result.tables.push_back(preferences);
  result.tables.push_back(foretold);
  return greatest;
}

/// What Kharaz's figures leave of e_n(v).
Remark on_alumina() {
  double weights = 0, sum = 0, slowest = std::numeric_limits<double>::infinity(), fastest = 0, misfit = 0;
  const auto rows = alumina("oblique_kharaz2001");
  for (const NormalRestitution& r : rows) {
    const double weight = 1 / (r.sigma * r.sigma);
    weights += weight, sum += weight * r.en;
    slowest = std::min(slowest, r.velocity), fastest = std::max(fastest, r.velocity);
  }
  for (const NormalRestitution& r : rows) misfit += std::pow((r.en - sum / weights) / r.sigma, 2);
  return {
      "Kharaz et al. 2001",
      fmt::format("their figures have no e_n; e_t and the angle of rebound leave of it {:.3f} +- {:.3f} from {:.1f} "
                  "to {:.1f} m/s, where angles are read to {} degrees (chi2 {:.1f} of {}): one number, and no e_n(v) "
                  "to compare laws by",
                  sum / weights, 1 / std::sqrt(weights), slowest, fastest, reading_error, misfit, rows.size() - 1)};
}

/// What the AIC and left-out data do where the truth is known.
void gate_by_synthetic_data(StudyResult& result, int trials) {
  const auto foretold = plausible_shares(0.95, trials);
  result.gates.push_back(between("fractional-hertz: share of left-out thirds within the 95 % point",
                                 share_foretold(trials), foretold.first, foretold.second));
  const auto misled = plausible_shares(misled_by_chance, trials);
  result.gates.push_back(between("constant alpha: share of data in which the AIC prefers alpha(v)",
                                 share_misled(trials), misled.first, misled.second));
}

std::string case_name(const CoverageCase& one) {
  return fit_name(one.request) + (one.with_times ? ", with times" : ", without times");
}

/// Shares that held the truth, lowest and highest; a gate a case on the share farthest from 0.95.
std::pair<double, double> cover(StudyResult& result, int trials) {
  const auto [least, greatest] = plausible_shares(0.95, trials);
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
    result.remarks.push_back(on_alumina());
    gate_by_synthetic_data(result, trials);
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
