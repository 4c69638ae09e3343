#pragma once

#include <vector>

namespace ricochet::collision {

/// Σ weight_i f(node_i) for ∫_0^1 (1−x)^a x^b f(x) dx; exact for polynomials of degree 2n − 1.
struct Quadrature {
  std::vector<double> node, weight;

  template <class F>
  double operator()(const F& f) const {
    double sum = 0;
    for (std::size_t i = 0; i < node.size(); ++i) sum += weight[i] * f(node[i]);
    return sum;
  }
};

/// Gauss and Jacobi's, a, b > −1 (GSL's).
Quadrature gauss_jacobi(int n, double a, double b);

}  // namespace ricochet::collision
