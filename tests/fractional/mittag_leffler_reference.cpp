#include "mittag_leffler_reference.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <sstream>

namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

const Real pi = boost::math::constants::pi<Real>();

Real reciprocal_gamma(const Real& x) {
  if (x > 0) return 1 / boost::math::tgamma(x);
  const Real whole = round(x), off = x - whole;  // reflection, exact at the poles
  const Real sine = fmod(whole, Real(2)) == 0 ? sin(pi * off) : -sin(pi * off);
  return sine * boost::math::tgamma(Real(1 - x)) / pi;
}

Real series(const Real& a, const Real& b, const Real& x, const Real& radius) {
  Real sum = 0, power = 1, greatest = 0;
  for (int k = 0;; ++k) {
    const Real term = power * reciprocal_gamma(a * k + b), size = abs(term);
    sum += term;
    if (size > greatest) greatest = size;
    // Γ outgrows the power past 3|x|^{1/a}; where |x| < 1, the powers alone bound what is left, as 1/Γ < 2.
    const bool bounded = radius < 1 || a * k > 3 * radius + 2;
    if (bounded && (radius < 1 ? abs(power) : size) < Real("1e-90") * greatest) return sum;
    power *= x;
  }
}

// Poles of s^{a−b}/(s^a − x) on the principal sheet, then −Σ x^{−k}/Γ(b − ak) up to its smallest term: with
// |x|^{1/a} > 75 the rest is below e^-75; or up to where no term counts any more.
Real far_out(const Real& a, const Real& b, const Real& x, const Real& radius) {
  Real sum = 0;
  for (int j = x > 0 ? 0 : 1; j <= a; j += 2) {
    const Real angle = pi * j / a;
    const Real phase = radius * sin(angle) + (1 - b) * angle;
    sum += (j == 0 || j == a ? 1 : 2) * pow(radius, Real(1 - b)) * exp(Real(radius * cos(angle))) * cos(phase) / a;
  }
  Real power = 1;
  for (int k = 1; a * k < b + 70; ++k) {
    power /= x;
    sum -= power * reciprocal_gamma(b - a * k);
    const Real beyond = a * k > b ? Real(a * k - b) : Real(0);  // 1/|Γ(b − ak)| < 2 Γ(1 + beyond)
    if (2 * abs(power) * boost::math::tgamma(Real(beyond + 1)) < Real("1e-40") * abs(sum)) break;
  }
  return sum;
}

Real evaluate(const Real& a, const Real& b, const Real& x) {
  const Real radius = x == 0 ? Real(0) : Real(pow(abs(x), Real(1 / a)));
  return radius <= 75 ? series(a, b, x, radius) : far_out(a, b, x, radius);
}

}  // namespace

Reference mittag_leffler_reference(double a, double b, double x) {
  const Real value = evaluate(a, b, x);
  const Real slope = (evaluate(a, Real(b) - 1, x) - (Real(b) - 1) * value) / a;  // x E' = (E_{a,b−1} − (b−1)E)/a
  std::ostringstream digits;
  digits.precision(20);
  digits << std::showpoint << value;
  return {value.convert_to<double>(), slope.convert_to<double>(), digits.str()};
}
