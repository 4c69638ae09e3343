#include "grain.hpp"
#include "measured.hpp"
#include "scan.hpp"
#include "stepping.hpp"

#include <verify/registry.hpp>

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify {

namespace {

using console::Notation;
using console::Table;
using namespace oblique;

Table angle_table() {
  const Notation six{Notation::Kind::significant, 6}, whole{Notation::Kind::significant, 2};
  std::vector<console::Column> columns{{"angle", "deg", whole}};
  const auto laws = contacts();
  columns.reserve(10);
  for (const char* quantity : {"et", "spin", "angle after"})
    for (const Contact& c : laws)
      columns.push_back({fmt::format("{} {}", quantity, c.name),
                         std::string_view(quantity) == "spin"          ? "1/s"
                         : std::string_view(quantity) == "angle after" ? "deg"
                                                                       : "",
                         six});
  Table table(columns, "Rebound of the measured grain, 5 mm at 3.9 m/s, by three tangential laws");
  for (int degrees = 0; degrees <= 85; degrees += 5) {
    std::vector<console::Cell> cells{static_cast<double>(degrees)};
    std::vector<Rebound> all;
    all.reserve(laws.size());
    for (const Contact& c : laws) all.push_back(rebound(c, degrees));
    for (const char* quantity : {"et", "spin", "angle"})
      for (const Rebound& r : all) cells.emplace_back(value_of(r, quantity));
    table.row(cells);
  }
  table.note(
      "et: of the centre. linear: k_n = 1.72e7, k_t = 1.48e7 N/m; mindlin: k_n = 4.1968e9, k_t = 5.4084e9 "
      "N/m^(3/2); mu = 0.092, nothing lost along the normal.");
  return table;
}

/// A plain leapfrog at t_col/320000 of the linear springs.
void add_check_values(std::vector<Gate>& gates) {
  struct Value {
    double degrees, et, spin;
  };
  const Contact linear = contacts()[1];
  for (const Value& v :
       {Value{5, 0.806425, 65.797683}, Value{20, 0.593122, 542.726029}, Value{40, 0.780717, 549.713492}}) {
    const Rebound r = rebound(linear, v.degrees);
    gates.push_back(near(fmt::format("linear, {} degrees: e_t, by plain stepping", v.degrees), r.et, v.et, 5.1e-7));
    gates.push_back(near(fmt::format("linear, {} degrees: spin, by plain stepping", v.degrees), r.spin, v.spin, 2e-6));
  }
}

/// Every law from where rigid friction slides throughout, and the rigid one everywhere.
void add_exact(std::vector<Gate>& gates) {
  double sliding = 0, sticking = 0;
  for (const Contact& c : contacts())
    for (int half = 1; half < 180; ++half) {
      const double degrees = 0.5 * half;
      const ObliqueImpact impact = at_angle(degrees);
      const double v_t = impact.i.velocity.x, slides = 1 - 2 * mu * impact.i.velocity.z / v_t;
      const double et = rebound(c, degrees).et;
      if (slides > 5.0 / 7 + 0.02 && c.name != "mindlin") sliding = std::max(sliding, std::abs(et - slides));
      if (c.name == "rigid" && slides < 5.0 / 7) sticking = std::max(sticking, std::abs(et - 5.0 / 7));
    }
  gates.push_back(at_most("gross sliding, rigid and linear: e_t off 1 - mu(1+e_n)v_n/v_t", sliding, 1e-9));
  gates.push_back(at_most("rigid, sticking: e_t off 5/7", sticking, 1e-9));
}

void add_scan(StudyResult& result, const Scan& s) {
  result.gates.push_back(
      at_most(fmt::format("{} random impacts: without an answer", s.impacts), static_cast<double>(s.failed), 0));
  result.gates.push_back(at_most("random impacts: kinetic energy gained, of what there was", s.most_gained, 1e-9));
  result.gates.push_back(at_most("random impacts: balance off, of what there was", s.worst_balance, 1e-9));
  result.gates.push_back(at_most("random impacts: a mechanism's loss below 0, of the energy", s.most_negative, 1e-9));
  result.extra["random_impacts"] = {{"impacts", s.impacts},
                                    {"failed", s.failed},
                                    {"most_gained", s.most_gained},
                                    {"worst_balance", s.worst_balance},
                                    {"most_negative", s.most_negative},
                                    {"greatest_share_of_friction_limit", s.worst_limit}};
}

class Oblique : public Study {
 public:
  std::string name() const override { return "oblique"; }
  std::string title() const override { return "Oblique impact"; }
  std::string claim() const override {
    return "The oblique collision of any normal law with any tangential one is exact where that is known, makes no "
           "energy, and with springs meets measured grains";
  }

  StudyResult run(const RunOptions& options) override {
    StudyResult result;
    result.tables = {angle_table()};
    add_check_values(result.gates);
    add_exact(result.gates);
    compare_with_measured(result);
    compare_with_chung_ooi(result);
    compare_with_thornton(result);
    const std::vector<benchmarks::Row> steps = stepping_rows();
    benchmarks::add_gates(result.gates, steps);
    result.tables.push_back(benchmarks::table(steps));
    const Scan random = scan(options.thorough ? 100'000 : 1000);
    add_scan(result, random);
    result.figures = {rebound_figure(), normalised_figure()};
    const Rebound rigid = rebound(contacts()[0], 20), linear = rebound(contacts()[1], 20);
    result.verdict = fmt::format(
        "At 20 degrees, where e_t = 0.597 is measured, rigid friction keeps {} and a linear spring {}; of {} random "
        "impacts none gained energy, and the balance is off by at most {} of it.",
        console::significant(rigid.et, 3), console::significant(linear.et, 3), random.impacts,
        console::significant(random.worst_balance, 1));
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> oblique_study() { return std::make_unique<Oblique>(); }

}  // namespace ricochet::verify
