#pragma once

#include "engine_headers.hpp"
#include "fractional_model.hpp"
#include "pair_contacts.hpp"

#include <vector>

namespace ricochet::lammps {

/// `pair_style fractional [memory TIME] [energy yes|no]` with `pair_coeff I J K C ALPHA` or `… target T_COL E_N`: the
/// normal contact of spheres by the fractional law (30), R = c^α k^{1−α} D^α ζ, repulsive only. Frictionless.
/// What it sums up (`compute pair fractional`): energy that the springs hold, energy lost.
class PairFractional : public LAMMPS_NS::Pair {
 public:
  explicit PairFractional(LAMMPS_NS::LAMMPS* lmp);
  ~PairFractional() override;

  void settings(int narg, char** arg) override;
  void coeff(int narg, char** arg) override;
  void init_style() override;
  double init_one(int i, int j) override;
  void compute(int eflag, int vflag) override;
  double single(int i, int j, int itype, int jtype, double rsq, double, double, double& force_over_r) override;

  void write_restart(FILE* file) override;
  void write_restart_settings(FILE* file) override;
  void read_restart(FILE* file) override;
  void read_restart_settings(FILE* file) override;

 private:
  void allocate();
  void claim_contacts();
  std::vector<double> greatest_radii() const;
  void look_at_present_grains();
  std::size_t kind(int itype, int jtype) const { return static_cast<std::size_t>(itype - 1) * types_ + jtype - 1; }
  double mass_eff(int i, int j) const;
  void pass(int i, int j, const double* apart, double rsq);

  FractionalModel model_;
  PairContacts* contacts_ = nullptr;  // LAMMPS's own
  int types_ = 0;
  std::vector<GivenLaw> laws_;      // by kind
  std::vector<double> radius_max_;  // by type
  int frozen_ = 0;                  // bit of the group that `fix freeze` holds
};

}  // namespace ricochet::lammps
