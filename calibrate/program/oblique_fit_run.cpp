#include "oblique_fit_run.hpp"

#include "measurements.hpp"
#include "report.hpp"

#include <console/csv.hpp>
#include <console/json.hpp>
#include <console/number.hpp>
#include <console/output.hpp>
#include <console/table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <regex>
#include <string>
#include <utility>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using console::Json;
using console::Table;

constexpr double degree = std::numbers::pi / 180;

enum Column : std::size_t {
  angle,
  speed,
  normal_velocity,
  tangential_velocity,
  et,
  et_sigma,
  rebound_angle,
  rebound_angle_sigma,
  spin,
  spin_sigma,
  quantity,
  value,
  sigma,
  count
};
// Angles are in degrees, which is what people write.
constexpr std::array<console::CsvColumn, count> columns{
    console::CsvColumn{
        .name = "angle", .unit = "deg", .aliases = "impact angle,angle of impact,impact_angle_deg,angle_deg,theta"},
    {.name = "velocity", .unit = "m/s", .aliases = "v,v0,speed,impact velocity,impact speed"},
    {.name = "normal_velocity", .unit = "m/s", .aliases = "v_n,vn"},
    {.name = "tangential_velocity", .unit = "m/s", .aliases = "v_t,vt"},
    {.name = "et", .aliases = "e_t,tangential restitution"},
    {.name = "et_sigma", .aliases = "e_t_sigma,sigma_et"},
    {.name = "rebound_angle", .unit = "deg", .aliases = "angle of rebound,rebound_angle_deg"},
    {.name = "rebound_angle_sigma", .unit = "deg"},
    {.name = "spin", .unit = "1/s", .aliases = "omega,rebound spin,spin after"},
    {.name = "spin_sigma", .unit = "1/s", .aliases = "omega_sigma"},
    {.name = "quantity"},
    {.name = "value"},
    {.name = "sigma"}};

class Reader {
 public:
  Reader(const std::string& path, double usual_speed)
      : file_(path, columns, console::Unknown::ignored), usual_speed_(usual_speed) {}

  std::vector<ObliqueMeasurement> all() {
    check_head();
    std::vector<ObliqueMeasurement> data;
    while (file_.next()) {
      data.push_back(row());
      if (!data.back().et && !data.back().rebound_angle && !data.back().spin)
        file_.fail("row: must have et, rebound_angle or spin");
    }
    if (data.empty()) file_.fail("no rows: must be a header with angle and et, rebound_angle or spin, and impacts");
    return data;
  }
  std::vector<std::string> ignored() const { return file_.ignored(); }

 private:
  void check_head() const {
    if (!file_.has(angle) && !(file_.has(normal_velocity) && file_.has(tangential_velocity)))
      file_.fail("column angle: missing: must be given, or normal_velocity and tangential_velocity");
    if (file_.has(angle) && file_.has(tangential_velocity))
      file_.fail("column = tangential_velocity: must be left out with angle");
    if (file_.has(quantity) != file_.has(value)) file_.fail("quantity and value: must be given together");
    for (const auto& [error, of] : {std::pair(et_sigma, et), {rebound_angle_sigma, rebound_angle}, {spin_sigma, spin}})
      if (file_.has(error) && !file_.has(of))
        file_.fail(fmt::format("column = {}: must be left out without {}", columns[error].name, columns[of].name));
    check_errors();
    if (!file_.has(quantity) && !file_.has(et) && !file_.has(rebound_angle) && !file_.has(spin))
      file_.fail("column et: missing: must be given, or rebound_angle, spin, or quantity and value");
  }

  /// Standard errors of all that was measured or of nothing: else nobody could weigh one against the other.
  void check_errors() const {
    constexpr std::array<std::pair<Column, Column>, 4> pairs{
        std::pair(et, et_sigma), {rebound_angle, rebound_angle_sigma}, {spin, spin_sigma}, {value, sigma}};
    const auto some = std::find_if(pairs.begin(), pairs.end(), [&](const auto& p) { return file_.has(p.second); });
    if (some == pairs.end()) return;
    for (const auto& [of, error] : pairs)
      if (file_.has(of) && !file_.has(error))
        file_.fail(fmt::format("column {}: missing: must be given with {}, errors for every quantity or for none",
                               columns[error].name, columns[some->second].name));
  }

  double positive(std::size_t column) const {
    const double number = file_.number(column, "a number in [1e-30, 1e30]");
    if (!(number >= 1e-30 && number <= 1e30)) file_.reject(column, "a number in [1e-30, 1e30]");
    return number;
  }

  std::optional<Observed> observed(std::size_t column, std::size_t error, double unit) const {
    if (!file_.has(column) || file_.text(column).empty()) return std::nullopt;
    Observed o{unit * file_.number(column)};
    if (file_.has(error)) o.sigma = unit * positive(error);
    return o;
  }

  /// One quantity a row.
  void add_value(ObliqueMeasurement& m) const {
    const std::string_view what = file_.text(quantity);
    Observed o{file_.number(value)};
    if (file_.has(sigma)) o.sigma = positive(sigma);
    if (what == "et")
      m.et = o;
    else if (what == "spin")
      m.spin = o;
    else if (what == "angle" || what == "rebound_angle")
      m.rebound_angle = Observed{o.value * degree, o.sigma * degree};
    else
      file_.reject(quantity, "et, rebound_angle (or angle) or spin");
  }

  ObliqueMeasurement row() const {
    ObliqueMeasurement m{};
    m.line = file_.line();
    if (file_.has(angle)) {
      const double degrees = file_.number(angle, "in (0, 90)");
      if (!(degrees > 0 && degrees < 90)) file_.reject(angle, "in (0, 90)");
      const double v = file_.has(speed) ? positive(speed) : usual_speed_;
      const bool along = file_.has(normal_velocity);
      m.normal_velocity = along ? positive(normal_velocity) : v * std::cos(degrees * degree);
      m.tangential_velocity = m.normal_velocity * std::tan(degrees * degree);
    } else {
      m.normal_velocity = positive(normal_velocity);
      m.tangential_velocity = positive(tangential_velocity);
    }
    m.et = observed(et, et_sigma, 1);
    m.rebound_angle = observed(rebound_angle, rebound_angle_sigma, degree);
    m.spin = observed(spin, spin_sigma, 1);
    if (file_.has(quantity)) add_value(m);
    return m;
  }

  console::CsvReader file_;
  double usual_speed_;
};

struct FitOf {
  Report normal;
  ObliqueFitRequest request;
  std::vector<ObliqueMeasurement> data;
  ObliqueFit fit;
  std::vector<std::string> notes;
  bool timed = false;  ///< a scale was given, so that k_t and c_t mean something
};

Table parameter_table(const FitOf& f) {
  Table table({{"parameter"}, {"value"}, {"standard error", "", {.digits = 3}}, {"unit"}},
              fmt::format("Friction and spring ({}) beside the {} law, ended by {}, en = {}", text(f.request.form),
                          name(f.request.normal), text(f.request.end),
                          console::significant(f.normal.results.front().achieved.en, 6)));
  for (const Estimate& p : f.fit.parameters) table.row({p.name, p.value, p.error, p.unit});
  if (f.fit.parameters.size() == 2)
    table.note(fmt::format("correlation of both: {}", console::fixed(f.fit.correlation, 3)));
  for (const auto& assumption : f.normal.job.assumptions) table.note("assumed: " + assumption);
  for (const auto& note : f.notes) table.note(note);
  const bool known = f.fit.errors_known;
  table.note(fmt::format("{} = {}, {} degrees of freedom{}", known ? "chi2" : "sum of squares",
                         console::significant(f.fit.chi2, 4), f.fit.freedom,
                         known ? fmt::format(", probability {}", console::significant(f.fit.probability, 3)) : ""));
  if (f.fit.parameters.size() == 2) {
    table.note(fmt::format("beta0 = {}", console::significant(f.fit.beta0, 4)));
    if (f.fit.turn.value_or(0) <= std::numbers::pi)
      table.note(fmt::format("for a run: --tangential {} --beta0 {} --mu {}", text(f.request.form),
                             console::significant(f.fit.beta0, 4), console::significant(f.fit.mu, 4)));
    else
      table.note("the spring turns back after more than half a period: no --beta0 makes it, its k_t does");
  }
  return table;
}

/// Beside a linear spring k.
std::optional<double> stiffness_ratio(const FitOf& f) {
  const auto* linear = std::get_if<Linear>(&f.request.normal);
  return linear ? std::optional(f.fit.law.k_t() / linear->k()) : std::nullopt;
}

/// k_t and c_t, where t_col is known, and k_t/k beside a spring in ζ, which no time is needed for.
std::optional<Table> spring_table(const FitOf& f) {
  if (f.fit.parameters.size() != 2) return std::nullopt;
  Table table({{"parameter"}, {"value"}, {"unit"}}, "The spring that it makes");
  if (f.timed) {
    table.row({"k_t", f.fit.law.k_t(), "kg/s^2"});
    table.row({"c_t", f.fit.law.c_t(), "kg/s"});
  }
  if (const auto ratio = stiffness_ratio(f)) table.row({"k_t/k", *ratio, ""});
  return table;
}

/// To the 14 digits that survive the way through both velocities: 30.127, not 30.126999999999995.
double impact_degrees(const ObliqueMeasurement& m) {
  return std::stod(console::significant(std::atan2(m.tangential_velocity, m.normal_velocity) / degree, 14));
}

Table comparison_table(const FitOf& f) {
  const console::Notation four{console::Notation::Kind::significant, 5};
  Table table({{"angle", "deg", four},
               {"et", "", four},
               {"et, fit", "", four},
               {"rebound angle", "deg", four},
               {"rebound angle, fit", "deg", four},
               {"spin", "1/s", four},
               {"spin, fit", "1/s", four}},
              "Measured and fitted");
  for (std::size_t i = 0; i < f.data.size(); ++i) {
    const ObliqueMeasurement& m = f.data[i];
    const ObliquePrediction& p = f.fit.predictions[i];
    const auto cell = [](const std::optional<Observed>& o, double unit) {
      return o ? console::Cell(o->value / unit) : console::blank();
    };
    table.row({impact_degrees(m), cell(m.et, 1), p.et, cell(m.rebound_angle, degree), p.rebound_angle / degree,
               cell(m.spin, 1), f.request.radius > 0 ? console::Cell(p.spin) : console::blank()});
  }
  return table;
}

std::vector<Table> tables_of(const FitOf& f) {
  std::vector<Table> tables{parameter_table(f)};
  if (const auto spring = spring_table(f); spring && !spring->rows().empty()) tables.push_back(*spring);
  Table findings({{"finding"}}, "What the data do not tell, and what does not fit");
  for (const auto& finding : f.fit.findings) findings.row({finding});
  if (!f.fit.findings.empty()) tables.push_back(findings);
  tables.push_back(comparison_table(f));
  return tables;
}

std::string document_of(const FitOf& f) {
  Json out{{"schema", "ricochet/oblique-fit/1"}, {"law", name(f.request.normal)},       {"end", text(f.request.end)},
           {"tangential", text(f.request.form)}, {"assumed", f.normal.job.assumptions}, {"notes", f.notes}};
  out["units"] = {{"angle", "rad"}, {"rebound_angle", "rad"}, {"spin", "1/s"}, {"k_t", "kg/s^2"}, {"c_t", "kg/s"}};
  out["parameters"] = Json::array();
  for (const Estimate& p : f.fit.parameters)
    out["parameters"].push_back({{"name", p.name}, {"value", p.value}, {"standard_error", p.error}});
  out["correlation"] = f.fit.parameters.size() == 2 ? Json(f.fit.correlation) : Json();
  out["beta0"] = f.fit.parameters.size() == 2 ? Json(f.fit.beta0) : Json();
  const auto ratio = stiffness_ratio(f);
  out["k_t/k"] = f.fit.parameters.size() == 2 && ratio ? Json(*ratio) : Json();
  if (f.timed && f.fit.parameters.size() == 2) out["spring"] = {{"k_t", f.fit.law.k_t()}, {"c_t", f.fit.law.c_t()}};
  out["chi2"] = f.fit.chi2;
  out["degrees_of_freedom"] = f.fit.freedom;
  out["errors_known"] = f.fit.errors_known;
  out["probability"] = f.fit.errors_known ? Json(f.fit.probability) : Json();
  out["fitted"] = Json::array();
  for (std::size_t i = 0; i < f.data.size(); ++i) {
    const ObliqueMeasurement& m = f.data[i];
    const ObliquePrediction& p = f.fit.predictions[i];
    out["fitted"].push_back({{"angle", std::atan2(m.tangential_velocity, m.normal_velocity)},
                             {"et", p.et},
                             {"rebound_angle", p.rebound_angle},
                             {"spin", f.request.radius > 0 ? Json(p.spin) : Json()}});
  }
  out["findings"] = f.fit.findings;
  return console::document(out);
}

/// The normal law that the flags say, one law and one end; without a scale t_col has no part in μ and β₀.
Report normal_law(const Options& options, bool& timed) {
  Options one = options;
  if (one.law.empty()) one.law = "linear";
  if (one.law == "all") throw BadInput("--law", "all", "one law with oblique data");
  if (one.end.empty()) one.end = "force";
  if (one.end == "both") throw BadInput("--end", "both", "overlap or force with oblique data");
  one.asked.beta0 = one.asked.mu = std::nullopt;
  one.asked.form.reset();
  timed = speaks_of(one.asked, Topic::scale);
  if (!timed) one.asked.tcol = 1e-4;
  Report report = run(job_of(one), {.method = Method::direct});
  if (!timed) report.job.assumptions.push_back("collision time 1e-04 s, which has no part in mu and beta0 (--tcol)");
  if (report.results.empty())
    throw console::Unreachable(report.infeasible.empty() ? report.failed.front().reason
                                                         : explained(report.infeasible.front(), Spelling::flags));
  return report;
}

/// The radius of the sphere that was looked at, and the share of its spin.
void take_bodies(FitOf& f, const Options& options) {
  const Asked& a = options.asked;
  if (a.radius2 || a.diameter2 || a.density2)
    throw BadInput(
        "--radius2, --diameter2 and --density2: must be left out with oblique data: --wall or equal spheres");
  if (a.radius) f.request.radius = *a.radius;
  if (a.diameter) f.request.radius = *a.diameter / 2;
  f.request.spin_share = a.wall ? 1 : 0.5;
  const bool spins = std::any_of(f.data.begin(), f.data.end(), [](const auto& m) { return m.spin.has_value(); });
  if (spins && !(f.request.radius > 0))
    throw BadInput("--radius: missing: must be given (or --diameter), with --density, where spins were measured");
}

}  // namespace

bool is_oblique(const std::string& path) {
  if (path == "-") return false;
  console::LineBlocks source(path);
  console::LineBlocks::Block block;
  auto head = console::take_csv_head(source, block);
  if (!head) return false;
  const bool normal = states_restitution(path, *head);
  // Units are the reader's to refuse: by its name alone a column tells what the file is.
  head->text = std::regex_replace(head->text, std::regex(R"(\s*[\[(][^\])]*[\])])"), "");
  try {
    const console::CsvColumns known(path, *head, columns, console::Unknown::ignored);
    const bool rebound = known.has(et) || known.has(rebound_angle) || known.has(spin) || known.has(quantity);
    return known.has(tangential_velocity) || (known.has(angle) && (rebound || !normal));
  } catch (const BadInput&) {  // then the other reader says what is wrong
    return false;
  }
}

std::vector<ObliqueMeasurement> read_oblique(const std::string& path, double speed, std::vector<std::string>& ignored) {
  Reader reader(path, speed);
  auto data = reader.all();
  ignored = reader.ignored();
  return data;
}

console::Exit run_oblique_fit(const Options& options) {
  take_only(options, "--fit of oblique impacts",
            flags_of({Topic::scale, Topic::loss, Topic::impact},
                     {"--fit", "--law", "--end", "--match", "--wall", "--tangential", "--format", "--output"}));
  FitOf f{};
  std::vector<std::string> assumed;
  f.data = read_oblique(options.fit, velocity_of(options.asked, Spelling::flags, assumed), assumed);
  if (!assumed.empty()) f.notes.push_back(fmt::format("columns that are not read: {}", fmt::join(assumed, ", ")));
  f.normal = normal_law(options, f.timed);
  const Calibration& r = f.normal.results.front();
  f.request = {.form = options.asked.form.value_or(TangentialForm::undamped),
               .normal = r.law,
               .end = r.end,
               .tcol = r.request.target.tcol,
               .mass_eff = r.request.target.impact.mass_eff};
  take_bodies(f, options);
  for (const ObliqueMeasurement& m : f.data)
    if (const auto why = impossible(f.request, m)) throw BadInput(fmt::format("{}:{}: {}", options.fit, m.line, *why));
  try {
    f.fit = fit_oblique(f.request, f.data);
  } catch (const std::invalid_argument& misuse) {
    throw BadInput(fmt::format("{}: {}", options.fit, misuse.what()));
  }
  console::Output output(options.output.file);
  output.write(options.output.format == console::Format::json
                   ? document_of(f)
                   : console::render_all(tables_of(f), options.output.format));
  output.commit();
  return console::Exit::done;
}

}  // namespace ricochet::calibration
