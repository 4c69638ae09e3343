#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ricochet::lammps {

/// Makes compute fractional/energy known to a LAMMPS whose library was built without it. `clear` forgets it, so it is
/// done again whenever a granular model is made.
void add_compute(LAMMPS_NS::LAMMPS& lmp);

}  // namespace ricochet::lammps
