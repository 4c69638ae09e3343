#include "../paper.hpp"

#include <verify/registry.hpp>

#include <console/gnuplot.hpp>
#include <console/number.hpp>
#include <ricochet/collision/fractional_collocation.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify {

namespace {

using console::Notation;
using console::Table;

// Above 0.97 the exact time is no longer known to 1e-12, and e_n is below 0.006.
constexpr double largest_alpha = 0.97;
constexpr int steps = 970;

/// (57) over the exact time at A = 1; the ratio does not depend on A, which only sets the unit of time.
double ratio(double alpha) { return tcol_estimate(1, alpha) / fractional_contact(alpha).tau; }

// The paper's Fig. 2, by the density of its sphere.
using paper::steel;
constexpr double rounding = steel.last_digit / 2;

double coefficient(double density) {
  return std::pow(steel.c, steel.alpha) * std::pow(steel.k, 1 - steel.alpha) / steel.impact(density).mass_eff;
}
double exact(double density) {
  return fractional_contact(steel.alpha).tau * std::pow(coefficient(density), -1 / (2 - steel.alpha));
}
double estimate(double density) { return tcol_estimate(coefficient(density), steel.alpha); }
/// (57) with the correction 1.641 taken plainly, not to the power 1−α: the other way to read the print.
double plain_estimate(double density) {
  return estimate(density) * std::pow(paper::estimate_factor, steel.alpha / (2 - steel.alpha));
}

Table over_alpha() {
  const Notation six{Notation::Kind::fixed, 6};
  Table table({{"alpha", {}, {Notation::Kind::fixed, 2}},
               {"en", {}, six},
               {"exact", "A^(-1/(2-alpha))", six},
               {"estimate", "A^(-1/(2-alpha))", six},
               {"error", "%", {Notation::Kind::fixed, 3}}},
              "Collision time of the fractional law: estimate (57) beside the exact one");
  for (int percent = 0; percent <= 97; percent += percent < 95 ? 5 : 2) {
    const double alpha = percent / 100.0;
    const FractionalContact contact = fractional_contact(alpha);
    const double estimate = tcol_estimate(1, alpha);
    table.row({alpha, contact.en, contact.tau, estimate, 100 * (estimate / contact.tau - 1)});
  }
  return table;
}

Table readings() {
  const Notation four{Notation::Kind::fixed, 3};
  Table table(
      {{"density", "kg/m³"}, {"exact", "µs", four}, {"estimate", "µs", four}, {"estimate, plain 1.641", "µs", four}},
      "The case of Fig. 2, whose density is printed as 7680 or 7850; the text has 38.6 and 37.8 µs");
  for (const double density : {steel.other_density, steel.density})
    table.row({density, 1e6 * exact(density), 1e6 * estimate(density), 1e6 * plain_estimate(density)});
  return table;
}

struct Curve {
  double greatest = 0;     ///< greatest ratio on the grid
  double steepest_up = 0;  ///< greatest rise between neighbours; the curve falls where this is negative
  double one_percent = 0;  ///< last α of the grid where the estimate is within 1 %
};

Curve follow() {
  Curve curve{.steepest_up = -1};
  double before = 0;
  for (int i = 0; i <= steps; ++i) {
    const double alpha = largest_alpha * i / steps;
    const double now = ratio(alpha);
    curve.greatest = std::max(curve.greatest, now);
    if (i > 0) curve.steepest_up = std::max(curve.steepest_up, now - before);
    if (now > 0.99) curve.one_percent = alpha;
    before = now;
  }
  return curve;
}

/// The greatest relative difference of t_col and e_n from those of the collocation, which knows no Mittag-Leffler
/// function and is good to 1e-10; e_n loses digits to cancellation beyond 0.9.
double against_collocation() {
  double worst = 0;
  for (int percent = 5; percent <= 90; percent += 5) {
    const double alpha = percent / 100.0;
    const FractionalContact closed = fractional_contact(alpha);
    const FractionalSolution solved = collocate_collision(alpha);
    worst = std::max({worst, std::abs(closed.tau / solved.tcol - 1), std::abs(closed.en / solved.en - 1)});
  }
  return worst;
}

console::Figure drawing(const Table& table) {
  using console::palette::blue, console::palette::gray;
  const console::Panel panel{.x = {.label = "conversion degree α", .range = std::pair(0.0, 1.0)},
                             .y = {.label = "estimate (57) / exact collision time", .range = std::pair(0.0, 1.05)},
                             .curves = {{.what = "1", .style = fmt::format("lines lw 1.5 dt 2 lc rgb '{}'", gray)},
                                        {.file = "tcol.csv",
                                         .what = "1:(1+$5/100)",
                                         .style = fmt::format("linespoints pt 7 ps 0.5 lw 2.5 lc rgb '{}'", blue)}},
                             .labels = {{"exact", 0.985, 1.03, fmt::format("right tc rgb '{}'", gray)},
                                        {"estimate (57)", 0.66, 0.86, fmt::format("tc rgb '{}'", blue)}}};
  return {
      .name = "tcol",
      .caption = "The estimate (57) of the collision time over the exact one: just below 1 at alpha = 0, and falling.",
      .plot = {.panels = {panel}},
      .data = {{"tcol.csv", table.csv()}}};
}

std::vector<Remark> remarks() {
  return {
      {"Table I, density of Fig. 2",
       fmt::format("Reads 7680 or 7850 kg/m³. 7850 gives a collision time of {:.2f} µs and an estimate (57) of {:.2f} "
                   "µs, as printed (38.6 and 37.8 µs); 7680 gives {:.2f} µs and {:.2f} µs.",
                   1e6 * exact(steel.density), 1e6 * estimate(steel.density), 1e6 * exact(steel.other_density),
                   1e6 * estimate(steel.other_density))},
      {"Eq. (57)", fmt::format("The exponent of 1.641 is not legible. With 1−α the estimate for Fig. 2 is {:.2f} µs, "
                               "below the exact time, as the text says; with 1.641 taken plainly it would be {:.2f} "
                               "µs, above it.",
                               1e6 * estimate(steel.density), 1e6 * plain_estimate(steel.density))}};
}

std::vector<Gate> gates(const Curve& curve) {
  const double at_zero = std::sqrt(6 * paper::estimate_factor) / std::numbers::pi;
  const double eps = std::numeric_limits<double>::epsilon();
  return {// Γ(4) = 6 and the spring's π; a handful of roundings in pow, tgamma and the root.
          near("ratio at alpha = 0 is sqrt(6*1.641)/pi", ratio(0), at_zero, 8 * eps),
          near("greatest ratio is that of alpha = 0: an underestimate throughout", curve.greatest, at_zero, 8 * eps),
          at_most("greatest rise of the ratio with alpha", curve.steepest_up, 0),
          at_most("exact time and e_n against the collocation, relative", against_collocation(), 1e-10),
          near("Fig. 2, 7850 kg/m³: exact time is the printed 38.6 µs", 1e6 * exact(steel.density), 1e6 * steel.tcol,
               1e6 * rounding),
          near("Fig. 2, 7850 kg/m³: estimate is the printed 37.8 µs", 1e6 * estimate(steel.density),
               1e6 * steel.tcol_estimate, 1e6 * rounding),
          at_least("Fig. 2, 7680 kg/m³: exact time misses the print by more than its rounding [µs]",
                   1e6 * (steel.tcol - exact(steel.other_density)), 1e6 * rounding)};
}

class Tcol : public Study {
 public:
  std::string name() const override { return "tcol"; }
  std::string title() const override { return "The estimate of the collision time, Eq. (57)"; }
  std::string claim() const override {
    return "Eq. (57) estimates the collision time of the fractional law, from below";
  }

  StudyResult run(const RunOptions&) override {
    const Curve curve = follow();
    StudyResult result;
    result.tables = {over_alpha(), readings()};
    result.gates = gates(curve);
    result.figures = {drawing(result.tables[0])};
    using console::significant;
    result.figures[0].finding = fmt::format(
        "The ratio starts at {}, falls throughout, is {} at α = 0.5 and {} at 0.97: (57) is good for "
        "weakly dissipative grains and always too short.",
        significant(ratio(0), 4), significant(ratio(0.5), 3), significant(ratio(largest_alpha), 2));
    result.remarks = remarks();
    const auto below = [](double alpha) { return significant(100 * (1 - ratio(alpha)), 2); };
    result.verdict = fmt::format(
        "(57) underestimates by {} % at alpha = 0, by {} % at 0.5 and by {} % at 0.97; it is within 1 % up to alpha = "
        "{:.3f}.",
        below(0), below(0.5), below(largest_alpha), curve.one_percent);
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> tcol_study() { return std::make_unique<Tcol>(); }

}  // namespace ricochet::verify
