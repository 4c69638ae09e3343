#include "convergence.hpp"

#include <ricochet/collision/power_law_sphere.hpp>
#include <ricochet/collision/solvers/sphere_elements.hpp>
#include <ricochet/verify/order.hpp>

#include <cmath>
#include <limits>

namespace ricochet::verify::sphere {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Refinement with_orders(Refinement r) {
  for (std::size_t i = 0; i < r.error.size(); ++i)
    r.order.push_back(i == 0 ? none
                             : pairwise_order(1.0 / r.meshes[i - 1], std::abs(r.error[i - 1]), 1.0 / r.meshes[i],
                                              std::abs(r.error[i])));
  return r;
}

/// Errors of every value but the last ones against `limit`.
Refinement against(double limit, double alpha, const std::vector<int>& meshes, const std::vector<double>& en) {
  Refinement r{.alpha = alpha, .meshes = meshes, .en = en, .error = {}, .order = {}};
  for (const double e : en) r.error.push_back(e - limit);
  return with_orders(r);
}

constexpr int finest_ting = 64;

}  // namespace

double Refinement::observed() const {
  double sum = 0;
  for (std::size_t i = order.size() - 3; i < order.size(); ++i) sum += order[i];
  return sum / 3;
}

Refinement joint(double alpha) {
  std::vector<int> steps;
  std::vector<double> en;
  for (int n = 32; n <= 1024; n *= 2) {
    steps.push_back(n);
    en.push_back(impact_by_elements(alpha, {.steps = n}).en);
  }
  return against(power_law_sphere(alpha, finest_ting).en, alpha, steps, en);
}

Refinement without_leading_term(const Refinement& joint) {
  const double limit = joint.en.back() - joint.error.back(), gain = std::exp2(2 - joint.alpha) - 1;
  std::vector<double> en;
  for (std::size_t i = 1; i < joint.en.size(); ++i) en.push_back(joint.en[i] + (joint.en[i] - joint.en[i - 1]) / gain);
  return against(limit, joint.alpha, {joint.meshes.begin() + 1, joint.meshes.end()}, en);
}

Refinement in_space(double alpha) {
  constexpr int steps = 512;
  Refinement r{.alpha = alpha, .meshes = {}, .en = {}, .error = {}, .order = {}};
  for (int every = 32; every >= 1; every /= 2) {
    r.meshes.push_back(steps / every);
    r.en.push_back(impact_by_elements(alpha, {.steps = steps, .every = every}).en);
  }
  for (std::size_t i = 0; i + 1 < r.en.size(); ++i) r.error.push_back(r.en[i] - r.en[i + 1]);
  return with_orders(r);
}

Refinement of_ting(double alpha) {
  const std::vector<int> nodes{8, 12, 16, 24, 32};
  std::vector<double> en;
  en.reserve(nodes.size());
  for (const int n : nodes) en.push_back(power_law_sphere(alpha, n).en);
  return against(power_law_sphere(alpha, finest_ting).en, alpha, nodes, en);
}

}  // namespace ricochet::verify::sphere
