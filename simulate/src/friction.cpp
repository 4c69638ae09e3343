#include "friction.hpp"

#include <console/number.hpp>
#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/tangential_restitution.hpp>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace ricochet::simulate {
namespace {

using console::Node;

bool has_springs(const Node& node) {
  return node.has("model") && node.at("model").one_of({"rigid", "linear", "mindlin"}) != "rigid";
}

void allow_keys(const Node& node) {
  if (has_springs(node))
    node.allow({"mu_static", "mu_dynamic", "decay", "rolling_arm", "model", "torsion", "mu_rolling", "k_t", "c_t",
                "beta0", "velocity"});
  else
    node.allow({"mu_static", "mu_dynamic", "decay", "rolling_arm", "model", "torsion", "mu_rolling"});
}

// k_t with c_t, or β₀.
void read_stiffness(const Node& node, TangentialAsked& asked) {
  if (node.has("beta0")) {
    const Node beta0 = node.at("beta0");
    if (asked.mindlin) beta0.reject("left out with the model mindlin");
    for (const char* key : {"k_t", "c_t"})
      if (node.has(key)) node.at(key).reject("left out with beta0");
    if (!beta0.json().is_number() || !(beta0.number() > 0 && beta0.number() <= 1)) beta0.reject("in (0, 1]");
    asked.beta0 = beta0.number();
    return;
  }
  if (node.has("k_t"))
    asked.k_t = node.at("k_t").positive();
  else if (!asked.mindlin)
    node.complain("\"k_t\" or \"beta0\" is missing; one must be given with the model linear");
  if (node.has("c_t")) asked.c_t = node.at("c_t").not_negative();
}

/// The normal collision at which springs are made.
Collision collision_of(const TangentialAsked& asked, const AnyLaw& normal, double mass, ContactEnd end) {
  const bool changes = std::holds_alternative<KuwabaraKono>(normal) || std::holds_alternative<Tsuji>(normal) ||
                       std::holds_alternative<FractionalHertz>(normal);
  if (!asked.velocity && (changes || asked.mindlin))
    asked.place.complain(
        "\"velocity\" is missing; these springs depend on the impact velocity for which they are made");
  const Collision found = collide(normal, {asked.velocity.value_or(1), mass}, {.end = end});
  if (!found.separated())
    asked.place.complain(fmt::format("bodies of effective mass {} kg never part under their law; \"k_t\" must be given",
                                     console::significant(mass, 3)));
  return found;
}

double mindlin_stiffness(const TangentialAsked& asked, double radius) {
  if (asked.k_t) return *asked.k_t;
  if (!asked.solid)
    asked.place.complain("\"k_t\" is missing; it must be given, or the law by \"en\", \"young\" and \"poisson\"");
  const auto compliance = [](const ElasticSolid& s) { return 2 * (2 - s.poisson) * (1 + s.poisson) / s.young; };
  const double shear = 1 / (compliance(asked.solid->first) + compliance(asked.solid->second));
  return MindlinTangential::of(shear, radius).k_t();
}

}  // namespace

Friction read_friction(const Node& node) {
  allow_keys(node);
  const double mu_static = node.at("mu_static").not_negative();
  const double mu_dynamic = node.has("mu_dynamic") ? node.at("mu_dynamic").not_negative() : mu_static;
  if (mu_dynamic > mu_static) node.at("mu_dynamic").reject("at most mu_static");
  return Friction(mu_static, mu_dynamic, node.has("decay") ? node.at("decay").not_negative() : 0,
                  node.has("rolling_arm") ? node.at("rolling_arm").not_negative() : 0);
}

double read_mu_rolling(const Node& node) {
  if (!node.has("mu_rolling")) return 0;
  if (node.has("rolling_arm") && node.at("rolling_arm").not_negative() > 0)
    node.at("mu_rolling").reject("left out with rolling_arm");
  return node.at("mu_rolling").not_negative();
}

std::optional<TangentialAsked> read_tangential(const Node& node) {
  if (!has_springs(node)) {
    if (node.has("torsion") && !node.at("torsion").yes_or_no()) node.at("torsion").reject("true with the model rigid");
    return std::nullopt;
  }
  TangentialAsked asked{.place = node};
  asked.mindlin = node.at("model").text() == "mindlin";
  read_stiffness(node, asked);
  if (node.has("torsion")) asked.torsion = node.at("torsion").yes_or_no();
  if (node.has("velocity")) asked.velocity = node.at("velocity").positive();
  asked.mu_rolling = read_mu_rolling(node);
  asked.rolls = asked.mu_rolling > 0 || (node.has("rolling_arm") && node.at("rolling_arm").number() > 0);
  return asked;
}

void set_tangential(const TangentialAsked& asked, const AnyLaw& normal, const PairOfBodies& pair, Interaction& own) {
  double overlap = 0;  // at which Mindlin's spring is as stiff as the others shall be
  try {
    if (asked.beta0) {
      own.tangential = tangential_for(*asked.beta0, collision_of(asked, normal, pair.mass, own.end).tcol, pair.mass);
    } else if (asked.mindlin) {
      own.tangential = MindlinTangential(mindlin_stiffness(asked, pair.radius), asked.c_t);
      if (asked.torsion || asked.rolls) overlap = collision_of(asked, normal, pair.mass, own.end).max_overlap;
    } else {
      own.tangential = LinearTangential(*asked.k_t, asked.c_t);
    }
  } catch (const std::invalid_argument& misuse) {
    asked.place.complain(misuse.what());
  }
  if (!asked.torsion && !asked.rolls) return;
  const Spring slide = spring(own.tangential, overlap);
  const double turning = pair.inertia / (tangential_mass_ratio * pair.mass);
  const Spring turn{turning * slide.stiffness, turning * slide.damping};
  if (!(std::isfinite(turn.stiffness) && std::isfinite(turn.damping)))
    asked.place.complain(fmt::format("no double carries these springs for bodies of effective mass {} kg",
                                     console::significant(pair.mass, 3)));
  if (asked.torsion) own.torsion = {Torsion::Limit::disc, turn};
  if (asked.rolls) own.rolling = {asked.mu_rolling, turn};
}

}  // namespace ricochet::simulate
