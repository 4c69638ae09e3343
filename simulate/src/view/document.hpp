#pragma once

#include "motion.hpp"
#include "walls.hpp"

#include <string>
#include <string_view>

namespace ricochet::simulate {

/// What the page's script reads: "motion-facts" as JSON, long arrays as base64.
struct MotionData {
  std::string elements;                                     ///< HTML
  double place_error = 0, speed_error = 0, spin_error = 0;  ///< of what is kept, at most; places along each axis
};

/// `period` along each axis [m], 0 where space does not repeat.
MotionData motion_data(const ShownMotion& motion, const std::vector<WallOutline>& outlines, Vec3 upward, Vec3 period);

/// Of simulate/page, put together when the program is built.
extern const std::string_view view_style, view_script;

}  // namespace ricochet::simulate
