#pragma once

#include "grain_contacts.hpp"

namespace ricochet::lammps {

/// The contacts of grains with each other, by the partner's tag. A pair stands with both of its grains, so that each
/// keeps it when they part; one of this rank is stepped with one of them, and the other's record follows before it is
/// needed: before grains may change the rank, at a run's end, in restart files.
class PairContacts : public GrainContacts {
 public:
  static constexpr const char* style_name = "FRACTIONAL_CONTACTS";

  PairContacts(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  /// After a step of the pair (i, j) of this rank, done with i's record.
  void stepped(int i, int j) {
    if (at_once_) at(j, atom->tag[i]) = at(i, atom->tag[j]);
  }
  /// What both remember of each other; nullptr where they have never met.
  const History* find_pair(int i, int j) const;

  int setmask() override;
  void init() override;
  void pre_exchange() override;
  void post_run() override { share(); }
  void write_restart(FILE* file) override;

 private:
  bool is_current(const History& history) const;
  void share();

  bool at_once_ = false;
};

}  // namespace ricochet::lammps
