#pragma once

#include "job.hpp"

#include <optional>
#include <string>

namespace ricochet::calibration {

/// What a rigid sphere on a half-space of the asked tan δ does, a power-law solid, beside what the law found does: the
/// error of taking α from tan δ (docs/theory/sphere.md).
struct RealSphere {
  double en;
  double difference;  ///< of the law's e_n, relative
};

/// None where no tan δ was asked for, the contact ends by overlap, which no real one does, or α is past what
/// `power_law_sphere` takes.
std::optional<RealSphere> real_sphere(const Job& job, const Calibration& found);

/// The same in a sentence.
std::string said(const RealSphere& sphere);

}  // namespace ricochet::calibration
