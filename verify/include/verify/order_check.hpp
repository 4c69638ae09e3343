#pragma once

#include <verify/study.hpp>

#include <memory>

namespace ricochet::verify {

/// `verify order FILE.csv --stated P --allowed D`: the orders that a user's own errors or values show, against the
/// stated one. A study of the command line's file, so not one of `verify all`.
std::unique_ptr<Study> order_check();

}  // namespace ricochet::verify
