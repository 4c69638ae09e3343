#include <simulate/random.hpp>

namespace ricochet::simulate {

std::uint64_t Random::bits() noexcept {
  std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

// Von Neumann's: a falling run of uniform numbers below x is of even length with probability e^−x, 0 ≤ x ≤ 1.
bool Random::happens(double x) noexcept {
  while (x > 1) {
    if (!happens(1)) return false;
    x -= 1;
  }
  bool even = true;
  for (double last = x;; even = !even) {
    const double next = uniform();
    if (next >= last) return even;
    last = next;
  }
}

double Random::normal() noexcept {
  for (;;) {
    int whole = 0;
    while (happens(0.5)) ++whole;
    if (!happens(0.5 * whole * (whole - 1))) continue;
    const double part = uniform();
    if (!happens(0.5 * part * (2 * whole + part))) continue;
    const double size = whole + part;
    return bits() >> 63 ? -size : size;
  }
}

double exponential(double x) noexcept {
  constexpr int halvings = 10, terms = 10;
  const double small = x / (1 << halvings);  // |small| ≤ 0.05: the terms left out are below 1e-19
  double sum = 1;
  for (int k = terms; k > 0; --k) sum = 1 + small / k * sum;
  for (int k = 0; k < halvings; ++k) sum *= sum;
  return sum;
}

}  // namespace ricochet::simulate
