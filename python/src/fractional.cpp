#include "bindings.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/fractional/memory_kernel.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>
#include <ricochet/support/require.hpp>

#include <pybind11/stl.h>

#include <vector>

namespace ricochet::python {
namespace {

py::dict contacts(const Array& alphas, const std::string& word, const Shape& shape) {
  const ContactEnd end = end_of(word);
  std::vector<FractionalContact> found;
  found.reserve(static_cast<std::size_t>(alphas.size()));
  each_one(view(alphas).size(), shape,
           [&](std::size_t i) { found.push_back(fractional_contact(view(alphas)[i], end)); });
  py::dict columns;
  const auto column = [&](const char* name, double FractionalContact::*of) { columns[name] = column_of(found, of); };
  column("alpha", &FractionalContact::alpha);
  column("z_star", &FractionalContact::z_star);
  column("tau", &FractionalContact::tau);
  column("en", &FractionalContact::en);
  column("overlap_end", &FractionalContact::overlap_end);
  column("z_max_overlap", &FractionalContact::z_max_overlap);
  column("t_max_overlap", &FractionalContact::t_max_overlap);
  column("max_overlap", &FractionalContact::max_overlap);
  column("t_max_force", &FractionalContact::t_max_force);
  column("max_force", &FractionalContact::max_force);
  return columns;
}

void bind_kernel(py::module_& m) {
  const auto column = [](double Arm::*of) {
    return
        [of](const MemoryKernel& k) { return filled(k.arms().size(), [&](std::size_t i) { return k.arms()[i].*of; }); };
  };
  py::class_<MemoryKernel>(m, "MemoryKernel",
                           "The kernel t^(-alpha)/Gamma(1-alpha) of the Caputo derivative as a spring, Maxwell arms "
                           "strength*exp(-rate*t) and a dashpot, every coefficient positive.")
      .def_property_readonly("alpha", &MemoryKernel::alpha)
      .def_property_readonly("shortest", &MemoryKernel::shortest, "[s]")
      .def_property_readonly("longest", &MemoryKernel::longest, "[s]")
      .def_property_readonly("spring", &MemoryKernel::spring, "[s^(-alpha)]")
      .def_property_readonly("dashpot", &MemoryKernel::dashpot, "[s^(1-alpha)]")
      .def_property_readonly("error", &MemoryKernel::error, "largest relative error on [shortest, longest]")
      .def_property_readonly("strengths", column(&Arm::strength), "of the arms [s^(-alpha)]")
      .def_property_readonly("rates", column(&Arm::rate), "of the arms [1/s]")
      .def(
          "__call__",
          [](const MemoryKernel& k, const Array& times) {
            return py::vectorize([&k](double t) {
              support::require_not_negative("t", t);
              return k(t);
            })(times);
          },
          py::arg("t"), "Spring and arms at t >= 0 [s].");
  m.def(
      "memory_kernel",
      [](double alpha, double shortest, double longest, double tolerance) {
        return memory_kernel(alpha, shortest, longest, tolerance);
      },
      py::call_guard<py::gil_scoped_release>(), py::arg("alpha"), py::arg("shortest"), py::arg("longest"),
      py::arg("tolerance") = 1e-8,
      "The kernel with the fewest arms that keeps the relative error `tolerance` (1e-12 to 0.1) between the times "
      "`shortest` and `longest` [s], at most 1e6 times longer, for 0 <= alpha <= 1.");
}

}  // namespace

void bind_fractional(py::module_& m) {
  m.def("_mittag_leffler", [](const Array& a, const Array& b, const Array& x, const Shape& shape) {
    require_one_length(x, a, b);
    const auto all_a = view(a), all_b = view(b), all_x = view(x);
    return each_value(all_x.size(), shape, [&](std::size_t i) { return mittag_leffler(all_a[i], all_b[i], all_x[i]); });
  });
  py::class_<MittagLeffler>(m, "MittagLeffler", "E_{a,b} prepared for many x at one (a, b).")
      .def(py::init<double, double>(), py::arg("a"), py::arg("b"))
      .def_property_readonly("a", &MittagLeffler::a)
      .def_property_readonly("b", &MittagLeffler::b)
      .def("__call__", py::vectorize(&MittagLeffler::operator()), py::arg("x"));
  m.def("_fractional_contact", &contacts);
  m.def("_conversion_degree", [](const Array& en, const std::string& word, const Shape& shape) {
    const ContactEnd end = end_of(word);
    const auto all = view(en);
    return each_value(all.size(), shape, [&](std::size_t i) { return conversion_degree(all[i], end); });
  });
  m.def("_tcol_estimate", [](const Array& coefficient, const Array& alpha, const Shape& shape) {
    require_one_length(coefficient, alpha);
    const auto all = view(coefficient), alphas = view(alpha);
    return each_value(all.size(), shape, [&](std::size_t i) { return tcol_estimate(all[i], alphas[i]); });
  });
  bind_kernel(m);
}

}  // namespace ricochet::python
