#include <ricochet/support/require.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>

#include "mittag_leffler_prepared.hpp"
#include "reciprocal_gamma.hpp"

#include <cmath>
#include <stdexcept>

namespace ricochet {

namespace {

using namespace fractional;

void require_parameters(double a, double b) {
  support::require(a > 0 && a <= 3, "a", a, "in (0, 3]");
  support::require(b > 0 && b <= 120, "b", b, "in (0, 120]");
}

void require_argument(double x) { support::require(x >= -1e6 && x <= 5, "x", x, "in [-1e6, 5]"); }

double representable(double value) {
  if (!std::isfinite(value)) throw std::overflow_error("mittag_leffler: the value exceeds the largest double");
  return value;
}

}  // namespace

double mittag_leffler(double a, double b, double x) {
  require_parameters(a, b);
  require_argument(x);
  if (x == 0) return reciprocal_gamma(b);
  if (a == 2 && b == 3) return versine(x);
  const HankelContour& contour = contour_for(b);
  const Poles poles(contour, a, x);
  const HankelContour::Grid grid = poles.grid(contour);
  const Form form = Form::choose(a, b, x);
  const double integral = Nodes(contour, grid, a, b, form).integral(x);
  const auto gamma = [=](int k) { return reciprocal_gamma_of_difference(b, k * a); };
  return representable(assemble(x, form, integral, gamma) + poles.residues(contour, grid, b, Poles::Count::rest));
}

MittagLeffler::MittagLeffler(double a, double b) {
  require_parameters(a, b);
  prepared_ = std::make_shared<PreparedMittagLeffler>(a, b);
}

double MittagLeffler::a() const noexcept { return prepared_->a(); }

double MittagLeffler::b() const noexcept { return prepared_->b(); }

double MittagLeffler::operator()(double x) const {
  require_argument(x);
  return representable(prepared_->value(x));
}

}  // namespace ricochet
