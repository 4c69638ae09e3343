#pragma once

#include "engine_headers.hpp"
#include "fractional_model.hpp"
#include "grain_contacts.hpp"

#include <array>
#include <optional>

namespace ricochet::lammps {

/// `fix ID GROUP wall/fractional xplane|yplane|zplane LO HI K C ALPHA|target T_COL E_N [memory TIME] [energy yes|no]`:
/// one or two resting planes, NULL for one that is not there, with the contact of `pair_style fractional`; the
/// effective mass is the grain's. As a vector: energy that the springs hold, energy lost.
class FixWallFractional : public GrainContacts {
 public:
  FixWallFractional(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int vflag) override { post_force(vflag); }
  void post_force(int) override;
  double compute_vector(int n) override;

 private:
  void read_planes(char** arg);
  void press(int i, Partner side);

  FractionalModel model_;
  int axis_ = 0;
  std::array<std::optional<double>, 2> planes_;  // low and high
  GivenLaw law_;
};

}  // namespace ricochet::lammps
