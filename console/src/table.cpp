#include <console/harmless.hpp>
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

/// How far the lines of a cell after its first are indented, which tells them from a row of their own.
constexpr std::size_t hanging = 2;

/// Least width to which the text can be broken.
std::size_t longest_word(const std::string& text, std::size_t indent) {
  std::size_t longest = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    longest = std::max(longest, display_width(std::string_view(text).substr(at, end - at)) + (at > 0 ? indent : 0));
    at = end + 1;
  }
  return longest;
}

/// A table's head and rows as lines of text, no wider than a terminal where their words allow that.
class TextRows {
 public:
  TextRows(const std::vector<Column>& columns, const std::vector<std::vector<Cell>>& rows) {
    right_.reserve(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) right_.push_back(is_right(columns[i], rows, i));
    add_head(columns);
    for (const auto& row : rows) {
      lines_.emplace_back();
      for (std::size_t i = 0; i < row.size(); ++i)
        lines_.back().push_back(std::visit(Shown{columns[i].notation}, row[i]));
    }
    fit();
  }

  std::string rendered() const {
    std::string out;
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      out += broken(lines_[l]);
      if (l + 1 != head_) continue;
      for (std::size_t i = 0; i < width_.size(); ++i) out += (i ? "  " : "") + std::string(width_[i], '-');
      out += "\n";
    }
    return out;
  }

 private:
  void add_head(const std::vector<Column>& columns) {
    lines_.emplace_back();
    for (const Column& column : columns) lines_[0].push_back(column.name);
    if (std::any_of(columns.begin(), columns.end(), [](const Column& c) { return !c.unit.empty(); })) {
      lines_.emplace_back();
      for (const Column& column : columns)
        lines_[1].push_back(column.unit.empty() ? "" : fmt::format("[{}]", column.unit));
    }
    head_ = lines_.size();
  }

  std::size_t indent(std::size_t column) const { return right_[column] ? 0 : hanging; }

  /// The greatest measure(cell, column) of each column, over all lines from the given one on.
  template <class F>
  std::vector<std::size_t> greatest(std::size_t from, const F& measure) const {
    std::vector<std::size_t> all(right_.size(), 0);
    for (std::size_t l = from; l < lines_.size(); ++l)
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::max(all[i], measure(lines_[l][i], i));
    return all;
  }

  /// Widths that suit a terminal: names are broken before what stands below them.
  void fit() {
    const auto whole = [](const std::string& cell, std::size_t) { return display_width(cell); };
    width_ = greatest(0, whole);
    const std::vector<std::size_t> words =
        greatest(0, [this](const std::string& cell, std::size_t i) { return longest_word(cell, indent(i)); });
    std::vector<std::size_t> cells = greatest(1, whole);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = std::max(cells[i], longest_word(lines_[0][i], indent(i)));
    for (const auto& least : {cells, words}) narrow_to(least);
  }

  void narrow_to(const std::vector<std::size_t>& least) {
    std::size_t total = 2 * (width_.size() - 1);
    for (const std::size_t width : width_) total += width;
    while (total > terminal_width) {
      std::size_t widest = width_.size();
      for (std::size_t i = 0; i < width_.size(); ++i)
        if (width_[i] > least[i] && (widest == width_.size() || width_[i] > width_[widest])) widest = i;
      if (widest == width_.size()) return;
      --width_[widest];
      --total;
    }
  }

  /// One row, over as many lines as its cells need.
  std::string broken(const std::vector<std::string>& row) const {
    std::vector<std::vector<std::string>> cells;
    cells.reserve(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) cells.push_back(wrapped(row[i], width_[i], indent(i)));
    std::size_t height = 1;
    for (const auto& cell : cells) height = std::max(height, cell.size());
    std::string out;
    for (std::size_t l = 0; l < height; ++l) {
      std::string line;
      for (std::size_t i = 0; i < cells.size(); ++i)
        line += (i ? "  " : "") + padded(l < cells[i].size() ? cells[i][l] : "", width_[i], right_[i]);
      out += without_trailing_spaces(line) + "\n";
    }
    return out;
  }

  std::vector<bool> right_ = {};
  std::vector<std::vector<std::string>> lines_ = {};  ///< the head's first
  std::size_t head_ = 0;
  std::vector<std::size_t> width_ = {};
};

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
    : columns_(std::move(columns)), caption_(without_controls(std::move(caption), true)) {}

Table& Table::row(std::vector<Cell> cells) {
  if (cells.size() != columns_.size())
    throw std::logic_error(
        fmt::format("table '{}': a row of {} cells for {} columns", caption_, cells.size(), columns_.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (const double* value = std::get_if<double>(&cells[i]); value && !std::isfinite(*value))
      throw std::logic_error(fmt::format("table '{}': {} is not a finite number", caption_, columns_[i].name));
    if (std::string* text = std::get_if<std::string>(&cells[i])) *text = without_controls(std::move(*text), true);
  }
  rows_.push_back(std::move(cells));
  return *this;
}

Table& Table::note(std::string text) {
  notes_.push_back(without_controls(std::move(text), true));
  return *this;
}

bool Table::right_aligned(std::size_t column) const { return is_right(columns_[column], rows_, column); }

std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::vector<std::string> lines(1);
  std::size_t used = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const std::size_t room = display_width(word);
    if (used > 0 && used + 1 + room > width) {
      lines.emplace_back(indent, ' ');
      lines.back() += word;
      used = indent + room;
    } else {
      if (at > 0) lines.back() += ' ';
      lines.back() += word;
      used += room + (at > 0 ? 1 : 0);
    }
    at = end + 1;
  }
  return lines;
}

std::string Table::text() const {
  const TextRows rows(columns_, rows_);
  std::string out;
  const auto add = [&out](const std::string& sentence) {
    for (const std::string& line : wrapped(sentence)) out += line + "\n";
  };
  if (!caption_.empty()) add(caption_);
  out += rows.rendered();
  for (const std::string& note : notes_) add(note);
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
