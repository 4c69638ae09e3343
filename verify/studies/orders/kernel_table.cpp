#include "kernel_table.hpp"

#include <console/number.hpp>
#include <ricochet/fractional/memory_kernel.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::verify {

namespace {

using console::Notation;

constexpr double counted_orders[] = {0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99};

/// Bounds on the arms at T/δ = 100. Below 1e-6 nine do not suffice for any method above α = 0.78; see
/// docs/theory/memory_kernel.md.
constexpr std::size_t most_arms_fine = 16, most_arms_coarse = 10;

}  // namespace

void add_kernel_counts(StudyResult& result, bool thorough) {
  std::vector<console::Column> columns{{"tolerance", "", {Notation::Kind::scientific, 0}}, {"T/delta"}};
  for (const double alpha : counted_orders) columns.push_back({fmt::format("alpha {}", alpha)});
  columns.push_back({"worst error", "", {Notation::Kind::scientific, 1}});
  console::Table table(columns, "Maxwell arms of the memory kernel; spring and dashpot are not counted");
  std::vector<double> ratios{10, 30, 100, 1000};
  if (thorough) ratios.insert(ratios.end(), {1e4, 1e6});
  double worst = 0;
  std::size_t fine = 0, coarse = 0;
  for (const double tolerance : {1e-6, 1e-10})
    for (const double ratio : ratios) {
      std::vector<console::Cell> cells{tolerance, ratio};
      double error = 0;
      for (const double alpha : counted_orders) {
        const MemoryKernel kernel = memory_kernel(alpha, 1, ratio, tolerance);
        const std::size_t arms = kernel.arms().size();
        cells.push_back(static_cast<std::int64_t>(arms));
        error = std::max(error, kernel.error());
        if (ratio == 100) {
          std::size_t& most = tolerance == 1e-6 ? coarse : fine;
          most = std::max(most, arms);
        }
      }
      cells.push_back(error);
      table.row(std::move(cells));
      worst = std::max(worst, error / tolerance);
    }
  result.tables.push_back(std::move(table));
  result.gates.push_back(at_most("memory kernel: worst error / tolerance", worst, 1));
  result.gates.push_back(at_most("memory kernel: most arms for 1e-10 at T/delta = 100", static_cast<double>(fine),
                                 static_cast<double>(most_arms_fine)));
  result.gates.push_back(at_most("memory kernel: most arms for 1e-6 at T/delta = 100", static_cast<double>(coarse),
                                 static_cast<double>(most_arms_coarse)));
}

}  // namespace ricochet::verify
