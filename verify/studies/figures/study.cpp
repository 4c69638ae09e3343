#include <verify/registry.hpp>

#include <console/number.hpp>
#include <console/panels.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/solvers/fractional_solvers.hpp>
#include <ricochet/collision/trace.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify {

namespace {

using console::Notation;
using console::Table;

/// One curve of a figure, over time; a block of the figure's CSV.
struct Curve {
  std::string title;
  std::vector<Instant> points;
  std::string style;  ///< "with …"
  int panel = 0;      ///< the group of curves that share a column of panels
};

/// The axes of a row of panels: CSV columns 2 t [1e-6 s], 3 overlap [1e-6 m], 4 rate [m/s], 5 force [N].
struct Axes {
  int x, y;
  const char *x_label, *y_label;
};

constexpr Axes over_time[] = {
    {2, 3, "t [µs]", "overlap [µm]"}, {2, 4, "t [µs]", "velocity [m/s]"}, {2, 5, "t [µs]", "force [N]"}};
constexpr Axes phases[] = {{3, 4, "overlap [µm]", "velocity [m/s]"},
                           {3, 5, "overlap [µm]", "force [N]"},
                           {4, 5, "velocity [m/s]", "force [N]"}};

/// The i-th curve of a group, in colours that differ.
std::string line(std::size_t i) {
  constexpr const char* colours[] = {console::palette::purple, console::palette::blue, console::palette::green,
                                     console::palette::orange, console::palette::vermilion};
  return std::string("with lines lw 2 lc '") + colours[i % std::size(colours)] + "'";
}

std::string csv_of(const std::vector<Curve>& curves) {
  std::string csv = "curve,t [1e-6 s],overlap [1e-6 m],velocity [m/s],force [N]\n";
  for (const Curve& curve : curves) {
    if (&curve != &curves.front()) csv += "\n\n";
    for (const Instant& p : curve.points)
      csv += '"' + curve.title + "\"," + console::shortest(p.time * 1e6) + "," + console::shortest(p.overlap * 1e6) +
             "," + console::shortest(p.rate) + "," + console::shortest(p.force) + "\n";
  }
  return csv;
}

/// A group of curves, drawn in one column of panels; the key stands in the panel of row `key_row` at `key`.
struct Column {
  std::string title, key;
  std::size_t key_row;
};

double coordinate(const Instant& p, int column) {
  return column == 2 ? 1e6 * p.time : column == 3 ? 1e6 * p.overlap : column == 4 ? p.rate : p.force;
}

/// The distance of an axis's tics, 1, 2 or 5 times a power of ten: left to itself gnuplot sets so many that their
/// labels touch in a panel of this width.
double tic_step(const std::vector<Curve>& curves, int panel, int column) {
  double low = 0, high = 0;
  for (const Curve& curve : curves) {
    if (curve.panel != panel) continue;
    for (const Instant& p : curve.points) {
      low = std::min(low, coordinate(p, column));
      high = std::max(high, coordinate(p, column));
    }
  }
  constexpr double intervals = 6;
  const double least = (high - low) / intervals, power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return factor * power;
  return 10 * power;
}

/// Rows of panels over columns of curve groups.
console::Figure figure(const std::string& name, const std::string& caption, const std::vector<Curve>& curves,
                       std::span<const Axes> rows, const std::vector<Column>& columns) {
  const std::string file = name + ".csv";
  std::string script = "set multiplot layout " + std::to_string(rows.size()) + "," + std::to_string(columns.size()) +
                       " margins " + (columns.size() == 1 ? "0.13" : "0.08") +
                       ",0.96,0.07,0.95 spacing 0.08,0.075\nset key font ',10' samplen 1.5 spacing 1\nset xzeroaxis lt "
                       "1 lc rgb 'black' lw 0.6\nset title font ',15'\n";
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const Axes& axes = rows[row];
      script += "set title '" + (row == 0 ? columns[column].title : "") + "'\nset key " +
                (row == columns[column].key_row ? columns[column].key : "off") + "\nset xlabel '" + axes.x_label +
                "' offset 0,0.5\nset ylabel '" + axes.y_label + "' offset 1,0\nset xtics " +
                console::shortest(tic_step(curves, static_cast<int>(column), axes.x)) + "\n";
      std::string plot;
      for (std::size_t i = 0; i < curves.size(); ++i) {
        if (curves[i].panel != static_cast<int>(column)) continue;
        plot += (plot.empty() ? "plot '" : ", \\\n  '") + file + "' " + (i == 0 ? "skip 1 " : "") + "index " +
                std::to_string(i) + " using " + std::to_string(axes.x) + ":" + std::to_string(axes.y) + " " +
                curves[i].style + " title '" + curves[i].title + "'";
      }
      script += plot + "\n";
    }
  script += "unset multiplot\n";
  const int wide = columns.size() == 1 ? 640 : 400 * static_cast<int>(columns.size());
  return {.name = name,
          .caption = caption,
          .script = script,
          .data = {{file, csv_of(curves)}},
          .width = wide,
          .height = 320 * static_cast<int>(rows.size())};
}

/// The closed form until the force has fallen to zero, or to `longest` [s] where it never does. At t_b the force of
/// α > 1 is infinite: the first point is left out.
std::vector<Instant> closed_form(const Fractional& law, const Impact& impact, double longest) {
  const FractionalTrajectory motion(law.coefficient(), law.alpha(), impact.mass_eff, impact.velocity);
  std::vector<Instant> points;
  constexpr int samples = 600;
  for (int i = law.alpha() > 1 ? 1 : 0; i <= samples; ++i) {
    const double t = longest * i / samples;
    points.push_back({t, motion.overlap(t), motion.rate(t), motion.force(t)});
    if (i > 1 && points.back().force <= 0) break;
  }
  return points;
}

// Fig. 2: a steel sphere, r = 3 mm, 7850 kg/m³ (see table1), on a plate.
const Fractional steel(4615380, 128.1, 0.2);
const Impact steel_impact{.velocity = 1, .mass_eff = 7850 * 4.0 / 3 * std::numbers::pi * 27e-9};
constexpr double steel_tcol = 38.6e-6;  // s, as the paper assumes

console::Figure figure2() {
  std::vector<Curve> curves;
  const FractionalTrajectory motion(steel.coefficient(), steel.alpha(), steel_impact.mass_eff, steel_impact.velocity);
  std::string missed[2];  // by the finest steps, at the end
  const FractionalScheme schemes[] = {FractionalScheme::rectangle, FractionalScheme::arms_exponential};
  for (int column = 0; column < 2; ++column) {
    for (const int steps : {5, 10, 20, 40}) {
      const FractionalSolverOptions options{.step = steel_tcol / steps, .end_time = steel_tcol};
      auto points = solve_collision(schemes[column], steel, steel_impact, options).path;
      missed[column] = console::scientific(std::fabs(points.back().rate - motion.rate(points.back().time)), 0);
      points.front().force = 0;  // at t_b the arms' dashpot stands for what is not yet there
      curves.push_back({"ΔN = " + std::to_string(steps), points, "with linespoints lw 1.5 ps 0.6", column});
    }
    curves.push_back({"exact", closed_form(steel, steel_impact, steel_tcol), "with lines lw 2 lc 'black'", column});
  }
  auto drawn =
      figure("figure2",
             "Fig. 2: overlap, velocity and force for growing numbers of steps; left (59) as written, right "
             "the arms with the exponential step.",
             curves, over_time, {{"(59) as written", "top right", 1}, {"arms, exponential step", "top right", 1}});
  drawn.finding = "With 40 steps (59) as written misses the last velocity by " + missed[0] +
                  " m/s, the arms with the exponential step by " + missed[1] + " m/s.";
  return drawn;
}

// Figs. 3 and 4: two spheres, r = 1.5 mm, 1000 kg/m³.
const Impact glass_impact{.velocity = 0.5, .mass_eff = 7.06858e-6};
constexpr double k = 5000, c = 0.1;  // kg/s², kg/s
const std::vector<std::vector<double>> groups{{-0.5, -0.25, -0.1}, {0, 0.25, 0.5, 0.75, 0.9}, {1.1, 1.25, 1.5}};

/// [s]; long enough for the slowest rebound.
double shown(double alpha) { return alpha < 1 ? 3e-4 : 2e-4; }

std::vector<Curve> alpha_curves() {
  std::vector<Curve> curves;
  for (std::size_t group = 0; group < groups.size(); ++group)
    for (std::size_t i = 0; i < groups[group].size(); ++i) {
      const double alpha = groups[group][i];
      const Fractional law(k, c, alpha);
      const int panel = static_cast<int>(group);
      curves.push_back(
          {"α = " + console::shortest(alpha), closed_form(law, glass_impact, shown(alpha)), line(i), panel});
      if (alpha > 0.97) continue;  // there is no rebound to solve for
      const double step = curves.back().points.back().time / 30;
      curves.push_back({"", solve_collision(FractionalScheme::trapezoid, law, glass_impact, {.step = step}).path,
                        "with points pt 6 ps 0.5 lc rgb '#767676'", panel});
      curves.back().points.pop_back();  // past the end
    }
  return curves;
}

/// Greatest distance of the solver's points from the closed form, in units of v₀.
double solver_distance() {
  double worst = 0;
  for (const auto& group : groups)
    for (const double alpha : group) {
      if (alpha > 0.97) continue;
      const Fractional law(k, c, alpha);
      const FractionalTrajectory exact(law.coefficient(), alpha, glass_impact.mass_eff, glass_impact.velocity);
      const double step = closed_form(law, glass_impact, shown(alpha)).back().time / 30;
      for (const auto& s : solve_collision(FractionalScheme::trapezoid, law, glass_impact, {.step = step}).path)
        if (!(std::fabs(s.rate - exact.rate(s.time)) <= worst)) worst = std::fabs(s.rate - exact.rate(s.time));
    }
  return worst / glass_impact.velocity;
}

/// A law of Table II with the printed coefficients.
struct Printed {
  std::string name;
  Collision collision;
  std::vector<Instant> points;
};

template <class Law>
Printed printed(const std::string& name, const Law& law, ContactEnd end) {
  const Collision collision = collide(law, glass_impact, {.end = end});
  return {name, collision, trace(law, glass_impact, collision.tcol, 2000)};
}

std::vector<Printed> table2_laws() {
  std::vector<Printed> laws;
  laws.push_back(printed("linear1", Linear(7316, 0.0979), ContactEnd::overlap));
  laws.push_back(printed("linear2", Linear(5225, 0.0981), ContactEnd::force));
  laws.push_back(printed("nonlinear", KuwabaraKono(1392000, 33.885), ContactEnd::force));
  laws.push_back(printed("hysteretic", Hysteretic(3924, 15697), ContactEnd::force));
  const Fractional law(5225, 0.297, 0.3197);
  const FractionalContact contact = fractional_contact(law.alpha());
  const FractionalTrajectory motion(law.coefficient(), law.alpha(), glass_impact.mass_eff, glass_impact.velocity);
  const double tcol = contact.tau * motion.time_scale();
  Printed fractional{"fractional", {}, closed_form(law, glass_impact, tcol)};
  fractional.collision.tcol = tcol;
  fractional.collision.en = contact.en;
  laws.push_back(fractional);
  return laws;
}

console::Figure figure5(const std::vector<Printed>& laws) {
  std::vector<console::Motion> motions;
  const Printed *deepest = &laws.front(), *shallowest = &laws.front();
  for (const Printed& law : laws) {
    motions.push_back({law.name, {}});
    const std::size_t every = law.points.size() > 1000 ? 10 : 1;
    for (std::size_t i = 0; i < law.points.size(); i += every)
      motions.back().moments.push_back(
          {law.points[i].time, law.points[i].overlap, law.points[i].rate, law.points[i].force});
    if (law.points.back().overlap > deepest->points.back().overlap) deepest = &law;
    if (law.points.back().overlap < shallowest->points.back().overlap) shallowest = &law;
  }
  auto figure = console::collision_panels(
      "figure5", "Fig. 5: overlap, velocity and force under every law of Table II with the printed coefficients.",
      motions);
  figure.finding = "All five laws bring the spheres from 0.5 to about " +
                   console::fixed(laws.front().points.back().rate, 2) + " m/s in about " +
                   console::significant(1e6 * laws.front().collision.tcol, 3) +
                   " µs; they differ on the way, and in the overlap left at the end: " +
                   console::fixed(1e6 * shallowest->points.back().overlap, 1) + " µm for " + shallowest->name + ", " +
                   console::fixed(1e6 * deepest->points.back().overlap, 1) + " µm for " + deepest->name + ".";
  return figure;
}

Table ends(const std::vector<Printed>& laws) {
  Table table({{"law"},
               {"t_col", "1e-4 s", {Notation::Kind::fixed, 5}},
               {"e_n", "", {Notation::Kind::fixed, 5}},
               {"overlap at the end", "1e-6 m", {Notation::Kind::fixed, 3}},
               {"force at the end", "N", {Notation::Kind::fixed, 4}}},
              "Where the curves of Fig. 5 end");
  for (const Printed& law : laws)
    table.row({law.name, law.collision.tcol * 1e4, law.collision.en, law.points.back().overlap * 1e6,
               law.points.back().force});
  table.note("linear1 ends where its overlap does: its force has turned attractive before.");
  return table;
}

class Figures : public Study {
 public:
  std::string name() const override { return "figures"; }
  std::string claim() const override { return "Figs. 2-5: the collision over time and in phase, as data and plots"; }
  StudyResult run(const RunOptions&) override {
    const std::vector<Printed> laws = table2_laws();
    StudyResult result;
    result.tables.push_back(ends(laws));
    for (const Printed& law : laws) {
      // The printed coefficients carry four digits: Table II, checked in table2.
      result.gates.push_back(near("Fig. 5, " + law.name + ": t_col / 1e-4 s", law.collision.tcol / 1e-4, 1, 2e-3));
      result.gates.push_back(near("Fig. 5, " + law.name + ": e_n / 0.5", law.collision.en / 0.5, 1, 2e-3));
      result.gates.push_back(near("Fig. 5, " + law.name + ": the curve's last velocity / -e_n v0",
                                  law.points.back().rate / (-law.collision.en * glass_impact.velocity), 1, 1e-3));
    }
    // Second order with 30 steps: 1/900.
    result.gates.push_back(
        at_most("Figs. 3, 4: solver with 30 steps from the closed form, of v0", solver_distance(), 3.0 / 900));
    const std::string names[] = {"α < 0: gains energy", "0 ≤ α < 1: rebounds", "α > 1: no rebound"};
    const std::vector<Column> times{{names[0], "top right", 1}, {names[1], "top right", 1}, {names[2], "top right", 1}};
    const std::vector<Column> planes{
        {names[0], "left center", 0}, {names[1], "left center", 0}, {names[2], "bottom left", 0}};
    result.figures.push_back(figure2());
    result.figures.push_back(figure("figure3",
                                    "Fig. 3: overlap, velocity and force for three groups of alpha; circles: "
                                    "product trapezoid, 30 steps.",
                                    alpha_curves(), over_time, times));
    result.figures.push_back(figure("figure4",
                                    "Fig. 4: phase curves for the three groups of alpha; circles: product "
                                    "trapezoid, 30 steps.",
                                    alpha_curves(), phases, planes));
    result.figures[1].finding =
        "Below 0 the spheres leave faster than they came; between 0 and 1 they leave the slower the "
        "greater α; above 1 they stay together. The solver's points lie within " +
        console::scientific(solver_distance(), 0) + " of v0 of the closed form.";
    result.figures[2].finding =
        "The loops of velocity over overlap are closed by less and less velocity as α grows; above 1 they stay open.";
    result.figures.push_back(figure5(laws));
    result.verdict =
        "Four figures with their data; the printed coefficients of Table II end within 0.2 % of t_col = 1e-4 s "
        "and e_n = 0.5.";
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> figures_study() { return std::make_unique<Figures>(); }

}  // namespace ricochet::verify
