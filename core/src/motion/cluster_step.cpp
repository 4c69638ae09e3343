// One step of a cluster: the impulses of all contacts together.
#include <ricochet/motion/cluster.hpp>

#include <algorithm>
#include <utility>

namespace ricochet {

void Cluster::step() {
  find_touching();
  rows_.resize(state_.contacts.size());
  drop_separated();
  prepare_rows();
  kick_by_fields();
  solve();
  conclude();
  for (std::size_t i = 0; i < size(); ++i) state_.half_positions[i] += options_.step * state_.velocities[i];
  ++state_.steps;
}

void Cluster::kick_by_fields() {
  const double h = options_.step;
  for (std::size_t i = 0; i < size(); ++i) state_.velocities[i] += h * gravity_;
  if (walls_swing_) set_wall_velocities(time() + h);
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
  const Vec3 wi = state_.spins[c.record.i], wj = state_.spins[c.record.j];
  return {tangential(v, g.normal) + cross(g.arm_i * wi + g.arm_j * wj, g.normal),  // Eq. (9)
          dot(wi - wj, g.normal), cross(wi - wj, g.normal)};
}

namespace {

// What u_t gains over half a step while the normal turns and the branches shorten, velocities staying as they are.
// Sticking then holds at the step's end, not half a step late.
Vec3 turning(const ContactGeometry& g, Vec3 v, Vec3 wi, Vec3 wj, bool wall, double half_step) noexcept {
  const double rate = dot(v, g.normal), d = g.arm_i + g.arm_j;
  if (wall) return half_step * -0.5 * rate * cross(wi, g.normal);
  if (!(d > 0)) return {};
  const Vec3 across = tangential(v, g.normal), normal_rate = -across / d;
  const double rate_i = -rate * (1 - g.arm_i / d), rate_j = -rate * (1 - g.arm_j / d);
  const Vec3 arms = g.arm_i * wi + g.arm_j * wj;
  return half_step * (rate / d * across + cross(rate_i * wi + rate_j * wj, g.normal) +
                      dot(arms, g.normal) * cross(g.normal, normal_rate));
}

}  // namespace

motion::NormalBatch Cluster::batch(const Model& model) noexcept { return {model.members, state_.contacts, normals_}; }

void Cluster::prepare_rows() {
  normals_.resize(rows_.size());
  if (has_springs_) springs_.resize(rows_.size());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const ContactState& c = state_.contacts[k];
    Row& row = rows_[k];
    const ContactGeometry& g = row.geometry;
    const std::uint32_t i = c.record.i, j = c.record.j;
    // After (26) the force goes on: it never was zero.
    const bool let_go = c.record.end != Encounter::never && c.record.how < EncounterEnd::permanent_contact;
    const bool silent = options_.reclosing == Reclosing::silent && let_go;
    motion::NormalRow& normal = normals_[k];
    normal = {};
    normal.overlap = g.overlap;
    const Vec3 v = relative_velocity(i, j);
    normal.rate = dot(v, g.normal);
    normal.mobility = inverse_mass_[i] + inverse_mass_[j];
    normal.duration = silent ? 0 : options_.step;
    row.before = slip_motion(c, g, v);
    row.friction = {};
    if (models_[c.model].rubs()) prepare_friction(c, v, row);
    if (models_[c.model].compliant) springs_[k] = compliant_row(c, v, row);
  }
  for (const Model& model : models_) model.normal->prepare(batch(model));
}

void Cluster::prepare_friction(const ContactState& c, Vec3 v, Row& row) const noexcept {
  const ContactGeometry& g = row.geometry;
  const std::uint32_t i = c.record.i, j = c.record.j;
  const double mi = inverse_mass_[i], mj = inverse_mass_[j], ji = inverse_inertia_[i], jj = inverse_inertia_[j];
  row.mobility = {mi + mj + g.arm_i * g.arm_i * ji + g.arm_j * g.arm_j * jj, g.arm_i * ji - g.arm_j * jj, ji + jj};
  row.turning = j >= size() && !(wall_of(j).flat() && !wall_of(j).spins())
                    ? wall_turning(c, 0.5 * options_.step)
                    : turning(g, v, state_.spins[i], state_.spins[j], j >= size(), 0.5 * options_.step);
  // The last step's impulse is the guess for this one.
  row.friction.impulse = c.friction;
  row.friction.impulse.sliding = tangential(c.friction.sliding, g.normal);
  row.friction.impulse.rolling = tangential(c.friction.rolling, g.normal);
}

double Cluster::radius_eff(const ContactState& c) const noexcept {
  const double ri = radii_[c.record.i];
  return c.record.j < size() ? ri * radii_[c.record.j] / (ri + radii_[c.record.j]) : ri;
}

// A rolling limit μ_r R* R is that of an arm of ρ + μ_r R*/a contact radii.
Friction Cluster::rigid_friction(const ContactState& c, const ContactGeometry& g) const {
  const TangentialContact& t = models_[c.model].tangential;
  if (!(t.rolling.mu > 0 && g.radius > 0)) return t.friction;
  const double arm = t.friction.rolling_arm() + t.rolling.mu * radius_eff(c) / g.radius;
  return Friction(t.friction.mu_static(), t.friction.mu_dynamic(), t.friction.decay(), arm);
}

// From the memory to the middle all fly straight: means are those halfway.
motion::CompliantRow Cluster::compliant_row(const ContactState& c, Vec3 v, const Row& row) const noexcept {
  const ContactGeometry& g = row.geometry;
  const std::uint32_t i = c.record.i, j = c.record.j;
  motion::CompliantApproach approach{.normal_then = g.normal,
                                     .normal = g.normal,
                                     .motion = row.before,
                                     .pressing = {0, g.overlap, g.radius, radius_eff(c)},
                                     .step = options_.step};
  approach.motion.slip -= c.lag / options_.step * row.turning;
  const bool curved = j >= size() && !wall_of(j).flat();
  if (j < size()) {
    const Vec3 branch = (g.arm_i + g.arm_j) * g.normal + c.lag * v;
    const double distance = norm(branch);
    if (distance > 0) approach.normal_then = branch / distance;
  } else if (curved) {
    const Vec3 then = state_.half_positions[i] - c.lag * state_.velocities[i];
    approach.normal_then = wall_of(j).meet(then, radii_[i], middle() - c.lag).normal;
  }
  if (j < size() || curved) {
    const Vec3 between = approach.normal_then + g.normal, spin = state_.spins[i] - state_.spins[j];
    const double length = norm(between);
    const Vec3 normal = length > 0 ? between / length : g.normal;
    approach.motion.spin = dot(spin, normal), approach.motion.roll = cross(spin, normal);
  }
  return motion::compliant_row(models_[c.model].tangential, c, approach);
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
  const ContactState& c = state_.contacts[contact];
  Row& row = rows_[contact];
  motion::NormalRow& along = normals_[contact];
  const ContactGeometry& g = row.geometry;
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
  row.friction = model.compliant ? motion::compliant_impulse(model.tangential, springs_[contact], problem, last)
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
    const double arm = rows_[k].geometry.arm_i + rows_[k].geometry.arm_j;
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
    apply(state_.contacts[k], row.geometry, more.normal, more.friction);
    row.direction = {more.normal + normal, more.friction + friction};
  }
  return size;
}

void Cluster::solve() {
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (const ContactState& c = state_.contacts[k]; models_[c.model].rubs())
      apply(c, rows_[k].geometry, normals_[k].impulse, rows_[k].friction.impulse);
    else
      push(c, rows_[k].geometry, normals_[k].impulse);
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
  if (converged_) return;
  ++state_.unconverged;
  state_.worst_change = std::max(state_.worst_change, greatest > 0 ? change / greatest : 1.0);
}

void Cluster::conclude() {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    ContactState& c = state_.contacts[k];
    const Row& row = rows_[k];
    motion::NormalRow& normal = normals_[k];
    const Vec3 v = relative_velocity(c.record.i, c.record.j);
    normal.rate_mid = 0.5 * (normal.rate + dot(v, row.geometry.normal));
    const SlipMotion after = slip_motion(c, row.geometry, v);
    if (models_[c.model].compliant)
      conclude_springs(k, after);
    else if (models_[c.model].rubs())
      conclude_friction(c, row, after);
    note_phases(c, row, normal.rate_mid, after);
    if (walls_drive_ && c.record.j >= size())
      note_wall_work(c, row.geometry, normal.impulse, row.friction.impulse, wall_of(c.record.j).velocity(time()));
  }
  for (const Model& model : models_) model.normal->conclude(batch(model), time() + 0.5 * options_.step);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    ContactState& c = state_.contacts[k];
    state_.lost_normal += normals_[k].loss;
    if (c.record.how == EncounterEnd::permanent_contact) note_breakage(c, normals_[k].mobility);
    if (c.record.end != Encounter::never && c.record.how == EncounterEnd::open)
      c.record.how = how_it_ended(c, normals_[k].rate_mid, rows_[k]);
  }
}

EncounterEnd Cluster::how_it_ended(const ContactState& c, double rate_mid, const Row& row) noexcept {
  const double still = 1e-9 * c.speed_scale;
  if (std::abs(rate_mid) > still) return EncounterEnd::deformed_rebound;
  return norm(row.before.slip) > still ? EncounterEnd::dynamic_contact : EncounterEnd::static_contact;
}

// What the approach has lost of its energy by t_e is that of the impact, less the share at rest.
void Cluster::note_breakage(ContactState& c, double mobility) const noexcept {
  const double taken = 0.5 * c.impact_rate * c.impact_rate * (1 - at_rest * at_rest) / mobility;
  if (taken >= models_[c.model].breakage_energy) c.record.how = EncounterEnd::breakage;
}

void Cluster::conclude_friction(ContactState& c, const Row& row, const SlipMotion& after) {
  const FrictionImpulse& f = row.friction.impulse;
  c.friction = f;
  state_.lost_friction -=
      0.5 * (dot(f.sliding, row.before.slip + after.slip) + f.torsion * (row.before.spin + after.spin) +
             dot(f.rolling, row.before.roll + after.roll));
}

void Cluster::conclude_springs(std::size_t contact, const SlipMotion& after) {
  ContactState& c = state_.contacts[contact];
  const Row& row = rows_[contact];
  const SlipMotion mean{0.5 * (row.before.slip + after.slip), 0.5 * (row.before.spin + after.spin),
                        0.5 * (row.before.roll + after.roll)};
  const motion::CompliantEnd end =
      motion::compliant_end(models_[c.model].tangential, springs_[contact], c, row.friction.impulse, mean, c.force);
  c.friction = row.friction.impulse;
  c.elongation = end.elongation, c.strained = end.stored;
  state_.lost_friction += end.lost;
}

void Cluster::note_phases(ContactState& c, const Row& row, double rate_mid, const SlipMotion& after) const {
  const double h = options_.step, start = std::max(time(), c.record.begin), still = 1e-9 * c.speed_scale;
  const auto enter = [&](Phase phase, double when) {
    double& begin = c.record.phase_begin[static_cast<std::size_t>(phase)];
    begin = std::min(begin, when);
  };
  if (rate_mid < 0) {
    // Between the time of the last approach and the middle of this step the rate went through zero.
    const double middle = time() + 0.5 * h, past = c.approach.rate;
    const bool turned = past > 0 && !c.fresh;
    enter(Phase::decompression, turned ? middle - c.lag * rate_mid / (rate_mid - past) : start);
  }
  const double reach = row.geometry.arm_i + row.geometry.arm_j;
  if (std::abs(after.spin) * reach > still) enter(Phase::torsion, start);
  // What springs give way by is no sliding.
  const bool slid = !models_[c.model].compliant && norm(row.before.slip) > still;
  if (!row.friction.sticks) {
    if (slid || norm(after.slip) > still) enter(Phase::sliding, start);
    return;
  }
  if (slid) enter(Phase::sliding, start);
  const bool rolls = norm(after.roll) * reach > still;
  enter(rolls ? Phase::rolling : Phase::rest, start + row.friction.slip_fraction * (time() + h - start));
}

}  // namespace ricochet
