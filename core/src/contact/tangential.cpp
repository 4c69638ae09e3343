#include "disc_resistance.hpp"

#include <ricochet/contact/tangential.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace ricochet {
namespace {

/// f(std::type_identity<Law>) of each law of the list, in order.
template <class F>
void each(const F& f) {
  [&]<TangentialLawType... L>(std::type_identity<std::variant<L...>>) { (f(std::type_identity<L>{}), ...); }
  (std::type_identity<TangentialLaw>{});
}

}  // namespace

std::string_view name(const TangentialLaw& law) noexcept {
  return std::visit([](const auto& l) { return std::string_view(l.name); }, law);
}

std::span<const Parameter> parameters_of(const TangentialLaw& law) noexcept {
  return std::visit([](const auto& l) { return std::span<const Parameter>(l.parameters); }, law);
}

std::vector<double> values(const TangentialLaw& law) {
  return std::visit(
      [](const auto& l) {
        const auto v = l.values();
        return std::vector<double>(v.begin(), v.end());
      },
      law);
}

bool compliant(const TangentialLaw& law) noexcept {
  return std::visit([](const auto& l) { return l.compliant; }, law);
}

std::vector<std::string_view> tangential_names() {
  std::vector<std::string_view> names;
  names.reserve(std::variant_size_v<TangentialLaw>);
  each([&](auto type) { names.push_back(decltype(type)::type::name); });
  return names;
}

std::optional<std::span<const Parameter>> tangential_parameters(std::string_view name) {
  std::optional<std::span<const Parameter>> found;
  each([&]<class Law>(std::type_identity<Law>) {
    if (Law::name == name) found = Law::parameters;
  });
  return found;
}

std::optional<TangentialLaw> tangential_law(std::string_view name, std::span<const double> values) {
  std::optional<TangentialLaw> found;
  each([&]<class Law>(std::type_identity<Law>) {
    if (Law::name != name) return;
    ParameterValues<Law> own{};
    if (values.size() != own.size())
      throw std::invalid_argument(std::string(name) + ": takes " + std::to_string(own.size()) + " parameters, not " +
                                  std::to_string(values.size()));
    std::copy(values.begin(), values.end(), own.begin());
    found = Law::from(own);
  });
  return found;
}

void check(const TangentialContact& c) {
  support::require_not_negative("torsion stiffness", c.torsion.spring.stiffness);
  support::require_not_negative("torsion damping", c.torsion.spring.damping);
  support::require_not_negative("torsion arm", c.torsion.arm);
  support::require_not_negative("mu_rolling", c.rolling.mu);
  support::require_not_negative("rolling stiffness", c.rolling.spring.stiffness);
  support::require_not_negative("rolling damping", c.rolling.spring.damping);
  if (!compliant(c.law)) return;
  support::require(c.torsion.limit == Torsion::Limit::none || c.torsion.spring.stiffness > 0, "torsion stiffness",
                   c.torsion.spring.stiffness, "> 0 where torsion has a limit");
  const bool rolls = c.rolling.mu > 0 || c.friction.rolling_arm() > 0;
  support::require(!rolls || c.rolling.spring.stiffness > 0, "rolling stiffness", c.rolling.spring.stiffness,
                   "> 0 where rolling has a limit");
}

namespace {

/// What resists over a step: k + c/dt.
double over_step(Spring s, double dt) noexcept { return s.stiffness + s.damping / dt; }

/// Sliding and torsion under the disc's curve: of the motions T*/K and M*/K what the sliders take is what friction of
/// the disc leaves of them, and the traction is that friction.
void cut_by_disc(LimitedTraction& out, const TangentialState& s, const Traction& wanted, double dt) noexcept {
  const double limit = s.sliding_limit, a = s.disc_radius;
  const double force = norm(wanted.sliding), torque = std::abs(wanted.torsion);
  if (limit > 0 && contact::admits_stick(force / limit, torque / (a * limit))) return;
  out.slides = out.twists = true;
  out.traction.sliding = {};
  out.traction.torsion = 0;
  if (!(limit > 0)) return;
  const double along = over_step(s.sliding, dt), about = over_step(s.torsion, dt);
  const auto f = contact::resisted({force / along, a * torque / about}, limit / along, limit * a * a / about);
  if (!f) {
    out.traction = wanted;
    out.slides = out.twists = false;
    return;
  }
  out.traction.sliding = limit * f->force * contact::unit(wanted.sliding);
  out.traction.torsion = std::copysign(limit * a * f->torque, wanted.torsion);
}

}  // namespace

LimitedTraction contact::limited_by_disc(const TangentialState& s, const Traction& wanted, double dt) noexcept {
  LimitedTraction out{.traction = wanted};
  const Cut rolling = cut(wanted.rolling, s.rolling_limit);
  out.traction.rolling = rolling.traction;
  out.rolls = rolling.limit;
  cut_by_disc(out, s, wanted, dt);
  return out;
}

Elongation set_back(const TangentialState& s, const Elongation& before, const Traction& t, double dt) noexcept {
  const auto relaxed = [dt](Spring spring, auto elongation, auto traction) {
    const double whole = over_step(spring, dt);
    return whole > 0 ? (spring.damping / dt * elongation - traction) / whole : 0 * elongation;
  };
  return {relaxed(s.sliding, before.slide, t.sliding), relaxed(s.torsion, before.twist, t.torsion),
          relaxed(s.rolling, before.roll, t.rolling)};
}

namespace {

TangentialEnergy operator-(TangentialEnergy a, const TangentialEnergy& b) noexcept {
  return {a.sliding - b.sliding, a.torsion - b.torsion, a.rolling - b.rolling};
}

/// A growing contact keeps its force.
Elongation carried(const Elongation& e, Spring before, Spring after) noexcept {
  const bool grows = after.stiffness > before.stiffness;
  return grows ? Elongation{before.stiffness / after.stiffness * e.slide, e.twist, e.roll} : e;
}

/// What a spring and its dashpot burn and what its slider does, while they move by `moved` and `strained`.
template <class Motion, class Force>
void burn(double& dashpot, double& slider, Spring s, const Motion& moved, const Motion& strained, const Force& force,
          double dt) noexcept {
  const auto product = [](const auto& a, const auto& b) {
    if constexpr (std::is_same_v<std::decay_t<decltype(a)>, Vec3>)
      return dot(a, b);
    else
      return a * b;
  };
  dashpot = s.damping / dt * product(strained, strained);
  slider += std::max(0.0, -product(force, moved - strained));
}

}  // namespace

TangentialStep tangential_step(const TangentialContact& contact, const Elongation& elongation, const SlipMotion& motion,
                               const Pressing& before, const Pressing& after, double dt) noexcept {
  const TangentialState then = tangential_state(contact, before, norm(motion.slip));
  const TangentialState now = tangential_state(contact, after, norm(motion.slip));
  const Elongation start = carried(elongation, then.sliding, now.sliding);
  const auto asked = [dt](Spring s, auto strain, auto rate) {
    return -1.0 * (s.stiffness * strain + over_step(s, dt) * dt * rate);
  };
  const Traction wanted{asked(now.sliding, start.slide, motion.slip), asked(now.torsion, start.twist, motion.spin),
                        asked(now.rolling, start.roll, motion.roll)};
  TangentialStep step;
  step.answer = limited(now, wanted, dt);
  const Traction& t = step.answer.traction;
  step.elongation = set_back(now, start, t, dt);
  step.stored = stored_energy(now, step.elongation);
  step.sliders = stored_energy(then, elongation) - stored_energy(now, start);
  burn(step.dashpots.sliding, step.sliders.sliding, now.sliding, dt * motion.slip, step.elongation.slide - start.slide,
       t.sliding, dt);
  burn(step.dashpots.torsion, step.sliders.torsion, now.torsion, dt * motion.spin, step.elongation.twist - start.twist,
       t.torsion, dt);
  burn(step.dashpots.rolling, step.sliders.rolling, now.rolling, dt * motion.roll, step.elongation.roll - start.roll,
       t.rolling, dt);
  return step;
}

}  // namespace ricochet
