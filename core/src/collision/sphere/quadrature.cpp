#include "quadrature.hpp"

#include <gsl/gsl_integration.h>

#include <memory>
#include <new>

namespace ricochet::collision {

Quadrature gauss_jacobi(int n, double a, double b) {
  const auto count = static_cast<std::size_t>(n);
  const std::unique_ptr<gsl_integration_fixed_workspace, decltype(&gsl_integration_fixed_free)> rule(
      gsl_integration_fixed_alloc(gsl_integration_fixed_jacobi, count, 0, 1, a, b), gsl_integration_fixed_free);
  if (!rule) throw std::bad_alloc();
  const double* nodes = gsl_integration_fixed_nodes(rule.get());
  const double* weights = gsl_integration_fixed_weights(rule.get());
  return {{nodes, nodes + count}, {weights, weights + count}};
}

}  // namespace ricochet::collision
