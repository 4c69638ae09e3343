#include "sizes.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <cmath>

namespace ricochet::simulate {
namespace {

using console::Node;

template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

double cube(double x) { return x * x * x; }

}  // namespace

Sizes::Sizes(const Node& node) : place_(node) {
  if (node.json().is_number()) {
    low_ = high_ = node.positive();
    return;
  }
  node.allow({"distribution", "low", "high", "mean", "deviation", "median", "sigma", "table", "by"});
  const std::string kind = node.at("distribution").one_of({"uniform", "normal", "lognormal", "table"});
  const bool by_mass = node.has("by") && node.at("by").one_of({"number", "mass"}) == "mass";
  thinned_ = by_mass && (kind == "uniform" || kind == "normal");
  if (kind == "table") {
    node.allow({"distribution", "table", "by"});
    kind_ = read_table(node.at("table"), by_mass);
  } else if (kind == "uniform") {
    node.allow({"distribution", "low", "high", "by"});
    kind_ = Uniform{};
    node.at("low"), node.at("high");
    read_bounds(node, 0, 0);
  } else if (kind == "normal") {
    node.allow({"distribution", "mean", "deviation", "low", "high", "by"});
    const double mean = node.at("mean").positive(), deviation = node.at("deviation").positive();
    kind_ = Normal{mean, deviation};
    if (!node.has("low") && !(mean > 3 * deviation))
      node.at("deviation").reject("less than a third of the mean where no \"low\" keeps radii > 0");
    read_bounds(node, mean - 3 * deviation, mean + 3 * deviation);
  } else {
    node.allow({"distribution", "median", "sigma", "low", "high", "by"});
    const double median = node.at("median").positive(), sigma = node.at("sigma").positive();
    if (!(sigma <= 3)) node.at("sigma").reject("the deviation of ln r, at most 3");
    read_bounds(node, median * exponential(-3 * sigma), median * exponential(3 * sigma));
    // Of a lognormal one by mass the one by number is lognormal too, of the same sigma.
    kind_ = Lognormal{by_mass ? median * exponential(-3 * sigma * sigma) : median, sigma};
  }
}

void Sizes::read_bounds(const Node& node, double low, double high) {
  low_ = node.has("low") ? node.at("low").positive() : low;
  high_ = node.has("high") ? node.at("high").positive() : high;
  if (!(low_ < high_))
    node.at(node.has("high") ? "high" : "low")
        .reject(
            fmt::format("such that low, {}, is less than high, {}", console::shortest(low_), console::shortest(high_)));
}

Sizes::Table Sizes::read_table(const Node& node, bool by_mass) {
  Table table;
  double sum = 0;
  for (std::size_t k = 0; k < node.size(); ++k) {
    const Node row = node.at(k);
    if (!row.json().is_array() || row.json().size() != 2) row.reject("a radius and its share [r, share]");
    const double radius = row.at(0).positive(), share = row.at(1).not_negative();
    sum += by_mass ? share / cube(radius) : share;
    table.radii.push_back(radius), table.shares.push_back(sum);
  }
  if (!(sum > 0 && std::isfinite(sum))) node.reject("rows [r, share] of which one has a share > 0");
  for (double& share : table.shares) share /= sum;
  return table;
}

double Sizes::candidate(Random& random) const {
  return std::visit(
      Cases{[&](const Single&) { return low_; }, [&](const Uniform&) { return random.between(low_, high_); },
            [&](const Normal& n) { return n.mean + n.deviation * random.normal(); },
            [&](const Lognormal& l) { return l.median * exponential(l.sigma * random.normal()); },
            [&](const Table& t) {
              const double u = random.uniform();
              std::size_t k = 0;
              while (k + 1 < t.shares.size() && u >= t.shares[k]) ++k;
              return t.radii[k];
            }},
      kind_);
}

double Sizes::draw(Random& random) const {
  if (std::holds_alternative<Table>(kind_)) return candidate(random);
  constexpr int most = 1'000'000;
  for (int k = 0; k < most; ++k) {
    const double r = candidate(random);
    if (r >= low_ && r <= high_ && (!thinned_ || random.uniform() < cube(low_ / r))) return r;
  }
  place_.complain("not one of a million radii lies between low and high; they must leave more");
}

}  // namespace ricochet::simulate
