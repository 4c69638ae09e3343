#include "law.hpp"

#include <ricochet/contact/any_law.hpp>

namespace ricochet::simulate {

NormalLaw read_law(const Node& node) {
  if (!node.json().is_object()) node.reject("an object with a law's name and parameters");
  const std::string law = node.at("name").one_of({"linear", "kuwabara-kono", "tsuji", "hysteretic", "fractional"});
  if (law == "hysteretic") {
    node.allow({"name", "k1", "k2", "end"});
    const double k1 = node.at("k1").positive(), k2 = node.at("k2").positive();
    if (k1 > k2) node.at("k1").reject("at most k2");
    return Hysteretic(k1, k2);
  }
  if (law == "fractional") {
    node.allow({"name", "k", "c", "alpha", "end"});
    const double alpha = node.at("alpha").number();
    if (alpha < 0 || alpha > 1) node.at("alpha").reject("in [0, 1]");
    return Fractional(node.at("k").positive(), node.at("c").positive(), alpha);
  }
  node.allow({"name", "k", "c", "end"});
  const double k = node.at("k").positive(), c = node.at("c").not_negative();
  if (law == "linear") return Linear(k, c);
  if (law == "tsuji") return Tsuji(k, c);
  return KuwabaraKono(k, c);
}

}  // namespace ricochet::simulate
