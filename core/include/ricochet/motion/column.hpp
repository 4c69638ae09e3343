#pragma once

#include <ricochet/contact/laws.hpp>

#include <cstddef>
#include <vector>

namespace ricochet {

/// Beads over a plate of infinite mass, on a vertical line. Bead i lies on bead i−1, bead 0 on the plate.
struct Column {
  std::vector<double> mass;      ///< [kg] > 0
  std::vector<double> gap;       ///< free distance under each bead at the start [m] ≥ 0
  std::vector<double> velocity;  ///< at the start [m/s], positive away from the plate
  double gravity = 0;            ///< towards the plate [m/s²] ≥ 0
};

/// `beads` equal beads with equal gaps and velocities.
Column equal_column(std::size_t beads, double mass, double gap, double velocity);

/// Kinetic energy with these velocities [m/s] over that at the start, Σ m v²/Σ m v₀² of (62); 0 for a start at rest.
double kinetic_energy_ratio(const Column& column, const std::vector<double>& velocity);

namespace motion {
void check(const Column& column);  ///< throws std::invalid_argument for what the members' comments exclude
}  // namespace motion

struct ColumnOptions {
  double step = 0;      ///< [s] > 0, at most `largest_step`; second order: t_col/200 gives E/E0 to about 1e-5 in the
                        ///< cases of the paper
  double duration = 0;  ///< stops then at the latest [s] > 0
  ContactEnd end = ContactEnd::force;
  Reclosing reclosing = Reclosing::repels;
  bool energy = false;  ///< keeps the energy balance (slower)
  /// Approach, relative to the greatest initial speed, that is left uncounted: a long column ends in a slow trickle of
  /// collisions that take thousands of times as long as the impact and change E/E0 by less than its square.
  double negligible_approach = 1e-9;
  double shortest_memory = 0;      ///< fractional law: δ of its MemoryKernel [s] ≥ 0; 0: step
  double longest_memory = 0;       ///< its T [s] ≥ 0, at most 1e6 δ; 0: duration, but at most 1e5 δ
  double memory_tolerance = 1e-6;  ///< relative error of its kernel on [δ, T], in [1e-12, 0.1]; see FractionalArms
};

/// How a run ended. "Approach" means by more than `negligible_approach` of the greatest initial speed.
enum class ColumnEnd {
  separated,    ///< no force acts, no neighbours approach: every contact is over
  resting,      ///< the same, but some bodies that still overlap do not move apart (static contact)
  out_of_time,  ///< `duration` was reached before either; always so under gravity
  broke_down  ///< a velocity or overlap is no longer finite, or the beads ended with more kinetic energy than they had
              ///< by over a tenth, which no law of the model can give: a smaller step is needed. Only `steps` is then
              ///< filled in
};

/// Kinetic + stored + dissipated + potential [J] is constant up to the scheme's order. What a contact still stores
/// when it opens, or while its force is held at zero, counts as dissipated.
struct ColumnEnergy {
  double kinetic = 0, stored = 0, dissipated = 0, potential = 0;
  double total() const noexcept { return kinetic + stored + dissipated + potential; }
};

struct ColumnResult {
  ColumnEnd end = ColumnEnd::out_of_time;
  double time = 0;               ///< [s]
  double energy_ratio = 0;       ///< kinetic energy at the end over that at the start; 1 − it is the share (62)
  std::vector<double> velocity;  ///< at the end [m/s]
  std::size_t steps = 0;         ///< taken (free flight is jumped over)
  std::size_t contacts = 0;      ///< that began
  double last_contact_time = 0;  ///< t_end − t_begin of the contact that stopped pressing last [s]
  ColumnEnergy energy;           ///< stored and dissipated only with `ColumnOptions::energy`
};

/// The largest step that the scheme bears [s]: h·g(h)·Σ ≤ 1/2 in every contact, with g the rise of the step's mean
/// force with the rate (kh/2 + c; fractional: c^α k^{1−α} h^{1−α}/Γ(3−α)) and Σ the inverse masses that its force and
/// its neighbours' act through. Where g depends on the overlap (Kuwabara-Kono, Tsuji) it is taken at the greatest one
/// of a binary collision with all the kinetic energy of the start, which heavy beads may put into a light one between
/// them; what gravity adds is not in it. Of a law of your own it is the greatest that `mean_force` shows along that
/// collision (at 1e-9 m/s at least). A single bead on a spring: t_col/π. Throws std::invalid_argument for a Column
/// that `run_column` refuses. Derivation: docs/theory/column.md.
template <ContactLaw Law>
double largest_step(const Column& column, const Law& plate, const Law& pair);
double largest_step(const Column& column, const AnyLaw& plate, const AnyLaw& pair);

/// Runs a column until all contacts are over, every pair with the law `pair` and the plate's contact with `plate`. The
/// scheme (ColumnEngine, docs/theory/column.md) is of second order in the step through every start and end of contact;
/// a step costs time linear in the number of beads.
/// Throws std::invalid_argument for vectors of different or no length, a value outside its range, or a step beyond
/// `largest_step`.
template <ContactLaw Law>
ColumnResult run_column(const Column& column, const Law& plate, const Law& pair, const ColumnOptions& options);
/// The same for laws known when it runs, which must be of one kind. The fractional laws run on Maxwell arms prepared by
/// `memory_kernel`. Throws also for laws of different kinds, and for a fractional memory that needs more arms than a
/// contact carries.
ColumnResult run_column(const Column& column, const AnyLaw& plate, const AnyLaw& pair, const ColumnOptions& options);

}  // namespace ricochet

#include <ricochet/motion/engine/column_run.hpp>
