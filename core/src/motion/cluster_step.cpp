// One step of a cluster: what leads to the impulses of all contacts, and the step itself.
#include "contact_motion.hpp"

#include <ricochet/motion/cluster.hpp>

namespace ricochet {

void Cluster::step() {
  find_touching();
  geometries_.resize(state_.contacts.size());
  drop_separated();
  note_start();
  prepare_normals();
  at_once_ = needs_no_sweeps();
  if (!at_once_) prepare_rows();
  kick_by_fields();
  if (at_once_)
    pass_at_once();
  else
    solve();
  note_end();
  conclude();
  for (std::size_t i = 0; i < size(); ++i) state_.half_positions[i] += options_.step * state_.velocities[i];
  ++state_.steps;
}

void Cluster::note_start() {
  motions_.resize(state_.velocities.size());
  for (std::size_t i = 0; i < motions_.size(); ++i) motions_[i] = {state_.velocities[i], state_.spins[i], {}, {}};
}

void Cluster::note_end() {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    motions_[i].velocity_mid = 0.5 * (motions_[i].velocity + state_.velocities[i]);
    motions_[i].spin_mid = 0.5 * (motions_[i].spin + state_.spins[i]);
  }
}

void Cluster::kick_by_fields() {
  const double h = options_.step;
  for (std::size_t i = 0; i < size(); ++i) state_.velocities[i] += h * gravity_;
  if (!long_range_) return;
  field_forces_.assign(size(), {});
  long_range_(time() + 0.5 * h, state_.half_positions, field_forces_);
  for (std::size_t i = 0; i < size(); ++i) {
    // Work on the velocity in the middle of its own kick; what other forces add to it meets F again as O(h²).
    const Vec3 change = h * inverse_mass_[i] * field_forces_[i];
    state_.long_range_work += h * dot(field_forces_[i], state_.velocities[i] + 0.5 * change);
    state_.velocities[i] += change;
  }
}

SlipMotion Cluster::slip_motion(const ContactState& c, const ContactGeometry& g, Vec3 v) const noexcept {
  return motion::slip_of(g, v, state_.spins[c.record.i], state_.spins[c.record.j]);
}

SlipMotion Cluster::slip_before(const ContactState& c, const ContactGeometry& g) const noexcept {
  const Motion &i = motions_[c.record.i], &j = motions_[c.record.j];
  return motion::slip_of(g, i.velocity - j.velocity, i.spin, j.spin);
}

SlipMotion Cluster::mean_slip(const ContactState& c, const ContactGeometry& g) const noexcept {
  const Motion &i = motions_[c.record.i], &j = motions_[c.record.j];
  return motion::slip_of(g, i.velocity_mid - j.velocity_mid, i.spin_mid, j.spin_mid);
}

motion::NormalBatch Cluster::batch(const Model& model) noexcept { return {model.members, state_.contacts, normals_}; }

void Cluster::prepare_normals() {
  normals_.resize(geometries_.size());
  for (std::size_t k = 0; k < geometries_.size(); ++k) {
    const ContactState& c = state_.contacts[k];
    const ContactGeometry& g = geometries_[k];
    const std::uint32_t i = c.record.i, j = c.record.j;
    // After (26) the force goes on: it never was zero.
    const bool let_go = c.record.end != Encounter::never && c.record.how < EncounterEnd::permanent_contact;
    const bool silent = options_.reclosing == Reclosing::silent && let_go;
    motion::NormalRow& normal = normals_[k];
    normal = {};
    normal.overlap = g.overlap;
    normal.rate = dot(relative_velocity(i, j), g.normal);
    normal.mobility = inverse_mass_[i] + inverse_mass_[j];
    normal.duration = silent ? 0 : options_.step;
    normal.since_touch = c.fresh ? c.lag + 0.5 * options_.step : 0;
  }
  for (const Model& model : models_) model.normal->prepare(batch(model));
}

SlipMobility Cluster::slip_mobility(const ContactState& c, const ContactGeometry& g) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  const double mi = inverse_mass_[i], mj = inverse_mass_[j], ji = inverse_inertia_[i], jj = inverse_inertia_[j];
  return {mi + mj + g.arm_i * g.arm_i * ji + g.arm_j * g.arm_j * jj, g.arm_i * ji - g.arm_j * jj, ji + jj};
}

double Cluster::radius_eff(const ContactState& c) const noexcept {
  const double ri = radii_[c.record.i];
  return c.record.j < size() ? ri * radii_[c.record.j] / (ri + radii_[c.record.j]) : ri;
}

// From the memory to the middle all fly straight: means are those halfway.
motion::CompliantRow Cluster::compliant_row(std::size_t contact) const noexcept {
  const ContactState& c = state_.contacts[contact];
  const ContactGeometry& g = geometries_[contact];
  const std::uint32_t i = c.record.i, j = c.record.j;
  const Motion &one = motions_[i], &other = motions_[j];
  const Vec3 v = one.velocity - other.velocity;
  const TangentialContact& law = models_[c.model].tangential;
  motion::CompliantApproach approach{.normal_then = g.normal,
                                     .normal = g.normal,
                                     .motion = motion::slip_of(g, v, one.spin, other.spin),
                                     .pressing = {0, g.overlap, g.radius, radius_eff(c)},
                                     .step = options_.step,
                                     .since_touch = normals_[contact].since_touch};
  approach.motion.slip -=
      c.lag / options_.step * motion::turning(g, v, one.spin, other.spin, j >= size(), 0.5 * options_.step);
  if (j < size()) {
    const Vec3 branch = (g.arm_i + g.arm_j) * g.normal + c.lag * v;
    const double distance = norm(branch);
    if (distance > 0) approach.normal_then = 1 / distance * branch;
    if (motion::compliant::turns(law)) {
      const Vec3 spin = one.spin - other.spin;
      const Vec3 between = approach.normal_then + g.normal;
      const double length = norm(between);
      const Vec3 normal = length > 0 ? between / length : g.normal;
      approach.motion.spin = dot(spin, normal), approach.motion.roll = cross(spin, normal);
    }
  }
  return motion::compliant_row(law, c, approach);
}

// An impulse along the normal alone.
void Cluster::push(const ContactState& c, const ContactGeometry& g, double normal) noexcept {
  const Vec3 linear = normal * g.normal;
  state_.velocities[c.record.i] -= inverse_mass_[c.record.i] * linear;
  state_.velocities[c.record.j] += inverse_mass_[c.record.j] * linear;
}

void Cluster::apply(const ContactState& c, const ContactGeometry& g, double normal, const FrictionImpulse& f) noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  const Vec3 linear = f.sliding - normal * g.normal;
  const Vec3 lever = cross(g.normal, f.sliding), couple = f.torsion * g.normal + cross(g.normal, f.rolling);
  state_.velocities[i] += inverse_mass_[i] * linear;
  state_.velocities[j] -= inverse_mass_[j] * linear;
  state_.spins[i] += inverse_inertia_[i] * (g.arm_i * lever + couple);
  state_.spins[j] += inverse_inertia_[j] * (g.arm_j * lever - couple);
}

double Cluster::normal_impulse(const ContactState& c, const motion::NormalRow& row, double rate_free) const noexcept {
  if (row.duration == 0) return row.fixed_impulse;
  // R in the middle of the step, implicit in the mean rate: affine in it for every law here.
  const double h = row.duration;
  const double explicit_force = row.force + row.slope * (0.5 * (row.rate + rate_free) - row.rate);
  const double force = explicit_force / (1 + 0.5 * h * row.slope * row.mobility);
  if (models_[c.model].end == ContactEnd::overlap) return h * force;
  // Only what repels counts. Over the step R is taken as linear; where it changes sign, the triangle remains.
  const double slope = (force - c.force) / c.lag;
  const double first = force - 0.5 * h * slope, last = force + 0.5 * h * slope;
  if (first >= 0 && last >= 0) return h * force;
  if (first <= 0 && last <= 0) return 0;
  const double peak = std::max(first, last);
  return 0.5 * peak * peak / std::abs(slope);
}

}  // namespace ricochet
