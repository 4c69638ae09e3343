#include "decimal.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <cmath>

namespace ricochet::console {

std::optional<double> scaled(const std::string& number, int exponent) {
  const auto mark = number.find_first_of("eE");
  if (exponent == 0) return parse_number(number);
  if (mark == std::string::npos) return parse_number(fmt::format("{}e{}", number, exponent));
  const auto own = parse_number(number.substr(mark + 1));
  if (!own || !(std::abs(*own) < 1e4) || number.find('.', mark) != std::string::npos) return std::nullopt;
  return parse_number(fmt::format("{}e{}", number.substr(0, mark), static_cast<int>(*own) + exponent));
}

}  // namespace ricochet::console
