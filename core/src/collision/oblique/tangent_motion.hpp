#pragma once

#include <ricochet/collision/oblique.hpp>

#include "element.hpp"
#include "lever.hpp"
#include "normal_path.hpp"

#include <array>
#include <cstddef>

namespace ricochet::collision {

/// Which of the three, as an index.
using Mechanism = std::size_t;
inline constexpr Mechanism sliding = 0, torsion = 1, rolling = 2;
inline constexpr std::array<Mechanism, 3> mechanisms{sliding, torsion, rolling};

/// What holds from one event to the next.
struct Phase {
  bool loading = true;            ///< along the normal, before the turning point
  std::array<bool, 3> sticks{};   ///< by mechanism
  std::array<Vec3, 3> heading{};  ///< direction against which friction acts, at the last step's start
};

/// The motion in the tangent plane while one phase holds, along a given normal motion. Vectors in the frame of the
/// contact: x, y in the plane, z along e. With W = ω×e of either body, T and ρ friction's force and rolling couple
/// turned likewise, m the effective mass:
///   V' = T/m,  W_i' = (a_i T + ρ)/J_i,  W_j' = (a_j T − ρ)/J_j,  Ω' = M (1/J_i + 1/J_j),
///   u = V + a_i W_i + a_j W_j,  roll = W_i − W_j.
/// Carried as changes, so that a grazing impact keeps its digits.
class TangentMotion {
 public:
  enum Part : std::size_t {
    place,         // s of the path
    clock,         // t [s]
    velocity,      // ΔV, two components
    turn_i = 4,    // ΔW_i, two
    turn_j = 6,    // ΔW_j, two
    spin = 8,      // ΔΩ
    slide_spring,  // of sliding, two: p while the contact grows, ξ while it shrinks, as each stays when k changes
    twist_spring = 11,
    roll_spring,  // two
    burnt = 14,   // in the dashpots
    slid,         // in the sliders, by mechanism: three
    parts = 18
  };
  using State = std::array<double, parts>;

  TangentMotion(const NormalPath& path, const TangentialContact& contact, const ObliqueImpact& in_frame,
                const ObliqueOptions& options, const Collision& normal);

  Phase phase;

  void operator()(const State& y, State& rate, double) const;
  /// Error that a step may make in a part.
  double scale(std::size_t part) const noexcept { return scales_[part]; }
  /// Passes the turning point.
  void turn(State& y);
  /// Falls through 0 where the mechanism changes from sticking to slipping or back. `present`: it can do either.
  double margin(Mechanism m, const State& y) const;
  bool present(Mechanism m) const noexcept { return present_[m]; }
  /// A margin as small as this is rounding.
  double rounding(Mechanism m) const noexcept { return phase.sticks[m] ? 10 * spring_scales_[m] : speed_rounding_[m]; }
  /// Notes the headings in `y`.
  void head(const State& y);
  /// Puts springs without a dashpot on their limit, where sliding ends.
  void settle(Mechanism m, State& y) const;
  /// Whether anything can happen in the tangent plane at all.
  bool moves() const noexcept { return moves_; }
  bool rigid() const noexcept { return rigid_; }
  /// Of a rigid disc that slides and spins at once, the slip dies as a power of the spin.
  bool slip_dies_with_spin() const noexcept { return rigid_ && shares_disc() && present_[torsion]; }
  /// Adds what the springs hold at the end, ½p²/k: to the sliders, which let go of it as the limit, or the contact area
  /// of Mindlin's spring, falls to 0; where a dashpot holds it back, to what is left.
  void give_up_strain(const State& y, ObliqueLosses& lost) const;

  /// A compliant contact whose torsion shares the disc's limit: `tangential_step` along the path with `steps` steps
  /// before the turning point and as many after it, to first order in their length. The strain is given up.
  struct Stepped {
    State state{};
    double stick_time = 0;
    int switches = 0;
  };
  bool shares_compliant_disc() const noexcept { return !rigid_ && shares_disc() && present_[torsion]; }
  Stepped stepped(int steps) const;

 private:
  struct View;  // all that follows from a state at once
  struct Walk;  // what steps of the contact's own carry along
  void step(Stepped& out, Walk& walk, double from, double to, bool loading) const;
  View view(const State& y) const;
  void add_elements(View& v) const;
  void add_rigid_forces(View& v) const;
  void add_compliant_forces(View& v) const;
  bool follows_motion(const View& v, Mechanism m) const;
  Vec3 along(const View& v, Mechanism m) const;
  Vec3 acceleration(const View& v, Mechanism m) const;
  void set_scales(const Collision& normal);
  double limit_rate(const View& v, Mechanism m) const;
  ElementRates rates(const View& v, Mechanism m) const;
  bool shares_disc() const noexcept { return contact_.torsion.limit == Torsion::Limit::disc; }

  const NormalPath& path_;
  const TangentialContact& contact_;
  ImpactBody i_, j_;
  ContactArm arm_;
  double inverse_mass_, inverse_i_, inverse_j_, radius_eff_;
  Vec3 slip_, roll_i_, roll_j_, drift_;  // of the start: u, W_i, W_j, V
  double spin_, tcol_ = 0;
  bool rigid_, moves_ = true;
  std::array<bool, 3> present_{};
  State scales_{};
  std::array<double, 3> spring_scales_{}, speed_rounding_{};
};

}  // namespace ricochet::collision
