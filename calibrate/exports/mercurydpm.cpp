#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>

namespace ricochet::calibration {

namespace {

struct MercuryDpm {
  const ContactSet& set;

  static std::string attracts() {
    return "This species does not clip the attractive part of its force, so contacts end by overlap; calibrate with "
           "--end overlap to meet the target.";
  }

  /// "species" of the only kind, "species_grain" of one among several.
  std::string name_of(std::size_t kind) const {
    return set.kinds.size() == 1 ? "species" : "species_" + set.kinds[kind].name;
  }

  /// The species made, and their densities where known, then setters(pair) of what acts in every pair. A setter is
  /// everything behind the arrow.
  template <class F>
  std::string species(std::string_view of, const F& setters) const {
    std::string text;
    for (std::size_t i = 0; i < set.kinds.size(); ++i) {
      text += fmt::format("auto {} = speciesHandler.copyAndAddObject({}());\n", name_of(i), of);
      if (set.kinds[i].density)
        text += fmt::format("{}->setDensity({});\n", name_of(i), shortest(*set.kinds[i].density));
    }
    for (const PairCase& pair : set.pairs) {
      std::string acts = name_of(pair.a);
      if (pair.a != pair.b) {
        acts = fmt::format("{}_{}", name_of(pair.a), set.kinds[pair.b].name);
        text +=
            fmt::format("auto {} = speciesHandler.getMixedObject({}, {});\n", acts, name_of(pair.a), name_of(pair.b));
      }
      auto all = setters(pair);
      for (std::string& setter : sliding(pair)) all.push_back(std::move(setter));
      for (const std::string& setter : all) text += fmt::format("{}->{};\n", acts, setter);
    }
    return text;
  }
  /// What makes a pair slide; nothing without friction.
  std::vector<std::string> sliding(const PairCase& pair) const {
    if (!frictional(set)) return {};
    const auto [k_t, c_t, mu] = sliding_of(pair);
    return {fmt::format("setSlidingStiffness({})", shortest(k_t)),
            fmt::format("setSlidingDissipation({})", shortest(c_t)),
            fmt::format("setSlidingFrictionCoefficient({})", shortest(mu))};
  }
  /// The species of a normal force with or without friction.
  std::string named(const std::string& normal) const {
    return normal + (frictional(set) ? "SlidingFriction" : "") + "Species";
  }
  static std::vector<std::string> hertzian(const PairCase& pair, double stiffness, double dissipation) {
    return {fmt::format("setEffectiveElasticModulus({})", shortest(effective_modulus(stiffness, *pair.radius_eff))),
            fmt::format("setDissipation({})", shortest(dissipation))};
  }
  std::string header(std::string_view of) const {
    return fmt::format(
        "Goes into setupInitialConditions() of a Mercury3D driver; needs #include \"Species/{}.h\". {}", of,
        frictional(set) ? "Sliding takes k_t, c_t in kg/s and mu of the pair as they are. Not run here: read in its "
                          "source."
                        : "For friction take the species of the same name with Friction or Mindlin in it.");
  }
  Body mindlin() const {
    return no_such_tangential("MercuryDPM",
                              "its Mindlin species is Mindlin and Deresiewicz's, with slip at the rim of the contact; "
                              "take the linear tangential law");
  }

  Body operator()(const Linear&) const {
    const std::string of = named("LinearViscoelastic");
    Body body{.fidelity = Fidelity::exact,
              .remarks = {header(of),
                          "setDissipation takes c in kg/s of the pair as it is. setCollisionTimeAnd"
                          "RestitutionCoefficient(tc, e, mass) wants twice the effective mass."},
              .input = species(of, [](const PairCase& p) {
                const auto& law = law_of<Linear>(p);
                return std::vector{fmt::format("setStiffness({})", shortest(law.k())),
                                   fmt::format("setDissipation({})", shortest(law.c()))};
              })};
    end_otherwise(body, set, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const KuwabaraKono&) const {
    if (!knows_radii(set)) return needs_radius();
    const std::string of = named("HertzianBSHPViscoelastic");
    return {.fidelity = Fidelity::exact,
            .remarks = {header(of),
                        "Dissipation is Brilliantov's A in seconds, c = (3/2) A k, and the modulus is E*, "
                        "k = (4/3) E* sqrt(R): other radii keep the same material. This species clips the "
                        "attractive part of its force."},
            .input = species(of, [](const PairCase& p) {
              const auto& law = law_of<KuwabaraKono>(p);
              return hertzian(p, law.k(), 2 * law.c() / (3 * law.k()));
            })};
  }

  Body operator()(const Tsuji&) const {
    if (!knows_radii(set)) return needs_radius();
    const std::string of = named("HertzianViscoelastic");
    Body body{.fidelity = Fidelity::exact,
              .remarks = {header(of),
                          "The modulus is E*, k = (4/3) E* sqrt(R). Dissipation has no unit: c = dissipation "
                          "sqrt(m k).",
                          keeps_restitution()},
              .input = species(of, [](const PairCase& p) {
                const auto& law = law_of<Tsuji>(p);
                return hertzian(p, law.k(), law.c() / std::sqrt(p.impact.mass_eff * law.k()));
              })};
    end_otherwise(body, set, ContactEnd::overlap, attracts());
    return body;
  }

  Body operator()(const Hysteretic&) const {
    const std::string of = named("LinearPlasticViscoelastic");
    return {.fidelity = Fidelity::exact,
            .remarks = {header(of),
                        "Without setDoConstantUnloadingStiffness(true) the unloading stiffness grows with "
                        "the overlap. The last plastic parameter, a depth of 1 in units of the effective "
                        "diameter, keeps the limit out of reach."},
            .input = species(of, [](const PairCase& p) {
              const auto& law = law_of<Hysteretic>(p);
              return std::vector<std::string>{
                  fmt::format("setPlasticParameters({}, {}, 0, 1)", shortest(law.k1()), shortest(law.k2())),
                  "setDoConstantUnloadingStiffness(true)", "setDissipation(0)"};
            })};
  }

  template <RemembersAll Law>
  Body operator()(const Law&) const {
    return no_memory("MercuryDPM");
  }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("MercuryDPM", Law::name);
  }
};

}  // namespace

Body write_mercurydpm(const ContactSet& set) {
  const MercuryDpm mercury{set};
  if (is_mindlin(set)) return mercury.mindlin();
  Body body = std::visit(mercury, set.pairs.front().law);
  if (damped_tangentially(set) && body.fidelity == Fidelity::exact) {
    body.fidelity = Fidelity::close;
    body.remarks.push_back(dashpot_feels_slip("MercuryDPM"));
  }
  return body;
}

}  // namespace ricochet::calibration
