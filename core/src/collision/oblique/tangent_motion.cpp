#include "tangent_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::collision {
namespace {

Vec3 plane(const TangentMotion::State& y, std::size_t part) noexcept { return {y[part], y[part + 1], 0}; }

void put(TangentMotion::State& y, std::size_t part, Vec3 a, double scale) noexcept {
  y[part] = scale * a.x;
  y[part + 1] = scale * a.y;
}

void put_spring(TangentMotion::State& y, Mechanism m, Vec3 a, double scale) noexcept {
  if (m == torsion)
    y[TangentMotion::twist_spring] = scale * a.x;
  else
    put(y, m == sliding ? TangentMotion::slide_spring : TangentMotion::roll_spring, a, scale);
}

/// ω×e in the frame of the contact, e = z.
Vec3 turned(Vec3 spin) noexcept { return {spin.y, -spin.x, 0}; }

double inverse_inertia(const ImpactBody& b) noexcept {
  return b.is_wall() ? 0 : 1 / (b.inertia_ratio * b.mass * b.radius * b.radius);
}

}  // namespace

struct TangentMotion::View {
  NormalInstant normal;
  Lever lever;
  Vec3 roll_i, roll_j, slip, roll;  // W_i, W_j, u, W_i − W_j
  double spin = 0, speed = 0;       // Ω, |u|
  SlipMobility mobility;
  std::array<Element, 3> element{};
  std::array<Vec3, 3> spring{}, motion{}, force{};  // p, v and −T by mechanism; torsion in x
  std::array<Vec3, 3> turning{};                    // dn/dt of directions that are slaves of the motion's
};

TangentMotion::TangentMotion(const NormalPath& path, const TangentialContact& contact, const ObliqueImpact& in_frame,
                             const ObliqueOptions& options, const Collision& normal)
    : path_(path),
      contact_(contact),
      i_(in_frame.i),
      j_(in_frame.j),
      arm_(options.arm),
      inverse_mass_(1 / i_.mass + 1 / j_.mass),
      inverse_i_(inverse_inertia(i_)),
      inverse_j_(inverse_inertia(j_)),
      radius_eff_(1 / (1 / i_.radius + 1 / j_.radius)),
      roll_i_(turned(i_.spin)),
      roll_j_(j_.is_wall() ? Vec3{} : turned(j_.spin)),
      drift_(tangential(i_.velocity - j_.velocity, {0, 0, 1})),
      spin_(i_.spin.z - (j_.is_wall() ? 0 : j_.spin.z)),
      rigid_(!compliant(contact.law)) {
  const double arm_j = j_.is_wall() ? 0 : j_.radius;
  slip_ = drift_ + i_.radius * roll_i_ + arm_j * roll_j_;
  slip_.y = 0;  // the frame's x is along the slip
  present_ = {contact.friction.mu_static() > 0, contact.torsion.limit != Torsion::Limit::none && spin_ != 0,
              contact.friction.rolling_arm() > 0 || contact.rolling.mu > 0};

  set_scales(normal);
}

/// By what friction can change at most and what there is to change, and by what is rounding.
void TangentMotion::set_scales(const Collision& normal) {
  constexpr double tolerance = 1e-12, rounding = 1e-15;  // of a whole step, whose halves are 2⁸ times as good
  const Friction& f = contact_.friction;
  const double arm_j = j_.is_wall() ? 0 : j_.radius, arm = i_.radius + arm_j;
  const double turning = i_.radius * (norm(roll_i_) + std::abs(spin_)) + arm_j * norm(roll_j_);
  const bool turns = arm_ == ContactArm::contact_point || present_[rolling] || present_[torsion];
  const double speed = norm(slip_) + (turns ? turning : 0), mu = f.mu_static() + f.rolling_arm() + contact_.rolling.mu;
  const double impulse = std::min(speed, mu * (i_.velocity.z - j_.velocity.z)) / inverse_mass_;
  moves_ = impulse > 0;
  tcol_ = normal.tcol;
  const double force = impulse / normal.tcol, change = tolerance * impulse * inverse_mass_;
  scales_.fill(tolerance * path_.length());
  scales_[clock] = tolerance * normal.tcol;
  std::fill_n(scales_.begin() + velocity, 2, change);
  std::fill_n(scales_.begin() + turn_i, 4, change / arm);
  scales_[spin] = change / arm;
  const double strained = spring(contact_.law, normal.max_overlap).stiffness * speed * normal.tcol;
  const double slack = tolerance * force + path_.noise() * mu * normal.max_force + rounding * strained;
  std::fill_n(scales_.begin() + burnt, 4, slack * speed * normal.tcol);
  spring_scales_ = {slack, slack * arm, slack * arm};
  for (const Mechanism m : mechanisms) put_spring(scales_, m, {1, 1, 0}, spring_scales_[m]);
  speed_rounding_ = {1e-11 * speed, 1e-11 * speed / arm, 1e-11 * speed / arm};
}

TangentMotion::View TangentMotion::view(const State& y) const {
  View v;
  v.normal = path_.at(y[place], phase.loading);
  v.lever = lever(i_, j_, arm_, v.normal.overlap);
  v.roll_i = roll_i_ + plane(y, turn_i);
  v.roll_j = roll_j_ + plane(y, turn_j);
  const double arm_j = j_.is_wall() ? 0 : j_.radius;
  // Of the changes, what the arms have lost included.
  v.slip = slip_ + (plane(y, velocity) + v.lever.arm_i * plane(y, turn_i) + v.lever.arm_j * plane(y, turn_j) +
                    (v.lever.arm_i - i_.radius) * roll_i_ + (v.lever.arm_j - arm_j) * roll_j_);
  v.roll = v.roll_i - v.roll_j;
  v.spin = spin_ + y[spin];
  v.speed = norm(v.slip);
  const Lever& l = v.lever;
  v.mobility = {inverse_mass_ + l.arm_i * l.arm_i * inverse_i_ + l.arm_j * l.arm_j * inverse_j_,
                l.arm_i * inverse_i_ - l.arm_j * inverse_j_, inverse_i_ + inverse_j_};
  v.motion = {v.slip, Vec3{v.spin, 0, 0}, v.roll};
  add_elements(v);
  v.spring = {plane(y, slide_spring), Vec3{y[twist_spring], 0, 0}, plane(y, roll_spring)};
  if (!phase.loading)
    for (const Mechanism m : mechanisms) v.spring[m] *= v.element[m].stiffness;
  if (rigid_)
    add_rigid_forces(v);
  else
    add_compliant_forces(v);
  return v;
}

void TangentMotion::add_elements(View& v) const {
  const NormalInstant& n = v.normal;
  const TangentialState s = tangential_state(contact_, {n.force, n.overlap, v.lever.radius, radius_eff_}, v.speed);
  const auto element = [](Spring spring, double limit) { return Element{spring.stiffness, 0, spring.damping, limit}; };
  v.element = {element(s.sliding, s.sliding_limit), element(s.torsion, s.torsion_limit),
               element(s.rolling, s.rolling_limit)};
  // Every k_t is constant or goes like √ζ.
  if (std::holds_alternative<MindlinTangential>(contact_.law))
    v.element[sliding].stiffness_rate = 0.5 * s.sliding.stiffness * n.rate / n.overlap;
}

/// Without a dashpot the direction n of a sliding spring turns towards the motion's at the rate k|v|/L, n' = (k/L)(v −
/// n n·v). Past 1e5 a collision it is its slave, n ∥ v − (L/k) n' with n' that of v, to 1e-10 of the angle it turns by.
bool TangentMotion::follows_motion(const View& v, Mechanism m) const {
  const Element& e = v.element[m];
  const double turns = e.stiffness * norm(v.motion[m]) * tcol_;
  return !rigid_ && !phase.sticks[m] && e.damping == 0 && turns > 1e5 * e.limit;
}

/// The direction against which friction acts where it slides: that of rigid slip, or of what spring and dashpot want.
/// Carried on smoothly through 0, which a step may pass before it is cut there and where springs end.
Vec3 TangentMotion::along(const View& v, Mechanism m) const {
  const Element& e = v.element[m];
  const Vec3 before = phase.heading[m];
  if (follows_motion(v, m)) return direction(v.motion[m] - e.limit / e.stiffness * v.turning[m], before);
  const bool damped = !rigid_ && e.damping > 0;
  const Vec3 wanted = rigid_ ? v.motion[m] : damped ? e.wanted(v.spring[m], v.motion[m]) : v.spring[m];
  if (!rigid_ && norm(wanted) <= spring_scales_[m]) return before;
  const Vec3 now = direction(wanted, before);
  return !damped && dot(now, before) < 0 ? -now : now;
}

void TangentMotion::add_compliant_forces(View& v) const {
  const auto add = [&] {
    for (const Mechanism m : mechanisms)
      if (present_[m])
        v.force[m] = phase.sticks[m] ? v.element[m].wanted(v.spring[m], v.motion[m]) : v.element[m].limit * along(v, m);
  };
  add();
  bool again = false;
  for (const Mechanism m : {sliding, rolling}) {
    if (!present_[m] || !follows_motion(v, m)) continue;
    const Vec3 n = direction(v.motion[m], {}), change = acceleration(v, m);
    v.turning[m] = (change - dot(n, change) * n) / norm(v.motion[m]);
    again = true;
  }
  if (again) add();
}

/// du/dt, or that of the rolling.
Vec3 TangentMotion::acceleration(const View& v, Mechanism m) const {
  const auto& [slip, cross, roll] = v.mobility;
  if (m == rolling) return -cross * v.force[sliding] - roll * v.force[rolling];
  const Vec3 drift = v.normal.rate * (v.lever.arm_i_slope * v.roll_i + v.lever.arm_j_slope * v.roll_j);
  return drift - slip * v.force[sliding] - cross * v.force[rolling];
}

/// Sliding forces first, then what sticks: that u' or the change of rolling, or both, be 0.
void TangentMotion::add_rigid_forces(View& v) const {
  const auto& [slip, cross, roll] = v.mobility;
  const bool disc = shares_disc() && present_[torsion] && !phase.sticks[torsion];
  const double a = v.lever.radius;
  const DiscFriction share = disc ? disc_friction(v.speed / (a * std::abs(v.spin))) : DiscFriction{1, 2.0 / 3};
  if (present_[torsion] && !phase.sticks[torsion])
    v.force[torsion] = v.element[torsion].limit * (disc ? 1.5 * share.torque : 1) * along(v, torsion);
  const bool holds_slip = present_[sliding] && phase.sticks[sliding];
  const bool holds_roll = present_[rolling] && phase.sticks[rolling];
  if (present_[sliding] && !holds_slip) v.force[sliding] = v.element[sliding].limit * share.force * along(v, sliding);
  if (present_[rolling] && !holds_roll) v.force[rolling] = v.element[rolling].limit * along(v, rolling);
  const Vec3 drift = v.normal.rate * (v.lever.arm_i_slope * v.roll_i + v.lever.arm_j_slope * v.roll_j);
  if (holds_slip && holds_roll) {
    const double determinant = slip * roll - cross * cross;
    v.force[sliding] = roll / determinant * drift;
    v.force[rolling] = -cross / determinant * drift;
  } else if (holds_slip) {
    v.force[sliding] = (drift - cross * v.force[rolling]) / slip;
  } else if (holds_roll) {
    v.force[rolling] = -cross / roll * v.force[sliding];
  }
}

double TangentMotion::limit_rate(const View& v, Mechanism m) const {
  const NormalInstant& n = v.normal;
  const Friction& f = contact_.friction;
  const double a = v.lever.radius, widens = v.lever.radius_slope * n.rate;
  if (m == rolling)
    return (f.rolling_arm() * a + contact_.rolling.mu * radius_eff_) * n.slope + f.rolling_arm() * widens * n.force;
  const double mu = f.coefficient(v.speed);
  double fading = 0;  // dμ/dt
  if (f.decay() > 0 && v.speed > 0)
    fading = -f.decay() * (mu - f.mu_dynamic()) * dot(v.slip, acceleration(v, sliding)) / v.speed;
  const double sliding_rate = mu * n.slope + fading * n.force;
  if (m == sliding) return sliding_rate;
  return contact_.torsion.arm * (a * sliding_rate + widens * mu * n.force);
}

ElementRates TangentMotion::rates(const View& v, Mechanism m) const {
  const Element& e = v.element[m];
  if (rigid_) return {{}, 0, dot(v.force[m], v.motion[m]), 0};
  if (phase.sticks[m]) return stuck(e, v.spring[m], v.motion[m]);
  const Vec3 n = along(v, m), motion = v.motion[m];
  const Vec3 sideways = follows_motion(v, m) ? e.limit / e.stiffness * v.turning[m] : motion - dot(n, motion) * n;
  return slides(e, limit_rate(v, m), n, sideways, v.spring[m], motion);
}

void TangentMotion::operator()(const State& y, State& rate, double) const {
  const View v = view(y);
  rate.fill(0);
  rate[place] = 1;
  const double pace = v.normal.pace;
  rate[clock] = pace;
  const Vec3 T = -v.force[sliding], R = -v.force[rolling];
  put(rate, velocity, inverse_mass_ * T, pace);
  put(rate, turn_i, inverse_i_ * (v.lever.arm_i * T + R), pace);
  put(rate, turn_j, inverse_j_ * (v.lever.arm_j * T - R), pace);
  rate[spin] = -pace * v.mobility.roll * v.force[torsion].x;
  for (const Mechanism m : mechanisms) {
    if (!present_[m]) continue;
    const ElementRates r = rates(v, m);
    put_spring(rate, m, r.strain, pace * (phase.loading ? v.element[m].stiffness : 1));
    rate[burnt] += pace * r.dashpot;
    rate[slid + m] = pace * r.slider;
  }
}

double TangentMotion::margin(Mechanism m, const State& y) const {
  const View v = view(y);
  if (!rigid_) return rates(v, m).margin;
  if (phase.sticks[m]) {
    const double held = norm(v.force[m]);
    return held > 0 ? v.element[m].limit - held : 1;
  }
  if (m == sliding && slip_dies_with_spin() && !phase.sticks[torsion]) return 1;
  return dot(v.motion[m], phase.heading[m]);
}

void TangentMotion::turn(State& y) {
  const View v = view(y);
  phase.loading = false;
  if (rigid_) return;
  for (const Mechanism m : mechanisms) {
    const double k = v.element[m].stiffness;
    if (!(k > 0)) continue;
    put_spring(y, m, v.spring[m], 1 / k);
    put_spring(scales_, m, spring_scales_[m] * Vec3{1, 1, 0}, 1 / k);
  }
}

void TangentMotion::head(const State& y) {
  const View v = view(y);
  for (const Mechanism m : mechanisms) {
    const Vec3 wanted = rigid_ ? v.motion[m] : v.element[m].wanted(v.spring[m], v.motion[m]);
    const bool clear = rigid_ || norm(wanted) > spring_scales_[m];
    if (clear) phase.heading[m] = direction(wanted, phase.heading[m]);
    if (phase.heading[m] == Vec3{}) phase.heading[m] = direction(v.motion[m], {});
  }
}

void TangentMotion::settle(Mechanism m, State& y) const {
  const View v = view(y);
  const Element& e = v.element[m];
  if (rigid_ || e.damping > 0) return;
  put_spring(y, m, along(v, m), phase.loading ? e.limit : e.limit / e.stiffness);
}

void TangentMotion::give_up_strain(const State& y, ObliqueLosses& lost) const {
  const View v = view(y);
  const std::array sliders{&lost.sliding, &lost.torsion, &lost.rolling};
  for (const Mechanism m : mechanisms) {
    const Element& e = v.element[m];
    if (!present_[m] || !e.present()) continue;
    const bool area_vanishes =
        m == sliding && path_.closes() && std::holds_alternative<MindlinTangential>(contact_.law);
    const bool held_back = e.damping > 0 && !area_vanishes;
    (held_back ? lost.stored : *sliders[m]) += 0.5 * dot(v.spring[m], v.spring[m]) / e.stiffness;
  }
}

}  // namespace ricochet::collision
