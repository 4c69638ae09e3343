#pragma once

#include <cstdint>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ricochet::lammps {

/// What all sub-models of one LAMMPS share on this rank.
struct RunState {
  // What was said in the run that began and is to end at these steps: once each.
  std::int64_t first_step = -1, last_step = -1;
  bool coarse_said = false, soft_said = false, forgotten_said = false, kernel_said = false;

  // Energies [energy] of the normal contacts that were looked at, for compute fractional/energy; a pair that the other
  // rank looks at too gives half of its own.
  bool energy_wanted = false;
  std::int64_t stored_at = -1;  // the step that `stored` is of
  double stored = 0, dissipated = 0;

  void begin_run(std::int64_t first, std::int64_t last) noexcept;
  void add_stored(std::int64_t step, double energy) noexcept;
};

RunState& run_state(const LAMMPS_NS::LAMMPS* lmp);

}  // namespace ricochet::lammps
