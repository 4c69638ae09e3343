#pragma once

#include <verify/study.hpp>

namespace ricochet::verify {

/// Arms that a memory kernel needs, over α, tolerance and T/δ, with its gates; `thorough` adds the long memories.
void add_kernel_counts(StudyResult& result, bool thorough);

}  // namespace ricochet::verify
