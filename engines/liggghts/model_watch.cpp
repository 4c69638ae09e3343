#include "model_watch.hpp"

#include "liggghts_headers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::liggghts {

void ModelWatch::begin_run(int types) {
  lightest_.assign(static_cast<std::size_t>(types) * types, std::numeric_limits<double>::infinity());
  was_reset_ = next_start_ >= 0 && lmp_->update->ntimestep != next_start_;
  next_start_ = lmp_->update->laststep;
  coarse_said_ = soft_said_ = false;
}

void ModelWatch::check_step(int at, double mass_eff, double tcol, bool on_all_ranks) {
  lightest_[at] = mass_eff;
  const double dt = lmp_->update->dt, steps = tcol / dt;
  if (steps < least_steps) {
    const std::string text = fmt::format(
        "{}: timestep = {:.6g}: must be at most 1/{} of the shortest collision time, {:.6g} (1/{} is advised)", model_,
        dt, least_steps, tcol, advised_steps);
    if (on_all_ranks) lmp_->error->all(FLERR, text.c_str());
    lmp_->error->one(FLERR, text.c_str());
  }
  if (steps >= advised_steps || coarse_said_) return;
  coarse_said_ = true;
  if (on_all_ranks && lmp_->comm->me != 0) return;
  warn(fmt::format("timestep = {:.6g} leaves {:.3g} steps to the shortest collision time, {:.6g}; {} are advised", dt,
                   steps, tcol, advised_steps));
}

void ModelWatch::check_overlap(const LIGGGHTS::ContactModels::SurfacesIntersectData& pair) {
  const double radius = pair.is_wall ? pair.radi : std::min(pair.radi, pair.radj);
  if (soft_said_ || !(pair.deltan > soft_overlap * radius)) return;
  soft_said_ = true;
  warn(
      fmt::format("an overlap of {:.3g} % of the smaller radius: the contact is too soft for this load (of one "
                  "collisionTime the stiffness falls with the mass: small grains need a shorter one)",
                  100 * pair.deltan / radius));
}

// Later on it may be that of grains that have been apart.
void ModelWatch::say_forgotten() {
  was_reset_ = false;
  if (lmp_->update->ntimestep != lmp_->update->firststep) return;
  warn("reset_timestep while grains touch: their contacts have lost their memory and start anew");
}

void ModelWatch::warn(const std::string& text) const {
  lmp_->error->warning(FLERR, fmt::format("{}: {}", model_, text).c_str());
}

std::vector<double> lightest_pairs(const LAMMPS_NS::LAMMPS& lmp, int types) {
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> here(types, none), lightest(types, none), pairs;
  const LAMMPS_NS::Atom& atom = *lmp.atom;
  for (int i = 0; atom.rmass && i < atom.nlocal; ++i) here[atom.type[i]] = std::min(here[atom.type[i]], atom.rmass[i]);
  MPI_Allreduce(here.data(), lightest.data(), types, MPI_DOUBLE, MPI_MIN, lmp.world);
  pairs.reserve(lightest.size() * lightest.size());
  for (const double a : lightest)
    for (const double b : lightest) pairs.push_back(a < none && b < none ? a * b / (a + b) : none);
  return pairs;
}

}  // namespace ricochet::liggghts
