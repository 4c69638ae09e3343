// The fractional interaction law as a LIGGGHTS normal model, `pair_style gran model fractional …`. LIGGGHTS includes
// this file once for its name and identifier and once for the class, hence the guards of its own convention.
#ifdef NORMAL_MODEL

NORMAL_MODEL(FRACTIONAL, fractional, 20)

#else

#ifndef RICOCHET_NORMAL_MODEL_FRACTIONAL_H
#define RICOCHET_NORMAL_MODEL_FRACTIONAL_H

#include "contact_models.h"
#include "energy_tally.hpp"
#include "normal_model_base.h"
#include "pair_law.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace LIGGGHTS::ContactModels {

template <>
class NormalModel<FRACTIONAL> : public NormalModelBase {
 public:
  NormalModel(LAMMPS* lmp, IContactHistorySetup* history, ContactModelBase* owner);

  void registerSettings(Settings& settings);
  void postSettings(IContactHistorySetup*, ContactModelBase*);
  void connectToProperties(PropertyRegistry& registry);
  double stressStrainExponent() { return 1; }

  void surfacesIntersect(SurfacesIntersectData& pair, ForceData& on_i, ForceData& on_j);
  void surfacesClose(SurfacesCloseData& pair, ForceData&, ForceData&);
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&);
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}

 private:
  void read_properties();
  ricochet::liggghts::PairLaw read_pair(int i, int j, const ricochet::liggghts::ContactFor& contact_for) const;
  const ricochet::liggghts::PairLaw& law_of(int itype, int jtype) const { return laws_[itype * types_ + jtype]; }
  void advance(SurfacesIntersectData& pair, double* history, const ricochet::liggghts::PairLaw& law);

  bool is_wall_;
  bool kt_to_kn_ = false, tangential_damping_ = true, track_energy_ = false;
  int history_offset_;

  double **tcol_ = nullptr, **en_ = nullptr;                  // the one set of properties, or
  double **k_ = nullptr, **c_ = nullptr, **alpha_ = nullptr;  // the other
  double memory_time_ = 0;

  int types_ = 0;
  double kernel_step_ = 0;  // the time step that the arms were chosen for
  std::map<std::pair<double, double>, ricochet::liggghts::HalfStepContact> contacts_;  // by α and memory
  std::vector<ricochet::liggghts::PairLaw> laws_;
  std::unique_ptr<ricochet::liggghts::EnergyTally> tally_;
};

}  // namespace LIGGGHTS::ContactModels

#endif
#endif
