#pragma once

#include "contact_motion.hpp"

#include <ricochet/contact/arms_block.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace ricochet::motion {

/// Contacts that slide or stick on their springs, side by side: most of those of a packing. `hold` and `conclude` act
/// on all lanes alike, whatever the unused ones hold.
struct Slides {
  static constexpr std::size_t lanes = 8;
  using Scalars = std::array<double, lanes>;
  struct Vectors {
    Scalars x{}, y{}, z{};
    Vec3 operator[](std::size_t k) const noexcept { return {x[k], y[k], z[k]}; }
    void set(std::size_t k, Vec3 v) noexcept { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
  };

  std::size_t count = 0;
  std::array<std::uint32_t, lanes> contacts{};  ///< which of the block's

  // How they come into the step.
  Vectors normal{};
  Scalars arm_i{}, arm_j{};
  Scalars wall{};                   ///< 1 at a plane that does not turn, else 0
  Vectors velocity{};               ///< of i past j, at the step's start
  Vectors spin_i{}, spin_j{};       ///< at the step's start
  Vectors velocity_mid{}, swing{};  ///< foreseen in its middle: v and arm_i ω_i + arm_j ω_j
  Vectors elongation{};             ///< at the time of the memory
  Vectors last{};                   ///< impulse of the last step
  Scalars span{};                   ///< from the memory to the middle
  Scalars mobility{};
  Scalars stiffness_then{}, stiffness{}, damping{};
  Scalars of_strain{}, of_motion{};  ///< see compliant::Carried
  Scalars pressing{};                ///< normal impulse, at least 0
  Scalars strained{};                ///< energy of the springs at the step's start

  // While they hold; `slides` 1 where the limit then says otherwise, and impulse and strain are those.
  Vectors then{};      ///< normal at the time of the memory
  Vectors moved{};     ///< mean slip since then
  Vectors start{};     ///< the memory, turned
  Vectors foreseen{};  ///< slip in the middle
  Vectors free{};      ///< the same without the contact's own last impulse
  Vectors strain{};    ///< in the middle
  Vectors impulse{};
  Scalars slides{};

  // What comes of it.
  Vectors mean{};  ///< slip
  Vectors on_i{}, on_j{};
  Scalars stored{}, lost{};
};

/// What the springs pass should they hold, over a step [s]. The same bits by any instructions, here and below.
void hold(Slides& s, double step, Instructions by) noexcept;
/// Energies and torques of the impulses.
void conclude(Slides& s, double step, Instructions by) noexcept;

}  // namespace ricochet::motion
