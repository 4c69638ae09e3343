// Contacts that do not act on each other within a step but by what they passed in the last one: springs and dashpots
// that a step resolves. A block of contacts goes through all of it while it is in the nearest cache.
#include "contact_rows.hpp"

#include <ricochet/motion/cluster.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace ricochet {
namespace {

constexpr std::size_t block_size = 64;

}  // namespace

struct Cluster::Workspace {
  std::array<ContactGeometry, block_size> geometries;
  std::array<motion::NormalRow, block_size> rows;
  std::array<Passed, block_size> passed;
};

// Each contact foresees what the others pass. With u the rates of all contacts, W their common mobility and D its
// diagonal, that is one Jacobi step u' = −W P, (1 + γD) P = h R(u − ½(W − D) P_last) with γ = ½h c; a mode with
// W = κD is stable as long as γD(κ − 1) < ½. The greatest eigenvalue of γW is at most that of the greatest sum, over
// both bodies of a contact, of their contacts' γ/m, so a quarter a body suffices.
void Cluster::add_drag(const ContactState& c, std::int64_t sign) noexcept {
  constexpr double enough = 0.25, unit = 0x1p-32, most = 1e4;
  constexpr auto limit = static_cast<std::int64_t>(enough / unit);
  const Model& model = models_[c.model];
  const std::uint32_t i = c.record.i, j = c.record.j;
  const double along = model.drag ? *model.drag : model.normal->drag(c, inverse_mass_[i] + inverse_mass_[j]);
  const auto add = [&](std::uint32_t body, double arm) {
    const double drag = inverse_mass_[body] * (std::abs(along) + model.damping) +
                        inverse_inertia_[body] * (arm * arm * model.damping + model.turning_damping);
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
  for (const ContactState& c : state_.contacts) add_drag(c, 1);
}

bool Cluster::needs_no_sweeps() {
  for (const Model& model : models_)
    if (model.rubs() && !model.compliant && !model.members.empty()) return false;
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
  share(spheres, [this](std::size_t first, std::size_t last) {
    note_start(first, last);
    fall(first, last);
    if (!long_range_) foresee(first, last);
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
  if (workers_) {
    passed_.resize(state_.contacts.size());
    share(passed_.size(), [this](std::size_t first, std::size_t last) {
      pass_range(first, last, std::span(passed_).subspan(first, last - first));
    });
    share(size(), [this](std::size_t first, std::size_t last) {
      gather(passed_, first, last);
      end_step(first, last);
    });
    book(passed_);
  } else {
    pass_range(0, state_.contacts.size(), {});
    end_step(0, size());
  }
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

// Of contacts first … last − 1, by blocks. Without `passed`, which takes what they pass, that is gathered at once.
void Cluster::pass_range(std::size_t first, std::size_t last, std::span<Passed> passed) {
  Workspace space;
  for (std::size_t k = first; k < last; k += block_size) {
    const std::size_t end = std::min(last, k + block_size);
    const std::span<Passed> these =
        passed.empty() ? std::span(space.passed).first(end - k) : passed.subspan(k - first, end - k);
    pass_block(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(end), space, these);
    if (!passed.empty()) continue;
    gather(these, 0, size());
    book(these);
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

void Cluster::pass_block(std::uint32_t first, std::uint32_t last, Workspace& space, std::span<Passed> passed) {
  auto& geometries = space.geometries;
  auto& rows = space.rows;
  for (std::uint32_t k = first; k < last; ++k) {
    const ContactState& c = state_.contacts[k];
    geometries[k - first] = geometry_of(c);
    rows[k - first] = normal_row(c, geometries[k - first]);
  }
  const auto each_batch = [&](const auto& act) {
    for (const Model& model : models_) {
      const auto from = std::lower_bound(model.members.begin(), model.members.end(), first);
      const auto to = std::lower_bound(from, model.members.end(), last);
      if (from != to) act(*model.normal, motion::NormalBatch{{from, to}, state_.contacts, rows, first});
    }
  };
  each_batch([](motion::NormalContacts& law, const motion::NormalBatch& batch) { law.prepare(batch); });
  for (std::uint32_t k = first; k < last; ++k)
    pass(state_.contacts[k], geometries[k - first], rows[k - first], passed[k - first]);
  const double now = middle();
  each_batch([now](motion::NormalContacts& law, const motion::NormalBatch& batch) { law.conclude(batch, now); });
  for (std::uint32_t k = first; k < last; ++k) {
    passed[k - first].lost_normal = rows[k - first].loss;
    note_end_of_contact(state_.contacts[k], geometries[k - first], rows[k - first]);
  }
}

// What the contacts, in their order, pass to spheres first … last − 1: each sphere's sum is the same whoever makes it.
void Cluster::gather(std::span<const Passed> passed, std::size_t first, std::size_t last) noexcept {
  for (const Passed& p : passed) {
    if (p.i >= last) break;  // contacts are ordered by i < j
    if (p.i >= first) {
      state_.velocity_gains[p.i] += p.linear;
      state_.spin_gains[p.i] += p.on_i;
    }
    if (p.j < first || p.j >= last) continue;
    state_.velocity_gains[p.j] -= p.linear;
    state_.spin_gains[p.j] += p.on_j;
  }
}

void Cluster::book(std::span<const Passed> passed) noexcept {
  for (const Passed& p : passed) {
    state_.lost_normal += p.lost_normal;
    state_.lost_friction += p.lost_friction;
    state_.wall_work += p.wall_work;
  }
}

template <bool Turns>
void Cluster::pass_springs(ContactState& c, const ContactGeometry& g, const motion::NormalRow& along, Vec3 v,
                           Passed& passed, Course* course) const noexcept {
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
  if (course != nullptr) course->after = mean, course->sticks = found.sticks;
}

// The same for the contact that is met most: one that slides or sticks on its spring, neither fresh nor with springs
// against torsion and rolling. In impulses, not in tractions.
void Cluster::pass_slide(ContactState& c, const ContactGeometry& g, const motion::NormalRow& along, Vec3 v,
                         Passed& passed, Course* course) const noexcept {
  const Model& model = models_[c.model];
  const TangentialContact& law = model.tangential;
  const Motion &one = motions_[c.record.i], &other = motions_[c.record.j];
  const double t = options_.step, span = c.lag, m = slip_mobility(c, g).slip;
  const Vec3 n = g.normal, v_start = one.velocity - other.velocity - swept(c, g);
  const Vec3 then = normal_then(c, g, v_start);
  const Spring before = spring(law.law, c.approach.overlap), now = spring(law.law, g.overlap);
  const Vec3 slip = tangential(v_start, n) + cross(g.arm_i * one.spin + g.arm_j * other.spin, n);
  const Vec3 moved = slip - span / t * turning(c, g, v_start);
  const Vec3 start = turned(c.elongation.slide, then, n);
  const Vec3 held = tangential(motion::compliant::strained(before.stiffness, now.stiffness, start, span * moved), n);
  const Vec3 last = tangential(c.friction.sliding, n);
  const Vec3 mean_foreseen = tangential(v, n) + cross(g.arm_i * one.spin_mid + g.arm_j * other.spin_mid, n);
  const Vec3 free = mean_foreseen - 0.5 * m * last;
  const double drag = t * now.damping;
  Vec3 impulse = -1.0 / (1 + 0.5 * drag * m) * (t * now.stiffness * held + drag * free);
  Vec3 elongation = held;
  const double speed = law.friction.depends_on_speed() ? norm(mean_foreseen) : 0;
  const double limit = law.friction.coefficient(speed) * std::max(0.0, along.impulse);
  const bool slides = motion::compliant::over(impulse, limit);
  if (slides) {
    const Vec3 passed_last = span < t ? -t * before.stiffness * start : turned(c.friction.sliding, then, n);
    impulse =
        motion::compliant::led(impulse, limit, passed_last, motion::compliant::halfway(before, start, moved, span));
    impulse = contact::cut(impulse, limit).traction;
    elongation = motion::compliant::relaxed(now, start, -1 / t * passed_last, -1 / t * impulse, span);
  }
  const Vec3 mean = free + 0.5 * m * impulse;
  const double stored = 0.5 * now.stiffness * dot(elongation, elongation);
  const double change = stored - 0.5 * before.stiffness * dot(start, start);
  const double at_end = std::max(0.0, stored + 0.5 * t / span * change);
  const bool sticks = !slides && now.stiffness == before.stiffness;
  passed.lost_friction = sticks ? drag * dot(mean, mean) : c.strained - at_end - dot(impulse, mean);
  const Vec3 lever = cross(n, impulse);
  passed.linear += impulse;
  passed.on_i = g.arm_i * lever, passed.on_j = g.arm_j * lever;
  c.friction.sliding = impulse;
  c.elongation.slide = elongation, c.strained = at_end;
  if (course == nullptr) return;
  const Vec3 spin = one.spin_mid - other.spin_mid;
  course->after = {mean, dot(spin, n), cross(spin, n)};
  course->sticks = !slides;
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

void Cluster::pass(ContactState& c, const ContactGeometry& g, motion::NormalRow& along, Passed& passed) noexcept {
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
  const Model& model = models_[c.model];
  const auto by_law = [&](Course* course) {
    if (model.turns)
      pass_springs<true>(c, g, along, v, passed, course);
    else if (model.compliant && c.fresh)
      pass_springs<false>(c, g, along, v, passed, course);
    else if (model.compliant)
      pass_slide(c, g, along, v, passed, course);
    else if (course != nullptr)
      course->after = motion::slip_of(g, v, motions_[i].spin_mid, motions_[j].spin_mid);
  };
  if (options_.records) {
    Course course{};
    by_law(&course);
    note_course(c, g, along.rate_mid, course);
  } else {
    by_law(nullptr);
  }
  if (walls_drive_)
    passed.wall_work =
        wall_work(c, g, along.impulse, model.rubs() ? c.friction : FrictionImpulse{}, motions_[j].velocity);
}

}  // namespace ricochet
