#pragma once

#include "../case.hpp"
#include "../families.hpp"
#include "../solvers.hpp"

#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/reduction.hpp>
#include <ricochet/collision/scale_and_loss.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace ricochet::verify::conformance {

inline constexpr const char* paper = "J. S. Leszczynski, Phys. Rev. E 70, 051315 (2004), Table II";
inline constexpr const char* chung_ooi = "Y. C. Chung, J. Y. Ooi, Granular Matter 13, 643 (2011), test ";
inline constexpr const char* mfix =
    "R. Garg, J. Galvin, T. Li, S. Pannala, Documentation of open-source MFIX-DEM software for gas-solids flows "
    "(2012), ";
inline constexpr const char* by_collide =
    "the binary collision in closed form, or integrated with located events to 1e-11 (core/include/ricochet/collision)";
inline constexpr const char* by_line =
    "Runge-Kutta-Fehlberg 7(8) with error control, begin and end of every contact located";

/// The law of that kind which gives t_col and e_n at the impact, ended so.
inline Meeting calibrated(LawKind kind, ContactEnd end, double tcol, double en, const Impact& impact) {
  return {at_impact(unit_law(kind, en, end).value().law, tcol, impact).value(), end};
}

inline double mass_eff(const Body& a, const Body& b) { return a.mass * b.mass / (a.mass + b.mass); }

inline TangentialContact rough(const TangentialLaw& law, double mu) {
  return {.law = law, .friction = Friction(mu, mu, 0)};
}

/// Two bodies that touch in the origin, the first flying along x at the second.
inline std::vector<Body> touching(Body first, Body second) {
  first.position = {-first.radius, 0, 0}, second.position = {second.radius, 0, 0};
  return {first, second};
}

/// One that touches the wall x = 0, whose normal is x.
inline std::vector<Body> touching_wall(Body body) {
  body.position = {body.radius, 0, 0};
  return {body};
}

/// The velocity of each body along x, the time of separation, and what engines need not report.
inline std::vector<Asked> asked_of_head_on(std::size_t bodies, double speed, double tcol, double overlap) {
  std::vector<Asked> all;
  for (std::size_t i = 1; i <= bodies; ++i) all.push_back({Quantity::vx, i, speed});
  all.push_back({Quantity::separation, 1, tcol});
  all.push_back({Quantity::contact_time, 1, tcol, false});
  all.push_back({Quantity::max_overlap, 1, overlap, false});
  return all;
}

/// A run goes on for three quarters of the collision after its end.
inline constexpr double run_of_one = 1.73;

}  // namespace ricochet::verify::conformance
