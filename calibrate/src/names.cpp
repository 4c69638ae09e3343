#include <calibrate/calibration.hpp>

namespace ricochet::calibration {

std::string_view text(ContactEnd end) noexcept { return end == ContactEnd::force ? "force" : "overlap"; }

std::string_view text(Method method) noexcept { return method == Method::nlopt ? "nlopt" : "direct"; }

}  // namespace ricochet::calibration
