#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>

namespace ricochet::calibration {

namespace {

struct Mfix {
  const ExportCase& what;

  static std::string setting() {
    return "For the project file with one solids phase and units 'SI'; walls get the same numbers. MEW and MEW_W of 0 "
           "are frictionless; put yours in their place.";
  }
  static std::string attracts() {
    return "MFiX does not clip the attractive part of the force, so contacts end by overlap; calibrate with --end "
           "overlap to meet the target.";
  }
  static Body overdamped() {
    return absent("NOT WRITTEN: MFiX computes the damping from a restitution, which has none for this overdamped law.");
  }

  Body operator()(const Linear& law) const {
    const auto en = logarithmic_restitution(damping_ratio(law, what.impact.mass_eff));
    if (!en) return overdamped();
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          "LSD takes the stiffness and a restitution e, from which it computes c = 2 sqrt(m k) "
                          "|ln e|/sqrt(pi^2 + ln^2 e): exact for a contact ended by overlap, at every mass."},
              .input = fmt::format(R"(DES_COLL_MODEL = 'LSD'
KN = {k}
KN_W = {k}
DES_EN_INPUT(1) = {en}
DES_EN_WALL_INPUT(1) = {en}
MEW = 0.0
MEW_W = 0.0
)",
                                   fmt::arg("k", shortest(law.k())), fmt::arg("en", shortest(*en)))};
    end_otherwise(body, what, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const KuwabaraKono&) const {
    return absent("NOT WRITTEN: MFiX's Hertzian law has no damping proportional to the contact radius.");
  }

  Body operator()(const Tsuji& law) const {
    if (!what.radius_eff) return needs_radius();
    const auto en = logarithmic_restitution(damping_ratio(law, what.impact.mass_eff));
    if (!en) return overdamped();
    const double young = youngs_modulus(effective_modulus(law.k(), *what.radius_eff), poisson);
    const double up_to_21_3 =
        restitution_of_damping(2 / std::sqrt(5.0) * damping_ratio(law, what.impact.mass_eff), ContactEnd::overlap);
    Body body{
        .fidelity = Fidelity::exact,
        .remarks = {setting(),
                    fmt::format("HERTZIAN knows moduli: k = (4/3) E* sqrt(R), E* = E/(2(1-nu^2)) for two equal bodies. "
                                "MFiX up to 21.3.2 computed the damping with a factor 2 in place of sqrt(5) and gives "
                                "{} with these numbers.",
                                rounded(up_to_21_3)),
                    keeps_restitution()},
        .input = fmt::format(R"(DES_COLL_MODEL = 'HERTZIAN'
E_YOUNG(1) = {young}
EW_YOUNG = {young}
V_POISSON(1) = {nu}
VW_POISSON = {nu}
DES_EN_INPUT(1) = {en}
DES_EN_WALL_INPUT(1) = {en}
DES_ET_INPUT(1) = 1.0
DES_ET_WALL_INPUT(1) = 1.0
MEW = 0.0
MEW_W = 0.0
)",
                             fmt::arg("young", shortest(young)), fmt::arg("nu", shortest(poisson)),
                             fmt::arg("en", shortest(*en)))};
    end_otherwise(body, what, ContactEnd::overlap, attracts());
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

Body write_mfix(const ExportCase& what) { return std::visit(Mfix{what}, what.law); }

}  // namespace ricochet::calibration
