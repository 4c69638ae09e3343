#include <ricochet/support/require.hpp>

#include <charconv>
#include <stdexcept>
#include <string>

namespace ricochet::support {

void reject(std::string_view name, double value, std::string_view accepted) {
  // std::to_chars, not printf: the message must not depend on the locale.
  char digits[32];
  const auto [end, status] = std::to_chars(digits, digits + sizeof digits, value);
  (void)status;  // 32 characters hold every shortest double
  throw std::invalid_argument(std::string(name) + " = " + std::string(digits, end) + ": must be " +
                              std::string(accepted));
}

}  // namespace ricochet::support
