#include "claims.hpp"

#include <console/number.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::column {

namespace {

/// Least or greatest share at the first abscissa, the event-driven column left out.
double extreme(const std::vector<ShareCurve>& curves, bool greatest) {
  double found = *curves[1].share.front();
  for (std::size_t i = 2; i < curves.size(); ++i)
    found = greatest ? std::max(found, *curves[i].share.front()) : std::min(found, *curves[i].share.front());
  return found;
}

/// The part of the event-driven share that a law leaves to the beads, less what the error of a step may add.
double kept_of(const Shares& shares, const std::string& law, std::size_t n) {
  const double error = static_cast<double>(n) * stated_error({});
  return 1 - (shares.at(law, n) + error) / shares.at("event-driven", n);
}

}  // namespace

void claim_gates(std::vector<Gate>& gates, const Shares& shares, const ConversionFit& fit) {
  gates.push_back(near("conversion degree of en = 0.945", conversion_degree(paper::column.en), 0.0293504, 5e-8));
  gates.push_back(near("en of the paper's alpha = 0.0258", fractional_contact(paper::column.alpha).en, 0.951545, 5e-7));
  for (const ColumnLaw& law : column_laws()) {
    double kept = 1;
    for (std::size_t n = 2; n <= 20; ++n) kept = std::min(kept, kept_of(shares, law.id, n));
    gates.push_back(at_least(
        fmt::format("{} detaches: least part of the event-driven share that it keeps, nc = 2 to 20", law.id), kept, 0));
    // Single collisions take more from each bead added; a column that detaches does not (Luding et al. 1994).
    gates.push_back(at_least(fmt::format("{} detaches ever more: that part at nc = 20 over that at nc = 2", law.id),
                             kept_of(shares, law.id, 20) / kept_of(shares, law.id, 2), 1));
  }
  for (const char* id : {"linear1", "linear2"})
    gates.push_back(at_most(fmt::format("{}: more beads lose less, share at nc = 20 over nc = 1", id),
                            shares.at(id, 20) / shares.at(id, 1), 1));
  gates.push_back(
      at_most("fractional alpha(nc) follows the event-driven column, greatest error of the share", fit.worst, 0.01));
}

std::string verdict(const Shares& shares, const ConversionFit& fit) {
  constexpr std::size_t last = paper::column.most;
  double least = 1, most = 0, apart = 0;
  for (const ColumnLaw& law : column_laws()) {
    least = std::min(least, shares.at(law.id, last));
    most = std::max(most, shares.at(law.id, last));
  }
  for (std::size_t n = 1; n <= last; ++n)
    apart = std::max(apart, std::abs(shares.at("fractional alpha=0.0258", n) - shares.at("hysteretic", n)));
  return fmt::format(
      "20 beads lose {:.3f} of their energy in single collisions, but {:.3f} to {:.3f} under laws with constant "
      "parameters: each detaches. With alpha(nc), s = (1 + {:.4f} (nc - 1))^{:.4f}, the fractional law follows the "
      "event-driven shares to {:.4f}. Constant alpha = 0.0258 stays within {:.3f} of the hysteretic law.",
      shares.at("event-driven", last), least, most, fit.law.a, fit.law.b, fit.worst, apart);
}

std::string share_finding(const Shares& shares) {
  const auto text = [&](const std::string& id) {
    const auto& share = shares.curve(id).share.back();
    return share ? fmt::format("{:.2f}", *share) : "an unknown share";
  };
  return fmt::format(
      "With {} beads single collisions (event-driven) would take {} of the energy, the hysteretic law takes {}, "
      "the linear one ended by overlap {}, the fractional law with constant α {}; with α(nc) it takes {}.",
      shares.beads.back(), text("event-driven"), text("hysteretic"), text("linear1"), text("fractional"),
      text("fractional alpha(nc)"));
}

/// The widest and the narrowest gap, in words; the first abscissa is the narrowest.
std::string gap_finding(const std::vector<ShareCurve>& curves) {
  const auto hard = curves[0].share.back();
  return fmt::format(
      "At the widest gap every law takes what single collisions take{}; at the narrowest they take between {:.2f} and "
      "{:.2f}.",
      hard ? fmt::format(", {:.2f}", *hard) : "", extreme(curves, false), extreme(curves, true));
}

std::vector<Remark> remarks(const ConversionFit& fit) {
  return {{"Fig. 6, α for e_n = 0.945", fmt::format("Printed as 0.0258. That α restores {}; e_n = 0.945 needs α = {}.",
                                                    console::significant(fractional_contact(paper::column.alpha).en, 6),
                                                    console::significant(conversion_degree(paper::column.en), 6))},
          {"Fig. 6, α(n_c)",
           fmt::format("Printed as \"1+exp(−n_c)\", which exceeds 1. Read as 1 − (1 − α_1)^s with s = (1 + {:.4f} (n_c "
                       "− 1))^{:.4f} it follows the event-driven column to {:.4f}.",
                       fit.law.a, fit.law.b, fit.worst)}};
}

}  // namespace ricochet::verify::column
