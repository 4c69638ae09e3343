#include "law.hpp"

#include <stdexcept>
#include <vector>

namespace ricochet::simulate {

using console::Node;

AnyLaw read_law(const Node& node) {
  if (!node.json().is_object()) node.reject("an object with a law's name and parameters");
  const LawKind kind = *LawKind::named(node.at("name").one_of(Laws::names));
  std::vector<std::string_view> keys{"name"};
  for (const Parameter& p : kind.parameters()) keys.push_back(p.name);
  keys.push_back("end");
  node.allow(keys);
  std::vector<double> values;
  for (const Parameter& p : kind.parameters()) {
    const Node value = node.at(std::string(p.name));
    if (!p.domain.contains(value.number())) value.reject(p.domain.accepted);
    values.push_back(value.number());
  }
  try {
    const AnyLaw law = kind.with(values);
    const auto* fractional = std::get_if<Fractional>(&law);
    if (fractional && !(fractional->alpha() >= 0 && fractional->alpha() <= 1)) node.at("alpha").reject("in [0, 1]");
    return law;
  } catch (const std::invalid_argument& misuse) {  // parameters that do not go together
    node.complain(misuse.what());
  }
}

}  // namespace ricochet::simulate
