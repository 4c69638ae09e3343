#include <ricochet/detail/require.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>

#include "hankel_contour.hpp"
#include "reciprocal_gamma.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace ricochet {

namespace {

using detail::HankelContour;
using std::numbers::pi;
using Complex = std::complex<double>;
using Grid = HankelContour::Grid;

void require_parameters(double a, double b) {
  detail::require(a > 0 && a <= 3, "a", a, "in (0, 3]");
  detail::require_positive("b", b);
}

void require_argument(double x) { detail::require(x >= -1e6 && x <= 5, "x", x, "in [-1e6, 5]"); }

const HankelContour& contour_of(double b, std::unique_ptr<HankelContour>& own) {
  constexpr double usual = 2.5;  // covers b = 1, 2 and a ≤ 2, so the usual contour is laid out once a process
  static const HankelContour contour(usual);
  if (b <= usual) return contour;
  own = std::make_unique<HankelContour>(b);
  return *own;
}

/// How the integrand is written.
struct Form {
  int shifts;     ///< how often E_{a,b} = (E_{a,b−a} − 1/Γ(b−a))/x is applied before integrating; −1: backwards
  bool near_one;  ///< the integrand of E_{1,m} subtracted
  int m;          ///< integer near b
};

Form form_of(double a, double b, double x) {
  const int m = b < 0.5 ? 0 : 1;
  const bool near_one = std::abs(a - 1) < 0.1 && std::abs(b - m) < 0.15;
  int shifts = 0;
  if (a < 2 && b < a + 1) shifts = (x <= -1) + (x <= -30);
  if (b < 0.3 && std::abs(x) < 1) shifts = -1;
  return {shifts, near_one && x < 0, m};
}

Complex power(Complex log_s, double exponent) {
  const double size = std::exp(exponent * log_s.real()), turn = exponent * log_s.imag();
  return {size * std::cos(turn), size * std::sin(turn)};
}

/// The nodes of one form on one grid, in arrays that the compiler can sum over in lanes.
class Nodes {
 public:
  Nodes(const HankelContour& contour, Grid grid, double a, double b, Form form) : size_(contour.size()), form_(form) {
    for (std::size_t k = 0; k < size_; ++k) {
      const detail::ContourNode& node = contour.node(grid, k);
      const Complex sa = power(node.log_s, a);
      pole_re_[k] = sa.real();
      pole_im_[k] = sa.imag();
      if (form.near_one)
        fill_near_one(k, node, a, b);
      else
        fill(k, node, (1 + form.shifts) * a - b);
    }
  }

  double integral(double x) const { return form_.near_one ? integral_near_one(x) : integral_plain(x); }

 private:
  void fill(std::size_t k, const detail::ContourNode& node, double exponent) {
    const Complex w = node.weight * std::exp(node.s + exponent * node.log_s);
    re_[k] = w.real();
    im_[k] = w.imag();
  }

  // s^{a−b}/(s^a − x) − s^{1−m}/(s − x) = s^{1−m} [s^a (s^δ − 1) − x (s^{a−1+δ} − 1)] / ((s^a − x)(s − x)), δ = m − b
  void fill_near_one(std::size_t k, const detail::ContourNode& node, double a, double b) {
    const double m = form_.m - form_.shifts;
    const double delta = (form_.m - b) + form_.shifts * (a - 1);
    const Complex w = node.weight * std::exp(node.s) * power(node.log_s, 1 - m);
    const Complex constant = w * Complex(pole_re_[k], pole_im_[k]) * detail::expm1(delta * node.log_s);
    const Complex linear = w * detail::expm1((a - 1 + delta) * node.log_s);
    re_[k] = constant.real();
    im_[k] = constant.imag();
    linear_re_[k] = linear.real();
    linear_im_[k] = linear.imag();
    s_re_[k] = node.s.real();
    s_im_[k] = node.s.imag();
  }

  double integral_plain(double x) const {
    double sum = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      const double re = pole_re_[k] - x, im = pole_im_[k];
      sum += (re_[k] * re + im_[k] * im) / (re * re + im * im);
    }
    return sum;
  }

  double integral_near_one(double x) const {
    double sum = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      const double re = re_[k] - x * linear_re_[k], im = im_[k] - x * linear_im_[k];
      const double p = pole_re_[k] - x, pi_ = pole_im_[k], q = s_re_[k] - x, qi = s_im_[k];
      const double den = p * q - pi_ * qi, den_i = p * qi + pi_ * q;
      sum += (re * den + im * den_i) / (den * den + den_i * den_i);
    }
    return sum;
  }

  using Row = std::array<double, HankelContour::capacity>;
  std::size_t size_;
  Form form_;
  Row pole_re_, pole_im_, re_, im_;
  Row linear_re_, linear_im_, s_re_, s_im_;
};

/// A pole of 1/(s^a − x), standing for its conjugate as well where `count` is 2.
struct Pole {
  Complex s, u;
  int count;
};

/// The poles on the principal sheet.
class Poles {
 public:
  Poles(const HankelContour& contour, double a, double x) : a_(a) {
    if (x == 0) return;
    // |x|^{1/a} with the rounding of 1/a made good, which a phase |x|^{1/a} sin(π/a) of thousands would feel.
    const double inverse = 1 / a, remainder = std::fma(-inverse, a, 1.0) / a;
    const double radius = std::pow(std::abs(x), inverse) * (1 + remainder * std::log(std::abs(x)));
    if (x > 0) add(contour, radius, 0, 1);
    if (x > 0 && a >= 2) add(contour, radius, 2 * pi / a, 2);
    if (x < 0 && a >= 1) add(contour, radius, pi / a, 2);
  }

  Grid grid(const HankelContour& contour) const {
    const Pole* nearest = nullptr;
    for (std::size_t i = 0; i < size_; ++i)
      if (!nearest || std::abs(poles_[i].u.imag()) < std::abs(nearest->u.imag())) nearest = &poles_[i];
    return nearest ? contour.grid_away_from(nearest->u) : HankelContour::on_axis;
  }

  /// Σ of s^{1−b} e^s/a times the contour's factor.
  double residues(const HankelContour& contour, Grid grid, double b) const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Pole& pole = poles_[i];
      const Complex factor = contour.pole_factor(pole.u, grid);
      if (factor == 0.0) continue;
      const Complex residue = std::exp(pole.s + (1 - b) * std::log(pole.s)) / a_;
      sum += pole.count * (residue * factor).real();
    }
    return sum;
  }

 private:
  void add(const HankelContour& contour, double radius, double argument, int count) {
    const Complex s(radius * std::cos(argument), radius * std::sin(argument));
    if (s.real() > -745) poles_[size_++] = {s, contour.parameter(s), count};
  }

  double a_;
  std::size_t size_ = 0;
  std::array<Pole, 2> poles_{};
};

double assemble(double a, double b, double x, Form form, double integral, double residues) {
  double value = integral;
  if (form.shifts < 0) value = detail::reciprocal_gamma(b) + x * value;
  for (int k = form.shifts; k > 0; --k) value = (value - detail::reciprocal_gamma_of_difference(b, k * a)) / x;
  if (form.near_one) value += form.m == 0 ? x * std::exp(x) : std::exp(x);
  value += residues;
  if (!std::isfinite(value)) throw std::overflow_error("mittag_leffler: the value exceeds the largest double");
  return value;
}

}  // namespace

double mittag_leffler(double a, double b, double x) {
  require_parameters(a, b);
  require_argument(x);
  if (x == 0) return detail::reciprocal_gamma(b);
  std::unique_ptr<HankelContour> own;
  const HankelContour& contour = contour_of(b, own);
  const Poles poles(contour, a, x);
  const Grid grid = poles.grid(contour);
  const Form form = form_of(a, b, x);
  return assemble(a, b, x, form, Nodes(contour, grid, a, b, form).integral(x), poles.residues(contour, grid, b));
}

struct MittagLeffler::Prepared {
  double a, b;
};

MittagLeffler::MittagLeffler(double a, double b) : prepared_(std::make_shared<Prepared>(Prepared{a, b})) {
  require_parameters(a, b);
}
double MittagLeffler::a() const noexcept { return prepared_->a; }
double MittagLeffler::b() const noexcept { return prepared_->b; }
double MittagLeffler::operator()(double x) const { return mittag_leffler(prepared_->a, prepared_->b, x); }

}  // namespace ricochet
