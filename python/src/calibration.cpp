#include "bindings.hpp"

#include <calibrate/direct_calibrator.hpp>
#include <calibrate/fit.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace ricochet::python {
namespace {

using namespace calibration;

LawKind kind_named(const std::string& name) {
  if (const auto kind = LawKind::named(name)) return *kind;
  throw std::invalid_argument("law = " + name + ": must be one of law_names");
}

/// What is to be held; nothing may be given that the law does not hold.
Held held_by(LawKind kind, bool stiffness, std::optional<double> alpha, std::optional<double> stiffening) {
  const std::string law(kind.name());
  const auto refuse = [](const char* what, std::optional<double> value, const std::string& why) {
    if (value) throw std::invalid_argument(what + (" = " + spelled(*value)) + ": " + why);
  };
  const bool follows = stiffness && kind == kind_of<FractionalKelvinVoigt>;
  if (stiffness && kind != kind_of<Fractional> && !follows)
    throw std::invalid_argument("stiffness: law " + law + " holds none");
  if (follows) refuse("alpha", alpha, "follows from the stiffness");
  if (!holds_degree(kind)) refuse("alpha", alpha, "law " + law + " holds none");
  if (kind != kind_of<FractionalZener>) refuse("stiffening", stiffening, "law " + law + " holds none");
  return {alpha.value_or(Held{}.alpha), stiffening.value_or(Held{}.stiffening)};
}

/// Columns of equal length, one row a target; stiffness not a number: none.
struct Targets {
  std::span<const double> tcol, en, velocity, mass_eff, stiffness;
  Held held;

  Request request(LawKind kind, ContactEnd end, std::size_t i) const {
    Request r{.law = kind, .end = end, .target = {tcol[i], en[i], {velocity[i], mass_eff[i]}}, .held = held};
    if (!std::isnan(stiffness[i])) r.stiffness = stiffness[i];
    return r;
  }
};

/// The law's parameters, one array each. What can't be reached is nan where `skip`, else thrown.
class Solved {
 public:
  Solved(LawKind kind, std::size_t count) : kind_(kind) {
    for (std::size_t p = 0; p < kind.parameters().size(); ++p) {
      columns_.push_back(Array(static_cast<py::ssize_t>(count)));
      to_.push_back(columns_.back().mutable_data());
    }
  }
  void put(std::size_t i, const DirectCalibrator::Answer& answer, bool skip) {
    if (const auto* law = std::get_if<AnyLaw>(&answer))
      std::visit(
          [&](const auto& one) {
            const auto values = one.values();
            for (std::size_t p = 0; p < values.size(); ++p) to_[p][i] = values[p];
          },
          *law);
    else if (skip)
      for (double* column : to_) column[i] = std::numeric_limits<double>::quiet_NaN();
    else
      throw std::domain_error(text_of(std::get<Infeasible>(answer)));
  }
  py::dict columns() const {
    py::dict out;
    for (std::size_t p = 0; p < columns_.size(); ++p)
      out[std::string(kind_.parameters()[p].name).c_str()] = columns_[p];
    return out;
  }

 private:
  LawKind kind_;
  std::vector<Array> columns_;
  std::vector<double*> to_;
};

py::dict calibrate_all(const DirectCalibrator& calibrator, const std::string& law, const std::string& end,
                       const Array& tcol, const Array& en, const Array& velocity, const Array& mass_eff,
                       const Array& stiffness, std::optional<double> alpha, std::optional<double> stiffening, bool skip,
                       const Shape& shape) {
  const LawKind kind = kind_named(law);
  const ContactEnd ends = end_of(end);
  require_one_length(tcol, en, velocity, mass_eff, stiffness);
  const auto k = view(stiffness);
  const bool any = std::any_of(k.begin(), k.end(), [](double one) { return !std::isnan(one); });
  const Held held = held_by(kind, any, alpha, stiffening);
  const Targets targets{view(tcol), view(en), view(velocity), view(mass_eff), k, held};
  Solved solved(kind, targets.en.size());
  each_one(targets.en.size(), shape,
           [&](std::size_t i) { solved.put(i, calibrator(targets.request(kind, ends, i)), skip); });
  return solved.columns();
}

/// A standard error that is given is one; 0 would mean that it is not known.
void require_errors(const char* name, const Array& column) {
  for (const double error : view(column))
    if (!(error > 0)) throw std::invalid_argument(name + (" = " + spelled(error)) + ": must be > 0");
}

/// A column that was not measured is empty.
std::vector<Measurement> measurements(const Array& velocity, const Array& en, const Array& en_sigma, const Array& tcol,
                                      const Array& tcol_sigma) {
  for (const Array* column : {&en, &en_sigma, &tcol, &tcol_sigma})
    if (column == &en || column->size() > 0) require_one_length(velocity, *column);
  require_errors("en_sigma", en_sigma);
  require_errors("tcol_sigma", tcol_sigma);
  const auto v = view(velocity), e = view(en), s = view(en_sigma), t = view(tcol), ts = view(tcol_sigma);
  const auto at = [](std::span<const double> column, std::size_t i) { return column.empty() ? 0.0 : column[i]; };
  std::vector<Measurement> rows;
  rows.reserve(v.size());
  for (std::size_t i = 0; i < v.size(); ++i)
    rows.push_back({.velocity = v[i], .en = e[i], .en_sigma = at(s, i), .tcol = at(t, i), .tcol_sigma = at(ts, i)});
  return rows;
}

void bind_fit(py::module_& m) {
  py::class_<Estimate>(m, "Estimate", "A fitted parameter with its standard error.")
      .def_readonly("name", &Estimate::name, "of the parameter")
      .def_readonly("value", &Estimate::value, "[unit]")
      .def_readonly("error", &Estimate::error, "its standard error [unit]")
      .def_readonly("unit", &Estimate::unit, "of both, \"\" of a number")
      .def("__repr__", shown<Estimate>([](const Estimate& e) {
             return "<" +
                    described("Estimate", std::pair("name", e.name), std::pair("value", e.value),
                              std::pair("error", e.error), std::pair("unit", e.unit)) +
                    ">";
           }));
  py::class_<Fit>(m, "Fit", "A weighted least-squares fit of one law to measured rebounds.")
      .def_property_readonly(
          "name", [](const Fit& fit) { return fit_name(fit.request); }, "the law's, and its end's")
      .def_property_readonly(
          "parameters",
          [](const Fit& fit) {
            py::dict out;
            for (const Estimate& e : fit.parameters) out[e.name.c_str()] = e;
            return out;
          },
          "{name: Estimate}")
      .def_property_readonly(
          "correlations", [](const Fit& fit) { return py::cast(fit.correlations); },
          "of the estimates, one row a parameter")
      .def_readonly("chi2", &Fit::chi2, "sum of the squared weighted residuals")
      .def_readonly("observations", &Fit::observations, "numbers that were fitted")
      .def_readonly("freedom", &Fit::freedom, "observations less parameters")
      .def_readonly("errors_known", &Fit::errors_known,
                    "whether standard errors were given; else the scatter is theirs")
      .def_readonly("aic", &Fit::aic, "Akaike's criterion, of use beside another law's fit to the same data")
      .def_readonly("probability", &Fit::probability, "of a chi2 as great or greater, where errors are known")
      .def_readonly("findings", &Fit::findings, "what is to be known before the fit is used")
      .def(
          "predict_en",
          [](const Fit& fit, const Array& velocity) {
            return py::vectorize([&fit](double v) { return predict(fit, v).en; })(velocity);
          },
          py::arg("velocity"), "e_n that the fitted law has at these velocities [m/s].")
      .def("__repr__", shown<Fit>([](const Fit& fit) {
             std::string out = "<Fit(" + fit_name(fit.request) + ":";
             for (const Estimate& e : fit.parameters)
               out += " " + e.name + "=" + spelled(e.value) + "(" + spelled(e.error) + ")";
             return out + ", chi2=" + spelled(fit.chi2) + ", observations=" + std::to_string(fit.observations) + ")>";
           }));
  m.def("_fit", [](const std::string& law, const std::string& end, double mass_eff, const Array& velocity,
                   const Array& en, const Array& en_sigma, const Array& tcol, const Array& tcol_sigma) {
    const FitRequest request{.law = kind_named(law), .end = end_of(end), .mass_eff = mass_eff};
    const auto rows = measurements(velocity, en, en_sigma, tcol, tcol_sigma);
    const py::gil_scoped_release others_go_on;
    return fit_law(request, rows);
  });
}

}  // namespace

std::string text_of(const Infeasible& missed) {
  if (missed.quantity.empty()) return missed.reason;
  const std::string range = missed.lowest == missed.highest
                                ? spelled(missed.lowest)
                                : (missed.low_open ? "in (" : "in [") + spelled(missed.lowest) + ", " +
                                      spelled(missed.highest) + (missed.open ? ")" : "]");
  return missed.quantity + " = " + spelled(missed.asked) + ": must be " + range + ": " + missed.reason;
}

void bind_calibration(py::module_& m) {
  py::class_<DirectCalibrator>(m, "_DirectCalibrator").def(py::init<>()).def("__call__", &calibrate_all);
  py::register_exception<NotConverged>(m, "NotConverged", PyExc_RuntimeError);
  bind_fit(m);
}

}  // namespace ricochet::python
