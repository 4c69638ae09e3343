#pragma once

#include <string>

/// E_{a,b}(x) and x E'(x) in multiprecision, straight from the definitions: the Taylor series while its cancellation
/// fits the digits carried, past that poles and asymptotic series. Shares no formula with the library but these.
struct Reference {
  double value, slope;  ///< E and x E', rounded
  std::string digits;   ///< E to 20 digits
};

/// 0 < a ≤ 3, b > 0; a value past the largest double gives infinity.
Reference mittag_leffler_reference(double a, double b, double x);
