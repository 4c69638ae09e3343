#include "bindings.hpp"

#include <calibrate/export.hpp>
#include <calibrate/tangential.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

namespace ricochet::python {
namespace {

using namespace calibration;

py::object object_of(const TangentialLaw& law) {
  return std::visit([](const auto& one) { return py::cast(one); }, law);
}

py::object tangential_for(const std::string& form, const py::object& normal, double beta0, double tcol, double en,
                          double velocity, double mass_eff, const std::string& end) {
  const auto named = tangential_form(form);
  if (!named) throw std::invalid_argument("form = " + form + ": must be linear, linear-undamped or mindlin");
  const Target target{tcol, en, {velocity, mass_eff}};
  const auto found = calibrate_tangential({.form = *named, .beta0 = beta0}, law_of(normal), end_of(end), target);
  if (const auto* missed = std::get_if<Infeasible>(&found)) throw std::invalid_argument(missed->reason);
  return object_of(std::get<TangentialCalibration>(found).law);
}

Snippet snippet(const std::string& engine, const py::object& law, double tcol, double en, double velocity,
                double mass_eff, const std::string& end, std::optional<double> radius_eff,
                std::optional<double> density, const py::object& tangential, double mu) {
  const auto named = engine_named(engine);
  if (!named) throw std::invalid_argument("engine = " + engine + ": must be one of engine_names");
  ExportCase what{.law = law_of(law),
                  .end = end_of(end),
                  .tcol = tcol,
                  .en = en,
                  .impact = {velocity, mass_eff},
                  .radius_eff = radius_eff,
                  .density = density};
  if (!tangential.is_none()) what.tangential = TangentialPart{tangential_law_of(tangential), mu};
  return export_law(*named, what);
}

}  // namespace

void bind_exports(py::module_& m) {
  py::list names;
  for (const Engine engine : engines()) names.append(std::string(text(engine)));
  m.attr("engine_names") = py::tuple(names);
  py::class_<Snippet>(m, "Snippet", "A law in the language of an engine, ready to be included.")
      .def_property_readonly("engine", [](const Snippet& s) { return std::string(text(s.engine)); })
      .def_property_readonly(
          "fidelity", [](const Snippet& s) { return std::string(text(s.fidelity)); },
          "exact: the engine runs this very law; close: another one; absent: it can't")
      .def_readonly("remarks", &Snippet::remarks)
      .def_readonly("text", &Snippet::text);
  m.def(
      "export_law", &snippet, py::arg("engine"), py::arg("law"), py::kw_only(), py::arg("tcol"), py::arg("en"),
      py::arg("velocity") = 0.5, py::arg("mass_eff") = 7.06858e-6, py::arg("end") = "force",
      py::arg("radius_eff") = py::none(), py::arg("density") = py::none(), py::arg("tangential") = py::none(),
      py::arg("mu") = 0.0,
      "The law, calibrated for tcol [s] and en at this impact, in the language of one of engine_names; radius_eff [m] "
      "and density [kg/m^3] where an engine wants them.");
  m.def(
      "tangential_law_for", &tangential_for, py::arg("form"), py::arg("normal"), py::kw_only(), py::arg("beta0"),
      py::arg("tcol"), py::arg("en"), py::arg("velocity") = 0.5, py::arg("mass_eff") = 7.06858e-6,
      py::arg("end") = "force",
      "The tangential law (form linear, linear-undamped or mindlin) that beside this normal one makes a contact which "
      "sticks rebound with beta0 = -u_t'/u_t.");
}

}  // namespace ricochet::python
