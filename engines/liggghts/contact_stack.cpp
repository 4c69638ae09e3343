#include "contact_stack.hpp"

#include <utility>

namespace ricochet::liggghts {

using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

namespace {

// LIGGGHTS's model bases have no virtual destructor: the deleter must know the class that was made.
template <class Base>
using Model = std::shared_ptr<Base>;

// The field of a combination's code, six bits each: normal, tangential, cohesion, rolling, surface.
int field(std::int64_t code, int index) { return static_cast<int>((code >> (6 * index)) & 63); }

// Makes Family<id> for the one of Ids… that equals `id`; unknown ones were never registered.
template <class Base, template <int> class Family, int... Ids, class... Arguments>
Model<Base> choose(int id, Arguments... arguments) {
  Model<Base> made;
  ((id == Ids ? void(made = std::make_shared<Family<Ids>>(arguments...)) : void()), ...);
  return made;
}

}  // namespace

ContactStack::ContactStack(LAMMPS* lmp, IContactHistorySetup* history, bool is_wall, std::int64_t code)
    : ContactModelBase(lmp, is_wall),
      code_(code),
      surface_(lmp, history, this),
      normal_(
          choose<NormalModelBase, NormalModel, FRACTIONAL, FRACTIONAL_KELVIN_VOIGT, FRACTIONAL_HERTZ, FRACTIONAL_ZENER>(
              field(code, 0), lmp, history, this)),
      cohesion_(choose<CohesionModelBase, CohesionModel, COHESION_OFF, COHESION_SJKR, COHESION_SJKR2,
                       COHESION_EASO_CAPILLARY_VISCOUS, COHESION_WASHINO_CAPILLARY_VISCOUS>(field(code, 2), lmp,
                                                                                            history, this)),
      tangential_(
          choose<TangentialModelBase, TangentialModel, TANGENTIAL_OFF, TANGENTIAL_NO_HISTORY, TANGENTIAL_HISTORY>(
              field(code, 1), lmp, history, this)),
      rolling_(
          choose<RollingModelBase, RollingModel, ROLLING_OFF, ROLLING_CDT, ROLLING_EPSD, ROLLING_EPSD2, ROLLING_EPSD3>(
              field(code, 3), lmp, history, this)) {}

void ContactStack::registerSettings(Settings& settings) {
  surface_.registerSettings(settings);
  normal_->registerSettings(settings);
  cohesion_->registerSettings(settings);
  tangential_->registerSettings(settings);
  rolling_->registerSettings(settings);
}

void ContactStack::postSettings(IContactHistorySetup* history) {
  surface_.postSettings(history, this);
  normal_->postSettings(history, this);
  cohesion_->postSettings(history, this);
  tangential_->postSettings(history, this);
  rolling_->postSettings(history, this);
}

void ContactStack::connectToProperties(PropertyRegistry& registry) {
  surface_.connectToProperties(registry);
  normal_->connectToProperties(registry);
  cohesion_->connectToProperties(registry);
  tangential_->connectToProperties(registry);
  rolling_->connectToProperties(registry);
}

bool ContactStack::contact_match(const std::string& kind, const std::string& model) const {
  auto& known = ContactModels::Factory::instance();
  if (kind == "surface") return field(code_, 4) == known.getSurfaceModelId(model);
  if (kind == "normal") return field(code_, 0) == known.getNormalModelId(model);
  if (kind == "cohesion") return field(code_, 2) == known.getCohesionModelId(model);
  if (kind == "tangential") return field(code_, 1) == known.getTangentialModelId(model);
  if (kind == "rolling_friction") return field(code_, 3) == known.getRollingModelId(model);
  return false;
}

}  // namespace ricochet::liggghts
