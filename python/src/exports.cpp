#include "bindings.hpp"

#include <calibrate/export.hpp>
#include <calibrate/tangential.hpp>

#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

namespace ricochet::python {
namespace {

using namespace calibration;

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

/// What the law does, which is what was asked for, if anything was.
Collision obtained(const AnyLaw& law, const Impact& impact, ContactEnd end, std::optional<double> tcol,
                   std::optional<double> en) {
  constexpr double allowed = 1e-6;  // of a law whose parameters were printed
  const Collision c = collide(law, impact, {.end = end});
  if (!c.separated()) throw std::invalid_argument("law: the collision does not end, but by " + text_of(c.status));
  const auto compare = [](const char* name, std::optional<double> asked, double gives) {
    if (asked && !(std::abs(*asked / gives - 1) <= allowed))
      throw std::invalid_argument(name + (" = " + spelled(*asked)) + ": the law gives " + rounded(gives));
  };
  compare("tcol", tcol, c.tcol);
  compare("en", en, c.en);
  return c;
}

py::object tangential_for(const std::string& form, const py::object& normal, double beta0, double tcol, double en,
                          double velocity, double mass_eff, const std::string& end) {
  const auto named = tangential_form(form);
  if (!named) throw std::invalid_argument("form = " + form + ": must be linear, linear-undamped or mindlin");
  const Target target{tcol, en, {velocity, mass_eff}};
  obtained(law_of(normal), target.impact, end_of(end), tcol, en);
  const AnyLaw law = law_of(normal);
  const auto found = [&, ends = end_of(end)] {
    const py::gil_scoped_release others_go_on;
    return calibrate_tangential({.form = *named, .beta0 = beta0}, law, ends, target);
  }();
  if (const auto* missed = std::get_if<Infeasible>(&found)) throw std::invalid_argument(text_of(*missed));
  return object_of(std::get<TangentialCalibration>(found).law);
}

Snippet snippet(const std::string& engine, const py::object& object, std::optional<double> tcol,
                std::optional<double> en, double velocity, double mass_eff, const std::string& end,
                std::optional<double> radius_eff, std::optional<double> density, const py::object& tangential,
                std::optional<double> mu) {
  const auto named = engine_named(engine);
  if (!named) throw std::invalid_argument("engine = " + engine + ": must be one of engine_names");
  if (mu && tangential.is_none()) throw std::invalid_argument("mu = " + spelled(*mu) + ": must have a tangential law");
  if (!mu && !tangential.is_none()) throw std::invalid_argument("mu: must be given with a tangential law");
  const AnyLaw law = law_of(object);
  const Impact impact{velocity, mass_eff};
  const Collision gives = obtained(law, impact, end_of(end), tcol, en);
  ExportCase what{.law = law,
                  .end = end_of(end),
                  .tcol = tcol.value_or(gives.tcol),
                  .en = en.value_or(gives.en),
                  .impact = impact,
                  .radius_eff = radius_eff,
                  .density = density};
  if (!tangential.is_none()) what.tangential = TangentialPart{tangential_law_of(tangential), *mu};
  return export_law(*named, what);
}

}  // namespace

void bind_exports(py::module_& m) {
  py::list names;
  for (const Engine engine : engines()) names.append(std::string(text(engine)));
  m.attr("engine_names") = py::tuple(names);
  py::class_<Snippet>(m, "Snippet", "A law in the language of an engine, ready to be included.")
      .def_property_readonly(
          "engine", [](const Snippet& s) { return std::string(text(s.engine)); }, "one of engine_names")
      .def_property_readonly(
          "fidelity", [](const Snippet& s) { return std::string(text(s.fidelity)); },
          "exact: the engine runs this very law; close: another one; absent: it can't")
      .def_readonly("remarks", &Snippet::remarks, "what is to be known before it is used")
      .def_readonly("text", &Snippet::text, "lines of the engine's input")
      .def("__repr__", shown<Snippet>([](const Snippet& s) {
             return "<Snippet(" + std::string(text(s.engine)) + ", " + std::string(text(s.fidelity)) + ")>";
           }));
  m.def(
      "export_law", &snippet, py::arg("engine"), py::arg("law"), py::kw_only(), py::arg("tcol") = py::none(),
      py::arg("en") = py::none(), py::arg("velocity") = 0.5, py::arg("mass_eff") = 7.06858e-6, py::arg("end") = "force",
      py::arg("radius_eff") = py::none(), py::arg("density") = py::none(), py::arg("tangential") = py::none(),
      py::arg("mu") = py::none(),
      "The law in the language of one of engine_names; radius_eff [m] and density [kg/m^3] where an engine wants them. "
      "tcol [s] and en are what it was calibrated for at this impact; a law that gives others is a ValueError.");
  m.def(
      "tangential_law_for", &tangential_for, py::arg("form"), py::arg("normal"), py::kw_only(), py::arg("beta0"),
      py::arg("tcol"), py::arg("en"), py::arg("velocity") = 0.5, py::arg("mass_eff") = 7.06858e-6,
      py::arg("end") = "force",
      "The tangential law (form linear, linear-undamped or mindlin) that beside this normal one makes a contact which "
      "sticks rebound with beta0 = -u_t'/u_t.");
}

}  // namespace ricochet::python
