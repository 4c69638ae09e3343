#pragma once

#include "shares.hpp"

#include <verify/study.hpp>

#include <string>
#include <vector>

namespace ricochet::verify::column {

/// Claims of the paper and of Luding et al. (1994), for the case of Fig. 6.
void claim_gates(std::vector<Gate>& gates, const Shares& shares, const ConversionFit& fit);

std::string verdict(const Shares& shares, const ConversionFit& fit);
std::string share_finding(const Shares& shares);                 ///< what one sees in the figure over nc
std::string gap_finding(const std::vector<ShareCurve>& curves);  ///< what one sees in the figure over the gap
std::vector<Remark> remarks(const ConversionFit& fit);

}  // namespace ricochet::verify::column
