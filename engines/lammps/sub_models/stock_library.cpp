// What puts the sub-models into a LAMMPS library that was built without them. Its table of sub-models cannot be added
// to from outside; but it calls the two member functions defined here by its procedure linkage table and its table of
// virtual functions, where the program's definitions come first.

#include "stock_library.hpp"

#include "compute_fractional_energy.h"
#include "gran_sub_mod_fractional.h"
#include "granular_model.h"
#include "lammps.h"
#include "modify.h"
#include "pair_granular.h"

#include <dlfcn.h>

#include <algorithm>
#include <string>
#include <utility>

namespace ricochet::lammps {

namespace {

using namespace LAMMPS_NS;
using namespace LAMMPS_NS::Granular_NS;

template <class Model>
GranSubMod* make(GranularModel* gm, LAMMPS* lmp) {
  return new Model(gm, lmp);
}

using Maker = GranSubMod* (*)(GranularModel*, LAMMPS*);

/// Of one of our own; else none. The header's rows end as statements do.
Maker maker_of(const std::string& name, SubModelType type) {
#define GRAN_SUB_MOD_CLASS
#define GranSubModStyle(key, Class, kind) \
  if (type == (kind) && name == #key) return &make<Class>
#include "gran_sub_mod_fractional.h"
#undef GranSubModStyle
#undef GRAN_SUB_MOD_CLASS
  return nullptr;
}

/// The library's own.
void construct_stock(GranularModel* gm, std::string name, SubModelType type) {
  using Member = void (*)(GranularModel*, std::string, SubModelType);
  static const auto next = reinterpret_cast<Member>(
      dlsym(RTLD_NEXT,
            "_ZN9LAMMPS_NS11Granular_NS13GranularModel19construct_sub_modelENSt7__cxx1112basic_string"
            "IcSt11char_traitsIcESaIcEEENS0_12SubModelTypeE"));
  next(gm, std::move(name), type);
}

Compute* make_compute(LAMMPS* lmp, int narg, char** arg) { return new ComputeFractionalEnergy(lmp, narg, arg); }

}  // namespace

void add_compute(LAMMPS_NS::LAMMPS& lmp) { (*lmp.modify->compute_map)["fractional/energy"] = &make_compute; }

}  // namespace ricochet::lammps

namespace LAMMPS_NS {

void Granular_NS::GranularModel::construct_sub_model(std::string model_name, SubModelType model_type) {
  ricochet::lammps::add_compute(*lmp);
  const auto make = ricochet::lammps::maker_of(model_name, model_type);
  if (!make) return ricochet::lammps::construct_stock(this, std::move(model_name), model_type);
  GranSubMod*& model = sub_models[model_type];
  delete model;
  model = make(this, lmp);
  model->name = std::move(model_name);
  model->allocate_coeffs();
  if (model_type == NORMAL) normal_model = dynamic_cast<GranSubModNormal*>(model);
  if (model_type == DAMPING) damping_model = dynamic_cast<GranSubModDamping*>(model);
}

// The library's own copies as many numbers as the one model has, but they lie where the largest of each kind leaves
// room: of types with different normal models the tangential history is lost when a pair moves to another rank.
void PairGranular::transfer_history(double* source, double* target, int itype, int jtype) {
  const Granular_NS::GranularModel& model = *models_list[types_indices[itype][jtype]];
  std::fill_n(target, size_history, 0.0);
  for (const Granular_NS::GranSubMod* part : model.sub_models)
    for (int i = 0; i < part->size_history; ++i) {
      const double factor = part->nondefault_history_transfer ? part->transfer_history_factor[i] : -1;
      target[part->history_index + i] = factor * source[part->history_index + i];
    }
}

}  // namespace LAMMPS_NS
