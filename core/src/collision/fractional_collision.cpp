#include "closed_forms.hpp"
#include "numerical_collision.hpp"

#include <ricochet/collision/fractional_collocation.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/root.hpp>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>

namespace ricochet::collision {
namespace {

/// A^{−1/(2−α)} [s], the time in which the motion unfolds.
double unit_of(const Fractional& law, const Impact& impact) {
  return std::pow(impact.mass_eff / law.coefficient(), 1 / (2 - law.alpha()));
}

/// Which zero comes first of those that may end the collision: below α = 0 that of the overlap alone.
ContactEnd first_end(const Fractional& law, ContactEnd asked) { return law.alpha() < 0 ? ContactEnd::overlap : asked; }

CollisionStatus ended_by(ContactEnd end) {
  return end == ContactEnd::force ? CollisionStatus::ended_by_force : CollisionStatus::ended_by_overlap;
}

}  // namespace

Collision closed_form(const Fractional& law, const Impact& impact, ContactEnd end) {
  if (end == ContactEnd::overlap && law.alpha() >= overlap_limit) return {};
  const FractionalContact contact = fractional_contact(law.alpha(), end);
  Collision out;
  out.status = ended_by(first_end(law, end));
  out.tcol = contact.tau;
  out.en = contact.en;
  out.overlap_end = contact.overlap_end * contact.tau;
  out.max_overlap = contact.max_overlap * contact.tau;
  out.time_max_overlap = contact.t_max_overlap * contact.tau;
  out.max_force = contact.max_force / contact.tau;
  out.time_max_force = contact.t_max_force * contact.tau;
  return in_units(out, impact, unit_of(law, impact));
}

Collision come_to_rest(const Fractional& law, const Impact& impact, double breakage_energy) {
  const double a = 2 - law.alpha();
  // E_{a,1}(−y) ≤ 1/(1 + y/Γ(1+a)) for 0 < a ≤ 1 (T. Simon, Electron. J. Probab. 19 (2014)), and Γ(1+a) ≤ 1.
  const double y = support::root([=](double z) { return mittag_leffler(a, 1, -z) - at_rest; }, 0, 1 / at_rest);
  Collision out;
  const bool breaks = energy_at_rest(impact) >= breakage_energy;
  out.status = breaks ? CollisionStatus::breakage : CollisionStatus::permanent_contact;
  out.tcol = out.time_max_overlap = std::pow(y, 1 / a);
  out.overlap_end = out.max_overlap = out.tcol * mittag_leffler(a, 2, -y);
  out.max_force = a < 1 ? 0 : 1;  // of the dashpot: at the touch
  return in_units(out, impact, unit_of(law, impact));
}

// m ζ' = m v₀ − c ζ^{3/2}: in units of m = v₀ = c = 1 the overlap rises to 1 and the force (3/2)ζ^{1/2}ζ' is greatest
// where 1 = 4ζ^{3/2}. With ζ = y² the time ∫ 2y dy/(1 − y³) is regular at the touch.
Collision come_to_rest(const FractionalHertz& law, const Impact& impact, double breakage_energy) {
  const auto time_to = [](double cubed) {
    const auto slowness = [](double y) { return 2 * y / (1 - y * y * y); };
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(slowness, 0.0, std::cbrt(cubed), 12, 1e-14);
  };
  Collision out;
  const bool breaks = energy_at_rest(impact) >= breakage_energy;
  out.status = breaks ? CollisionStatus::breakage : CollisionStatus::permanent_contact;
  out.tcol = out.time_max_overlap = time_to(1 - at_rest);
  out.overlap_end = out.max_overlap = std::pow(1 - at_rest, 2.0 / 3);
  out.time_max_force = time_to(0.25);
  out.max_force = 1.125 * std::cbrt(0.25);
  const double unit = std::pow(impact.mass_eff / (law.c() * std::sqrt(impact.velocity)), 1 / 1.5);
  return in_units(out, impact, unit);
}

Collision follow_fractional(const Fractional& law, const Impact& impact, ContactEnd asked) {
  constexpr int nodes = 32;
  const ContactEnd end = first_end(law, asked);
  const FractionalSolution solved = collocate_collision(law.alpha(), nodes, end);
  // The polynomials carry the speed to some 1e-15 of v₀, and the square of that of an overlap's end: a rebound slower
  // than these is not told from none.
  const double slowest = end == ContactEnd::force ? 1e-12 : 1e-7;
  if (!solved.separated()) return {};
  if (!(solved.en >= slowest)) return {.status = CollisionStatus::out_of_range};
  Collision out = static_cast<const Collision&>(solved);
  if (end == ContactEnd::overlap) out.overlap_end = 0;
  return in_units(out, impact, unit_of(law, impact));
}

}  // namespace ricochet::collision
