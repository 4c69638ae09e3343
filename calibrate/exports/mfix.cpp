#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>
#include <numbers>

namespace ricochet::calibration {

namespace {

struct Mfix {
  const ContactSet& set;

  std::string setting() const {
    return fmt::format(
        "For the project file with one solids phase and units 'SI'; {}. MEW and MEW_W of 0 are "
        "frictionless; put yours in their place.",
        walls_of(set).empty() ? "walls get the same numbers" : "the numbers with W are the wall's");
  }
  static std::string attracts() {
    return "MFiX does not clip the attractive part of the force, so contacts end by overlap; calibrate with --end "
           "overlap to meet the target.";
  }
  static Body overdamped() {
    return absent("NOT WRITTEN: MFiX computes the damping from a restitution, which has none for this overdamped law.");
  }

  static Body several() {
    return absent("NOT WRITTEN: MFiX's models have one stiffness, and its numbers are written for one solids phase.");
  }

  /// The pair of grains and what meets the wall; the same without a wall.
  const PairCase& grains() const { return *find_pair(set, 0, 0); }
  const PairCase& at_wall() const { return walls_of(set).empty() ? grains() : *find_pair(set, 0, 1); }
  bool one_phase() const { return set.kinds.size() - walls_of(set).size() == 1 && walls_of(set).size() <= 1; }

  /// The restitution of which MFiX computes this law's damping.
  template <class Law>
  static std::optional<double> restitution(const PairCase& pair) {
    return logarithmic_restitution(damping_ratio(law_of<Law>(pair), pair.impact.mass_eff));
  }

  /// What MFiX takes for the collision time of two grains, π/√(k/m − (η/m)²/4) with η = 2√(mk) |ln e|/√(π² + ln²e):
  /// √((π² + ln²e) m/k), for the Hertzian k as if it were a linear one.
  static double own_collision_time(double k, double mass, double en) {
    return std::hypot(std::numbers::pi, std::log(en)) * std::sqrt(mass / k);
  }

  Body operator()(const Linear&) const {
    if (!one_phase()) return several();
    const auto en = restitution<Linear>(grains()), en_wall = restitution<Linear>(at_wall());
    if (!en || !en_wall) return overdamped();
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          "LSD takes the stiffness and a restitution e, from which it computes c = 2 sqrt(m k) "
                          "|ln e|/sqrt(pi^2 + ln^2 e): exact for a contact ended by overlap, at every mass."},
              .input = fmt::format(R"(DES_COLL_MODEL = 'LSD'
KN = {}
KN_W = {}
DES_EN_INPUT(1) = {}
DES_EN_WALL_INPUT(1) = {}
MEW = 0.0
MEW_W = 0.0
)",
                                   shortest(law_of<Linear>(grains()).k()), shortest(law_of<Linear>(at_wall()).k()),
                                   shortest(*en), shortest(*en_wall))};
    body.divided_time = own_collision_time(law_of<Linear>(grains()).k(), grains().impact.mass_eff, *en);
    end_otherwise(body, set, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const KuwabaraKono&) const {
    return absent("NOT WRITTEN: MFiX's Hertzian law has no damping proportional to the contact radius.");
  }

  Body operator()(const Tsuji& law) const {
    if (!knows_radii(set)) return needs_radius();
    if (!one_phase()) return several();
    const auto en = restitution<Tsuji>(grains()), en_wall = restitution<Tsuji>(at_wall());
    if (!en || !en_wall) return overdamped();
    const auto young = youngs_moduli(set);
    if (!young) return needs_materials("MFiX");
    const double up_to_21_3 = restitution_of_damping(
        2 / std::sqrt(5.0) * damping_ratio(law, set.pairs.front().impact.mass_eff), ContactEnd::overlap);
    Body body{
        .fidelity = Fidelity::exact,
        .remarks = {setting(),
                    fmt::format("HERTZIAN knows moduli: k = (4/3) E* sqrt(R), E* = E/(2(1-nu^2)) for two equal bodies. "
                                "MFiX up to 21.3.2 computed the damping with a factor 2 in place of sqrt(5) and gives "
                                "{} with these numbers.",
                                rounded(up_to_21_3)),
                    keeps_restitution()},
        .input =
            fmt::format(R"(DES_COLL_MODEL = 'HERTZIAN'
E_YOUNG(1) = {young}
EW_YOUNG = {young_wall}
V_POISSON(1) = {nu}
VW_POISSON = {nu_wall}
DES_EN_INPUT(1) = {en}
DES_EN_WALL_INPUT(1) = {en_wall}
DES_ET_INPUT(1) = 1.0
DES_ET_WALL_INPUT(1) = 1.0
MEW = 0.0
MEW_W = 0.0
)",
                        fmt::arg("young", shortest(young->front())), fmt::arg("young_wall", shortest(young->back())),
                        fmt::arg("nu", shortest(set.kinds.front().poisson)),
                        fmt::arg("nu_wall", shortest(set.kinds.back().poisson)), fmt::arg("en", shortest(*en)),
                        fmt::arg("en_wall", shortest(*en_wall)))};
    body.divided_time = own_collision_time(law_of<Tsuji>(grains()).k(), grains().impact.mass_eff, *en);
    end_otherwise(body, set, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const Hysteretic&) const { return absent("NOT WRITTEN: MFiX has no plastic loading and unloading."); }

  Body operator()(const Fractional&) const { return no_memory("MFiX"); }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("MFiX", Law::name);
  }
};

}  // namespace

Body write_mfix(const ContactSet& set) { return std::visit(Mfix{set}, set.pairs.front().law); }

}  // namespace ricochet::calibration
