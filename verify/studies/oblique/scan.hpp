#pragma once

#include <cstddef>

namespace ricochet::verify::oblique {

/// What random impacts showed: two spheres or a sphere and a wall, every law of the list with every tangential law,
/// with and without torsion and rolling resistance, any spins and directions.
struct Scan {
  std::size_t impacts = 0, failed = 0;
  double most_gained = 0;    ///< greatest gain of kinetic energy, of what there was; < 0: all lost some
  double worst_balance = 0;  ///< greatest |lost by kinetic energy − lost by mechanism|, of what there was
  double most_negative = 0;  ///< greatest negative loss of one mechanism, of what there was
  double worst_limit = 0;    ///< greatest |tangential impulse|/(μ_s normal impulse)
};

/// The same impacts each time: the generator is seeded by their number in the row.
Scan scan(std::size_t impacts);

}  // namespace ricochet::verify::oblique
