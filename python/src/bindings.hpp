#pragma once

#include <calibrate/calibration.hpp>
#include <ricochet/collision/collision.hpp>
#include <ricochet/contact/tangential.hpp>
#include <ricochet/contact/vec3.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// The Python module `ricochet._core`: C++ names as they are, arrays flat. The package around it broadcasts and shapes.
namespace ricochet::python {

namespace py = pybind11;

/// Doubles side by side; other numbers are copied, and what is no real number is refused.
using Array = py::array_t<double, py::array::c_style>;

inline std::span<const double> view(const Array& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Throws std::invalid_argument unless all columns are as long as the first.
template <class... Columns>
void require_one_length(const Array& first, const Columns&... others) {
  if (((others.size() != first.size()) || ...)) throw std::invalid_argument("columns of different lengths");
}

/// One number for each of `count` cases, in an array of NumPy's.
template <class F>
Array filled(std::size_t count, const F& value) {
  Array out(static_cast<py::ssize_t>(count));
  double* to = out.mutable_data();
  for (std::size_t i = 0; i < count; ++i) to[i] = value(i);
  return out;
}

/// How the cases of a call are counted, by the shape of its arrays: none for numbers alone.
using Shape = std::vector<std::size_t>;

/// "at index (1, 2): " of case i as NumPy counts, "" for numbers alone.
std::string place_of(std::size_t i, const Shape& shape);

/// work(i), whose complaint about its input is told with the case's place.
template <class Work>
void one_of(const Shape& shape, std::size_t i, const Work& work) {
  try {
    work(i);
  } catch (const std::domain_error& e) {
    throw std::domain_error(place_of(i, shape) + e.what());
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument(place_of(i, shape) + e.what());
  } catch (const calibration::NotConverged& e) {
    throw calibration::NotConverged(place_of(i, shape) + e.what());
  }
}

/// work(i) for i = 0 … count − 1, while other threads of Python go on; Ctrl-C is heard some ten times a second.
template <class Work>
void each_one(std::size_t count, const Shape& shape, const Work& work) {
  using clock = std::chrono::steady_clock;
  constexpr std::size_t between_looks = 16;
  for (std::size_t i = 0; i < count;) {
    {
      const py::gil_scoped_release others_go_on;
      const auto until = clock::now() + std::chrono::milliseconds(100);
      do {
        for (const std::size_t to = std::min(count, i + between_looks); i < to; ++i) one_of(shape, i, work);
      } while (i < count && clock::now() < until);
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

/// A number of each case, as each_one makes them.
template <class F>
Array each_value(std::size_t count, const Shape& shape, const F& value) {
  Array out(static_cast<py::ssize_t>(count));
  double* to = out.mutable_data();
  each_one(count, shape, [&](std::size_t i) { to[i] = value(i); });
  return out;
}

/// One member of each of these.
template <class T>
Array column_of(const std::vector<T>& all, double T::*member) {
  return filled(all.size(), [&](std::size_t i) { return all[i].*member; });
}

/// "force" or "overlap". Throws std::invalid_argument for another word.
ContactEnd end_of(const std::string& word);

/// The law that an object of one of the classes stands for, and back. Throws py::type_error for another object.
AnyLaw law_of(const py::handle& object);
py::object object_of(const AnyLaw& law);

TangentialLaw tangential_law_of(const py::handle& object);
py::object object_of(const TangentialLaw& law);

std::string text_of(CollisionStatus status);
/// C++ leaves 0 where a collision came to no end; here that is not a number.
Collision without_zeros(Collision c);
/// As Python spells it.
std::string spelled(double value);

/// "en = 0.2: must be in [0.43, 1.0): " and the reason, the range where there is one.
std::string text_of(const calibration::Infeasible& missed);

template <class Value>
std::string repr_of(const Value& value) {
  if constexpr (std::is_base_of_v<py::handle, Value>)
    return py::repr(value).template cast<std::string>();
  else
    return py::repr(py::cast(value)).template cast<std::string>();
}

/// "Name(one=…, two=…)", each value as Python spells it.
template <class... Values>
std::string described(const char* name, const std::pair<const char*, Values>&... parts) {
  std::string out;
  ((out += (out.empty() ? "" : ", ") + std::string(parts.first) + "=" + repr_of(parts.second)), ...);
  return name + ("(" + out + ")");
}

/// Makes of T's description a __repr__, which may be asked of an object whose __init__ has not come to its end: it has
/// no T yet.
template <class T, class Describe>
auto shown(Describe describe) {
  return [describe](const py::object& self) -> std::string {
    auto* object = reinterpret_cast<py::detail::instance*>(self.ptr());
    if (!object->get_value_and_holder().holder_constructed())
      return "<" + py::type::of(self).attr("__name__").template cast<std::string>() + " without a value>";
    return describe(self.cast<const T&>());
  };
}

/// Three numbers.
Vec3 vec3_of(const Array& array);
Array array_of(Vec3 v);
std::array<double, 3> vector_of(Vec3 v);
/// One row a vector.
std::vector<Vec3> rows_of(const Array& array);
Array array_of(std::span<const Vec3> rows);

void bind_fractional(py::module_& m);
void bind_laws(py::module_& m);
void bind_collision(py::module_& m);
void bind_tangential(py::module_& m);
void bind_calibration(py::module_& m);
void bind_exports(py::module_& m);
void bind_cluster(py::module_& m);

}  // namespace ricochet::python
