#include "run_state.hpp"

#include <map>

namespace ricochet::lammps {

void RunState::begin_run(std::int64_t first, std::int64_t last) noexcept {
  if (first == first_step && last == last_step) return;
  first_step = first;
  last_step = last;
  coarse_said = soft_said = forgotten_said = kernel_said = false;
}

void RunState::add_stored(std::int64_t step, double energy) noexcept {
  if (stored_at != step) stored = 0;
  stored_at = step;
  stored += energy;
}

RunState& run_state(const LAMMPS_NS::LAMMPS* lmp) {
  static std::map<const LAMMPS_NS::LAMMPS*, RunState> states;
  return states[lmp];
}

}  // namespace ricochet::lammps
