// The laws with a fractional memory as LIGGGHTS normal models, `pair_style gran model fractional …`. LIGGGHTS includes
// this file once for their names and identifiers and once for the classes, hence the guards of its own convention.
#ifdef NORMAL_MODEL

NORMAL_MODEL(FRACTIONAL, fractional, 20)
NORMAL_MODEL(FRACTIONAL_KELVIN_VOIGT, fractional - kelvin - voigt, 21)
NORMAL_MODEL(FRACTIONAL_HERTZ, fractional - hertz, 22)
NORMAL_MODEL(FRACTIONAL_ZENER, fractional - zener, 23)

#else

#ifndef RICOCHET_NORMAL_MODEL_FRACTIONAL_H
#define RICOCHET_NORMAL_MODEL_FRACTIONAL_H

#include "contact_models.h"
#include "normal_model_base.h"
#include "remembering_model.hpp"

namespace LIGGGHTS::ContactModels {

template <>
class NormalModel<FRACTIONAL> : public ricochet::liggghts::RememberingModel<ricochet::Fractional> {
 public:
  using RememberingModel::RememberingModel;
};

template <>
class NormalModel<FRACTIONAL_KELVIN_VOIGT>
    : public ricochet::liggghts::RememberingModel<ricochet::FractionalKelvinVoigt> {
 public:
  using RememberingModel::RememberingModel;
};

template <>
class NormalModel<FRACTIONAL_HERTZ> : public ricochet::liggghts::RememberingModel<ricochet::FractionalHertz> {
 public:
  using RememberingModel::RememberingModel;
};

template <>
class NormalModel<FRACTIONAL_ZENER> : public ricochet::liggghts::RememberingModel<ricochet::FractionalZener> {
 public:
  using RememberingModel::RememberingModel;
};

}  // namespace LIGGGHTS::ContactModels

#endif
#endif
