#include "liggghts_headers.hpp"
#include "remembering_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace ricochet::liggghts {

using namespace LIGGGHTS;

namespace {

constexpr half_step::TargetNames target_names{"collisionTime", "coefficientRestitution", "fractionalAlpha"};

/// `fractionalK` of the parameter k.
std::string property_name(std::string_view parameter) {
  std::string name = fmt::format("fractional{}", parameter);
  char& initial = name[name.size() - parameter.size()];
  initial = static_cast<char>(std::toupper(initial));
  return name;
}

template <class Law>
std::string model_name() {
  return fmt::format("model {}", Law::name);
}

// The registry wants a plain function for each property, and hands it no name.
MatrixProperty* collision_time(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "collisionTime", who);
}
MatrixProperty* restitution(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "coefficientRestitution", who);
}
MatrixProperty* degree(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "fractionalAlpha", who);
}
MatrixProperty* stiffening(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "fractionalStiffening", who);
}
ScalarProperty* memory_time(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, "memoryTime", who);
}
ScalarProperty* velocity(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, "characteristicVelocity", who);
}
template <class Law, std::size_t I>
MatrixProperty* parameter(PropertyRegistry& registry, const char* who, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, property_name(Law::parameters[I].name).c_str(), who);
}

bool has_property(LAMMPS_NS::Modify& modify, const std::string& name, const char* kind) {
  return modify.find_fix_property(name.c_str(), "property/global", kind, 0, 0, "a fractional model", false) != nullptr;
}
bool has_matrix(LAMMPS_NS::Modify& modify, const std::string& name) {
  return has_property(modify, name, "peratomtypepair");
}

template <class Law>
std::string parameter_names() {
  std::string names;
  for (std::size_t i = 0; i < Law::parameters.size(); ++i)
    names += (i == 0 ? "" : i + 1 < Law::parameters.size() ? ", " : " and ") + property_name(Law::parameters[i].name);
  return names;
}

template <class Law>
constexpr bool knows_velocity = std::is_same_v<Law, FractionalHertz>;

}  // namespace

template <class Law>
RememberingModel<Law>::RememberingModel(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* history,
                                        ContactModels::ContactModelBase* owner)
    : NormalModelBase(lmp, history, owner), is_wall_(owner->is_wall()), watch_(lmp, model_name<Law>()) {
  history_offset_ = history->add_history_value("fractional_0", "0");
  for (std::size_t i = 1; i < ContactHistory::size; ++i)
    history->add_history_value("fractional_" + std::to_string(i), "0");
}

template <class Law>
void RememberingModel<Law>::registerSettings(Settings& settings) {
  settings.registerOnOff("ktToKnUser", kt_to_kn_);
  settings.registerOnOff("tangential_damping", tangential_damping_, true);
  settings.registerOnOff("trackEnergy", track_energy_);
}

template <class Law>
void RememberingModel<Law>::postSettings(IContactHistorySetup*, ContactModels::ContactModelBase*) {
  if (track_energy_) tally_ = std::make_unique<EnergyTally>(lmp);
}

template <class Law>
void RememberingModel<Law>::connectToProperties(PropertyRegistry& registry) {
  const std::string who = model_name<Law>();
  if (force->cg_active()) error->cg(FLERR, who.c_str());
  const bool by_target = has_matrix(*modify, "collisionTime"), by_parameters = has_matrix(*modify, "fractionalK");
  if (by_target == by_parameters)
    error->all(FLERR, fmt::format("{} takes either collisionTime and coefficientRestitution or {} (fix "
                                  "property/global … peratomtypepair), {}",
                                  who, parameter_names<Law>(), by_target ? "not both" : "and finds neither")
                          .c_str());
  if (by_target)
    connect_target(registry);
  else
    connect_parameters(registry);
  connect_tangential(registry);
  connect_scalar(registry, "memoryTime", &memory_time, memory_time_);
  if constexpr (knows_velocity<Law>) {
    connect_scalar(registry, "characteristicVelocity", &velocity, velocity_);
    if (!(velocity_ > 0))
      error->all(FLERR, fmt::format("{}: characteristicVelocity = {}: a scalar > 0 is needed, the velocity of the "
                                    "impacts that are asked for",
                                    who, velocity_)
                            .c_str());
  }
  types_ = registry.max_type() + 1;
  read_properties();
  watch_.begin_run(types_);
  if (!is_wall_) check_steps_of_present_grains();
}

template <class Law>
void RememberingModel<Law>::connect_target(PropertyRegistry& registry) {
  const std::string who = model_name<Law>();
  registry.registerProperty("collisionTime", &collision_time);
  registry.registerProperty("fractionalRestitution", &restitution);
  registry.connect("collisionTime", tcol_, who.c_str());
  registry.connect("fractionalRestitution", en_, who.c_str());
  if (!HoldsDegree<Law>) return;
  if (has_matrix(*modify, "fractionalAlpha")) {
    registry.registerProperty("fractionalAlpha", &degree);
    registry.connect("fractionalAlpha", alpha_, who.c_str());
  }
  if (has_matrix(*modify, "fractionalStiffening")) {
    registry.registerProperty("fractionalStiffening", &stiffening);
    registry.connect("fractionalStiffening", stiffening_, who.c_str());
  }
}

template <class Law>
void RememberingModel<Law>::connect_parameters(PropertyRegistry& registry) {
  const std::string who = model_name<Law>();
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto one = [&](const std::string& name, MatrixProperty* (*make)(PropertyRegistry&, const char*, bool),
                         double**& values) {
      registry.registerProperty(name, make);
      registry.connect(name, values, who.c_str());
    };
    (one(property_name(Law::parameters[I].name), &parameter<Law, I>, parameters_[I]), ...);
  }
  (std::make_index_sequence<Law::parameters.size()>{});
}

/// Spring and dashpot in the tangent plane, under LIGGGHTS's own names for constant ones: where the deck has them, in
/// the place of those that follow from the linear contact.
template <class Law>
void RememberingModel<Law>::connect_tangential(PropertyRegistry& registry) {
  const std::string who = model_name<Law>();
  if (has_matrix(*modify, "kt")) {
    if (kt_to_kn_)
      error->all(FLERR,
                 fmt::format("{} takes either kt (fix property/global) or ktToKnUser on, not both", who).c_str());
    registry.registerProperty("kt", &MODEL_PARAMS::createKt);
    registry.connect("kt", kt_, who.c_str());
  }
  if (has_matrix(*modify, "gammat_abs")) {
    registry.registerProperty("gammat_abs", &MODEL_PARAMS::createGammatAbs);
    registry.connect("gammat_abs", gammat_, who.c_str());
  }
}

/// Leaves `value` as it is where the deck has none. Under a name of ours: LIGGGHTS's own creators limit some.
template <class Law>
void RememberingModel<Law>::connect_scalar(PropertyRegistry& registry, const std::string& name,
                                           ScalarProperty* (*make)(PropertyRegistry&, const char*, bool),
                                           double& value) {
  if (!has_property(*modify, name, "scalar")) return;
  registry.registerProperty("fractional_" + name, make);
  registry.connect("fractional_" + name, value, model_name<Law>().c_str());
}

// The arms are chosen once, for the first run's time step, so that what the contacts remember keeps its meaning when a
// later run takes another step.
template <class Law>
void RememberingModel<Law>::read_properties() {
  const std::string who = model_name<Law>();
  if (kernel_step_ == 0) kernel_step_ = update->dt;
  watch_.check_kernel(kernel_step_);
  const double memory = memory_time_ > 0 ? memory_time_ : half_step::default_memory_steps * kernel_step_;
  const auto contact_for = [&](const Law& law) -> const LocatedContact<Law>& {
    return contacts_.try_emplace({law.values(), memory}, law, kernel_step_, memory).first->second;
  };
  try {
    laws_.clear();
    for (int i = 0; i < types_; ++i)
      for (int j = 0; j < types_; ++j) laws_.push_back(read_pair(std::max(i, 1), std::max(j, 1), contact_for));
  } catch (const std::invalid_argument& misuse) {
    error->all(FLERR, fmt::format("{}: {}", who, misuse.what()).c_str());
  }
}

template <class Law>
PairLaw<Law> RememberingModel<Law>::read_pair(int i, int j, const ContactFor<Law>& contact_for) const {
  if (tcol_) {
    Held held;
    if (alpha_) held.alpha = alpha_[i][j];
    if (stiffening_) held.stiffening = stiffening_[i][j];
    return PairLaw<Law>::from_target(tcol_[i][j], en_[i][j], held, velocity_, contact_for, target_names);
  }
  ParameterValues<Law> values{};
  std::transform(parameters_.begin(), parameters_.end(), values.begin(), [&](double** p) { return p[i][j]; });
  return PairLaw<Law>::from_parameters(Law::from(values), velocity_, contact_for);
}

// Walls are of any type and grains may come later: those are looked at as they touch.
template <class Law>
void RememberingModel<Law>::check_steps_of_present_grains() {
  const std::vector<double> lightest = lightest_pairs(*lmp, types_);
  for (int i = 0; i < static_cast<int>(lightest.size()); ++i)
    if (watch_.is_lightest(i, lightest[i])) watch_.check_step(i, lightest[i], laws_[i].tcol(lightest[i]), true);
}

template <class Law>
void RememberingModel<Law>::beginPass(Intersection& pass, Forces&, Forces&) {
  if (tally_ && pass.computeflag && !is_wall_) tally_->clear_stored();
}

template <class Law>
void RememberingModel<Law>::surfacesIntersect(Intersection& pair, Forces& on_i, Forces& on_j) {
  if (pair.contact_flags) *pair.contact_flags |= ContactModels::CONTACT_NORMAL_MODEL;
  const int types = at(pair.itype, pair.jtype);
  const PairLaw<Law>& law = laws_[types];
  if (watch_.is_lightest(types, pair.meff)) watch_.check_step(types, pair.meff, law.tcol(pair.meff), false);
  watch_.check_overlap(pair);
  double* const history = pair.contact_history + history_offset_;
  if (pair.computeflag) advance(pair, history, law);

  const double touches = ContactHistory::is_at(history, update->ntimestep) ? 1 : 0;
  pair.Fn = touches * law.coefficient(pair.meff) * ContactHistory::repulsion(history);
  prepare_other_models(pair, law);

  const double magnitude = pair.is_wall ? pair.Fn * pair.area_ratio : pair.Fn;
  for (int d = 0; d < 3; ++d) {
    on_i.delta_F[d] += magnitude * pair.en[d];
    if (!pair.is_wall) on_j.delta_F[d] -= magnitude * pair.en[d];
  }
}

template <class Law>
void RememberingModel<Law>::prepare_other_models(Intersection& pair, const PairLaw<Law>& law) const {
  const auto linear = law.linear_equivalent(pair.meff);
  pair.kn = linear.stiffness;
  pair.gamman = linear.damping;
  pair.kt = kt_ ? kt_[pair.itype][pair.jtype] : kt_to_kn_ ? linear.stiffness * 2 / 7 : linear.stiffness;
  pair.gammat = !tangential_damping_ ? 0 : gammat_ ? gammat_[pair.itype][pair.jtype] : linear.damping;
}

// LIGGGHTS calls for forces several times at one step: when it sets a run up, with the velocities of the whole step
// and the history closed, and to list the contacts. The force is then the one found when the step was taken.
template <class Law>
void RememberingModel<Law>::advance(Intersection& pair, double* history, const PairLaw<Law>& law) {
  const LocatedContact<Law>& contact = law.contact();
  const double step = update->ntimestep;
  std::array<double, ContactHistory::size> before{};
  if (tally_) std::copy_n(history, before.size(), before.begin());
  const bool remembers = history[ContactHistory::stamp] != 0;
  if (remembers && !ContactHistory::continues(history, step) && !ContactHistory::is_at(history, step))
    watch_.check_memory();
  if (pair.shearupdate) contact.advance(history, step, pair.deltan, -pair.vn, update->dt);
  if (!tally_ || !ContactHistory::is_at(history, step)) return;
  const double scale = law.coefficient(pair.meff);
  const double lost = pair.shearupdate ? contact.dissipated_energy(before.data(), history, update->dt) : 0;
  tally_->add(pair, scale * contact.stored_energy(history), scale * lost);
}

template <class Law>
void RememberingModel<Law>::surfacesClose(Nearness& pair, Forces&, Forces&) {
  if (pair.contact_flags) *pair.contact_flags &= ~ContactModels::CONTACT_NORMAL_MODEL;
}

template class RememberingModel<Fractional>;
template class RememberingModel<FractionalKelvinVoigt>;
template class RememberingModel<FractionalHertz>;
template class RememberingModel<FractionalZener>;

}  // namespace ricochet::liggghts
