#include "fractional_styles.hpp"

#include "contact_stack.hpp"

#include <initializer_list>
#include <string>

namespace ricochet::liggghts {

namespace {

using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

template <class Stack>
PairStyles::IGranularPairStyle* make_pair(LAMMPS* lmp, PairGran* parent, int64_t code) {
  return new PairStyles::Granular<Stack>(lmp, parent, code);
}

template <class Stack>
Walls::IGranularWall* make_wall(LAMMPS* lmp, FixWallGran* parent, int64_t code) {
  return new Walls::Granular<Stack>(lmp, parent, code);
}

void register_combinations(const std::string& name, int normal) {
  ContactModels::Factory::instance().addNormalModel(name, normal);
  for (int tangential : {TANGENTIAL_OFF, TANGENTIAL_NO_HISTORY, TANGENTIAL_HISTORY})
    for (int cohesion : {COHESION_OFF, COHESION_SJKR, COHESION_SJKR2, COHESION_EASO_CAPILLARY_VISCOUS,
                         COHESION_WASHINO_CAPILLARY_VISCOUS})
      for (int rolling : {ROLLING_OFF, ROLLING_CDT, ROLLING_EPSD, ROLLING_EPSD2, ROLLING_EPSD3}) {
        const auto code = Utils::generate_gran_hashcode(normal, tangential, cohesion, rolling, SURFACE_DEFAULT);
        PairStyles::Factory::instance().addStyle("gran", static_cast<int>(code), &make_pair<ContactStack>);
        Walls::Factory::instance().addStyle("gran", static_cast<int>(code), &make_wall<ContactStack>);
      }
}

}  // namespace

void register_fractional_styles() {
  register_combinations(std::string(Fractional::name), FRACTIONAL);
  register_combinations(std::string(FractionalKelvinVoigt::name), FRACTIONAL_KELVIN_VOIGT);
  register_combinations(std::string(FractionalHertz::name), FRACTIONAL_HERTZ);
  register_combinations(std::string(FractionalZener::name), FRACTIONAL_ZENER);
}

}  // namespace ricochet::liggghts
