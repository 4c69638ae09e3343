// The arms as ordinary differential equations in Boost.Odeint. Alone in its file, which is C++17: the matrices that
// Odeint's Rosenbrock method is tied to (uBLAS) use what C++20 took out of std::allocator.

#include "arms_equations.hpp"

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/ublas/vector.hpp>

#include <utility>

namespace ricochet::collision {

namespace {

using State = boost::numeric::ublas::vector<double>;

}  // namespace

Path arms_rosenbrock_path(const Mesh& mesh, const Exponentials& kernel) {
  Path path;
  const ArmsEquations equations{kernel};
  const auto system = std::make_pair(equations, ArmsJacobian{kernel});
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
