#include <ricochet/fractional/memory_kernel.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using ricochet::Arm;
using ricochet::memory_kernel;
using ricochet::MemoryKernel;

namespace {

/// Largest relative deviation from t^{−α}/Γ(1−α) on [δ, T], by an independent plain scan.
double scanned_error(const MemoryKernel& kernel) {
  double worst = 0;
  const int samples = 3000;
  for (int i = 0; i <= samples; ++i) {
    const double t = kernel.shortest() * std::pow(kernel.longest() / kernel.shortest(), i / double(samples));
    const double exact = std::pow(t, -kernel.alpha()) / std::tgamma(1 - kernel.alpha());
    worst = std::max(worst, std::fabs(kernel(t) / exact - 1));
  }
  return worst;
}

/// ∫₀^δ of the spring and the arms times τ^m, m = 0, 1, by closed forms in long double.
double moment(const MemoryKernel& kernel, int m) {
  const long double d = kernel.shortest();
  long double sum = kernel.spring() * std::pow(d, m + 1) / (m + 1);
  for (const Arm& arm : kernel.arms()) {
    const long double s = arm.rate, x = s * d;
    if (m == 0) sum += arm.strength * -std::expm1(-x) / s;
    else if (x < 0.01L) sum += arm.strength * d * d * (0.5L - x / 3 + x * x / 8 - x * x * x / 30 + x * x * x * x / 144);
    else sum += arm.strength * (-std::expm1(-x) - x * std::exp(-x)) / (s * s);
  }
  return static_cast<double>(sum);
}

const double orders[] = {0.01, 0.1, 0.25, 0.3197, 0.5, 0.6, 0.75, 0.9, 0.99};

}  // namespace

TEST_CASE("A memory kernel is positive, accurate and says how accurate") {
  for (const double alpha : orders)
    for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
      CAPTURE(alpha, tolerance);
      const MemoryKernel kernel = memory_kernel(alpha, 1e-6, 1e-4, tolerance);
      CHECK(kernel.error() <= tolerance);
      // The a-posteriori error may miss the very top of a wave by little; 1e-14 is the rounding of this scan.
      CHECK(scanned_error(kernel) <= 1.02 * kernel.error() + 1e-14);
      CHECK(kernel.error() <= 1.02 * scanned_error(kernel) + 1e-14);
      CHECK(kernel.spring() > 0);
      CHECK(kernel.dashpot() > 0);
      for (const Arm& arm : kernel.arms()) CHECK((arm.strength > 0 && arm.rate > 0));
    }
}

TEST_CASE("A memory kernel shares both moments with the true one below its shortest time") {
  for (const double alpha : orders) {
    CAPTURE(alpha);
    const double d = 3e-7;
    const MemoryKernel kernel = memory_kernel(alpha, d, 3e-5, 1e-10);
    CHECK(moment(kernel, 0) + kernel.dashpot() ==
          Approx(std::pow(d, 1 - alpha) / std::tgamma(2 - alpha)).epsilon(1e-13));
    CHECK(moment(kernel, 1) ==
          Approx(std::pow(d, 2 - alpha) / ((2 - alpha) * std::tgamma(1 - alpha))).epsilon(1e-12));
  }
}

TEST_CASE("A memory kernel spends few arms") {
  // Exponents of the asymptotic rate leave 16 arms for 1e-10 over a ratio of 100, and 10 for 1e-6.
  for (const double alpha : orders) {
    CAPTURE(alpha);
    CHECK(memory_kernel(alpha, 1, 100, 1e-10).arms().size() <= 16);
    CHECK(memory_kernel(alpha, 1, 100, 1e-6).arms().size() <= (alpha <= 0.5 ? 9 : 10));
    CHECK(memory_kernel(alpha, 1, 30, 1e-10).arms().size() <= 13);
    CHECK(memory_kernel(alpha, 1, 10, 1e-10).arms().size() <= 10);
  }
}

TEST_CASE("Long memories are reached") {
  for (const double alpha : {0.01, 0.3197, 0.99}) {
    CAPTURE(alpha);
    for (const double ratio : {1e3, 1e4}) CHECK(memory_kernel(alpha, 1e-3, 1e-3 * ratio, 1e-10).error() <= 1e-10);
    CHECK(memory_kernel(alpha, 1, 1e6, 1e-6).error() <= 1e-6);
  }
}

TEST_CASE("The limits of a memory kernel are exact, and orders next to them work") {
  const MemoryKernel spring = memory_kernel(0, 1e-6, 1e-4, 1e-10), dashpot = memory_kernel(1, 1e-6, 1e-4, 1e-10);
  CHECK((spring.spring() == 1 && spring.dashpot() == 0 && spring.arms().empty() && spring.error() == 0));
  CHECK((dashpot.spring() == 0 && dashpot.dashpot() == 1 && dashpot.arms().empty() && dashpot.error() == 0));
  CHECK(memory_kernel(1e-9, 1, 100, 1e-10).spring() == Approx(1).epsilon(1e-8));
  CHECK(memory_kernel(1 - 1e-9, 1, 100, 1e-10).dashpot() == Approx(1).epsilon(1e-7));
  CHECK(memory_kernel(0.5, 1, 1, 1e-6).error() <= 1e-6);
}

TEST_CASE("A memory kernel scales with the unit of time") {
  const MemoryKernel a = memory_kernel(0.3, 1, 50, 1e-8), b = memory_kernel(0.3, 1e-6, 50e-6, 1e-8);
  REQUIRE(a.arms().size() == b.arms().size());
  CHECK(b.spring() == Approx(a.spring() * std::pow(1e-6, -0.3)).epsilon(1e-9));
  CHECK(b.dashpot() == Approx(a.dashpot() * std::pow(1e-6, 0.7)).epsilon(1e-9));
}

TEST_CASE("Misuse of a memory kernel is named") {
  CHECK_THROWS_WITH(memory_kernel(-0.1, 1, 2, 1e-6), Catch::Contains("alpha = -0.1"));
  CHECK_THROWS_WITH(memory_kernel(NAN, 1, 2, 1e-6), Catch::Contains("alpha"));
  CHECK_THROWS_WITH(memory_kernel(0.5, 0, 2, 1e-6), Catch::Contains("shortest = 0"));
  CHECK_THROWS_WITH(memory_kernel(0.5, 2, 1, 1e-6), Catch::Contains("longest = 1"));
  CHECK_THROWS_WITH(memory_kernel(0.5, 1, 2e6, 1e-6), Catch::Contains("longest"));
  CHECK_THROWS_WITH(memory_kernel(0.5, 1, 2, 1e-14), Catch::Contains("tolerance"));
}
