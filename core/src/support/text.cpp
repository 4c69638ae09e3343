#include <ricochet/support/text.hpp>

#include <array>
#include <charconv>

namespace ricochet::support {

namespace {

// 400 characters hold every double in fixed notation with up to 80 digits after the point.
template <class... Format>
std::string convert(double value, Format... format) {
  std::array<char, 400> digits{};
  const auto [end, status] = std::to_chars(digits.data(), digits.data() + digits.size(), value, format...);
  return status == std::errc{} ? std::string(digits.data(), end) : std::string("?");
}

}  // namespace

std::string shortest(double value) {
  std::string text;
  append_shortest(text, value);
  return text;
}

void append_shortest(std::string& text, double value) {
  std::array<char, 32> digits{};  // hold every shortest double
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

std::string significant(double value, int digits) { return convert(value, std::chars_format::general, digits); }

std::string fixed(double value, int digits) {
  std::string text = convert(value, std::chars_format::fixed, digits);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);
  return text;
}

std::string scientific(double value, int digits) { return convert(value, std::chars_format::scientific, digits); }

}  // namespace ricochet::support
