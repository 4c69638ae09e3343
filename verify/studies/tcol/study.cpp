#include <verify/registry.hpp>

#include <console/number.hpp>
#include <ricochet/collision/fractional_contact.hpp>

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

/// The paper's Fig. 2: a steel sphere on a plate.
struct Fig2 {
  double radius = 3e-3;  // m
  double k = 4615380;    // kg/s²
  double c = 128.1;      // kg/s
  double alpha = 0.2;
  double printed_exact = 38.6e-6;     // s
  double printed_estimate = 37.8e-6;  // s
  double rounding = 0.05e-6;          // s: half a unit of the last printed digit

  double coefficient(double density) const {
    const double mass = density * 4 / 3 * std::numbers::pi * std::pow(radius, 3);
    return std::pow(c, alpha) * std::pow(k, 1 - alpha) / mass;
  }
  double exact(double density) const {
    return fractional_contact(alpha).tau * std::pow(coefficient(density), -1 / (2 - alpha));
  }
  double estimate(double density) const { return tcol_estimate(coefficient(density), alpha); }
  /// (57) with the correction 1.641 taken plainly, not to the power 1−α: the other way to read the print.
  double plain_estimate(double density) const { return estimate(density) * std::pow(1.641, alpha / (2 - alpha)); }
};

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

Table readings(const Fig2& figure) {
  const Notation four{Notation::Kind::fixed, 3};
  Table table(
      {{"density", "kg/m³"}, {"exact", "µs", four}, {"estimate", "µs", four}, {"estimate, plain 1.641", "µs", four}},
      "The case of Fig. 2, whose density is printed as 7680 or 7850; the text has 38.6 and 37.8 µs");
  for (const double density : {7680.0, 7850.0})
    table.row(
        {density, 1e6 * figure.exact(density), 1e6 * figure.estimate(density), 1e6 * figure.plain_estimate(density)});
  return table;
}

struct Curve {
  double greatest = 0;     ///< greatest ratio on the grid
  double steepest_up = 0;  ///< greatest rise between neighbours; the curve falls where this is negative
  double one_percent = 0;  ///< last α of the grid where the estimate is within 1 %
  double force_left = 0;   ///< greatest |R(t_col)| over the greatest force
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
    const FractionalContact contact = fractional_contact(alpha);
    // With A = m = v₀ = 1 the force is in units of max_force/tau.
    const double force = FractionalTrajectory(1, alpha, 1, 1).force(contact.tau);
    curve.force_left = std::max(curve.force_left, std::abs(force) * contact.tau / contact.max_force);
  }
  return curve;
}

console::Figure drawing(const Table& table) {
  return {"tcol",
          "The estimate (57) of the collision time over the exact one: just below 1 at alpha = 0, and falling.",
          "set xlabel 'conversion degree α'\nset ylabel 'estimate (57) / exact collision time'\n"
          "set yrange [0:1.05]\nset xrange [0:1]\nunset key\n"
          "set label 1 'exact' at 0.985,1.02 right tc rgb '#767676'\nset label 2 'estimate (57)' at 0.66,0.86 tc rgb "
          "'#0072b2'\n"
          "plot 1 with lines lw 1.5 dt 2 lc rgb '#767676', \\\n"
          "  'tcol.csv' skip 1 using 1:(1+$5/100) with linespoints pt 7 ps 0.5 lw 2.5 lc rgb '#0072b2'",
          {{"tcol.csv", table.csv()}}};
}

std::vector<Remark> remarks(const Fig2& figure) {
  const auto micro = [](double seconds) { return console::fixed(1e6 * seconds, 2) + " µs"; };
  return {
      {"Table I, density of Fig. 2", "Reads 7680 or 7850 kg/m³. 7850 gives a collision time of " +
                                         micro(figure.exact(7850)) + " and an estimate (57) of " +
                                         micro(figure.estimate(7850)) + ", as printed (38.6 and 37.8 µs); 7680 gives " +
                                         micro(figure.exact(7680)) + " and " + micro(figure.estimate(7680)) + "."},
      {"Eq. (57)", "The exponent of 1.641 is not legible. With 1−α the estimate for Fig. 2 is " +
                       micro(figure.estimate(7850)) +
                       ", below the exact time, as the text says; with 1.641 taken plainly it would be " +
                       micro(figure.plain_estimate(7850)) + ", above it."}};
}

class Tcol : public Study {
 public:
  std::string name() const override { return "tcol"; }
  std::string claim() const override {
    return "Eq. (57) estimates the collision time of the fractional law, from below";
  }

  StudyResult run(const RunOptions&) override {
    const Fig2 figure;
    const double density = 7850;
    const Curve curve = follow();
    const double at_zero = std::sqrt(6 * 1.641) / std::numbers::pi;
    const double eps = std::numeric_limits<double>::epsilon();
    StudyResult result;
    result.tables = {over_alpha(), readings(figure)};
    result.gates = {
        // Γ(4) = 6 and the spring's π; a handful of roundings in pow, tgamma and the root.
        near("ratio at alpha = 0 is sqrt(6*1.641)/pi", ratio(0), at_zero, 8 * eps),
        near("greatest ratio is that of alpha = 0: an underestimate throughout", curve.greatest, at_zero, 8 * eps),
        at_most("greatest rise of the ratio with alpha", curve.steepest_up, 0),
        // t_col has 1e-12; the force falls through zero with a slope of the order of max_force/t_col.
        at_most("force left at the exact time, over the greatest", curve.force_left, 1e-11),
        near("Fig. 2, 7850 kg/m³: exact time is the printed 38.6 µs", 1e6 * figure.exact(density),
             1e6 * figure.printed_exact, 1e6 * figure.rounding),
        near("Fig. 2, 7850 kg/m³: estimate is the printed 37.8 µs", 1e6 * figure.estimate(density),
             1e6 * figure.printed_estimate, 1e6 * figure.rounding),
        at_least("Fig. 2, 7680 kg/m³: exact time misses the print by more than its rounding [µs]",
                 1e6 * (figure.printed_exact - figure.exact(7680)), 1e6 * figure.rounding),
        at_least("plain 1.641 would overestimate, against the text: ratio in Fig. 2",
                 figure.plain_estimate(density) / figure.exact(density), 1)};
    result.figures = {drawing(result.tables[0])};
    result.figures[0].finding = "The ratio starts at " + console::significant(ratio(0), 4) + ", falls throughout, is " +
                                console::significant(ratio(0.5), 3) + " at α = 0.5 and " +
                                console::significant(ratio(largest_alpha), 2) +
                                " at 0.97: (57) is good for weakly dissipative grains and always too short.";
    result.remarks = remarks(figure);
    result.verdict = "(57) underestimates by " + console::significant(100 * (1 - ratio(0)), 2) +
                     " % at alpha = 0, by " + console::significant(100 * (1 - ratio(0.5)), 2) + " % at 0.5 and by " +
                     console::significant(100 * (1 - ratio(largest_alpha)), 2) +
                     " % at 0.97; it is within 1 % up to alpha = " + console::fixed(curve.one_percent, 3) + ".";
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> tcol_study() { return std::make_unique<Tcol>(); }

}  // namespace ricochet::verify
