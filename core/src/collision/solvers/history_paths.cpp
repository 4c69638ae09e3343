// Schemes that keep the whole history of the rate.

#include "fractional_path.hpp"

#include <ricochet/fractional/operators.hpp>

#include <cmath>

namespace ricochet::collision {

namespace {

/// far^p − near^p, 0 ≤ near < far, without cancellation.
double power_difference(double p, double near, double far) {
  return near > 0 ? std::pow(far, p) * -std::expm1(p * std::log1p((near - far) / far)) : std::pow(far, p);
}

/// I^β of a history whose first step is shorter than the others: the uniform rule from t_1 on, plus the first step.
class PartialRule {
 public:
  PartialRule(ConvolutionRule uniform, double beta, const Mesh& mesh, bool linear)
      : uniform_(std::move(uniform)), beta_(beta), mesh_(mesh), linear_(linear), scale_(1 / std::tgamma(beta)) {}

  /// At the time of the last sample.
  double operator()(const std::vector<double>& x, Path& path) const {
    const std::size_t n = x.size() - 1;
    const double far = mesh_.time(n), near = n == 1 ? 0 : static_cast<double>(n - 1) * mesh_.step;
    const double mass = power_difference(beta_, near, far) / beta_;
    path.kernel_evaluations += 2;
    path.multiplications += n + 1;
    double start = x[0] * mass;
    if (linear_) {
      const double first = power_difference(beta_ + 1, near, far) / (beta_ + 1);
      path.kernel_evaluations += 2;
      start = x[1] * mass + (x[0] - x[1]) / mesh_.first * (first - near * mass);
    }
    return scale_ * start + uniform_.last({x.data() + 1, n});
  }

 private:
  ConvolutionRule uniform_;
  double beta_;
  const Mesh& mesh_;
  bool linear_;
  double scale_;
};

std::size_t most_steps(const Mesh& mesh) { return static_cast<std::size_t>(mesh.end / mesh.step) + 2; }

}  // namespace

Path rectangle_path(const Mesh& mesh) {
  Path path;
  const std::size_t most = most_steps(mesh);
  const double beta = 1 - mesh.alpha;
  const PartialRule derivative(rectangle_integral(beta, mesh.step, most), beta, mesh, false);
  path.kernel_evaluations += most;
  std::vector<double> rates{1};
  for (std::size_t n = 1; !mesh.past(n); ++n) {
    const double h = n == 1 ? mesh.first : mesh.step, v = path.rate.back();
    rates.push_back(v - h * path.force.back());  // the predicted rate, to which (59) gives weight 0
    const double force = derivative(rates, path);
    rates.back() = v - 0.5 * h * (path.force.back() + force);
    path.add(mesh.time(n), path.overlap.back() + 0.5 * h * (v + rates.back()), rates.back(), force);
    if (!mesh.exact && path.ended(mesh)) break;
  }
  return path;
}

Path rectangle_integral_path(const Mesh& mesh) {
  Path path;
  const std::size_t most = most_steps(mesh);
  const double beta = -mesh.alpha;
  const PartialRule integral(rectangle_integral(beta, mesh.step, most), beta, mesh, false);
  path.kernel_evaluations += most;
  std::vector<double> overlaps{0};
  for (std::size_t n = 1; !mesh.past(n); ++n) {
    const double h = n == 1 ? mesh.first : mesh.step, v = path.rate.back();
    overlaps.push_back(0);  // not known yet, and (60) gives it weight 0
    const double force = integral(overlaps, path), rate = v - 0.5 * h * (path.force.back() + force);
    overlaps.back() = path.overlap.back() + 0.5 * h * (v + rate);
    path.add(mesh.time(n), overlaps.back(), rate, force);
    if (!mesh.exact && path.ended(mesh)) break;
  }
  return path;
}

Path trapezoid_path(const Mesh& mesh) {
  Path path;
  const std::size_t most = most_steps(mesh);
  const double beta = 2 - mesh.alpha;
  const PartialRule predict(rectangle_integral(beta, mesh.step, most), beta, mesh, false);
  const PartialRule correct(trapezoid_integral(beta, mesh.step, most), beta, mesh, true);
  const PartialRule derivative(trapezoid_integral(beta - 1, mesh.step, most), beta - 1, mesh, true);
  path.kernel_evaluations += 3 * most;
  std::vector<double> rates{1};
  for (std::size_t n = 1; !mesh.past(n); ++n) {
    const double h = n == 1 ? mesh.first : mesh.step, v = path.rate.back();
    rates.push_back(0);
    rates.back() = 1 - predict(rates, path);
    for (int pass = 0; pass < 2; ++pass) rates.back() = 1 - correct(rates, path);
    path.add(mesh.time(n), path.overlap.back() + 0.5 * h * (v + rates.back()), rates.back(), derivative(rates, path));
    if (!mesh.exact && path.ended(mesh)) break;
  }
  return path;
}

}  // namespace ricochet::collision
