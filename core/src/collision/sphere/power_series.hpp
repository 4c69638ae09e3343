#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ricochet::collision {

/// Coefficients of (Σ c_j z^j)^q, c_0 = 1, by Miller's recurrence; the next one after those of `power` so far.
/// `c` has more terms than `power`.
template <class Real>
Real next_of_power(std::span<const Real> c, std::span<const Real> power, Real q) {
  const std::size_t n = power.size();
  Real sum = 0;
  for (std::size_t k = 1; k <= n; ++k)
    sum += (q * static_cast<Real>(k) - static_cast<Real>(n - k)) * c[k] * power[n - k];
  return sum / static_cast<Real>(n);
}

}  // namespace ricochet::collision
