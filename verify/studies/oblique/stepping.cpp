#include "stepping.hpp"

#include "../benchmarks/impact.hpp"
#include "grain.hpp"

#include <fmt/format.h>

namespace ricochet::verify::oblique {

namespace {

using benchmarks::Asked;
using benchmarks::Row;

/// The cluster's order is 2, and less where it says so: a force that starts like t^{1/2}, as Mindlin's stiffness does,
/// adds errors of order 3/2 (cluster.hpp); and a rigid contact that rolls as the bodies part does so about the contact
/// point of the last step's middle, not of the end: to first order, by a share (2/7)ζ'h/(4r) or so.
std::pair<double, double> orders(const Contact& contact) {
  if (contact.name == "linear") return {2, 2};
  return {contact.name == "rigid" ? 1 : 1.5, 2};
}

std::vector<Row> rows_of(const Contact& contact, double degrees, const char* what) {
  ObliqueImpact impact = at_angle(degrees);
  impact.normal = {0, 0, -1};
  impact.i.velocity.z = -impact.i.velocity.z;
  const ObliqueCollision exact =
      collide(contact.normal, contact.tangential, impact, {.arm = ContactArm::contact_point});
  const std::string test = fmt::format("{}, {} degrees, {}", contact.name, degrees, what);
  const std::vector<Asked> asked{
      {test, "v_t after", "m/s", exact.velocity_i.x, norm(impact.i.velocity), orders(contact)},
      {test, "spin after", "1/s", exact.spin_i.y, norm(impact.i.velocity) / radius, orders(contact)}};
  const Interaction interaction{
      .law = NormalLaw(contact.normal), .friction = contact.tangential.friction, .tangential = contact.tangential.law};
  const Sphere sphere{radius, density, {}, impact.i.velocity};
  return benchmarks::measure(asked, exact.normal.tcol, [&](double step) {
    const benchmarks::Meeting m = benchmarks::meet(benchmarks::against_wall(sphere, interaction), step);
    return std::vector<double>{m.velocity.x, m.spin.y};
  });
}

}  // namespace

std::vector<Row> stepping_rows() {
  std::vector<Row> rows;
  const auto add = [&](const Contact& contact, double degrees, const char* what) {
    for (Row& row : rows_of(contact, degrees, what)) rows.push_back(std::move(row));
  };
  const auto [rigid, linear, mindlin] = contacts();
  add(linear, 2.5, "sticks");
  add(linear, 15, "sticks and slides");
  add(linear, 40, "slides");
  add(mindlin, 2.5, "sticks");
  add(mindlin, 15, "sticks and slides");
  add(rigid, 15, "slides, then rolls");
  return rows;
}

}  // namespace ricochet::verify::oblique
