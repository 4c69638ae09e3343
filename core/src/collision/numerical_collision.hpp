#pragma once

#include <ricochet/collision/collision.hpp>

#include "damped_power.hpp"

namespace ricochet::collision {

/// Follows the scaled motion from the first touch to the asked end. Scaled result; see `in_units`.
template <int P, int Q, int R>
Collision follow(const DampedPower<P, Q, R>& motion, const CollideOptions& options);

extern template Collision follow(const LinearMotion&, const CollideOptions&);
extern template Collision follow(const KuwabaraKonoMotion&, const CollideOptions&);
extern template Collision follow(const TsujiMotion&, const CollideOptions&);

/// The hysteretic law's two branches, k₁ = 1 and k₂ = `stiffening`. Scaled result.
Collision follow_hysteretic(double stiffening, const CollideOptions& options);

/// The fractional law by collocation of its Volterra equation, without the Mittag-Leffler function. In SI units.
Collision follow_fractional(const Fractional& law, const Impact& impact, ContactEnd end);

}  // namespace ricochet::collision
