#pragma once

#include <ricochet/collision/oblique.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::verify::conformance {

/// A homogeneous sphere at one time, SI units.
struct Body {
  double radius = 0, mass = 0;
  Vec3 position{}, velocity{}, spin{};

  static Body of_density(double radius, double density);
  double inertia() const noexcept { return 0.4 * mass * radius * radius; }
  double density() const noexcept;
};

/// A flat, rigid wall at rest; the normal points to the grains and has the length 1.
struct Plane {
  Vec3 point{}, normal{1, 0, 0};
};

/// A normal law and the zero that ends its contacts.
struct Meeting {
  AnyLaw law;
  ContactEnd end = ContactEnd::force;
};

/// What is asked of the state at a run's end; `separation`, `contact_time` and `max_overlap` are of the first contact
/// of body 1, and only of cases that have one contact.
enum class Quantity {
  x,
  y,
  z,
  vx,
  vy,
  vz,
  wx,
  wy,
  wz,
  separation,    ///< when the overlap came back to 0, by the straight flight that the end state shows
  contact_time,  ///< t_col: until the zero that ends the contact
  max_overlap
};
std::string_view name(Quantity quantity) noexcept;

struct Asked {
  Quantity quantity = Quantity::vx;
  std::size_t body = 1;  ///< from 1
  double scale = 1;      ///< errors are told as shares of it
  bool required = true;  ///< else it is shown and not graded: engines need not report it
};

struct Answer : Asked {
  double value = 0;
  double error = 0;  ///< it is known to this, the place of the force (anywhere in the overlap) included
};

/// The state after `duration` by another way than time steps.
struct Solution {
  std::vector<Body> bodies = {};
  double separation = 0, contact_time = 0, max_overlap = 0;
  double error = 0;  ///< of all numbers, as shares of their scales
};

/// Orders in the step with which the errors of the two usual steppings fall.
struct Orders {
  double leapfrog = 1;  ///< velocity Verlet, forces from the velocity of half a step before
  double located = 2;   ///< begin and end of a contact found inside the step; less where the force begins like a root
};

struct Case;
using Solver = Solution (*)(const Case&, ContactArm);

/// A case that every engine can be asked. Written as `ricochet/case/1` (case_json.hpp, docs/conformance.md).
struct Case {
  std::string name = {}, family = {}, title = {}, source = {};
  std::string how = {};  ///< what the answers are computed by
  std::vector<Body> bodies = {};
  std::vector<Plane> walls = {};
  Vec3 gravity{};
  std::optional<Meeting> law = {}, wall_law = {};  ///< between bodies; of a body and a wall
  std::optional<TangentialContact> tangential = {};
  double flight_steps = 1.5;  ///< an engine starts so many steps before the positions of the bodies
  double time_scale = 0;      ///< [s], about one collision
  std::vector<int> steps{25, 50, 100, 200, 400, 800};  ///< in time_scale
  double duration = 0;                                 ///< [s] from the positions of the bodies on
  Orders orders{};
  std::vector<Asked> asked = {};
  Solver solver = nullptr;

  double step(int steps_in_scale) const noexcept { return time_scale / steps_in_scale; }
  /// ⌈flight_steps + duration/step⌉; what is above a whole number by rounding alone counts as that number.
  long steps_of_run(int steps_in_scale) const noexcept;
  /// Between a run's start and its end the positions of the bodies are passed by this much [s].
  double end_of_run(int steps_in_scale) const noexcept;
  /// A run's first state.
  std::vector<Body> start(int steps_in_scale) const;
};

/// What is asked, answered: by forces at a radius from the centres; `error` is what another place in the overlap makes
/// of it, and the solver's own.
std::vector<Answer> answers(const Case& of);

/// One of the numbers of a solution; `separation` and the like of its contact.
double number(const Solution& of, const Asked& asked);

/// The number of that body's row.
double component(const Body& body, Quantity quantity);

/// Kinetic energy and that in gravity [J].
double energy(const std::vector<Body>& bodies, Vec3 gravity);

/// All cases, family by family.
std::vector<Case> all_cases();

}  // namespace ricochet::verify::conformance
