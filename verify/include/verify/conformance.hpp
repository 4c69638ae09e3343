#pragma once

#include <verify/study.hpp>

#include <memory>

namespace ricochet::verify {

/// `verify conformance`: engine-neutral cases of contact models with exact answers, and the grades of what engines gave
/// (docs/conformance.md). A study of files, so not one of `verify all`.
std::unique_ptr<Study> conformance_check();

}  // namespace ricochet::verify
