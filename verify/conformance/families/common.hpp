#pragma once

#include "../case.hpp"
#include "../families.hpp"
#include "../solvers.hpp"

#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/reduction.hpp>
#include <ricochet/collision/scale_and_loss.hpp>
#include <ricochet/collision/tangential_restitution.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace ricochet::verify::conformance {

inline constexpr const char* paper = "J. S. Leszczynski, Phys. Rev. E 70, 051315 (2004), Table II";
inline constexpr const char* two_bodies =
    "m ζ'' = −F with m = m₁m₂/(m₁+m₂): L. D. Landau, E. M. Lifshitz, Mechanics, §13";
inline constexpr const char* wall_body = "m ζ'' = −F with the sphere's m, the wall's being infinite";
inline constexpr const char* linear_by_force =
    "linear law ended by force: T. Schwager, T. Pöschel, Granular Matter 9, 465 (2007)";
inline constexpr const char* linear_by_overlap =
    "linear law ended by overlap: J. Schäfer, S. Dippel, D. E. Wolf, J. Phys. I France 6, 5 (1996)";
inline constexpr const char* by_tsuji =
    "Y. Tsuji, T. Tanaka, T. Ishida, Powder Technol. 71, 239 (1992), the damping by restitution: D. Antypov, J. A. "
    "Elliott, EPL 94, 50004 (2011)";
inline constexpr const char* becker = "V. Becker, T. Schwager, T. Pöschel, Phys. Rev. E 77, 011304 (2008)";
inline constexpr const char* chung_ooi = "set-up of Y. C. Chung, J. Y. Ooi, Granular Matter 13, 643 (2011), test ";
inline constexpr const char* mfix =
    "set-up of R. Garg, J. Galvin, T. Li, S. Pannala, Documentation of open-source MFIX-DEM software for gas-solids "
    "flows "
    "(2012), ";
inline constexpr const char* by_collide =
    "the binary collision in closed form, or integrated with located events to 1e-11 (core/include/ricochet/collision)";
inline constexpr const char* by_oblique =
    "the oblique binary collision, every change between sticking and sliding located, to 1e-9";
inline constexpr const char* by_line =
    "Runge-Kutta-Fehlberg 7(8) with error control, begin and end of every contact located";
inline constexpr const char* by_floor =
    "Runge-Kutta-Fehlberg 7(8) with error control, every change between sticking and sliding located";

/// Of a set-up that others published: their numbers are not what is asked for.
inline Case published(Case c, std::string source) {
  c.source = std::move(source);
  c.how = "computed here, not the publication's printed numbers: " + c.how;
  return c;
}

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
