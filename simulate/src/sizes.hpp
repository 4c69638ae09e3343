#pragma once

#include <simulate/random.hpp>

#include <console/node.hpp>

#include <variant>
#include <vector>

namespace ricochet::simulate {

/// How the radii of many spheres are distributed, by their number or their mass: always in [low, high].
class Sizes {
 public:
  /// A number, or {"distribution": …}. Throws console::BadInput.
  explicit Sizes(const console::Node& node);
  double draw(Random& random) const;  ///< a radius [m]

 private:
  struct Single {};
  struct Uniform {};
  struct Normal {
    double mean, deviation;
  };
  struct Lognormal {
    double median, sigma;  // of ln r
  };
  struct Table {
    std::vector<double> radii, shares;  // shares add up from one to the next, the last is 1
  };
  using Kind = std::variant<Single, Uniform, Normal, Lognormal, Table>;

  static Table read_table(const console::Node& node, bool by_mass);
  void read_bounds(const console::Node& node, double low, double high);
  double candidate(Random& random) const;

  console::Node place_;
  Kind kind_;
  double low_ = 0, high_ = 0;
  bool thinned_ = false;  // by mass: taken with probability (low/r)³
};

}  // namespace ricochet::simulate
