#include "../../verify/studies/cluster/convergence.hpp"
#include "../../verify/studies/cluster/figures.hpp"
#include "../../verify/studies/cluster/run.hpp"
#include "../../verify/studies/cluster/sign.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::verify;
using namespace ricochet::verify::cluster;

namespace {

Sample sample_of(Vec3 branch, Vec3 spin) {
  Sample s;
  s.position[0] = {0.5, -0.25, 2};
  s.position[4] = s.position[0] + branch;
  s.spin[0] = spin;
  return s;
}

/// Spheres 1 and 5 collide from 1 to 3 s; the spin of 1 is its time, across the normal.
Run run_of_three() {
  Run run{.law = {0.5}, .step = 1, .samples = {}, .collisions = {{.i = 0, .j = 4, .begin = 1, .end = 3}}};
  for (double t = 0; t < 5; ++t) {
    run.samples.push_back(sample_of({0.3, 0, -0.4}, t * Vec3{0, 1, 0}));
    run.samples.back().time = t;
  }
  return run;
}

}  // namespace

TEST_CASE("a spin in a contact's frame keeps its length and its part along the normal") {
  const Vec3 branch{0.02, -0.03, -0.06}, spin{1.5, -0.5, 2};
  const Vec3 local = local_spin(sample_of(branch, spin), 0, 4);
  CHECK(norm(local) == Approx(norm(spin)).epsilon(1e-15));
  CHECK(local.z == Approx(dot(spin, branch) / norm(branch)).epsilon(1e-15));
  CHECK(tangential(local) == Approx(norm(cross(branch, spin)) / norm(branch)).epsilon(1e-15));
}

TEST_CASE("the frame (1)-(3): e_xi lies in the plane xy, e_eta completes it to the right") {
  // Normal (0.6, 0, -0.8): e_ξ = (0, 1, 0), e_η = e_ζ × e_ξ = (0.8, 0, 0.6).
  const Vec3 branch{0.3, 0, -0.4};
  const Vec3 xi = local_spin(sample_of(branch, {0, 1, 0}), 0, 4),
             eta = local_spin(sample_of(branch, {0.8, 0, 0.6}), 0, 4);
  CHECK(norm(xi - Vec3{1, 0, 0}) < 1e-15);
  CHECK(norm(eta - Vec3{0, 1, 0}) < 1e-15);
}

TEST_CASE("spins against a sphere are those of the samples during the collision") {
  const Run run = run_of_three();
  const auto spins = spins_against(run, 0, 4);
  REQUIRE(spins.size() == 3);
  CHECK(spins.front().time == 1);
  CHECK(spins.back().spin.x == Approx(3).epsilon(1e-15));
  CHECK(greatest_tangential(run, 0, 4) == Approx(3).epsilon(1e-15));
  CHECK(spins_against(run, 0, 3).empty());
  CHECK(collision_of(run, 0, 4) == run.collisions.data());
  CHECK(collision_of(run, 0, 3) == nullptr);
}

TEST_CASE("the bounds of an order are those of a power law with the others added or taken away") {
  // At h/4 the error is 1, of which ±s is the start's, h^{2−α}, and ±g the kernels', h⁰.
  const auto order = [](double alpha, double s, double g) {
    return 0.5 * std::log2((1 - s - g) * 16 + s * std::pow(4, 2 - alpha) + g);
  };
  for (const double alpha : {0.01, 0.5, 0.97})
    for (const double s : {0.0, 0.1, 0.6})
      for (const double g : {0.0, 0.02, 0.2}) {
        const auto [low, high] = velocity_orders(alpha, s, g);
        CHECK(low == Approx(order(alpha, s, g)).epsilon(1e-14));
        CHECK(high == Approx(order(alpha, -s, -g)).epsilon(1e-14));
      }
  CHECK(velocity_orders(0.97, 50, 0).first == Approx(2 - 0.97).epsilon(1e-14));
  CHECK(velocity_orders(0.97, 0, 0) == std::pair(2.0, 2.0));
  CHECK(std::isnan(velocity_orders(0.97, 0, 1.5).first));
}

namespace {

std::vector<std::string> fields_of(const std::string& csv, std::size_t line) {
  std::istringstream lines(csv);
  std::string text, field;
  for (std::size_t i = 0; i <= line; ++i) std::getline(lines, text);
  std::vector<std::string> fields;
  for (std::istringstream row(text); std::getline(row, field, ',');) fields.push_back(field);
  return fields;
}

}  // namespace

TEST_CASE("Figs. 7 and 8 draw the columns that they name, and tell the two states apart") {
  Run strong = run_of_three(), weak = run_of_three();
  strong.law = {0.01}, weak.law = {0.97};
  for (Sample& s : strong.samples) {
    s.position[2] = {1, 2 + s.time, 3 + s.time};
    s.velocity[0] = {4, 5, 6};
  }
  const auto ways = trajectories(strong, weak);
  const auto names = fields_of(ways.data[0].bytes, 0), first = fields_of(ways.data[0].bytes, 1);
  REQUIRE(names.size() == 1 + 5 * 9);
  REQUIRE(first.size() == names.size());
  // Sphere 3 is drawn from two columns of the file: those of its y and z.
  std::smatch columns;
  const std::string script = console::script_of(ways.plot);
  REQUIRE(std::regex_search(script, columns,
                            std::regex("'cluster-strong.csv' skip 1 using (\\d+):(\\d+) with [^\n]*title 'sphere 3'")));
  const std::size_t y = std::stoul(columns[1].str()), z = std::stoul(columns[2].str());
  CHECK(names.at(y - 1) == "y3 [m]");
  CHECK(names.at(z - 1) == "z3 [m]");
  CHECK(first.at(y - 1) == "2");
  CHECK(first.at(z - 1) == "3");

  const auto speeds = velocities(strong, weak);
  const std::string& spins = speeds.data[2].bytes;  // of three samples in each state; ω_ξ is the time
  CHECK(fields_of(spins, 1) == std::vector<std::string>{"1", "1", "0", "0", "strong"});
  CHECK(fields_of(spins, 6).back() == "weak");
  CHECK(speeds.finding.find("8.77 m/s after strong and at 0 m/s after weak") != std::string::npos);  // √77
}

TEST_CASE("(61) creeps as far as its slope says, the rigid law not at all") {
  const auto cases = sign_cases();
  CHECK(all_pass(sign_gates(cases)));
  CHECK(cases[0].slip_left == 0);
  // Sticking on the slope takes (2/7) tan θ/μ of the limit; of ε₂ a tenth bears nothing.
  const double share = 2.0 / 7 * std::tan(std::numbers::pi / 18) / 0.5;
  for (std::size_t i = 1; i < cases.size(); ++i) {
    CHECK(cases[i].slip_left == Approx((0.1 + 0.9 * share) * cases[i].eps2).epsilon(1e-6));
    CHECK(cases[i].creep == cases[i].slip_left);
  }
}
