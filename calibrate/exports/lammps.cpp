#include "body.hpp"

#include <ricochet/collision/peer_damping.hpp>
#include <ricochet/support/root.hpp>

#include <cmath>

namespace ricochet::calibration {

namespace {

/// The argument at which LAMMPS's polynomial is `eta` = c/√(mk). It falls monotonically, and LAMMPS takes arguments
/// below 0 as well, so every eta above its least value (at 1) has one.
std::optional<double> polynomial_argument(double eta) {
  double low = -1;
  const double high = 1;
  if (eta < marshall_polynomial(high)) return std::nullopt;
  while (marshall_polynomial(low) < eta) low *= 2;
  return support::root([=](double x) { return marshall_polynomial(x) - eta; }, low, high);
}

struct Lammps {
  const ExportCase& what;

  std::vector<std::string> pair(const std::string& normal, const std::string& damping) const {
    std::string line = "pair_coeff * * " + normal + " damping " + damping + " tangential linear_nohistory 0.0 0.0";
    if (what.end == ContactEnd::force) line += " limit_damping";
    return {"pair_style granular", line};
  }

  static std::string setting() {
    return "Needs atom_style sphere, newton off and comm_modify vel yes. The tangential part is frictionless; put "
           "yours in its place. limit_damping clips the attractive part of the force (contact ended by force).";
  }

  Body operator()(const Linear& law) const {
    return {.fidelity = Fidelity::exact,
            .remarks = {setting(),
                        "damping velocity takes c in kg/s as it is, for every pair. The styles gran/hooke "
                        "and gran/hooke/history take it per effective mass instead: gamma_n = " +
                            shortest(law.c() / what.impact.mass_eff) + " 1/s here."},
            .lines = pair("hooke " + shortest(law.k()) + " " + shortest(law.c()), "velocity")};
  }

  Body operator()(const KuwabaraKono& law) const {
    if (!what.radius_eff) return needs_radius();
    const double root = std::sqrt(*what.radius_eff);
    return {.fidelity = Fidelity::exact,
            .remarks = {setting(),
                        "hertz multiplies its stiffness by the contact radius sqrt(R overlap), damping "
                        "viscoelastic by that and the effective mass: k/sqrt(R), c/(m sqrt(R)).",
                        tied_to_pair()},
            .lines = pair("hertz " + shortest(law.k() / root) + " " + shortest(law.c() / (what.impact.mass_eff * root)),
                          "viscoelastic")};
  }

  Body operator()(const Tsuji& law) const {
    if (!what.radius_eff) return needs_radius();
    const std::string normal = "hertz " + shortest(law.k() / std::sqrt(*what.radius_eff)) + " ";
    if (law.c() == 0)
      return {.fidelity = Fidelity::exact, .remarks = {setting()}, .lines = pair(normal + "0", "velocity")};
    const double eta = law.c() / std::sqrt(what.impact.mass_eff * law.k());
    const auto argument = polynomial_argument(eta);
    if (!argument)
      return absent("NOT WRITTEN: the polynomial of damping tsuji never falls below 0.0003, this law needs " +
                    rounded(eta) + ".");
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          "damping tsuji turns its number into c/sqrt(m k) by a polynomial that was fitted for the "
                          "particle's mass and is applied to the pair's: asked for " +
                              rounded(what.en) +
                              " it would not give it. The number below is the argument at which the polynomial has "
                              "this law's value, not a restitution.",
                          keeps_restitution()},
              .lines = pair(normal + shortest(*argument), "tsuji")};
    if (const auto en = logarithmic_restitution(damping_ratio(law, what.impact.mass_eff)))
      body.remarks.push_back("LAMMPS since 2024 has damping coeff_restitution; write that with " + shortest(*en) +
                             " in place of tsuji with its number.");
    return body;
  }

  Body operator()(const Hysteretic&) const {
    return absent("NOT WRITTEN: pair_style granular of this version has no plastic loading and unloading.");
  }

  Body operator()(const Fractional&) const {
    return absent("NOT WRITTEN: LAMMPS has no law with memory; LIGGGHTS runs it through liggghts-ricochet.");
  }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return absent("NOT WRITTEN: LAMMPS has no " + std::string(Law::name) + " law.");
  }
};

}  // namespace

Body write_lammps(const ExportCase& what) { return std::visit(Lammps{what}, what.law); }

}  // namespace ricochet::calibration
