#include <verify/registry.hpp>

#include <calibrate/fit.hpp>

#include <console/csv.hpp>
#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/progress.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace ricochet::verify {

namespace {

using calibration::Fit;
using calibration::FitRequest;
using calibration::LawName;
using calibration::Measurement;
using console::Table;

// Any mass will do where there are no collision times: e_n then depends on the combinations that the fit reports.
constexpr double mass = 7.06858e-6;

struct Source {
  std::string file, label;
};
const std::array sources{Source{"restitution_ice_bridges1984", "frosted ice, 210 K (Bridges et al. 1984, their fit)"},
                         Source{"restitution_ice_hatzes1988", "compacted frost, 123 K (Hatzes et al. 1988, their fit)"}};

std::vector<Measurement> read(const std::string& file) {
  const std::string path = data_folder() + "/" + file + ".csv";
  console::LineBlocks source(path);
  std::vector<Measurement> data;
  for (console::LineBlocks::Block block; source.next(block);)
    for (std::string_view text = block.text; !text.empty();) {
      const auto line = console::take_line(text);
      if (console::is_csv_remark(line) || line.starts_with("velocity")) continue;
      std::array<std::string_view, 2> fields;
      const auto count = console::split_csv(line, fields);
      const auto velocity = console::parse_number(fields[0]), en = console::parse_number(fields[1]);
      if (count != 2 || !velocity || !en) throw console::Failed(path + ": " + std::string(line) + ": not velocity,en");
      data.push_back({*velocity, *en});
    }
  return data;
}

std::vector<Fit> all_fits(const std::vector<Measurement>& data) {
  std::vector<Fit> fits;
  for (const LawName law : {LawName::linear, LawName::kuwabara_kono, LawName::tsuji, LawName::hysteretic, LawName::fractional})
    fits.push_back(fit_law({law, ContactEnd::force, mass}, data));
  fits.push_back(fit_law({LawName::fractional, ContactEnd::force, mass, true}, data));
  return fits;
}

bool constant(const Fit& fit) { return fit.request.law != LawName::kuwabara_kono && !fit.request.alpha_of_speed; }

Table table_of(const Source& source, const std::vector<Fit>& fits) {
  const auto best = std::min_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.aic < b.aic; });
  Table table({{"law"}, {"parameter"}, {"value"}, {"standard error", "", {.digits = 3}}, {"unit"}, {"scatter in en", "", {.digits = 3}},
               {"AIC over the best", "", {console::Notation::Kind::fixed, 1}}},
              "Laws fitted to " + source.label);
  for (const Fit& fit : fits)
    for (const auto& p : fit.parameters)
      table.row({fit_name(fit.request), p.name, p.value, p.error, p.unit,
                 std::sqrt(fit.chi2 / static_cast<double>(fit.freedom)), fit.aic - best->aic});
  return table;
}

console::Figure figure_of(const Source& source, const std::vector<Measurement>& data, const std::vector<Fit>& fits) {
  std::vector<console::Column> columns{{"velocity", "m/s"}, {"en"}};
  std::string curves;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
    columns.push_back({fit_name(fits[i].request)});
    const std::string name = i == 0 ? "laws of constant restitution" : fit_name(fits[i].request);
    curves += ", '" + source.file + ".csv' skip 1 using 1:" + std::to_string(columns.size()) + " with lines lw 2 title '" + name + "'";
  }
  Table table(columns);
  for (std::size_t i = 0; i < data.size(); ++i)
    table.row({data[i].velocity, data[i].en, fits[0].predictions[i].en, fits[1].predictions[i].en, fits[5].predictions[i].en});
  return {source.file, "Laws fitted to " + source.label + ".",
          "set logscale x\nset grid\nset xlabel 'impact velocity [m/s]'\nset ylabel 'restitution'\nset yrange [0:1]\n"
          "plot '" + source.file + ".csv' skip 1 using 1:2 with points pt 7 lc rgb 'black' title 'published fit, sampled'" + curves,
          {{source.file + ".csv", table.csv()}}};
}

/// Share of the intervals value ± 1.96 errors that hold the truth, over synthetic data with known errors.
double coverage(const AnyLaw& law, LawName name, int trials) {
  std::mt19937_64 random(2004);
  std::normal_distribution<double> normal;
  const auto known = calibration::identifiable(law);
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<Measurement> data;
    for (int i = 0; i < 12; ++i) {
      const double v = 0.02 * std::pow(100.0, i / 11.0);
      const auto out = collide(law, {v, mass});
      const double sigma = 0.02 * out.tcol;
      data.push_back({v, out.en + 0.01 * normal(random), 0.01, out.tcol + sigma * normal(random), sigma});
    }
    const Fit fit = fit_law({name, ContactEnd::force, mass}, data);
    for (std::size_t i = 0; i < known.size(); ++i)
      held += std::abs(fit.parameters[i].value - known[i].value) <= 1.959964 * fit.parameters[i].error;
  }
  return held / static_cast<double>(trials * known.size());
}

class FitStudy : public Study {
 public:
  std::string name() const override { return "fit"; }
  std::string claim() const override {
    return "Fits to restitution against speed find the parameters that the data tell, within the errors that they state";
  }

  StudyResult run(const RunOptions& options) override {
    StudyResult result;
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
          result.gates.push_back(near(source.file + ": " + fit_name(fit.request) + " has the mean restitution", fit.predictions[0].en, mean, 1e-8));
          result.gates.push_back(holds(source.file + ": " + fit_name(fit.request) + " is said to misfit", fit.findings.size() == 2));
        }
      result.gates.push_back(at_most(source.file + ": scatter of alpha(v) over that of constant alpha",
                                     std::sqrt(fits[5].chi2 / fits[4].chi2), 0.5));
    }
    // 2000 trials: 0.95 ± 0.02, four standard deviations of a share. 150: 0.95 − 4 of them.
    const int trials = options.thorough ? 2000 : 150;
    const double slack = options.thorough ? 0.02 : 4 * std::sqrt(0.95 * 0.05 / trials);
    const std::array<std::pair<LawName, AnyLaw>, 5> truths{{{LawName::linear, Linear(5000, 0.1)},
                                                           {LawName::kuwabara_kono, KuwabaraKono(1.4e6, 30)},
                                                           {LawName::tsuji, Tsuji(1.4e6, 2)},
                                                           {LawName::hysteretic, Hysteretic(4000, 9000)},
                                                           {LawName::fractional, Fractional(5000, 0.3, 0.3)}}};
    console::Progress progress("verify fit", truths.size());
    for (const auto& [law, truth] : truths) {
      result.gates.push_back(between(std::string(text(law)) + ": share of " + std::to_string(trials) + " trials whose 95 % intervals hold the truth",
                                     coverage(truth, law, trials), 0.95 - slack, std::min(1.0, 0.95 + slack)));
      progress.advance();
    }
    result.verdict = "Neither ice is a law of constant restitution; an alpha that follows the speed leaves less than half the scatter, and "
                     "the stated errors hold the truth as often as they say.";
    if (!all_pass(result.gates)) result.verdict = "A gate failed: see the table of gates.";
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> fit_study() { return std::make_unique<FitStudy>(); }

}  // namespace ricochet::verify
