#include "law_by_target.hpp"

#include <console/number.hpp>
#include <ricochet/collision/reach.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

namespace ricochet::simulate {
namespace {

using console::Node;

constexpr std::size_t most_sorts = 200;

ElasticSolid read_solid(const Node& law, const std::string& young, const std::string& poisson) {
  const Node ratio = law.at(poisson);
  if (!(ratio.number() > -1 && ratio.number() <= 0.5)) ratio.reject("in (-1, 0.5]");
  return {law.at(young).positive(), ratio.number()};
}

Scale read_scale(const Node& law) {
  if (law.has("tcol")) {
    for (const char* key : {"young", "poisson", "young2", "poisson2"})
      if (law.has(key)) law.at(key).reject("left out with tcol");
    return scale::CollisionTime{law.at("tcol").positive()};
  }
  if (!law.has("young")) law.complain("\"tcol\" or \"young\" is missing; one must be given with \"en\"");
  const ElasticSolid first = read_solid(law, "young", "poisson");
  const bool two = law.has("young2") || law.has("poisson2");
  return scale::Moduli{.first = first, .second = two ? read_solid(law, "young2", "poisson2") : first, .radius_eff = 1};
}

/// Does the law change with the velocity for which it is made?
bool needs_velocity(LawKind kind, const Scale& scale) {
  const bool timed = std::holds_alternative<scale::CollisionTime>(scale);
  if (kind == kind_of<KuwabaraKono> || kind == kind_of<FractionalHertz>) return true;
  return kind == kind_of<Tsuji> ? timed : !timed;
}

/// Bodies whose contacts have the same law.
struct Sort {
  std::size_t material = 0;
  double radius = 0, density = 0;  ///< of a wall 0
  // NOLINTNEXTLINE(modernize-use-nullptr): seen in the code that clang 14 makes of it
  auto operator<=>(const Sort&) const = default;
  double mass() const { return Sphere{.radius = radius, .density = density}.mass(); }
  bool wall() const { return radius == 0; }
};

class Sorts {
 public:
  Sorts(const ByPair& by_pair, ClusterSetup& setup) {
    for (const auto& [pair, law] : by_pair.laws) sorted_.insert({pair.first, pair.second});
    for (const auto& [pair, asked] : by_pair.tangentials) sorted_.insert({pair.first, pair.second});
    for (Sphere& s : setup.spheres)
      s.material = place({s.material, by_size(s.material) ? s.radius : 1, by_size(s.material) ? s.density : 1});
    for (Wall& w : setup.walls) w.material = place({w.material, 0, 0});
  }
  const std::vector<Sort>& all() const { return all_; }

 private:
  bool by_size(std::size_t material) const { return sorted_.contains(material); }
  std::size_t place(const Sort& sort) {
    const auto [known, fresh] = places_.emplace(sort, all_.size());
    if (fresh) all_.push_back(sort);
    return known->second;
  }

  std::set<std::size_t> sorted_;
  std::map<Sort, std::size_t> places_;
  std::vector<Sort> all_;
};

PairOfBodies pair_of(const Sort& a, const Sort& b) {
  const Sort &grain = a.wall() ? b : a, &other = a.wall() ? a : b;
  const auto effective = [&](double one, double two) { return other.wall() ? one : one / (1 + one / two); };
  const auto inertia = [](const Sort& s) { return Sphere{.radius = s.radius, .density = s.density}.inertia(); };
  return {effective(grain.mass(), other.mass()), effective(grain.radius, other.radius),
          effective(inertia(grain), inertia(other))};
}

AnyLaw law_of(const LawByTarget& by, ContactEnd end, const PairOfBodies& pair) {
  const Impact impact{by.velocity, pair.mass};
  Scale scale = by.scale;
  if (auto* moduli = std::get_if<scale::Moduli>(&scale)) moduli->radius_eff = pair.radius;
  try {
    const auto tcol = collision_time(by.kind, end, scale, by.en, impact, by.held);
    const auto unit = tcol ? unit_law(by.kind, by.en, end, by.held) : std::nullopt;
    if (const auto law = unit ? at_impact(unit->law, *tcol, impact) : std::nullopt) return *law;
  } catch (const std::invalid_argument& misuse) {
    by.place.complain(misuse.what());
  }
  by.place.complain(
      fmt::format("no double carries this law for bodies of effective mass {} kg; en and the scale must "
                  "be less extreme",
                  console::significant(pair.mass, 3)));
}

const Node& place_of(const ByPair& by_pair) {
  return by_pair.laws.empty() ? by_pair.tangentials.begin()->second.place : by_pair.laws.begin()->second.place;
}

/// The rounding of the parameters leaves no fractional law of e_n < 0.00317 that ends by overlap; and what is held of a
/// law of real solids none below some e_n.
void require_reach(const Node& law, LawKind kind, double en, ContactEnd end, const Held& held) {
  if (reaches(kind, end, en, 1, {1, 1}, reach_tolerance, held)) return;
  const double least = least_restitution(kind, end, en, 1, {1, 1}, reach_tolerance, held);
  const bool rounded = en >= restitution_bound(kind, end, held);
  law.at("en").reject(
      fmt::format("in [{}, 1] with the law {} ended by {}: below, {}", console::significant(least, 3), kind.name(),
                  end == ContactEnd::force ? "force" : "overlap",
                  rounded ? "the rounding of its parameters to doubles leaves another en"
                          : fmt::format("no loss leaves less at its alpha = {}", console::shortest(held.alpha))));
}

/// What is held of a law that holds something.
Held read_held(const Node& law, LawKind kind) {
  Held held;
  const auto given = [&](const char* key, bool holds) {
    if (law.has(key) && !holds) law.at(key).reject(fmt::format("left out with the law {} by target", kind.name()));
    return law.has(key);
  };
  if (given("alpha", holds_degree(kind))) {
    held.alpha = law.at("alpha").number();
    if (!domains::degree.contains(held.alpha)) law.at("alpha").reject(domains::degree.accepted);
  }
  if (given("stiffening", kind == kind_of<FractionalZener>)) held.stiffening = law.at("stiffening").positive();
  return held;
}

}  // namespace

bool is_by_target(const Node& law) { return law.has("en"); }

LawByTarget read_law_by_target(const Node& law) {
  law.allow({"name", "en", "tcol", "young", "poisson", "young2", "poisson2", "velocity", "end", "alpha", "stiffening"});
  const LawKind kind = *LawKind::named(law.at("name").one_of(Laws::names));
  const double en = law.at("en").positive();
  if (en > 1) law.at("en").reject("in (0, 1]");
  const Scale scale = read_scale(law);
  if (law.has("end") && law.at("end").text() == "overlap" && !kind.ends().offer(ContactEnd::overlap))
    law.at("end").reject(fmt::format("force with the law {}", kind.name()));
  const Held held = read_held(law, kind);
  require_reach(law, kind, en,
                law.has("end") && law.at("end").text() == "overlap" ? ContactEnd::overlap : ContactEnd::force, held);
  if (!law.has("velocity") && needs_velocity(kind, scale))
    law.complain("\"velocity\" is missing; this law depends on the impact velocity for which it is made");
  return {kind, en, scale, law.has("velocity") ? law.at("velocity").positive() : 1, held, law};
}

void resolve(const ByPair& by_pair, ClusterSetup& setup) {
  if (by_pair.laws.empty() && by_pair.tangentials.empty()) return;
  const Interactions asked = setup.interactions;
  const Sorts sorts(by_pair, setup);
  const auto& all = sorts.all();
  if (all.size() > most_sorts)
    place_of(by_pair).complain(
        fmt::format("{} sizes of bodies; must be at most {} where a law is found for each pair (\"en\", \"beta0\"); "
                    "parameters such as k and c, k_t and c_t hold for any",
                    all.size(), most_sorts));
  setup.interactions.clear();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j) {
      const auto pair = std::minmax(all[i].material, all[j].material);
      const auto interaction = asked.find(pair);
      if (interaction == asked.end() || (all[i].wall() && all[j].wall())) continue;
      Interaction own = interaction->second;
      const PairOfBodies bodies = pair_of(all[i], all[j]);
      std::optional<AnyLaw> normal;
      if (const auto by = by_pair.laws.find(pair); by != by_pair.laws.end())
        normal = law_of(by->second, own.end, bodies), own.law = *normal;
      if (const auto springs = by_pair.tangentials.find(pair); springs != by_pair.tangentials.end())
        set_tangential(springs->second, normal.value_or(springs->second.normal), bodies, own);
      setup.interactions.emplace(std::pair(i, j), own);
    }
}

}  // namespace ricochet::simulate
