#pragma once

#include "case.hpp"
#include "conversion_fit.hpp"

#include <console/json.hpp>
#include <console/table.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify::column {

/// One curve of shares; nothing where there is none.
struct ShareCurve {
  std::string id;
  std::vector<std::optional<double>> share;
};

/// Shares of the event-driven column and of every law, over the numbers of beads.
struct Shares {
  std::vector<std::size_t> beads;
  std::vector<ShareCurve> curves;
  const ShareCurve& curve(const std::string& id) const;
  double at(const std::string& id, std::size_t n) const;
};

/// Also of the fractional law with the paper's α, and with the α(nc) of the fit as far as it was fitted.
Shares measure(const std::vector<std::size_t>& beads, const ConversionFit& fit, const ColumnCase& c);

/// The same of a column of `beads` beads over its gaps [m].
std::vector<ShareCurve> over_gaps(std::size_t beads, const std::vector<double>& gaps, ColumnCase c);

console::Table share_table(const std::string& first, const std::string& unit, const std::vector<double>& x,
                           const std::vector<ShareCurve>& curves, const std::string& caption);
console::Table fit_table(const ConversionFit& fit);
console::Json rows(const Shares& shares, const ColumnCase& c);

}  // namespace ricochet::verify::column
