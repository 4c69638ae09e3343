#include "solvers.hpp"

#include "arms_motion.hpp"

#include <ricochet/collision/fractional_contact.hpp>

#include <cmath>

namespace ricochet::verify {

namespace {

constexpr int offsets = 16;
constexpr Impact impact{.velocity = 1, .mass_eff = 1};  // with k = c = 1: natural units

struct Observed {
  double en, tcol, overlap_end;
};

/// Stated orders; docs/theory/orders.md. arms_trapezoid: its start error is one of impulse, which scales the motion
/// and leaves its duration alone: t_col keeps order 2.
double stated_order(FractionalScheme scheme, double alpha, bool tcol) {
  switch (scheme) {
    case FractionalScheme::rectangle:
    case FractionalScheme::rectangle_integral: return 1;
    case FractionalScheme::arms_trapezoid: return tcol ? 2 : 2 - alpha;
    case FractionalScheme::arms_rosenbrock: return 4;
    default: return 2;
  }
}

/// Terms a gap above the stated order: 1−α for (59) and the trapezoid rules, α between h^{2−α} and h², −α for (60).
double allowance(FractionalScheme scheme, double alpha, bool tcol) {
  double gap = 1 - alpha;
  if (scheme == FractionalScheme::arms_trapezoid && !tcol) gap = alpha;
  if (scheme == FractionalScheme::rectangle_integral) gap = -alpha;
  if (scheme == FractionalScheme::arms_rosenbrock) gap = 1;
  return gap < 0.5 ? 0.15 : 0.1;
}

void add(Convergence& c, std::size_t n, const std::vector<double>& errors) {
  double mean = 0, size = 0, worst = 0;
  for (const double e : errors) {
    mean += e / static_cast<double>(errors.size());
    size += std::fabs(e) / static_cast<double>(errors.size());
    worst = std::fabs(e) > worst || std::isnan(e) ? std::fabs(e) : worst;
  }
  c.steps.push_back(n);
  c.values.push_back(mean);
  c.errors.push_back(size);
  c.worst.push_back(worst);
}

SolverConvergence statements(FractionalScheme scheme, double alpha) {
  const std::string scheme_name(name(scheme));
  const auto statement = [&](const char* quantity) {
    const bool tcol = quantity[0] == 't';
    return Convergence{
        .statement = {scheme_name, quantity, alpha, stated_order(scheme, alpha, tcol), allowance(scheme, alpha, tcol)},
        .rounding = 1e-12,
        .length = scheme == FractionalScheme::collocation ? 0 : fractional_contact(alpha).tau};
  };
  return {
      .scheme = scheme, .en = statement("e_n"), .tcol = statement("t_col"), .overlap_end = statement("overlap_end")};
}

/// One solver for one law, with the kernel that its statement is about.
class Solver {
 public:
  Solver(FractionalScheme scheme, double alpha, Against against)
      : scheme_(scheme), tau_(fractional_contact(alpha).tau), law_(1, 1, alpha) {
    // Rosenbrock's order is that of the arms' equations, so its kernel is kept: coarse where only the order matters.
    if (scheme == FractionalScheme::arms_rosenbrock)
      options_.kernel = solver_kernel(law_, impact, tau_ / (against == Against::kept_kernel ? 16 : 256));
  }
  const MemoryKernel& kernel() const { return *options_.kernel; }

  /// Steps of the contact's n-th part; their mesh is offset by `offset` of a step. For the collocation n nodes.
  FractionalSolverResult solve(std::size_t n, double offset) {
    options_.step = tau_ / static_cast<double>(n);
    options_.offset = offset;
    options_.nodes = static_cast<int>(n);
    return solve_collision(scheme_, law_, impact, options_);
  }

  /// Makes the kernel of the arms that take one of the step's length.
  void keep_kernel(std::size_t n) {
    if (scheme_ == FractionalScheme::arms_trapezoid || scheme_ == FractionalScheme::arms_exponential)
      options_.kernel = solver_kernel(law_, impact, tau_ / static_cast<double>(n));
  }

 private:
  FractionalScheme scheme_;
  double tau_;
  Fractional law_;
  FractionalSolverOptions options_;
};

Observed reference_of(const Solver& solver, double alpha, Against against) {
  const FractionalContact exact = fractional_contact(alpha);
  if (against == Against::closed_form) return {exact.en, exact.tau, exact.overlap_end * exact.tau};
  const ArmsMotion kept = exact_motion(solver.kernel(), exact.tau);
  return {kept.en, kept.tcol, kept.overlap_end};
}

}  // namespace

SolverConvergence measure(FractionalScheme scheme, double order, const std::vector<std::size_t>& steps,
                          Against against) {
  const bool integral = scheme == FractionalScheme::rectangle_integral;
  const double alpha = integral ? -order : order;
  SolverConvergence result = statements(scheme, alpha);
  Solver solver(scheme, alpha, against);
  const Observed reference = reference_of(solver, alpha, against);
  const int trials = scheme == FractionalScheme::collocation ? 1 : offsets;
  for (const std::size_t n : steps) {
    solver.keep_kernel(n);
    std::vector<double> en, tcol, overlap;
    double multiplications = 0, kernels = 0;
    for (int k = 0; k < trials; ++k) {
      const FractionalSolverResult r = solver.solve(n, static_cast<double>(k) / offsets);
      const double nan = std::nan("");
      const bool ended = r.separated();
      en.push_back(ended ? r.en / reference.en - 1 : nan);
      tcol.push_back(ended ? r.tcol / reference.tcol - 1 : nan);
      overlap.push_back(ended ? r.overlap_end / reference.overlap_end - 1 : nan);
      multiplications += static_cast<double>(r.multiplications) / trials;
      kernels += static_cast<double>(r.kernel_evaluations) / trials;
    }
    add(result.en, n, en);
    add(result.tcol, n, tcol);
    if (!integral) add(result.overlap_end, n, overlap);
    result.multiplications.push_back(multiplications);
    result.kernel_evaluations.push_back(kernels);
  }
  return result;
}

Against stated_against(FractionalScheme scheme) {
  return scheme == FractionalScheme::arms_rosenbrock ? Against::kept_kernel : Against::closed_form;
}

}  // namespace ricochet::verify
