/* -*- c++ -*- ----------------------------------------------------------
   Sub-models of pair granular: the laws with a fractional memory, of Ricochet.
   SPDX-License-Identifier: GPL-3.0-or-later
   As every such header of LAMMPS it is read twice: for the styles' names, and for their classes.
------------------------------------------------------------------------- */

#ifdef GRAN_SUB_MOD_CLASS
// clang-format off
GranSubModStyle(fractional,GranSubModNormalFractional,NORMAL);
GranSubModStyle(fractional/target,GranSubModNormalFractionalTarget,NORMAL);
GranSubModStyle(fractional/kelvin_voigt,GranSubModNormalFractionalKelvinVoigt,NORMAL);
GranSubModStyle(fractional/kelvin_voigt/target,GranSubModNormalFractionalKelvinVoigtTarget,NORMAL);
GranSubModStyle(fractional/hertz,GranSubModNormalFractionalHertz,NORMAL);
GranSubModStyle(fractional/hertz/target,GranSubModNormalFractionalHertzTarget,NORMAL);
GranSubModStyle(fractional/zener,GranSubModNormalFractionalZener,NORMAL);
GranSubModStyle(fractional/zener/target,GranSubModNormalFractionalZenerTarget,NORMAL);
GranSubModStyle(fractional,GranSubModDampingFractional,DAMPING);
GranSubModStyle(fractional/memory,GranSubModDampingFractionalMemory,DAMPING);
// clang-format on
#else

#ifndef LMP_GRAN_SUB_MOD_FRACTIONAL_H
#define LMP_GRAN_SUB_MOD_FRACTIONAL_H

#include "gran_sub_mod_damping.h"
#include "gran_sub_mod_normal.h"
#include "energy_tally.hpp"

#include <pair_law.hpp>
#include <run_watch.hpp>

#include <optional>
#include <string>
#include <vector>

namespace LAMMPS_NS::Granular_NS {

// What `damping fractional` asks of its normal model.
class GranSubModNormalRemembering : public GranSubModNormal {
 public:
  using GranSubModNormal::GranSubModNormal;

  // Damping [mass/time] of the linear contact with the collision time and restitution of the pair at hand.
  virtual double linear_damping() = 0;
};

// A law as a normal model: what it does with a contact, however its coefficients name the law. The contact remembers
// `ricochet::half_step::ContactHistory`, which has no sign that an exchange of i and j could change.
template <class Law>
class GranSubModNormalOfLaw : public GranSubModNormalRemembering {
 public:
  void coeffs_to_local() override;
  void mix_coeffs(double*, double*) override;
  void init() override;
  double calculate_forces() override;
  double linear_damping() override;

 protected:
  using ContactFor = ricochet::half_step::ContactFor<Law>;
  using PairLaw = ricochet::half_step::PairLaw<Law>;
  using Remark = ricochet::half_step::RunWatch::Remark;

  // The value that NULL stands for, where it may.
  struct Coefficient {
    std::string name;
    std::optional<double> by_default;
  };

  GranSubModNormalOfLaw(GranularModel*, LAMMPS*, std::vector<Coefficient>);

  // Throws std::invalid_argument.
  virtual PairLaw law_of_coeffs(const ContactFor&) const = 0;

 private:
  void choose_law(double dt, double memory);
  void begin_run();
  void watch_contact(double radius);
  double force_found_before(const double* memory, double step);
  void advance_and_tally(double* memory, double step);
  void tally(double energy, double lost);
  void hand_on(const std::optional<Remark>&);

  std::vector<Coefficient> coefficients;
  std::optional<PairLaw> law;
  ricochet::half_step::RunWatch watch;
  ricochet::lammps::EnergyTally& energies;
  bigint first_step = -1, last_step = -1;       // of the run that begin_run() has seen
  bigint seen_step = -1;                        // of the last contact
  double kernel_step = 0;                       // the time step that the arms were chosen for
  double damping_mass = -1, damping_value = 0;  // the last linear_damping()
};

// By its parameters, in the law's order: K C ALPHA; K K1 TAU ALPHA of fractional/zener; of fractional/hertz, whose
// collisions depend on the speed, also the VELOCITY at which t_col and e_n are wanted.
template <class Law>
class GranSubModNormalByParameters : public GranSubModNormalOfLaw<Law> {
 public:
  GranSubModNormalByParameters(GranularModel*, LAMMPS*);

 protected:
  typename GranSubModNormalOfLaw<Law>::PairLaw law_of_coeffs(
      const typename GranSubModNormalOfLaw<Law>::ContactFor&) const override;
};

// By what every pair's collision is to be: TCOL EN, of the laws of real solids ALPHA too, then the VELOCITY of
// fractional/hertz or the K1/K of fractional/zener.
template <class Law>
class GranSubModNormalByTarget : public GranSubModNormalOfLaw<Law> {
 public:
  GranSubModNormalByTarget(GranularModel*, LAMMPS*);

 protected:
  typename GranSubModNormalOfLaw<Law>::PairLaw law_of_coeffs(
      const typename GranSubModNormalOfLaw<Law>::ContactFor&) const override;
};

using GranSubModNormalFractional = GranSubModNormalByParameters<ricochet::Fractional>;
using GranSubModNormalFractionalTarget = GranSubModNormalByTarget<ricochet::Fractional>;
using GranSubModNormalFractionalKelvinVoigt = GranSubModNormalByParameters<ricochet::FractionalKelvinVoigt>;
using GranSubModNormalFractionalKelvinVoigtTarget = GranSubModNormalByTarget<ricochet::FractionalKelvinVoigt>;
using GranSubModNormalFractionalHertz = GranSubModNormalByParameters<ricochet::FractionalHertz>;
using GranSubModNormalFractionalHertzTarget = GranSubModNormalByTarget<ricochet::FractionalHertz>;
using GranSubModNormalFractionalZener = GranSubModNormalByParameters<ricochet::FractionalZener>;
using GranSubModNormalFractionalZenerTarget = GranSubModNormalByTarget<ricochet::FractionalZener>;

// No force of its own: the normal model's is all of it. Says what tangential models scale for their damping.
class GranSubModDampingFractional : public GranSubModDamping {
 public:
  GranSubModDampingFractional(GranularModel*, LAMMPS*);
  void init() override;
  double calculate_forces() override;

  // How long a contact remembers [time]; 0: a thousand time steps.
  virtual double memory() const { return 0; }

 private:
  GranSubModNormalRemembering* normal = nullptr;
};

// The same with one coefficient, that time.
class GranSubModDampingFractionalMemory : public GranSubModDampingFractional {
 public:
  GranSubModDampingFractionalMemory(GranularModel*, LAMMPS*);
  void coeffs_to_local() override;
  double memory() const override { return coeffs[0]; }
};

}  // namespace LAMMPS_NS::Granular_NS

#endif
#endif
