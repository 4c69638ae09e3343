#include <calibrate/flights.hpp>

#include <ricochet/support/require.hpp>

#include <cmath>

namespace ricochet::calibration {
namespace {

/// The first of N flights over their mean.
double first_over_mean(double en, double count) {
  return en == 1 ? 1 : count * (1 - en) / -std::expm1(count * std::log(en));
}

}  // namespace

Bounce bounce_between(const Flights& before, const Flights& after) {
  using support::require;
  for (const Flights& f : {before, after}) {
    support::require_positive("length of flights", f.length);
    support::require_positive("count of flights", f.count);
  }
  const double n = before.count, gap = after.start - before.start;
  require(after.count == n, "count of flights", after.count, "that of the flights before");
  require(gap > 0 && std::isfinite(gap), "start of flights", after.start, "later than that before");
  require(after.mean() <= before.mean(), "mean flight", after.mean(), "at most that before");
  const double kept = 1 - (before.length - after.length) / gap;  // e_n^N
  require(kept > 0, "end of flights", after.start + after.length, "later than that before");
  const double en = std::pow(kept, 1 / n), first = first_over_mean(en, n);
  return {.velocity = standard_gravity / 4 * first * (before.mean() + after.mean() / en),
          .en = en,
          .en_sigma = before.sigma / gap * std::sqrt(2 + 2 * kept * kept) * en / (n * kept)};
}

}  // namespace ricochet::calibration
