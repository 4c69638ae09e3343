#include "model_watch.hpp"

#include "liggghts_headers.hpp"

#include <run_advice.hpp>

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
  if (steps < half_step::least_steps) {
    const std::string text = fmt::format("{}: {}", model_, half_step::too_coarse(dt, tcol));
    if (on_all_ranks) lmp_->error->all(FLERR, text.c_str());
    lmp_->error->one(FLERR, text.c_str());
  }
  if (steps >= half_step::advised_steps || coarse_said_) return;
  coarse_said_ = true;
  if (on_all_ranks && lmp_->comm->me != 0) return;
  warn(half_step::coarse(dt, tcol));
}

void ModelWatch::check_overlap(const LIGGGHTS::ContactModels::SurfacesIntersectData& pair) {
  const double radius = pair.is_wall ? pair.radi : std::min(pair.radi, pair.radj);
  if (soft_said_ || !(pair.deltan > half_step::soft_overlap * radius)) return;
  soft_said_ = true;
  warn(half_step::too_soft(pair.deltan / radius, "collisionTime"));
}

// Later on it may be that of grains that have been apart.
void ModelWatch::say_forgotten() {
  was_reset_ = false;
  if (lmp_->update->ntimestep != lmp_->update->firststep) return;
  warn(half_step::forgotten);
}

void ModelWatch::warn(std::string_view text) const {
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
