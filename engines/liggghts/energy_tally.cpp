#include "energy_tally.hpp"

#include "liggghts_headers.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace ricochet::liggghts {

namespace {

LAMMPS_NS::FixPropertyAtom* shared_scalar(LAMMPS_NS::Modify& modify, const std::string& name) {
  using LAMMPS_NS::FixPropertyAtom;
  if (auto* found = modify.find_fix_property(name.c_str(), "property/atom", "scalar", 0, 0, "trackEnergy", false))
    return static_cast<FixPropertyAtom*>(found);
  std::array<std::string, 9> words{name, "all", "property/atom", name, "scalar", "yes", "no", "no", "0.0"};
  std::array<char*, 9> arguments;
  std::transform(words.begin(), words.end(), arguments.begin(), [](std::string& word) { return word.data(); });
  return modify.add_fix_property_atom(static_cast<int>(arguments.size()), arguments.data(), "trackEnergy");
}

}  // namespace

EnergyTally::EnergyTally(LAMMPS_NS::LAMMPS* lmp)
    : lmp_(lmp),
      stored_(shared_scalar(*lmp->modify, "fractionalStored")),
      dissipated_(shared_scalar(*lmp->modify, "fractionalDissipated")) {}

void EnergyTally::clear_stored() { std::fill_n(stored_->vector_atom, lmp_->atom->nlocal, 0.0); }

void EnergyTally::add(const LIGGGHTS::ContactModels::SurfacesIntersectData& pair, double stored, double dissipated) {
  const double share = pair.is_wall ? 1 : 0.5;
  stored_->vector_atom[pair.i] += share * stored;
  dissipated_->vector_atom[pair.i] += share * dissipated;
  if (pair.is_wall || pair.j >= lmp_->atom->nlocal) return;  // the rank that owns a ghost adds its half
  stored_->vector_atom[pair.j] += share * stored;
  dissipated_->vector_atom[pair.j] += share * dissipated;
}

}  // namespace ricochet::liggghts
