#include <console/number.hpp>
#include <console/table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ricochet::console {

namespace {

std::string in_notation(double value, const Notation& notation) {
  switch (notation.kind) {
    case Notation::Kind::fixed: return fixed(value, notation.digits);
    case Notation::Kind::scientific: return scientific(value, notation.digits);
    case Notation::Kind::significant: break;
  }
  return significant(value, notation.digits);
}

struct Shown {
  const Notation& notation;
  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(double value) const { return in_notation(value, notation); }
  std::string operator()(std::int64_t value) const { return fmt::format_int(value).str(); }
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
};

struct Exact {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(double value) const { return shortest(value); }
  std::string operator()(std::int64_t value) const { return fmt::format_int(value).str(); }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(const std::string& text) const {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
  }
};

/// "tcol [s]"
std::string heading(const Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

bool is_right(const Column& column, const std::vector<std::vector<Cell>>& rows, std::size_t index) {
  if (column.align != Align::automatic) return column.align == Align::right;
  // Numbers line up at the right; one text among them (a bound such as "in [0, 1]") leaves the column at the left.
  return std::none_of(rows.begin(), rows.end(), [index](const auto& row) {
    return std::holds_alternative<std::string>(row[index]) || std::holds_alternative<bool>(row[index]);
  });
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, display_width(text)), ' ');
  return right ? space + text : text + space;
}

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string escaped_for_markdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

}  // namespace

Cell blank() { return std::monostate{}; }

Cell number_or_blank(double value) { return std::isfinite(value) ? Cell(value) : Cell(std::monostate{}); }

std::string shown(const Cell& cell, const Notation& notation) { return std::visit(Shown{notation}, cell); }

std::size_t display_width(std::string_view utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

Table::Table(std::vector<Column> columns, std::string caption)
    : columns_(std::move(columns)), caption_(std::move(caption)) {}

Table& Table::row(std::vector<Cell> cells) {
  if (cells.size() != columns_.size())
    throw std::logic_error(
        fmt::format("table '{}': a row of {} cells for {} columns", caption_, cells.size(), columns_.size()));
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (const double* value = std::get_if<double>(&cells[i]); value && !std::isfinite(*value))
      throw std::logic_error(fmt::format("table '{}': {} is not a finite number", caption_, columns_[i].name));
  rows_.push_back(std::move(cells));
  return *this;
}

Table& Table::note(std::string text) {
  notes_.push_back(std::move(text));
  return *this;
}

bool Table::right_aligned(std::size_t column) const { return is_right(columns_[column], rows_, column); }

std::string Table::text() const {
  std::vector<std::vector<std::string>> lines(1);
  for (const Column& column : columns_) lines[0].push_back(column.name);
  if (std::any_of(columns_.begin(), columns_.end(), [](const Column& c) { return !c.unit.empty(); })) {
    lines.emplace_back();
    for (const Column& column : columns_)
      lines[1].push_back(column.unit.empty() ? "" : fmt::format("[{}]", column.unit));
  }
  const std::size_t head = lines.size();
  for (const auto& row : rows_) {
    lines.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i)
      lines.back().push_back(std::visit(Shown{columns_[i].notation}, row[i]));
  }
  std::vector<std::size_t> width(columns_.size());
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) width[i] = std::max(width[i], display_width(line[i]));

  std::string out = caption_.empty() ? "" : caption_ + "\n";
  for (std::size_t l = 0; l < lines.size(); ++l) {
    std::string line;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      line += (i ? "  " : "") + padded(lines[l][i], width[i], is_right(columns_[i], rows_, i));
    out += without_trailing_spaces(line) + "\n";
    if (l + 1 != head) continue;
    for (std::size_t i = 0; i < width.size(); ++i) out += (i ? "  " : "") + std::string(width[i], '-');
    out += "\n";
  }
  for (const std::string& note : notes_) out += note + "\n";
  return out;
}

std::string Table::csv() const {
  std::string out;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    out += (i ? "," : "") + Exact{}(heading(column));
  }
  out += '\n';
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) out += (i ? "," : "") + std::visit(Exact{}, row[i]);
    out += '\n';
  }
  return out;
}

std::string Table::markdown() const {
  std::string out = caption_.empty() ? "" : fmt::format("**{}**\n\n", escaped_for_markdown(caption_));
  std::string rule = "|";
  out += "|";
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    out += fmt::format(" {} |", escaped_for_markdown(heading(column)));
    rule += is_right(column, rows_, i) ? " ---: |" : " --- |";
  }
  out += "\n" + rule + "\n";
  for (const auto& row : rows_) {
    out += "|";
    for (std::size_t i = 0; i < row.size(); ++i)
      out += fmt::format(" {} |", escaped_for_markdown(std::visit(Shown{columns_[i].notation}, row[i])));
    out += "\n";
  }
  for (const std::string& note : notes_) out += fmt::format("\n{}\n", escaped_for_markdown(note));
  return out;
}

std::string Table::render(Format format) const {
  switch (format) {
    case Format::table: return text();
    case Format::csv: return csv();
    case Format::markdown: return markdown();
    case Format::latex: return latex();
    case Format::json:
    case Format::junit: break;
  }
  throw std::logic_error("a table alone is no document");
}

std::string render_all(const std::vector<Table>& tables, Format format) {
  std::string out;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (i) out += "\n";
    if (i && format == Format::csv) out += fmt::format("# {}\n", tables[i].caption());
    out += tables[i].render(format);
  }
  return out;
}

}  // namespace ricochet::console
