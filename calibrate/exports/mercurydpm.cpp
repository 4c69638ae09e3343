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

  /// The species made, and its density where it is known; what sets its law follows.
  std::string species(std::string_view of) const {
    return fmt::format("auto species = speciesHandler.copyAndAddObject({}());\n", of) +
           (what.density ? fmt::format("species->setDensity({});\n", shortest(*what.density)) : "");
  }
  std::string hertzian(double stiffness, double dissipation) const {
    return fmt::format(R"(species->setEffectiveElasticModulus({});
species->setDissipation({});
)",
                       shortest(effective_modulus(stiffness, *what.radius_eff)), shortest(dissipation));
  }
  static std::string header(std::string_view of) {
    return fmt::format(
        "Goes into setupInitialConditions() of a Mercury3D driver; needs #include \"Species/{}.h\". For friction take "
        "the species of the same name with Friction or Mindlin in it.",
        of);
  }

  Body operator()(const Linear& law) const {
    constexpr std::string_view of = "LinearViscoelasticSpecies";
    Body body{.fidelity = Fidelity::exact,
              .remarks = {header(of),
                          "setDissipation takes c in kg/s of the pair as it is. setCollisionTimeAnd"
                          "RestitutionCoefficient(tc, e, mass) wants twice the effective mass."},
              .input = species(of) + fmt::format(R"(species->setStiffness({});
species->setDissipation({});
)",
                                                 shortest(law.k()), shortest(law.c()))};
    end_otherwise(body, what, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const KuwabaraKono& law) const {
    if (!what.radius_eff) return needs_radius();
    constexpr std::string_view of = "HertzianBSHPViscoelasticSpecies";
    return {.fidelity = Fidelity::exact,
            .remarks = {header(of),
                        "Dissipation is Brilliantov's A in seconds, c = (3/2) A k, and the modulus is E*, "
                        "k = (4/3) E* sqrt(R): other radii keep the same material. This species clips the "
                        "attractive part of its force."},
            .input = species(of) + hertzian(law.k(), 2 * law.c() / (3 * law.k()))};
  }

  Body operator()(const Tsuji& law) const {
    if (!what.radius_eff) return needs_radius();
    constexpr std::string_view of = "HertzianViscoelasticSpecies";
    Body body{.fidelity = Fidelity::exact,
              .remarks = {header(of),
                          "The modulus is E*, k = (4/3) E* sqrt(R). Dissipation has no unit: c = dissipation "
                          "sqrt(m k).",
                          keeps_restitution()},
              .input = species(of) + hertzian(law.k(), law.c() / std::sqrt(what.impact.mass_eff * law.k()))};
    end_otherwise(body, what, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const Hysteretic& law) const {
    constexpr std::string_view of = "LinearPlasticViscoelasticSpecies";
    return {.fidelity = Fidelity::exact,
            .remarks = {header(of),
                        "Without setDoConstantUnloadingStiffness(true) the unloading stiffness grows with "
                        "the overlap. The last plastic parameter, a depth of 1 in units of the effective "
                        "diameter, keeps the limit out of reach."},
            .input = species(of) + fmt::format(R"(species->setPlasticParameters({}, {}, 0, 1);
species->setDoConstantUnloadingStiffness(true);
species->setDissipation(0);
)",
                                               shortest(law.k1()), shortest(law.k2()))};
  }

  Body operator()(const Fractional&) const { return no_memory("MercuryDPM"); }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("MercuryDPM", Law::name);
  }
};

}  // namespace

Body write_mercurydpm(const ExportCase& what) { return std::visit(MercuryDpm{what}, what.law); }

}  // namespace ricochet::calibration
