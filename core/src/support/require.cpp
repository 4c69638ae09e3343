#include <ricochet/support/require.hpp>

#include <charconv>
#include <stdexcept>
#include <string>

namespace ricochet::support {

void reject(const char* name, double value, const char* accepted) {
  // std::to_chars, not printf: the message must not depend on the locale.
  char digits[32];
  const auto [end, status] = std::to_chars(digits, digits + sizeof digits, value);
  (void)status;  // 32 characters hold every shortest double
  throw std::invalid_argument(std::string(name) + " = " + std::string(digits, end) + ": must be " + accepted);
}

}  // namespace ricochet::support
