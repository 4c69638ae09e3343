#include "energy_tally.hpp"

#include <map>

namespace ricochet::lammps {

EnergyTally& energy_tally(const LAMMPS_NS::LAMMPS* lmp) {
  static std::map<const LAMMPS_NS::LAMMPS*, EnergyTally> tallies;
  return tallies[lmp];
}

}  // namespace ricochet::lammps
