#pragma once

#include <cmath>

namespace ricochet::support {

/// x^{Quarters/4}, x ≥ 0, by products and square roots: the powers of contact laws are whole numbers of quarters, and a
/// general power costs several times as much. Error: below 4 roundings for |Quarters| ≤ 16.
template <int Quarters>
double quarter_power(double x) noexcept {
  if constexpr (Quarters < 0) {
    return 1 / quarter_power<-Quarters>(x);
  } else if constexpr (Quarters > 4) {
    return x * quarter_power<Quarters - 4>(x);
  } else if constexpr (Quarters == 4) {
    return x;
  } else if constexpr (Quarters == 3) {
    const double root = std::sqrt(x);
    return root * std::sqrt(root);
  } else if constexpr (Quarters == 2) {
    return std::sqrt(x);
  } else if constexpr (Quarters == 1) {
    return std::sqrt(std::sqrt(x));
  } else {
    return 1;
  }
}

}  // namespace ricochet::support
