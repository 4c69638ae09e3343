#pragma once

#include <calibrate/export.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <functional>

namespace ricochet::calibration {

/// What one engine makes of the contacts, before it is framed by comments.
struct Body {
  Fidelity fidelity = Fidelity::absent;
  std::vector<std::string> remarks = {};
  std::string input = {};  ///< in the engine's language, whole lines
  /// The end of contact that the engine uses, where it isn't the one asked for.
  std::optional<ContactEnd> other_end = {};
  /// Of an engine that is not told the time step but by how much it shall divide this one [s].
  std::optional<double> divided_time = {};
};

Body write_liggghts(const ContactSet& set);
Body write_lammps(const ContactSet& set);
Body write_yade(const ContactSet& set);
Body write_mercurydpm(const ContactSet& set);
Body write_mfix(const ContactSet& set);

using support::shortest;

/// Six digits, for sentences.
inline std::string rounded(double value) { return support::significant(value, 6); }

Body absent(std::string why);
/// For an engine that knows nothing like this law.
Body no_such_law(std::string_view engine, std::string_view law);
/// For a law that remembers all in an engine that keeps no memory.
Body no_memory(std::string_view engine);
/// For a law that is scaled by the grain's radius, when none was given.
Body needs_radius();
/// For an engine whose materials make the stiffness, where no materials make those of these pairs.
Body needs_materials(std::string_view engine);
/// Remarks: what the numbers are tied to, and what becomes of other sizes.
std::string tied_to_pair();
std::string keeps_restitution();

bool knows_radii(const ContactSet& set);
/// The contact between bodies of these kinds, in either order; null where none was given.
const PairCase* find_pair(const ContactSet& set, std::size_t a, std::size_t b);
/// The same, and where none was given, as for two walls, any in which one of both takes part: engines want whole
/// matrices.
const PairCase& pair_or_stand_in(const ContactSet& set, std::size_t a, std::size_t b);
/// The kinds that are walls, as places.
std::vector<std::size_t> walls_of(const ContactSet& set);
/// "" of the only kind of wall, "_steel" where there are several.
std::string suffix_of(const ContactSet& set, std::size_t kind);

/// A plane that is a kind of wall until the deck says where it is.
struct WallPlane {
  char axis = 'z';     ///< across the plane
  int place = 0;       ///< on that axis [m]
  bool above = false;  ///< the grains are below it
};
/// The first kind at z = 0, the next ones at x = 0 and y = 0, then a metre further: never two in one place, where each
/// would push the same grains.
WallPlane plane_of(const ContactSet& set, std::size_t kind);
/// "Set the variable to where the wall is … without, ricochet_wall is the plane z = 0."; "" without walls.
std::string where_walls_are(const ContactSet& set);

/// Two things in series, x_i + x_j = 1/value(pair): what each kind contributes, 1/(2 value) of a pair of its own, and
/// for a wall what the first grain's contact with it leaves. nullopt where no such numbers >= 0 give every pair's value
/// to 1e-9. A wall that gives way by less than 1e-9 of the grain counts as rigid, 0.
std::optional<std::vector<double>> in_series(const ContactSet& set,
                                             const std::function<double(const PairCase&)>& value);

/// 1/part of each; a rigid one gets 10¹² times the first one's.
std::vector<double> members(const std::vector<double>& parts);

template <class Law>
const Law& law_of(const PairCase& pair) {
  return std::get<Law>(pair.law);
}

/// 3k/(4√R) [Pa]: the effective modulus E* of Hertz' contact with kζ^{3/2}, k = (4/3)E*√R.
double effective_modulus(double hertz_stiffness, double radius_eff);
/// E [Pa] of each kind, from E* of its pairs by 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂; nullopt where none give every pair.
std::optional<std::vector<double>> youngs_moduli(const ContactSet& set);

/// The restitution that the form −ln e/√(π²+ln²e) turns into `damping_ratio`; nothing where that is ≥ 1.
std::optional<double> logarithmic_restitution(double damping_ratio);

/// Whether the contacts have a tangential part.
bool frictional(const ContactSet& set);
/// Its k_t [kg/s²; Mindlin: kg/(s² m^{1/2})], c_t [kg/s] and μ.
struct Sliding {
  double k_t = 0, c_t = 0, mu = 0;
};
Sliding sliding_of(const PairCase& pair);
bool is_mindlin(const ContactSet& set);
/// Whether any contact has a tangential dashpot.
bool damped_tangentially(const ContactSet& set);
/// k_t/√R = 8 G* [Pa] of Mindlin's law.
double mindlin_modulus(const PairCase& pair);

/// For an engine whose dashpot feels the whole slip of a contact that slides.
std::string dashpot_feels_slip(std::string_view engine);
/// For an engine that judges the limit by the spring alone and adds the dashpot's force only while the contact sticks.
std::string judges_spring_alone(std::string_view engine);
/// What each of them does where Mindlin's contact grows or shrinks, beside the law that was asked for.
std::string other_mindlin(std::string_view engine, std::string_view does);
/// For an engine that makes the tangential stiffness of the moduli: the same contacts with Poisson's ratios that give
/// it, those known where they do, else one for all; nullopt where none does.
std::optional<ContactSet> with_shear_moduli(const ContactSet& set);
/// For an engine whose tangential stiffness follows from the moduli, where these give another one.
Body needs_shear_moduli(std::string_view engine);
/// A tangential part that the engine can't be given beside this law.
Body no_such_tangential(std::string_view engine, std::string_view why);

/// "5 1/s": a value of the only pair; of several "5 (glass, glass), 7 (glass, steel) 1/s".
std::string of_each(const ContactSet& set, double (*value)(const PairCase&), std::string_view unit = "");
/// c/m [1/s] of a linear contact.
double damping_per_mass(const PairCase& pair);

/// Makes the body `close` when the engine ends contacts otherwise than asked, with the remark that says so.
void end_otherwise(Body& body, const ContactSet& set, ContactEnd engine_end, std::string remark);

}  // namespace ricochet::calibration
