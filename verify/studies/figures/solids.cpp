#include "solids.hpp"

#include "../paper.hpp"

#include <console/gnuplot.hpp>
#include <console/law_colour.hpp>
#include <console/number.hpp>
#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/reduction.hpp>

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

namespace ricochet::verify::figures {
namespace {

using console::shortest;
using paper::pair;

const std::string by_speed = "solids-speed.csv", by_degree = "solids-alpha.csv";
constexpr Held held{.alpha = 0.5, .stiffening = 100};
constexpr double made_for = 0.6;  // e_n at the paper's impact

// One list for the header and the curves of both files.
constexpr std::string_view over_speed[] = {Fractional::name, FractionalKelvinVoigt::name, FractionalZener::name,
                                           FractionalHertz::name, KuwabaraKono::name};
constexpr std::string_view over_degree[] = {Fractional::name, FractionalKelvinVoigt::name, FractionalZener::name,
                                            FractionalHertz::name};

template <class Law>
Law made(double en) {
  if constexpr (HoldsDegree<Law>)
    return *Reduction<Law>::in_si(Reduction<Law>::unit(en, ContactEnd::force, held)->law, pair.tcol, pair.impact);
  else
    return *Reduction<Law>::in_si(Reduction<Law>::unit(en, ContactEnd::force)->law, pair.tcol, pair.impact);
}

template <class Law>
double kept(const Law& law, double speed) {
  return collide(law, Impact{.velocity = speed, .mass_eff = pair.impact.mass_eff}).en;
}

template <class... Value>
std::string row(double first, Value... value) {
  std::string text = shortest(first);
  ((text += "," + shortest(value)), ...);
  return text + "\n";
}

template <std::size_t N>
std::string header(std::string first, const std::string_view (&names)[N]) {
  for (const std::string_view name : names) first += fmt::format(",{}", name);
  return first + "\n";
}

std::string speeds() {
  const auto a = made<Fractional>(made_for);
  const auto b = made<FractionalKelvinVoigt>(made_for);
  const auto c = made<FractionalZener>(made_for);
  const auto d = made<FractionalHertz>(made_for);
  const auto e = made<KuwabaraKono>(made_for);
  std::string csv = header("v0 [m/s]", over_speed);
  for (int i = -24; i <= 8; ++i) {  // eighths of a decade
    const double v = std::pow(10, i / 8.0);
    csv += row(v, kept(a, v), kept(b, v), kept(c, v), kept(d, v), kept(e, v));
  }
  return csv;
}

/// With k = m = v₀ = 1: c = 1, and Zener's arm of the same springpot and k₁ = 4.
std::string degrees() {
  constexpr Impact unit{.velocity = 1, .mass_eff = 1};
  std::string csv = header("alpha", over_degree);
  for (int i = 1; i < 50; ++i) {
    const double alpha = i / 50.0;
    csv += row(alpha, collide(Fractional(1, 1, alpha), unit).en, collide(FractionalKelvinVoigt(1, 1, alpha), unit).en,
               collide(FractionalZener(1, 4, std::pow(0.25, 1 / alpha), alpha), unit).en,
               collide(FractionalHertz(1, 1, alpha), unit).en);
  }
  return csv;
}

template <std::size_t N>
std::vector<console::Curve> curves(const std::string& file, const std::string_view (&names)[N]) {
  constexpr int dashes[] = {1, 2, 4, 1, 1};  // the first three lie on one another over the speed
  std::vector<console::Curve> all;
  for (std::size_t i = 0; i < N; ++i)
    all.push_back({.file = file,
                   .what = fmt::format("1:{}", i + 2),
                   .style = fmt::format("lines lw 2.5 dt {} lc rgb '{}'", dashes[i], console::law_colour(names[i])),
                   .title = std::string(names[i])});
  return all;
}

/// d ln(1 − e_n)/d ln v₀ between the paper's speed and half of it.
template <class Law>
double exponent(const Law& law) {
  const double v = pair.impact.velocity;
  return std::log2((1 - kept(law, v)) / (1 - kept(law, 0.5 * v)));
}

}  // namespace

console::Figure solids_figure() {
  const console::Panel speed{.title = "over the speed, all made for one impact",
                             .x = {.label = "v_0 [m/s]", .log = true, .range = std::pair(1e-3, 10.0)},
                             .y = {.label = "e_n", .range = std::pair(0.0, 1.0), .label_offset = "1,0"},
                             .curves = curves(by_speed, over_speed),
                             .key = "bottom left"};
  const console::Panel degree{.title = "over α, at k = c = m = v_0 = 1",
                              .x = {.label = "α", .range = std::pair(0.0, 1.0)},
                              .y = {.label = "e_n", .range = std::pair(0.0, 1.0), .label_offset = "1,0"},
                              .curves = curves(by_degree, over_degree)};
  const double slow = 1e-3;
  return {
      .name = "solids",
      .caption = "Restitution of the laws of real solids over the speed and over the conversion degree.",
      .plot = {.panels = {speed, degree},
               .layout = console::Layout{.rows = 1,
                                         .columns = 2,
                                         .left = 0.08,
                                         .right = 0.98,
                                         .bottom = 0.2,
                                         .top = 0.9,
                                         .between_columns = 0.1}},
      .data = {{by_speed, speeds()}, {by_degree, degrees()}},
      .width = 960,
      .height = 450,
      .finding = fmt::format(
          "Made for e_n = {} at {} m/s, the laws that are linear in the overlap keep that at every speed. At {} m/s "
          "Kuwabara and Kono's law keeps {:.3f}, fractional-hertz with α = {} {:.3f}.",
          made_for, pair.impact.velocity, slow, kept(made<KuwabaraKono>(made_for), slow), held.alpha,
          kept(made<FractionalHertz>(made_for), slow))};
}

std::vector<Gate> solids_gates() {
  // 1 − e = c₁ g − c₂ g² …, g as v₀^{α/5}: at e = 0.999 the second term, of c₁g = 0.001's size, moves the exponent by
  // some thousandths of itself.
  constexpr double elastic = 0.999;
  std::vector<Gate> gates;
  gates.push_back(near("kuwabara-kono: exponent of 1 - e_n in the speed", exponent(made<KuwabaraKono>(elastic)), 0.2,
                       5 * (1 - elastic) * 0.2));
  gates.push_back(near("fractional-hertz, alpha = 0.5: exponent of 1 - e_n in the speed",
                       exponent(made<FractionalHertz>(elastic)), 0.1, 5 * (1 - elastic) * 0.1));
  return gates;
}

}  // namespace ricochet::verify::figures
