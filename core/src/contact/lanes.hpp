#pragma once

// Doubles that a processor computes side by side, for loops whose order g++ would not keep.

#include <cstring>

namespace ricochet::contact {

/// What every x86-64 and ARM64 holds in a register.
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;

/// Fills `to`, a vector of doubles, from an array. Not by return: wider vectors than the file's target change its ABI.
template <class Vector>
[[gnu::always_inline]] inline void load(Vector& to, const double* from) noexcept {
  std::memcpy(&to, from, sizeof to);
}

inline Pair pair_at(const double* from) noexcept {
  Pair pair;
  load(pair, from);
  return pair;
}

}  // namespace ricochet::contact
