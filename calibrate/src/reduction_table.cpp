#include "reduction_table.hpp"

#include <cmath>

namespace ricochet::calibration {
namespace {

using support::Panel;

/// A point of the reduction: the group g = ln c at k = m = v₀ = 1, and the collision that it gives.
struct Point {
  double group, loss, tcol;
};

/// Follows the reduction from loss to loss, each the start of the search for the next.
template <class Law>
class Walk {
 public:
  Walk(ContactEnd end, double loss) : end_(end), here_(at(std::log(loss))) {}

  /// Secant on ln(loss/target), which is nearly linear in g, from the last two points: three or four collisions.
  const Point& to(double loss) {
    const auto miss = [&](const Point& p) { return std::log(p.loss / loss); };
    Point before = here_;
    here_ = at(before.group - miss(before) / slope_);
    for (int trial = 0; trial < 30 && here_.group != before.group; ++trial) {
      const double change = miss(here_) - miss(before);
      if (std::abs(miss(here_)) <= 4e-16 || change == 0) break;
      // Within the noise of the collision two points say nothing about the slope.
      if (std::abs(change) > 1e-6) slope_ = change / (here_.group - before.group);
      if (std::abs(miss(here_)) < 1e-14 / loss && std::abs(change) < 1e-6) break;
      before = here_;
      here_ = at(here_.group - miss(here_) / slope_);
    }
    return here_;
  }

 private:
  Point at(double group) const {
    const auto out = collide(Reduction<Law>::at({0, group}), {1, 1}, {end_});
    return {group, -std::log(out.en), out.tcol};
  }

  ContactEnd end_;
  Point here_;
  double slope_ = 1;
};

}  // namespace

template <class Law>
ReductionTable<Law>::ReductionTable(ContactEnd end) : elastic_(Reduction<Law>::unit(1, end).value().law.k()) {
  Walk<Law> walk(end, least_loss);
  const auto solution = [&](double loss) {
    // Where the loss has a closed form there is nothing to walk.
    const auto known = std::isfinite(Law::overdamped_from) ? Reduction<Law>::unit(std::exp(-loss), end) : std::nullopt;
    if (known) return known->law;
    const Point& point = walk.to(loss);
    return Reduction<Law>::at(Reduction<Law>::with_unit_tcol(point.group, point.tcol));
  };
  for (int i = 0; low_edge(i) < greatest_loss; ++i) {
    const double low = low_edge(i), high = low_edge(i + 1);
    Panel::Row k{}, c_over_loss{};
    for (std::size_t j = Panel::size; j-- > 0;) {  // the abscissae fall with j
      const double loss = Panel::abscissa(j, low, high);
      const Law law = solution(loss);
      k[j] = law.k();
      c_over_loss[j] = law.c() / loss;
    }
    panels_.push_back({Panel(k, low, high), Panel(c_over_loss, low, high)});
  }
}

template class ReductionTable<Linear>;
template class ReductionTable<KuwabaraKono>;
template class ReductionTable<Tsuji>;

}  // namespace ricochet::calibration
