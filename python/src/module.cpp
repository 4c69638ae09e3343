#include "bindings.hpp"

#include <ricochet/version.hpp>

namespace ricochet::python {

std::string spelled(double value) {
  const py::gil_scoped_acquire python;  // also asked for where other threads go on
  return py::repr(py::float_(value));
}

PYBIND11_MODULE(_core, m) {
  m.doc() = "What the package ricochet is made of: the C++ library, its arrays flat.";
  m.attr("__version__") = std::string(version);
  bind_fractional(m);
  bind_laws(m);
  bind_collision(m);
  bind_tangential(m);
  bind_calibration(m);
  bind_exports(m);
  bind_cluster(m);
}

}  // namespace ricochet::python
