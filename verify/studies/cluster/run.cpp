#include "run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet::verify::cluster {

ClusterSetup five_spheres(Choice choice) {
  constexpr paper::FiveSpheres five = paper::five_spheres;
  ClusterSetup setup;
  for (const auto& ball : five.balls) {
    const auto& [x, y, z] = ball.position;
    setup.spheres.push_back({ball.radius, ball.density, {x, y, z}, {0, 0, ball.velocity_z}, {}, 0});
  }
  setup.interactions.insert({{0, 0},
                             {Fractional(choice.k, choice.c, choice.alpha),
                              Friction(five.mu_static, five.mu_dynamic, five.decay, five.rolling_arm)}});
  return setup;
}

namespace {

Sample sample(const ricochet::Cluster& c) {
  Sample s{c.time(), {}, {}, {}};
  for (std::size_t i = 0; i < 5; ++i)
    s.position[i] = c.position(i), s.velocity[i] = c.velocity(i), s.spin[i] = c.spin(i);
  return s;
}

// What is watched at every step.
class Watch {
 public:
  Watch(const ricochet::Cluster& c, const ClusterSetup& setup)
      : momentum_(c.momentum()),
        angular_(c.angular_momentum()),
        total_(c.energy().total()),
        least_(c.energy().mechanical()) {
    for (const Sphere& s : setup.spheres) {
      momentum_scale_ += s.mass() * norm(s.velocity);
      angular_scale_ += s.mass() * norm(s.position) * norm(s.velocity);
    }
  }

  void operator()(const ricochet::Cluster& c, Run& run) {
    const ClusterEnergy e = c.energy();
    run.momentum_drift = std::max(run.momentum_drift, norm(c.momentum() - momentum_) / momentum_scale_);
    run.angular_drift = std::max(run.angular_drift, norm(c.angular_momentum() - angular_) / angular_scale_);
    run.energy_drift = std::max(run.energy_drift, std::abs(e.total() / total_ - 1));
    run.energy_growth = std::max(run.energy_growth, (e.mechanical() - least_) / total_);
    run.kinetic_left = e.kinetic / total_;
    least_ = std::min(least_, e.mechanical());
  }

 private:
  Vec3 momentum_, angular_;
  double total_, least_, momentum_scale_ = 0, angular_scale_ = 0;
};

}  // namespace

Run run(Choice choice, double duration, double step, double sample_interval) {
  const auto every = static_cast<std::uint64_t>(std::ceil(sample_interval / step - 1e-9));
  const double h = sample_interval / static_cast<double>(every);
  const ClusterSetup setup = five_spheres(choice);
  // No contact outlasts the run; the kernel reaches as far.
  ricochet::Cluster cluster(setup,
                            {.step = h, .longest_contact = std::min(duration, 4e5 * h), .solver_tolerance = 1e-13});
  Run run{.law = choice, .step = h, .samples = {sample(cluster)}, .collisions = {}};
  Watch watch(cluster, setup);
  const auto steps = static_cast<std::uint64_t>(std::llround(duration / h));
  for (std::uint64_t n = 1; n <= steps; ++n) {
    cluster.step();
    watch(cluster, run);
    for (const Encounter& e : cluster.take_finished()) run.collisions.push_back(e);
    if (n % every == 0) run.samples.push_back(sample(cluster));
  }
  run.kernel_error = cluster.kernel_error();
  for (const ContactState& c : cluster.contacts()) run.collisions.push_back(c.record);
  std::sort(run.collisions.begin(), run.collisions.end(),
            [](const Encounter& a, const Encounter& b) { return a.begin < b.begin; });
  return run;
}

std::string pair_name(const Encounter& e) { return fmt::format("{}-{}", e.i + 1, e.j + 1); }

const Encounter* collision_of(const Run& run, std::uint32_t i, std::uint32_t j) {
  for (const Encounter& e : run.collisions)
    if (e.i == i && e.j == j) return &e;
  return nullptr;
}

Vec3 local_spin(const Sample& sample, std::size_t i, std::size_t j) {
  const Vec3 branch = sample.position[j] - sample.position[i], normal = branch / norm(branch);
  const Vec3 xi = Vec3{-normal.y, normal.x, 0} / std::hypot(normal.x, normal.y), eta = cross(normal, xi);
  const Vec3 spin = sample.spin[i];
  return {dot(spin, xi), dot(spin, eta), dot(spin, normal)};
}

double tangential(Vec3 local) { return std::hypot(local.x, local.y); }

std::vector<LocalSpin> spins_against(const Run& run, std::uint32_t i, std::uint32_t j) {
  std::vector<LocalSpin> spins;
  if (const Encounter* e = collision_of(run, i, j))
    for (const Sample& s : run.samples)
      if (s.time >= e->begin && s.time <= e->end) spins.push_back({s.time, local_spin(s, i, j)});
  return spins;
}

double greatest_tangential(const Run& run, std::uint32_t i, std::uint32_t j) {
  double greatest = 0;
  for (const LocalSpin& s : spins_against(run, i, j)) greatest = std::max(greatest, tangential(s.spin));
  return greatest;
}

Overlap overlap(const std::vector<Encounter>& collisions, double until) {
  std::vector<std::pair<double, int>> events;
  double sum = 0;
  for (const Encounter& c : collisions) {
    const double end = std::min(c.end, until);
    events.push_back({c.begin, 1});
    events.push_back({end, -1});
    sum += end - c.begin;
  }
  std::sort(events.begin(), events.end());
  Overlap o;
  double several = 0, last = 0;
  int pairs = 0;
  for (const auto& [time, change] : events) {
    if (pairs > 0) o.busy += time - last;
    if (pairs > 1) several += time - last;
    pairs += change, last = time;
    o.most_pairs = std::max(o.most_pairs, pairs);
  }
  if (collisions.empty()) return o;
  o.mean_duration = sum / static_cast<double>(collisions.size());
  o.shared = several / o.busy;
  o.mean_pairs = sum / o.busy;
  return o;
}

}  // namespace ricochet::verify::cluster
