#include "fix_wall_fractional.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace ricochet::lammps {

namespace {

constexpr int words_before_law = 6;  // ID, group, style, axis, low, high

int axis_of(const std::string& word, const FractionalModel& model) {
  constexpr std::array names{"xplane", "yplane", "zplane"};
  const auto* const found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) model.refuse(fmt::format("{}: must be xplane, yplane or zplane", word));
  return static_cast<int>(found - names.begin());
}

}  // namespace

FixWallFractional::FixWallFractional(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : GrainContacts(lmp, narg, arg), model_(lmp, "fix wall/fractional") {
  const int words = words_before_law + GivenLaw::words;
  if (narg < words) model_.refuse("must be xplane|yplane|zplane LO HI, then K C ALPHA or target T_COL E_N");
  axis_ = axis_of(arg[3], model_);
  read_planes(arg + 4);
  law_ = GivenLaw::read({arg + words_before_law, GivenLaw::words}, lmp);
  model_.read_settings({arg + words, static_cast<std::size_t>(narg - words)});
  vector_flag = 1;
  size_vector = 2;
  global_freq = 1;
  extvector = 1;
}

void FixWallFractional::read_planes(char** arg) {
  for (int side = 0; side < 2; ++side)
    if (std::string(arg[side]) != "NULL") planes_[side] = LAMMPS_NS::utils::numeric(FLERR, arg[side], false, lmp);
  if (!planes_[0] && !planes_[1]) model_.refuse("NULL NULL: at least one of LO and HI must be a place");
  if (planes_[0] && planes_[1] && !(*planes_[0] < *planes_[1]))
    model_.refuse(fmt::format("{} {}: must be LO < HI, the grains between them", arg[0], arg[1]));
}

int FixWallFractional::setmask() { return GrainContacts::setmask() | LAMMPS_NS::FixConst::POST_FORCE; }

void FixWallFractional::init() {
  model_.check_deck();
  // Grains beyond it would be taken to the other side, where the plane does not see them.
  if (domain->periodicity[axis_] != 0)
    model_.refuse(fmt::format("{}plane: the box must not be periodic in {} (boundary)", "xyz"[axis_], "xyz"[axis_]));
  model_.begin_run({&law_, 1});
  double here = std::numeric_limits<double>::infinity(), lightest = 0;
  for (int i = 0; i < atom->nlocal; ++i)
    if ((atom->mask[i] & groupbit) != 0) here = std::min(here, atom->rmass[i]);
  MPI_Allreduce(&here, &lightest, 1, MPI_DOUBLE, MPI_MIN, world);
  model_.look_ahead(0, lightest);
}

void FixWallFractional::post_force(int) {
  model_.begin_step();
  for (int i = 0; i < atom->nlocal; ++i) {
    if ((atom->mask[i] & groupbit) == 0) continue;
    for (int side = 0; side < 2; ++side)
      if (planes_[side]) press(i, side);
  }
}

void FixWallFractional::press(int i, Partner side) {
  const double inwards = side == 0 ? 1 : -1;
  const double overlap = atom->radius[i] - inwards * (atom->x[i][axis_] - *planes_[side]);
  if (overlap <= 0) return;
  const double rate = -inwards * atom->v[i][axis_];
  atom->f[i][axis_] += inwards * model_.force({0, atom->rmass[i], overlap, rate, atom->radius[i], 1}, at(i, side));
}

double FixWallFractional::compute_vector(int n) {
  const ContactEnergies& energies = model_.energies();
  const double here = n == 0 ? energies.stored : energies.lost;
  double all = 0;
  MPI_Allreduce(&here, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

}  // namespace ricochet::lammps
