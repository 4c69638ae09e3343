#include "materials.hpp"

#include <console/node.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace ricochet::calibration {
namespace {

using console::Node;

double within(const Node& node, double least, double greatest, const char* accepted) {
  const double value = node.number();
  if (!(value >= least && value <= greatest)) node.reject(accepted);
  return value;
}

double scale(const Node& node) { return within(node, least_scale, greatest_scale, "a number in [1e-30, 1e30]"); }

/// Names go into engines' own names.
bool is_name(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || c == '_' || (c >= '0' && c <= '9'); });
}

void read_radius(const Node& node, Material& m) {
  if (node.json().is_number()) {
    m.least = m.greatest = scale(node);
    return;
  }
  if (!node.json().is_array() || node.size() != 2) node.reject("a radius [m], or two, [least, greatest]");
  m.least = scale(node.at(std::size_t{0}));
  m.greatest = scale(node.at(std::size_t{1}));
  if (m.greatest < m.least) node.reject("the least radius before the greatest");
}

Material read_material(const Node& node, const std::string& name, const Materials& of) {
  Material m{.name = name};
  if (!is_name(name)) node.complain("a material's name must be letters, digits and _, a letter first");
  m.wall = node.json().is_object() && node.has("wall") && node.at("wall").yes_or_no();
  if (m.wall)
    node.allow({"wall", "young", "poisson", "stiffness"});
  else
    node.allow({"wall", "density", "radius", "young", "poisson", "stiffness"});
  if (!m.wall) {
    m.density = scale(node.at("density"));
    read_radius(node.at("radius"), m);
  }
  if (node.has("young") || node.has("poisson"))
    m.solid = ElasticSolid{scale(node.at("young")), within(node.at("poisson"), -0.99, 0.5, "in [-0.99, 0.5]")};
  if (!node.has("stiffness")) return m;
  if (m.solid) node.at("stiffness").reject("left out with young and poisson");
  if (of.law.parameters().front().dimension.metre != 0)
    node.at("stiffness")
        .reject(fmt::format("left out with the law {}, whose k goes with the radius; give young and "
                            "poisson",
                            of.law.name()));
  m.stiffness = scale(node.at("stiffness"));
  return m;
}

/// Grains before walls, each in the order of the file.
void read_all(const Node& node, Materials& materials) {
  if (!node.json().is_object() || node.json().empty())
    node.reject("an object of at least one material, {\"name\": {...}}");
  node.require_names();
  for (const bool walls : {false, true})
    for (const auto& [name, value] : node.json().items()) {
      const Material m = read_material(node.at(name), name, materials);
      if (m.wall == walls) materials.all.push_back(m);
    }
  if (materials.all.front().wall) node.reject("at least one grain, a material that is no wall");
}

std::size_t place_of(const Node& node, const Materials& materials) {
  const std::string name = node.text();
  std::vector<std::string> known;
  for (std::size_t i = 0; i < materials.all.size(); ++i) {
    if (materials.all[i].name == name) return i;
    known.push_back(materials.all[i].name);
  }
  node.reject(fmt::format("one of the materials {}", fmt::join(known, ", ")));
}

bool has_scale(const Pair& pair, const Materials& materials) {
  const Material &a = materials.all[pair.a], &b = materials.all[pair.b];
  return pair.tcol || pair.stiffness || (a.solid && b.solid) || (a.stiffness && b.stiffness);
}

Pair read_pair(const Node& node, const Materials& materials, const std::optional<double>& tcol) {
  node.allow({"between", "en", "tcol", "stiffness", "beta0", "mu"});
  const Node between = node.at("between");
  if (!between.json().is_array() || between.size() != 2) between.reject("two materials [\"a\", \"b\"]");
  const auto [a, b] =
      std::minmax({place_of(between.at(std::size_t{0}), materials), place_of(between.at(std::size_t{1}), materials)});
  if (materials.all[a].wall) between.reject("at least one grain");
  Pair pair{.a = a, .b = b, .en = within(node.at("en"), least_scale, 1, "in (0, 1]")};
  if (node.has("tcol")) pair.tcol = scale(node.at("tcol"));
  if (node.has("stiffness")) pair.stiffness = scale(node.at("stiffness"));
  if (pair.tcol && pair.stiffness) node.at("stiffness").reject("left out with tcol");
  if (!pair.tcol && !pair.stiffness) pair.tcol = tcol;
  if (node.has("beta0")) pair.beta0 = within(node.at("beta0"), -1, 1, "in [-1, 1]");
  if (node.has("mu")) pair.mu = within(node.at("mu"), 0, greatest_scale, "in [0, 1e30]");
  if (pair.mu && !pair.beta0 && materials.tangential != TangentialForm::mindlin)
    node.complain("\"beta0\" is missing; it must be given with \"mu\"");
  if (!has_scale(pair, materials))
    node.complain("no scale; give tcol or stiffness, or young and poisson, or stiffness of both materials");
  return pair;
}

void read_pairs(const Node& root, Materials& materials) {
  const Node node = root.at("pairs");
  const auto tcol = root.has("tcol") ? std::optional(scale(root.at("tcol"))) : std::nullopt;
  std::map<std::pair<std::size_t, std::size_t>, bool> given;
  for (std::size_t k = 0; k < node.size(); ++k) {
    const Pair pair = read_pair(node.at(k), materials, tcol);
    if (!given.emplace(std::pair(pair.a, pair.b), true).second)
      node.at(k).at("between").reject("a pair that is given once");
    materials.pairs.push_back(pair);
  }
  for (std::size_t a = 0; a < materials.all.size() && !materials.all[a].wall; ++a)
    for (std::size_t b = a; b < materials.all.size(); ++b)
      if (!given.contains({a, b}))
        node.complain(fmt::format("no entry between \"{}\" and \"{}\", which can meet; it must be given",
                                  materials.all[a].name, materials.all[b].name));
}

void read_law(const Node& node, Materials& materials) {
  node.allow({"name", "end", "alpha", "stiffening"});
  materials.law = *LawKind::named(node.at("name").one_of(Laws::names));
  const auto refuse_unless = [&](bool held, const char* key) {
    if (node.has(key) && !held) node.at(key).reject(fmt::format("left out with the law {}", materials.law.name()));
    return node.has(key);
  };
  if (refuse_unless(holds_degree(materials.law), "alpha"))
    materials.held.alpha = within(node.at("alpha"), 0, 1, "in [0, 1]");
  if (refuse_unless(materials.law == kind_of<FractionalZener>, "stiffening"))
    materials.held.stiffening = scale(node.at("stiffening"));
  if (!node.has("end")) return;
  if (node.at("end").one_of({"force", "overlap"}) == "overlap") materials.end = ContactEnd::overlap;
  if (!materials.law.ends().offer(materials.end))
    node.at("end").reject(fmt::format("force with the law {}", materials.law.name()));
}

/// Engines' names for a pair are its materials' joined by "_": "a_b" for a and b, beside a material a_b.
void require_distinct_words(const Node& node, const Materials& materials) {
  std::map<std::string, std::string> makers;
  const auto add = [&](const std::string& word, const std::string& maker) {
    const auto [known, fresh] = makers.emplace(word, maker);
    if (!fresh)
      node.complain(fmt::format("the word {} of an export would stand for {} and for {}; rename one", word,
                                known->second, maker));
  };
  for (const Material& a : materials.all) add(a.name, a.name);
  for (const Material& a : materials.all)
    for (const Material& b : materials.all)
      if (&a != &b) add(fmt::format("{}_{}", a.name, b.name), fmt::format("{} with {}", a.name, b.name));
}

}  // namespace

Materials read_materials(const std::string& file, const std::string& text) {
  const console::Json json = console::parse_json(file, text, "docs/materials.md");
  const Node root(file, text, json);
  root.allow({"schema", "title", "law", "velocity", "soften", "match", "tcol", "tangential", "materials", "pairs"});
  if (root.has("schema")) root.at("schema").one_of({"ricochet/materials/1"});
  if (root.has("title")) root.at("title").text();
  Materials materials;
  read_law(root.at("law"), materials);
  materials.velocity = scale(root.at("velocity"));
  if (root.has("soften")) materials.soften = within(root.at("soften"), 1, greatest_scale, "in [1, 1e30]");
  if (root.has("match") && root.at("match").one_of({"time", "overlap"}) == "overlap")
    materials.match = LinearMatch::overlap;
  if (root.has("tangential"))
    materials.tangential = *tangential_form(root.at("tangential").one_of({"linear", "linear-undamped", "mindlin"}));
  read_all(root.at("materials"), materials);
  require_distinct_words(root.at("materials"), materials);
  read_pairs(root, materials);
  if (root.has("tangential") && std::none_of(materials.pairs.begin(), materials.pairs.end(),
                                             [](const Pair& pair) { return pair.beta0 || pair.mu; }))
    root.at("tangential").reject("left out where no pair has beta0 or mu");
  return materials;
}

}  // namespace ricochet::calibration
