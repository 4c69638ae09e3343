#include <catch2/catch.hpp>

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/power_law_sphere.hpp>
#include <ricochet/collision/solvers/hertzian_forms.hpp>
#include <ricochet/collision/solvers/sphere_elements.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;

namespace {

/// ∫_0^1 dx/√(1 − x^{5/2}), by the beta function.
const double hertz_integral = 0.4 * std::beta(0.4, 0.5);

}  // namespace

TEST_CASE("A power-law sphere without loss is Hertz's") {
  const SphereImpact hertz = power_law_sphere(0);
  const double deepest = std::pow(1.25, 0.4);  // ½ = (2/5) ζ^{5/2}
  CHECK(hertz.max_overlap == Approx(deepest).epsilon(1e-12));
  CHECK(hertz.time_max_overlap == Approx(deepest * hertz_integral).epsilon(1e-12));
  CHECK(hertz.tcol == Approx(2 * deepest * hertz_integral).epsilon(1e-9));
  CHECK(hertz.en == Approx(1).epsilon(2e-8));  // order 5 in the nodes
  CHECK(std::abs(hertz.overlap_end) < 1e-8);
  // Elements: of order 2 here, with all of the loss the mesh's.
  const SphereImpact coarse = impact_by_elements(0, {.steps = 128}), fine = impact_by_elements(0, {.steps = 256});
  CHECK(std::log2((coarse.tcol - hertz.tcol) / (fine.tcol - hertz.tcol)) == Approx(2).margin(0.01));
  CHECK(std::abs(fine.en - 1) < 1.0 / (256 * 256));
}

TEST_CASE("Elements and Ting's formulation give one restitution, and know nothing of each other") {
  for (const double alpha : {0.125, 0.5}) {
    const ElementsLimit elements = limit_by_elements(alpha);
    CHECK(elements.doubt <= 1e-6);
    CHECK(elements.limit.back() == Approx(power_law_sphere(alpha).en).margin(1e-6));
  }
  const SphereImpact ting = power_law_sphere(0.5), elements = impact_by_elements(0.5, {.steps = 512});
  CHECK(elements.tcol == Approx(ting.tcol).epsilon(1e-4));
  CHECK(elements.max_overlap == Approx(ting.max_overlap).epsilon(1e-4));
  CHECK(elements.time_max_overlap == Approx(ting.time_max_overlap).epsilon(1e-4));
  CHECK(elements.overlap_end == Approx(ting.overlap_end).epsilon(1e-3));
}

TEST_CASE("The sphere is nearer to the paper's linear law than either Hertzian form") {
  struct Row {
    double alpha, within;
  };
  for (const Row& row : {Row{0.0625, 0.0015}, Row{0.25, 0.006}, Row{0.5, 0.015}}) {
    const double sphere = power_law_sphere(row.alpha).en, linear = fractional_contact(row.alpha).en;
    const double outer = hertzian_rebound(HertzianForm::derivative_of_power, row.alpha).en;
    const double inner = hertzian_rebound(HertzianForm::power_of_derivative, row.alpha).en;
    CHECK(std::abs(linear / sphere - 1) <= row.within);
    CHECK(std::abs(outer / sphere - 1) > 4 * std::abs(linear / sphere - 1));
    CHECK(std::abs(inner / sphere - 1) > 4 * std::abs(linear / sphere - 1));
    CHECK(outer < linear);
    CHECK(linear < sphere);
    CHECK(sphere < inner);
  }
}

TEST_CASE("While the contact grows the sphere is the Hertzian law") {
  // From a series alone, against plain summing in time: both forms of one restitution at the values of a trial that
  // stepped with L1.
  CHECK(hertzian_rebound(HertzianForm::derivative_of_power, 0.25).en == Approx(0.57164767998).epsilon(1e-9));
  CHECK(hertzian_rebound(HertzianForm::derivative_of_power, 0.5).en == Approx(0.285653122776).epsilon(1e-9));
  CHECK(hertzian_rebound(HertzianForm::derivative_of_power, 0.25).tcol == Approx(2.8422870976).epsilon(1e-9));
}

TEST_CASE("What the sphere's solvers do not take") {
  CHECK_THROWS_WITH(power_law_sphere(0.9), "alpha = 0.9: must be in [0, 0.8]");
  CHECK_THROWS_WITH(power_law_sphere(0.5, 4), "nodes = 4: must be in [8, 64]");
  CHECK_THROWS_WITH(impact_by_elements(-0.1, {}), "alpha = -0.1: must be in [0, 0.8]");
  CHECK_THROWS_WITH(impact_by_elements(0.5, {.steps = 4}), "steps = 4: must be in [8, 8192]");
  CHECK_THROWS_WITH(impact_by_elements(0.5, {.steps = 64, .every = 3}), "every = 3: must be a divisor of steps");
  CHECK_THROWS_WITH(limit_by_elements(0.5, 0), "tolerance = 0: must be finite and > 0");
  CHECK_THROWS_WITH(hertzian_rebound(HertzianForm::derivative_of_power, 0.01), "alpha = 0.01: must be in [0.05, 0.8]");
}
