// Any text as a file of targets: one row out per row in, as many fields in each as the header names, numbers that are
// finite in every row marked calibrated; or one line that says what is wrong with the header.

#include "memory_file.hpp"
#include "target_rows.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>

#include <algorithm>
#include <stdexcept>

using namespace ricochet;

namespace {

void expect(bool ok, const char* what) {
  if (!ok) throw std::logic_error(what);
}

/// The fields of a row as RFC 4180 has them.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (line[i] == '"' && (quoted || fields.back().empty()))
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  expect(!quoted, "a quote that is not closed");
  return fields;
}

/// `status` is the column of that name, after which the parameters come.
void check_row(std::string_view line, std::size_t columns, std::size_t status) {
  const auto fields = fields_of(line);
  expect(fields.size() == columns, "a row with more or fewer fields than the header");
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    if (fields[i].empty() || (i >= 4 && i <= status)) continue;
    expect(console::parse_number(fields[i]).has_value(), "a field that is no finite number");
    numbers += i > status;
  }
  if (fields[status] == "calibrated")
    expect(numbers == 2 || numbers == 3, "a calibrated row without its parameters");
  else
    expect(numbers == 0, "parameters in a row that failed");
}

void check(const std::string& path, const calibration::TargetDefaults& defaults) {
  console::LineBlocks source(path, 512);  // small, so that lines cross the blocks
  console::LineBlocks::Block block;
  const auto head = console::take_csv_head(source, block);
  if (!head) return;
  static const calibration::DirectCalibrator calibrator;
  const calibration::TargetRows rows("f.csv", *head, defaults, calibrator);
  const std::string names = rows.header();
  const auto columns = fields_of(std::string_view(names).substr(0, names.size() - 1));
  const auto status = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), "status") - columns.begin());
  do {
    const auto answers = rows.answer(block);
    std::size_t count = 0;
    for (std::string_view text = answers.text; !text.empty(); ++count)
      check_row(console::take_line(text), columns.size(), status);
    expect(count == answers.rows && answers.complaints.size() == answers.failed, "a row that was lost");
    for (const auto& complaint : answers.complaints)
      expect(complaint.find('\n') == std::string::npos, "more than one line");
  } while (source.next(block));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A row outside the tables takes milliseconds under the sanitizers: few rows, so that only a hang takes long.
  if (std::count(data, data + size, '\n') > 10) return -1;
  const MemoryFile file(data, size);
  const calibration::TargetDefaults defaults;
  try {
    check(file.path(), defaults);
  } catch (const console::BadInput& error) {
    expect(std::string(error.what()).find('\n') == std::string::npos, "more than one line");
  }
  return 0;
}
