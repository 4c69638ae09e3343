#include "decimal.hpp"

#include <console/number.hpp>
#include <console/quantity.hpp>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ricochet::console {
namespace {

/// A decimal multiple of an SI unit. The first spelling of each is the one that messages offer.
struct Multiple {
  std::string_view unit, si;
  int exponent;
  bool offered = true;
};
constexpr std::array multiples{
    Multiple{"ms", "s", -3},
    Multiple{"us", "s", -6},
    Multiple{"µs", "s", -6, false},  // the micro sign
    Multiple{"μs", "s", -6, false},  // the Greek letter
    Multiple{"ns", "s", -9},
    Multiple{"cm", "m", -2},
    Multiple{"mm", "m", -3},
    Multiple{"um", "m", -6},
    Multiple{"µm", "m", -6, false},
    Multiple{"μm", "m", -6, false},
    Multiple{"nm", "m", -9},
    Multiple{"cm/s", "m/s", -2},
    Multiple{"mm/s", "m/s", -3},
    Multiple{"g", "kg", -3},
    Multiple{"mg", "kg", -6},
    Multiple{"kPa", "Pa", 3},
    Multiple{"MPa", "Pa", 6},
    Multiple{"N/mm^2", "Pa", 6, false},
    Multiple{"GPa", "Pa", 9},
    Multiple{"kg/m3", "kg/m^3", 0, false},
    Multiple{"g/cm^3", "kg/m^3", 3},
    Multiple{"g/cm3", "kg/m^3", 3, false},
    Multiple{"N/m", "kg/s^2", 0},
    Multiple{"N/mm", "kg/s^2", 3},
    Multiple{"kN/m", "kg/s^2", 3},
    Multiple{"MN/m", "kg/s^2", 6},
    Multiple{"N s/m", "kg/s", 0},
    Multiple{"kN", "N", 3},
    Multiple{"mN", "N", -3},
    Multiple{"uN", "N", -6},
    Multiple{"%", "", -2},
    // Of kζ^{3/2}: N/mm^1.5 is no power of ten of it.
    Multiple{"N/m^1.5", "kg/(s^2 m^(1/2))", 0},
    Multiple{"N/m^(3/2)", "kg/(s^2 m^(1/2))", 0, false},
    Multiple{"kN/m^1.5", "kg/(s^2 m^(1/2))", 3},
    Multiple{"MN/m^1.5", "kg/(s^2 m^(1/2))", 6},
    Multiple{"GN/m^1.5", "kg/(s^2 m^(1/2))", 9},
};

struct NumberAndUnit {
  std::string number;
  std::string_view unit;
};

/// Where the number ends the unit begins, after a blank or none.
std::optional<NumberAndUnit> parts_of(std::string_view text) {
  const bool plus = text.starts_with('+');
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, status] = std::from_chars(text.data() + (plus ? 1 : 0), end, value);
  if (status != std::errc{}) return std::nullopt;
  const auto length = static_cast<std::size_t>(rest - text.data());
  std::string_view unit = text.substr(length);
  if (unit.starts_with(' ')) unit.remove_prefix(1);
  return NumberAndUnit{std::string(text.substr(0, length)), unit};
}

constexpr std::size_t longest_list = 10000;

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  for (auto at = text.find(separator); at != std::string_view::npos; at = text.find(separator)) {
    pieces.push_back(text.substr(0, at));
    text.remove_prefix(at + 1);
  }
  pieces.push_back(text);
  return pieces;
}

std::string accepted(std::string_view si) {
  if (si == count_unit) return "a finite number without unit";
  const std::string units = unit_choices(si);
  if (units.empty()) return "a finite number";
  return fmt::format("a finite number, plain or {}", si.empty() ? "with " + units : "with a unit: " + units);
}

/// The numbers between separators.
std::vector<double> each_of(const std::vector<std::string_view>& pieces, std::string_view si) {
  std::vector<double> values;
  std::size_t with_unit = 0;
  for (const std::string_view piece : pieces) {
    const auto value = parse_quantity(piece, si);
    if (!value) throw std::invalid_argument(accepted(si));
    values.push_back(*value);
    with_unit += parts_of(piece)->unit.empty() ? 0 : 1;
  }
  if (with_unit != 0 && with_unit != pieces.size())
    throw std::invalid_argument("a list with a unit at every number or at none");
  return values;
}

/// From the first to the second in steps of the third. The sums are rounded to 14 digits, so that 0.3 + 3 × 0.1 is 0.6.
std::vector<double> steps_of(const std::vector<double>& range) {
  const double from = range[0], to = range[1], step = range[2], count = (to - from) / step;
  if (!(count >= 0 && count < static_cast<double>(longest_list)))
    throw std::invalid_argument(
        fmt::format("from:to:step with a step that leads from one to the other, {} values at most", longest_list));
  const auto steps = static_cast<std::size_t>(count * (1 + 1e-12) + 1e-9);
  std::vector<double> values;
  values.reserve(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i)
    values.push_back(*parse_number(significant(from + static_cast<double>(i) * step, 14)));
  return values;
}

}  // namespace

std::optional<int> decimal_exponent(std::string_view unit, std::string_view si) {
  const bool plain = si.empty() || si == count_unit;
  if (unit.empty() || unit == si || (plain && (unit == "-" || unit == "1"))) return 0;
  for (const Multiple& m : multiples)
    if (m.unit == unit && m.si == si) return m.exponent;
  return std::nullopt;
}

std::string unit_choices(std::string_view si) {
  if (si == count_unit) return "";
  std::vector<std::string_view> names;
  if (!si.empty()) names.push_back(si);
  if (si == "rad") names.push_back("deg");
  for (const Multiple& m : multiples)
    if (m.si == si && m.offered) names.push_back(m.unit);
  if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
  const std::string_view last = names.back();
  names.pop_back();
  return fmt::format("{} or {}", fmt::join(names, ", "), last);
}

std::optional<double> parse_quantity(std::string_view text, std::string_view si) {
  const auto parts = parts_of(text);
  if (!parts) return std::nullopt;
  if (si == "rad" && parts->unit == "deg") {
    const auto degrees = parse_number(parts->number);
    return degrees ? std::optional(*degrees * (std::numbers::pi / 180)) : std::nullopt;
  }
  const auto exponent = decimal_exponent(parts->unit, si);
  if (!exponent || parts->unit == "-" || parts->unit == "1") return std::nullopt;
  return scaled(parts->number, *exponent);
}

std::vector<double> parse_quantities(std::string_view text, std::string_view si) {
  const auto range = split(text, ':');
  if (range.size() == 1) return each_of(split(text, ','), si);
  if (range.size() != 3) throw std::invalid_argument("from:to:step, a list a,b,c or one number");
  return steps_of(each_of(range, si));
}

}  // namespace ricochet::console
