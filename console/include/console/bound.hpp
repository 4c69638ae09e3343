#pragma once

#include <string>

namespace ricochet::console {

enum class Bound { lower, upper };

/// The end of a range with the fewest digits, `least` or more, that lie within it: what lies beyond the end lies beyond
/// what is said, too, and no message is to read "2.57e-05: must be at most 2.57e-05".
std::string bound_text(Bound side, double end, int least = 6);

}  // namespace ricochet::console
