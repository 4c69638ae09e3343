#include <console/number.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace ricochet::console {

namespace {

// 400 characters hold every double in fixed notation with up to 80 digits after the point.
template <class... Format>
std::string convert(double value, Format... format) {
  std::array<char, 400> digits{};
  const auto [end, status] = std::to_chars(digits.data(), digits.data() + digits.size(), value, format...);
  return status == std::errc{} ? std::string(digits.data(), end) : std::string("?");
}

}  // namespace

std::string shortest(double value) { return convert(value); }

std::string significant(double value, int digits) { return convert(value, std::chars_format::general, digits); }

std::string fixed(double value, int digits) { return convert(value, std::chars_format::fixed, digits); }

std::string scientific(double value, int digits) { return convert(value, std::chars_format::scientific, digits); }

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace ricochet::console
