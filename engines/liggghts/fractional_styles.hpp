#pragma once

namespace ricochet::liggghts {

/// Makes `model fractional` and those of the laws of real solids known to LIGGGHTS for pairs and walls, with every
/// tangential, cohesion and rolling model of LIGGGHTS that does not need the normal model it was written for (its
/// Luding family does). Once a process, before the first input line.
void register_fractional_styles();

}  // namespace ricochet::liggghts
