#pragma once

#include "scaled_contact.hpp"

#include <functional>

namespace ricochet::collision {

/// Where the events of a collision lie, to a per mille or so; times of the scaled motion from the touch on.
struct Scouted {
  CollisionStatus status = CollisionStatus::budget_spent;  ///< an end, or why there is none
  double turn = 0;                                         ///< when the overlap is greatest; 0: it never turned
  double end = 0;
  bool by_overlap = false;  ///< the overlap may have returned to 0 no later than the force
  Instant deepest = {}, strongest = {};
  Instant rest = {};  ///< where the rate fell to `at_rest` of v₀ before any turn; counts for a permanent contact
};

/// Shows `visit` every instant, with the memory as it then is.
using Visit = std::function<void(const Instant&)>;
Scouted scout(
    ScaledContact& contact, ContactEnd end, std::size_t budget, const Visit& visit = [](const Instant&) {});

}  // namespace ricochet::collision
