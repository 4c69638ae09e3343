#include "measurements.hpp"

#include <console/csv.hpp>

#include <array>

namespace ricochet::calibration {
namespace {

enum Column : std::size_t { velocity, en, en_sigma, tcol, tcol_sigma, count };
constexpr std::array<console::CsvColumn, count> columns{
    console::CsvColumn{"velocity", "m/s", true}, {"en", "", true}, {"en_sigma"}, {"tcol", "s"}, {"tcol_sigma", "s"}};
constexpr std::array<double Measurement::*, count> members{
    &Measurement::velocity, &Measurement::en, &Measurement::en_sigma, &Measurement::tcol, &Measurement::tcol_sigma};

void check_head(const console::CsvReader& file) {
  if (file.has(tcol) != file.has(tcol_sigma)) file.fail("tcol and tcol_sigma: must be given together");
  if (file.has(tcol) && !file.has(en_sigma))
    file.fail("column en_sigma: missing: must be given with tcol, to weigh one against the other");
}

double number(const console::CsvReader& file, std::size_t column) {
  const char* accepted = column == en ? "in (0, 1]" : "a number in [1e-30, 1e30]";
  const double value = file.number(column, accepted);
  if (!(value > 0) || (column == en ? value > 1 : value < 1e-30 || value > 1e30)) file.reject(column, accepted);
  return value;
}

}  // namespace

std::vector<Measurement> read_measurements(const std::string& path) {
  console::CsvReader file(path, columns);
  check_head(file);
  std::vector<Measurement> data;
  while (file.next()) {
    Measurement m{};
    for (std::size_t i = 0; i < count; ++i)
      if (file.has(i)) m.*members[i] = number(file, i);
    data.push_back(m);
  }
  if (data.empty()) file.fail("no rows: must be a header with velocity and en, and measurements");
  return data;
}

}  // namespace ricochet::calibration
