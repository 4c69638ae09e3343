#pragma once

#include <cstdint>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ricochet::lammps {

/// Energies [energy] of the normal contacts of one LAMMPS on this rank, for compute fractional/energy. A pair that
/// another rank looks at too gives half of its own.
struct EnergyTally {
  int users = 0;                ///< computes; without any nothing is tallied
  std::int64_t stored_at = -1;  ///< the step that `stored` is of; −1: none
  double stored = 0, dissipated = 0;

  void add_stored(std::int64_t step, double energy) noexcept;
};

/// The one that all sub-models of `lmp` share.
EnergyTally& energy_tally(const LAMMPS_NS::LAMMPS* lmp);

}  // namespace ricochet::lammps
