#include "measurements.hpp"

#include "job.hpp"

#include <console/csv.hpp>
#include <console/exit.hpp>
#include <console/number.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace ricochet::calibration {
namespace {

using console::BadInput;

struct Column {
  std::string_view name, unit, accepted;
  double Measurement::*member;
};
constexpr std::array columns{Column{"velocity", " [m/s]", "a number in [1e-30, 1e30]", &Measurement::velocity},
                             Column{"en", "", "in (0, 1]", &Measurement::en},
                             Column{"en_sigma", "", "a number in [1e-30, 1e30]", &Measurement::en_sigma},
                             Column{"tcol", " [s]", "a number in [1e-30, 1e30]", &Measurement::tcol},
                             Column{"tcol_sigma", " [s]", "a number in [1e-30, 1e30]", &Measurement::tcol_sigma}};

/// Reads one file; every complaint begins with where it is.
class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  std::vector<Measurement> read() {
    console::LineBlocks source(path_);
    for (console::LineBlocks::Block block; source.next(block);) {
      std::string_view text = block.text;
      if (block.first_line == 1 && text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
      for (line_ = block.first_line; !text.empty(); ++line_) {
        const auto line = console::take_line(text);
        if (console::is_csv_remark(line)) continue;
        if (order_.empty())
          header(split(line));
        else
          data_.push_back(row(split(line)));
      }
    }
    if (data_.empty())
      throw BadInput(path_ + ":" + std::to_string(std::max<std::size_t>(line_, 1)) +
                     ": no rows: must be a header with velocity and en, and measurements");
    return data_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw BadInput(path_ + ":" + std::to_string(line_) + ": " + what);
  }

  std::vector<std::string_view> split(std::string_view line) const {
    std::array<std::string_view, 32> fields;
    const auto count = console::split_csv(line, fields);
    if (!count) fail("row = " + shown(line) + ": must be a row of CSV");
    return {fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(*count)};
  }

  bool has(std::string_view name) const {
    return std::any_of(order_.begin(), order_.end(), [&](const Column* c) { return c->name == name; });
  }

  void header(const std::vector<std::string_view>& names) {
    for (const auto name : names) {
      const auto column = std::find_if(columns.begin(), columns.end(), [&](const Column& c) {
        return name == c.name || name == std::string(c.name) + std::string(c.unit);
      });
      if (column == columns.end())
        fail("column = " + shown(name) + ": must be one of velocity [m/s], en, en_sigma, tcol [s], tcol_sigma [s]");
      if (has(column->name)) fail("column = " + std::string(column->name) + ": must be given once");
      order_.push_back(column);
    }
    for (const char* needed : {"velocity", "en"})
      if (!has(needed)) fail("column " + std::string(needed) + ": missing: must be given");
    if (has("tcol") != has("tcol_sigma")) fail("tcol and tcol_sigma: must be given together");
    if (has("tcol") && !has("en_sigma"))
      fail("column en_sigma: missing: must be given with tcol, to weigh one against the other");
  }

  Measurement row(const std::vector<std::string_view>& fields) const {
    if (fields.size() != order_.size())
      fail("fields = " + std::to_string(fields.size()) + ": must be " + std::to_string(order_.size()) +
           ", one a column");
    Measurement m{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const Column& column = *order_[i];
      const auto value = console::parse_number(fields[i]);
      const bool is_en = column.member == &Measurement::en;
      if (!value || !(*value > 0) || (is_en ? *value > 1 : *value < 1e-30 || *value > 1e30))
        fail(std::string(column.name) + " = " + shown(fields[i]) + ": must be " + std::string(column.accepted));
      m.*column.member = *value;
    }
    return m;
  }

  std::string path_;
  std::size_t line_ = 0;
  std::vector<const Column*> order_;
  std::vector<Measurement> data_;
};

}  // namespace

std::vector<Measurement> read_measurements(const std::string& path) { return Reader(path).read(); }

}  // namespace ricochet::calibration
