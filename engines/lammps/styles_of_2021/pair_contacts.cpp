#include "pair_contacts.hpp"

#include <algorithm>
#include <unordered_map>

namespace ricochet::lammps {

using half_step::ContactHistory;

PairContacts::PairContacts(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : GrainContacts(lmp, narg, arg) {
  restart_global = 1;  // has nothing global to save, but is told that a file is about to be written
}

int PairContacts::setmask() { return GrainContacts::setmask() | LAMMPS_NS::FixConst::POST_RUN; }

// A fix that moves grains from rank to rank by itself (balance) may do so before this one's turn.
void PairContacts::init() {
  at_once_ = std::any_of(modify->fix, modify->fix + modify->nfix,
                         [](const LAMMPS_NS::Fix* fix) { return fix->pre_exchange_migrate != 0; });
  if (at_once_) share();
}

void PairContacts::pre_exchange() {
  share();
  GrainContacts::pre_exchange();
}

void PairContacts::write_restart(FILE* file) {
  share();
  const int size = 0;
  if (comm->me == 0) std::fwrite(&size, sizeof size, 1, file);
}

const PairContacts::History* PairContacts::find_pair(int i, int j) const {
  const History* const with_i = find(i, atom->tag[j]);
  if (j >= atom->nlocal || (with_i && is_current(*with_i))) return with_i;
  return find(j, atom->tag[i]);
}

bool PairContacts::is_current(const History& history) const {
  const auto now = static_cast<double>(update->ntimestep);
  return ContactHistory::continues(history.data(), now) || ContactHistory::is_at(history.data(), now);
}

void PairContacts::share() {
  std::unordered_map<Partner, int> place;
  for (int i = 0; i < atom->nlocal; ++i) place.emplace(atom->tag[i], i);
  for (int i = 0; i < atom->nlocal; ++i)
    for (const Contact& contact : contacts_[i]) {
      const auto partner = place.find(contact.partner);
      if (partner == place.end() || partner->second == i || !is_current(contact.history)) continue;
      History& theirs = at(partner->second, atom->tag[i]);
      if (!is_current(theirs) || theirs[ContactHistory::stamp] < contact.history[ContactHistory::stamp])
        theirs = contact.history;
    }
}

}  // namespace ricochet::lammps
