#pragma once

#include <calibrate/export.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

namespace ricochet::calibration {

/// What one engine makes of a law, before it is framed by comments.
struct Body {
  Fidelity fidelity = Fidelity::absent;
  std::vector<std::string> remarks = {};
  std::string input = {};  ///< in the engine's language, whole lines
  /// The end of contact that the engine uses, where it isn't the one asked for.
  std::optional<ContactEnd> other_end = {};
};

Body write_liggghts(const ExportCase& what);
Body write_lammps(const ExportCase& what);
Body write_yade(const ExportCase& what);
Body write_mercurydpm(const ExportCase& what);
Body write_mfix(const ExportCase& what);

using support::shortest;

/// Six digits, for sentences.
inline std::string rounded(double value) { return support::significant(value, 6); }

Body absent(std::string why);
/// For an engine that knows nothing like this law.
Body no_such_law(std::string_view engine, std::string_view law);
/// For the fractional law in an engine that keeps no memory.
Body no_memory(std::string_view engine);
/// For a law that is scaled by the grain's radius, when none was given.
Body needs_radius();
/// Remarks: what the numbers are tied to, and what becomes of other sizes.
std::string tied_to_pair();
std::string keeps_restitution();

/// 3k/(4√R) [Pa]: the effective modulus E* of Hertz' contact with kζ^{3/2}, k = (4/3)E*√R.
double effective_modulus(double hertz_stiffness, double radius_eff);
/// E of two equal bodies with Poisson's ratio ν: E* = E/(2(1−ν²)).
double youngs_modulus(double effective_modulus, double poisson);

/// The restitution that the form −ln e/√(π²+ln²e) turns into `damping_ratio`; nothing where that is ≥ 1.
std::optional<double> logarithmic_restitution(double damping_ratio);

/// Makes the body `close` when the engine ends contacts otherwise than asked, with the remark that says so.
void end_otherwise(Body& body, const ExportCase& what, ContactEnd engine_end, std::string remark);

/// Poisson's ratio that snippets write where an engine wants one: it has no influence on these normal forces.
constexpr double poisson = 0.3;

}  // namespace ricochet::calibration
