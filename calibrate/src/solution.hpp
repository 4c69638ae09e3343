#pragma once

#include "family.hpp"

#include <string>

namespace ricochet::calibration {

/// What a method found, in the units of the target.
struct Solution {
  AnyLaw law;
  std::string algorithm;
  std::size_t evaluations;  ///< collisions tried
};

/// The reduction of `unit_law`: the one dimensionless group from e_n, then the scale. nullopt as there.
std::optional<Solution> solve_directly(LawName law, ContactEnd end, double en);

/// The search; its best point, whether or not it met the tolerance.
Solution search(LawName law, ContactEnd end, double en, const std::string& algorithm, double tolerance);

/// The collision of a law in the units of the target.
inline Collision unit_collision(LawName law, const Coordinates& x, ContactEnd end) {
  return collide(scaled_law(law, x), {1, 1}, {end});
}

/// Throws std::invalid_argument for a target or stiffness outside its domain and for an end that the law does not
/// offer.
void require_request(const Request& request);

/// The law by the direct reduction alone, where doubles carry it to the tolerance; the request is a valid one.
std::variant<AnyLaw, Infeasible> calibrate_directly(const Request& request, double tolerance);

}  // namespace ricochet::calibration
