#pragma once

#include <calibrate/calibration.hpp>

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace ricochet::calibration {

/// What a change of one parameter does to the collision: logarithmic derivatives, the percent that the result changes
/// for one percent of the parameter. Nothing where the parameter is 0 or cannot be moved in both directions.
struct Sensitivity {
  NamedValue parameter;
  std::optional<double> tcol, en;
};

/// Central differences of `collide` over ±1e-4 of each parameter: the error is of the order of 1e-7.
std::vector<Sensitivity> sensitivities(const AnyLaw& law, ContactEnd end, const Impact& impact);

/// How engines step a contact.
enum class Stepping {
  /// LAMMPS, LIGGGHTS, Yade, MercuryDPM: the force from the position at the end of the step and the velocity at its
  /// middle, a contact found only once the bodies overlap, the force clamped at zero where the contact ends by force.
  /// First order in the step, because the touch is not located and the velocity lags. MFiX's default, 'EULER', takes
  /// the velocity forward first and the position with it, which is the same with its velocity for the one at the
  /// middle.
  half_step,
  /// liggghts-ricochet, lammps-ricochet; laws with a memory ended by force only: touch and end are located. Second
  /// order. They warn of fewer steps than half_step::RunWatch::advised_steps, and none are advised here.
  located
};

/// How the engines that run such a contact step it: `located` where it is_located.
Stepping stepping_of(const AnyLaw& law, ContactEnd end);

/// How far e_n is off when an engine takes that many steps a collision time.
struct StepError {
  int steps = 0;     ///< t_col/Δt
  double error = 0;  ///< greatest |e_n/target − 1| over eighteen places of the first touch within a step
};

/// The errors of e_n that a step is advised for.
inline constexpr double step_bounds[] = {0.01, 0.001};

/// The collision as engines step it, from 5 steps a collision time on until the error stays within the least of
/// step_bounds for three meshes, a tenth to a quarter finer each, or 20000 steps. Laws that remember all are carried by
/// Maxwell arms with a kernel error of 1e-6. Throws std::invalid_argument for `located` where it is not `is_located`.
std::vector<StepError> step_errors(const AnyLaw& law, ContactEnd end, const Target& target, Stepping stepping);

/// The same error where a collision takes that many steps > 0, whole or not; infinite where the contact does not end.
double step_error(const AnyLaw& law, ContactEnd end, const Target& target, double steps, Stepping stepping);

/// Is it for an engine's driver, which locates both ends of a contact? The laws that remember all, ended by force.
bool is_located(const AnyLaw& law, ContactEnd end);

/// The least steps from which on the error stays within `bound`, and that the stepping's programs do not warn of;
/// nothing if the finest mesh does not suffice.
std::optional<int> steps_for(const std::vector<StepError>& errors, double bound, Stepping stepping);

/// The time step that keeps e_n to error_en in an engine; nothing where 20000 steps a collision do not.
struct EngineStep {
  std::string engine;
  double error_en = 0;         ///< one of step_bounds
  std::optional<double> step;  ///< [s]
};

/// For every engine that runs this law and ends it so: a row a bound.
std::vector<EngineStep> engine_steps(const AnyLaw& law, ContactEnd end, const Target& target);

/// `engine_steps` of many contacts: t_col over the step depends on the law's kind, the end and e_n alone, of a law of
/// real solids also on its α and k₁/k, so that those of one e_n are stepped once.
class StepAdvisor {
 public:
  std::vector<EngineStep> operator()(const AnyLaw& law, ContactEnd end, const Target& target);

 private:
  using Key = std::tuple<std::size_t, ContactEnd, double, double, double>;
  std::map<Key, std::vector<EngineStep>> known_;  // steps as t_col over them
};

/// π r √(ρ/G)/(0.1631ν + 0.8766) [s]: the time that a Rayleigh wave takes along half a sphere, of which engines' users
/// take a share. Radius [m], density [kg/m³], Young's modulus [Pa] > 0, −1 < ν ≤ 0.5; throws std::invalid_argument.
/// Source: Y. Li, Y. Xu, C. Thornton, Powder Technol. 160, 219 (2005).
double rayleigh_time(double radius, double density, double young, double poisson);

/// hertz_time (ricochet/collision/scale_and_loss.hpp) of a law with kζ^{3/2} in it, as if it were elastic [s]; nothing
/// for others.
std::optional<double> hertz_time_of(const AnyLaw& law, const Impact& impact);

}  // namespace ricochet::calibration
