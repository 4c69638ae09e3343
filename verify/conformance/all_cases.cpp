#include "families.hpp"

namespace ricochet::verify::conformance {

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const auto family : {normal_cases, oblique_cases, plane_cases, falling_cases, again_cases, first_step_cases})
    for (Case& c : family()) all.push_back(std::move(c));
  return all;
}

}  // namespace ricochet::verify::conformance
