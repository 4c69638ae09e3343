#include <console/bound.hpp>
#include <console/number.hpp>

namespace ricochet::console {

std::string bound_text(Bound bound, double refused, int least) {
  const bool upper = bound.side == Bound::upper;
  const auto tells = [&](double told) {
    if (!(upper ? told <= bound.value : told >= bound.value)) return false;
    const bool beyond = upper ? refused >= bound.value : refused <= bound.value;
    return !beyond || (upper ? refused > told : refused < told) || (bound.open && refused == told);
  };
  for (int digits = least; digits < 17; ++digits)
    if (std::string text = significant(bound.value, digits); tells(parse_number(text).value_or(refused))) return text;
  return shortest(bound.value);
}

}  // namespace ricochet::console
