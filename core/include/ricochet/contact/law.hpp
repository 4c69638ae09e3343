#pragma once

#include <algorithm>
#include <concepts>
#include <string_view>

namespace ricochet {

/// The state of a contact along its normal, as every normal law sees it.
struct Approach {
  double overlap = 0;  ///< ζ [m], Eqs. (5), (16); positive in contact
  double rate = 0;     ///< ζ' [m/s], positive while compressing
};

/// Memory of a law whose force depends on the present approach alone.
struct NoMemory {
  bool operator==(const NoMemory&) const = default;
};

/// A normal contact law: an immutable value (its parameters) plus a small memory of fixed size that travels with the
/// contact. Binary collision, column, cluster and the engine plug-ins all drive this one concept.
///
/// - `force(a, m)` [N]: the law's formula, *signed*; `repulsion` below clamps it. Pure.
/// - `advance(m, before, after, dt)`: steps the memory over dt [s], exactly where the rate is linear over the step.
///   A default-constructed Memory is the state at the first touch, t_b.
/// - `stored_energy(a, m)` [J]: what the law's springs hold. `dissipated_power(a, m)` [W]: what its dashpots burn;
///   never negative. Together: force·rate = d(stored_energy)/dt + dissipated_power wherever the force is smooth.
template <class Law>
concept ContactLaw = std::copyable<Law> && std::copyable<typename Law::Memory> &&
    requires(const Law& law, typename Law::Memory& memory, const typename Law::Memory& past, Approach a, double dt) {
  { Law::name } -> std::convertible_to<std::string_view>;
  { law.force(a, past) }
  noexcept->std::same_as<double>;
  { law.advance(memory, a, a, dt) }
  noexcept->std::same_as<void>;
  { law.stored_energy(a, past) }
  noexcept->std::same_as<double>;
  { law.dissipated_power(a, past) }
  noexcept->std::same_as<double>;
};

/// R = max(0, force) for ζ > 0, else 0 [N]: all laws of the model are repulsive only.
template <ContactLaw Law>
double repulsion(const Law& law, Approach a, const typename Law::Memory& memory) noexcept {
  return a.overlap > 0 ? std::max(0.0, law.force(a, memory)) : 0.0;
}

/// Which zero ends a collision: that of the overlap (24), with the force allowed to turn attractive before, or that of
/// the repulsive force (25).
enum class ContactEnd { overlap, force };

/// Where a collision's force only tends to 0 (26) no zero ends it. It ends, by this convention, where the approach has
/// fallen to this share of the impact velocity: 1e-4 of its energy is left.
inline constexpr double at_rest = 0.01;

/// Whether the force of a binary collision under this law never falls to 0 but only tends to it (26), its bodies never
/// parting: what the law's own `force_fades()` says, no where it has none.
template <class Law>
bool force_fades(const Law& law) noexcept {
  if constexpr (requires { law.force_fades(); })
    return law.force_fades();
  else
    return false;
}

/// What happens when a pair whose force has fallen to zero (25) is pushed together again before it has separated; only
/// where the contact ends by force.
enum class Reclosing {
  repels,  ///< the force stays max(0, ·) of (30), the memory that of t_b: it repels again
  silent   ///< the literal reading: no force until the pair has separated; bodies can pass through each other
};

}  // namespace ricochet
