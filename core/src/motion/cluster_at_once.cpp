// Contacts that do not act on each other within a step but by what they passed in the last one: springs and dashpots
// that a step resolves. A block of contacts goes through all of it while it is in the nearest cache.
#include "contact_rows.hpp"
#include "slides.hpp"

#include <ricochet/motion/cluster.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace ricochet {
namespace {

constexpr std::size_t block_size = 64;

}  // namespace

struct Cluster::Workspace {
  std::array<ContactState*, block_size> contacts{};
  std::array<std::uint32_t, block_size> models{};   // of the block's contacts
  std::array<std::uint32_t, block_size> members{};  // the block's contacts by interaction
  std::array<std::uint32_t, block_size> ends{};     // where in `members` each interaction's end
  std::uint32_t batches = 0;
  std::array<ContactGeometry, block_size> geometries;
  std::array<motion::NormalRow, block_size> rows;
  std::array<Passed, block_size> passed;
  motion::Slides slides{};

  void group(std::uint32_t count) noexcept;
};

// Looks at the interactions that the block has, not at all that there are: bodies of many sizes have thousands.
void Cluster::Workspace::group(std::uint32_t count) noexcept {
  std::uint32_t model = models[0], filled = 0, greatest = models[0];
  for (std::uint32_t n = 1; n < count; ++n) {
    model = std::min(model, models[n]);
    greatest = std::max(greatest, models[n]);
  }
  batches = 0;
  while (model < greatest) {
    std::uint32_t next = greatest;
    for (std::uint32_t n = 0; n < count; ++n) {
      if (models[n] == model) members[filled++] = n;
      if (models[n] > model) next = std::min(next, models[n]);
    }
    ends[batches++] = filled;
    model = next;
  }
  for (std::uint32_t n = 0; n < count; ++n)
    if (models[n] == greatest) members[filled++] = n;
  ends[batches++] = filled;
}

// Each contact foresees what the others pass. With u the rates of all contacts, W their common mobility and D its
// diagonal, that is one Jacobi step u' = −W P, (1 + γD) P = h R(u − ½(W − D) P_last) with γ = ½h c; a mode with
// W = κD is stable as long as γD(κ − 1) < ½. The greatest eigenvalue of γW is at most that of the greatest sum, over
// both bodies of a contact, of their contacts' γ/m, so a quarter a body suffices. What a contact brakes along its
// normal is orthogonal to what it brakes across and turning: the greater of the two is its share.
void Cluster::add_drag(const ContactState& c, std::int64_t sign) noexcept {
  constexpr double enough = 0.25, unit = 0x1p-32, most = 1e4;
  constexpr auto limit = static_cast<std::int64_t>(enough / unit);
  const Model& model = models_[c.model];
  const std::uint32_t i = c.record.i, j = c.record.j;
  const double along = model.drag ? *model.drag : model.normal->drag(c, inverse_mass_[i] + inverse_mass_[j]);
  const auto add = [&](std::uint32_t body, double arm) {
    const double across = inverse_mass_[body] * model.damping +
                          inverse_inertia_[body] * (arm * arm * model.damping + model.turning_damping);
    const double drag = std::max(inverse_mass_[body] * std::abs(along), across);
    std::int64_t& sum = drags_[body];
    braked_ -= sum > limit ? 1 : 0;
    sum += sign * static_cast<std::int64_t>(std::ceil(std::min(most, 0.5 * options_.step * drag) / unit));
    braked_ += sum > limit ? 1 : 0;
  };
  add(i, radii_[i]);
  if (j < radii_.size()) add(j, radii_[j]);
}

void Cluster::sum_drags() noexcept {
  drags_.assign(inverse_mass_.size(), 0);
  braked_ = 0;
  for (const ContactState& c : contacts_) add_drag(c, 1);
}

bool Cluster::needs_no_sweeps() {
  for (const Model& model : models_)
    if (model.rubs() && !model.compliant && model.contacts > 0) return false;
  if (drags_vary_) sum_drags();
  return braked_ == 0;
}

// What spheres will do in the middle of the step if contacts pass what they passed in the last one.
void Cluster::foresee(std::size_t first, std::size_t last) noexcept {
  for (std::size_t i = first; i < last; ++i) {
    Motion& m = motions_[i];
    m.velocity_mid = 0.5 * (m.velocity + state_.velocities[i]) + 0.5 * std::exchange(state_.velocity_gains[i], {});
    m.spin_mid = m.spin + 0.5 * std::exchange(state_.spin_gains[i], {});
  }
}

// All that spheres do before their contacts pass anything.
void Cluster::begin_step() {
  const std::size_t spheres = size(), bodies = state_.velocities.size();
  motions_.resize(bodies);
  note_start(spheres, bodies);
  each_range([this](const Range& range) {
    note_start(range.first, range.last);
    fall(range.first, range.last);
    if (!long_range_) foresee(range.first, range.last);
  });
  kick_by_fields();
  if (long_range_) foresee(0, spheres);
  for (std::size_t w = spheres; w < bodies; ++w) {
    motions_[w].velocity_mid = 0.5 * (motions_[w].velocity + state_.velocities[w]);
    motions_[w].spin_mid = motions_[w].spin;
  }
}

void Cluster::pass_at_once() {
  begin_step();
  each_range([this](Range& range) { pass_range(range); });
  each_range([this](const Range& range) {
    add_late(range.first, range.last);
    end_step(range.first, range.last);
  });
  book();
  sweeps_ = 1;
  converged_ = true;
}

// What contacts have passed moves their spheres.
void Cluster::end_step(std::size_t first, std::size_t last) noexcept {
  for (std::size_t i = first; i < last; ++i) {
    state_.velocities[i] += state_.velocity_gains[i] *= inverse_mass_[i];
    state_.spins[i] += state_.spin_gains[i] *= inverse_inertia_[i];
  }
  fly(first, last);
}

// By blocks of contacts.
void Cluster::pass_range(Range& range) {
  Workspace space;
  range.late.clear();
  std::fill(losses_.begin() + range.first / group_of_losses,
            losses_.begin() + (range.last + group_of_losses - 1) / group_of_losses, Losses{});
  const std::uint32_t last = contacts_.place_of({range.last, 0});
  for (std::uint32_t first = contacts_.place_of({range.first, 0}); first < last;) {
    const std::uint32_t end = std::min<std::uint32_t>(last, first + block_size);
    pass_block(first, end, space);
    gather(std::span(space.passed).first(end - first), range);
    first = end;
  }
}

// As geometry, from what lies side by side.
inline ContactGeometry Cluster::geometry_of(const ContactState& c) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  if (j >= radii_.size()) return geometry(i, j);
  const Motion &one = motions_[i], &other = motions_[j];
  const Vec3 way = other.position - one.position;
  return sphere_sphere({}, one.radius, periodic_.any() ? periodic_.shortest(way) : way, other.radius,
                       models_[c.model].turns);
}

void Cluster::pass_block(std::uint32_t first, std::uint32_t last, Workspace& space) {
  auto& geometries = space.geometries;
  auto& rows = space.rows;
  auto& passed = space.passed;
  motion::Slides& slides = space.slides;
  const std::uint32_t count = last - first;
  for (std::uint32_t n = 0; n < count; ++n) {
    ContactState& c = contacts_[first + n];
    if (n + motion::look_ahead < count) motion::fetch(motions_[contacts_[first + n + motion::look_ahead].record.j]);
    if (n + 2 * motion::look_ahead < count) motion::fetch(contacts_[first + n + 2 * motion::look_ahead]);
    space.contacts[n] = &c, space.models[n] = c.model;
    geometries[n] = geometry_of(c);
    rows[n] = normal_row(c, geometries[n]);
  }
  space.group(count);
  each_batch(space, [](motion::NormalContacts& law, const motion::NormalBatch& batch) { law.prepare(batch); });
  for (std::uint32_t n = 0; n < count; ++n) {
    ContactState& c = *space.contacts[n];
    const Vec3 v = pass_normal(c, geometries[n], rows[n], passed[n]);
    if (!slides_or_holds(c)) {
      pass_tangential(c, geometries[n], rows[n], v, passed[n]);
      continue;
    }
    slides.contacts[slides.count] = n;
    add_slide(c, geometries[n], rows[n], v, slides);
    if (slides.count == motion::Slides::lanes) pass_slides(space);
  }
  if (slides.count > 0) pass_slides(space);
  const double now = middle();
  each_batch(space, [now](motion::NormalContacts& law, const motion::NormalBatch& batch) { law.conclude(batch, now); });
  for (std::uint32_t n = 0; n < count; ++n) {
    passed[n].lost_normal = rows[n].loss;
    note_end_of_contact(*space.contacts[n], geometries[n], rows[n]);
  }
}

// act(law, batch) for each interaction that has some of the block's contacts.
template <class Act>
void Cluster::each_batch(Workspace& space, const Act& act) {
  std::uint32_t first = 0;
  for (const std::uint32_t end : std::span(space.ends).first(space.batches)) {
    const auto members = std::span(space.members).subspan(first, end - first);
    act(*models_[space.models[members.front()]].normal, {members, space.contacts, space.rows});
    first = end;
  }
}

inline void Cluster::receive(const Gain& gain) noexcept {
  state_.velocity_gains[gain.body] += gain.linear;
  state_.spin_gains[gain.body] += gain.turning;
}

// Each body's gains are summed in the order of its contacts, whoever passes them.
void Cluster::gather(std::span<const Passed> passed, Range& range) {
  const auto add = [&](const Gain& gain) {
    if (lowest_[gain.body] < range.first)
      range.late.push_back(gain);
    else
      receive(gain);
  };
  for (const Passed& p : passed) {
    add({p.i, p.linear, p.on_i});
    if (p.j < radii_.size()) add({p.j, -p.linear, p.on_j});
    Losses& losses = losses_[p.i / group_of_losses];
    losses.normal += p.lost_normal, losses.friction += p.lost_friction, losses.wall_work += p.wall_work;
  }
}

void Cluster::add_late(std::size_t first, std::size_t last) noexcept {
  for (const Range& range : ranges_)
    for (const Gain& gain : range.late)
      if (gain.body >= first && gain.body < last) receive(gain);
}

void Cluster::book() noexcept {
  for (const Losses& losses : losses_) {
    state_.lost_normal += losses.normal;
    state_.lost_friction += losses.friction;
    state_.wall_work += losses.wall_work;
  }
}

template <bool Turns>
void Cluster::pass_springs(ContactState& c, const ContactGeometry& g, const motion::NormalRow& along, Vec3 v,
                           Passed& passed, Course& course) const noexcept {
  const TangentialContact& law = models_[c.model].tangential;
  const Motion &one = motions_[c.record.i], &other = motions_[c.record.j];
  const SlipMobility m = slip_mobility(c, g);
  FrictionImpulse last = c.friction;
  last.sliding = tangential(last.sliding, g.normal);
  if (Turns) last.rolling = tangential(last.rolling, g.normal);
  // The motion in the middle, without this contact's own last impulse, stands for those at both ends.
  SlipMotion free = motion::slip_of(g, v, one.spin_mid, other.spin_mid);
  free.slip -= 0.5 * m.slip * last.sliding;
  if (Turns) {
    free.slip -= 0.5 * m.cross * last.rolling;
    free.roll -= 0.5 * (m.cross * last.sliding + m.roll * last.rolling);
    free.spin -= 0.5 * m.roll * last.torsion;
  }
  const FrictionProblem problem{std::max(0.0, along.impulse), g.radius, m, free, free, {}};
  motion::CompliantRow row = compliant_row<Turns>(c, g, along.since_touch);
  const FrictionSolution found = motion::compliant_impulse<Turns>(law, c, row, problem, last);
  const FrictionImpulse& f = found.impulse;
  SlipMotion mean = free;
  mean.slip += 0.5 * (m.slip * f.sliding + m.cross * f.rolling);
  mean.spin += 0.5 * m.roll * f.torsion;
  mean.roll += 0.5 * (m.cross * f.sliding + m.roll * f.rolling);
  const motion::CompliantEnd end = motion::compliant_end<Turns>(law, row, c, mean, c.force);
  const motion::CompliantLoss loss = motion::compliant_loss(row, c.strained - end.stored);
  passed.lost_friction = motion::lost(loss, law, f, mean);
  const Vec3 lever = cross(g.normal, f.sliding);
  passed.linear += f.sliding;
  passed.on_i = g.arm_i * lever, passed.on_j = g.arm_j * lever;
  if (Turns) {
    const Vec3 couple = f.torsion * g.normal + cross(g.normal, f.rolling);
    passed.on_i += couple, passed.on_j -= couple;
  }
  c.friction = f;
  c.elongation = end.elongation, c.strained = end.stored;
  course.after = mean, course.sticks = found.sticks;
}

// Neither fresh nor with springs against torsion and rolling, at a body whose normal turns as a sphere's or not at all.
RICOCHET_INNERMOST bool Cluster::slides_or_holds(const ContactState& c) const noexcept {
  const Model& model = models_[c.model];
  return model.compliant && !model.turns && !c.fresh && !curved(c.record.j);
}

RICOCHET_INNERMOST void Cluster::add_slide(const ContactState& c, const ContactGeometry& g,
                                           const motion::NormalRow& along, Vec3 velocity_mid,
                                           motion::Slides& s) const noexcept {
  const std::size_t k = s.count++;
  const Motion &one = motions_[c.record.i], &other = motions_[c.record.j];
  const TangentialLaw& law = models_[c.model].tangential.law;
  const Spring then = spring(law, c.approach.overlap), now = spring(law, g.overlap);
  const motion::compliant::Carried carried = motion::compliant::carried(then.stiffness, now.stiffness);
  s.normal.set(k, g.normal);
  s.arm_i[k] = g.arm_i, s.arm_j[k] = g.arm_j;
  s.wall[k] = c.record.j >= radii_.size() ? 1 : 0;
  s.velocity.set(k, one.velocity - other.velocity - swept(c, g));
  s.spin_i.set(k, one.spin), s.spin_j.set(k, other.spin);
  s.velocity_mid.set(k, velocity_mid);
  s.swing.set(k, g.arm_i * one.spin_mid + g.arm_j * other.spin_mid);
  s.elongation.set(k, c.elongation.slide);
  s.last.set(k, c.friction.sliding);
  s.span[k] = c.lag;
  s.mobility[k] = slip_mobility(c, g).slip;
  s.stiffness_then[k] = then.stiffness, s.stiffness[k] = now.stiffness, s.damping[k] = now.damping;
  s.of_strain[k] = carried.strain, s.of_motion[k] = carried.motion;
  s.pressing[k] = std::max(0.0, along.impulse);
  s.strained[k] = c.strained;
}

// Where the springs pass more than friction can, the contact slides. In impulses, not in tractions.
RICOCHET_INNERMOST void Cluster::limit_slide(const ContactState& c, motion::Slides& s, std::size_t k) const noexcept {
  const TangentialContact& law = models_[c.model].tangential;
  const double speed = law.friction.depends_on_speed() ? norm(s.foreseen[k]) : 0;
  const double limit = law.friction.coefficient(speed) * s.pressing[k];
  const Vec3 held = s.impulse[k];
  const bool slides = motion::compliant::over(held, limit);
  s.slides[k] = slides ? 1 : 0;
  if (!slides) return;
  const double t = options_.step, span = s.span[k];
  const Spring then{s.stiffness_then[k], s.damping[k]}, now{s.stiffness[k], s.damping[k]};
  const Vec3 start = s.start[k];
  const Vec3 last = span < t ? -t * then.stiffness * start : turned(s.last[k], s.then[k], s.normal[k]);
  const Vec3 led = motion::compliant::led(held, limit, last, motion::compliant::halfway(then, start, s.moved[k], span));
  const Vec3 impulse = contact::cut(led, limit).traction;
  s.impulse.set(k, impulse);
  s.strain.set(k, motion::compliant::slid(then, now, start, -1 / t * last, -1 / t * impulse, span));
}

// All that are gathered in the lanes.
void Cluster::pass_slides(Workspace& space) noexcept {
  motion::Slides& s = space.slides;
  motion::hold(s, options_.step, instructions_);
  for (std::size_t k = 0; k < s.count; ++k) limit_slide(*space.contacts[s.contacts[k]], s, k);
  motion::conclude(s, options_.step, instructions_);
  for (std::size_t k = 0; k < s.count; ++k) {
    const std::uint32_t n = s.contacts[k];
    ContactState& c = *space.contacts[n];
    Passed& p = space.passed[n];
    const Vec3 impulse = s.impulse[k];
    p.linear += impulse, p.on_i = s.on_i[k], p.on_j = s.on_j[k], p.lost_friction = s.lost[k];
    c.friction.sliding = impulse, c.elongation.slide = s.strain[k], c.strained = s.stored[k];
    if (walls_drive_) book_wall(c, space.geometries[n], space.rows[n], p);
    if (!options_.records) continue;
    const Vec3 spin = motions_[c.record.i].spin_mid - motions_[c.record.j].spin_mid, normal = s.normal[k];
    Course course{};
    course.after = {s.mean[k], dot(spin, normal), cross(spin, normal)};
    course.sticks = s.slides[k] == 0;
    note_course(c, space.geometries[n], space.rows[n].rate_mid, course);
  }
  s.count = 0;
}

// Of `course` the mean motion stands in `after`.
void Cluster::note_course(ContactState& c, const ContactGeometry& g, double rate_mid, Course course) const noexcept {
  const auto after = [](const auto& mean, const auto& before) { return 2.0 * mean - before; };
  course.before = slip_before(c, g);
  course.after = {after(course.after.slip, course.before.slip), after(course.after.spin, course.before.spin),
                  after(course.after.roll, course.before.roll)};
  course.rate_mid = rate_mid, course.slip_fraction = 0;
  note_phases(c, g, course);
}

// Returns the velocity of i past j that is foreseen in the middle of the step.
RICOCHET_INNERMOST Vec3 Cluster::pass_normal(const ContactState& c, const ContactGeometry& g, motion::NormalRow& along,
                                             Passed& passed) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  const Vec3 v = motions_[i].velocity_mid - motions_[j].velocity_mid - swept(c, g);
  const double rate = dot(v, g.normal);
  const double rate_free = 2 * rate - along.rate + along.mobility * c.normal_impulse;
  along.impulse = normal_impulse(c, along, rate_free);
  along.rate_mid = rate - 0.5 * along.mobility * (along.impulse - c.normal_impulse);
  passed = {.i = i,
            .j = j,
            .linear = -along.impulse * g.normal,
            .on_i = {},
            .on_j = {},
            .lost_normal = 0,
            .lost_friction = 0,
            .wall_work = 0};
  return v;
}

// What the walls' motion puts into a contact.
void Cluster::book_wall(const ContactState& c, const ContactGeometry& g, const motion::NormalRow& along,
                        Passed& passed) const noexcept {
  passed.wall_work = wall_work(c, g, along.impulse, models_[c.model].rubs() ? c.friction : FrictionImpulse{},
                               motions_[c.record.j].velocity);
}

void Cluster::pass_tangential(ContactState& c, const ContactGeometry& g, const motion::NormalRow& along, Vec3 v,
                              Passed& passed) const noexcept {
  const Model& model = models_[c.model];
  Course course{};
  if (model.turns)
    pass_springs<true>(c, g, along, v, passed, course);
  else if (model.compliant)
    pass_springs<false>(c, g, along, v, passed, course);
  else if (options_.records)
    course.after = motion::slip_of(g, v, motions_[c.record.i].spin_mid, motions_[c.record.j].spin_mid);
  if (options_.records) note_course(c, g, along.rate_mid, course);
  if (walls_drive_) book_wall(c, g, along, passed);
}

}  // namespace ricochet
