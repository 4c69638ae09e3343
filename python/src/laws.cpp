#include "bindings.hpp"

#include <ricochet/contact/laws.hpp>

#include <cctype>
#include <optional>
#include <stdexcept>
#include <utility>

namespace ricochet::python {
namespace {

/// "kuwabara-kono" → "KuwabaraKono".
std::string class_name(std::string_view name) {
  std::string out;
  bool begins = true;
  for (const char c : name) {
    if (c != '-') out += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '-';
  }
  return out;
}

std::string described(const LawKind& kind) {
  std::string out = "Contact law " + std::string(kind.name()) + ":";
  for (const Parameter& p : kind.parameters()) {
    out += (out.back() == ':' ? " " : ", ") + std::string(p.name);
    if (!p.unit().empty()) out += " [" + p.unit() + "]";
    out += " " + std::string(p.domain.accepted);
  }
  return out + ".";
}

double number(const std::string& name, const py::handle& value) {
  try {
    return value.cast<double>();
  } catch (const py::cast_error&) {
    throw py::type_error(name + " = " + repr_of(value) + ": must be a number");
  }
}

/// The values of a law's parameters as a call gave them, by place or by name.
std::vector<double> values_of(const LawKind& kind, const py::args& args, const py::kwargs& kwargs) {
  const auto parameters = kind.parameters();
  if (args.size() + kwargs.size() != parameters.size())
    throw std::invalid_argument(std::to_string(args.size() + kwargs.size()) + " parameters: must be " +
                                std::to_string(parameters.size()) + ". " + described(kind));
  std::vector<double> values;
  values.reserve(parameters.size());
  for (const auto& arg : args) values.push_back(number(std::string(parameters[values.size()].name), arg));
  for (std::size_t i = values.size(); i < parameters.size(); ++i) {
    const std::string name(parameters[i].name);
    if (!kwargs.contains(name)) throw std::invalid_argument(name + ": missing: must be given. " + described(kind));
    values.push_back(number(name, kwargs[name.c_str()]));
  }
  return values;
}

std::string text_of(const AnyLaw& law) {
  std::string out = class_name(name(law));
  for (const NamedValue& p : parameters(law))
    out += (out.back() == ')' || out.find('(') != std::string::npos ? ", " : "(") + p.name + "=" + spelled(p.value);
  return out + ")";
}

template <class Law>
py::object bind(py::module_& m) {
  const LawKind kind = kind_of<Law>;
  auto c = py::class_<Law>(m, class_name(Law::name).c_str(), described(kind).c_str());
  c.def(py::init([kind](const py::args& args, const py::kwargs& kwargs) {
    return std::get<Law>(kind.with(values_of(kind, args, kwargs)));
  }));
  for (std::size_t i = 0; i < Law::parameters.size(); ++i)
    c.def_property_readonly(
        std::string(Law::parameters[i].name).c_str(), [i](const Law& law) { return law.values()[i]; },
        Law::parameters[i].unit().c_str());
  c.attr("name") = std::string(Law::name);
  c.def_property_readonly("parameters", [](const Law& law) {
    py::dict out;
    for (const NamedValue& p : parameters(AnyLaw(law))) out[p.name.c_str()] = p.value;
    return out;
  });
  c.def_property_readonly_static("units", [](const py::object&) {
    py::dict out;
    for (const Parameter& p : Law::parameters) out[std::string(p.name).c_str()] = p.unit();
    return out;
  });
  c.def("__repr__", shown<Law>([](const Law& law) { return text_of(law); }));
  c.def("__eq__", [](const Law& law, const py::object& other) {
    return py::isinstance<Law>(other) && other.cast<const Law&>().values() == law.values();
  });
  c.def("__hash__", [](const Law& law) {
    return py::hash(py::make_tuple(std::string(Law::name), py::tuple(py::cast(law.values()))));
  });
  c.def(py::pickle([](const Law& law) { return py::tuple(py::cast(law.values())); },
                   [](const py::tuple& state) { return Law::from(py::cast<ParameterValues<Law>>(state)); }));
  return c;
}

}  // namespace

AnyLaw law_of(const py::handle& object) {
  std::optional<AnyLaw> law;
  for (const LawKind kind : LawKind::all())
    kind.visit([&]<class Law>(std::type_identity<Law>) {
      if (py::isinstance<Law>(object)) law = object.cast<const Law&>();
    });
  if (law) return *law;
  throw py::type_error("law = " + repr_of(object) + ": must be a contact law, Linear(k, c) or so");
}

py::object object_of(const AnyLaw& law) {
  return std::visit([](const auto& one) { return py::cast(one); }, law);
}

void bind_laws(py::module_& m) {
  py::list names, classes;
  for (const LawKind kind : LawKind::all()) {
    kind.visit([&]<class Law>(std::type_identity<Law>) { classes.append(bind<Law>(m)); });
    names.append(std::string(kind.name()));
  }
  m.attr("law_names") = py::tuple(names);
  m.attr("Law") = py::module_::import("typing").attr("Union")[py::tuple(classes)];
  m.def(
      "law",
      [](const std::string& name, const py::kwargs& kwargs) {
        const auto kind = LawKind::named(name);
        if (!kind) throw std::invalid_argument("law = " + name + ": must be one of law_names");
        return object_of(kind->with(values_of(*kind, py::tuple(), kwargs)));
      },
      py::arg("name"), "The law of that name with these parameters: law(\"linear\", k=1e4, c=0.1).");
}

}  // namespace ricochet::python
