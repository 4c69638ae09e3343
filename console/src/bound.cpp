#include <console/bound.hpp>
#include <console/number.hpp>

namespace ricochet::console {

std::string bound_text(Bound side, double end, int least) {
  for (int digits = least; digits < 17; ++digits) {
    std::string text = significant(end, digits);
    if (const auto told = parse_number(text); told && (side == Bound::upper ? *told <= end : *told >= end)) return text;
  }
  return shortest(end);
}

}  // namespace ricochet::console
