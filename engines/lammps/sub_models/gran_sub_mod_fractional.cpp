/* ----------------------------------------------------------------------
   Sub-models of pair granular: the laws with a fractional memory, of Ricochet.
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "gran_sub_mod_fractional.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "granular_model.h"
#include "update.h"

#include <ricochet/support/require.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>

using namespace LAMMPS_NS;
using namespace Granular_NS;

namespace half_step = ricochet::half_step;
using half_step::ContactHistory;
using half_step::LocatedContact;

namespace {

constexpr half_step::TargetNames target_names{"TCOL", "EN", "ALPHA"};

// Of fractional/hertz alone the speed of a collision sets how long it takes and what it loses.
template <class Law>
constexpr bool knows_velocity = std::is_same_v<Law, ricochet::FractionalHertz>;

std::string capitals(std::string_view name) {
  std::string word(name);
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
  return word;
}

// The arms of a law take a fit: pairs of types and walls that have the same law share them.
template <class Law>
const LocatedContact<Law>& contact_of(const Law& law, double dt, double memory) {
  static std::map<std::pair<ricochet::ParameterValues<Law>, std::pair<double, double>>, LocatedContact<Law>> known;
  return known.try_emplace({law.values(), {dt, memory}}, law, dt, memory).first->second;
}

}  // namespace

/* ----------------------------------------------------------------------
   What all laws and both forms do
------------------------------------------------------------------------- */

template <class Law>
GranSubModNormalOfLaw<Law>::GranSubModNormalOfLaw(GranularModel* gm, LAMMPS* lmp, std::vector<Coefficient> named)
    : GranSubModNormalRemembering(gm, lmp),
      coefficients(std::move(named)),
      energies(ricochet::lammps::energy_tally(lmp)) {
  num_coeffs = static_cast<int>(coefficients.size());
  size_history = ContactHistory::size;
  nondefault_history_transfer = 1;
  transfer_history_factor = new double[size_history];
  std::fill_n(transfer_history_factor, size_history, 1.0);
  damp = Emod = poiss = 0.0;
}

/* ---------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::coeffs_to_local() {
  for (std::size_t i = 0; i < coefficients.size(); i++)
    if (coefficients[i].by_default && coeffs[i] == -1) coeffs[i] = *coefficients[i].by_default;
  // Not for good: the time step may still change, and damping fractional/memory was not read yet.
  choose_law(update->dt, half_step::default_memory_steps * update->dt);
}

/* ----------------------------------------------------------------------
   The degree is a number between two kinds of a body, where 0 may stand;
   all else scales.
------------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::mix_coeffs(double* icoeffs, double* jcoeffs) {
  for (int i = 0; i < num_coeffs; i++)
    coeffs[i] = (coefficients[i].name == target_names.alpha) ? mix_mean(icoeffs[i], jcoeffs[i])
                                                             : mix_geom(icoeffs[i], jcoeffs[i]);
  coeffs_to_local();
}

/* ---------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::init() {
  const GranSubModDamping& given = *gm->damping_model;
  if (!dynamic_cast<const GranSubModDampingFractional*>(&given))
    error->all(FLERR, "granular model " + name + " takes damping fractional, or fractional/memory TIME, and finds " +
                          given.name);
}

/* ---------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::choose_law(double dt, double memory) {
  try {
    law.emplace(
        law_of_coeffs([&](const Law& one) -> const LocatedContact<Law>& { return contact_of(one, dt, memory); }));
  } catch (const std::invalid_argument& misuse) {
    error->all(FLERR, "granular model " + name + ": " + misuse.what());
  }
}

/* ----------------------------------------------------------------------
   The arms are chosen once, so that what the contacts remember keeps its
   meaning when a later run takes another time step.
------------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::begin_run() {
  first_step = update->firststep;
  last_step = update->laststep;
  watch.begin_run(1, first_step, last_step);
  if (update->whichflag == 2) error->one(FLERR, "granular model " + name + ": minimize knows no time");
  if (std::strncmp(update->integrate_style, "respa", 5) == 0)
    error->one(FLERR, "granular model " + name + ": run_style respa looks at contacts more than once a step");
  if (kernel_step == 0) {
    kernel_step = gm->dt;
    const double memory = static_cast<GranSubModDampingFractional*>(gm->damping_model)->memory();
    choose_law(kernel_step, memory > 0 ? memory : half_step::default_memory_steps * kernel_step);
  } else {
    hand_on(ricochet::half_step::RunWatch::look_at_kernel(kernel_step, gm->dt));
  }
}

/* ---------------------------------------------------------------------- */

template <class Law>
double GranSubModNormalOfLaw<Law>::calculate_forces() {
  // A run from step 0 may follow another from step 0 to the same end.
  if (first_step != update->firststep || last_step != update->laststep || update->ntimestep < seen_step) begin_run();
  seen_step = update->ntimestep;
  const double radius = gm->contact_type == PAIR ? std::min(gm->radi, gm->radj) : gm->radi;
  if (watch.is_lightest(0, gm->meff) || watch.is_soft(gm->delta, radius)) watch_contact(radius);
  double* memory = &gm->history[history_index];
  const auto step = static_cast<double>(update->ntimestep);
  if (!gm->history_update || ContactHistory::is_at(memory, step)) return force_found_before(memory, step);
  if (energies.users > 0)
    advance_and_tally(memory, step);
  else
    law->contact().advance(memory, step, gm->delta, -gm->vnnr, gm->dt);
  return law->coefficient(gm->meff) * ContactHistory::repulsion(memory);
}

/* ----------------------------------------------------------------------
   While a run is set up, and for whoever asks afterwards, the force is the
   one found when the step was taken.
------------------------------------------------------------------------- */

template <class Law>
double GranSubModNormalOfLaw<Law>::force_found_before(const double* memory, double step) {
  const bool asked = gm->contact_type == PAIR && gm->calculate_svector;  // by Pair::single()
  const bool found = ContactHistory::is_at(memory, step);
  if (update->setupflag && !asked) {
    if (memory[ContactHistory::stamp] != 0 && !found) hand_on(watch.look_at_memory(update->ntimestep));
    if (energies.users > 0) tally(law->contact().stored_energy(memory), 0.0);
  }
  return found ? law->coefficient(gm->meff) * ContactHistory::repulsion(memory) : 0.0;
}

/* ---------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::advance_and_tally(double* memory, double step) {
  const LocatedContact<Law>& contact = law->contact();
  std::array<double, ContactHistory::size> before{};
  std::copy_n(memory, before.size(), before.begin());
  contact.advance(memory, step, gm->delta, -gm->vnnr, gm->dt);
  tally(contact.stored_energy(memory), contact.dissipated_energy(before.data(), memory, gm->dt));
}

/* ---------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::tally(double energy, double lost) {
  const bool shared = gm->contact_type == PAIR && !force->newton_pair && gm->j >= atom->nlocal;
  const double share = (shared ? 0.5 : 1.0) * law->coefficient(gm->meff);
  energies.add_stored(update->ntimestep, share * energy);
  energies.dissipated += share * lost;
}

/* ---------------------------------------------------------------------- */

template <class Law>
double GranSubModNormalOfLaw<Law>::linear_damping() {
  if (gm->meff != damping_mass) {
    damping_mass = gm->meff;
    damping_value = law->linear_equivalent(damping_mass).damping;
  }
  return damping_value;
}

/* ---------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::watch_contact(double radius) {
  if (watch.is_lightest(0, gm->meff)) hand_on(watch.look_at_step(0, gm->meff, law->tcol(gm->meff), gm->dt));
  if (watch.is_soft(gm->delta, radius)) hand_on(watch.soft(gm->delta, radius));
}

/* ---------------------------------------------------------------------- */

template <class Law>
void GranSubModNormalOfLaw<Law>::hand_on(const std::optional<Remark>& remark) {
  if (!remark) return;
  const std::string text = "granular model " + name + ": " + remark->text;
  if (remark->refuses) error->one(FLERR, text);
  error->warning(FLERR, text);
}

/* ----------------------------------------------------------------------
   A law by its parameters
------------------------------------------------------------------------- */

template <class Law>
GranSubModNormalByParameters<Law>::GranSubModNormalByParameters(GranularModel* gm, LAMMPS* lmp)
    : GranSubModNormalOfLaw<Law>(gm, lmp, [] {
        std::vector<typename GranSubModNormalOfLaw<Law>::Coefficient> all;
        all.reserve(Law::parameters.size() + 1);
        for (const auto& parameter : Law::parameters) all.push_back({capitals(parameter.name), {}});
        if (knows_velocity<Law>) all.push_back({"VELOCITY", {}});
        return all;
      }()) {}

/* ---------------------------------------------------------------------- */

template <class Law>
typename GranSubModNormalOfLaw<Law>::PairLaw GranSubModNormalByParameters<Law>::law_of_coeffs(
    const typename GranSubModNormalOfLaw<Law>::ContactFor& contact) const {
  ricochet::ParameterValues<Law> values{};
  std::copy_n(this->coeffs, values.size(), values.begin());
  const double velocity = knows_velocity<Law> ? this->coeffs[values.size()] : 1.0;
  ricochet::support::require_positive("VELOCITY", velocity);
  return half_step::PairLaw<Law>::from_parameters(Law::from(values), velocity, contact);
}

/* ----------------------------------------------------------------------
   A law by the collision that it is to make
------------------------------------------------------------------------- */

template <class Law>
GranSubModNormalByTarget<Law>::GranSubModNormalByTarget(GranularModel* gm, LAMMPS* lmp)
    : GranSubModNormalOfLaw<Law>(gm, lmp, [] {
        const ricochet::Held held;
        std::vector<typename GranSubModNormalOfLaw<Law>::Coefficient> all{{"TCOL", {}}, {"EN", {}}};
        if (ricochet::HoldsDegree<Law>) all.push_back({"ALPHA", held.alpha});
        if (knows_velocity<Law>) all.push_back({"VELOCITY", {}});
        if (std::is_same_v<Law, ricochet::FractionalZener>) all.push_back({"K1/K", held.stiffening});
        return all;
      }()) {}

/* ---------------------------------------------------------------------- */

template <class Law>
typename GranSubModNormalOfLaw<Law>::PairLaw GranSubModNormalByTarget<Law>::law_of_coeffs(
    const typename GranSubModNormalOfLaw<Law>::ContactFor& contact) const {
  ricochet::Held held;
  if (ricochet::HoldsDegree<Law>) held.alpha = this->coeffs[2];
  if (std::is_same_v<Law, ricochet::FractionalZener>) held.stiffening = this->coeffs[3];
  const double velocity = knows_velocity<Law> ? this->coeffs[3] : 1.0;
  ricochet::support::require_positive("VELOCITY", velocity);
  return half_step::PairLaw<Law>::from_target(this->coeffs[0], this->coeffs[1], held, velocity, contact, target_names);
}

/* ----------------------------------------------------------------------
   The damping model that goes with them
------------------------------------------------------------------------- */

GranSubModDampingFractional::GranSubModDampingFractional(GranularModel* gm, LAMMPS* lmp) : GranSubModDamping(gm, lmp) {
  damp = damp_prefactor = 0.0;
}

/* ---------------------------------------------------------------------- */

void GranSubModDampingFractional::init() {
  GranSubModNormal& given = *gm->normal_model;
  normal = dynamic_cast<GranSubModNormalRemembering*>(&given);
  if (!normal)
    error->all(FLERR, "damping " + name + " goes with the granular models fractional alone, not with " + given.name);
}

/* ---------------------------------------------------------------------- */

double GranSubModDampingFractional::calculate_forces() {
  damp_prefactor = normal->linear_damping();
  return 0.0;
}

/* ---------------------------------------------------------------------- */

GranSubModDampingFractionalMemory::GranSubModDampingFractionalMemory(GranularModel* gm, LAMMPS* lmp)
    : GranSubModDampingFractional(gm, lmp) {
  num_coeffs = 1;
}

/* ---------------------------------------------------------------------- */

void GranSubModDampingFractionalMemory::coeffs_to_local() {
  try {
    ricochet::support::require_positive("TIME", coeffs[0]);
  } catch (const std::invalid_argument& misuse) {
    error->all(FLERR, "damping " + name + ": " + misuse.what());
  }
}

namespace LAMMPS_NS::Granular_NS {
template class GranSubModNormalByParameters<ricochet::Fractional>;
template class GranSubModNormalByParameters<ricochet::FractionalKelvinVoigt>;
template class GranSubModNormalByParameters<ricochet::FractionalHertz>;
template class GranSubModNormalByParameters<ricochet::FractionalZener>;
template class GranSubModNormalByTarget<ricochet::Fractional>;
template class GranSubModNormalByTarget<ricochet::FractionalKelvinVoigt>;
template class GranSubModNormalByTarget<ricochet::FractionalHertz>;
template class GranSubModNormalByTarget<ricochet::FractionalZener>;
}  // namespace LAMMPS_NS::Granular_NS
