#pragma once

#include "engine_headers.hpp"
#include "grain_contacts.hpp"
#include "pair_law.hpp"
#include "run_watch.hpp"

#include <array>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ricochet::lammps {

/// A law as a deck gives it: `K C ALPHA`, or `target T_COL E_N`.
struct GivenLaw {
  bool by_target = false;
  std::array<double, 3> values{};

  /// Its words in a deck, 3 of both ways.
  static constexpr int words = 3;
  /// Reads the first words of `arg`, which may be followed by others. LAMMPS's error for numbers that are none.
  static GivenLaw read(std::span<char*> arg, LAMMPS_NS::LAMMPS* lmp);
};

/// What a deck sets for all contacts of a style.
struct Settings {
  double memory = 0;    ///< [time]; 0: half_step::default_memory_steps steps
  bool energy = false;  ///< whether energies are summed up
};

/// Energies [J] of this rank's contacts; of a pair that another rank steps as well, half.
struct ContactEnergies {
  double stored = 0;  ///< that springs hold now
  double lost = 0;    ///< since the style was made
};

/// The fractional law in pairs and on walls of LAMMPS: what both make of their words, and a contact's step. Contacts
/// are of kinds, each with its law.
class FractionalModel {
 public:
  struct Touch {
    std::size_t kind;
    double mass_eff, overlap;
    double rate;    ///< of approach, half a step before
    double radius;  ///< of the smaller grain
    double share;   ///< of the contact that this rank counts
  };

  FractionalModel(LAMMPS_NS::LAMMPS* lmp, std::string name) : lmp_(lmp), name_(std::move(name)) {}

  /// `memory TIME` and `energy yes|no`.
  void read_settings(std::span<char*> arg);
  /// Ends the run, on all ranks, unless the deck is one that the model can work in.
  void check_deck() const;

  /// Before a run: a law for each kind. The arms are chosen once, for the first run's time step, so that what contacts
  /// remember keeps its meaning when a later run takes another step.
  void begin_run(std::span<const GivenLaw> laws);
  /// Looks at the step for pairs of such a mass, known to all ranks.
  void look_ahead(std::size_t kind, double lightest_mass_eff);

  /// Before a step's contacts.
  void begin_step() { energies_.stored = 0; }
  /// The repulsion [N] of a contact, which is stepped unless LAMMPS sets a run up: then it is the one found when the
  /// step was taken, so that runs begin as they ended.
  double force(const Touch& touch, GrainContacts::History& history);
  /// Of a contact that may have been touched in the last step.
  double last_force(std::size_t kind, double mass_eff, const GrainContacts::History& history) const;

  const ContactEnergies& energies() const { return energies_; }
  Settings& settings() { return settings_; }
  double& kernel_step() { return kernel_step_; }
  [[noreturn]] void refuse(const std::string& text) const;

 private:
  using Law = half_step::PairLaw<Fractional>;
  using Contact = half_step::LocatedContact<Fractional>;

  Law make_law(const GivenLaw& given);
  const Contact& contact_of(const Fractional& law);
  void hand_on(const std::optional<half_step::RunWatch::Remark>& remark, bool on_all_ranks) const;
  void step(const Touch& touch, GrainContacts::History& history);

  LAMMPS_NS::LAMMPS* lmp_;
  std::string name_;
  Settings settings_;
  double kernel_step_ = 0;  // the time step that the arms were chosen for
  std::map<std::pair<ParameterValues<Fractional>, double>, Contact> contacts_;  // by law and memory
  std::vector<Law> laws_;
  half_step::RunWatch watch_;
  ContactEnergies energies_;
};

}  // namespace ricochet::lammps
