// Contacts that do not act on each other within a step but by what they passed in the last one: springs and dashpots
// that a step resolves.
#include "contact_rows.hpp"

#include <ricochet/motion/cluster.hpp>

#include <algorithm>

namespace ricochet {

// Each contact foresees what the others pass. With u the rates of all contacts, W their common mobility and D its
// diagonal, that is one Jacobi step u' = −W P, (1 + γD) P = h R(u − ½(W − D) P_last) with γ = ½h c; a mode with
// W = κD is stable as long as γD(κ − 1) < ½. The greatest eigenvalue of γW is at most that of the greatest sum, over
// both bodies of a contact, of their contacts' γ/m, so a quarter a body suffices.
bool Cluster::needs_no_sweeps() {
  for (const Model& model : models_)
    if (model.rubs() && !model.compliant && !model.members.empty()) return false;
  drags_.assign(inverse_mass_.size(), 0);
  for (std::size_t k = 0; k < geometries_.size(); ++k) {
    const ContactState& c = state_.contacts[k];
    const Model& model = models_[c.model];
    const ContactGeometry& g = geometries_[k];
    const double along = std::abs(normals_[k].slope);
    const auto add = [&](std::uint32_t body, double arm) {
      double& drag = drags_[body];
      drag += inverse_mass_[body] * (along + model.damping) + inverse_inertia_[body] * (arm * arm * model.damping + model.turning_damping);
    };
    add(c.record.i, g.arm_i), add(c.record.j, g.arm_j);
  }
  constexpr double enough = 0.25;
  const double most = 2 * enough / options_.step;
  return std::all_of(drags_.begin(), drags_.end(), [&](double drag) { return drag <= most; });
}

// What the bodies will do in the middle of the step if contacts pass what they passed in the last one.
void Cluster::foresee() noexcept {
  for (std::size_t i = 0; i < size(); ++i) {
    Motion& m = motions_[i];
    m.velocity_mid = 0.5 * (m.velocity + state_.velocities[i] + state_.velocity_gains[i]);
    m.spin_mid = m.spin + 0.5 * state_.spin_gains[i];
  }
  for (std::size_t i = size(); i < motions_.size(); ++i)
    motions_[i].velocity_mid = 0.5 * (motions_[i].velocity + state_.velocities[i]), motions_[i].spin_mid = motions_[i].spin;
}

void Cluster::pass_at_once() {
  foresee();
  passed_.resize(geometries_.size());
  for (std::size_t k = 0; k < geometries_.size(); ++k) pass(k);
  // Sums of impulses and torques, in the order of the contacts; walls have entries of no consequence.
  state_.velocity_gains.assign(motions_.size(), {});
  state_.spin_gains.assign(motions_.size(), {});
  for (std::size_t k = 0; k < geometries_.size(); ++k) {
    const auto [i, j] = std::pair(state_.contacts[k].record.i, state_.contacts[k].record.j);
    const Passed& p = passed_[k];
    state_.velocity_gains[i] += p.linear;
    state_.velocity_gains[j] -= p.linear;
    state_.spin_gains[i] += geometries_[k].arm_i * p.lever + p.couple;
    state_.spin_gains[j] += geometries_[k].arm_j * p.lever - p.couple;
  }
  state_.velocity_gains.resize(size());
  state_.spin_gains.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    state_.velocities[i] += state_.velocity_gains[i] *= inverse_mass_[i];
    state_.spins[i] += state_.spin_gains[i] *= inverse_inertia_[i];
  }
  sweeps_ = 1;
  converged_ = true;
}

template <bool Turns>
void Cluster::pass_springs(std::size_t contact, Vec3 v) noexcept {
  ContactState& c = state_.contacts[contact];
  const ContactGeometry& g = geometries_[contact];
  const TangentialContact& law = models_[c.model].tangential;
  const SlipMobility m = slip_mobility(c, g);
  FrictionImpulse last = c.friction;
  last.sliding = tangential(last.sliding, g.normal);
  if (Turns) last.rolling = tangential(last.rolling, g.normal);
  // The motion in the middle, without this contact's own last impulse, stands for those at both ends.
  SlipMotion free = motion::slip_of(g, v, motions_[c.record.i].spin_mid, motions_[c.record.j].spin_mid);
  free.slip -= 0.5 * m.slip * last.sliding;
  if (Turns) {
    free.slip -= 0.5 * m.cross * last.rolling;
    free.roll -= 0.5 * (m.cross * last.sliding + m.roll * last.rolling);
    free.spin -= 0.5 * m.roll * last.torsion;
  }
  const FrictionProblem problem{std::max(0.0, normals_[contact].impulse), g.radius, m, free, free, {}};
  motion::CompliantRow row = compliant_row<Turns>(contact);
  const FrictionSolution found = motion::compliant_impulse<Turns>(law, c, row, problem, last);
  const FrictionImpulse& f = found.impulse;
  const Vec3 change = 0.5 * (m.slip * f.sliding + m.cross * f.rolling);
  const SlipMotion mean{free.slip + change, free.spin + 0.5 * m.roll * f.torsion,
                        free.roll + 0.5 * (m.cross * f.sliding + m.roll * f.rolling)};
  const motion::CompliantEnd end = motion::compliant_end<Turns>(law, row, c, mean, c.force);
  Passed& passed = passed_[contact];
  passed.linear += f.sliding;
  passed.lever = cross(g.normal, f.sliding);
  passed.couple = f.torsion * g.normal + cross(g.normal, f.rolling);
  passed.loss = motion::compliant_loss(row, c.strained - end.stored);
  passed.sticks = found.sticks;
  c.friction = f;
  c.elongation = end.elongation, c.strained = end.stored;
}

void Cluster::pass(std::size_t contact) noexcept {
  const ContactState& c = state_.contacts[contact];
  const ContactGeometry& g = geometries_[contact];
  motion::NormalRow& along = normals_[contact];
  const Motion &i = motions_[c.record.i], &j = motions_[c.record.j];
  const Vec3 v = i.velocity_mid - j.velocity_mid - swept(c, g);
  const double rate_free = 2 * dot(v, g.normal) - along.rate + along.mobility * c.normal_impulse;
  along.impulse = normal_impulse(c, along, rate_free);
  Passed& passed = passed_[contact];
  passed = {.linear = -along.impulse * g.normal, .lever = {}, .couple = {}, .loss = {}, .sticks = false};
  const Model& model = models_[c.model];
  if (model.turns)
    pass_springs<true>(contact, v);
  else if (model.compliant)
    pass_springs<false>(contact, v);
}

}  // namespace ricochet
