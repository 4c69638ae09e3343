#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>

namespace ricochet::calibration {

namespace {

struct MercuryDpm {
  const ExportCase& what;

  static std::string attracts() {
    return "This species does not clip the attractive part of its force, so contacts end by overlap; calibrate with "
           "--end overlap to meet the target.";
  }

  std::vector<std::string> species(const std::string& of, const std::vector<std::string>& settings) const {
    std::vector<std::string> lines{"auto species = speciesHandler.copyAndAddObject(" + of + "());"};
    if (what.density) lines.push_back("species->setDensity(" + shortest(*what.density) + ");");
    for (const std::string& s : settings) lines.push_back("species->" + s + ";");
    return lines;
  }
  static std::string header(const std::string& of) {
    return "Goes into setupInitialConditions() of a Mercury3D driver; needs #include \"Species/" + of +
           ".h\". For friction take the species of the same name with Friction or Mindlin in it.";
  }

  Body operator()(const Linear& law) const {
    const std::string of = "LinearViscoelasticSpecies";
    Body body{
        .fidelity = Fidelity::exact,
        .remarks = {header(of),
                    "setDissipation takes c in kg/s of the pair as it is. setCollisionTimeAnd"
                    "RestitutionCoefficient(tc, e, mass) wants twice the effective mass."},
        .lines = species(of, {"setStiffness(" + shortest(law.k()) + ")", "setDissipation(" + shortest(law.c()) + ")"})};
    end_otherwise(body, what, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const KuwabaraKono& law) const {
    if (!what.radius_eff) return needs_radius();
    const std::string of = "HertzianBSHPViscoelasticSpecies";
    return {.fidelity = Fidelity::exact,
            .remarks = {header(of),
                        "Dissipation is Brilliantov's A in seconds, c = (3/2) A k, and the modulus is E*, "
                        "k = (4/3) E* sqrt(R): other radii keep the same material. This species clips the "
                        "attractive part of its force."},
            .lines = species(
                of, {"setEffectiveElasticModulus(" + shortest(effective_modulus(law.k(), *what.radius_eff)) + ")",
                     "setDissipation(" + shortest(2 * law.c() / (3 * law.k())) + ")"})};
  }

  Body operator()(const Tsuji& law) const {
    if (!what.radius_eff) return needs_radius();
    const std::string of = "HertzianViscoelasticSpecies";
    Body body{.fidelity = Fidelity::exact,
              .remarks = {header(of),
                          "The modulus is E*, k = (4/3) E* sqrt(R). Dissipation has no unit: c = dissipation "
                          "sqrt(m k).",
                          keeps_restitution()},
              .lines = species(
                  of, {"setEffectiveElasticModulus(" + shortest(effective_modulus(law.k(), *what.radius_eff)) + ")",
                       "setDissipation(" + shortest(law.c() / std::sqrt(what.impact.mass_eff * law.k())) + ")"})};
    end_otherwise(body, what, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const Hysteretic& law) const {
    const std::string of = "LinearPlasticViscoelasticSpecies";
    return {.fidelity = Fidelity::exact,
            .remarks = {header(of),
                        "Without setDoConstantUnloadingStiffness(true) the unloading stiffness grows with "
                        "the overlap. The last plastic parameter, a depth of 1 in units of the effective "
                        "diameter, keeps the limit out of reach."},
            .lines = species(of, {"setPlasticParameters(" + shortest(law.k1()) + ", " + shortest(law.k2()) + ", 0, 1)",
                                  "setDoConstantUnloadingStiffness(true)", "setDissipation(0)"})};
  }

  Body operator()(const Fractional&) const {
    return absent("NOT WRITTEN: MercuryDPM has no law with memory; LIGGGHTS runs it through liggghts-ricochet.");
  }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return absent("NOT WRITTEN: MercuryDPM has no " + std::string(Law::name) + " law.");
  }
};

}  // namespace

Body write_mercurydpm(const ExportCase& what) { return std::visit(MercuryDpm{what}, what.law); }

}  // namespace ricochet::calibration
