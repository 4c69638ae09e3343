#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/fractional/viscoelastic_motion.hpp>

namespace ricochet::collision {

/// The collision of a viscoelastic motion, whose unit of time is such that M(1) is about 1: the first zeros of its
/// transforms. Scaled; see `in_units`. no_separation where the overlap never returns to 0.
Collision closed_form(const ViscoelasticMotion& motion, ContactEnd end);

}  // namespace ricochet::collision
