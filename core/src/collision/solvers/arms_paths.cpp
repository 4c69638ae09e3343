// Schemes that keep the elongations of a memory kernel's arms.

#include "fractional_path.hpp"

#include <ricochet/fractional/decay_moments.hpp>

namespace ricochet::collision {

namespace {

/// Over one step of length h with the rate linear: the elongation q → decay·q + gain_before·v_n + gain_after·v_{n+1},
/// and its integral, ∫q = held·q + impulse_before·v_n + impulse_after·v_{n+1}.
struct ArmStep {
  double decay, gain_before, gain_after, held, impulse_before, impulse_after;
};

ArmStep arm_step(double rate, double h) {
  const double x = rate * h;
  const auto m = fractional::decay_moments(x);
  return {m.decay,
          h * m.rising,
          h * m.falling,
          h * fractional::decay_mean(x),
          h * h * (m.falling - m.falling_once),
          h * h * m.falling_once};
}

std::vector<ArmStep> arm_steps(const Exponentials& kernel, double h) {
  std::vector<ArmStep> steps;
  for (const double rate : kernel.rate) steps.push_back(arm_step(rate, h));
  return steps;
}

/// Steps v_{n+1} = v_n − ∫force, the integral by the trapezoid or exactly for a rate linear over the step. Either is
/// linear in v_{n+1}: ∫force = known + slope·v_{n+1}.
Path arms_path(const Mesh& mesh, const Exponentials& kernel, bool exact_impulse) {
  Path path;
  std::vector<ArmStep> steps = arm_steps(kernel, mesh.first);
  path.kernel_evaluations = 2 * kernel.rate.size();
  std::vector<double> q(kernel.rate.size());
  path.force[0] = kernel.dashpot;
  for (std::size_t n = 1; !mesh.past(n); ++n) {
    const double h = n == 1 ? mesh.first : mesh.step, v = path.rate.back(), z = path.overlap.back();
    if (n == 2) steps = arm_steps(kernel, mesh.step);
    double known = 0, slope = 0;
    if (exact_impulse) {
      known = kernel.spring * (h * z + h * h * v / 3) + kernel.dashpot * 0.5 * h * v;
      slope = kernel.spring * h * h / 6 + kernel.dashpot * 0.5 * h;
    } else {
      known = 0.5 * h * (path.force.back() + kernel.spring * (z + 0.5 * h * v));
      slope = 0.5 * h * (kernel.spring * 0.5 * h + kernel.dashpot);
    }
    for (std::size_t j = 0; j < q.size(); ++j) {
      const ArmStep& s = steps[j];
      known += kernel.strength[j] *
               (exact_impulse ? s.held * q[j] + s.impulse_before * v : 0.5 * h * (s.decay * q[j] + s.gain_before * v));
      slope += kernel.strength[j] * (exact_impulse ? s.impulse_after : 0.5 * h * s.gain_after);
    }
    const double rate = (v - known) / (1 + slope), overlap = z + 0.5 * h * (v + rate);
    double force = kernel.spring * overlap + kernel.dashpot * rate;
    for (std::size_t j = 0; j < q.size(); ++j) {
      q[j] = steps[j].decay * q[j] + steps[j].gain_before * v + steps[j].gain_after * rate;
      force += kernel.strength[j] * q[j];
    }
    path.multiplications += 6 * q.size();
    path.add(mesh.time(n), overlap, rate, force);
    if (!mesh.exact && path.ended(mesh)) break;
  }
  return path;
}

}  // namespace

Path arms_trapezoid_path(const Mesh& mesh, const Exponentials& kernel) { return arms_path(mesh, kernel, false); }

Path arms_exponential_path(const Mesh& mesh, const Exponentials& kernel) { return arms_path(mesh, kernel, true); }

}  // namespace ricochet::collision
