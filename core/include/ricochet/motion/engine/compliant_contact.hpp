#pragma once

#include <ricochet/contact/geometry.hpp>
#include <ricochet/contact/tangential.hpp>
#include <ricochet/motion/contact_state.hpp>

namespace ricochet::motion {

// A contact with springs in its tangent plane over one step of the leapfrog scheme. Elongations live where positions
// do, in the middle of the steps, velocities between them:
//
//   ξ_{n+1/2} = ξ_{n−1/2} + h u_n,  P = −h (k ξ_{n+1/2} + c (u_n + u_{n+1})/2),  |P| ≤ μ ∫R dt.
//
// The spring is explicit, so contacts at rest on each other ask for no sweeps; the dashpot is implicit, so it does not
// limit the step. Order 2 while it sticks (Störmer-Verlet, the dashpot by the midpoint rule).
//
// While it slides, q = k ξ + c ξ' has the limit's length and the direction of k ξ + c u. The midpoint rule on ξ' over
// the step from n−1/2 is a radial return at its middle, q_n ∥ k ξ_{n−1/2} + (k h/2 + c) u_n, and q goes on through it:
// q_{n+1/2} ∥ 2 q_n − q_{n−1/2}, |q_n| being the mean of the two limits. ξ then follows its load by the exact solution
// for loads linear in time. Switches between stick and slip are O(1) steps with a local error O(h²): order 2 as a
// whole. A stiffness that starts like √t (Mindlin's), and torsion that shares the disc's limit with a slide whose λ
// changes, have order 1.5 and 1 in the limit, the latter as the cut to the curve is a first-order return.

/// What is known of the contact before the step's impulses are sought, and the answer found last.
struct CompliantRow {
  Elongation before;    ///< at the time of the memory, turned to the present normal
  Elongation held;      ///< in the middle of the step, should the contact stick
  Traction last;        ///< at the time of the memory, turned
  Vec3 slide, roll;     ///< directions of the tractions halfway, should it slide or roll over a limit
  Spring spring_then;   ///< against sliding, at the time of the memory
  Pressing pressing;    ///< in the middle; its force is that of the answer
  double span = 0;      ///< from the memory to the middle; of a fresh contact from the touch to the step's end [s]
  double duration = 0;  ///< over which the impulse acts [s]
  bool fresh = false;
  LimitedTraction answer;
};

/// How the contact comes into the middle of the step.
struct CompliantApproach {
  Vec3 normal_then, normal;  ///< at the time of the memory and now
  SlipMotion motion;         ///< mean since then
  Pressing pressing;         ///< in the middle, without the force
  double step = 0;           ///< Δt [s]
};

CompliantRow compliant_row(const TangentialContact& law, const ContactState& contact,
                           const CompliantApproach& approach) noexcept;

/// As friction_impulse, of springs. `sticks`: neither sliding nor torsion are at their limit.
FrictionSolution compliant_impulse(const TangentialContact& law, CompliantRow& row, const FrictionProblem& problem,
                                   const FrictionImpulse& guess) noexcept;

/// The memory after the step, in its middle (of a fresh contact at its end), and its energies.
struct CompliantEnd {
  Elongation elongation;
  double stored = 0;  ///< by the springs at the step's end [J]
  double lost = 0;    ///< over the step [J]
};

/// `mean` is the motion halfway between before and after the impulse, `force` the R at the end of a fresh contact's
/// step [N]. What a contact that sticks loses is its dashpots' c u²; else the work that the springs have not stored.
CompliantEnd compliant_end(const TangentialContact& law, const CompliantRow& row, const ContactState& contact,
                           const FrictionImpulse& impulse, const SlipMotion& mean, double force) noexcept;

}  // namespace ricochet::motion
