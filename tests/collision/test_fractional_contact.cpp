#include "reference_contacts.hpp"

#include <catch2/catch.hpp>
#include <ricochet/collision/fractional_collocation.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace ricochet;
using std::numbers::pi;

namespace {

bool agree(double x, double y, double relative) { return std::abs(x - y) <= relative * std::abs(y); }

}  // namespace

TEST_CASE("the fractional contact has its tabulated numbers to 1e-12") {
  const auto table = reference_contacts();
  CHECK(table.size() == 12);
  for (const FractionalContact& r : table) {
    INFO("alpha = " << r.alpha);
    const FractionalContact c = fractional_contact(r.alpha);
    CHECK(agree(c.z_star, r.z_star, 1e-12));
    CHECK(agree(c.tau, r.tau, 1e-12));
    CHECK(agree(c.en, r.en, 1e-12));
    CHECK(agree(c.overlap_end, r.overlap_end, 1e-12));
    CHECK(agree(c.z_max_overlap, r.z_max_overlap, 1e-12));
    CHECK(agree(c.t_max_overlap, r.t_max_overlap, 1e-12));
    CHECK(agree(c.max_overlap, r.max_overlap, 1e-12));
    CHECK(std::abs(conversion_degree(r.en) - r.alpha) <= 1e-12);
  }
}

TEST_CASE("closed form and collocation agree on every number of the fractional contact") {
  const auto compare = [](double alpha, ContactEnd end, double tolerance) {
    INFO("alpha = " << alpha);
    const FractionalContact c = fractional_contact(alpha, end);
    const FractionalSolution s = collocate_collision(alpha, 36, end);
    REQUIRE(s.separated());
    CHECK(agree(s.tcol, c.tau, tolerance));
    CHECK(agree(s.en, c.en, tolerance));
    CHECK(std::abs(s.overlap_end / s.tcol - c.overlap_end) <= tolerance * c.max_overlap);
    CHECK(agree(s.max_overlap, c.max_overlap * c.tau, tolerance));
    CHECK(agree(s.time_max_overlap, c.t_max_overlap * c.tau, tolerance));
    CHECK(agree(s.max_force, c.max_force / c.tau, tolerance));
    CHECK(agree(s.time_max_force, c.t_max_force * c.tau, 100 * tolerance));
  };
  for (double alpha :
       {-1.0, -0.8, -0.5, -0.25, -0.1, -0.01, 0.0, 0.01, 0.1, 0.2, 0.3197, 0.5, 0.66, 0.8, 0.9, 0.95, 0.97})
    compare(alpha, ContactEnd::force, 1e-12);
  for (double alpha : {0.0, 0.01, 0.2, 0.35, 0.39}) compare(alpha, ContactEnd::overlap, 1e-12);
}

TEST_CASE("contacts end by overlap up to the limit where its minimum touches zero") {
  const double below = std::nextafter(overlap_limit, 0.0);
  const FractionalContact c = fractional_contact(below, ContactEnd::overlap);
  CHECK(c.en >= 0);
  CHECK(c.en < 1e-6);  // e_n falls as the root of what is left of α
  // The limit itself, from the other side: at z where the rate vanishes for the second time the overlap is zero.
  const double a = 2 - overlap_limit;
  double low = 13, high = 17;
  for (int i = 0; i < 60; ++i) (mittag_leffler(a, 1, -0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
  CHECK(std::abs(mittag_leffler(a, 2, -low)) < 1e-15);
  CHECK_THROWS_WITH(fractional_contact(0.41, ContactEnd::overlap),
                    "alpha = 0.41: must be in [-1, 0.400884...) for a contact that ends by overlap");
}

TEST_CASE("up to the last alpha below 1 the contact is right, as far as 2 - alpha tells it from 1") {
  // 20 digits of z* and e_n at alpha = 1 - 2^-k, from the series in 110-digit arithmetic.
  struct Row {
    int k;
    double z_star, en;
  };
  for (const Row& row : {Row{5, 6.5375119116453007951, 0.0059482419504787765393},
                         Row{10, 11.291628255499282605, 9.6072876614502215081e-5},
                         Row{20, 19.571220936241860747, 5.1522652143996575239e-8},
                         Row{30, 27.240555802856868995, 3.5548036764286897424e-11},
                         Row{40, 34.694091426346644725, 2.7018115303234938862e-14},
                         Row{50, 42.032711631283158155, 2.165917954861328735e-17}}) {
    CAPTURE(row.k);
    const FractionalContact c = fractional_contact(1 - std::ldexp(1.0, -row.k));  // 2 - alpha is exact
    CHECK(agree(c.z_star, row.z_star, 1e-12));
    CHECK(agree(c.en, row.en, 1e-12));
  }
  CHECK_THROWS_WITH(fractional_contact(1 - 1.2e-16),
                    Catch::StartsWith("alpha = 0.9999999999999999: must be in [-1, 1)"));
}

TEST_CASE("below alpha = 0 the overlap's zero ends the contact, whichever end is asked for") {
  // From the series in 30-digit arithmetic.
  struct Row {
    double alpha, z_star, en;
  };
  for (const Row& row :
       {Row{-1, 27.454621738566911091, 2.5847397266428515171}, Row{-0.75, 19.895846708509685034, 2.2333809622476810456},
        Row{-0.5, 14.916897539794417092, 1.8575138873735052151},
        Row{-0.25, 11.71217696953725139, 1.4500812477720298114},
        Row{-0.1, 10.452270878655406204, 1.1861743080339754771},
        Row{-0.01, 9.9182461400709349888, 1.0190399760075101604}})
    for (const ContactEnd end : {ContactEnd::force, ContactEnd::overlap}) {
      CAPTURE(row.alpha);
      const FractionalContact c = fractional_contact(row.alpha, end);
      CHECK(agree(c.z_star, row.z_star, 1e-12));
      CHECK(agree(c.en, row.en, 1e-12));
      CHECK(c.overlap_end == 0);
    }
  CHECK_THROWS_WITH(fractional_contact(-1.01), Catch::StartsWith("alpha = -1.01: must be in [-1, 1)"));
}

TEST_CASE("at alpha = -1 the motion is elementary: zeta''' = -zeta") {
  // ζ = (2 e^{t/2} cos(√3t/2 − π/3) − e^{−t})/3, and R' ∝ ζ: the force is greatest where the contact ends.
  const FractionalContact c = fractional_contact(-1);
  const double t = c.tau, phase = std::sqrt(0.75) * t;
  CHECK(std::abs(2 * std::exp(0.5 * t) * std::cos(phase - pi / 3) - std::exp(-t)) < 1e-13);
  CHECK(agree(c.en, -(2 * std::exp(0.5 * t) * std::cos(phase) + std::exp(-t)) / 3, 1e-13));
  CHECK(c.t_max_force == Approx(1).epsilon(1e-12));
}

TEST_CASE("a spring keeps the whole velocity, and nothing keeps more") {
  for (const ContactEnd end : {ContactEnd::force, ContactEnd::overlap}) {
    CHECK(fractional_contact(0, end).en == 1);
    for (const double alpha : {1e-300, 1e-20, 1e-16, 1e-15, 1e-10}) CHECK(fractional_contact(alpha, end).en <= 1);
  }
}

TEST_CASE("the conversion degree inverts the restitution") {
  for (const ContactEnd end : {ContactEnd::force, ContactEnd::overlap})
    for (double en : {1.0, 0.999999, 0.945, 0.5, 0.1, 0.01, 0.006}) {
      INFO("en = " << en);
      const double alpha = conversion_degree(en, end);
      CHECK(agree(fractional_contact(alpha, end).en, en, 1e-11));
    }
  CHECK(std::abs(conversion_degree(0.5) - 0.3196786) < 5e-8);    // Fig. 5
  CHECK(std::abs(conversion_degree(0.945) - 0.0293504) < 5e-8);  // Fig. 6
  CHECK_THROWS_WITH(conversion_degree(1.5), "en = 1.5: must be in [1e-15, 1]");
  CHECK_THROWS_WITH(conversion_degree(1e-7, ContactEnd::overlap),
                    "en = 1e-07: must be in [1e-6, 1] for a contact that ends by overlap");
  for (const double en : {1e-4, 1e-7, 1e-10, 1e-13}) {
    const double alpha = conversion_degree(en);
    CHECK(agree(fractional_contact(alpha).en, en, 1e-11 + 2e-16 / (1 - alpha)));
  }
  CHECK_THROWS_AS(conversion_degree(0), std::invalid_argument);
  CHECK_THROWS_AS(fractional_contact(1), std::invalid_argument);
}

TEST_CASE("estimate (57) gives the time it is quoted with") {
  // The case of Fig. 2: a sphere of 3 mm and 7850 kg/m³ on a plate
  const double mass = 4.0 / 3 * pi * std::pow(3e-3, 3) * 7850, alpha = 0.2;
  const double coefficient = std::pow(128.1, alpha) * std::pow(4615380, 1 - alpha) / mass;
  CHECK(std::abs(tcol_estimate(coefficient, alpha) - 37.8e-6) < 0.05e-6);
  const double exact = fractional_contact(alpha).tau * std::pow(coefficient, -1 / (2 - alpha));
  CHECK(std::abs(exact - 38.57e-6) < 0.01e-6);
  CHECK(std::abs(tcol_estimate(1, 0) - std::sqrt(1.641 * 6)) < 1e-14);
}

TEST_CASE("the trajectory satisfies m zeta'' + R = 0 for every conversion degree") {
  for (double alpha : {-0.5, 0.0, 0.2, 0.7, 1.0, 1.3}) {
    const FractionalTrajectory path(3e3, alpha, 7.06858e-6, 0.5);
    const double scale = path.time_scale();
    for (double s : {0.3, 1.0, 2.2}) {
      INFO("alpha = " << alpha << ", s = " << s);
      const double t = s * scale, h = 1e-3 * scale;
      const double slope =
          (8 * (path.overlap(t + h) - path.overlap(t - h)) - (path.overlap(t + 2 * h) - path.overlap(t - 2 * h))) /
          (12 * h);
      CHECK(std::abs(slope - path.rate(t)) < 1e-10 * 0.5);
      const double acceleration =
          (8 * (path.rate(t + h) - path.rate(t - h)) - (path.rate(t + 2 * h) - path.rate(t - 2 * h))) / (12 * h);
      CHECK(std::abs(7.06858e-6 * acceleration + path.force(t)) < 1e-9 * 7.06858e-6 * 0.5 / scale);
    }
    CHECK(path.overlap(0) == 0);
    CHECK(std::abs(path.rate(0) - 0.5) < 1e-15);
  }
  CHECK_THROWS_WITH(FractionalTrajectory(1, 2, 1, 1), "alpha = 2: must be in [-1, 2)");
  CHECK_THROWS_WITH(FractionalTrajectory(1e-308, 0.5, 1e308, 1), Catch::StartsWith("unit of the motion = inf"));
  CHECK_THROWS_WITH(FractionalTrajectory(1, 0.5, 1, 5e-324), Catch::StartsWith("unit of the motion = 5e-324"));
  CHECK_THROWS_WITH(FractionalTrajectory(1, 0.5, 1, 1).overlap(-1), "t = -1: must be finite and >= 0");
  CHECK_THROWS_AS(FractionalTrajectory(1, 1.5, 1, 1).force(0), std::invalid_argument);
}

TEST_CASE("A trajectory at the edge of doubles is a double or refuses the time") {
  std::size_t numbers = 0, refused = 0;
  for (const double alpha : {-1.0, -0.5, 0.0, 0.5, 0.97, 1.0, 1.5})
    for (const double coefficient : {1e-320, 1.0, 1e300})
      for (const double mass : {5e-324, 1.0, 1e308})
        for (const double velocity : {1e-300, 1.0, 1e300, 1.7e308}) try {
            const FractionalTrajectory path(coefficient, alpha, mass, velocity);
            for (const double s : {0.5, 1.9, 6.0, 40.0})
              for (const auto number :
                   {&FractionalTrajectory::overlap, &FractionalTrajectory::rate, &FractionalTrajectory::force})
                try {
                  const double value = (path.*number)(s * path.time_scale());
                  CHECK(std::isfinite(value));
                  ++numbers;
                } catch (const std::invalid_argument& error) {
                  CHECK_THAT(error.what(), Catch::StartsWith("t = ") || Catch::StartsWith("x = "));
                  ++refused;
                }
          } catch (const std::invalid_argument& error) {
            CHECK_THAT(error.what(), Catch::StartsWith("unit of the motion = "));
          }
  CHECK(numbers > 100);
  CHECK(refused > 10);
  CHECK_THROWS_WITH(FractionalTrajectory(1, -1, 1, 1.7e308).overlap(40),
                    Catch::StartsWith("t = 40: must be a time at"));
}
