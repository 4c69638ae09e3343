#pragma once

#include <ricochet/collision/collision.hpp>

#include <concepts>
#include <functional>

namespace ricochet {

/// The binary collision under a constant load N [N] that presses the bodies together, m ζ'' + R = N: a sphere that
/// falls on a plate has N = m g. It ends by force (25), where R falls to 0, if it does: under a load the bodies part
/// only above some speed (`least_speed_to_part`), below it they swing about ζ(R = N) or creep, which is no_separation.
///
/// e_n = −ζ'(t_e)/v₀ falls as the speed does: what R takes out of a contact that lasts longer and longer is the law's,
/// the load itself takes nothing (c = 0: e_n = 1 whatever the load). N T/(m v₀), T the contact's time, is the new
/// group. That R is 0 does not mean that the load leaves the bodies apart: `clears` tells.
///
/// Any law but those below: generic `collide`, the load in the momentum of each step. Error: that of `collide`, times
/// 1 + N t_col/(m v₀), which is to be below 100: beyond, whether R grazes 0 is not told. Throws std::invalid_argument
/// as `collide`, and for a load that is negative or not finite.
template <ContactLaw Law>
Collision collide_under_load(const Law& law, const Impact& impact, double load, const CollideOptions& options = {});

/// The fractional law, 0 ≤ α < 1, in closed form. The equation is linear, so the load adds (N/m) times the integral of
/// the motion without it: with y = A t^a, a = 2−α,
///   ζ' = v₀ E_{a,1}(−y) + (N/m) t E_{a,2}(−y),   R = m A v₀ t^{1−α} E_{a,a}(−y) + N (1 − E_{a,1}(−y)).
/// Error: 1e-11 of tcol and en, more where R grazes 0. Throws std::invalid_argument for another α.
Collision collide_under_load(const Fractional& law, const Impact& impact, double load,
                             const CollideOptions& options = {});

/// The laws of real solids. Kelvin–Voigt and Zener by the same superposition of the transforms, y' and ∫y of the
/// motion y without the load; Hertz by collocation of x' = v₀ + N t/m − …. Error: 1e-11, more where R grazes 0;
/// fractional-hertz 1e-10.
Collision collide_under_load(const FractionalKelvinVoigt& law, const Impact& impact, double load,
                             const CollideOptions& options = {});
Collision collide_under_load(const FractionalHertz& law, const Impact& impact, double load,
                             const CollideOptions& options = {});
Collision collide_under_load(const FractionalZener& law, const Impact& impact, double load,
                             const CollideOptions& options = {});

namespace collision {
void require_load(double load);
/// The least speed at which `parts` holds, to 3e-4, sought from a guess on; see least_speed_to_part.
double speed_to_part(const std::function<bool(double)>& parts, double guess);
}  // namespace collision

template <ContactLaw Law>
Collision collide_under_load(const Law& law, const Impact& impact, double load, const CollideOptions& options) {
  collision::require_load(load);
  collision::Driven<Law> driven(law);
  return collision::follow(driven, impact, options, load);
}

template <std::same_as<AnyLaw> Any>
Collision collide_under_load(const Any& law, const Impact& impact, double load, const CollideOptions& options = {}) {
  return std::visit([&](const auto& one) { return collide_under_load(one, impact, load, options); }, law);
}

/// Whether bodies that leave a contact with e_n at the given speed get clear of the overlap that it left them with,
/// against the load and no other force: (e_n v₀)² ≥ 2 N ζ(t_e)/m.
bool clears(const Collision& out, const Impact& impact, double load);

/// The speed [m/s] below which the bodies do not come off under that load > 0: there e_n stops being defined. To three
/// digits. 0 where they still part at N t_col/(128 m), t_col that without a load, as they do at any speed where nothing
/// is lost or the law is hysteretic; infinite where they part at none. Throws as collide_under_load.
double least_speed_to_part(const AnyLaw& law, double mass_eff, double load);

}  // namespace ricochet
