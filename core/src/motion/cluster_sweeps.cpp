// Contacts that act on each other within a step: rigid friction and stiff dashpots, by sweeps.
#include "contact_rows.hpp"

#include <ricochet/motion/cluster.hpp>

#include <algorithm>

namespace ricochet {

void Cluster::prepare_rows() {
  rows_.resize(geometries_.size());
  if (has_springs_) springs_.resize(rows_.size());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const ContactState& c = *present_[k];
    rows_[k].before = slip_motion(c, geometries_[k], relative_velocity(c.record.i, c.record.j));
    rows_[k].friction = {};
    if (models_[c.model].rubs()) prepare_friction(k);
    if (models_[c.model].compliant) springs_[k] = compliant_row<true>(c, geometries_[k], normals_[k].since_touch);
  }
}

void Cluster::prepare_friction(std::size_t contact) noexcept {
  const ContactState& c = *present_[contact];
  const ContactGeometry& g = geometries_[contact];
  Row& row = rows_[contact];
  row.mobility = slip_mobility(c, g);
  row.turning = turning(c, g, relative_velocity(c.record.i, c.record.j));
  // The last step's impulse is the guess for this one.
  row.friction.impulse = c.friction;
  row.friction.impulse.sliding = tangential(c.friction.sliding, g.normal);
  row.friction.impulse.rolling = tangential(c.friction.rolling, g.normal);
}

// A rolling limit μ_r R* R is that of an arm of ρ + μ_r R*/a contact radii.
Friction Cluster::rigid_friction(const ContactState& c, const ContactGeometry& g) const {
  const TangentialContact& t = models_[c.model].tangential;
  if (!(t.rolling.mu > 0 && g.radius > 0)) return t.friction;
  const double arm = t.friction.rolling_arm() + t.rolling.mu * radius_eff(c) / g.radius;
  return Friction(t.friction.mu_static(), t.friction.mu_dynamic(), t.friction.decay(), arm);
}

namespace {

FrictionImpulse operator-(const FrictionImpulse& a, const FrictionImpulse& b) noexcept {
  return {a.sliding - b.sliding, a.torsion - b.torsion, a.rolling - b.rolling};
}

FrictionImpulse operator+(const FrictionImpulse& a, const FrictionImpulse& b) noexcept {
  return {a.sliding + b.sliding, a.torsion + b.torsion, a.rolling + b.rolling};
}

FrictionImpulse operator*(double s, const FrictionImpulse& a) noexcept {
  return {s * a.sliding, s * a.torsion, s * a.rolling};
}

// Sweeps before they are accelerated: contacts that settle soon settle sooner without.
constexpr int plain_sweeps = 16;

}  // namespace

// Solves one contact, all others as they are; returns the change of its impulses [N s].
double Cluster::relax(std::size_t contact) noexcept {
  const ContactState& c = *present_[contact];
  Row& row = rows_[contact];
  motion::NormalRow& along = normals_[contact];
  const ContactGeometry& g = geometries_[contact];
  const Vec3 v = relative_velocity(c.record.i, c.record.j);
  const double rate_free = dot(v, g.normal) + along.mobility * along.impulse;
  const double normal = normal_impulse(c, along, rate_free);
  const double change = normal - along.impulse;
  along.impulse = normal;
  const Model& model = models_[c.model];
  if (!model.rubs()) {
    push(c, g, change);
    return std::abs(change);
  }
  const FrictionImpulse last = row.friction.impulse;
  const SlipMobility& m = row.mobility;
  SlipMotion free = slip_motion(c, g, v);
  free.slip -= m.slip * last.sliding + m.cross * last.rolling;
  free.roll -= m.cross * last.sliding + m.roll * last.rolling;
  free.spin -= m.roll * last.torsion;
  const FrictionProblem problem{std::max(0.0, normal), g.radius, m, row.before, free, row.turning};
  row.friction = model.compliant
                     ? motion::compliant_impulse<true>(model.tangential, c, springs_[contact], problem, last)
                     : friction_impulse(rigid_friction(c, g), problem, last);
  const FrictionImpulse delta = row.friction.impulse - last;
  apply(c, g, change, delta);
  const double arm = g.arm_i + g.arm_j;
  const double couples = arm > 0 ? (std::abs(delta.torsion) + norm(delta.rolling)) / arm : 0;
  return std::abs(change) + norm(delta.sliding) + couples;
}

// Nonsmooth conjugate gradients (Silcowitz-Hansen, Niebe, Erleben, Vis. Comput. 26, 893 (2010)): what a sweep changed
// stands for the gradient; part of the direction before is added. Where that leads out of the limits the next sweep
// leads back in. Returns the squared size of the change; couples count by the lever of the contact.
double Cluster::accelerate(double last, bool restart) noexcept {
  const auto change = [&](std::size_t k) {
    const Row& row = rows_[k];
    return Pulse{normals_[k].impulse - row.before_sweep.normal, row.friction.impulse - row.before_sweep.friction};
  };
  double size = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const auto [normal, f] = change(k);
    const double arm = geometries_[k].arm_i + geometries_[k].arm_j;
    const double couples = arm > 0 ? (f.torsion * f.torsion + dot(f.rolling, f.rolling)) / (arm * arm) : 0;
    size += normal * normal + dot(f.sliding, f.sliding) + couples;
  }
  const double share = restart || !(size < last) ? 0.0 : size / last;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    Row& row = rows_[k];
    const auto [normal, friction] = change(k);
    const Pulse more{share * row.direction.normal, share * row.direction.friction};
    normals_[k].impulse += more.normal;
    row.friction.impulse = row.friction.impulse + more.friction;
    apply(*present_[k], geometries_[k], more.normal, more.friction);
    row.direction = {more.normal + normal, more.friction + friction};
  }
  return size;
}

void Cluster::solve() {
  std::copy_n(state_.velocities.begin(), radii_.size(), state_.velocity_gains.begin());
  std::copy_n(state_.spins.begin(), radii_.size(), state_.spin_gains.begin());
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (const ContactState& c = *present_[k]; models_[c.model].rubs())
      apply(c, geometries_[k], normals_[k].impulse, rows_[k].friction.impulse);
    else
      push(c, geometries_[k], normals_[k].impulse);
  converged_ = false;
  double change = 0, greatest = 0, size = 0;
  for (sweeps_ = 0; sweeps_ < options_.max_sweeps && !converged_; ++sweeps_) {
    if (sweeps_ >= plain_sweeps) size = accelerate(size, sweeps_ == plain_sweeps);
    const bool noted = sweeps_ + 1 >= plain_sweeps;  // what the next sweep is accelerated by
    change = greatest = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (noted) rows_[k].before_sweep = {normals_[k].impulse, rows_[k].friction.impulse};
      change = std::max(change, relax(k));
      greatest = std::max(greatest, normals_[k].impulse);
    }
    converged_ = change <= options_.solver_tolerance * greatest;
  }
  for (std::size_t i = 0; i < radii_.size(); ++i) {
    state_.velocity_gains[i] = state_.velocities[i] - state_.velocity_gains[i];
    state_.spin_gains[i] = state_.spins[i] - state_.spin_gains[i];
  }
  if (converged_) return;
  ++state_.unconverged;
  state_.worst_change = std::max(state_.worst_change, greatest > 0 ? change / greatest : 1.0);
}

}  // namespace ricochet
