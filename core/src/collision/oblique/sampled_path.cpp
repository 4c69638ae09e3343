// The path of any contact law: steps of its own memory, extrapolated at the nodes of a mesh.

#include <ricochet/collision/oblique.hpp>

#include "../driven/limit.hpp"
#include "../driven/scaled_contact.hpp"
#include "../driven/stretch.hpp"
#include "graded_clock.hpp"
#include "normal_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ricochet::collision {
namespace {

constexpr int nodes = 64;  // intervals of a stretch that values are kept at
constexpr int most_steps = 1 << 15;
constexpr double enough = 1e-11;  // change of the limits, relative to the greatest value, at which doubling ends

/// ζ, ζ', R at one node as the steps grow finer.
struct Node {
  std::array<Limit, 3> limits;

  void add(const Instant& at) {
    limits[0].add(at.overlap);
    limits[1].add(at.rate);
    limits[2].add(at.force);
  }
};
using Nodes = std::vector<Node>;

/// The local polynomial through eleven neighbouring nodes and its slope, by the barycentric formula.
class Interpolant {
 public:
  explicit Interpolant(std::vector<double> values) : values_(std::move(values)) {}

  struct Reading {
    double value, slope;
  };
  /// x in units of the nodes.
  Reading at(double x) const {
    const auto last = static_cast<double>(values_.size() - points);
    const double first = std::clamp(std::floor(x) - 5, 0.0, last);
    if (x == std::floor(x)) x += 1e-9;  // the formula divides by the distance to each node
    double weights = 0, sum = 0;
    std::array<double, points> part{};
    for (std::size_t k = 0; k < points; ++k) {
      part[k] = weight[k] / (x - first - static_cast<double>(k));
      weights += part[k];
      sum += part[k] * value(first, k);
    }
    const double middle = sum / weights;
    double slope = 0;
    for (std::size_t k = 0; k < points; ++k)
      slope += part[k] * (middle - value(first, k)) / (x - first - static_cast<double>(k));
    return {middle, slope / weights};
  }

 private:
  static constexpr std::size_t points = 11;
  /// (−1)^k times the binomial coefficients of 10.
  static constexpr std::array<double, points> weight{1, -10, 45, -120, 210, -252, 210, -120, 45, -10, 1};

  double value(double first, std::size_t k) const { return values_[static_cast<std::size_t>(first) + k]; }

  std::vector<double> values_;
};

GradedClock clock_of(const Collision& c) { return {c.time_max_overlap, c.tcol - c.time_max_overlap}; }

/// One stretch: its three interpolants.
struct Branch {
  Interpolant overlap, rate, force;
};

class SampledPath final : public NormalPath {
 public:
  SampledPath(Branch loading, Branch unloading, const Impact& impact, const Collision& by_force)
      : NormalPath(1, 2, std::abs(by_force.overlap_end) < 1e-9 * by_force.max_overlap),
        branches_{std::move(loading), std::move(unloading)},
        clock_(clock_of(by_force)),
        end_rate_(-by_force.en * impact.velocity) {
    margin_ = 1e-3;  // (1e-3)⁴ of the collision: of what is left there the extrapolated values know nothing
    noise_ = 1e-11;
  }

  NormalInstant at(double s, bool loading) const override {
    s = inside(s);
    const Branch& branch = loading ? branches_.front() : branches_.back();
    const double x = nodes * (loading ? s : s - 1);
    const auto [time, rest, pace] = clock_.at(s, loading);
    const auto [force, growth] = branch.force.at(x);
    const double rate = branch.rate.at(x).value;
    const double overlap =
        closes_ && rest < 1e-4 * clock_.rebound ? last_overlap(rest, rate, end_rate_) : branch.overlap.at(x).value;
    return {pace, overlap, rate, std::max(0.0, force), nodes * growth / pace};
  }

 private:
  std::array<Branch, 2> branches_;
  GradedClock clock_;
  double end_rate_;
};

/// Adds what a stretch of `steps` steps passed at the nodes; how far the limits still move, relative to the greatest.
double add(Nodes& nodes_of, const std::vector<Instant>& path, int steps) {
  const auto stride = static_cast<std::size_t>(steps / nodes);
  for (std::size_t n = 0; n < nodes_of.size(); ++n) nodes_of[n].add(path[n * stride]);
  double doubt = 0;
  for (std::size_t q = 0; q < 3; ++q) {
    double greatest = 0, worst = 0;
    for (const Node& node : nodes_of) {
      greatest = std::max(greatest, std::abs(node.limits[q].value()));
      worst = std::max(worst, node.limits[q].doubt());
    }
    doubt = std::max(doubt, worst / greatest);
  }
  return doubt;
}

Branch branch(const Nodes& nodes_of, const std::array<double, 3>& units) {
  const auto values = [&](std::size_t q) {
    std::vector<double> v;
    v.reserve(nodes_of.size());
    for (const Node& node : nodes_of) v.push_back(units[q] * node.limits[q].value());
    return Interpolant(std::move(v));
  };
  return {values(0), values(1), values(2)};
}

}  // namespace

std::shared_ptr<const NormalPath> normal_path(DrivenLaw& law, const Impact& impact, const Collision& by_force) {
  const double unit = time_scale(law, impact).value_or(by_force.tcol);
  const GradedClock clock = clock_of(by_force);
  ScaledContact contact(law, impact, unit);
  Nodes up(nodes + 1), down(nodes + 1);
  for (int steps = nodes; steps <= most_steps; steps *= 2) {
    Stretch loading(contact, contact.touch(), Graded::at_start, steps);
    contact.mark();
    const Instant top = loading.run(clock.turn / unit);
    contact.mark();
    Stretch unloading(contact, top, Graded::at_end, steps);
    unloading.run(clock.rebound / unit);
    if (std::max(add(up, loading.path(), steps), add(down, unloading.path(), steps)) <= enough) break;
  }
  const std::array<double, 3> units{impact.velocity * unit, impact.velocity, impact.mass_eff * impact.velocity / unit};
  return std::make_shared<SampledPath>(branch(up, units), branch(down, units), impact, by_force);
}

}  // namespace ricochet::collision
