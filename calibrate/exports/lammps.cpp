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

  /// `normal` with its two numbers, stiffness and damping, and the kind of damping that the second one sets.
  std::string pair(std::string_view normal, double stiffness, double strength, std::string_view damping) const {
    return fmt::format(R"(pair_style granular
pair_coeff * * {} {} {} damping {} tangential linear_nohistory 0.0 0.0{}
)",
                       normal, shortest(stiffness), shortest(strength), damping,
                       what.end == ContactEnd::force ? " limit_damping" : "");
  }

  static std::string setting() {
    return "Needs atom_style sphere, newton off and comm_modify vel yes. The tangential part is frictionless; put "
           "yours in its place. limit_damping clips the attractive part of the force (contact ended by force).";
  }

  Body operator()(const Linear& law) const {
    return {.fidelity = Fidelity::exact,
            .remarks = {setting(),
                        fmt::format("damping velocity takes c in kg/s as it is, for every pair. The styles gran/hooke "
                                    "and gran/hooke/history take it per effective mass instead: gamma_n = {} 1/s here.",
                                    shortest(law.c() / what.impact.mass_eff))},
            .input = pair("hooke", law.k(), law.c(), "velocity")};
  }

  Body operator()(const KuwabaraKono& law) const {
    if (!what.radius_eff) return needs_radius();
    const double root = std::sqrt(*what.radius_eff);
    return {.fidelity = Fidelity::exact,
            .remarks = {setting(),
                        "hertz multiplies its stiffness by the contact radius sqrt(R overlap), damping "
                        "viscoelastic by that and the effective mass: k/sqrt(R), c/(m sqrt(R)).",
                        tied_to_pair()},
            .input = pair("hertz", law.k() / root, law.c() / (what.impact.mass_eff * root), "viscoelastic")};
  }

  Body operator()(const Tsuji& law) const {
    if (!what.radius_eff) return needs_radius();
    const double stiffness = law.k() / std::sqrt(*what.radius_eff);
    if (law.c() == 0)
      return {.fidelity = Fidelity::exact, .remarks = {setting()}, .input = pair("hertz", stiffness, 0, "velocity")};
    const double eta = law.c() / std::sqrt(what.impact.mass_eff * law.k());
    const auto argument = polynomial_argument(eta);
    if (!argument)
      return absent(fmt::format(
          "NOT WRITTEN: the polynomial of damping tsuji never falls below 0.0003, this law needs {}.", rounded(eta)));
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          fmt::format("damping tsuji turns its number into c/sqrt(m k) by a polynomial that was fitted "
                                      "for the particle's mass and is applied to the pair's: asked for {} it would not "
                                      "give it. The number below is the argument at which the polynomial has this "
                                      "law's value, not a restitution.",
                                      rounded(what.en)),
                          keeps_restitution()},
              .input = pair("hertz", stiffness, *argument, "tsuji")};
    if (const auto en = logarithmic_restitution(damping_ratio(law, what.impact.mass_eff)))
      body.remarks.push_back(
          fmt::format("LAMMPS since 2024 has damping coeff_restitution; write that with {} in place "
                      "of tsuji with its number.",
                      shortest(*en)));
    return body;
  }

  Body operator()(const Hysteretic&) const {
    return absent("NOT WRITTEN: pair_style granular of this version has no plastic loading and unloading.");
  }

  Body operator()(const Fractional&) const { return no_memory("LAMMPS"); }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("LAMMPS", Law::name);
  }
};

}  // namespace

Body write_lammps(const ExportCase& what) { return std::visit(Lammps{what}, what.law); }

}  // namespace ricochet::calibration
