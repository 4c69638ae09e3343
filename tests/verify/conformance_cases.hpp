#pragma once

#include "../../verify/conformance/grade.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace ricochet::verify::conformance {

inline Case case_named(const std::string& name) {
  static const std::vector<Case> all = all_cases();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Case& c) { return c.name == name; });
  if (found == all.end()) throw std::logic_error("no case " + name);
  return *found;
}

inline Answered answered_case(const std::string& name) { return answered({case_named(name)}).front(); }

/// What an engine would give whose every required number is off by `error(steps)` of its scale; of cases of one contact
/// along x, which are asked for v_x and the time of separation alone.
template <class Error>
CaseResult off_by(const Answered& of, const std::vector<int>& steps, const Error& error) {
  CaseResult result{of.of.name};
  for (const int n : steps) {
    Run run{n, of.solution.bodies};
    const double e = error(n);
    double separation = of.solution.separation;
    for (const Answer& a : of.answers) {
      if (!a.required) continue;
      if (a.quantity == Quantity::vx) run.bodies[a.body - 1].velocity.x += e * a.scale;
      if (a.quantity == Quantity::separation) separation += e * a.scale;
    }
    // Where the bodies are at the end: apart since the separation.
    const double flown = of.of.end_of_run(n) - separation;
    Body& a = run.bodies[0];
    if (run.bodies.size() == 1) {
      a.position.x = a.radius + a.velocity.x * flown;
    } else {
      Body& b = run.bodies[1];
      a.position.x = 0, b.position.x = a.radius + b.radius + (b.velocity.x - a.velocity.x) * flown;
    }
    result.runs.push_back(run);
  }
  return result;
}

}  // namespace ricochet::verify::conformance
