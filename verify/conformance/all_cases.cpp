#include "families.hpp"

#include <algorithm>
#include <type_traits>

namespace ricochet::verify::conformance {

namespace {

/// Of a stepping that finds begin and end of a contact inside the step. Where the damping force begins like ζ^q ζ', 0 <
/// q < 1, the force has no derivative at the touch: ζ ≈ v t, and the step that it lies in errs by O(h^{1+q}) in the
/// impulse, at whatever place of it the force is taken.
double located_order(const Meeting& meeting) {
  return std::visit(
      [](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (requires { Law::damping_power; })
          if (law.c() > 0 && Law::damping_power > 0) return std::min(2.0, 1 + Law::damping_power);
        return 2.0;
      },
      meeting.law);
}

}  // namespace

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const auto family : {normal_cases, oblique_cases, plane_cases, falling_cases, again_cases, first_step_cases})
    for (Case& c : family()) {
      for (const auto& meeting : {c.law, c.wall_law})
        if (meeting) c.orders.located = std::min(c.orders.located, located_order(*meeting));
      all.push_back(std::move(c));
    }
  return all;
}

}  // namespace ricochet::verify::conformance
