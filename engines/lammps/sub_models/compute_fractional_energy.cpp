/* ----------------------------------------------------------------------
   compute fractional/energy, of Ricochet.
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "compute_fractional_energy.h"

#include "error.h"
#include "energy_tally.hpp"
#include "update.h"

using namespace LAMMPS_NS;

using ricochet::lammps::energy_tally;

/* ---------------------------------------------------------------------- */

ComputeFractionalEnergy::ComputeFractionalEnergy(LAMMPS* lmp, int narg, char** arg) : Compute(lmp, narg, arg) {
  if (narg != 3) error->all(FLERR, "compute fractional/energy takes no arguments beyond ID and group");
  vector_flag = 1;
  size_vector = 2;
  extvector = 1;
  vector = new double[size_vector]{};
  auto& tally = energy_tally(lmp);
  tally.users++;
  dissipated_before = tally.dissipated;
}

/* ---------------------------------------------------------------------- */

ComputeFractionalEnergy::~ComputeFractionalEnergy() {
  energy_tally(lmp).users--;
  delete[] vector;
}

/* ----------------------------------------------------------------------
   Before the forces that set a run up, which are of the step that the last
   run ended with.
------------------------------------------------------------------------- */

void ComputeFractionalEnergy::init() { energy_tally(lmp).stored_at = -1; }

/* ---------------------------------------------------------------------- */

void ComputeFractionalEnergy::compute_vector() {
  invoked_vector = update->ntimestep;
  const auto& tally = energy_tally(lmp);
  // Not const: the MPI of a LAMMPS that is built without one takes a void*.
  double here[2] = {tally.stored_at == update->ntimestep ? tally.stored : 0.0, tally.dissipated - dissipated_before};
  MPI_Allreduce(here, vector, size_vector, MPI_DOUBLE, MPI_SUM, world);
}
