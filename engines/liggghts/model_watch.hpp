#pragma once

#include "run_watch.hpp"

#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace LIGGGHTS::ContactModels {
struct SurfacesIntersectData;
}

namespace ricochet::liggghts {

/// RunWatch in LIGGGHTS: kinds of contacts are pairs of types, itype·types + jtype.
class ModelWatch {
 public:
  ModelWatch(LAMMPS_NS::LAMMPS* lmp, std::string model) : lmp_(lmp), model_(std::move(model)) {}

  /// Before a run of grains of so many types (0 … types − 1).
  void begin_run(int types);

  /// Before each run, on all ranks: `chosen_for` is the time step that the memory kernel was chosen for.
  void check_kernel(double chosen_for) const;

  bool is_lightest(int at, double mass_eff) const noexcept { return run_.is_lightest(at, mass_eff); }
  /// Looks at it: warns, or ends the run on all ranks or this one.
  void check_step(int at, double mass_eff, double tcol, bool on_all_ranks);

  void check_overlap(const LIGGGHTS::ContactModels::SurfacesIntersectData& pair);
  /// Of a contact that has a memory of an earlier step than the last.
  void check_memory();

 private:
  void warn(const std::string& text) const;

  LAMMPS_NS::LAMMPS* lmp_;
  std::string model_;
  half_step::RunWatch run_;
};

/// The effective mass of the lightest pair of grains of every two types on all ranks, infinite where there is none;
/// types 0 … types − 1, LIGGGHTS's counting from 1.
std::vector<double> lightest_pairs(const LAMMPS_NS::LAMMPS& lmp, int types);

}  // namespace ricochet::liggghts
