#pragma once

#include <cmath>

namespace ricochet::support {

/// Throws std::invalid_argument "<name> = <value>: must be <accepted>" unless `ok`.
[[noreturn]] void reject(const char* name, double value, const char* accepted);

inline void require(bool ok, const char* name, double value, const char* accepted) {
  if (!ok) reject(name, value, accepted);
}

inline void require_positive(const char* name, double value) {
  require(std::isfinite(value) && value > 0, name, value, "finite and > 0");
}

inline void require_not_negative(const char* name, double value) {
  require(std::isfinite(value) && value >= 0, name, value, "finite and >= 0");
}

}  // namespace ricochet::support
