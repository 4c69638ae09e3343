#pragma once

#include <cmath>
#include <string_view>

namespace ricochet::support {

/// Throws std::invalid_argument "<name> = <value>: must be <accepted>" unless `ok`.
[[noreturn]] void reject(std::string_view name, double value, std::string_view accepted);

inline void require(bool ok, std::string_view name, double value, std::string_view accepted) {
  if (!ok) reject(name, value, accepted);
}

inline void require_positive(std::string_view name, double value) {
  require(std::isfinite(value) && value > 0, name, value, "finite and > 0");
}

inline void require_not_negative(std::string_view name, double value) {
  require(std::isfinite(value) && value >= 0, name, value, "finite and >= 0");
}

}  // namespace ricochet::support
