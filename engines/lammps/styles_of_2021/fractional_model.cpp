#include "fractional_model.hpp"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

namespace ricochet::lammps {

using half_step::ContactHistory;

namespace {

constexpr half_step::TargetNames target_names{"t_col", "e_n", "alpha"};

double numeric(const char* text, LAMMPS_NS::LAMMPS* lmp) { return LAMMPS_NS::utils::numeric(FLERR, text, false, lmp); }

}  // namespace

GivenLaw GivenLaw::read(std::span<char*> arg, LAMMPS_NS::LAMMPS* lmp) {
  if (arg.size() < words)
    lmp->error->all(FLERR, std::string("the law is missing: must be K C ALPHA or target T_COL E_N"));
  if (std::strcmp(arg[0], "target") == 0) return {true, {numeric(arg[1], lmp), numeric(arg[2], lmp), 0}};
  return {false, {numeric(arg[0], lmp), numeric(arg[1], lmp), numeric(arg[2], lmp)}};
}

void FractionalModel::read_settings(std::span<char*> arg) {
  for (std::size_t i = 0; i < arg.size(); i += 2) {
    const std::string word = arg[i], value = i + 1 < arg.size() ? arg[i + 1] : "";
    if (word == "memory" && !value.empty()) {
      settings_.memory = numeric(value.c_str(), lmp_);
      if (!(settings_.memory > 0)) refuse(fmt::format("memory = {}: must be > 0", value));
    } else if (word == "energy" && (value == "yes" || value == "no")) {
      settings_.energy = value == "yes";
    } else {
      refuse(fmt::format("{} {}: must be memory TIME or energy yes|no", word, value));
    }
  }
}

void FractionalModel::check_deck() const {
  const LAMMPS_NS::Atom& atom = *lmp_->atom;
  if (!atom.sphere_flag || !atom.tag_enable) refuse("needs atom_style sphere, with atom IDs");
  if (lmp_->force->newton_pair != 0) refuse("newton = on: must be newton off");
  if (lmp_->comm->ghost_velocity == 0) refuse("needs comm_modify vel yes");
  if (lmp_->force->ftm2v != 1)
    refuse(fmt::format("units = {}: must be si, cgs, lj, micro or nano", lmp_->update->unit_style));
  if (lmp_->update->whichflag == 2) refuse("minimize knows no time");
  if (std::strncmp(lmp_->update->integrate_style, "respa", 5) == 0)
    refuse("run_style respa looks at contacts more than once a step");
  for (int i = 0; i < lmp_->modify->nfix; ++i)
    if (lmp_->modify->fix[i]->rigid_flag != 0)
      refuse(fmt::format("fix {}: rigid bodies are not known to it", lmp_->modify->fix[i]->style));
}

void FractionalModel::begin_run(std::span<const GivenLaw> laws) {
  if (kernel_step_ == 0) kernel_step_ = lmp_->update->dt;
  hand_on(half_step::RunWatch::look_at_kernel(kernel_step_, lmp_->update->dt), true);
  try {
    laws_.clear();
    for (const GivenLaw& given : laws) laws_.push_back(make_law(given));
  } catch (const std::invalid_argument& misuse) {
    refuse(misuse.what());
  }
  watch_.begin_run(laws.size(), lmp_->update->ntimestep, lmp_->update->laststep);
}

FractionalModel::Law FractionalModel::make_law(const GivenLaw& given) {
  const auto find = [this](const Fractional& law) -> const Contact& { return contact_of(law); };
  if (given.by_target) return Law::from_target(given.values[0], given.values[1], {}, 1, find, target_names);
  return Law::from_parameters(Fractional::from(given.values), 1, find);
}

const FractionalModel::Contact& FractionalModel::contact_of(const Fractional& law) {
  const double memory = settings_.memory > 0 ? settings_.memory : half_step::default_memory_steps * kernel_step_;
  return contacts_.try_emplace({law.values(), memory}, law, kernel_step_, memory).first->second;
}

void FractionalModel::look_ahead(std::size_t kind, double lightest_mass_eff) {
  if (!watch_.is_lightest(kind, lightest_mass_eff)) return;
  const double tcol = laws_[kind].tcol(lightest_mass_eff);
  hand_on(watch_.look_at_step(kind, lightest_mass_eff, tcol, lmp_->update->dt), true);
}

double FractionalModel::force(const Touch& touch, GrainContacts::History& history) {
  const double now = static_cast<double>(lmp_->update->ntimestep);
  // Grains that come during a run are looked at as they touch.
  if (watch_.is_lightest(touch.kind, touch.mass_eff))
    hand_on(watch_.look_at_step(touch.kind, touch.mass_eff, laws_[touch.kind].tcol(touch.mass_eff), lmp_->update->dt),
            false);
  if (watch_.is_soft(touch.overlap, touch.radius)) hand_on(watch_.soft(touch.overlap, touch.radius), false);
  const bool remembers = history[ContactHistory::stamp] != 0;
  if (remembers && !ContactHistory::continues(history.data(), now) && !ContactHistory::is_at(history.data(), now))
    hand_on(watch_.look_at_memory(lmp_->update->ntimestep), false);
  step(touch, history);
  return last_force(touch.kind, touch.mass_eff, history);
}

void FractionalModel::step(const Touch& touch, GrainContacts::History& history) {
  const bool steps = lmp_->update->setupflag == 0;
  const double now = static_cast<double>(lmp_->update->ntimestep), dt = lmp_->update->dt;
  const Contact& contact = laws_[touch.kind].contact();
  if (!settings_.energy) {
    if (steps) contact.advance(history.data(), now, touch.overlap, touch.rate, dt);
    return;
  }
  const GrainContacts::History before = history;
  if (steps) contact.advance(history.data(), now, touch.overlap, touch.rate, dt);
  if (!ContactHistory::is_at(history.data(), now)) return;
  const double scale = touch.share * laws_[touch.kind].coefficient(touch.mass_eff);
  energies_.stored += scale * contact.stored_energy(history.data());
  if (steps) energies_.lost += scale * contact.dissipated_energy(before.data(), history.data(), dt);
}

double FractionalModel::last_force(std::size_t kind, double mass_eff, const GrainContacts::History& history) const {
  const double now = static_cast<double>(lmp_->update->ntimestep);
  if (!ContactHistory::is_at(history.data(), now)) return 0;
  return laws_[kind].coefficient(mass_eff) * ContactHistory::repulsion(history.data());
}

void FractionalModel::hand_on(const std::optional<half_step::RunWatch::Remark>& remark, bool on_all_ranks) const {
  if (!remark) return;
  const std::string text = fmt::format("{}: {}", name_, remark->text);
  if (remark->refuses && on_all_ranks) lmp_->error->all(FLERR, text);
  if (remark->refuses) lmp_->error->one(FLERR, text);
  if (!on_all_ranks || lmp_->comm->me == 0) lmp_->error->warning(FLERR, text);
}

void FractionalModel::refuse(const std::string& text) const { lmp_->error->all(FLERR, name_ + ": " + text); }

}  // namespace ricochet::lammps
