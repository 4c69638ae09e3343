/* -*- c++ -*- ----------------------------------------------------------
   compute fractional/energy: what the normal contacts of the granular models fractional hold and lost, of Ricochet.
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(fractional/energy,ComputeFractionalEnergy);
// clang-format on
#else

#ifndef LMP_COMPUTE_FRACTIONAL_ENERGY_H
#define LMP_COMPUTE_FRACTIONAL_ENERGY_H

#include "compute.h"

namespace LAMMPS_NS {

// A global vector of all pairs and walls, whatever the group: the energy that the contacts' springs hold now, and what
// was lost since the compute was made. Their sum and the kinetic and potential energies of grains without friction stay
// the same, see docs/lammps.md.
class ComputeFractionalEnergy : public Compute {
 public:
  ComputeFractionalEnergy(class LAMMPS*, int, char**);
  ~ComputeFractionalEnergy() override;
  void init() override;
  void compute_vector() override;

 private:
  double dissipated_before;  // this one was made, on this rank
};

}  // namespace LAMMPS_NS

#endif
#endif
