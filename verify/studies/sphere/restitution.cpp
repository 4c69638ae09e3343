#include "restitution.hpp"

#include <console/gnuplot.hpp>
#include <console/law_colour.hpp>
#include <console/number.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/power_law_sphere.hpp>
#include <ricochet/collision/solvers/hertzian_forms.hpp>
#include <ricochet/collision/solvers/sphere_elements.hpp>
#include <ricochet/contact/laws.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace ricochet::verify::sphere {
namespace {

using console::Notation;

Row laws_at(double alpha) {
  return {.alpha = alpha,
          .ting = power_law_sphere(alpha).en,
          .elements = 0,
          .doubt = 0,
          .linear = fractional_contact(alpha).en,
          .of_power = hertzian_rebound(HertzianForm::derivative_of_power, alpha).en,
          .of_derivative = hertzian_rebound(HertzianForm::power_of_derivative, alpha).en};
}

double loss_factor(double alpha) { return std::tan(0.5 * std::numbers::pi * alpha); }

constexpr int first_drawn = 2, last_drawn = 32;  // in fortieths

std::string curves() {
  std::string csv =
      "alpha,sphere,linear,derivative of power,power of derivative,linear [%],derivative of power [%],"
      "power of derivative [%]\n";
  for (int i = first_drawn; i <= last_drawn; ++i) {
    const Row r = laws_at(i / 40.0);
    csv += fmt::format("{},{},{},{},{},{},{},{}\n", r.alpha, r.ting, r.linear, r.of_power, r.of_derivative,
                       r.off(r.linear), r.off(r.of_power), r.off(r.of_derivative));
  }
  return csv;
}

}  // namespace

std::vector<Row> rows() {
  std::vector<Row> all;
  for (const double alpha : {0.0625, 0.125, 0.25, 0.5, 0.75}) {
    Row row = laws_at(alpha);
    const ElementsLimit elements = limit_by_elements(alpha);
    row.elements = elements.limit.back();
    row.doubt = elements.doubt;
    all.push_back(row);
  }
  return all;
}

console::Table table(const std::vector<Row>& rows) {
  const Notation seven{Notation::Kind::fixed, 7}, percent{Notation::Kind::fixed, 2};
  console::Table table({{"alpha"},
                        {"tan delta", "", {Notation::Kind::significant, 4}},
                        {"sphere", "", {Notation::Kind::fixed, 8}},
                        {"by elements", "", seven},
                        {"linear law", "", seven},
                        {"off", "%", percent},
                        {"K D^a z^1.5", "", seven},
                        {"off", "%", percent},
                        {"K z^0.5 D^a z", "", seven},
                        {"off", "%", percent}},
                       "Restitution of a rigid sphere on a power-law half-space, and of the laws that stand for it");
  for (const Row& r : rows)
    table.row({r.alpha, loss_factor(r.alpha), r.ting, r.elements, r.linear, r.off(r.linear), r.of_power,
               r.off(r.of_power), r.of_derivative, r.off(r.of_derivative)});
  table.note("sphere: Ting's formulation; by elements: the same contact told element by element, extrapolated");
  table.note("linear law: the paper's (30) at the same alpha, k and c of any size; z: the overlap");
  return table;
}

Worst worst_of_linear() {
  Worst worst{0, 0};
  for (int i = first_drawn; i <= last_drawn; ++i) {
    const double alpha = i / 40.0, off = 100 * (fractional_contact(alpha).en / power_law_sphere(alpha).en - 1);
    if (std::abs(off) > std::abs(worst.percent)) worst = {alpha, off};
  }
  return worst;
}

console::Figure figure() {
  const char* const sphere = console::palette::gray;
  const char* const linear = console::law_colour(Fractional::name);
  const char* const power = console::law_colour(FractionalHertz::name);  // k = 0 of it
  const char* const derivative = console::law_colour(KuwabaraKono::name);
  const auto line = [](int column, const char* colour, const char* title) {
    return console::Curve{.file = "sphere.csv",
                          .what = fmt::format("1:{}", column),
                          .style = fmt::format("lines lw 2.5 lc rgb '{}'", colour),
                          .title = title};
  };
  const console::Panel left{.title = "restitution",
                            .x = {.label = "α", .range = std::pair(0.0, 0.8)},
                            .y = {.label = "e_n", .range = std::pair(0.0, 1.0)},
                            .curves = {line(2, sphere, "sphere"), line(3, linear, "the paper's law, D^α ζ"),
                                       line(4, power, "D^α ζ^{3/2}"), line(5, derivative, "ζ^{1/2} D^α ζ")},
                            .key = "bottom left"};
  const console::Panel right{.title = "what each law is off",
                             .x = {.label = "α", .range = std::pair(0.0, 0.8)},
                             .y = {.label = "%", .range = std::pair(-15.0, 30.0)},
                             .curves = {line(6, linear, ""), line(7, power, ""), line(8, derivative, "")},
                             .zero_line = true};
  return {.name = "sphere",
          .caption = "Restitution of a power-law sphere over alpha, and of three laws that stand for it.",
          .plot = {.panels = {left, right},
                   .layout = console::Layout{.rows = 1,
                                             .columns = 2,
                                             .left = 0.08,
                                             .right = 0.98,
                                             .bottom = 0.14,
                                             .top = 0.9,
                                             .between_columns = 0.1}},
          .data = {{"sphere.csv", curves()}},
          .width = 960,
          .height = 450};
}

}  // namespace ricochet::verify::sphere
