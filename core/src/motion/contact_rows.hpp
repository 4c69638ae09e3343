#pragma once

#include "contact_motion.hpp"

#include <ricochet/motion/cluster.hpp>

// What a contact's solution begins with, by sweeps or at once.
namespace ricochet {

// Spheres whose contacts' losses are summed first, so that the sum does not depend on who takes which.
inline constexpr std::uint32_t group_of_losses = 16;

// part(range) for all of them, by as many threads.
template <class Part>
void Cluster::each_range(const Part& part) {
  if (workers_)
    workers_->run([&](std::size_t worker) { part(ranges_[worker]); });
  else
    part(ranges_.front());
}

// From the centre of one sphere to that of another, across a border where that is nearer.
RICOCHET_INNERMOST Vec3 Cluster::branch(std::uint32_t i, std::uint32_t j) const noexcept {
  const Vec3 way = state_.half_positions[j] - state_.half_positions[i];
  return periodic_.any() ? periodic_.shortest(way) : way;
}

RICOCHET_INNERMOST ContactGeometry Cluster::geometry(std::uint32_t i, std::uint32_t j, bool disc) const noexcept {
  if (j < size()) return sphere_sphere({}, radii_[i], branch(i, j), radii_[j], disc);
  return wall_of(j).meet(state_.half_positions[i], radii_[i], middle());
}

RICOCHET_INNERMOST Vec3 Cluster::relative_velocity(std::uint32_t i, std::uint32_t j) const noexcept {
  return state_.velocities[i] - (j < size() || !walls_drive_ ? state_.velocities[j] : wall_velocity(i, j));
}

// Of the wall's surface where the sphere touches it in the middle of the step.
inline Vec3 Cluster::wall_velocity(std::uint32_t i, std::uint32_t j) const noexcept {
  const motion::Surface& wall = wall_of(j);
  if (!wall.spins()) return state_.velocities[j];
  const ContactGeometry g = geometry(i, j);
  return state_.velocities[j] + wall.swept(state_.half_positions[i] + g.arm_i * g.normal, middle());
}

RICOCHET_INNERMOST SlipMobility Cluster::slip_mobility(const ContactState& c, const ContactGeometry& g) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  const double mi = motions_[i].inverse_mass, mj = motions_[j].inverse_mass;
  const double ji = motions_[i].inverse_inertia, jj = motions_[j].inverse_inertia;
  return {mi + mj + g.arm_i * g.arm_i * ji + g.arm_j * g.arm_j * jj, g.arm_i * ji - g.arm_j * jj, ji + jj};
}

RICOCHET_INNERMOST double Cluster::radius_eff(const ContactState& c) const noexcept {
  const double ri = radii_[c.record.i];
  return c.record.j < size() ? ri * radii_[c.record.j] / (ri + radii_[c.record.j]) : ri;
}

// What the spin of a wall adds to its velocity where the sphere touches it.
RICOCHET_INNERMOST Vec3 Cluster::swept(const ContactState& c, const ContactGeometry& g) const noexcept {
  if (c.record.j < size() || !walls_drive_) return {};
  return wall_of(c.record.j).swept(state_.half_positions[c.record.i] + g.arm_i * g.normal, middle());
}

// Whether the body is a wall that is curved or turns.
RICOCHET_INNERMOST bool Cluster::curved(std::uint32_t j) const noexcept {
  return j >= size() && !(wall_of(j).flat() && !wall_of(j).spins());
}

// What u_t gains over half a step while velocities stay as they are; v = v_i − v_j.
RICOCHET_INNERMOST Vec3 Cluster::turning(const ContactState& c, const ContactGeometry& g, Vec3 v) const noexcept {
  const std::uint32_t j = c.record.j;
  if (curved(j)) return wall_turning(c, 0.5 * options_.step);
  return motion::turning(g, v, motions_[c.record.i].spin, motions_[j].spin, j >= size(), 0.5 * options_.step);
}

// The normal at the time of the memory; all fly straight since.
RICOCHET_INNERMOST Vec3 Cluster::normal_then(const ContactState& c, const ContactGeometry& g, Vec3 v) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  if (j < size()) return motion::normal_before(g, v, c.lag);
  if (wall_of(j).flat()) return g.normal;
  const Vec3 then = state_.half_positions[i] - c.lag * motions_[i].velocity;
  return wall_of(j).meet(then, radii_[i], middle() - c.lag).normal;
}

// From the memory to the middle all fly straight: means are those halfway.
template <bool Turns>
RICOCHET_INNERMOST motion::CompliantRow Cluster::compliant_row(const ContactState& c, const ContactGeometry& g,
                                                               double since_touch) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  const Motion &one = motions_[i], &other = motions_[j];
  const Vec3 v = one.velocity - other.velocity - swept(c, g);
  const TangentialContact& law = models_[c.model].tangential;
  motion::CompliantApproach approach{.normal_then = g.normal,
                                     .normal = g.normal,
                                     .motion = motion::slip_of(g, v, one.spin, other.spin),
                                     .pressing = {0, g.overlap, g.radius, radius_eff(c)},
                                     .step = options_.step,
                                     .since_touch = since_touch};
  approach.motion.slip -= c.lag / options_.step * turning(c, g, v);
  approach.normal_then = normal_then(c, g, v);
  if (Turns && approach.normal_then != g.normal) {
    const Vec3 spin = one.spin - other.spin, between = approach.normal_then + g.normal;
    const double length = norm(between);
    const Vec3 normal = length > 0 ? between / length : g.normal;
    approach.motion.spin = dot(spin, normal), approach.motion.roll = cross(spin, normal);
  }
  return motion::compliant_row<Turns>(law, c, approach);
}

RICOCHET_INNERMOST double Cluster::normal_impulse(const ContactState& c, const motion::NormalRow& row,
                                                  double rate_free) const noexcept {
  if (row.duration == 0) return row.fixed_impulse;
  // R in the middle of the step, implicit in the mean rate: affine in it for every law here.
  const double h = row.duration;
  const double explicit_force = row.force + row.slope * (0.5 * (row.rate + rate_free) - row.rate);
  const double force = explicit_force / (1 + 0.5 * h * row.slope * row.mobility);
  if (models_[c.model].end == ContactEnd::overlap) return h * force;
  // Only what repels counts. Over the step R is taken as linear; where it changes sign, the triangle remains.
  const double half_change = (c.lag == h ? 0.5 : 0.5 * h / c.lag) * (force - c.force);
  const double first = force - half_change, last = force + half_change;
  if (first >= 0 && last >= 0) return h * force;
  if (first <= 0 && last <= 0) return 0;
  const double peak = std::max(first, last);
  return 0.25 * h * peak * peak / std::abs(half_change);
}

RICOCHET_INNERMOST SlipMotion Cluster::slip_motion(const ContactState& c, const ContactGeometry& g,
                                                   Vec3 v) const noexcept {
  return motion::slip_of(g, v, state_.spins[c.record.i], state_.spins[c.record.j]);
}

RICOCHET_INNERMOST SlipMotion Cluster::slip_before(const ContactState& c, const ContactGeometry& g) const noexcept {
  const Motion &i = motions_[c.record.i], &j = motions_[c.record.j];
  return motion::slip_of(g, i.velocity - j.velocity - swept(c, g), i.spin, j.spin);
}

RICOCHET_INNERMOST SlipMotion Cluster::mean_slip(const ContactState& c, const ContactGeometry& g) const noexcept {
  const Motion &i = motions_[c.record.i], &j = motions_[c.record.j];
  return motion::slip_of(g, i.velocity_mid - j.velocity_mid - swept(c, g), i.spin_mid, j.spin_mid);
}

RICOCHET_INNERMOST motion::NormalRow Cluster::normal_row(const ContactState& c,
                                                         const ContactGeometry& g) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  // After (26) the force goes on: it never was zero.
  const bool let_go = c.record.end != Encounter::never && c.record.how < EncounterEnd::permanent_contact;
  const bool silent = options_.reclosing == Reclosing::silent && let_go;
  motion::NormalRow row;
  row.overlap = g.overlap;
  row.rate = dot(motions_[i].velocity - motions_[j].velocity - swept(c, g), g.normal);
  row.mobility = motions_[i].inverse_mass + motions_[j].inverse_mass;
  row.duration = silent ? 0 : options_.step;
  row.since_touch = c.fresh ? c.lag + 0.5 * options_.step : 0;
  return row;
}

}  // namespace ricochet
