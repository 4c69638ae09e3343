#include "target_rows.hpp"

#include "report.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using support::append_shortest;

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

TargetRows::TargetRows(std::string file, const console::CsvHead& head, const TargetDefaults& defaults,
                       const DirectCalibrator& calibrator)
    : file_(std::move(file)), defaults_(defaults), columns_(file_, head, accepted), calibrator_(calibrator) {
  const bool any_law = columns_.has(law);
  for (const LawKind l : LawKind::all()) {
    if (!any_law && l != defaults_.law) continue;
    std::size_t i = 0;
    for (const Parameter& p : l.parameters()) {
      const std::string unit = p.unit();
      const std::string column = unit.empty() ? std::string(p.name) : fmt::format("{} [{}]", p.name, unit);
      const auto same = std::find(parameters_.begin(), parameters_.end(), column);
      place_[l.index()][i++] = static_cast<std::size_t>(same - parameters_.begin());
      if (same == parameters_.end()) parameters_.push_back(column);
    }
  }
}

std::string TargetRows::header() const {
  return fmt::format("tcol [s],en,velocity [m/s],mass_eff [kg],law,end,status,{}\n", fmt::join(parameters_, ","));
}

double TargetRows::number(Row& row, Field field, std::optional<double> otherwise) const {
  if (row.text[field].empty() && otherwise) return *(row.number[field] = otherwise);
  row.number[field] = columns_.number(field, row.text[field]);
  if (!row.number[field])
    throw BadInput(accepted[field].name, console::excerpt(row.text[field]),
                   field == en ? "in (0, 1]" : "a number in [1e-30, 1e30]");
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
  if (!r.law.ends().offer(r.end))
    throw BadInput("end", text(r.end), fmt::format("force with the law {}", r.law.name()));
}

void TargetRows::write(std::string& out, const Row& row, std::string_view status, const AnyLaw* found) const {
  for (const Field field : {tcol, en, velocity, mass_eff}) {
    if (row.number[field]) append_shortest(out, *row.number[field]);
    out += ',';
  }
  append_text(out, found ? row.request.law.name() : row.text[law]);
  out += ',';
  append_text(out, found ? text(row.request.end) : row.text[end]);
  out += ',';
  append_text(out, status);
  if (!found) {
    out.append(parameters_.size(), ',');
    out += '\n';
    return;
  }
  std::array<double, Laws::most_parameters> values{};
  const std::size_t known = std::visit(
      [&](const auto& l) {
        const auto own = l.values();
        std::copy(own.begin(), own.end(), values.begin());
        return own.size();
      },
      *found);
  const auto& places = place_[row.request.law.index()];
  for (std::size_t column = 0; column < parameters_.size(); ++column) {
    out += ',';
    for (std::size_t i = 0; i < known; ++i)
      if (places[i] == column) append_shortest(out, values[i]);
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
      columns_.split(line, row.text);
      read(row);
      const auto answer = calibrator_(row.request);
      if (const auto* found = std::get_if<AnyLaw>(&answer)) {
        write(answers.text, row, "calibrated", found);
        continue;
      }
      failure = fmt::format("infeasible: {}", explained(std::get<Infeasible>(answer)));
    } catch (const std::exception& error) {
      const bool bad = console::exit_code(error) == console::Exit::bad_input;
      failure = fmt::format("{}: {}", bad ? "bad input" : "failed", error.what());
    }
    write(answers.text, row, failure, nullptr);
    if (++answers.failed <= most_complaints)
      answers.complaints.push_back(
          fmt::format("{}:{}: {}", file_, line_number, failure.substr(failure.find(": ") + 2)));
  }
  return answers;
}

}  // namespace ricochet::calibration
