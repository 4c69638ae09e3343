#include <ricochet/collision/fractional_collocation.hpp>
#include <ricochet/collision/solvers/fractional_solvers.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include "fractional_path.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet {

namespace {

using collision::Mesh;
using collision::Path;

/// Natural times to follow: t_col is at most 3.4 of them for α < 0.8 and 6.3 for α ≤ 0.97.
double longest_contact(double alpha) { return alpha < 0.8 ? 4 : 7; }

/// Lagrange's interpolation through the last points, at most four.
double interpolated(const std::vector<double>& t, const std::vector<double>& f, double at) {
  const std::size_t n = t.size(), from = n - std::min<std::size_t>(n, 4);
  double sum = 0;
  for (std::size_t i = from; i < n; ++i) {
    double term = f[i];
    for (std::size_t j = from; j < n; ++j)
      if (j != i) term *= (at - t[j]) / (t[i] - t[j]);
    sum += term;
  }
  return sum;
}

/// Hermite's cubic on [a, b] from values and slopes.
double hermite(double a, double b, double fa, double fb, double sa, double sb, double at) {
  const double h = b - a, u = (at - a) / h, w = 1 - u;
  return fa * w * w * (1 + 2 * u) + fb * u * u * (1 + 2 * w) + h * u * w * (sa * w - sb * u);
}

/// The force's zero in the last step, of its interpolant.
double zero_of_force(const Path& path) {
  const std::size_t b = path.time.size() - 1, a = b - 1;
  if (path.force[a] <= 0) return path.time[a];  // a step longer than the contact
  return support::root([&](double t) { return interpolated(path.time, path.force, t); }, path.time[a], path.time[b],
                       path.force[a], path.force[b]);
}

struct End {
  double time, overlap, rate;
};

End located_end(const Path& path, bool by_overlap) {
  const std::size_t b = path.time.size() - 1, a = b - 1;
  const auto overlap = [&](double t) {
    return hermite(path.time[a], path.time[b], path.overlap[a], path.overlap[b], path.rate[a], path.rate[b], t);
  };
  const double t = by_overlap ? support::root(overlap, path.time[a], path.time[b]) : zero_of_force(path);
  return {t, by_overlap ? 0 : overlap(t),
          hermite(path.time[a], path.time[b], path.rate[a], path.rate[b], -path.force[a], -path.force[b], t)};
}

Path follow(FractionalScheme scheme, const Mesh& mesh, const collision::Exponentials& kernel) {
  switch (scheme) {
    case FractionalScheme::rectangle: return collision::rectangle_path(mesh);
    case FractionalScheme::rectangle_integral: return collision::rectangle_integral_path(mesh);
    case FractionalScheme::trapezoid: return collision::trapezoid_path(mesh);
    case FractionalScheme::arms_trapezoid: return collision::arms_trapezoid_path(mesh, kernel);
    case FractionalScheme::arms_exponential: return collision::arms_exponential_path(mesh, kernel);
    case FractionalScheme::arms_rosenbrock: return collision::arms_rosenbrock_path(mesh, kernel);
    case FractionalScheme::collocation: break;  // takes no steps
  }
  return {};
}

void check(FractionalScheme scheme, const Fractional& law, const Impact& impact, const FractionalSolverOptions& o) {
  const double alpha = law.alpha();
  if (scheme == FractionalScheme::trapezoid)
    support::require(alpha >= -1 && alpha <= 0.97, "alpha", alpha, "between -1 and 0.97");
  else if (scheme == FractionalScheme::rectangle_integral)
    support::require(alpha >= -1 && alpha < 0, "alpha", alpha, ">= -1 and < 0");
  else
    support::require(alpha > 0 && alpha <= 0.97, "alpha", alpha, "> 0 and at most 0.97");
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  support::require_not_negative("end_time", o.end_time);
  if (o.kernel) support::require(o.kernel->alpha() == alpha, "kernel alpha", o.kernel->alpha(), "the law's alpha");
  if (scheme != FractionalScheme::collocation) support::require_positive("step", o.step);
  support::require(o.offset >= 0 && o.offset < 1, "offset", o.offset, "at least 0 and < 1");
}

/// Natural time A^{−1/(2−α)}, A = c^α k^{1−α}/m.
double natural_time(const Fractional& law, const Impact& impact) {
  return std::pow(law.coefficient() / impact.mass_eff, -1 / (2 - law.alpha()));
}

bool has_arms(FractionalScheme scheme) {
  return scheme == FractionalScheme::arms_trapezoid || scheme == FractionalScheme::arms_exponential ||
         scheme == FractionalScheme::arms_rosenbrock;
}

/// The kernel with time in `unit`.
collision::Exponentials scaled(const MemoryKernel& kernel, double unit) {
  const double strength = std::pow(unit, kernel.alpha());
  collision::Exponentials e{.spring = kernel.spring() * strength, .dashpot = kernel.dashpot() * strength / unit};
  for (const Arm& arm : kernel.arms()) {
    e.strength.push_back(arm.strength * strength);
    e.rate.push_back(arm.rate * unit);
  }
  return e;
}

FractionalSolverResult by_collocation(const Fractional& law, const Impact& impact, const FractionalSolverOptions& o) {
  const FractionalSolution solution = collocate_collision(law.alpha(), o.nodes);
  FractionalSolverResult result;
  if (!solution.separated()) return result;
  const double unit = natural_time(law, impact);
  const auto n = static_cast<std::size_t>(solution.nodes), solves = static_cast<std::size_t>(solution.solves);
  result.status = CollisionStatus::ended_by_force;
  result.tcol = solution.tcol * unit;
  result.en = solution.en;
  result.overlap_end = solution.overlap_end * unit * impact.velocity;
  result.steps = n;
  result.kernel_evaluations = solves * n * n;       // one a matrix entry
  result.multiplications = solves * n * n * n / 3;  // one elimination
  return result;
}

}  // namespace

std::string_view name(FractionalScheme scheme) noexcept {
  switch (scheme) {
    case FractionalScheme::rectangle: return "(59) predictor-corrector";
    case FractionalScheme::rectangle_integral: return "(60) explicit";
    case FractionalScheme::trapezoid: return "product trapezoid P(EC)2E";
    case FractionalScheme::arms_trapezoid: return "arms, trapezoid";
    case FractionalScheme::arms_exponential: return "arms, exponential";
    case FractionalScheme::arms_rosenbrock: return "arms, Rosenbrock 4";
    case FractionalScheme::collocation: return "collocation";
  }
  return {};
}

MemoryKernel solver_kernel(const Fractional& law, const Impact& impact, double shortest, double tolerance) {
  const double longest = longest_contact(law.alpha()) * natural_time(law, impact);
  return memory_kernel(law.alpha(), {shortest, std::max(longest, shortest), tolerance});
}

FractionalSolverResult solve_collision(FractionalScheme scheme, const Fractional& law, const Impact& impact,
                                       const FractionalSolverOptions& options) {
  check(scheme, law, impact, options);
  if (scheme == FractionalScheme::collocation) return by_collocation(law, impact, options);

  const double unit = natural_time(law, impact), v0 = impact.velocity, h = options.step / unit;
  const Mesh mesh{.alpha = law.alpha(),
                  .first = (1 - options.offset) * h,
                  .step = h,
                  .end = options.end_time > 0 ? options.end_time / unit : longest_contact(law.alpha()),
                  .exact = options.end_time > 0};
  support::require(mesh.first < mesh.end, "step", options.step, "shorter than the contact");
  collision::Exponentials kernel;
  if (has_arms(scheme))
    kernel = scaled(options.kernel ? *options.kernel : solver_kernel(law, impact, options.step), unit);
  const Path path = follow(scheme, mesh, kernel);

  FractionalSolverResult result;
  result.steps = path.time.size() - 1;
  result.kernel_evaluations = path.kernel_evaluations;
  result.multiplications = path.multiplications;
  for (std::size_t n = 0; n < path.time.size(); ++n)
    result.path.push_back({path.time[n] * unit, path.overlap[n] * unit * v0, path.rate[n] * v0,
                           path.force[n] * impact.mass_eff * v0 / unit});
  if (mesh.exact) {
    result.status = CollisionStatus::budget_spent;
    result.tcol = result.path.back().time;
    result.en = -path.rate.back();
    result.overlap_end = result.path.back().overlap;
  } else if (path.ended(mesh)) {
    const End end = located_end(path, mesh.by_overlap());
    result.status = mesh.by_overlap() ? CollisionStatus::ended_by_overlap : CollisionStatus::ended_by_force;
    result.tcol = end.time * unit;
    result.en = -end.rate;
    result.overlap_end = end.overlap * unit * v0;
  }
  return result;
}

}  // namespace ricochet
