#pragma once

#include "contact_models.h"
#include "energy_tally.hpp"
#include "model_watch.hpp"
#include "normal_model_base.h"
#include "pair_law.hpp"

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ricochet::liggghts {

using half_step::ContactFor;
using half_step::ContactHistory;
using half_step::LocatedContact;
using half_step::PairLaw;

/// A law with a fractional memory as a normal model of LIGGGHTS: reads the properties of the deck, keeps a PairLaw of
/// every two types, and drives each contact by its LocatedContact.
template <class Law>
class RememberingModel : public LIGGGHTS::ContactModels::NormalModelBase {
 public:
  using Settings = ::Settings;
  using PropertyRegistry = ::PropertyRegistry;
  using Intersection = LIGGGHTS::ContactModels::SurfacesIntersectData;
  using Nearness = LIGGGHTS::ContactModels::SurfacesCloseData;
  using Forces = LIGGGHTS::ContactModels::ForceData;

  RememberingModel(LAMMPS_NS::LAMMPS* lmp, LIGGGHTS::IContactHistorySetup* history,
                   LIGGGHTS::ContactModels::ContactModelBase* owner);

  void registerSettings(Settings& settings) override;
  void postSettings(LIGGGHTS::IContactHistorySetup*, LIGGGHTS::ContactModels::ContactModelBase*) override;
  void connectToProperties(PropertyRegistry& registry) override;
  double stressStrainExponent() override { return std::is_same_v<Law, FractionalHertz> ? 1.5 : 1; }

  void surfacesIntersect(Intersection& pair, Forces& on_i, Forces& on_j) override;
  void surfacesClose(Nearness& pair, Forces&, Forces&) override;
  void beginPass(Intersection&, Forces&, Forces&) override;
  void endPass(Intersection&, Forces&, Forces&) override {}

 private:
  void connect_target(PropertyRegistry& registry);
  void connect_parameters(PropertyRegistry& registry);
  void connect_tangential(PropertyRegistry& registry);
  void connect_scalar(PropertyRegistry& registry, const std::string& name,
                      ::ScalarProperty* (*make)(PropertyRegistry&, const char*, bool), double& value);
  void read_properties();
  PairLaw<Law> read_pair(int i, int j, const ContactFor<Law>& contact_for) const;
  void check_steps_of_present_grains();
  int at(int itype, int jtype) const { return itype * types_ + jtype; }
  void advance(Intersection& pair, double* history, const PairLaw<Law>& law);
  /// Stiffness and damping that tangential, rolling and cohesion models scale theirs by.
  void prepare_other_models(Intersection& pair, const PairLaw<Law>& law) const;

  bool is_wall_;
  bool kt_to_kn_ = false, tangential_damping_ = true, track_energy_ = false;
  int history_offset_;

  double **tcol_ = nullptr, **en_ = nullptr, **alpha_ = nullptr, **stiffening_ = nullptr;  // the one set, or
  std::array<double**, Law::parameters.size()> parameters_{};                              // the other
  double **kt_ = nullptr, **gammat_ = nullptr;  // in the tangent plane, where the deck gives them
  double memory_time_ = 0;
  double velocity_ = std::is_same_v<Law, FractionalHertz> ? 0 : 1;  // of the others any is the same

  int types_ = 0;
  double kernel_step_ = 0;  // the time step that the arms were chosen for
  std::map<std::pair<ParameterValues<Law>, double>, LocatedContact<Law>> contacts_;  // by law and memory
  std::vector<PairLaw<Law>> laws_;
  std::unique_ptr<EnergyTally> tally_;
  ModelWatch watch_;
};

}  // namespace ricochet::liggghts
