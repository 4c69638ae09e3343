#include "oblique_check.hpp"

#include <ricochet/support/require.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <variant>

namespace ricochet::calibration {
namespace {

using support::require;

/// Of the centre of a sphere without spin before, 3/7 ≤ e_t ≤ 1: with its spin after, ω r = (5/2) (1 − e_t) v_t, the
/// tangential part has no more energy than before, e_t² + (5/2) (1 − e_t)² ≤ 1.
constexpr double least_et = 3.0 / 7;
/// What a measurement may be off beyond, or three of its standard errors, as a share of what is greatest.
constexpr double noise = 0.05;

/// e_t, rebound angle and spin of one impact tell the same; beside a law that is not linear another speed does tell
/// more.
bool alike(const ObliqueFitRequest& request, const ObliqueMeasurement& a, const ObliqueMeasurement& b) {
  const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-6 * std::abs(y); };
  const bool linear = std::holds_alternative<Linear>(request.normal);
  return near(a.tangential_velocity * b.normal_velocity, b.tangential_velocity * a.normal_velocity) &&
         (linear || near(a.normal_velocity, b.normal_velocity));
}

void require_spread(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data) {
  if (std::all_of(data.begin(), data.end(), [&](const auto& m) { return alike(request, m, data.front()); }))
    throw std::invalid_argument(
        "angles = 1: must be two different ones at least for two unknowns: et, rebound_angle and spin of one impact "
        "tell the same");
}

}  // namespace

std::optional<std::string> impossible(const ObliqueFitRequest& request, const ObliqueMeasurement& m) {
  const auto outside = [](const std::optional<Observed>& o, double low, double high, double unit) {
    const double slack = o ? std::max(noise * unit, 3 * o->sigma) : 0;
    return o && !(o->value >= low - slack && o->value <= high + slack);
  };
  if (outside(m.et, least_et, 1, 1))
    return fmt::format("et = {}: must be in [3/7, 1], as energy has it for a sphere without spin before",
                       support::shortest(m.et->value));
  if (outside(m.rebound_angle, 0, std::numbers::pi / 2, 1))
    return fmt::format("rebound_angle = {}: must be in [0, 90), in degrees",
                       support::significant(m.rebound_angle->value * 180 / std::numbers::pi, 15));
  const double greatest =
      request.radius > 0 ? request.spin_share * 2.5 * (1 - least_et) * m.tangential_velocity / request.radius : 0;
  // With the other sign convention every spin is negative, however small: there the stated error alone is noise.
  const bool backwards = m.spin && m.spin->value < -3 * m.spin->sigma;
  if (backwards || (request.radius > 0 && outside(m.spin, 0, greatest, greatest)))
    return fmt::format(
        "spin = {}: must be in [0, {}], forwards as the sphere goes, as energy has it without spin before",
        support::shortest(m.spin->value), support::significant(greatest, 4));
  return std::nullopt;
}

void require_oblique(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data) {
  if (request.form == TangentialForm::mindlin)
    throw std::invalid_argument("tangential = mindlin: must be linear or linear-undamped");
  support::require_positive("tcol", request.tcol);
  support::require_positive("mass_eff", request.mass_eff);
  std::optional<bool> known;
  std::size_t observations = 0;
  for (const ObliqueMeasurement& m : data) {
    support::require_positive("normal_velocity", m.normal_velocity);
    support::require_positive("tangential_velocity", m.tangential_velocity);
    for (const auto& o : {m.et, m.rebound_angle, m.spin}) {
      if (!o) continue;
      ++observations;
      require(o->sigma >= 0, "sigma", o->sigma, ">= 0");
      require(known.value_or(o->sigma > 0) == (o->sigma > 0), "sigma", o->sigma, "> 0 for every number or for none");
      known = o->sigma > 0;
    }
    if (m.spin) require(request.radius > 0, "radius", request.radius, "> 0 where spins were measured");
    if (const auto why = impossible(request, m))
      throw std::invalid_argument(m.line > 0 ? fmt::format("line {}: {}", m.line, *why) : *why);
  }
  require(observations > 2, "observations", static_cast<double>(observations), "more than the unknowns, 2");
  require_spread(request, data);
}

}  // namespace ricochet::calibration
