#pragma once

#include "convergence.hpp"

#include <console/table.hpp>

#include <string>
#include <vector>

namespace ricochet::verify {

/// One row a mesh: scheme, function, alpha, n, dt, error, pairwise_order, stated_order (none where the scheme is
/// exact), pass (of the whole case). dt in the study's unit of time; none where n counts no steps of one length.
console::Table long_table(const std::vector<Convergence>& all);

/// One row a scheme: what is stated, what was observed, and the case that comes nearest to failing.
console::Table summary_table(const std::vector<Convergence>& all, const std::string& caption);

/// One compact table a scheme: rows function and N, for every α the error and the pairwise order, then the stated order
/// and the observed one.
std::vector<console::Table> scheme_tables(const std::vector<Convergence>& all);

/// The cases of each scheme, in the order of appearance.
std::vector<std::vector<Convergence>> by_scheme(const std::vector<Convergence>& all);

}  // namespace ricochet::verify
