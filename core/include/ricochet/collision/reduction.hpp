#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/contact/laws.hpp>
#include <ricochet/support/quarter_power.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>

namespace ricochet {

/// Where a law stands in the units of its impact (mass and velocity 1), as two numbers that a search may move freely:
/// the logarithm of its stiffness and a logarithmic measure of its loss, −∞ of which is the elastic law.
struct Coordinates {
  double scale, loss;
};

/// What a collision time and a restitution leave open of a law that has more than two parameters; each law takes of it
/// what is its own. At one speed nothing but a third number (a stiffness, an overlap) could tell them.
struct Held {
  double alpha = 0.5;       ///< of the laws of real solids
  double stiffening = 100;  ///< fractional-zener: k1/k, that of a polymer between glass and rubber
};

/// A law in the units of its impact.
template <class Law>
struct UnitLaw {
  Law law;                 ///< takes 1 where mass and velocity are 1
  std::size_t collisions;  ///< that it took to find it
  bool closed_form;        ///< its loss is a known function of e_n, not a bracketed root
};

namespace collision {

/// A bracketed root of e_n(loss): the loss at which `collide_at` keeps `en`, sought from the guess ln(−ln e_n) on, as
/// where little is lost it goes with the measure of the loss. nullopt where no loss does; counts the collisions.
struct LossFound {
  double loss;
  std::size_t collisions;
};
std::optional<LossFound> find_loss(const std::function<Collision(double loss)>& collide_at, double en);

/// 1 in the unit of a parameter of that dimension, in SI units, where mass, velocity and t_col are those given.
template <Dimension dimension>
double unit_in_si(double tcol, const Impact& impact) noexcept {
  return support::quarter_power<dimension.kilogram>(impact.mass_eff) *
         support::quarter_power<dimension.metre>(impact.velocity) *
         support::quarter_power<dimension.metre + dimension.second>(tcol);
}

/// `values`, of a law in the units of an impact, in SI units.
template <DescribedLaw Law>
ParameterValues<Law> values_in_si(ParameterValues<Law> values, double tcol, const Impact& impact) noexcept {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((values[I] *= unit_in_si<Law::parameters[I].dimension>(tcol, impact)), ...);
  }
  (std::make_index_sequence<Law::parameters.size()>{});
  return values;
}

}  // namespace collision

/// What calibration has to know of a law: how its parameters set e_n and the scale, in the units of the impact, and how
/// they go over into SI. Search, tables, fits, exports and engines all ask here.
///
/// This is the reduction of any law whose first parameter is its stiffness, whose second is what loses energy (0: an
/// elastic contact), and whose others, if any, keep the values of `Law::held`, by `collide` alone. A law of which more
/// is known specialises it, and may keep of it what fits.
template <DescribedLaw Law>
struct GenericReduction {
  /// The law at `x`, in the units of the impact: parameters e^scale, e^loss.
  static Law at(const Coordinates& x) {
    ParameterValues<Law> values{std::exp(x.scale), std::exp(x.loss)};
    if constexpr (requires { Law::held; }) std::copy(Law::held.begin(), Law::held.end(), values.begin() + 2);
    return Law::from(values);
  }

  /// The same e_n as at {0, loss}, but a collision that takes 1 instead of the `tcol` that it takes there.
  static Coordinates with_unit_tcol(double loss, double tcol) {
    return {slowing(0) * std::log(tcol), loss + slowing(1) * std::log(tcol)};
  }

  /// The law that keeps `en`, brought to the collision time 1. nullopt where no loss does or a double does not carry
  /// it.
  static std::optional<UnitLaw<Law>> unit(double en, ContactEnd end) {
    if (en == 1) return unit_at(0, end, {0, false});
    const auto found = collision::find_loss([&](double loss) { return collide(at({0, loss}), {1, 1}, {end}); }, en);
    if (!found) return std::nullopt;
    return unit_at(std::exp(found->loss), end, {found->collisions, false});
  }

  /// A law in the units of the impact brought to a collision time [s] and an impact; nullopt where a parameter is then
  /// no normal double.
  static std::optional<Law> in_si(const Law& unit, double tcol, const Impact& impact) {
    return representable<Law>(collision::values_in_si<Law>(unit.values(), tcol, impact));
  }

  /// The relative error that the rounding of the parameters to doubles leaves in e_n.
  static double rounding_error(const Law& /*unit*/, ContactEnd, double /*en*/) noexcept { return 0; }
  /// The relative error of `collide` itself, by its numerical path.
  static double numerical_error(ContactEnd, double /*en*/) noexcept { return 1e-9; }

 protected:
  struct Known {
    std::size_t collisions;
    bool closed_form;
  };
  /// The law of these first two parameters, 1 and `damping`, made to collide in the time 1 by one more collision.
  static std::optional<UnitLaw<Law>> unit_at(double damping, ContactEnd end, Known known) {
    ParameterValues<Law> values = at({0, 0}).values();
    values[1] = damping;
    const Collision out = collide(Law::from(values), {1, 1}, {end});
    if (!out.separated()) return std::nullopt;
    const auto law = representable<Law>(collision::values_in_si<Law>(values, 1 / out.tcol, {1, 1}));
    return law ? std::optional(UnitLaw<Law>{*law, known.collisions + 1, known.closed_form}) : std::nullopt;
  }

 private:
  /// The power of a collision's time by which parameter i falls as its unit of time grows.
  static double slowing(std::size_t i) {
    const Dimension d = Law::parameters[i].dimension;
    return -(d.metre + d.second) / 4.0;
  }
};

template <DescribedLaw Law>
struct Reduction : GenericReduction<Law> {};

/// Closed forms for Linear and Tsuji, whose damping ratio β = γ/overdamped_from is a known function of e_n (see
/// damping_ratio.hpp). Relative error of t_col and e_n: that of `collide`; Kuwabara–Kono 1e-10.
template <class Form>
struct Reduction<PowerLaw<Form>> : GenericReduction<PowerLaw<Form>> {
  using Law = PowerLaw<Form>;

  static std::optional<UnitLaw<Law>> unit(double en, ContactEnd end);
  /// Of the linear law ended by overlap: k = π² + λ², c = 2λ with λ = −ln e_n, in the units of the impact.
  static ParameterValues<Law> values_by_overlap(double loss) noexcept requires(Form::stiffness_quarters == 4) {
    return {std::numbers::pi * std::numbers::pi + loss * loss, 2 * loss};
  }
  /// By force none; by overlap that of a damping ratio close to 1, L = |ln e_n|.
  static double rounding_error(const Law&, ContactEnd end, double en) noexcept {
    const double loss = -std::log(en);
    return end == ContactEnd::force ? 0 : (Form::damping_quarters == 0 ? 1e-16 : 1e-15) * loss * loss * loss;
  }
  static double numerical_error(ContactEnd, double) noexcept { return 1e-11; }
};

/// e_n = √(k₁/k₂), t_col = (π/2) √(m/k₁) (1 + e_n). Coordinates: ln k₁, ln(k₂/k₁ − 1).
template <>
struct Reduction<Hysteretic> : GenericReduction<Hysteretic> {
  static Hysteretic at(const Coordinates& x);
  static Coordinates with_unit_tcol(double loss, double tcol) { return {2 * std::log(tcol), loss}; }
  static std::optional<UnitLaw<Hysteretic>> unit(double en, ContactEnd end);
  static ParameterValues<Hysteretic> unit_values(double en) noexcept {
    const double root = 0.5 * std::numbers::pi * (1 + en), k1 = root * root;
    return {k1, k1 / (en * en)};
  }
  static double numerical_error(ContactEnd, double) noexcept { return 1e-11; }
};

/// Only α and c^α k^{1−α} are determined: k and c are both that number in the units of the impact, until `holding`
/// gives k a value. Coordinates: ln c^α k^{1−α}, ln(α/(1−α)).
template <>
struct Reduction<Fractional> : GenericReduction<Fractional> {
  static Fractional at(const Coordinates& x);
  static Coordinates with_unit_tcol(double loss, double tcol);
  static std::optional<UnitLaw<Fractional>> unit(double en, ContactEnd end);
  /// The law of conversion degree α, 0 ≤ α < 1.
  static Fractional of_degree(double alpha);
  static std::optional<Fractional> in_si(const Fractional& unit, double tcol, const Impact& impact);
  static double rounding_error(const Fractional& unit, ContactEnd end, double en) noexcept {
    return end == ContactEnd::overlap ? 1e-15 / (en * en) : 2e-16 / (1 - unit.alpha());
  }
  static double numerical_error(ContactEnd end, double en) noexcept {
    return 1e-11 + (end == ContactEnd::force ? 1e-14 / en : 0);
  }
  /// `in_si` with the k [kg/s²] that is wanted, from c^α k^{1−α} in the units of the impact: k (c/k)^α, solved for c.
  /// The elastic α = 0 leaves c free: √(k m) stands for it. nullopt where c is no normal double.
  static std::optional<Fractional> holding(double k, double coefficient, double alpha, double tcol, double mass_eff);
};

/// α is held. Coordinates: ln k and ln g, g = (c/k)(k/m)^{α/2}, which is one number with c at k = m = 1. With α held
/// e_n falls from 1 to that of the fractional law of the same α as g grows, by force: no less is reached.
template <>
struct Reduction<FractionalKelvinVoigt> : GenericReduction<FractionalKelvinVoigt> {
  static FractionalKelvinVoigt at(const Coordinates& x, const Held& held = {});
  static Coordinates with_unit_tcol(double loss, double tcol) { return {2 * std::log(tcol), loss}; }
  static std::optional<UnitLaw<FractionalKelvinVoigt>> unit(double en, ContactEnd end, const Held& held = {});
  static std::optional<FractionalKelvinVoigt> in_si(const FractionalKelvinVoigt& unit, double tcol,
                                                    const Impact& impact);
  /// See restitution_bound (collision/reach.hpp).
  static double restitution_bound(ContactEnd end, const Held& held);
  /// The α at which the law of this k > 0, in the units of the impact, keeps e_n and takes 1: with k given t_col and
  /// e_n leave nothing open. With α from that of the fractional law of e_n to 1, k grows from 0 to the linear law's.
  /// nullopt for a greater k, and at e_n = 1, where no dashpot is left that α could be of.
  /// Throws std::invalid_argument unless k > 0.
  static std::optional<double> degree(double k, double en, ContactEnd end);
  static double rounding_error(const FractionalKelvinVoigt&, ContactEnd end, double en) noexcept {
    return end == ContactEnd::overlap ? 1e-15 / (en * en) : 0;
  }
  static double numerical_error(ContactEnd end, double en) noexcept {
    return 1e-11 + (end == ContactEnd::force ? 1e-14 / en : 1e-15 / (en * en));
  }
};

/// The same, g = (c/k) T_H^{−α}; no less e_n is reached than that of k = 0.
template <>
struct Reduction<FractionalHertz> : GenericReduction<FractionalHertz> {
  static FractionalHertz at(const Coordinates& x, const Held& held = {});
  static Coordinates with_unit_tcol(double loss, double tcol) { return {2.5 * std::log(tcol), loss}; }
  static std::optional<UnitLaw<FractionalHertz>> unit(double en, ContactEnd end, const Held& held = {});
  static std::optional<FractionalHertz> in_si(const FractionalHertz& unit, double tcol, const Impact& impact);
  static double restitution_bound(ContactEnd end, const Held& held);
  static double numerical_error(ContactEnd, double en) noexcept { return 1e-11 + 1e-14 / en; }
};

/// α and k₁/k are held. Coordinates: ln k and ln (k₁/k)(τ√(k/m))^α, the g of the Kelvin–Voigt law that this one is for
/// short τ. Along τ e_n falls to a least value and returns to 1; the shorter τ is answered, which is the one that
/// Kelvin–Voigt's continues.
template <>
struct Reduction<FractionalZener> : GenericReduction<FractionalZener> {
  static FractionalZener at(const Coordinates& x, const Held& held = {});
  static Coordinates with_unit_tcol(double loss, double tcol) { return {2 * std::log(tcol), loss}; }
  static std::optional<UnitLaw<FractionalZener>> unit(double en, ContactEnd end, const Held& held = {});
  /// The coordinate of the least e_n.
  static double lossiest(const Held& held);
  static double restitution_bound(ContactEnd end, const Held& held);
  static double numerical_error(ContactEnd, double) noexcept { return 1e-7; }
};

/// A law of which `Held` holds something.
template <class Law>
concept HoldsDegree = requires(const Coordinates& x, const Held& held) {
  Reduction<Law>::at(x, held);
};

// The same of a law that is known only as one of the list.

/// Does `Held` hold the α of that law?
bool holds_degree(LawKind kind) noexcept;
/// The law at `x`, in the units of the impact.
AnyLaw scaled_law(LawKind kind, const Coordinates& x, const Held& held = {});
Coordinates with_unit_tcol(LawKind kind, double loss, double tcol);

/// The law of that kind that keeps e_n. Each kind has one dimensionless group that sets e_n and a scale that sets
/// t_col. In exact arithmetic each reaches every e_n in (0, 1], but for the laws of real solids at what is held.
/// nullopt where it does not, or a double cannot carry it: a parameter is no normal double, a collision out of range,
/// or fractional with e_n < 1e-15 (by overlap 1e-6).
/// Throws std::invalid_argument unless 0 < en ≤ 1, the kind ends so, and what is held lies in its domain.
std::optional<UnitLaw<AnyLaw>> unit_law(LawKind kind, double en, ContactEnd end, const Held& held = {});

/// `unit_law` brought to a collision time [s] and an impact; nullopt where a parameter is then no normal double.
/// Throws std::invalid_argument for a scale not finite and > 0.
std::optional<AnyLaw> at_impact(const AnyLaw& unit_law, double tcol, const Impact& impact);

/// See Reduction.
double rounding_error(const AnyLaw& unit_law, ContactEnd end, double en);
double numerical_error(LawKind kind, ContactEnd end, double en);

/// The law of that kind whose binary collision takes `tcol` [s] and keeps `en` of the velocity, at the given impact and
/// end: the first guess-free step of any study that compares laws at equal (t_col, e_n). Of the fractional law only α
/// and c^α k^{1−α} are determined; c = k in number here. Elastic contacts are left out.
/// Throws std::invalid_argument unless tcol > 0, 1e-3 ≤ en < 1, and the kind ends so; std::overflow_error where a
/// parameter is no normal double or the law does not reach en with what is held of it.
AnyLaw tuned_law(LawKind kind, double tcol, double en, const Impact& impact, ContactEnd end = ContactEnd::force,
                 const Held& held = {});

/// The fractional law of conversion degree α, 0 < α < 0.97, whose binary collision takes `tcol` [s].
Fractional tuned_fractional(double alpha, double tcol, double mass_eff);

}  // namespace ricochet
