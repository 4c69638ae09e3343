#pragma once

#include <string>

namespace ricochet::console {

/// The end of a range, itself in it unless `open`.
struct Bound {
  double value;
  enum Side { lower, upper } side;
  bool open = false;
};

/// The fewest digits, `least` or more, by which the bound is still kept and what was refused, if it lies beyond, is
/// not: no message is to say "2.57e-05: must be at most 2.57e-05".
std::string bound_text(Bound bound, double refused, int least = 6);

}  // namespace ricochet::console
