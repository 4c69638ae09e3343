#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>

namespace ricochet::calibration {

namespace {

struct Yade {
  const ExportCase& what;

  static std::string setting() {
    return "Defines material, ip2 and law2: O.materials.append(material), and "
           "InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [ip2], [law2]). Set NewtonIntegrator(damping=0): its default "
           "of 0.2 would slow every grain. Grains are "
           "frictionless here.";
  }
  static std::string clips() {
    return "Yade clips the attractive part of this law's force, so contacts end by force; calibrate with --end force "
           "to meet the target.";
  }

  std::string material(const std::string& of, const std::string& arguments) const {
    const std::string density = what.density ? fmt::format("density={}, ", shortest(*what.density)) : "";
    return fmt::format("material = {}({}{}, frictionAngle=0)", of, density, arguments);
  }

  Body operator()(const Linear& law) const {
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          "Yade joins the two grains' springs and dashpots in series, so the material "
                          "carries twice the pair's k and c."},
              .input = fmt::format(R"({}
ip2 = Ip2_ViscElMat_ViscElMat_ViscElPhys()
law2 = Law2_ScGeom_ViscElPhys_Basic()
)",
                                   material("ViscElMat", fmt::format("kn={}, cn={}, ks=0, cs=0", shortest(2 * law.k()),
                                                                     shortest(2 * law.c()))))};
    end_otherwise(body, what, ContactEnd::force, clips());
    return body;
  }

  Body operator()(const KuwabaraKono&) const {
    return absent("NOT WRITTEN: Yade's Hertzian laws have no damping proportional to the contact radius.");
  }

  Body operator()(const Tsuji& law) const {
    if (!what.radius_eff) return needs_radius();
    const double young = youngs_modulus(effective_modulus(law.k(), *what.radius_eff), poisson);
    // c = 2 betan √(m K_t), K_t = (3/2)kζ^{1/2}, and c = β√(5mk)ζ^{1/4}.
    const double betan = damping_ratio(law, what.impact.mass_eff) * std::sqrt(5.0 / 6.0);
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          "Mindlin's law knows moduli: k = (4/3) E* sqrt(R), E* = E/(2(1-nu^2)) for two equal "
                          "bodies. betan is the fraction of the critical damping of the tangent stiffness, "
                          "exact at every mass; en= would go through a polynomial, and in Yade of 2019 "
                          "through a formula for another end of contact.",
                          keeps_restitution()},
              .input = fmt::format(
                  R"({}
ip2 = Ip2_FrictMat_FrictMat_MindlinPhys(betan={}, betas=0)
law2 = Law2_ScGeom_MindlinPhys_Mindlin()
)",
                  material("FrictMat", fmt::format("young={}, poisson={}", shortest(young), shortest(poisson))),
                  shortest(betan))};
    end_otherwise(body, what, ContactEnd::force, clips());
    return body;
  }

  Body operator()(const Hysteretic& law) const {
    if (!what.radius_eff) return needs_radius();
    if (law.k1() == law.k2()) return absent("NOT WRITTEN: LudingMat needs kp > k1; use the linear law with c = 0.");
    const double deepest = what.impact.velocity * std::sqrt(what.impact.mass_eff / law.k1());
    const double depth = deepest * (1 - law.k1() / law.k2()) / (2 * *what.radius_eff);
    const double half = law.k1() / (law.k1() + 0.5 * (law.k2() - law.k1()));
    return {.fidelity = Fidelity::close,
            .remarks = {setting(),
                        fmt::format("LudingMat lets the unloading stiffness grow from k1 at no overlap to kp at a "
                                    "limit, set here to the greatest overlap of the target's impact: its collision "
                                    "time and restitution are met there alone. At half the velocity the restitution "
                                    "is {} (constant k2: {}).",
                                    rounded(std::sqrt(half)), rounded(what.en))},
            .input = fmt::format(
                R"({}
ip2 = Ip2_LudingMat_LudingMat_LudingPhys()
law2 = Law2_ScGeom_LudingPhys_Basic()
)",
                material("LudingMat", fmt::format("k1={}, kp={}, kc=0, ks=0, G0=0, PhiF={}", shortest(law.k1()),
                                                  shortest(law.k2()), shortest(depth))))};
  }

  Body operator()(const Fractional&) const { return no_memory("Yade"); }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("Yade", Law::name);
  }
};

}  // namespace

Body write_yade(const ExportCase& what) { return std::visit(Yade{what}, what.law); }

}  // namespace ricochet::calibration
