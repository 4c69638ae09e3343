#include "curves.hpp"

#include <console/gnuplot.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::peers {

namespace {

// So that a contact of a millimetre-sized grain lasts about 0.1 ms.
constexpr double linear_stiffness = 5000, hertz_stiffness = 1.4e6;

/// Integrates the contact that `peer` makes of the restitution asked, without any closed form.
double obtained_restitution(const PeerDamping& peer, double asked) {
  const double beta = peer.damping_ratio(asked);
  const CollideOptions options{.end = peer.end, .method = CollideMethod::numerical};
  const double m = impact.mass_eff;
  if (peer.law == PeerLaw::linear)
    return collide(Linear(linear_stiffness, 2 * beta * std::sqrt(m * linear_stiffness)), impact, options).en;
  return collide(Tsuji(hertz_stiffness, beta * std::sqrt(5 * m * hertz_stiffness)), impact, options).en;
}

}  // namespace

std::vector<double> asked_restitutions() {
  std::vector<double> asked;
  for (int percent = 5; percent <= 99; ++percent) asked.push_back(percent / 100.0);
  return asked;
}

Curve measure(const PeerDamping& peer, const std::vector<double>& asked) {
  Curve curve{.peer = peer};
  for (const double en : asked) {
    const double obtained = obtained_restitution(peer, en);
    curve.obtained.push_back(obtained);
    if (std::abs(obtained - en) > curve.worst) {
      curve.worst = std::abs(obtained - en);
      curve.worst_at = en;
    }
    curve.worst_relative = std::max(curve.worst_relative, std::abs(obtained / en - 1));
    const double closed = restitution_of_damping(peer.damping_ratio(en), peer.end);
    curve.closed_form = std::max(curve.closed_form, std::abs(obtained / closed - 1));
  }
  return curve;
}

const Curve& find(const std::vector<Curve>& curves, std::string_view id) {
  return *std::find_if(curves.begin(), curves.end(), [id](const Curve& curve) { return curve.peer.id == id; });
}

console::Figure error_figure(const std::vector<Curve>& curves, const std::vector<double>& asked) {
  struct Drawn {
    const char* id;
    const char* title;
  };
  constexpr Drawn drawn[] = {
      {"lammps tsuji 2021", "LAMMPS tsuji, 29 Sep 2021 (pair mass)"},
      {"liggghts hertz, limited", "logarithmic form, force clipped (LIGGGHTS limitForce, Yade tc-en, ...)"},
      {"mfix hertz 21", "MFiX up to 21.3.2, Hertz (factor 2)"},
      {"lammps tsuji 2026", "LAMMPS tsuji, 2026 (particle mass)"},
      {"yade mindlin 2023", "Yade 2023, Kratos (polynomial of Thornton et al.)"},
      {"liggghts hertz", "logarithmic form, ended by overlap"}};
  std::string csv = "en_asked";
  for (const Drawn& d : drawn) csv += fmt::format(",\"{}\"", d.id);
  csv += "\n";
  for (std::size_t i = 0; i < asked.size(); ++i) {
    csv += console::shortest(asked[i]);
    for (const Drawn& d : drawn) csv += fmt::format(",{}", console::shortest(find(curves, d.id).obtained[i]));
    csv += "\n";
  }
  console::Panel panel{.x = {.label = "restitution asked", .range = std::pair(0.0, 1.0)},
                       .y = {.label = "restitution obtained - asked", .range = std::pair(-0.02, 0.2)},
                       .zero_line = true};
  for (const Drawn& d : drawn) {
    const auto line = panel.curves.size() + 1;
    panel.curves.push_back({.file = "peers-error.csv",
                            .what = fmt::format("1:(${}-$1)", line + 1),
                            .style = fmt::format("lines lt {} lw 2", line),
                            .title = d.title});
  }
  return {.name = "peers-error",
          .caption = "Restitution obtained less restitution asked, for the formulas that engines use.",
          .plot = console::with_key_below(panel, 6, 0.36),
          .data = {{"peers-error.csv", csv}},
          .width = 900,
          .height = 560};
}

}  // namespace ricochet::verify::peers
