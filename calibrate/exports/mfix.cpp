#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>
#include <numbers>

namespace ricochet::calibration {

namespace {

struct Mfix {
  const ContactSet& set;

  std::string setting() const {
    return fmt::format("For the project file with one solids phase and units 'SI'; {}.{}",
                       walls_of(set).empty() ? "walls get the same numbers" : "the numbers with W are the wall's",
                       frictional(set) ? "" : " MEW and MEW_W of 0 are frictionless; put yours in their place.");
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

  std::string friction() const {
    if (!frictional(set)) return "MEW = 0.0\nMEW_W = 0.0\n";
    return fmt::format("MEW = {}\nMEW_W = {}\n", shortest(sliding_of(grains()).mu), shortest(sliding_of(at_wall()).mu));
  }

  /// KT_FAC = k_t/k and DES_ETAT_FAC = c_t/c, each in [0, 1]; nothing where one is not.
  struct Shares {
    double stiffness = 0, damping = 0;
  };
  static std::optional<Shares> shares(const PairCase& p) {
    const auto [k_t, c_t, mu] = sliding_of(p);
    const auto& law = law_of<Linear>(p);
    const Shares s{k_t / law.k(), c_t > 0 ? c_t / law.c() : 0};
    return s.stiffness <= 1 && s.damping <= 1 ? std::optional(s) : std::nullopt;
  }
  /// The four factors; nothing where MFiX would refuse one.
  std::optional<std::string> factors() const {
    if (!frictional(set)) return "";
    const auto pair = shares(grains()), wall = shares(at_wall());
    if (!pair || !wall) return std::nullopt;
    return fmt::format("KT_FAC = {}\nKT_W_FAC = {}\nDES_ETAT_FAC = {}\nDES_ETAT_W_FAC = {}\n",
                       shortest(pair->stiffness), shortest(wall->stiffness), shortest(pair->damping),
                       shortest(wall->damping));
  }

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
    if (is_mindlin(set)) return no_such_tangential("MFiX", "LSD has a constant k_t; take the linear tangential law");
    const auto sliding = factors();
    if (!sliding) return no_such_tangential("MFiX", "LSD wants k_t/k and c_t/c in [0, 1]");
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
{}{})",
                                   shortest(law_of<Linear>(grains()).k()), shortest(law_of<Linear>(at_wall()).k()),
                                   shortest(*en), shortest(*en_wall), *sliding, friction())};
    body.divided_time = own_collision_time(law_of<Linear>(grains()).k(), grains().impact.mass_eff, *en);
    if (frictional(set))
      body.remarks.emplace_back(
          "KT_FAC is k_t/k, DES_ETAT_FAC c_t/c, each of at most 1; without them MFiX takes 2/7 "
          "and 1/2. Not run here: read in its source.");
    if (damped_tangentially(set)) {
      body.fidelity = Fidelity::close;
      body.remarks.emplace_back(
          "MFiX compares the spring's force alone with mu R and adds the dashpot's always, also where the contact "
          "slides: the rebound differs from the law's there.");
    }
    end_otherwise(body, set, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const KuwabaraKono&) const {
    return absent("NOT WRITTEN: MFiX's Hertzian law has no damping proportional to the contact radius.");
  }

  Body operator()(const Tsuji& law) const {
    if (!knows_radii(set)) return needs_radius();
    if (!one_phase()) return several();
    if (frictional(set) && !is_mindlin(set))
      return no_such_tangential("MFiX", "HERTZIAN lets k_t grow with the contact; take mindlin");
    if (damped_tangentially(set))
      return no_such_tangential("MFiX", "HERTZIAN lets c_t change with the contact; take c_t = 0");
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
{friction})",
                        fmt::arg("young", shortest(young->front())), fmt::arg("young_wall", shortest(young->back())),
                        fmt::arg("nu", shortest(set.kinds.front().poisson)),
                        fmt::arg("nu_wall", shortest(set.kinds.back().poisson)), fmt::arg("en", shortest(*en)),
                        fmt::arg("en_wall", shortest(*en_wall)), fmt::arg("friction", friction()))};
    body.divided_time = own_collision_time(law_of<Tsuji>(grains()).k(), grains().impact.mass_eff, *en);
    if (frictional(set)) {
      body.fidelity = Fidelity::close;
      body.remarks.emplace_back(
          "k_t = 8 G* sqrt(R) follows from the same moduli; DES_ET_INPUT of 1 means no c_t. Not "
          "run here: read in its source.");
      body.remarks.push_back(other_mindlin("MFiX", "its tangential elongation is kept while the stiffness grows"));
    }
    end_otherwise(body, set, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const Hysteretic&) const { return absent("NOT WRITTEN: MFiX has no plastic loading and unloading."); }

  template <RemembersAll Law>
  Body operator()(const Law&) const {
    return no_memory("MFiX");
  }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("MFiX", Law::name);
  }
};

}  // namespace

Body write_mfix(const ContactSet& set) {
  if (is_mindlin(set) && std::holds_alternative<Tsuji>(set.pairs.front().law)) {
    const auto sheared = with_shear_moduli(set);
    return sheared ? std::visit(Mfix{*sheared}, set.pairs.front().law) : needs_shear_moduli("MFiX");
  }
  return std::visit(Mfix{set}, set.pairs.front().law);
}

}  // namespace ricochet::calibration
