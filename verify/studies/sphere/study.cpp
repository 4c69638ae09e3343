// The sphere that the paper's law stands for.

#include "convergence.hpp"
#include "restitution.hpp"

#include <verify/registry.hpp>

#include <console/number.hpp>
#include <ricochet/collision/power_law_sphere.hpp>

#include <fmt/format.h>

#include <cmath>

namespace ricochet::verify {
namespace {

using console::Notation;
using sphere::Refinement, sphere::Row;

constexpr double digits_agreed = 1e-6;

/// e_n as another computation had them before this study was written, to 5e-6 (the sphere) and to its last digit.
struct Beforehand {
  double alpha, sphere, linear, of_power;
};
constexpr Beforehand beforehand[] = {{0.0625, 0.886268, 0.885301, 0.873847},
                                     {0.125, 0.781207, 0.779414, 0.762487},
                                     {0.25, 0.594853, 0.591797, 0.571648},
                                     {0.5, 0.304378, 0.300195, 0.285653},
                                     {0.75, 0.106654, 0.103218, 0.097580}};

/// How near the paper's law is said to be [%].
struct Within {
  double alpha, percent;
};
constexpr Within claimed[] = {{0.0625, 0.15}, {0.25, 0.6}, {0.5, 1.5}};

std::string at(double alpha) { return fmt::format("alpha = {}", console::shortest(alpha)); }

const Row& row_of(const std::vector<Row>& rows, double alpha) {
  for (const Row& r : rows)
    if (r.alpha == alpha) return r;
  throw std::logic_error("no such row");
}

void add_values(std::vector<Gate>& gates, const std::vector<Row>& rows) {
  for (const Within& w : claimed) {
    const Row& r = row_of(rows, w.alpha);
    gates.push_back(
        near(fmt::format("{}: the paper's law off the sphere [%]", at(w.alpha)), r.off(r.linear), 0, w.percent));
  }
  for (const Beforehand& b : beforehand) {
    const Row& r = row_of(rows, b.alpha);
    gates.push_back(
        near(fmt::format("{}: e of the sphere as computed beforehand", at(b.alpha)), r.ting, b.sphere, 5e-6));
    gates.push_back(near(fmt::format("{}: e of the paper's law, likewise", at(b.alpha)), r.linear, b.linear, 5e-7));
    gates.push_back(near(fmt::format("{}: e of K D^a z^1.5, likewise", at(b.alpha)), r.of_power, b.of_power, 5e-7));
    gates.push_back(near(fmt::format("{}: e by elements as by Ting's formulation", at(b.alpha)), r.elements, r.ting,
                         digits_agreed));
    gates.push_back(at_most(fmt::format("{}: its last two limits differ by", at(b.alpha)), r.doubt, digits_agreed));
  }
}

/// Straight through α = 0.001 and 0.002 to 0, where Hertz is elastic; the curvature leaves some 2·0.001·0.002.
void add_hertz(std::vector<Gate>& gates) {
  const auto straight = [](double a, double b) { return 2 * a - b; };
  const SphereImpact one = power_law_sphere(0.001), two = power_law_sphere(0.002);
  const double hertz = 2 * std::pow(1.25, 0.4) * 0.4 * std::beta(0.4, 0.5);
  gates.push_back(near("alpha to 0: e of Hertz", straight(one.en, two.en), 1, 1e-5));
  gates.push_back(near("alpha to 0: t_col of Hertz, relative", straight(one.tcol, two.tcol) / hertz, 1, 1e-5));
}

/// Where a term of order p has another of p + gap beside it, as in `verify orders`.
double allowance(double gap) { return gap < 0.5 ? 0.15 : 0.1; }

struct Convergences {
  std::vector<Refinement> joint, rest, space, ting;
};

Convergences refine(const std::vector<Row>& rows) {
  Convergences all;
  for (const Row& r : rows) {
    all.joint.push_back(sphere::joint(r.alpha));
    all.rest.push_back(sphere::without_leading_term(all.joint.back()));
    all.space.push_back(sphere::in_space(r.alpha));
    all.ting.push_back(sphere::of_ting(r.alpha));
  }
  return all;
}

/// docs/theory/sphere.md says why each order, and why small α is left out of some.
void add_orders(std::vector<Gate>& gates, const Convergences& all) {
  for (std::size_t i = 0; i < all.joint.size(); ++i) {
    const double a = all.joint[i].alpha;
    gates.push_back(near(fmt::format("{}: order in steps and elements together", at(a)), all.joint[i].observed(), 2 - a,
                         allowance(a)));
    if (a >= 0.25)
      gates.push_back(
          near(fmt::format("{}: order in elements alone", at(a)), all.space[i].observed(), 2 - a, allowance(a)));
    if (a >= 0.5)
      gates.push_back(near(fmt::format("{}: order of what the leading term leaves", at(a)), all.rest[i].observed(), 2,
                           allowance(a)));
    gates.push_back(
        near(fmt::format("{}: order of Ting's formulation in its nodes", at(a)), all.ting[i].observed(), 5, 0.15));
  }
}

console::Table mesh_table(const std::vector<Refinement>& joint, const std::vector<Refinement>& rest) {
  const Notation error{Notation::Kind::scientific, 2}, order{Notation::Kind::fixed, 3};
  console::Table table({{"alpha"},
                        {"steps"},
                        {"e", "", {Notation::Kind::fixed, 8}},
                        {"error", "", error},
                        {"order", "", order},
                        {"error without h^(2-a)", "", error},
                        {"order", "", order}},
                       "By elements, one touched in every step: against Ting's formulation");
  for (std::size_t i = 0; i < joint.size(); ++i)
    for (std::size_t k = 0; k < joint[i].meshes.size(); ++k)
      table.row({joint[i].alpha, std::int64_t{joint[i].meshes[k]}, joint[i].en[k], joint[i].error[k],
                 console::number_or_blank(joint[i].order[k]),
                 k > 0 ? console::Cell(rest[i].error[k - 1]) : console::blank(),
                 k > 0 ? console::number_or_blank(rest[i].order[k - 1]) : console::blank()});
  table.note("steps: up to the turning point, on a mesh graded by 2; stated: 2 - alpha, and 2 for what it leaves");
  return table;
}

console::Table refinement_table(const std::vector<Refinement>& all, const std::string& mesh, const std::string& error,
                                const std::string& caption) {
  console::Table table({{"alpha"},
                        {mesh},
                        {"e", "", {Notation::Kind::fixed, 10}},
                        {error, "", {Notation::Kind::scientific, 2}},
                        {"order", "", {Notation::Kind::fixed, 3}}},
                       caption);
  for (const Refinement& r : all)
    for (std::size_t k = 0; k < r.error.size(); ++k)
      table.row({r.alpha, std::int64_t{r.meshes[k]}, r.en[k], r.error[k], console::number_or_blank(r.order[k])});
  return table;
}

class Sphere : public Study {
 public:
  std::string name() const override { return "sphere"; }
  std::string title() const override { return "A real power-law sphere: physics or a fit?"; }
  std::string claim() const override {
    return "The paper's law, linear in the overlap, has nearly the restitution of a real sphere of a power-law solid: "
           "within 0.15, 0.6, 1.5 % at alpha = 0.0625, 0.25, 0.5, which Hertzian forms of it have not";
  }
  StudyResult run(const RunOptions&) override {
    const std::vector<Row> rows = sphere::rows();
    const Convergences meshes = refine(rows);
    StudyResult result;
    add_values(result.gates, rows);
    add_hertz(result.gates);
    add_orders(result.gates, meshes);
    result.tables = {
        sphere::table(rows), mesh_table(meshes.joint, meshes.rest),
        refinement_table(meshes.space, "elements", "difference to next",
                         "By elements, ever more of them in 512 steps; stated order: 2 - alpha"),
        refinement_table(meshes.ting, "nodes", "error", "Ting's formulation, against 64 nodes; stated order: 5")};
    result.figures = {sphere::figure()};
    const sphere::Worst worst = sphere::worst_of_linear();
    result.figures[0].finding = result.verdict = said(rows, worst);
    return result;
  }

 private:
  static std::string said(const std::vector<Row>& rows, const sphere::Worst& worst) {
    const Row& half = row_of(rows, 0.5);
    return fmt::format(
        "At alpha = 0.5 the sphere keeps {:.4f}; the paper's law is {:+.1f} % off, K D^a z^1.5 {:+.1f} %, K z^0.5 D^a "
        "z "
        "{:+.1f} %. Up to alpha = 0.8 the paper's law is never further off than {:+.1f} % (at {}).",
        half.ting, half.off(half.linear), half.off(half.of_power), half.off(half.of_derivative), worst.percent,
        console::shortest(worst.alpha));
  }
};

}  // namespace

std::unique_ptr<Study> sphere_study() { return std::make_unique<Sphere>(); }

}  // namespace ricochet::verify
