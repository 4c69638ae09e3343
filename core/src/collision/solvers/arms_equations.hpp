#pragma once

// The arms' motion as differential equations, of whatever vectors and matrices an integrator takes. C++17: see
// arms_rosenbrock.cpp.

#include "fractional_path.hpp"

#include <cstddef>

namespace ricochet::collision {

/// x = (ζ, ζ', elongations); m = 1.
struct ArmsEquations {
  const Exponentials& kernel;

  template <class State>
  double force(const State& x) const {
    double f = kernel.spring * x[0] + kernel.dashpot * x[1];
    for (std::size_t j = 0; j < kernel.rate.size(); ++j) f += kernel.strength[j] * x[2 + j];
    return f;
  }
  template <class State>
  void operator()(const State& x, State& dxdt, double) const {
    dxdt[0] = x[1];
    dxdt[1] = -force(x);
    for (std::size_t j = 0; j < kernel.rate.size(); ++j) dxdt[2 + j] = x[1] - kernel.rate[j] * x[2 + j];
  }
};

/// ∂x'/∂x, and ∂x'/∂t = 0.
struct ArmsJacobian {
  const Exponentials& kernel;

  template <class State, class Matrix>
  void operator()(const State&, Matrix& jacobian, double, State& dfdt) const {
    const std::size_t size = kernel.rate.size() + 2;
    for (std::size_t i = 0; i < size; ++i) {
      dfdt[i] = 0;
      for (std::size_t j = 0; j < size; ++j) jacobian(i, j) = 0;
    }
    jacobian(0, 1) = 1;
    jacobian(1, 0) = -kernel.spring;
    jacobian(1, 1) = -kernel.dashpot;
    for (std::size_t j = 0; j < kernel.rate.size(); ++j) {
      jacobian(1, 2 + j) = -kernel.strength[j];
      jacobian(2 + j, 1) = 1;
      jacobian(2 + j, 2 + j) = -kernel.rate[j];
    }
  }
};

}  // namespace ricochet::collision
