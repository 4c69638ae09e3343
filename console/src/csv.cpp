#include "decimal.hpp"

#include <console/csv.hpp>
#include <console/exit.hpp>
#include <console/harmless.hpp>
#include <console/number.hpp>
#include <console/quantity.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace ricochet::console {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// Around a field; a tab that separates fields is none of them.
std::string_view blanks(char separator) { return separator == '\t' ? " " : " \t"; }

std::string_view trimmed(std::string_view text, std::string_view blanks) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A semicolon in the head outside quotes separates; else a comma; else a tab.
char separator_of(std::string_view head) {
  bool quoted = false, comma = false, tab = false;
  for (const char c : head) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ';') return ';';
    comma = comma || c == ',';
    tab = tab || c == '\t';
  }
  return tab && !comma ? '\t' : ',';
}

std::string spelled(const CsvColumn& column) {
  const bool plain = column.unit.empty() || column.unit == count_unit;
  return plain ? std::string(column.name) : fmt::format("{} [{}]", column.name, column.unit);
}

std::string list_of(std::span<const CsvColumn> columns) {
  std::vector<std::string> all;
  all.reserve(columns.size());
  for (const CsvColumn& column : columns) all.push_back(spelled(column));
  return fmt::format("{}", fmt::join(all, ", "));
}

/// What a field tells of its file's decimal sign. "1.234" may be a number in thousands, "1.234,5" and "0.5" are not.
struct SignEvidence {
  char sign = 0;  ///< '.', ',' or nothing
  bool sure = false;
};

SignEvidence evidence_of(std::string_view field) {
  if (field.find_first_not_of("0123456789+-.,eE") != std::string_view::npos) return {};
  const auto last = field.find_last_of(".,"), first = field.find_first_of(".,");
  if (last == std::string_view::npos) return {};
  if (first != last) return {field[last], field[first] != field[last]};
  const auto before = field.find_first_of("123456789"), behind = field.substr(last + 1).find_first_not_of("0123456789");
  const bool three = behind == std::string_view::npos && field.size() - last == 4;
  return {field[last], !(three && before < last && last - before <= 3)};
}

struct Heading {
  std::string_view name, unit;
};

/// "v [mm/s]" and "v (mm/s)" into name and unit.
Heading parts_of(std::string_view heading) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')})
    if (const auto at = heading.rfind(open); heading.ends_with(close) && at != std::string_view::npos)
      return {trimmed(heading.substr(0, at), " \t"), trimmed(heading.substr(at + 1, heading.size() - at - 2), " \t")};
  return {heading, {}};
}

/// "Drop height" is drop_height.
bool same_name(std::string_view a, std::string_view b) {
  const auto plain = [](char c) -> int {
    return c == '_' || c == '-' ? ' ' : std::tolower(static_cast<unsigned char>(c));
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return plain(x) == plain(y); });
}

/// Is it the column's name, or one of its aliases?
bool names(const CsvColumn& column, std::string_view name) {
  if (same_name(name, column.name)) return true;
  for (std::string_view rest = column.aliases; !rest.empty();) {
    const auto end = std::min(rest.find(','), rest.size());
    if (same_name(name, rest.substr(0, end))) return true;
    rest.remove_prefix(std::min(rest.size(), end + 1));
  }
  return false;
}

}  // namespace

bool is_csv_remark(std::string_view line) {
  const auto first = line.find_first_not_of(" \t;,");
  if (first == std::string_view::npos) return true;
  return line.substr(line.find_first_not_of(" \t")).starts_with('#') || (line.starts_with("sep=") && line.size() <= 5);
}

std::string_view take_line(std::string_view& text) {
  const auto end = text.find('\n');
  auto line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string excerpt(std::string_view text) {
  std::string line = without_controls(std::string(text.substr(0, 60)));
  return line.empty() ? "nothing" : line;
}

std::optional<CsvHead> take_csv_head(LineBlocks& source, LineBlocks::Block& block) {
  while (source.next(block)) {
    std::string_view text = block.text;
    if (block.first_line == 1 && text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    for (std::size_t number = block.first_line; !text.empty(); ++number) {
      const auto line = take_line(text);
      if (is_csv_remark(line)) continue;
      CsvHead head{std::string(line), number};
      block.text = std::string(text);
      block.first_line = number + 1;
      return head;
    }
  }
  return std::nullopt;
}

CsvColumns::CsvColumns(const std::string& file, const CsvHead& head, std::span<const CsvColumn> accepted,
                       Unknown unknown, std::string_view rows)
    : accepted_(accepted), separator_(separator_of(head.text)), exponents_(accepted.size()), stated_(accepted.size()) {
  try {
    std::array<std::string_view, most> headings;
    const auto count = fields_of(head.text, headings);
    if (!count) throw BadInput(fmt::format("header = {}: must be a row of CSV", excerpt(head.text)));
    for (std::size_t i = 0; i < *count; ++i) order_.push_back(take(headings[i], unknown));
    if (ignored_.size() == *count) refuse(headings[0], *count);
    for (std::size_t i = 0; i < accepted.size(); ++i)
      if (accepted[i].needed && !has(i))
        throw BadInput(fmt::format("column {}: missing: must be given", accepted[i].name));
    decimal_sign_ = separator_ == ',' ? '.' : sign_in(rows);
  } catch (const BadInput& error) {
    throw BadInput(fmt::format("{}:{}: {}", file, head.line, error.what()));
  }
}

/// The decimal sign by the first field that leaves no doubt of it, else by the first that has one; 0 without any.
char CsvColumns::sign_in(std::string_view rows) const {
  char doubtful = 0;
  while (!rows.empty()) {
    const auto line = take_line(rows);
    std::array<std::string_view, most> row;
    const auto count = is_csv_remark(line) ? std::optional<std::size_t>() : fields_of(line, row);
    for (std::size_t i = 0; count && i < std::min(*count, order_.size()); ++i) {
      if (!order_[i]) continue;
      const SignEvidence told = evidence_of(row[i]);
      if (told.sure) return told.sign;
      if (doubtful == 0) doubtful = told.sign;
    }
  }
  return doubtful;
}

/// None of the headings is known: the first is named, or the separator that the head lacks.
void CsvColumns::refuse(std::string_view heading, std::size_t count) const {
  if (count == 1 && heading.find_first_of(" \t|:/") != std::string_view::npos)
    throw BadInput(fmt::format("header = {}: must be names between commas, semicolons or tabs, of {}", excerpt(heading),
                               list_of(accepted_)));
  throw BadInput(fmt::format("column = {}: must be one of {}", excerpt(heading), list_of(accepted_)));
}

/// The accepted column that a heading names, and its unit noted.
std::optional<std::size_t> CsvColumns::take(std::string_view heading, Unknown unknown) {
  const Heading given = parts_of(heading);
  const auto named = [&](const CsvColumn& c) {
    return names(c, given.name) && !(c.unit.empty() && !decimal_exponent(given.unit, ""));
  };
  // Of several columns of that name the one of that unit.
  auto known = std::find_if(accepted_.begin(), accepted_.end(),
                            [&](const CsvColumn& c) { return named(c) && decimal_exponent(given.unit, c.unit); });
  if (known == accepted_.end()) known = std::find_if(accepted_.begin(), accepted_.end(), named);
  if (known == accepted_.end() && unknown == Unknown::ignored) {
    ignored_.push_back(excerpt(heading));
    return std::nullopt;
  }
  if (known == accepted_.end()) refuse(heading, 2);
  const auto exponent = decimal_exponent(given.unit, known->unit);
  if (!exponent) throw BadInput(fmt::format("column = {}: must be {}", excerpt(heading), units_of(known->name)));
  const auto column = static_cast<std::size_t>(known - accepted_.begin());
  for (std::size_t i = 0; i < accepted_.size(); ++i)
    if (has(i) && accepted_[i].name == known->name)
      throw BadInput(fmt::format("column = {}: must be given once", known->name));
  exponents_[column] = exponent;
  stated_[column] = !given.unit.empty();
  return column;
}

/// "in m/s, cm/s or mm/s", of every column of that name.
std::string CsvColumns::units_of(std::string_view name) const {
  std::vector<std::string> all;
  for (const CsvColumn& c : accepted_)
    if (c.name == name && !unit_choices(c.unit).empty()) all.push_back(unit_choices(c.unit));
  return all.empty() ? "without unit" : fmt::format("in {}", fmt::join(all, "; or in "));
}

/// How many fields the line has; nothing where a quote is not closed or there are more than `fields` holds.
std::optional<std::size_t> CsvColumns::fields_of(std::string_view line, std::span<std::string_view> fields) const {
  const std::string_view around = blanks(separator_);
  for (std::size_t count = 0; count < fields.size(); ++count) {
    const auto start = line.find_first_not_of(around);
    const bool quoted = start != std::string_view::npos && line[start] == '"';
    const auto close = quoted ? line.find('"', start + 1) : 0;
    if (close == std::string_view::npos) return std::nullopt;
    const auto end = line.find(separator_, close);
    const auto raw = trimmed(line.substr(0, end), around);
    if (quoted && raw.back() != '"') return std::nullopt;
    fields[count] = quoted ? raw.substr(1, raw.size() - 2) : raw;
    if (end == std::string_view::npos) return count + 1;
    line.remove_prefix(end + 1);
  }
  return std::nullopt;
}

void CsvColumns::split(std::string_view line, std::span<std::string_view> fields) const {
  std::array<std::string_view, most> row;
  const auto count = fields_of(line, row);
  if (!count) throw BadInput(fmt::format("row = {}: must be a row of CSV", excerpt(line)));
  if (*count != order_.size())
    throw BadInput(fmt::format("fields = {}: must be {}, one a column", *count, order_.size()));
  for (std::size_t i = 0; i < *count; ++i)
    if (order_[i]) fields[*order_[i]] = row[i];
}

std::optional<double> CsvColumns::number(std::size_t column, std::string_view field) const {
  const int exponent = exponents_[column].value_or(0);
  const auto comma = separator_ == ',' ? std::string_view::npos : field.find(',');
  if (exponent == 0 && comma == std::string_view::npos && decimal_sign_ != ',') return parse_number(field);
  if (!doubt(field).empty()) return std::nullopt;
  std::string number(field);
  if (comma != std::string_view::npos) number[comma] = '.';
  return scaled(number, exponent);
}

std::string_view CsvColumns::doubt(std::string_view field) const {
  const bool comma = field.find(',') != std::string_view::npos, point = field.find('.') != std::string_view::npos;
  if (comma && (point || separator_ == ',')) return ", without separators of thousands";
  if (comma && decimal_sign_ == '.') return ", with a decimal point as the file's other numbers";
  if (point && decimal_sign_ == ',') return ", with a decimal comma as the file's other numbers";
  return {};
}

CsvReader::CsvReader(std::string path, std::span<const CsvColumn> accepted, Unknown unknown)
    : path_(std::move(path)), accepted_(accepted), source_(path_), fields_(accepted.size()) {
  const auto head = take_csv_head(source_, block_);
  if (!head) return;
  columns_.emplace(path_, *head, accepted_, unknown, block_.text);
  line_ = head->line;
  rest_ = block_.text;
}

bool CsvReader::next() {
  while (columns_) {
    if (rest_.empty()) {
      if (!source_.next(block_)) break;
      rest_ = block_.text;
    }
    ++line_;
    const auto line = take_line(rest_);
    if (is_csv_remark(line)) continue;
    try {
      columns_->split(line, fields_);
    } catch (const BadInput& error) {
      fail(error.what());
    }
    return true;
  }
  line_ += columns_ ? 1 : 0;
  return false;
}

double CsvReader::number(std::size_t column, std::string_view accepted) const {
  const auto value = columns_->number(column, fields_[column]);
  if (!value) reject(column, fmt::format("{}{}", accepted, columns_->doubt(fields_[column])));
  return *value;
}

void CsvReader::reject(std::size_t column, std::string_view accepted) const {
  fail(fmt::format("{} = {}: must be {}", accepted_[column].name, excerpt(fields_[column]), accepted));
}

void CsvReader::fail(const std::string& what) const { throw BadInput(fmt::format("{}:{}: {}", path_, line_, what)); }

}  // namespace ricochet::console
