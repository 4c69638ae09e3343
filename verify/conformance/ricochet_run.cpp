#include "ricochet_run.hpp"

#include <ricochet/motion/cluster.hpp>
#include <ricochet/version.hpp>

#include <console/exit.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::verify::conformance {

namespace {

constexpr std::size_t grains = 0, walls = 1;  // materials

Interaction interaction(const Meeting& meeting, const std::optional<TangentialContact>& tangential) {
  Interaction all{.law = meeting.law, .end = meeting.end};
  if (!tangential) return all;
  all.friction = tangential->friction, all.tangential = tangential->law;
  all.torsion = tangential->torsion, all.rolling = tangential->rolling;
  return all;
}

ClusterSetup setup_of(const Case& of, int steps) {
  ClusterSetup setup;
  for (const Body& b : of.start(steps))
    setup.spheres.push_back({b.radius, b.density(), b.position, b.velocity, b.spin, grains});
  for (const Plane& plane : of.walls) setup.walls.push_back({plane.point, plane.normal, walls});
  // Of bodies that never meet each other none is asked.
  const Meeting& pair = of.law ? *of.law : of.wall_law.value();
  setup.interactions.insert({{grains, grains}, interaction(pair, of.tangential)});
  if (of.wall_law) setup.interactions.insert({{grains, walls}, interaction(*of.wall_law, of.tangential)});
  setup.gravity = of.gravity;
  return setup;
}

bool is_of_first(const Encounter& e) { return e.i == 0; }

}  // namespace

Run run_ricochet(const Case& of, int steps) {
  Cluster cluster(setup_of(of, steps), {.step = of.step(steps)});
  Run run{steps, of.bodies};
  std::optional<double> deepest;
  for (long n = 0; n < of.steps_of_run(steps); ++n) {
    cluster.step();
    for (const ContactState& c : cluster.contacts())
      if (c.record.i == 0) deepest = std::max(deepest.value_or(0), c.approach.overlap);
    for (const Encounter& e : cluster.take_finished())
      if (is_of_first(e) && !run.contact_time) run.contact_time = e.end - e.begin;
  }
  run.max_overlap = deepest;
  for (std::size_t i = 0; i < run.bodies.size(); ++i) {
    Body& b = run.bodies[i];
    b.position = cluster.position(i), b.velocity = cluster.velocity(i), b.spin = cluster.spin(i);
  }
  return run;
}

Results run_ricochet(const std::vector<Case>& cases) {
  Results results{"Ricochet", std::string(ricochet::version), "", "verify conformance --run ricochet"};
  console::Progress progress("verify conformance", cases.size());
  for (const Case& of : cases) {
    CaseResult result{of.name};
    for (const int steps : of.steps) result.runs.push_back(run_ricochet(of, steps));
    results.cases.push_back(std::move(result));
    progress.advance();
  }
  return results;
}

}  // namespace ricochet::verify::conformance
