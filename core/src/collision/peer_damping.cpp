#include <ricochet/collision/peer_damping.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace ricochet {

namespace {

template <std::size_t n>
double horner(const std::array<double, n>& coefficients, double x) {
  double sum = 0;
  for (std::size_t i = n; i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

/// −ln e/√(π² + ln² e): what nearly every engine uses, exact for both laws when the contact ends by overlap.
double logarithmic(double en) { return damping_of_restitution(en, ContactEnd::overlap); }

/// Exact for the linear law ended by force.
double schwager_poeschel(double en) { return damping_of_restitution(en, ContactEnd::force); }

// Tsuji's law: c = η√(mk) is β = η/√5. A fraction of the tangent critical damping, 2γ√(m·(3/2)kζ^{1/2}), is η = √6 γ.
const double of_eta = 1 / std::sqrt(5.0);
const double of_tangent_fraction = std::sqrt(6.0 / 5.0);

double marshall_with_effective_mass(double en) { return marshall_polynomial(en) * of_eta; }
double marshall_with_particle_mass(double en) { return std::numbers::sqrt2 * marshall_polynomial(en) * of_eta; }
double thornton(double en) { return thornton_polynomial(en) * of_tangent_fraction; }
double two_instead_of_root_five(double en) { return 2 * logarithmic(en) * of_eta; }

constexpr auto overlap = ContactEnd::overlap;
constexpr auto force = ContactEnd::force;

const std::array<PeerDamping, 19> peers{{
    {"lammps hooke", "LAMMPS since 2024, damping coeff_restitution", PeerLaw::linear, overlap, true, logarithmic,
     "lammps/lammps src/GRANULAR/gran_sub_mod_damping.cpp"},
    {"lammps hooke, limited", "LAMMPS since 2024, damping coeff_restitution, limit_damping", PeerLaw::linear, force,
     false, logarithmic, "lammps/lammps src/GRANULAR/gran_sub_mod_damping.cpp"},
    {"lammps hertz", "LAMMPS since 2024, damping coeff_restitution", PeerLaw::tsuji, overlap, true, logarithmic,
     "lammps/lammps src/GRANULAR/gran_sub_mod_damping.cpp"},
    {"lammps hertz, limited", "LAMMPS since 2024, damping coeff_restitution, limit_damping", PeerLaw::tsuji, force,
     false, logarithmic, "lammps/lammps src/GRANULAR/gran_sub_mod_damping.cpp"},
    {"lammps tsuji 2021", "LAMMPS 29 Sep 2021, damping tsuji (effective mass)", PeerLaw::tsuji, overlap, false,
     marshall_with_effective_mass, "lammps/lammps src/GRANULAR/pair_granular.cpp; Marshall 2009, Eq. (53)"},
    {"lammps tsuji 2026", "LAMMPS since 2026 (pull request 5113), damping tsuji", PeerLaw::tsuji, overlap, false,
     marshall_with_particle_mass, "lammps/lammps src/GRANULAR/gran_sub_mod_damping.cpp; Marshall 2009, Eq. (53)"},
    {"liggghts hooke", "LIGGGHTS 3.8.0, hooke", PeerLaw::linear, overlap, true, logarithmic,
     "CFDEMproject/LIGGGHTS-PUBLIC src/normal_model_hooke.h"},
    {"liggghts hooke, limited", "LIGGGHTS 3.8.0, hooke, limitForce on", PeerLaw::linear, force, false, logarithmic,
     "CFDEMproject/LIGGGHTS-PUBLIC src/normal_model_hooke.h"},
    {"liggghts hertz", "LIGGGHTS 3.8.0, hertz", PeerLaw::tsuji, overlap, true, logarithmic,
     "CFDEMproject/LIGGGHTS-PUBLIC src/normal_model_hertz.h, src/global_properties.cpp"},
    {"liggghts hertz, limited", "LIGGGHTS 3.8.0, hertz, limitForce on", PeerLaw::tsuji, force, false, logarithmic,
     "CFDEMproject/LIGGGHTS-PUBLIC src/normal_model_hertz.h, src/global_properties.cpp"},
    {"mercurydpm linear", "MercuryDPM, LinearViscoelastic", PeerLaw::linear, overlap, true, logarithmic,
     "MercuryDPM Kernel/Species/NormalForceSpecies/LinearViscoelasticNormalSpecies.cc"},
    {"mercurydpm hertz", "MercuryDPM, HertzianViscoelastic", PeerLaw::tsuji, overlap, true, logarithmic,
     "MercuryDPM Kernel/Species/NormalForceSpecies/HertzianViscoelasticNormalSpecies.cc; Antypov & Elliott 2011"},
    {"mfix linear", "MFiX 25.2.1, LSD", PeerLaw::linear, overlap, true, logarithmic,
     "MFiX model/check_data/check_solids_dem.f, model/des/calc_force_dem.f"},
    {"mfix hertz", "MFiX 25.2.1, HERTZIAN", PeerLaw::tsuji, overlap, true, logarithmic,
     "MFiX model/check_data/check_solids_dem.f, model/des/calc_force_dem.f"},
    {"mfix hertz 21", "MFiX up to 21.3.2, HERTZIAN (factor 2 for the square root of 5)", PeerLaw::tsuji, overlap, false,
     two_instead_of_root_five, "MFiX 21.3.2 model/check_data/check_solids_dem.f"},
    {"yade tc-en", "Yade, ViscElMat(tc, en)", PeerLaw::linear, force, false, logarithmic,
     "yade/trunk pkg/dem/ViscoelasticPM.cpp; Pournin et al. 2001"},
    {"yade young-en", "Yade, ViscElMat(young, en): its equation, solved exactly", PeerLaw::linear, force, true,
     schwager_poeschel, "yade/trunk pkg/dem/ViscoelasticPM.cpp; Schwager & Poeschel 2007"},
    {"yade mindlin 2019", "Yade of 2019, MindlinPhys(en)", PeerLaw::tsuji, force, false, logarithmic,
     "yade/trunk pkg/dem/HertzMindlin.cpp of 2019; Antypov & Elliott 2011"},
    {"yade mindlin 2023", "Yade 2023.02a, MindlinPhys(en); also Kratos", PeerLaw::tsuji, force, false, thornton,
     "yade/trunk pkg/dem/HertzMindlin.cpp; Thornton, Cummins & Cleary 2013, Eqs. (B6), (B7), Table 2"},
}};

}  // namespace

std::span<const PeerDamping> peer_dampings() { return peers; }

double marshall_polynomial(double en) {
  return horner<7>({1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218}, en);
}

double mueller_poeschel_restitution(double u) {
  const double numerator = 1 + 0.501086 * u;
  return numerator / (numerator + u * u * (1.15345 + u * (0.577977 + u * 0.532178)));
}

double thornton_polynomial(double en) {
  const double exponent = en * horner<10>({-6.918798, -16.41105, 146.8049, -796.4559, 2928.711, -7206.864, 11494.29,
                                           -11342.18, 6276.757, -1489.915},
                                          en);
  // √(1/d − 1), d = 1 − (1+e)² e^x, of which the difference loses all digits as e → 0.
  const double d = -std::expm1(2 * std::log1p(en) + exponent);
  return std::sqrt(1 - d) / std::sqrt(d);
}

}  // namespace ricochet
