#include "pade.hpp"

#include <ricochet/collision/peer_damping.hpp>
#include <ricochet/collision/collision.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify::peers {

namespace {

using console::Notation;

/// e of the law at k = m = v = 1, where c = u².
double exact(double u) { return collide(KuwabaraKono(1, u * u), {1, 1}, {.method = CollideMethod::numerical}).en; }

constexpr double shown[] = {0.1, 0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.5, 2, 3};

double worst_error() {
  double worst = 0;
  for (int i = 1; i <= 80; ++i)
    worst = std::max(worst, std::abs(mueller_poeschel_restitution(i / 20.0) - exact(i / 20.0)));
  return worst;
}

/// lim (1 − e)/u² as u → 0. With 1 − e = C₁u² − 0.798u⁴ − 0.267u⁵ + … (Schwager & Pöschel, Phys. Rev. E 78, 051304
/// (2008)) two values give it to O(u³).
double first_coefficient() {
  const auto slope = [](double u) { return (1 - exact(u)) / (u * u); };
  return (4 * slope(0.008) - slope(0.016)) / 3;
}

}  // namespace

console::Table pade_table() {
  const Notation five{Notation::Kind::fixed, 5};
  console::Table table({{"u", "", {Notation::Kind::fixed, 1}},
                        {"en by the form", "", five},
                        {"en of the collision", "", five},
                        {"form - collision", "", {Notation::Kind::scientific, 1}},
                        {"relative", "", {Notation::Kind::scientific, 1}}},
                       "Kuwabara and Kono's restitution by the Padé form of Müller and Pöschel (2011)");
  for (const double u : shown) {
    const double form = mueller_poeschel_restitution(u), collision = exact(u);
    table.row({u, form, collision, form - collision, form / collision - 1});
  }
  table.note("u^2 = c k^(-3/5) m^(-2/5) v^(1/5)");
  return table;
}

std::vector<console::Json> pade_rows() {
  std::vector<console::Json> rows;
  for (const double u : shown) {
    const double form = mueller_poeschel_restitution(u), collision = exact(u);
    rows.push_back({{"peer", "mueller-poeschel 2011"},
                    {"law", "kuwabara-kono"},
                    {"end", "force"},
                    {"en_asked", form},
                    {"en_obtained", collision},
                    {"error", collision - form}});
  }
  return rows;
}

std::vector<Gate> pade_gates() {
  using std::numbers::pi;
  // C₁ = Γ(3/5) √π/(2^{1/5} 5^{2/5} Γ(21/10)) where c = u²: Ramírez, Pöschel, Brilliantov, Schwager, Phys. Rev.
  // E 60, 4465 (1999). The extrapolation leaves (4/3) 0.267u³ = 2e-7 and the collision's own 1e-11/u² = 2e-7.
  const double c1 = std::tgamma(0.6) * std::sqrt(pi) / (std::pow(2, 0.2) * std::pow(5, 0.4) * std::tgamma(2.1));
  return {at_most("kuwabara-kono: (1 - en)/u^2 for u -> 0 against its closed form, relative",
                  std::abs(first_coefficient() / c1 - 1), 1e-6),
          at_most("Padé form: d2 against that closed form, to its printed digits", std::abs(1.15345 - c1), 5e-6),
          at_most("Padé form against the collision, u up to 4", worst_error(), 0.01)};
}

}  // namespace ricochet::verify::peers
