#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/support/require.hpp>

namespace ricochet::collision {

/// Throws std::invalid_argument for what every `collide` refuses.
inline void require_impact(const Impact& impact, const CollideOptions& options) {
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  support::require(options.breakage_energy >= 0, "breakage_energy", options.breakage_energy, ">= 0");
}

}  // namespace ricochet::collision
