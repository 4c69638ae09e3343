#include "results.hpp"

#include <console/csv.hpp>
#include <console/exit.hpp>
#include <console/harmless.hpp>
#include <console/input.hpp>
#include <console/number.hpp>
#include <console/table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

namespace ricochet::verify::conformance {

namespace {

namespace fs = std::filesystem;

enum Column { name, steps, body, x, y, z, vx, vy, vz, wx, wy, wz, contact_time, max_overlap, note };
constexpr std::array columns{console::CsvColumn{"case", "", true},
                             console::CsvColumn{"steps"},
                             console::CsvColumn{"body"},
                             console::CsvColumn{"x", "m"},
                             console::CsvColumn{"y", "m"},
                             console::CsvColumn{"z", "m"},
                             console::CsvColumn{"vx", "m/s"},
                             console::CsvColumn{"vy", "m/s"},
                             console::CsvColumn{"vz", "m/s"},
                             console::CsvColumn{"wx"},
                             console::CsvColumn{"wy"},
                             console::CsvColumn{"wz"},
                             console::CsvColumn{"contact_time", "s"},
                             console::CsvColumn{"max_overlap", "m"},
                             console::CsvColumn{"note"}};
constexpr int most_steps = 10'000'000;
constexpr double greatest = 1e100;

/// Words of a file that go on to terminals and other files: no control characters, no beginning like a formula's.
std::string harmless(std::string_view text) {
  while (!text.empty() && std::string_view("=+-@ ").find(text.front()) != std::string_view::npos) text.remove_prefix(1);
  return console::without_controls(std::string(text));
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// "# key: value" of the file's remarks, a byte order mark before the first; empty where there is none.
std::string remark(std::string_view text, std::string_view key) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  while (!text.empty()) {
    std::string_view line = trimmed(console::take_line(text));
    if (!line.starts_with('#')) continue;
    line = trimmed(line.substr(1));
    if (!line.starts_with(key)) continue;
    line = trimmed(line.substr(key.size()));
    if (line.starts_with(':')) return harmless(trimmed(line.substr(1)));
  }
  return {};
}

/// How a number is spelt.
struct Spelling {
  int digits = 0;  ///< from the first that is not 0 on
  int places = 0;  ///< behind the point
  bool exponent = false;
};
Spelling spelling_of(std::string_view text) {
  Spelling s;
  bool behind = false;
  for (const char c : text) {
    if (c == 'e' || c == 'E') return s.exponent = true, s;
    const bool digit = c >= '0' && c <= '9';
    if (digit && (c != '0' || s.digits > 0)) ++s.digits;
    if (digit && behind) ++s.places;
    behind = behind || c == '.' || c == ',';
  }
  return s;
}

/// Half a unit of the last of so many digits.
double half_unit(double value, int digits) {
  return value == 0 ? 0 : 0.5 * std::pow(10, std::floor(std::log10(std::abs(value))) + 1 - digits);
}

/// How finely a file's numbers are printed.
class Printing {
 public:
  void take(Column column, double value, std::string_view text) {
    const Spelling s = spelling_of(text);
    const bool point = s.places > 0 && !s.exponent;
    if (digits_ == 0) places_ = s.places;
    fixed_ = fixed_ && point && s.places == places_;
    digits_ = std::max({digits_, s.digits, 1});
    // Units may differ by column.
    unit_[column] = std::max(unit_[column], half_unit(value, s.digits));
  }
  double rounded(Column column, double value) const { return fixed_ ? unit(column) : half_unit(value, digits_); }

 private:
  /// Of a column that is 0 throughout that of its neighbours, which have the same unit, else of what has no other.
  double unit(Column column) const {
    if (unit_[column] > 0) return unit_[column];
    double of_kind = 0;
    if (column >= x && column <= wz) {
      const int first = x + (column - x) / 3 * 3;
      for (int k = first; k < first + 3; ++k) of_kind = std::max(of_kind, unit_[static_cast<std::size_t>(k)]);
    }
    return of_kind > 0 ? of_kind : 0.5 * std::pow(10, -places_);
  }

  int digits_ = 0, places_ = 0;
  bool fixed_ = true;
  std::array<double, columns.size()> unit_{};
};

class Reader {
 public:
  Reader(const std::string& path, const std::vector<Case>& cases) : path_(path), cases_(cases), rows_(path, columns) {}

  std::vector<CaseResult> read() {
    while (rows_.next()) read_row();
    for (const CaseResult& result : results_) check_bodies(result);
    for (CaseResult& result : results_)
      std::sort(result.runs.begin(), result.runs.end(), [](const Run& a, const Run& b) { return a.steps < b.steps; });
    for (CaseResult& result : results_)
      for (Run& run : result.runs) note_rounding(run);
    return std::move(results_);
  }

 private:
  void read_row() {
    const Case& of = case_of_row();
    CaseResult& result = result_of(of);
    if (rows_.has(note) && !rows_.text(note).empty()) result.note = harmless(rows_.text(note));
    if (!rows_.has(steps) || rows_.text(steps).empty()) {
      if (result.note.empty()) rows_.fail("steps = : must be a whole number, or there is a note why it was not run");
      if (!seen_.insert({of.name, 0, 0}).second) rows_.reject(name, "given once without steps");
      return;
    }
    const int n = whole(steps, most_steps);
    const auto which = static_cast<std::size_t>(whole(body, static_cast<int>(of.bodies.size())));
    if (!seen_.insert({of.name, n, which}).second) rows_.reject(body, "given once a case and steps");
    Run& run = run_of(result, of, n);
    Body& b = run.bodies[which - 1];
    b.position = {number(x), number(y), number(z)};
    b.velocity = {number(vx), number(vy), number(vz)};
    b.spin = {number(wx), number(wy), number(wz)};
    if (which != 1) return;
    run.contact_time = optional_number(contact_time);
    run.max_overlap = optional_number(max_overlap);
  }
  const Case& case_of_row() {
    const auto found =
        std::find_if(cases_.begin(), cases_.end(), [&](const Case& c) { return c.name == rows_.text(name); });
    if (found == cases_.end()) rows_.reject(name, "one of verify conformance --list");
    return *found;
  }
  CaseResult& result_of(const Case& of) {
    const auto found =
        std::find_if(results_.begin(), results_.end(), [&](const CaseResult& r) { return r.name == of.name; });
    return found != results_.end() ? *found : results_.emplace_back(CaseResult{of.name});
  }
  static Run& run_of(CaseResult& result, const Case& of, int n) {
    const auto found = std::find_if(result.runs.begin(), result.runs.end(), [&](const Run& r) { return r.steps == n; });
    return found != result.runs.end() ? *found : result.runs.emplace_back(Run{n, of.bodies});
  }
  int whole(Column column, int most) {
    const std::string accepted = fmt::format("a whole number from 1 to {}", most);
    const double value = rows_.number(column, accepted);
    if (!(value >= 1 && value <= most && value == std::floor(value))) rows_.reject(column, accepted);
    return static_cast<int>(value);
  }
  /// What squares and quotients of two are still finite of.
  double number(Column column) {
    const double value = rows_.number(column);
    if (std::abs(value) > greatest) rows_.reject(column, fmt::format("at most {:g}", greatest));
    printing_.take(column, value, rows_.text(column));
    return value;
  }
  std::optional<double> optional_number(Column column) {
    if (!rows_.has(column) || rows_.text(column).empty()) return std::nullopt;
    return number(column);
  }
  /// Once all of the file is read.
  void note_rounding(Run& run) const {
    const auto of = [&](Column first, Vec3 v) {
      const auto at = [&](int i, double value) { return printing_.rounded(static_cast<Column>(first + i), value); };
      return Vec3{at(0, v.x), at(1, v.y), at(2, v.z)};
    };
    for (const Body& b : run.bodies)
      run.rounded.bodies.push_back(
          {.position = of(x, b.position), .velocity = of(vx, b.velocity), .spin = of(wx, b.spin)});
    if (run.contact_time) run.rounded.contact_time = printing_.rounded(contact_time, *run.contact_time);
    if (run.max_overlap) run.rounded.max_overlap = printing_.rounded(max_overlap, *run.max_overlap);
  }
  void check_bodies(const CaseResult& result) const {
    for (const Run& run : result.runs)
      for (std::size_t which = 1; which <= run.bodies.size(); ++which)
        if (!seen_.contains({result.name, run.steps, which}))
          throw console::BadInput(fmt::format("{}: case {}, {} steps: body {} is missing: must be all {}", path_,
                                              result.name, run.steps, which, run.bodies.size()));
  }

  std::string path_;
  const std::vector<Case>& cases_;
  console::CsvReader rows_;
  std::vector<CaseResult> results_;
  Printing printing_;
  std::set<std::tuple<std::string, int, std::size_t>> seen_;
};

}  // namespace

const CaseResult* Results::find(const std::string& wanted) const {
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const CaseResult& r) { return r.name == wanted; });
  return found == cases.end() ? nullptr : &*found;
}

Results read_results(const std::string& path, const std::vector<Case>& cases) {
  // For its remarks, then for its rows.
  if (std::error_code error; fs::exists(path, error) && !fs::is_regular_file(path, error))
    throw console::BadInput(path + ": must be a file, as it is read twice; a pipe's text goes to one first");
  const std::string text = console::read_text(path);
  Results results{remark(text, "engine"), remark(text, "version"), remark(text, "date"), remark(text, "by")};
  for (const auto& [key, value] : {std::pair("engine", results.engine), std::pair("version", results.version)})
    if (value.empty())
      throw console::BadInput(fmt::format("{}: a line \"# {}: …\" is missing: must name the {}", path, key,
                                          key == std::string("engine") ? "engine" : "engine's version"));
  results.cases = Reader(path, cases).read();
  if (results.cases.empty())
    throw console::BadInput(fmt::format("{}: no rows: must be a file with a row a run and body", path));
  return results;
}

std::string results_text(const Results& results) {
  std::string text = fmt::format("# engine: {}\n# version: {}\n# date: {}\n# by: {}\n", results.engine, results.version,
                                 results.date, results.by);
  console::Table table({{"case"},
                        {"steps"},
                        {"body"},
                        {"x"},
                        {"y"},
                        {"z"},
                        {"vx"},
                        {"vy"},
                        {"vz"},
                        {"wx"},
                        {"wy"},
                        {"wz"},
                        {"contact_time"},
                        {"max_overlap"},
                        {"note"}});
  for (const CaseResult& result : results.cases) {
    if (result.runs.empty()) {
      std::vector<console::Cell> cells(table.columns().size(), console::blank());
      cells.front() = result.name, cells.back() = result.note;
      table.row(cells);
    }
    for (const Run& run : result.runs)
      for (std::size_t i = 0; i < run.bodies.size(); ++i) {
        const Body& b = run.bodies[i];
        const auto first = [&](const std::optional<double>& v) {
          return i == 0 && v ? console::Cell(*v) : console::blank();
        };
        table.row({result.name, std::int64_t{run.steps}, static_cast<std::int64_t>(i + 1), b.position.x, b.position.y,
                   b.position.z, b.velocity.x, b.velocity.y, b.velocity.z, b.spin.x, b.spin.y, b.spin.z,
                   first(run.contact_time), first(run.max_overlap), result.note});
      }
  }
  return text + table.csv();
}

}  // namespace ricochet::verify::conformance
