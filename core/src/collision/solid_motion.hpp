#pragma once

#include "memory_collocation.hpp"

#include <ricochet/contact/laws.hpp>
#include <ricochet/fractional/viscoelastic_motion.hpp>

#include <optional>

namespace ricochet::collision {

// What the laws of real solids are at their limits, and the motions that follow them elsewhere.

/// The linear law that is the same: at α = 1, at α = 0 and without a springpot; of Zener's also where no double carries
/// k₁τ^α.
std::optional<Linear> limit_of(const FractionalKelvinVoigt& law);
std::optional<Linear> limit_of(const FractionalZener& law, double mass);
/// Kuwabara and Kono's: at α = 1, at α = 0 and where the springpot has less than 1e-16 of the force.
std::optional<KuwabaraKono> limit_of(const FractionalHertz& law, const Impact& impact);

/// A linear motion from x = 0, x' = 1 in units of time in which M(1) is about 1.
struct SolidMotion {
  double unit;  ///< [s]
  ViscoelasticMotion motion;
};
/// nullopt where its scales lie farther apart than doubles carry; the law is none of its limits.
std::optional<SolidMotion> motion_of(const FractionalKelvinVoigt& law, double mass);
std::optional<SolidMotion> motion_of(const FractionalZener& law, double mass);

/// The equation of a collision in units of time in which neither of its forces is much greater than 1.
struct ScaledEquation {
  double unit;  ///< [s]
  MemoryEquation equation;
};
std::optional<ScaledEquation> equation_of(const FractionalHertz& law, const Impact& impact);

}  // namespace ricochet::collision
