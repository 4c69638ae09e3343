// The arms as ordinary differential equations in Boost.Odeint. Alone in its file, which is C++17: the matrices that
// Odeint's Rosenbrock method is tied to (uBLAS) use what C++20 took out of std::allocator.

#include "fractional_path.hpp"

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/ublas/matrix.hpp>
#include <boost/numeric/ublas/vector.hpp>

#include <utility>

namespace ricochet::collision {

namespace {

using State = boost::numeric::ublas::vector<double>;  // ζ, ζ', elongations
using Matrix = boost::numeric::ublas::matrix<double>;

struct Equations {
  const Exponentials& kernel;

  double force(const State& x) const {
    double f = kernel.spring * x[0] + kernel.dashpot * x[1];
    for (std::size_t j = 0; j < kernel.rate.size(); ++j) f += kernel.strength[j] * x[2 + j];
    return f;
  }
  void operator()(const State& x, State& dxdt, double) const {
    dxdt[0] = x[1];
    dxdt[1] = -force(x);
    for (std::size_t j = 0; j < kernel.rate.size(); ++j) dxdt[2 + j] = x[1] - kernel.rate[j] * x[2 + j];
  }
};

struct Jacobian {
  const Exponentials& kernel;

  void operator()(const State&, Matrix& jacobian, double, State& dfdt) const {
    jacobian.clear();
    dfdt.clear();
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

}  // namespace

Path arms_rosenbrock_path(const Mesh& mesh, const Exponentials& kernel) {
  Path path;
  const Equations equations{kernel};
  const auto system = std::make_pair(equations, Jacobian{kernel});
  const std::size_t size = kernel.rate.size() + 2;
  boost::numeric::odeint::rosenbrock4<double> stepper;
  State x(size);
  x.clear();
  x[1] = 1;
  path.force[0] = kernel.dashpot;
  for (std::size_t n = 1; !mesh.past(n); ++n) {
    const double h = n == 1 ? mesh.first : mesh.step;
    State error(size), next(size);
    stepper.do_step(system, x, mesh.time(n - 1), next, h, error);
    x = next;
    path.multiplications += size * size * size / 3 + 6 * size * size;  // one LU, six back substitutions
    path.add(mesh.time(n), x[0], x[1], equations.force(x));
    if (!mesh.exact && path.ended(mesh)) break;
  }
  return path;
}

}  // namespace ricochet::collision
