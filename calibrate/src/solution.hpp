#pragma once

#include <calibrate/calibration.hpp>
#include <ricochet/collision/loaded.hpp>

#include <string>

namespace ricochet::calibration {

/// What a method found, in the units of the target.
struct Solution {
  AnyLaw law;
  std::string algorithm;
  std::size_t evaluations;  ///< collisions tried
};

/// The search; its best point, whether or not it met the tolerance. `load` is in the units of the target.
Solution search(const Request& request, const std::string& algorithm, double tolerance, double load = 0);

/// The collision of a law in the units of the target.
inline Collision unit_collision(const Request& request, const Coordinates& x, double load = 0) {
  constexpr std::size_t budget = 100'000;  // a force that all but grazes 0 would spend what it gets
  const AnyLaw law = scaled_law(request.law, x, request.held);
  if (load > 0) return collide_under_load(law, {1, 1}, load, {.max_evaluations = budget});
  return collide(law, {1, 1}, {request.end});
}

/// A law in the units of the target in SI units; the fractional law with the k that it holds. nullopt where a parameter
/// is then no normal double.
std::optional<AnyLaw> brought_to(const AnyLaw& scaled, const Request& request);

/// Throws std::invalid_argument for a target, stiffness or what is held outside its domain and for an end that the law
/// does not offer.
void require_request(const Request& request);

/// What calibration has to hold to find that law; the defaults of a law that holds nothing.
Held held_of(const AnyLaw& law);

/// The same with the α that its stiffness leaves, where a law has both; or why there is none.
std::variant<Request, Infeasible> with_degree(const Request& request);

/// The law by the direct reduction alone, where doubles carry it to the tolerance; the request is a valid one.
std::variant<AnyLaw, Infeasible> calibrate_directly(const Request& request, double tolerance);

}  // namespace ricochet::calibration
