#include "bindings.hpp"

#include <ricochet/collision/collision.hpp>

#include <limits>
#include <stdexcept>
#include <vector>

namespace ricochet::python {
namespace {

CollideMethod method_of(const std::string& word) {
  if (word == "automatic") return CollideMethod::automatic;
  if (word == "closed_form") return CollideMethod::closed_form;
  if (word == "numerical") return CollideMethod::numerical;
  throw std::invalid_argument("method = " + word + ": must be automatic, closed_form or numerical");
}

/// Of equally many velocities and masses.
py::dict collide_all(const py::object& object, const Array& velocity, const Array& mass_eff, const std::string& end,
                     const std::string& method, const Shape& shape) {
  const AnyLaw law = law_of(object);
  const CollideOptions options{.end = end_of(end), .method = method_of(method)};
  require_one_length(velocity, mass_eff);
  const auto v = view(velocity), m = view(mass_eff);
  std::vector<Collision> all;
  all.reserve(v.size());
  each_one(v.size(), shape, [&](std::size_t i) {
    all.push_back(without_zeros(collide(law, Impact{v[i], m[i]}, options)));
  });
  py::dict columns;
  py::list status;
  for (const Collision& c : all) status.append(text_of(c.status));
  columns["status"] = status;
  const auto column = [&](const char* name, double Collision::*of) { columns[name] = column_of(all, of); };
  column("tcol", &Collision::tcol);
  column("en", &Collision::en);
  column("max_overlap", &Collision::max_overlap);
  column("time_max_overlap", &Collision::time_max_overlap);
  column("max_force", &Collision::max_force);
  column("time_max_force", &Collision::time_max_force);
  column("overlap_end", &Collision::overlap_end);
  return columns;
}

}  // namespace

Collision without_zeros(Collision c) {
  const bool came_to_rest = c.status == CollisionStatus::permanent_contact || c.status == CollisionStatus::breakage;
  if (!c.separated() && !came_to_rest) c.tcol = c.en = c.overlap_end = std::numeric_limits<double>::quiet_NaN();
  return c;
}

std::string text_of(CollisionStatus status) {
  switch (status) {
    case CollisionStatus::ended_by_force: return "ended_by_force";
    case CollisionStatus::ended_by_overlap: return "ended_by_overlap";
    case CollisionStatus::permanent_contact: return "permanent_contact";
    case CollisionStatus::breakage: return "breakage";
    case CollisionStatus::no_separation: return "no_separation";
    case CollisionStatus::budget_spent: return "budget_spent";
    case CollisionStatus::out_of_range: break;
  }
  return "out_of_range";
}

std::string place_of(std::size_t i, const Shape& shape) {
  std::string out;
  for (std::size_t axis = shape.size(); axis > 0; i /= shape[--axis])
    out = std::to_string(i % shape[axis - 1]) + (out.empty() ? "" : ", ") + out;
  if (shape.size() > 1) out = "(" + out + ")";
  return out.empty() ? "" : "at index " + out + ": ";
}

ContactEnd end_of(const std::string& word) {
  if (word == "force") return ContactEnd::force;
  if (word == "overlap") return ContactEnd::overlap;
  throw std::invalid_argument("end = " + word + ": must be force or overlap");
}

Vec3 vec3_of(const Array& array) {
  if (array.size() != 3) throw std::invalid_argument("a vector has 3 numbers, not " + std::to_string(array.size()));
  const auto v = view(array);
  return {v[0], v[1], v[2]};
}

Array array_of(Vec3 v) {
  const double of[] = {v.x, v.y, v.z};
  return filled(3, [&](std::size_t i) { return of[i]; });
}

std::array<double, 3> vector_of(Vec3 v) { return {v.x, v.y, v.z}; }

std::vector<Vec3> rows_of(const Array& array) {
  if (array.ndim() != 2 || array.shape(1) != 3) throw std::invalid_argument("an array of vectors has the shape (n, 3)");
  std::vector<Vec3> rows(static_cast<std::size_t>(array.shape(0)));
  const auto v = view(array);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
  return rows;
}

Array array_of(std::span<const Vec3> rows) {
  Array out({static_cast<py::ssize_t>(rows.size()), py::ssize_t(3)});
  double* to = out.mutable_data();
  for (const Vec3& v : rows) {
    *to++ = v.x;
    *to++ = v.y;
    *to++ = v.z;
  }
  return out;
}

void bind_collision(py::module_& m) { m.def("_collide", &collide_all); }

}  // namespace ricochet::python
