#pragma once

#include <calibrate/advice.hpp>
#include <calibrate/export.hpp>
#include <calibrate/known.hpp>
#include <calibrate/tangential.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ricochet::calibration {

/// Grains of one material and a range of radii, or a wall.
struct Material {
  std::string name;
  bool wall = false;
  double density = 0;              ///< of a grain [kg/m³]
  double least = 0, greatest = 0;  ///< radius of a grain [m]; a wall has none
  std::optional<ElasticSolid> solid = {};
  std::optional<double> stiffness = {};  ///< of the contact between two of its grains [kg/s²]; laws in ζ alone

  bool one_size() const { return least == greatest; }
  double mass(double radius) const;
};

/// What two materials shall do to each other.
struct Pair {
  std::size_t a = 0, b = 0;  ///< places in Materials::all; a wall is never a
  double en = 0;
  std::optional<double> tcol = {}, stiffness = {};  ///< instead of what the materials make [s], [the law's k]
  std::optional<double> beta0 = {}, mu = {};        ///< in the tangent plane
};

/// Materials and what is asked of their contacts, all under one law at one impact velocity.
struct Materials {
  LawKind law;
  ContactEnd end = ContactEnd::force;
  double velocity = 0;  ///< [m/s]
  double soften = 1;    ///< divides E*
  LinearMatch match = LinearMatch::time;
  TangentialForm tangential = TangentialForm::linear;  ///< of pairs that have β₀ or μ
  Held held = {};                                      ///< of the laws of real solids
  std::vector<Material> all = {};                      ///< grains before walls
  std::vector<Pair> pairs = {};                        ///< of every two that can meet
};

/// One contact of two bodies of given sizes, and what their law makes of it.
struct SizedContact {
  double radius_a = 0, radius_b = 0;  ///< [m]; of a wall 0
  double radius_eff = 0;              ///< [m]
  Impact impact;
  AnyLaw law;
  Collision collision;
};

/// A pair, calibrated at the middle of both ranges of radii.
struct PairResult {
  Pair asked;
  Calibration found;
  Target target;
  double radius_eff = 0;                                 ///< at which it was calibrated [m]
  std::optional<TangentialCalibration> tangential = {};  ///< where the pair asks for one
};

struct PairMissed {
  Pair asked;
  Infeasible why;
};

using PairOutcome = std::variant<PairResult, PairMissed>;

/// What stays when grains of other sizes meet than those that a pair was calibrated for.
enum class Kept {
  numbers,  ///< k and c of the linear law, k₁ and k₂, or k, c and α; of the Hertzian laws the modulus, and with it
            ///< the damping ratio (Tsuji), Brilliantov's A = 2c/(3k) (Kuwabara–Kono) or c/k (fractional-hertz)
  restitution,  ///< of the linear law k and the damping ratio instead
  target        ///< of the linear and the fractional law t_col and e_n instead
};

/// Every pair's law. The scale is the pair's t_col or stiffness, else E and ν of both materials, else their stiffnesses
/// in series, 2/(1/k₁ + 1/k₂).
/// Throws as `request_of` and `calibrate`, and std::invalid_argument for a pair without a scale.
std::vector<PairOutcome> calibrate_pairs(const Materials& materials);

/// The pair's contact at the ends of both ranges of radii: smallest, unlike and greatest; none where there is no range.
std::vector<SizedContact> over_sizes(const Materials& materials, const PairResult& pair, Kept kept);

/// What an engine is told of them; all pairs have to be found.
ContactSet contact_set(const Materials& materials, const std::vector<PairResult>& pairs, Kept kept);

/// A way in which an engine keeps e_n for every size of grain.
struct SizeChoice {
  std::string engine, how;
  Kept kept;
  bool written = false;      ///< by `export_contacts` for a set with ranges of radii
  std::string refusal = {};  ///< why it is not written for these pairs, where it else would be
};
std::vector<SizeChoice> size_choices(LawKind law);
/// The same for these pairs, which are all: not every engine can be given every number.
std::vector<SizeChoice> size_choices(const Materials& materials, const std::vector<PairResult>& pairs);
/// What the engine's file keeps.
Kept kept_by(std::string_view engine, LawKind law);

/// The steps that keep e_n of every pair and size: the least over them, for each engine that runs all.
std::vector<EngineStep> engine_steps(const Materials& materials, const std::vector<PairResult>& pairs);

}  // namespace ricochet::calibration
