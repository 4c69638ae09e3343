#include "energy_tally.hpp"

#include <map>

namespace ricochet::lammps {

void EnergyTally::add_stored(std::int64_t step, double energy) noexcept {
  if (stored_at != step) stored = 0;
  stored_at = step;
  stored += energy;
}

EnergyTally& energy_tally(const LAMMPS_NS::LAMMPS* lmp) {
  static std::map<const LAMMPS_NS::LAMMPS*, EnergyTally> tallies;
  return tallies[lmp];
}

}  // namespace ricochet::lammps
