#include "deck.hpp"

#include <ricochet/motion/cluster.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace engines;

namespace {

// Figs. 7-9 of the paper, data/scenes/five_spheres_strong.json and _weak.json, without friction.
constexpr double duration = 0.04, k = 1000, c = 1;
const Box box{{-0.4, -0.3, -0.3}, {0.4, 0.5, 0.5}};

struct Motion {
  const char* name;
  double alpha;
};

std::vector<Grain> five_spheres() {
  return {{.radius = 0.02, .density = 2000, .position = {0, 0.1, 0.23}, .velocity = {0, 0, -5}},
          {.radius = 0.01, .density = 2000, .position = {0.001, 0.125, 0.205}},
          {.radius = 0.007, .density = 1000, .position = {-0.002, 0.09, 0.198}},
          {.radius = 0.005, .density = 1000, .position = {-0.004, 0.12, 0.186}},
          {.radius = 0.009, .density = 1000, .position = {-0.001, 0.1, 0.18}}};
}

std::vector<Vector> velocities_in_cluster(double alpha, double step) {
  ricochet::ClusterSetup setup;
  for (const Grain& g : five_spheres())
    setup.spheres.push_back({g.radius,
                             g.density,
                             {g.position[0], g.position[1], g.position[2]},
                             {g.velocity[0], g.velocity[1], g.velocity[2]}});
  setup.interactions.emplace(std::pair{0, 0}, ricochet::Interaction{ricochet::Fractional(k, c, alpha)});
  ricochet::ClusterOptions options;
  options.step = step;
  options.longest_contact = duration;
  ricochet::Cluster cluster(setup, options);
  REQUIRE(cluster.advance(static_cast<std::uint64_t>(std::llround(duration / step))));
  std::vector<Vector> velocity;
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    const auto v = cluster.velocity(i);
    velocity.push_back({v.x, v.y, v.z});
  }
  return velocity;
}

std::vector<Vector> velocities_in_engine(const Motion& motion, double dt) {
  const int steps = static_cast<int>(std::lround(duration / dt));
  const Workplace place(std::string("five_spheres_") + motion.name + "_" + std::to_string(steps));
  const std::string law = parameters(k, c, motion.alpha);
  REQUIRE(place.run(preamble(box) + place.create(five_spheres(), box) + neighbours("0.005") +
                    one_law(law, memory(duration)) + move(dt) + dump("dump", steps) + run(steps)) == 0);
  return place.frames("dump").back().velocity;
}

double largest_distance(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]));
  return worst;
}

}  // namespace

TEST_CASE("the paper's five spheres fly on as our own cluster has them") {
  for (const Motion& motion : {Motion{"strong", 0.01}, Motion{"weak", 0.97}}) {
    const auto exact = velocities_in_cluster(motion.alpha, 1e-6);
    std::printf("five spheres, %s: our own two steps differ by %.1e m/s\n", motion.name,
                largest_distance(exact, velocities_in_cluster(motion.alpha, 2e-6)));
    std::vector<double> errors;
    for (double dt : {4e-5, 2e-5, 1e-5, 5e-6}) {
      errors.push_back(largest_distance(exact, velocities_in_engine(motion, dt)));
      std::printf("five spheres, %s, step %g s: velocities within %.2e m/s\n", motion.name, dt, errors.back());
    }
    const double order = std::log2(errors[1] / errors[3]) / 2;
    std::printf("five spheres, %s: order %.2f\n", motion.name, order);
    // Of second order: the shortest contact, 2 ms, takes 400 such steps, and the impact comes at 5 m/s.
    CHECK(errors[3] <= 5. / (400 * 400));
    CHECK(order == Approx(2).margin(0.5));
  }
}
