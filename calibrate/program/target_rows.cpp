#include "target_rows.hpp"

#include "report.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>

#include <algorithm>
#include <charconv>

namespace ricochet::calibration {
namespace {

using console::BadInput;

constexpr std::array all_laws{LawName::linear, LawName::kuwabara_kono, LawName::tsuji, LawName::hysteretic,
                              LawName::fractional};
constexpr std::size_t most_columns = 32;

AnyLaw specimen(LawName law) {
  switch (law) {
    case LawName::linear: return Linear(1, 1);
    case LawName::kuwabara_kono: return KuwabaraKono(1, 1);
    case LawName::tsuji: return Tsuji(1, 1);
    case LawName::hysteretic: return Hysteretic(1, 1);
    case LawName::fractional: break;
  }
  return Fractional(1, 1, 0);
}

/// The values of `parameters`, without its names.
struct Values {
  std::array<double, 3> operator()(const Hysteretic& law) const { return {law.k1(), law.k2(), 0}; }
  std::array<double, 3> operator()(const Fractional& law) const { return {law.k(), law.c(), law.alpha()}; }
  template <class Law>
  std::array<double, 3> operator()(const Law& law) const {
    return {law.k(), law.c(), 0};
  }
};

void append(std::string& out, double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

/// As RFC 4180 quotes it, where it needs to be.
void append_text(std::string& out, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

}  // namespace

std::string take_header(console::LineBlocks& source, console::LineBlocks::Block& block, const std::string& file,
                        std::size_t& line_number) {
  while (source.next(block)) {
    std::string_view text = block.text;
    if (block.first_line == 1 && text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    for (line_number = block.first_line; !text.empty(); ++line_number) {
      std::string line(console::take_line(text));
      if (console::is_csv_remark(line)) continue;
      block.text = std::string(text);
      block.first_line = line_number + 1;
      return line;
    }
  }
  throw BadInput(file + ":1: header missing: must be a row of the columns tcol and en, and others");
}

TargetRows::TargetRows(std::string file, std::size_t line, std::string_view header, const TargetDefaults& defaults,
                       const DirectCalibrator& calibrator)
    : file_(std::move(file)), defaults_(defaults), calibrator_(calibrator) {
  std::array<std::string_view, most_columns> names_read;
  const std::string where = file_ + ":" + std::to_string(line) + ": ";
  const auto found = console::split_csv(header, names_read);
  if (!found) throw BadInput(where + "header = " + shown(header) + ": must be a row of CSV");
  for (std::size_t i = 0; i < *found; ++i) {
    const Field field = field_of(line, names_read[i]);
    if (std::find(columns_.begin(), columns_.end(), field) != columns_.end())
      throw BadInput(where + "column = " + std::string(names[field]) + ": must be given once");
    columns_.push_back(field);
  }
  for (const Field needed : {tcol, en})
    if (std::find(columns_.begin(), columns_.end(), needed) == columns_.end())
      throw BadInput(where + "column " + std::string(names[needed]) + ": missing: must be given");
  const bool any_law = std::find(columns_.begin(), columns_.end(), law) != columns_.end();
  for (const LawName l : all_laws) {
    if (!any_law && l != defaults_.law) continue;
    std::size_t i = 0;
    for (const auto& p : parameters(specimen(l))) {
      const std::string column = p.unit.empty() ? p.name : p.name + " [" + p.unit + "]";
      const auto same = std::find(parameters_.begin(), parameters_.end(), column);
      place_[static_cast<std::size_t>(l)][i++] = static_cast<std::size_t>(same - parameters_.begin());
      if (same == parameters_.end()) parameters_.push_back(column);
    }
  }
}

TargetRows::Field TargetRows::field_of(std::size_t line, std::string_view column) const {
  for (std::size_t i = 0; i < count; ++i)
    if (column == names[i] || column == std::string(names[i]) + std::string(units[i])) return static_cast<Field>(i);
  throw BadInput(file_ + ":" + std::to_string(line) + ": column = " + shown(column) +
                 ": must be one of tcol [s], en, velocity [m/s], mass_eff [kg], law, end, stiffness [kg/s^2]");
}

std::string TargetRows::header() const {
  std::string line = "tcol [s],en,velocity [m/s],mass_eff [kg],law,end,status";
  for (const auto& name : parameters_) line += "," + name;
  return line + "\n";
}

void TargetRows::split(std::string_view line, Row& row) const {
  std::array<std::string_view, most_columns> fields;
  const auto found = console::split_csv(line, fields);
  if (!found) throw BadInput("row = " + shown(line) + ": must be a row of CSV");
  if (*found != columns_.size())
    throw BadInput("fields", std::to_string(*found), std::to_string(columns_.size()) + ", one a column");
  for (std::size_t i = 0; i < *found; ++i) row.text[columns_[i]] = fields[i];
}

double TargetRows::number(Row& row, Field field, std::optional<double> otherwise) const {
  if (row.text[field].empty() && otherwise) return *(row.number[field] = otherwise);
  row.number[field] = console::parse_number(row.text[field]);
  if (!row.number[field])
    throw BadInput(names[field], shown(row.text[field]), field == en ? "in (0, 1]" : "a number in [1e-30, 1e30]");
  return *row.number[field];
}

void TargetRows::read(Row& row) const {
  Request& r = row.request;
  r.target.tcol = number(row, tcol, std::nullopt);
  r.target.en = number(row, en, std::nullopt);
  r.target.impact = {number(row, velocity, defaults_.impact.velocity),
                     number(row, mass_eff, defaults_.impact.mass_eff)};
  r.law = row.text[law].empty() ? defaults_.law : law_named("law", row.text[law]);
  r.end = row.text[end].empty() ? defaults_.end : end_named("end", row.text[end]);
  r.stiffness = defaults_.stiffness;
  if (!row.text[stiffness].empty()) r.stiffness = number(row, stiffness, std::nullopt);
  if (!offers(r.law, r.end)) throw BadInput("end", text(r.end), "force with the law " + std::string(text(r.law)));
}

void TargetRows::write(std::string& out, const Row& row, std::string_view status, const AnyLaw* found) const {
  for (const Field field : {tcol, en, velocity, mass_eff}) {
    if (row.number[field]) append(out, *row.number[field]);
    out += ',';
  }
  append_text(out, found ? text(row.request.law) : row.text[law]);
  out += ',';
  append_text(out, found ? text(row.request.end) : row.text[end]);
  out += ',';
  append_text(out, status);
  if (!found) {
    out.append(parameters_.size(), ',');
    out += '\n';
    return;
  }
  const auto values = std::visit(Values{}, *found);
  const auto& places = place_[static_cast<std::size_t>(row.request.law)];
  const std::size_t known = row.request.law == LawName::fractional ? 3 : 2;
  for (std::size_t column = 0; column < parameters_.size(); ++column) {
    out += ',';
    for (std::size_t i = 0; i < known; ++i)
      if (places[i] == column) append(out, values[i]);
  }
  out += '\n';
}

Answers TargetRows::answer(const console::LineBlocks::Block& block) const {
  Answers answers;
  answers.text.reserve(3 * block.text.size());
  std::string_view text = block.text;
  for (std::size_t line_number = block.first_line; !text.empty(); ++line_number) {
    const std::string_view line = console::take_line(text);
    if (console::is_csv_remark(line)) continue;
    Row row;
    std::string failure;
    ++answers.rows;
    try {
      split(line, row);
      read(row);
      const auto answer = calibrator_(row.request);
      if (const auto* found = std::get_if<AnyLaw>(&answer)) {
        write(answers.text, row, "calibrated", found);
        continue;
      }
      failure = "infeasible: " + explained(std::get<Infeasible>(answer));
    } catch (const std::exception& error) {
      const bool bad = console::exit_code(error) == console::Exit::bad_input;
      failure = (bad ? "bad input: " : "failed: ") + std::string(error.what());
    }
    write(answers.text, row, failure, nullptr);
    if (++answers.failed <= most_complaints)
      answers.complaints.push_back(file_ + ":" + std::to_string(line_number) + ": " +
                                   failure.substr(failure.find(": ") + 2));
  }
  return answers;
}

}  // namespace ricochet::calibration
