#include "impact.hpp"

#include <array>
#include <stdexcept>

namespace ricochet::verify::benchmarks {

namespace {

// Overlaps and forces live half a step from each other's mean: the peak of the parabola through three values.
double peak(const std::array<double, 3>& y) {
  const double curvature = y[0] - 2 * y[1] + y[2], slope = 0.5 * (y[2] - y[0]);
  return curvature < 0 ? y[1] - 0.5 * slope * slope / curvature : y[1];
}

class Peak {
 public:
  void add(double value) {
    last_ = {last_[1], last_[2], value};
    if (++seen_ >= 3 && last_[1] >= last_[0] && last_[1] >= last_[2]) greatest_ = std::max(greatest_, peak(last_));
  }
  double greatest() const { return greatest_; }

 private:
  std::array<double, 3> last_{};
  int seen_ = 0;
  double greatest_ = 0;
};

}  // namespace

Meeting meet(const ClusterSetup& setup, double step) {
  constexpr int most_steps = 10'000'000;
  Cluster cluster(setup, {.step = step});
  Meeting meeting;
  Peak overlap, force;
  for (int n = 0; n < most_steps; ++n) {
    cluster.step();
    for (const ContactState& c : cluster.contacts()) {
      overlap.add(c.approach.overlap), force.add(c.force);
      if (c.approach.rate > 0) meeting.loading.emplace_back(c.approach.overlap, c.force);
    }
    for (const Encounter& e : cluster.take_finished()) {
      meeting.tcol = e.end - e.begin;
      meeting.greatest_overlap = overlap.greatest(), meeting.greatest_force = force.greatest();
      meeting.velocity = cluster.velocity(0), meeting.spin = cluster.spin(0);
      return meeting;
    }
  }
  throw std::runtime_error("a collision that does not end");
}

ClusterSetup against_wall(const Sphere& sphere, const Interaction& interaction) {
  ClusterSetup setup;
  setup.interactions.insert({{0, 0}, interaction});
  setup.spheres = {sphere};
  setup.spheres[0].position = {0, 0, sphere.radius};
  setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
  return setup;
}

ClusterSetup against_sphere(Sphere first, Sphere second, const Interaction& interaction) {
  ClusterSetup setup;
  setup.interactions.insert({{0, 0}, interaction});
  first.position = {-first.radius, 0, 0}, second.position = {second.radius, 0, 0};
  setup.spheres = {first, second};
  return setup;
}

}  // namespace ricochet::verify::benchmarks
