#include "bindings.hpp"

#include <ricochet/motion/cluster.hpp>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ricochet::python {
namespace {

void bind_walls(py::module_& m) {
  const Array still = array_of(Vec3{});
  py::class_<Wall>(m, "Wall", "What spheres meet besides each other, of infinite mass.")
      .def_static(
          "plane",
          [](const Array& point, const Array& inward, std::size_t material, const Array& velocity) {
            return Wall{.point = vec3_of(point),
                        .inward = vec3_of(inward),
                        .material = material,
                        .motion = {.velocity = vec3_of(velocity)}};
          },
          py::arg("point"), py::arg("inward"), py::arg("material") = 0, py::arg("velocity") = still,
          "A plane through `point` [m]; spheres are on the side of `inward`.")
      .def_static(
          "cylinder",
          [](const Array& point, const Array& axis, double radius, std::size_t material, double spin) {
            return Wall{.point = vec3_of(point),
                        .inward = vec3_of(axis),
                        .material = material,
                        .form = surface::Cylinder{radius},
                        .motion = {.spin = spin}};
          },
          py::arg("point"), py::arg("axis"), py::arg("radius"), py::arg("material") = 0, py::arg("spin") = 0.0,
          "The inside of a cylinder without end, radius [m], that spins about its axis [1/s].")
      .def("__repr__", shown<Wall>([](const Wall& w) {
             const auto* cylinder = std::get_if<surface::Cylinder>(&w.form);
             const std::pair point("point", vector_of(w.point)),
                 direction(cylinder ? "axis" : "inward", vector_of(w.inward));
             const std::pair material("material", w.material);
             if (cylinder)
               return described("Wall.cylinder", point, direction, std::pair("radius", cylinder->radius), material,
                                std::pair("spin", w.motion.spin));
             return described("Wall.plane", point, direction, material,
                              std::pair("velocity", vector_of(w.motion.velocity)));
           }));
  m.def(
      "box_walls",
      [](const Array& low, const Array& high, std::size_t material) {
        return box_walls(vec3_of(low), vec3_of(high), material);
      },
      py::arg("low"), py::arg("high"), py::arg("material") = 0, "The six walls of a box, spheres inside [m].");
}

std::string end_word(const Interaction& i) { return i.end == ContactEnd::force ? "force" : "overlap"; }

void bind_interaction(py::module_& m) {
  py::class_<Interaction>(m, "Interaction", "How two materials meet.")
      .def(py::init([](const py::object& law, const TangentialContact& tangential, const std::string& end) {
             return Interaction{.law = law_of(law),
                                .friction = tangential.friction,
                                .end = end_of(end),
                                .tangential = tangential.law,
                                .torsion = tangential.torsion,
                                .rolling = tangential.rolling};
           }),
           py::arg("law"), py::arg("tangential") = TangentialContact{}, py::arg("end") = "force")
      .def_property_readonly("end", &end_word, "force or overlap")
      .def("__repr__", shown<Interaction>([](const Interaction& i) {
             return "<" +
                    described(
                        "Interaction", std::pair("law", std::string(i.law.name())),
                        std::pair("tangential", TangentialContact{i.tangential, i.friction, i.torsion, i.rolling}),
                        std::pair("end", end_word(i))) +
                    ">";
           }));
}

/// Rows of equal number, one a sphere.
std::vector<Sphere> spheres(const Array& positions, const Array& radii, const Array& densities, const Array& velocities,
                            const Array& spins, const std::vector<std::size_t>& materials) {
  const auto x = rows_of(positions), v = rows_of(velocities), w = rows_of(spins);
  const auto r = view(radii), rho = view(densities);
  std::vector<Sphere> out;
  out.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) out.push_back({r[i], rho[i], x[i], v[i], w[i], materials[i]});
  return out;
}

using Pairs = std::vector<std::pair<std::pair<std::size_t, std::size_t>, Interaction>>;

ClusterSetup setup(std::vector<Sphere> bodies, const Pairs& interactions, const std::vector<Wall>& walls,
                   const Array& gravity, const Array& period) {
  ClusterSetup out;
  out.spheres = std::move(bodies);
  out.walls = walls;
  out.gravity = vec3_of(gravity);
  for (const auto& [pair, interaction] : interactions)
    if (!out.interactions.insert({std::minmax(pair.first, pair.second), interaction}).second)
      throw std::invalid_argument("interactions: must have the materials " + std::to_string(pair.first) + " and " +
                                  std::to_string(pair.second) + " once");
  out.periodic = {vec3_of(period)};
  return out;
}

template <class F>
Array rows(const Cluster& cluster, const F& of) {
  std::vector<Vec3> all;
  all.reserve(cluster.size());
  for (std::size_t i = 0; i < cluster.size(); ++i) all.push_back(std::invoke(of, cluster, i));
  return array_of(all);
}

py::dict energies(const Cluster& cluster) {
  const ClusterEnergy e = cluster.energy();
  py::dict out;
  out["kinetic"] = e.kinetic;
  out["gravity"] = e.gravity;
  out["stored"] = e.stored;
  out["strained"] = e.strained;
  out["lost_normal"] = e.lost_normal;
  out["lost_friction"] = e.lost_friction;
  out["wall_work"] = e.wall_work;
  out["total"] = e.total();
  return out;
}

/// Pairs of bodies, walls counting from the number of spheres, overlap [m] and force [N].
py::dict contacts(const Cluster& cluster) {
  const auto& all = cluster.contacts();
  py::array_t<std::uint32_t> pairs({static_cast<py::ssize_t>(all.size()), py::ssize_t(2)});
  std::uint32_t* to = pairs.mutable_data();
  for (const ContactState& c : all) {
    *to++ = c.record.i;
    *to++ = c.record.j;
  }
  py::dict out;
  out["pairs"] = pairs;
  out["overlap"] = filled(all.size(), [&](std::size_t i) { return all[i].approach.overlap; });
  out["force"] = filled(all.size(), [&](std::size_t i) { return all[i].force; });
  return out;
}

py::list finished(Cluster& cluster) {
  py::list out;
  for (const Encounter& e : cluster.take_finished()) {
    py::dict one;
    one["i"] = e.i;
    one["j"] = e.j;
    one["begin"] = e.begin;
    one["end"] = e.end;
    one["separation"] = e.separation;
    one["how"] = std::string(name(e.how));
    out.append(one);
  }
  return out;
}

/// A cluster for Python's threads: while one is in a step no other may look. `moving_` is under Python's lock.
class GuardedCluster {
 public:
  explicit GuardedCluster(Cluster cluster) : cluster_(std::move(cluster)) {}

  Cluster& still() {
    if (moving_) throw std::runtime_error("the cluster is being advanced by another thread");
    return cluster_;
  }

  /// By portions, between which Ctrl-C is heard and a signal's handler may look.
  void advance(std::uint64_t steps) {
    constexpr std::uint64_t portion = 256;
    for (std::uint64_t left = steps; left > 0; left -= std::min(left, portion)) {
      if (!advance_at_once(std::min(left, portion)))
        throw std::runtime_error("a position or velocity is not finite: the step is too large");
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  }
  std::size_t size() const noexcept { return cluster_.size(); }

 private:
  bool advance_at_once(std::uint64_t steps) {
    Cluster& cluster = still();
    const Moving moving(moving_);
    const py::gil_scoped_release others_go_on;
    return cluster.advance(steps);
  }

  class Moving {
   public:
    explicit Moving(bool& flag) : flag_(flag) { flag_ = true; }
    Moving(const Moving&) = delete;
    Moving& operator=(const Moving&) = delete;
    ~Moving() { flag_ = false; }

   private:
    bool& flag_;
  };
  Cluster cluster_;
  bool moving_ = false;
};

/// What a cluster that nobody advances tells.
template <class F>
auto told(F of) {
  return [of](GuardedCluster& guarded) { return of(guarded.still()); };
}

}  // namespace

void bind_cluster(py::module_& m) {
  bind_walls(m);
  bind_interaction(m);
  py::class_<GuardedCluster>(m, "_Cluster")
      .def(py::init([](const Array& positions, const Array& radii, const Array& densities, const Array& velocities,
                       const Array& spins, const std::vector<std::size_t>& materials, const Pairs& interactions,
                       const std::vector<Wall>& walls, const Array& gravity, const Array& period, double step,
                       int threads, double solver_tolerance) {
        return GuardedCluster(Cluster(setup(spheres(positions, radii, densities, velocities, spins, materials),
                                            interactions, walls, gravity, period),
                                      {.step = step, .solver_tolerance = solver_tolerance, .threads = threads}));
      }))
      .def("advance", &GuardedCluster::advance, py::arg("steps"))
      .def_property_readonly("time", told([](const Cluster& c) { return c.time(); }))
      .def_property_readonly("steps", told([](const Cluster& c) { return c.steps(); }))
      .def("__len__", &GuardedCluster::size)
      .def_property_readonly("positions", told([](const Cluster& c) { return rows(c, &Cluster::position); }))
      .def_property_readonly("velocities", told([](const Cluster& c) { return rows(c, &Cluster::velocity); }))
      .def_property_readonly("spins", told([](const Cluster& c) { return rows(c, &Cluster::spin); }))
      .def_property_readonly("energy", told(&energies))
      .def_property_readonly("momentum", told([](const Cluster& c) { return array_of(c.momentum()); }))
      .def_property_readonly("angular_momentum", told([](const Cluster& c) { return array_of(c.angular_momentum()); }))
      .def_property_readonly("contacts", told(&contacts))
      .def("take_finished", told(&finished));
  m.def("_stiffest_contact", [](const Array& positions, const Array& radii, const Array& densities,
                                const Array& velocities, const Array& spins, const std::vector<std::size_t>& materials,
                                const Pairs& interactions, const std::vector<Wall>& walls, const Array& gravity) {
    return stiffest_contact(setup(spheres(positions, radii, densities, velocities, spins, materials), interactions,
                                  walls, gravity, array_of(Vec3{})))
        .tcol;
  });
}

}  // namespace ricochet::python
