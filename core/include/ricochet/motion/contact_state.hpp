#pragma once

#include <ricochet/contact/friction.hpp>
#include <ricochet/contact/law.hpp>
#include <ricochet/contact/tangential.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace ricochet {

/// How a collision ended, Definitions 2–7 of the paper.
enum class EncounterEnd {
  open,               ///< it has not
  elastic_rebound,    ///< the overlap returned to zero while the bodies still repelled (24)
  deformed_rebound,   ///< the repulsion fell to zero first, the bodies separating (25)
  dynamic_contact,    ///< (25) without separating, while rolling or sliding
  static_contact,     ///< (25) without any motion
  permanent_contact,  ///< the repulsion only tends to zero (26): the approach has fallen to `at_rest` of that at t_b
  breakage            ///< the same, and the contact has taken up Interaction::breakage_energy (Definition 7)
};
inline constexpr std::size_t encounter_end_count = 7;
std::string_view name(EncounterEnd end) noexcept;

/// What a contact goes through, Definition 4. Several at once are the rule: compression with sliding, say.
enum class Phase { compression, decompression, torsion, sliding, rolling, rest };
inline constexpr std::size_t phase_count = 6;
std::string_view name(Phase phase) noexcept;

/// One collision of one pair, from its first touch until it separates.
struct Encounter {
  static constexpr double never = std::numeric_limits<double>::infinity();

  std::uint32_t i = 0, j = 0;  ///< bodies; walls count from the number of spheres
  double begin = 0;            ///< t_b [s]
  double end = never;  ///< t_e [s]: first zero of the force (25), else of the overlap (24), or at rest (26); t_col =
                       ///< end − begin
  double separation = never;  ///< where the overlap returned to zero [s]; the pair forgets its memory there
  EncounterEnd how = EncounterEnd::open;
  std::array<double, phase_count> phase_begin{never, never, never, never, never, never};  ///< when first entered [s]

  bool operator==(const Encounter&) const = default;
};

/// A contact between two steps: what its future depends on besides its law's memory, which the laws keep side by side.
/// 288 bytes, whatever the law.
struct ContactState {
  Encounter record;
  std::uint32_t model = 0;    ///< which interaction, as the cluster counts them
  std::uint32_t slot = 0;     ///< where the law keeps the memory, as it counts its contacts
  Approach approach;          ///< at the time of the memory
  double force = 0;           ///< signed, then [N]
  double lag = 0;             ///< from that time to the middle of the coming step [s]
  bool fresh = false;         ///< within the contact's first step
  double normal_impulse = 0;  ///< of the last step [N s]
  FrictionImpulse friction;   ///< of the last step, from where the next one is sought
  double stored = 0;          ///< elastic energy and memory at the end of the last step [J]
  double impact_rate = 0;     ///< ζ' at t_b [m/s]
  double speed_scale = 0;     ///< of the meeting [m/s]: a 10⁻⁹ of it counts as no motion
  Elongation elongation;      ///< of a compliant tangential law, at the time of the memory
  double strained = 0;        ///< energy of its springs at the end of the last step [J]
};

}  // namespace ricochet
