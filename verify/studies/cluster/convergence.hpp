#pragma once

#include <verify/gate.hpp>

#include <console/table.hpp>

#include <array>
#include <utility>
#include <vector>

namespace ricochet::verify::cluster {

/// Errors of the five spheres' motion against one on a far finer mesh, at the printed k and c. Where a touch falls
/// between two steps moves every error by tens of percent, so each is the mean over a dozen of meshes a little apart.
struct Convergence {
  /// A mean error at step h, h/2, h/4, its order from h to h/4, and the bounds of that.
  struct Errors {
    std::array<double, 3> mean{};
    double order = 0, low = 0, high = 0;
  };
  double alpha = 0, step = 0;
  Errors velocity;  ///< greatest difference of any velocity at the end [m/s]
  Errors energy;    ///< greatest relative error of the energy balance
};

/// The bounds. Beside the error A h² of the scheme stand, with signs unknown,
/// - what a force that starts like F t^p/Γ(1+p), p = 1−α, F = c^α k^{1−α} v_n, adds to the impulse of each collision
///   after its first, graded, step: Σ_n −h³/24 R''(t_n) with t_0 anywhere in (h/2, 3h/2), in the mean
///   F p 2^{1−p}/(24 Γ(1+p)) h^{1+p}. A change of the relative velocity at the start leaves the collision, which is
///   linear, multiplied by e_n;
/// - the kernels' errors, which do not fall with h: relative changes of the force, so of v₀ at most.
/// The energy balance is worst at one time: a step after a touch, where the power rises like t^p and halving a step
/// leaves h^{1+p}, or later, where it leaves h²: between 2−α and 2.
/// With shares s of these in the finest error, the order is 2 + ½ log2(1 ± Σ s (1 − 4^{q−2})), their orders q being
/// 2−α and 0; it cannot fall below q for the former. Three standard errors of the means come on top.
Convergence converge(double alpha, double duration);

/// Least and greatest order of the velocities from a step h to h/4, for these shares in the error at h/4 of what the
/// force's start and what the kernels' errors may be; without the standard errors. Not a number where the kernels may
/// be all of the error.
std::pair<double, double> velocity_orders(double alpha, double start_share, double kernel_share);

console::Table convergence_table(const std::vector<Convergence>& all);
void convergence_gates(std::vector<Gate>& gates, const std::vector<Convergence>& all);

}  // namespace ricochet::verify::cluster
