// The paper's sgn (61) beside the rigid law that stands in its place.
#include "sign.hpp"

#include <ricochet/contact/friction.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace ricochet::verify::cluster {
namespace {

using console::Notation;
using console::Table;

constexpr double mass = 0.01, radius = 0.01;  // kg, m; neither enters what is shown
constexpr double mu = 0.5, gravity = 9.81, slope = std::numbers::pi / 18;
constexpr double slip_at_start = 0.5, duration = 0.1;              // m/s, s
constexpr double shares[] = {1e-1, 1e-2, 1e-3, 1e-4};              // ε₂ over the slip at the start
constexpr double inertia = 0.4 * mass * radius * radius;           // of a homogeneous sphere
constexpr double mobility = 1 / mass + radius * radius / inertia;  // 7/(2m)

double drive() { return gravity * std::sin(slope); }                        // of the slip [m/s²]
double most() { return mobility * mu * mass * gravity * std::cos(slope); }  // that friction can do against it

/// (61): 0 up to ε₁, linear from there, ±1 from ε₂.
double regularised(double x, double eps1, double eps2) {
  const double size = std::fabs(x);
  if (size <= eps1) return 0;
  return std::copysign(size >= eps2 ? 1.0 : (size - eps1) / (eps2 - eps1), x);
}

/// u' = g sin θ − (7/2) μ g cos θ sgn(u), by Runge's and Kutta's method of order 4 in a quarter of the time in which
/// the linear part of (61) decays.
SignCase with_sign(double eps2) {
  const double eps1 = 0.1 * eps2, decay = (eps2 - eps1) / most();
  const auto steps = static_cast<std::size_t>(std::ceil(duration / (0.25 * decay)));
  const double h = duration / static_cast<double>(steps);
  const auto slope_at = [&](double u) { return drive() - most() * regularised(u, eps1, eps2); };
  double u = slip_at_start;
  for (std::size_t n = 0; n < steps; ++n) {
    const double a = slope_at(u), b = slope_at(u + 0.5 * h * a), c = slope_at(u + 0.5 * h * b), d = slope_at(u + h * c);
    u += h / 6 * (a + 2 * b + 2 * c + d);
  }
  // The slip at which (61) bears the share of the limit that sticking needs.
  const double stated = eps1 + drive() / most() * (eps2 - eps1);
  return {eps2, u, stated, u, 2 * decay};
}

/// The law as Cluster has it, in twenty steps.
SignCase rigid() {
  constexpr int steps = 20;
  const double h = duration / steps;
  const Friction friction(mu, mu, 0, 0);
  FrictionProblem p;
  p.normal_impulse = mass * gravity * std::cos(slope) * h;
  p.mobility = {mobility, radius / inertia, 1 / inertia};
  Vec3 u{slip_at_start, 0, 0};
  for (int n = 0; n < steps; ++n) {
    p.before.slip = u;
    p.free.slip = u + Vec3{h * drive(), 0, 0};
    u = p.free.slip + mobility * friction_impulse(friction, p, {}).impulse.sliding;
  }
  return {0, u.x, 0, u.x, h};
}

}  // namespace

std::vector<SignCase> sign_cases() {
  std::vector<SignCase> cases{rigid()};
  for (const double share : shares) cases.push_back(with_sign(share * slip_at_start));
  return cases;
}

Table sign_table(const std::vector<SignCase>& cases) {
  const Notation three{Notation::Kind::significant, 3};
  Table table({{"law"},
               {"eps2 / u0", "", three},
               {"slip left / u0", "", three},
               {"stated", "", three},
               {"slips in a second", "mm", three},
               {"longest explicit step", "s", three}},
              "The paper's sgn (61) beside the rigid law: a sphere slides down a slope on which it can roll");
  for (const SignCase& c : cases)
    table.row({c.eps2 > 0 ? "(61)" : "rigid", c.eps2 / slip_at_start, c.slip_left / slip_at_start,
               c.stated / slip_at_start, 1e3 * c.creep, c.step});
  table.note(
      fmt::format("Slip u0 = {} m/s at the start, slope 10°, mu = {}, eps1 = eps2/10. A contact that should hold "
                  "creeps at eps1 + (load/limit)(eps2 - eps1): the less, the shorter the steps must be.",
                  slip_at_start, mu));
  table.note("rigid: the step is the one taken, 20 for the whole slide; it needs no shorter ones.");
  return table;
}

std::vector<Gate> sign_gates(const std::vector<SignCase>& cases) {
  std::vector<Gate> gates;
  double off = 0;
  for (const SignCase& c : cases)
    if (c.eps2 > 0) off = std::fmax(off, std::fabs(c.slip_left / c.stated - 1));
  // Sticking ends the slip to rounding; the linear part of (61) has decayed by exp(−20) at least when the run ends.
  gates.push_back(at_most("rigid friction: slip left, of the slip at the start",
                          std::fabs(cases.front().slip_left) / slip_at_start, 1e-15));
  gates.push_back(at_most("(61): slip left from the stated creep, greatest relative difference", off, 1e-6));
  const SignCase &coarse = cases[1], &fine = cases.back();
  gates.push_back(between("(61): order in eps of its distance from the rigid law",
                          std::log(coarse.slip_left / fine.slip_left) / std::log(coarse.eps2 / fine.eps2), 0.999,
                          1.001));
  return gates;
}

}  // namespace ricochet::verify::cluster
