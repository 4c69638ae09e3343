#include "grain_contacts.hpp"

#include <algorithm>

namespace ricochet::lammps {

using half_step::ContactHistory;
using LAMMPS_NS::Atom;
using LAMMPS_NS::ubuf;

GrainContacts::GrainContacts(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg) {
  restart_peratom = 1;
  create_attribute = 1;
  maxexchange_dynamic = 1;
  GrainContacts::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

GrainContacts::~GrainContacts() {
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

GrainContacts::History& GrainContacts::at(int i, Partner partner) {
  std::vector<Contact>& own = contacts_[i];
  for (Contact& contact : own)
    if (contact.partner == partner) return contact.history;
  return own.emplace_back(Contact{partner, {}}).history;
}

const GrainContacts::History* GrainContacts::find(int i, Partner partner) const {
  for (const Contact& contact : contacts_[i])
    if (contact.partner == partner) return &contact.history;
  return nullptr;
}

int GrainContacts::setmask() { return LAMMPS_NS::FixConst::PRE_EXCHANGE; }

// Contacts that were not touched in the last step have ended: the neighbour list that is about to be made may not know
// them any more.
void GrainContacts::pre_exchange() {
  const auto step = static_cast<double>(update->ntimestep);
  for (int i = 0; i < atom->nlocal; ++i)
    std::erase_if(contacts_[i],
                  [&](const Contact& contact) { return !ContactHistory::continues(contact.history.data(), step); });
  fit_buffers();
}

// A grain that comes from another rank and goes on to a third may have more contacts than any here: LAMMPS itself keeps
// room for 1024 numbers.
void GrainContacts::fit_buffers() {
  maxexchange = 1;
  for (int i = 0; i < atom->nlocal; ++i) maxexchange = std::max(maxexchange, packed_size(i));
}

int GrainContacts::pack_exchange(int i, double* buffer) {
  double* next = buffer;
  *next++ = static_cast<double>(contacts_[i].size());
  for (const Contact& contact : contacts_[i]) {
    *next++ = ubuf(contact.partner).d;
    next = std::copy(contact.history.begin(), contact.history.end(), next);
  }
  return static_cast<int>(next - buffer);
}

int GrainContacts::unpack_exchange(int i, double* buffer) {
  const double* next = buffer;
  contacts_[i].resize(static_cast<std::size_t>(*next++));
  for (Contact& contact : contacts_[i]) {
    contact.partner = static_cast<Partner>(ubuf(*next++).i);
    std::copy_n(next, contact.history.size(), contact.history.begin());
    next += contact.history.size();
  }
  return static_cast<int>(next - buffer);
}

// In front of it stands its length, by which other fixes pass over it.
int GrainContacts::pack_restart(int i, double* buffer) {
  buffer[0] = 1 + pack_exchange(i, buffer + 1);
  return static_cast<int>(buffer[0]);
}

void GrainContacts::unpack_restart(int i, int which) {
  double* next = atom->extra[i];
  for (int other = 0; other < which; ++other) next += static_cast<int>(*next);
  unpack_exchange(i, next + 1);
}

int GrainContacts::maxsize_restart() {
  int largest = 0;
  for (int i = 0; i < atom->nlocal; ++i) largest = std::max(largest, size_restart(i));
  return largest;
}

double GrainContacts::memory_usage() {
  std::size_t bytes = contacts_.capacity() * sizeof(std::vector<Contact>);
  for (const auto& own : contacts_) bytes += own.capacity() * sizeof(Contact);
  return static_cast<double>(bytes);
}

}  // namespace ricochet::lammps
