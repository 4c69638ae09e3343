#include "pair_fractional.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::lammps {

namespace {

constexpr const char* contacts_id = "FRACTIONAL_CONTACTS";

// Read by rank 0, for all.
template <class T>
void read_for_all(T& value, FILE* file, const LAMMPS_NS::LAMMPS& lmp) {
  if (lmp.comm->me == 0) LAMMPS_NS::utils::sfread(FLERR, &value, sizeof value, 1, file, nullptr, lmp.error);
  MPI_Bcast(&value, sizeof value, MPI_BYTE, 0, lmp.world);
}

template <class T>
void write_one(const T& value, FILE* file) {
  std::fwrite(&value, sizeof value, 1, file);
}

}  // namespace

PairFractional::PairFractional(LAMMPS_NS::LAMMPS* lmp) : Pair(lmp), model_(lmp, "pair fractional") {
  single_enable = 1;
  restartinfo = 1;
  finitecutflag = 1;
  no_virial_fdotr_compute = 1;
  nextra = 2;
  pvector = new double[2]{};
  LAMMPS_NS::utils::logmesg(
      lmp, std::string("pair fractional: frictionless normal contacts; friction, rolling and mesh walls come with the "
                       "LAMMPS of 2025 (docs/lammps.md)\n"));
}

PairFractional::~PairFractional() {
  delete[] pvector;
  if (contacts_) modify->delete_fix(contacts_id);
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

void PairFractional::allocate() {
  allocated = 1;
  types_ = atom->ntypes;
  memory->create(setflag, types_ + 1, types_ + 1, "pair:setflag");
  memory->create(cutsq, types_ + 1, types_ + 1, "pair:cutsq");
  for (int i = 1; i <= types_; ++i) std::fill_n(setflag[i], types_ + 1, 0);
  laws_.assign(static_cast<std::size_t>(types_) * types_, {});
}

void PairFractional::settings(int narg, char** arg) {
  model_.settings() = {};
  model_.read_settings({arg, static_cast<std::size_t>(narg)});
}

void PairFractional::coeff(int narg, char** arg) {
  if (narg != 2 + GivenLaw::words) model_.refuse("pair_coeff: must be I J K C ALPHA or I J target T_COL E_N");
  if (!allocated) allocate();
  int ilow = 0, ihigh = 0, jlow = 0, jhigh = 0;
  LAMMPS_NS::utils::bounds(FLERR, arg[0], 1, types_, ilow, ihigh, error);
  LAMMPS_NS::utils::bounds(FLERR, arg[1], 1, types_, jlow, jhigh, error);
  const GivenLaw law = GivenLaw::read({arg + 2, GivenLaw::words}, lmp);
  for (int i = ilow; i <= ihigh; ++i)
    for (int j = std::max(jlow, i); j <= jhigh; ++j) {
      setflag[i][j] = 1;
      laws_[kind(i, j)] = laws_[kind(j, i)] = law;
    }
}

void PairFractional::init_style() {
  model_.check_deck();
  if (force->pair != this) model_.refuse("pair_style hybrid is not known to it: must be the only pair style");
  for (int i = 1; i <= types_; ++i)
    for (int j = i; j <= types_; ++j)
      if (setflag[i][j] == 0) model_.refuse(fmt::format("pair_coeff {} {} is missing: laws are not mixed", i, j));
  claim_contacts();
  neighbor->request(this, instance_me);
  frozen_ = 0;
  for (int i = 0; i < modify->nfix; ++i)
    if (std::string(modify->fix[i]->style) == "freeze") frozen_ |= modify->fix[i]->groupbit;
  radius_max_ = greatest_radii();
  model_.begin_run(laws_);
  look_at_present_grains();
}

void PairFractional::claim_contacts() {
  if (contacts_) return;
  if (modify->find_fix(contacts_id) >= 0) model_.refuse("only one pair style fractional at a time");
  contacts_ =
      static_cast<PairContacts*>(modify->add_fix(fmt::format("{} all {}", contacts_id, PairContacts::style_name)));
}

// Of grains that are there on any rank and those that a fix will bring.
std::vector<double> PairFractional::greatest_radii() const {
  std::vector<double> here(types_ + 1, 0), all(types_ + 1, 0);
  for (int i = 0; i < atom->nlocal; ++i) here[atom->type[i]] = std::max(here[atom->type[i]], atom->radius[i]);
  MPI_Allreduce(here.data(), all.data(), types_ + 1, MPI_DOUBLE, MPI_MAX, world);
  for (int n = 0; n < modify->nfix; ++n) {
    const std::string style = modify->fix[n]->style;
    if (style != "pour" && style != "deposit") continue;
    for (int type = 1; type <= types_; ++type) {
      int asked = type;
      if (const void* radius = modify->fix[n]->extract("radius", asked))
        all[type] = std::max(all[type], *static_cast<const double*>(radius));
    }
  }
  return all;
}

void PairFractional::look_at_present_grains() {
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> here(types_ + 1, none), all(types_ + 1, none);
  for (int i = 0; i < atom->nlocal; ++i) here[atom->type[i]] = std::min(here[atom->type[i]], atom->rmass[i]);
  MPI_Allreduce(here.data(), all.data(), types_ + 1, MPI_DOUBLE, MPI_MIN, world);
  for (int i = 1; i <= types_; ++i)
    for (int j = i; j <= types_; ++j)
      if (all[i] < none && all[j] < none) model_.look_ahead(kind(i, j), all[i] * all[j] / (all[i] + all[j]));
}

double PairFractional::init_one(int i, int j) { return radius_max_[i] + radius_max_[j]; }

// A grain that is held has no mass of its own in a collision.
double PairFractional::mass_eff(int i, int j) const {
  const double a = atom->rmass[i], b = atom->rmass[j];
  if ((atom->mask[i] & frozen_) != 0) return b;
  if ((atom->mask[j] & frozen_) != 0) return a;
  return a * b / (a + b);
}

void PairFractional::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  model_.begin_step();
  const double* const* const x = atom->x;
  const double* const radius = atom->radius;
  for (int n = 0; n < list->inum; ++n) {
    const int i = list->ilist[n], count = list->numneigh[i];
    const int* const neighbours = list->firstneigh[i];
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2], ri = radius[i];
    for (int m = 0; m < count; ++m) {
      const int j = neighbours[m] & NEIGHMASK;
      const double apart[3] = {xi - x[j][0], yi - x[j][1], zi - x[j][2]};
      const double rsq = apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2];
      const double reach = ri + radius[j];
      if (rsq < reach * reach) pass(i, j, apart, rsq);
    }
  }
  pvector[0] = model_.energies().stored;
  pvector[1] = model_.energies().lost;
}

// With newton off a pair of two ranks is stepped by both, with the same numbers; one within a rank once.
void PairFractional::pass(int i, int j, const double* apart, double rsq) {
  const LAMMPS_NS::Atom& grains = *atom;
  const double r = std::sqrt(rsq);
  const double *vi = grains.v[i], *vj = grains.v[j], ri = grains.radius[i], rj = grains.radius[j];
  const double parting = ((vi[0] - vj[0]) * apart[0] + (vi[1] - vj[1]) * apart[1] + (vi[2] - vj[2]) * apart[2]) / r;
  const bool own = j < grains.nlocal;
  auto& history = contacts_->at(i, grains.tag[j]);
  const double force = model_.force(
      {kind(grains.type[i], grains.type[j]), mass_eff(i, j), ri + rj - r, -parting, std::min(ri, rj), own ? 1 : 0.5},
      history);
  if (own) contacts_->stepped(i, j);
  const double over_r = force / r;
  double *fi = grains.f[i], *fj = grains.f[j];
  for (int d = 0; d < 3; ++d) {
    fi[d] += over_r * apart[d];
    if (own) fj[d] -= over_r * apart[d];
  }
  if (evflag != 0) ev_tally(i, j, grains.nlocal, 0, 0, 0, over_r, apart[0], apart[1], apart[2]);
}

double PairFractional::single(int i, int j, int itype, int jtype, double rsq, double, double, double& force_over_r) {
  const auto* history = contacts_->find_pair(i, j);
  force_over_r = history ? model_.last_force(kind(itype, jtype), mass_eff(i, j), *history) / std::sqrt(rsq) : 0;
  return 0;
}

void PairFractional::write_restart(FILE* file) {
  write_restart_settings(file);
  for (int i = 1; i <= types_; ++i)
    for (int j = i; j <= types_; ++j) {
      write_one(setflag[i][j], file);
      write_one(laws_[kind(i, j)], file);
    }
}

void PairFractional::read_restart(FILE* file) {
  read_restart_settings(file);
  allocate();
  for (int i = 1; i <= types_; ++i)
    for (int j = i; j <= types_; ++j) {
      read_for_all(setflag[i][j], file, *lmp);
      read_for_all(laws_[kind(i, j)], file, *lmp);
      laws_[kind(j, i)] = laws_[kind(i, j)];
    }
}

void PairFractional::write_restart_settings(FILE* file) {
  write_one(model_.settings(), file);
  write_one(model_.kernel_step(), file);
}

void PairFractional::read_restart_settings(FILE* file) {
  read_for_all(model_.settings(), file, *lmp);
  read_for_all(model_.kernel_step(), file, *lmp);
}

}  // namespace ricochet::lammps
