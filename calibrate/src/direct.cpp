#include "solution.hpp"

namespace ricochet::calibration {

std::optional<Solution> solve_directly(LawName law, ContactEnd end, double en) {
  const auto found = unit_law(law, en, end);
  if (!found) return std::nullopt;
  return Solution{found->law, found->closed_form ? "closed form" : "bracketed root", found->collisions};
}

}  // namespace ricochet::calibration
