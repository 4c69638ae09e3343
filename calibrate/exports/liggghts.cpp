#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>

namespace ricochet::calibration {

namespace {

/// A material property of the pair of types 1, 1 under a fix of our own name.
std::string property(std::string_view name, double value, std::string_view kind = "peratomtypepair 1") {
  return fmt::format("fix ricochet_{0} all property/global {0} {1} {2}", name, kind, shortest(value));
}

std::string with_style(const std::vector<std::string>& properties, std::string_view model) {
  return fmt::format(R"({}
pair_style gran model {}
pair_coeff * *
)",
                     fmt::join(properties, "\n"), model);
}

struct Liggghts {
  const ExportCase& what;

  std::string limit() const { return what.end == ContactEnd::force ? "limitForce on" : "limitForce off"; }

  static std::string setting() {
    return "Include after create_box with one atom type (with more, each property wants the full matrix). Needs "
           "atom_style granular, newton off and communicate single vel yes. tangential off has no friction; put your "
           "model in its place.";
  }

  Body operator()(const Linear& law) const {
    return {
        .fidelity = Fidelity::exact,
        .remarks = {setting(),
                    fmt::format("absolute_damping on takes c in kg/s as it is; without it LIGGGHTS wants gamman per "
                                "effective mass, {} 1/s here. limitForce on clips the attractive part of the force.",
                                shortest(law.c() / what.impact.mass_eff))},
        .input = with_style(
            {property("kn", law.k()), property("kt", 0), property("gamman_abs", law.c()), property("gammat_abs", 0)},
            fmt::format("hooke/stiffness tangential off absolute_damping on {} tangential_damping off", limit()))};
  }

  Body operator()(const KuwabaraKono& law) const {
    if (!what.radius_eff) return needs_radius();
    const double root = std::sqrt(*what.radius_eff);
    return {.fidelity = Fidelity::exact,
            .remarks = {setting(),
                        "hertz/stiffness multiplies kn by sqrt(R overlap), gamman by that and the effective "
                        "mass: k/sqrt(R), c/(m sqrt(R)).",
                        tied_to_pair()},
            .input = with_style({property("kn", law.k() / root), property("kt", 0),
                                 property("gamman", law.c() / (what.impact.mass_eff * root)), property("gammat", 0)},
                                fmt::format("hertz/stiffness tangential off {} tangential_damping off", limit()))};
  }

  Body operator()(const Tsuji& law) const {
    if (!what.radius_eff) return needs_radius();
    const auto en = logarithmic_restitution(damping_ratio(law, what.impact.mass_eff));
    if (!en || *en <= 0.05)
      return absent(
          fmt::format("NOT WRITTEN: LIGGGHTS refuses a coefficientRestitution of 0.05 or less, this law needs {}.",
                      en ? shortest(*en) : "an overdamped one"));
    const double young = youngs_modulus(effective_modulus(law.k(), *what.radius_eff), poisson);
    std::vector<std::string> properties;
    if (young < 5e6) properties.push_back("soft_particles yes");
    if (young > 1e9) properties.push_back("hard_particles yes");
    properties.push_back(property("youngsModulus", young, "peratomtype"));
    properties.push_back(property("poissonsRatio", poisson, "peratomtype"));
    properties.push_back(property("coefficientRestitution", *en));
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          "hertz knows moduli, not stiffnesses: k = (4/3) E* sqrt(R), E* = E/(2(1-nu^2)) for "
                          "two equal bodies.",
                          keeps_restitution()},
              .input = with_style(properties, fmt::format("hertz tangential off {} tangential_damping off", limit()))};
    if (what.end == ContactEnd::force)
      body.remarks.push_back(
          fmt::format("LIGGGHTS derives the damping for a force that may attract, so with limitForce on it rebounds "
                      "faster than asked; the coefficientRestitution below is the one whose damping gives {}.",
                      shortest(what.en)));
    return body;
  }

  Body operator()(const Hysteretic& law) const {
    if (!what.radius_eff) return needs_radius();
    if (law.k1() == law.k2()) return absent("NOT WRITTEN: luding needs k2 > k1; use the linear law with c = 0.");
    const double deepest = what.impact.velocity * std::sqrt(what.impact.mass_eff / law.k1());
    const double depth = deepest * (1 - law.k1() / law.k2()) / (2 * *what.radius_eff);
    const double half = law.k1() / (law.k1() + 0.5 * (law.k2() - law.k1()));
    return {.fidelity = Fidelity::close,
            .remarks = {setting(),
                        fmt::format("luding lets the unloading stiffness grow from k1 at no overlap to k2 at a limit, "
                                    "set here to the greatest overlap of the target's impact: its collision time and "
                                    "restitution are met there alone. At half the velocity the restitution is {} "
                                    "(constant k2: {}).",
                                    rounded(std::sqrt(half)), rounded(what.en))},
            .input =
                with_style({property("LoadingStiffness", law.k1()), property("UnloadingStiffness", law.k2() / law.k1()),
                            property("coefficientAdhesionStiffness", 0), property("coefficientPlasticityDepth", depth),
                            property("pullOffForce", 0), property("coefficientRestitution", 1)},
                           "luding tangential off")};
  }

  Body operator()(const Fractional& law) const {
    if (what.end != ContactEnd::force)
      return absent("NOT WRITTEN: normal fractional ends contacts by force; export with --end force.");
    return {.fidelity = Fidelity::exact,
            .remarks = {setting(),
                        "Run with liggghts-ricochet, which adds this model to LIGGGHTS. Only c^alpha "
                        "k^(1-alpha) acts, for every pair alike.",
                        fmt::format("For the same collision time and restitution at every pair's own mass, give in "
                                    "place of the three properties: {} and {}",
                                    property("collisionTime", what.tcol), property("coefficientRestitution", what.en))},
            .input = with_style({property("fractionalK", law.k()), property("fractionalC", law.c()),
                                 property("fractionalAlpha", law.alpha())},
                                "fractional tangential off")};
  }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("LIGGGHTS", Law::name);
  }
};

}  // namespace

Body write_liggghts(const ExportCase& what) { return std::visit(Liggghts{what}, what.law); }

}  // namespace ricochet::calibration
