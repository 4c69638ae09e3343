#include "order_file.hpp"

#include <console/csv.hpp>
#include <console/harmless.hpp>

#include <algorithm>
#include <array>

namespace ricochet::verify {

namespace {

enum Column { h, n, error, value, scheme, name };
constexpr std::array columns{console::CsvColumn{"h"},     console::CsvColumn{"n"},      console::CsvColumn{"error"},
                             console::CsvColumn{"value"}, console::CsvColumn{"scheme"}, console::CsvColumn{"case"}};

/// The case that the row belongs to, a new one if it is the first.
OrderCase& case_of(OrderFile& file, const console::CsvReader& rows) {
  const auto text = [&](Column column) {
    if (!rows.has(column)) return std::string();
    if (!console::is_harmless(rows.text(column))) rows.reject(column, console::harmless_words);
    return std::string(rows.text(column));
  };
  const auto same = std::find_if(file.cases.begin(), file.cases.end(),
                                 [&](const OrderCase& c) { return c.scheme == text(scheme) && c.name == text(name); });
  if (same != file.cases.end()) return *same;
  return file.cases.emplace_back(OrderCase{text(scheme), text(name), {}, {}});
}

}  // namespace

OrderFile read_order_file(const std::string& path) {
  console::CsvReader rows(path, columns);
  OrderFile file;
  while (rows.next()) {
    if (rows.has(h) == rows.has(n)) rows.fail("columns = h, n: must be one of the two");
    if (rows.has(error) == rows.has(value)) rows.fail("columns = error, value: must be one of the two");
    file.errors = rows.has(error);
    const Column mesh = rows.has(h) ? h : n;
    const double read = rows.number(mesh);
    if (!(read > 0)) rows.reject(mesh, "> 0");
    OrderCase& one = case_of(file, rows);
    const double step = mesh == h ? read : 1 / read;
    if (std::find(one.h.begin(), one.h.end(), step) != one.h.end()) rows.reject(mesh, "given once a case");
    one.h.push_back(step);
    one.value.push_back(rows.number(file.errors ? error : value));
  }
  if (file.cases.empty()) rows.fail("rows = none: must be at least three meshes");
  return file;
}

}  // namespace ricochet::verify
