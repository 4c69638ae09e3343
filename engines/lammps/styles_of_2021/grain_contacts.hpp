#pragma once

#include "engine_headers.hpp"
#include "half_step_contact.hpp"

#include <array>
#include <vector>

namespace ricochet::lammps {

/// For every grain of this rank the contacts that it has, by partner, with what they remember. A fix, so that they go
/// where the grain goes: from place to place in memory, from rank to rank, into restart files and out of them, there
/// for a fix of the same ID and style.
class GrainContacts : public LAMMPS_NS::Fix {
 public:
  using Partner = LAMMPS_NS::tagint;
  using History = std::array<double, half_step::ContactHistory::size>;

  GrainContacts(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~GrainContacts() override;

  /// What grain `i` remembers of `partner`, nothing (all zero) at their first meeting; until the next call for `i`.
  History& at(int i, Partner partner);
  /// The same; nullptr where they have never met.
  const History* find(int i, Partner partner) const;

  int setmask() override;
  void setup_pre_exchange() override { fit_buffers(); }
  void pre_exchange() override;

  void grow_arrays(int count) override { contacts_.resize(count); }
  void copy_arrays(int from, int to, int) override { contacts_[to] = contacts_[from]; }
  void set_arrays(int i) override { contacts_[i].clear(); }
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int i, int which) override;
  int size_restart(int i) override { return 1 + packed_size(i); }
  int maxsize_restart() override;
  double memory_usage() override;

 protected:
  struct Contact {
    Partner partner;
    History history;
  };

  std::vector<std::vector<Contact>> contacts_;  // of owned grains

 private:
  static constexpr int contact_size = 1 + static_cast<int>(half_step::ContactHistory::size);

  int packed_size(int i) const { return 1 + contact_size * static_cast<int>(contacts_[i].size()); }
  void fit_buffers();
};

}  // namespace ricochet::lammps
