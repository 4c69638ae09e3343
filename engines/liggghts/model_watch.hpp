#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace LIGGGHTS::ContactModels {
struct SurfacesIntersectData;
}

namespace ricochet::liggghts {

/// What a normal model says about the run that it is in: a time step too coarse for its collisions, grains too soft for
/// their loads, contacts that lost their memory. Each warning once a run.
class ModelWatch {
 public:
  ModelWatch(LAMMPS_NS::LAMMPS* lmp, std::string model) : lmp_(lmp), model_(std::move(model)) {}

  /// Before a run of grains of so many types (0 … types − 1).
  void begin_run(int types);

  /// The effective mass of the lightest pair of types `at` (itype·types + jtype) that was looked at.
  bool is_lightest(int at, double mass_eff) const noexcept { return mass_eff < lightest_[at]; }
  /// Looks at it: warns, or ends the run on all ranks or this one.
  void check_step(int at, double mass_eff, double tcol, bool on_all_ranks);

  void check_overlap(const LIGGGHTS::ContactModels::SurfacesIntersectData& pair);
  /// Of a contact that has a memory of an earlier step than the last.
  void check_memory() {
    if (was_reset_) say_forgotten();
  }

 private:
  void say_forgotten();
  void warn(std::string_view text) const;

  LAMMPS_NS::LAMMPS* lmp_;
  std::string model_;
  std::vector<double> lightest_;
  std::int64_t next_start_ = -1;  // the step at which the next run begins, unless it is reset
  bool was_reset_ = false, coarse_said_ = false, soft_said_ = false;
};

/// The effective mass of the lightest pair of grains of every two types on all ranks, infinite where there is none;
/// types 0 … types − 1, LIGGGHTS's counting from 1.
std::vector<double> lightest_pairs(const LAMMPS_NS::LAMMPS& lmp, int types);

}  // namespace ricochet::liggghts
