#include "bindings.hpp"

#include <ricochet/collision/oblique.hpp>
#include <ricochet/contact/tangential.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace ricochet::python {
namespace {

template <class Law>
py::class_<Law> bind_spring(py::module_& m, const char* name, const char* what) {
  return py::class_<Law>(m, name, what)
      .def(py::init<double, double>(), py::arg("k_t"), py::arg("c_t") = 0.0)
      .def_property_readonly("k_t", &Law::k_t)
      .def_property_readonly("c_t", &Law::c_t)
      .def("__repr__", shown<Law>([name](const Law& law) {
             return described(name, std::pair("k_t", law.k_t()), std::pair("c_t", law.c_t()));
           }));
}

void bind_parts(py::module_& m) {
  py::class_<Spring>(m, "Spring", "A spring and a dashpot side by side.")
      .def(py::init([](double stiffness, double damping) {
             return Spring{stiffness, damping};
           }),
           py::arg("stiffness") = 0.0, py::arg("damping") = 0.0)
      .def_readonly("stiffness", &Spring::stiffness, "[N/m, or N m]")
      .def_readonly("damping", &Spring::damping, "[N s/m, or N m s]")
      .def("__repr__", shown<Spring>([](const Spring& s) {
             return described("Spring", std::pair("stiffness", s.stiffness), std::pair("damping", s.damping));
           }));
  py::class_<Friction>(m, "Friction",
                       "mu(u) = mu_dynamic + (mu_static - mu_dynamic) exp(-decay u), Eq. (35); rolling_arm in contact "
                       "radii (46).")
      .def(py::init([](double mu_static, std::optional<double> mu_dynamic, double decay, double rolling_arm) {
             return Friction(mu_static, mu_dynamic.value_or(mu_static), decay, rolling_arm);
           }),
           py::arg("mu_static") = 0.0, py::arg("mu_dynamic") = py::none(), py::arg("decay") = 0.0,
           py::arg("rolling_arm") = 0.0)
      .def_property_readonly("mu_static", &Friction::mu_static)
      .def_property_readonly("mu_dynamic", &Friction::mu_dynamic)
      .def_property_readonly("decay", &Friction::decay, "[s/m]")
      .def_property_readonly("rolling_arm", &Friction::rolling_arm)
      .def("__repr__", shown<Friction>([](const Friction& f) {
             return described("Friction", std::pair("mu_static", f.mu_static()),
                              std::pair("mu_dynamic", f.mu_dynamic()), std::pair("decay", f.decay()),
                              std::pair("rolling_arm", f.rolling_arm()));
           }));
  py::class_<RigidTangential>(m, "RigidTangential", "The paper's friction: sticks, or slides at the limit.")
      .def(py::init<>())
      .def("__repr__", shown<RigidTangential>([](const RigidTangential&) { return described("RigidTangential"); }));
  bind_spring<LinearTangential>(m, "LinearTangential", "Spring and dashpot of constant k_t [N/m], c_t [N s/m].");
  bind_spring<MindlinTangential>(m, "MindlinTangential", "k_t sqrt(overlap), k_t = 8 G* sqrt(R*) [kg/(s^2 m^(1/2))].")
      .def_static("of", &MindlinTangential::of, py::arg("shear_modulus_eff"), py::arg("radius_eff"),
                  "By the effective shear modulus [Pa] and radius [m].");
}

Torsion torsion_of(const std::string& limit, const Spring& spring, double arm) {
  if (limit == "none" && (spring.stiffness != 0 || spring.damping != 0))
    throw std::invalid_argument("torsion_spring: must be given with torsion_limit separate or disc");
  if (limit == "none") return {};
  if (limit == "separate") return {Torsion::Limit::separate, spring, arm};
  if (limit == "disc") return {Torsion::Limit::disc, spring, arm};
  throw std::invalid_argument("torsion_limit = " + limit + ": must be none, separate or disc");
}

std::string word_of(Torsion::Limit limit) {
  if (limit == Torsion::Limit::none) return "none";
  return limit == Torsion::Limit::separate ? "separate" : "disc";
}

void bind_contact(py::module_& m) {
  py::class_<TangentialContact>(m, "TangentialContact",
                                "All that acts in the tangent plane of two materials. torsion_limit: none, separate "
                                "(a spring [N m] whose moment is at most torsion_arm [contact radii] mu F) or disc "
                                "(sliding and torsion share the limit of a disc); mu_rolling: a spring [N m] whose "
                                "moment is at most mu_rolling R* F.")
      .def(py::init([](const py::object& law, const Friction& friction, const std::string& torsion_limit,
                       const Spring& torsion_spring, double torsion_arm, double mu_rolling,
                       const Spring& rolling_spring) {
             TangentialContact contact{.law = tangential_law_of(law),
                                       .friction = friction,
                                       .torsion = torsion_of(torsion_limit, torsion_spring, torsion_arm),
                                       .rolling = {mu_rolling, rolling_spring}};
             if (mu_rolling == 0 && (rolling_spring.stiffness != 0 || rolling_spring.damping != 0))
               throw std::invalid_argument("rolling_spring: must be given with a mu_rolling > 0");
             check(contact);
             return contact;
           }),
           py::arg("law") = RigidTangential{}, py::arg("friction") = Friction(), py::kw_only(),
           py::arg("torsion_limit") = "none", py::arg("torsion_spring") = Spring{},
           py::arg("torsion_arm") = Torsion{}.arm, py::arg("mu_rolling") = 0.0, py::arg("rolling_spring") = Spring{})
      .def("__repr__", shown<TangentialContact>([](const TangentialContact& c) {
             return described("TangentialContact", std::pair("law", object_of(c.law)),
                              std::pair("friction", c.friction), std::pair("torsion_limit", word_of(c.torsion.limit)),
                              std::pair("torsion_spring", c.torsion.spring), std::pair("torsion_arm", c.torsion.arm),
                              std::pair("mu_rolling", c.rolling.mu), std::pair("rolling_spring", c.rolling.spring));
           }));
}

void bind_oblique(py::module_& m) {
  py::class_<ImpactBody>(m, "ImpactBody",
                         "A sphere, or a wall, at the first touch: mass [kg], radius [m], velocity [m/s], spin [1/s]; "
                         "inertia_ratio: its moment of inertia over mass radius^2, 0.4 of a solid sphere.")
      .def(py::init([](double mass, double radius, const Array& velocity, const Array& spin, double inertia_ratio) {
             return ImpactBody{mass, radius, vec3_of(velocity), vec3_of(spin), inertia_ratio};
           }),
           py::arg("mass"), py::arg("radius"), py::arg("velocity") = array_of(Vec3{}),
           py::arg("spin") = array_of(Vec3{}), py::arg("inertia_ratio") = 0.4)
      .def_static(
          "wall", [](const Array& velocity) { return ImpactBody::wall(vec3_of(velocity)); },
          py::arg("velocity") = array_of(Vec3{}), "Of infinite mass.")
      .def("__repr__", shown<ImpactBody>([](const ImpactBody& b) {
             const std::pair velocity("velocity", vector_of(b.velocity));
             const bool still = b.spin.x == 0 && b.spin.y == 0 && b.spin.z == 0;
             if (b.is_wall() && std::isinf(b.radius) && still) return described("ImpactBody.wall", velocity);
             return described("ImpactBody", std::pair("mass", b.mass), std::pair("radius", b.radius), velocity,
                              std::pair("spin", vector_of(b.spin)), std::pair("inertia_ratio", b.inertia_ratio));
           }));
}

py::dict losses(const ObliqueLosses& lost) {
  py::dict out;
  out["normal"] = lost.normal;
  out["dashpot"] = lost.dashpot;
  out["sliding"] = lost.sliding;
  out["torsion"] = lost.torsion;
  out["rolling"] = lost.rolling;
  out["stored"] = lost.stored;
  return out;
}

/// What C++ leaves at 0 where the bodies do not part is no number here.
ObliqueCollision of_an_end(ObliqueCollision c) {
  if (c.separated()) return c;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  c.et = c.beta = std::nullopt;
  for (Vec3* v : {&c.velocity_i, &c.velocity_j, &c.spin_i, &c.spin_j, &c.impulse}) *v = {none, none, none};
  c.impulse_ratio = c.stick_time = c.slip_time = none;
  c.lost = {none, none, none, none, none, none};
  return c;
}

py::dict collide_obliquely(const py::object& law, const TangentialContact& tangential, const ImpactBody& i,
                           const ImpactBody& j, const Array& direction, const std::string& end,
                           const std::string& arm) {
  if (arm != "radius" && arm != "contact_point")
    throw std::invalid_argument("arm = " + arm + ": must be radius or contact_point");
  const ObliqueOptions options{.end = end_of(end),
                               .arm = arm == "radius" ? ContactArm::radius : ContactArm::contact_point};
  const ObliqueCollision c =
      of_an_end(collide(law_of(law), tangential, ObliqueImpact{vec3_of(direction), i, j}, options));
  const Collision normal = without_zeros(c.normal);
  py::dict out;
  out["status"] = text_of(c.status);
  out["tcol"] = normal.tcol;
  out["en"] = normal.en;
  out["et"] = c.et;
  out["beta"] = c.beta;
  out["impulse_ratio"] = c.impulse_ratio;
  out["velocity_i"] = array_of(c.velocity_i);
  out["velocity_j"] = array_of(c.velocity_j);
  out["spin_i"] = array_of(c.spin_i);
  out["spin_j"] = array_of(c.spin_j);
  out["impulse"] = array_of(c.impulse);
  out["stick_time"] = c.stick_time;
  out["slip_time"] = c.slip_time;
  out["lost"] = losses(c.lost);
  return out;
}

}  // namespace

py::object object_of(const TangentialLaw& law) {
  return std::visit([](const auto& one) { return py::cast(one); }, law);
}

TangentialLaw tangential_law_of(const py::handle& object) {
  if (py::isinstance<RigidTangential>(object)) return object.cast<RigidTangential>();
  if (py::isinstance<LinearTangential>(object)) return object.cast<LinearTangential>();
  if (py::isinstance<MindlinTangential>(object)) return object.cast<MindlinTangential>();
  throw py::type_error("law = " + repr_of(object) + ": must be RigidTangential, LinearTangential or MindlinTangential");
}

void bind_tangential(py::module_& m) {
  bind_parts(m);
  bind_contact(m);
  bind_oblique(m);
  m.def("_collide_obliquely", &collide_obliquely);
}

}  // namespace ricochet::python
