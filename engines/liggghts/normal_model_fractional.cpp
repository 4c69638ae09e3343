#include "liggghts_headers.hpp"
#include "normal_model_fractional.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace LIGGGHTS::ContactModels {

using ricochet::liggghts::ContactFor;
using ricochet::liggghts::EnergyTally;
using ricochet::liggghts::HalfStepContact;
using ricochet::liggghts::PairLaw;

namespace {

constexpr const char* caller = "model fractional";
// A contact that lasts longer than this many steps is carried on by the kernel's spring, unless memoryTime says more.
constexpr double default_memory_steps = 1e3;

// The registry wants a plain function for each property, and hands it no name.
MatrixProperty* collision_time(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "collisionTime", who);
}
MatrixProperty* restitution(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "coefficientRestitution", who);
}
MatrixProperty* stiffness(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "fractionalK", who);
}
MatrixProperty* damping(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "fractionalC", who);
}
MatrixProperty* degree(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "fractionalAlpha", who);
}
ScalarProperty* memory_time(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, "memoryTime", who);
}

bool has_property(Modify& modify, const char* name, const char* kind) {
  return modify.find_fix_property(name, "property/global", kind, 0, 0, caller, false) != nullptr;
}

}  // namespace

NormalModel<FRACTIONAL>::NormalModel(LAMMPS* lmp, IContactHistorySetup* history, ContactModelBase* owner)
    : NormalModelBase(lmp, history, owner), is_wall_(owner->is_wall()) {
  history_offset_ = history->add_history_value("fractional_0", "0");
  for (std::size_t i = 1; i < HalfStepContact::size; ++i)
    history->add_history_value("fractional_" + std::to_string(i), "0");
}

void NormalModel<FRACTIONAL>::registerSettings(Settings& settings) {
  settings.registerOnOff("ktToKnUser", kt_to_kn_);
  settings.registerOnOff("tangential_damping", tangential_damping_, true);
  settings.registerOnOff("trackEnergy", track_energy_);
}

void NormalModel<FRACTIONAL>::postSettings(IContactHistorySetup*, ContactModelBase*) {
  if (track_energy_) tally_ = std::make_unique<EnergyTally>(lmp);
}

void NormalModel<FRACTIONAL>::connectToProperties(PropertyRegistry& registry) {
  if (force->cg_active()) error->cg(FLERR, caller);
  const bool by_target = has_property(*modify, "collisionTime", "peratomtypepair");
  if (by_target && has_property(*modify, "fractionalK", "peratomtypepair"))
    error->all(FLERR,
               "model fractional takes either collisionTime and coefficientRestitution or fractionalK, "
               "fractionalC and fractionalAlpha, not both");
  if (by_target) {
    registry.registerProperty("collisionTime", &collision_time);
    registry.registerProperty("fractionalRestitution", &restitution);
    registry.connect("collisionTime", tcol_, caller);
    registry.connect("fractionalRestitution", en_, caller);
  } else {
    registry.registerProperty("fractionalK", &stiffness);
    registry.registerProperty("fractionalC", &damping);
    registry.registerProperty("fractionalAlpha", &degree);
    registry.connect("fractionalK", k_, caller);
    registry.connect("fractionalC", c_, caller);
    registry.connect("fractionalAlpha", alpha_, caller);
  }
  if (has_property(*modify, "memoryTime", "scalar")) {
    registry.registerProperty("memoryTime", &memory_time);
    registry.connect("memoryTime", memory_time_, caller);
  }
  types_ = registry.max_type() + 1;
  read_properties();
}

// The arms are chosen once, for the first run's time step, so that what the contacts remember keeps its meaning when a
// later run takes another step.
void NormalModel<FRACTIONAL>::read_properties() {
  if (kernel_step_ == 0)
    kernel_step_ = update->dt;
  else if (kernel_step_ != update->dt && comm->me == 0)
    error->warning(FLERR, "model fractional keeps the memory kernel chosen for the first run's time step");
  const double memory = memory_time_ > 0 ? memory_time_ : default_memory_steps * kernel_step_;
  const auto contact_for = [&](double alpha) -> const HalfStepContact& {
    return contacts_.try_emplace({alpha, memory}, alpha, kernel_step_, memory).first->second;
  };
  try {
    laws_.clear();
    for (int i = 0; i < types_; ++i)
      for (int j = 0; j < types_; ++j) laws_.push_back(read_pair(std::max(i, 1), std::max(j, 1), contact_for));
  } catch (const std::invalid_argument& misuse) {
    error->all(FLERR, (std::string(caller) + ": " + misuse.what()).c_str());
  }
}

PairLaw NormalModel<FRACTIONAL>::read_pair(int i, int j, const ContactFor& contact_for) const {
  return tcol_ ? PairLaw::from_target(tcol_[i][j], en_[i][j], contact_for)
               : PairLaw::from_parameters(k_[i][j], c_[i][j], alpha_[i][j], contact_for);
}

void NormalModel<FRACTIONAL>::beginPass(SurfacesIntersectData& pass, ForceData&, ForceData&) {
  if (tally_ && pass.computeflag && !is_wall_) tally_->clear_stored();
}

void NormalModel<FRACTIONAL>::surfacesIntersect(SurfacesIntersectData& pair, ForceData& on_i, ForceData& on_j) {
  if (pair.contact_flags) *pair.contact_flags |= CONTACT_NORMAL_MODEL;
  const PairLaw& law = law_of(pair.itype, pair.jtype);
  double* const history = pair.contact_history + history_offset_;
  if (pair.computeflag) advance(pair, history, law);

  const double touches = HalfStepContact::is_at(history, update->ntimestep) ? 1 : 0;
  pair.Fn = touches * law.coefficient(pair.meff) * HalfStepContact::repulsion(history);
  const auto linear = law.linear_equivalent(pair.meff);
  pair.kn = linear.stiffness;
  pair.kt = kt_to_kn_ ? linear.stiffness * 2 / 7 : linear.stiffness;
  pair.gamman = linear.damping;
  pair.gammat = tangential_damping_ ? linear.damping : 0;

  const double magnitude = pair.is_wall ? pair.Fn * pair.area_ratio : pair.Fn;
  for (int d = 0; d < 3; ++d) {
    on_i.delta_F[d] += magnitude * pair.en[d];
    if (!pair.is_wall) on_j.delta_F[d] -= magnitude * pair.en[d];
  }
}

// LIGGGHTS calls for forces several times at one step: when it sets a run up, with the velocities of the whole step
// and the history closed, and to list the contacts. The force is then the one found when the step was taken.
void NormalModel<FRACTIONAL>::advance(SurfacesIntersectData& pair, double* history, const PairLaw& law) {
  const HalfStepContact& contact = law.contact();
  const double step = update->ntimestep;
  std::array<double, HalfStepContact::size> before{};
  if (tally_) std::copy_n(history, before.size(), before.begin());
  if (pair.shearupdate) contact.advance(history, step, pair.deltan, -pair.vn, update->dt);
  if (!tally_ || !HalfStepContact::is_at(history, step)) return;
  const double scale = law.coefficient(pair.meff);
  const double lost = pair.shearupdate ? contact.dissipated_energy(before.data(), history, update->dt) : 0;
  tally_->add(pair, scale * contact.stored_energy(history), scale * lost);
}

void NormalModel<FRACTIONAL>::surfacesClose(SurfacesCloseData& pair, ForceData&, ForceData&) {
  if (pair.contact_flags) *pair.contact_flags &= ~CONTACT_NORMAL_MODEL;
}

}  // namespace LIGGGHTS::ContactModels
