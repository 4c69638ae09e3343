#pragma once

#include "friction.hpp"

#include <console/node.hpp>
#include <ricochet/collision/scale_and_loss.hpp>
#include <ricochet/motion/bodies.hpp>

#include <map>
#include <utility>

namespace ricochet::simulate {

/// A law that an interaction gives by what its collisions shall do, for every pair of bodies at their own effective
/// mass and radius: e_n, and t_col or the moduli of both.
struct LawByTarget {
  LawKind kind;
  double en = 0;
  Scale scale;          ///< of moduli without the radius, which is each pair's own
  double velocity = 0;  ///< of the impact [m/s], where it matters
  Held held;            ///< of the laws of real solids
  console::Node place;
};

/// Laws by target of the setup's interactions, by their pair of materials.
using LawsByTarget = std::map<std::pair<std::size_t, std::size_t>, LawByTarget>;

/// All that bodies of other sizes have otherwise.
struct ByPair {
  LawsByTarget laws;
  TangentialsAsked tangentials;
};

/// Whether the object says what the collisions shall do instead of the law's parameters.
bool is_by_target(const console::Node& law);

/// Reads {"name", "en", "tcol" | "young", "poisson" [, "young2", "poisson2"], "velocity", "alpha", "stiffening"}, the
/// last two of laws that hold them. Throws console::BadInput, also where the velocity is missing and the law depends on
/// it.
LawByTarget read_law_by_target(const console::Node& law);

/// Gives every pair of bodies its own law and springs: bodies of materials with such are sorted by radius and density,
/// each sort becomes a material of its own, and every interaction is repeated for the sorts. Without any the setup
/// stays as it is. Throws console::BadInput for more than 200 sorts, and where no double carries a pair's law.
void resolve(const ByPair& by_pair, ClusterSetup& setup);

}  // namespace ricochet::simulate
