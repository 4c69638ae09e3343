#include "reduction_table.hpp"

#include "solution.hpp"

#include <cmath>

namespace ricochet::calibration {
namespace {

using support::Panel;

/// A point of the reduction: the group g = ln c at k = m = v₀ = 1, and the collision that it gives.
struct Point {
  double group, loss, tcol;
};

/// Follows the reduction from loss to loss, each the start of the search for the next.
class Walk {
 public:
  Walk(LawName law, ContactEnd end, double loss) : law_(law), end_(end), here_(at(std::log(loss))) {}

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
    const auto out = unit_collision(law_, {0, group}, end_);
    return {group, -std::log(out.en), out.tcol};
  }

  LawName law_;
  ContactEnd end_;
  Point here_;
  double slope_ = 1;
};

struct Coefficients {
  double k, c;
};

/// Of a damped power law.
Coefficients coefficients(const AnyLaw& law) {
  return std::visit(
      [](const auto& l) -> Coefficients {
        if constexpr (requires { l.c(); }) return {l.k(), l.c()};
        return {};
      },
      law);
}

}  // namespace

ReductionTable::ReductionTable(LawName law, ContactEnd end)
    : elastic_(coefficients(solve_directly(law, end, 1).value().law).k) {
  Walk walk(law, end, least_loss);
  const auto solution = [&](double loss) {
    // The other laws have their group in closed form.
    if (law != LawName::kuwabara_kono) return coefficients(solve_directly(law, end, std::exp(-loss)).value().law);
    const Point& point = walk.to(loss);
    return coefficients(scaled_law(law, with_unit_tcol(law, point.group, point.tcol)));
  };
  for (int i = 0; low_edge(i) < greatest_loss; ++i) {
    const double low = low_edge(i), high = low_edge(i + 1);
    Panel::Row k{}, c_over_loss{};
    for (std::size_t j = Panel::size; j-- > 0;) {  // the abscissae fall with j
      const double loss = Panel::abscissa(j, low, high);
      const Coefficients law_at = solution(loss);
      k[j] = law_at.k;
      c_over_loss[j] = law_at.c / loss;
    }
    panels_.push_back({Panel(k, low, high), Panel(c_over_loss, low, high)});
  }
}

}  // namespace ricochet::calibration
