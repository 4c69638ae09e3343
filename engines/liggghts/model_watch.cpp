#include "model_watch.hpp"

#include "liggghts_headers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::liggghts {

void ModelWatch::begin_run(int types) {
  const LAMMPS_NS::Update& update = *lmp_->update;
  run_.begin_run(static_cast<std::size_t>(types) * types, update.ntimestep, update.laststep);
}

void ModelWatch::check_kernel(double chosen_for) const {
  const auto remark = half_step::RunWatch::look_at_kernel(chosen_for, lmp_->update->dt);
  if (remark && lmp_->comm->me == 0) warn(remark->text);
}

void ModelWatch::check_step(int at, double mass_eff, double tcol, bool on_all_ranks) {
  const auto remark = run_.look_at_step(at, mass_eff, tcol, lmp_->update->dt);
  if (!remark) return;
  if (!remark->refuses) {
    if (!on_all_ranks || lmp_->comm->me == 0) warn(remark->text);
    return;
  }
  const std::string text = fmt::format("{}: {}", model_, remark->text);
  if (on_all_ranks) lmp_->error->all(FLERR, text.c_str());
  lmp_->error->one(FLERR, text.c_str());
}

void ModelWatch::check_overlap(const LIGGGHTS::ContactModels::SurfacesIntersectData& pair) {
  const double radius = pair.is_wall ? pair.radi : std::min(pair.radi, pair.radj);
  if (run_.is_soft(pair.deltan, radius)) warn(run_.soft(pair.deltan, radius).text);
}

void ModelWatch::check_memory() {
  if (const auto remark = run_.look_at_memory(lmp_->update->ntimestep)) warn(remark->text);
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
