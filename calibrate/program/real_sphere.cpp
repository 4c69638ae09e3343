#include "real_sphere.hpp"

#include <console/number.hpp>
#include <ricochet/collision/power_law_sphere.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace ricochet::calibration {

std::optional<RealSphere> real_sphere(const Job& job, const Calibration& found) {
  const auto* factor = std::get_if<loss::LossFactor>(&job.known.loss);
  if (job.given || !factor || found.end != ContactEnd::force) return std::nullopt;
  const double alpha = 2 / std::numbers::pi * std::atan(factor->tan_delta);
  constexpr double greatest = 0.8;
  if (alpha > greatest) return std::nullopt;
  const double en = power_law_sphere(alpha).en;
  return RealSphere{en, found.achieved.en / en - 1};
}

std::string said(const RealSphere& sphere) {
  return fmt::format("at that tan delta a rigid sphere on a half-space keeps en = {}, this law {:+.2f} %",
                     console::significant(sphere.en, 6), 100 * sphere.difference);
}

}  // namespace ricochet::calibration
