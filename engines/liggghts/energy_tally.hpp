#pragma once

namespace LAMMPS_NS {
class LAMMPS;
class FixPropertyAtom;
}  // namespace LAMMPS_NS

namespace LIGGGHTS::ContactModels {
struct SurfacesIntersectData;
}

namespace ricochet::liggghts {

/// Normal contact energies by grain, for an energy balance: `fix property/atom` scalars f_fractionalStored (held by
/// the contacts' springs now) and f_fractionalDissipated (lost since the start), in energy units; a grain carries half
/// of a pair's and all of a wall contact's. Pair and walls share them; restart files keep them.
class EnergyTally {
 public:
  explicit EnergyTally(LAMMPS_NS::LAMMPS* lmp);

  void clear_stored();
  void add(const LIGGGHTS::ContactModels::SurfacesIntersectData& pair, double stored, double dissipated);

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  LAMMPS_NS::FixPropertyAtom* stored_;
  LAMMPS_NS::FixPropertyAtom* dissipated_;
};

}  // namespace ricochet::liggghts
