#pragma once

#include <console/node.hpp>
#include <ricochet/collision/scale_and_loss.hpp>
#include <ricochet/motion/bodies.hpp>

#include <map>
#include <optional>
#include <utility>

namespace ricochet::simulate {

/// Springs in the tangent plane that an interaction asks for; what depends on the bodies is each pair's own.
struct TangentialAsked {
  bool mindlin = false;  ///< else linear
  std::optional<double> k_t = {}, beta0 = {};
  double c_t = 0;
  bool torsion = false;
  double mu_rolling = 0;
  bool rolls = false;                       ///< rolling has a limit
  std::optional<double> velocity = {};      ///< of the impact [m/s], where it matters
  std::optional<scale::Moduli> solid = {};  ///< of a normal law by moduli, without the radius
  AnyLaw normal = Linear(1, 0);             ///< unless that is by target
  console::Node place;

  /// Do bodies of other sizes have other springs?
  bool by_pair() const { return beta0 || torsion || rolls || !k_t; }
};

/// By their pair of materials.
using TangentialsAsked = std::map<std::pair<std::size_t, std::size_t>, TangentialAsked>;

/// The Coulomb part {"mu_static" [, "mu_dynamic", "decay", "rolling_arm"]}, whatever the model. Throws
/// console::BadInput, also for keys that the model does not have.
Friction read_friction(const console::Node& node);

/// μ_r of any model, 0 where it is not given. Throws console::BadInput, also beside a rolling_arm.
double read_mu_rolling(const console::Node& node);

/// Reads {"model": "linear" | "mindlin", "k_t" [, "c_t"] | "beta0" [, "velocity", "torsion", "mu_rolling"]}; nothing of
/// the model "rigid", which is the default. Throws console::BadInput.
std::optional<TangentialAsked> read_tangential(const console::Node& node);

/// The masses and radii that a pair's springs depend on.
struct PairOfBodies {
  double mass = 0, radius = 0, inertia = 0;  ///< effective: m₁m₂/(m₁+m₂) and so on; a wall's are infinite
};

/// Gives the interaction of such a pair, whose normal law is `normal`, the springs asked for: k_t and c_t of β₀ within
/// the law's own t_col (StickingForm::damped), Mindlin's k_t = 8 G* √R* of moduli, and springs against torsion and
/// rolling that swing and decay as that against sliding does, (7/2) (J/m) k_t. Throws console::BadInput where there are
/// none.
void set_tangential(const TangentialAsked& asked, const AnyLaw& normal, const PairOfBodies& pair, Interaction& own);

}  // namespace ricochet::simulate
