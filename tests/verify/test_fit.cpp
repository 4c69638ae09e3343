// What `verify fit` judges by: its bounds, and what it makes of data whose answer is known.
#include "../../verify/studies/fit/chance.hpp"
#include "../../verify/studies/fit/coverage.hpp"
#include "../../verify/studies/fit/foretold.hpp"

#include <calibrate/flights.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

using namespace ricochet;
using namespace ricochet::verify;
using calibration::Fit;
using calibration::Measurement;

TEST_CASE("plausible shares are the binomial's quantiles, and leave room on either side") {
  // Of one trial nothing is told; of 300 at 0.95, P(all) = 0.95^300 = 2e-7 and P(298 or more) = 2.8e-5 are too little,
  // P(297 or more) is not.
  CHECK(plausible_shares(0.5, 1) == std::pair(0.0, 1.0));
  const auto [least, greatest] = plausible_shares(0.95, 300);
  double above = 0;
  for (int k = 300; k >= 0; --k) {
    above += std::exp(std::lgamma(301) - std::lgamma(k + 1) - std::lgamma(301 - k) + k * std::log(0.95) +
                      (300 - k) * std::log(0.05));
    if (above < by_chance) continue;
    CHECK(greatest == Approx(k / 300.0));
    break;
  }
  CHECK(greatest < 1);
  CHECK(least == Approx(268 / 300.0));  // four standard deviations, 15.1, below 285, and a skew distribution's rest
}

TEST_CASE("95 % intervals hold the truth in 95 % of trials, not in all of them") {
  const auto [least, greatest] = plausible_shares(0.95, 300);
  for (const CoverageCase& one : coverage_cases()) {
    if (one.request.law != kind_of<Linear> && one.request.law != kind_of<Hysteretic>) continue;
    for (const Coverage& c : coverage_of(one, 300)) {
      CAPTURE(c.parameter);
      CHECK(c.share >= least);
      CHECK(c.share <= greatest);
    }
  }
}

TEST_CASE("Chow's F is the textbook's where the fit is a mean") {
  const std::vector<Measurement> part{{0.1, 0.7}, {0.2, 0.72}, {0.3, 0.74}};
  std::vector<Measurement> all = part;
  all.insert(all.end(), {{0.4, 0.8}, {0.5, 0.8}});
  const auto fitted = [&](const std::vector<Measurement>& data) {
    return fit_law({kind_of<Linear>, ContactEnd::force, 1e-5}, data);
  };
  // Sums of squares about 0.72 and 0.752: 0.0008, of 2 degrees of freedom, and 0.00848.
  CHECK(chow(fitted(all), fitted(part)) == Approx((0.00848 - 0.0008) / 2 / (0.0008 / 2)).epsilon(1e-6));
  // F of (1, 2) is t² of 2 degrees of freedom, whose two-sided 0.1 % point is 31.599.
  CHECK(plausible_f(1, 2).second == Approx(31.599 * 31.599).epsilon(1e-4));
}

TEST_CASE("thirds are those of the speed, and nothing is left out twice") {
  const std::vector<Measurement> data{{3, 0.3}, {1, 0.1}, {2, 0.2}, {5, 0.5}, {4, 0.4}, {6, 0.6}, {7, 0.7}};
  const auto both = thirds(data);
  REQUIRE(both[0].rest.size() == 2);
  CHECK(both[0].rest[1].velocity == 2);
  CHECK(both[0].kept.front().velocity == 3);
  CHECK(both[1].rest[0].velocity == 6);
  CHECK(both[1].kept.back().velocity == 5);
  CHECK(both[1].kept.size() == 5);
}

TEST_CASE("a law foretells what it made, where another one misses") {
  std::vector<Measurement> data;
  for (int i = 0; i < 9; ++i) {
    const double v = 0.02 * std::pow(100.0, i / 8.0);
    data.push_back({v, collide(KuwabaraKono(1.4e6, 30), {v, 7.06858e-6}).en});
  }
  const Foretold told = foretell(thirds(data)[1]);
  CHECK(fit_name(told.fits[told.preferred()].request) == "kuwabara-kono");
  CHECK(told.miss[told.preferred()] < 1e-6);
  CHECK(told.miss[0] > 0.05);
  CHECK(told.nearest() == told.preferred());
}

TEST_CASE("the sources are read whole, the ball's by its flights") {
  REQUIRE(sources().size() == 4);
  CHECK(read(sources()[0]).size() == 12);
  CHECK(read(sources()[0])[0].en == 0.79983);
  const auto ball = read(sources()[3]);
  REQUIRE(ball.size() == 8);
  const auto first = calibration::bounce_between({0.134, 2.501, 10}, {4.969, 2.177, 10});
  CHECK(ball[0].en == Approx(first.en).epsilon(1e-12));
  CHECK(ball[0].velocity == Approx(first.velocity).epsilon(1e-12));
}

TEST_CASE("Kharaz's normal restitution follows from two angles and e_t") {
  const auto rows = alumina("oblique_kharaz2001");
  REQUIRE(rows.size() == 7);  // of nine angles, one lies below and one above those of e_t
  // At 9.826 degrees, between e_t = 0.67257 at 9.496 and 0.59691 at 20.012; the rebound is at 6.518 degrees.
  const double et = 0.67257 + (0.59691 - 0.67257) * (9.826 - 9.496) / (20.012 - 9.496);
  const double degree = std::acos(-1.0) / 180;
  CHECK(rows[2].en == Approx(et * std::tan(9.826 * degree) / std::tan(6.518 * degree)).epsilon(1e-12));
  CHECK(rows[2].velocity == Approx(3.9 * std::cos(9.826 * degree)));
  // ± 0.3 degrees of the rebound.
  const double higher = et * std::tan(9.826 * degree) / std::tan(6.818 * degree);
  const double lower = et * std::tan(9.826 * degree) / std::tan(6.218 * degree);
  CHECK(rows[2].sigma == Approx((lower - higher) / 2).epsilon(0.01));
}
