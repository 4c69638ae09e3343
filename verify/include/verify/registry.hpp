#pragma once

#include <verify/study.hpp>

#include <memory>
#include <vector>

namespace ricochet::verify {

using Studies = std::vector<std::unique_ptr<Study>>;

/// Every study of verify/studies.inc, in that order.
Studies all_studies();

}  // namespace ricochet::verify
