// One step of a cluster: what leads to the impulses of all contacts, and the step itself.
#include "contact_rows.hpp"

#include <ricochet/motion/cluster.hpp>

namespace ricochet {

void Cluster::step() {
  find_touching();
  if (needs_no_sweeps())
    pass_at_once();
  else
    pass_by_sweeps();
  ++state_.steps;
}

void Cluster::pass_by_sweeps() {
  motions_.resize(state_.velocities.size());
  note_start(0, motions_.size());
  prepare_normals();
  prepare_rows();
  fall(0, size());
  kick_by_fields();
  solve();
  note_end();
  conclude();
  fly(0, size());
}

void Cluster::note_start(std::size_t first, std::size_t last) noexcept {
  for (std::size_t i = first; i < last; ++i) {
    Motion& m = motions_[i];
    m.velocity = state_.velocities[i], m.spin = state_.spins[i];
    m.inverse_mass = inverse_mass_[i], m.inverse_inertia = inverse_inertia_[i];
    if (i < radii_.size()) m.position = state_.half_positions[i], m.radius = radii_[i];
  }
}

void Cluster::fall(std::size_t first, std::size_t last) noexcept {
  for (std::size_t i = first; i < last; ++i) state_.velocities[i] += options_.step * gravity_;
}

void Cluster::fly(std::size_t first, std::size_t last) noexcept {
  for (std::size_t i = first; i < last; ++i) state_.half_positions[i] += options_.step * state_.velocities[i];
}

void Cluster::note_end() {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    motions_[i].velocity_mid = 0.5 * (motions_[i].velocity + state_.velocities[i]);
    motions_[i].spin_mid = 0.5 * (motions_[i].spin + state_.spins[i]);
  }
}

void Cluster::kick_by_fields() {
  const double h = options_.step;
  // At the step's end, to the bit as restore() takes it.
  if (walls_swing_) set_wall_velocities(static_cast<double>(state_.steps + 1) * h);
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

motion::NormalBatch Cluster::batch(const Model& model) noexcept { return {model.members, present_, normals_}; }

void Cluster::group_contacts() {
  for (Model& model : models_) model.members.clear();
  present_.clear();
  for (ContactState& c : contacts_) {
    models_[c.model].members.push_back(static_cast<std::uint32_t>(present_.size()));
    present_.push_back(&c);
  }
}

void Cluster::prepare_normals() {
  group_contacts();
  geometries_.resize(present_.size());
  normals_.resize(present_.size());
  for (std::size_t k = 0; k < present_.size(); ++k) {
    const ContactState& c = *present_[k];
    geometries_[k] = geometry(c.record.i, c.record.j);
    normals_[k] = normal_row(c, geometries_[k]);
  }
  for (const Model& model : models_) model.normal->prepare(batch(model));
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

}  // namespace ricochet
