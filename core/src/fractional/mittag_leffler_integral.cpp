#include "mittag_leffler_integral.hpp"

#include "complex_power.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::fractional {

using std::numbers::pi;

Form Form::choose(double a, double b, double x) {
  Form form;
  form.m = b < 0.5 ? 0 : 1;
  form.near_one = x < 0 && std::abs(a - 1) < least_pole_order - 1 && std::abs(b - form.m) < 0.15;
  if (a < 2 && b < a + 1) form.shifts = (x <= -1) + (x <= -30);
  if (a < least_plain_order) {
    form.shifts = x <= -1;
    form.near_zero = x < 1 - 2 * a;  // to the right, E is as large as the residue at the pole s = x^{1/a}, of order 1/a
  } else if (b < least_second && std::abs(x) < 1) {
    form.shifts = -1;
  }
  return form;
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the rows' first size_ entries are ever read.
Nodes::Nodes(const HankelContour& contour, HankelContour::Grid grid, double a, double b, Form form)
    : size_(contour.size()), form_(form) {
  const ContourNodes& nodes = contour.nodes(grid);
  if (form.near_one)
    fill_near_one(nodes, a, b);
  else if (form.near_zero)
    fill_near_zero(nodes, a, b);
  else
    fill(nodes, a, b);
}

// weight·s^{(1+shifts)a − b}; b = 1 and b = a, the usual ones, need no second power.
void Nodes::fill(const ContourNodes& nodes, double a, double b) {
  complex_powers(size_, nodes.log_size.data(), nodes.argument.data(), a, pole_re_.data(), pole_im_.data());
  const bool over_s = form_.shifts >= 0 && b == 1, chained = over_s || (form_.shifts >= 0 && b == a);
  std::copy_n((over_s ? nodes.over_s_re : nodes.weight_re).begin(), size_, re_.begin());
  std::copy_n((over_s ? nodes.over_s_im : nodes.weight_im).begin(), size_, im_.begin());
  if (chained) return multiply(form_.shifts + (over_s ? 1 : 0), pole_re_, pole_im_);
  multiply_by_power(nodes, (1 + form_.shifts) * a - b);
}

// weight·s^{shifts·a − b} (s^a − 1).
void Nodes::fill_near_zero(const ContourNodes& nodes, double a, double b) {
  complex_powers_less_one(size_, nodes.log_size.data(), nodes.argument.data(), a, pole_re_.data(), pole_im_.data());
  std::copy_n(nodes.weight_re.begin(), size_, re_.begin());
  std::copy_n(nodes.weight_im.begin(), size_, im_.begin());
  multiply_by_power(nodes, form_.shifts * a - b);
  multiply(1, pole_re_, pole_im_);
}

// In parts where b is large: e^s in the weight and s^{−b} would each leave the range of a double.
void Nodes::multiply_by_power(const ContourNodes& nodes, double exponent) {
  const int parts = 1 + static_cast<int>(std::abs(exponent) / 40);
  Row power_re, power_im;
  complex_powers(size_, nodes.log_size.data(), nodes.argument.data(), exponent / parts, power_re.data(),
                 power_im.data());
  multiply(parts, power_re, power_im);
}

// The integrand times the rows' numbers, so many times.
void Nodes::multiply(int times, const Row& q_re, const Row& q_im) {
  for (int i = 0; i < times; ++i)
    for (std::size_t k = 0; k < size_; ++k) {
      const double re = re_[k] * q_re[k] - im_[k] * q_im[k];
      im_[k] = re_[k] * q_im[k] + im_[k] * q_re[k];
      re_[k] = re;
    }
}

// s^{a−b}/(s^a − x) − s^{1−m}/(s − x) = s^{1−m} [s^a (s^δ − 1) − x (s^{δ+a−1} − 1)] / ((s^a − x)(s − x)), δ = m − b,
// the shifts taken into m and b. For b = m and b = a, δ is a multiple of a − 1 and everything comes from s^{a−1} − 1.
void Nodes::fill_near_one(const ContourNodes& nodes, double a, double b) {
  const bool chained = b == form_.m || (b == a && form_.m == 1);
  const int links = form_.shifts - (b == form_.m ? 0 : 1);
  const double delta = (form_.m - b) + form_.shifts * (a - 1);
  const auto less_one = [&](double exponent, Row& re, Row& im) {
    complex_powers_less_one(size_, nodes.log_size.data(), nodes.argument.data(), exponent, re.data(), im.data());
  };
  less_one(a - 1, pole_re_, pole_im_);
  if (!chained) less_one(delta, re_, im_), less_one(delta + (a - 1), linear_re_, linear_im_);
  for (std::size_t k = 0; k < size_; ++k) {
    const Complex s(nodes.s_re[k], nodes.s_im[k]), step(pole_re_[k], pole_im_[k]), sa = s + product(s, step);
    const auto chain = [&](int n) {  // s^{n(a−1)} − 1
      Complex sum = n < 0 ? -step / (1.0 + step) : Complex(0);
      for (int i = 0; i < n; ++i) sum += step + product(sum, step);
      return sum;
    };
    const Complex low = chained ? chain(links) : Complex(re_[k], im_[k]);
    const Complex high = chained ? chain(links + 1) : Complex(linear_re_[k], linear_im_[k]);
    Complex w(nodes.weight_re[k], nodes.weight_im[k]);
    for (int m = form_.m - form_.shifts; m < 1; ++m) w = product(w, s);
    const Complex constant = product(w, product(sa, low)), linear = product(w, high);
    pole_re_[k] = sa.real(), pole_im_[k] = sa.imag();
    re_[k] = constant.real(), im_[k] = constant.imag();
    linear_re_[k] = linear.real(), linear_im_[k] = linear.imag();
    s_re_[k] = s.real(), s_im_[k] = s.imag();
  }
}

// Four partial sums: the order of the additions is fixed, and the divisions overlap.
double Nodes::integral_plain(double x) const {
  std::array<double, 4> sum{};
  const auto term = [&](std::size_t k) {
    const double re = pole_re_[k] - x, im = pole_im_[k];
    return (re_[k] * re + im_[k] * im) / (re * re + im * im);
  };
  std::size_t k = 0;
  for (; k + 4 <= size_; k += 4)
    for (std::size_t lane = 0; lane < 4; ++lane) sum[lane] += term(k + lane);
  for (; k < size_; ++k) sum[0] += term(k);
  return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}

double Nodes::integral_near_one(double x) const {
  std::array<double, 4> sum{};
  const auto term = [&](std::size_t k) {
    const double re = re_[k] - x * linear_re_[k], im = im_[k] - x * linear_im_[k];
    const double p_re = pole_re_[k] - x, p_im = pole_im_[k], q_re = s_re_[k] - x, q_im = s_im_[k];
    const double d_re = p_re * q_re - p_im * q_im, d_im = p_re * q_im + p_im * q_re;
    return (re * d_re + im * d_im) / (d_re * d_re + d_im * d_im);
  };
  std::size_t k = 0;
  for (; k + 4 <= size_; k += 4)
    for (std::size_t lane = 0; lane < 4; ++lane) sum[lane] += term(k + lane);
  for (; k < size_; ++k) sum[0] += term(k);
  return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}

double pole_radius(double a, double x) {
  const double inverse = 1 / a, remainder = std::fma(-inverse, a, 1.0) / a;
  return std::pow(std::abs(x), inverse) * (1 + remainder * std::log(std::abs(x)));
}

double versine(double x) {
  const double half = 0.5 * std::sqrt(std::abs(x)), root = x < 0 ? std::sin(half) : std::sinh(half);
  return x == 0 ? 0.5 : 2 * root * root / std::abs(x);
}

Poles::Poles(const HankelContour& contour, double a, double x) : a_(a) {
  if (x > 0) {
    const double radius = pole_radius(a, x);
    add(contour, radius, 0, 1, 1);
    // At a = 2 these meet on the cut, where their factor is 0.
    if (a > 2) add(contour, radius, 2 * pi / a, std::cos(2 * pi / a), 2);
  } else if (x < 0 && a >= least_pole_order) {
    add(contour, pole_radius(a, x), pi / a, cosine_of_pole(a), 2);
  }
}

void Poles::add(const HankelContour& contour, double radius, double argument, double cosine, int count) {
  const Complex s(radius * cosine, radius * std::sin(argument));
  if (s.real() > -745) poles_[size_++] = {s, contour.parameter(s), radius, argument, count};
}

HankelContour::Grid Poles::grid(const HankelContour& contour) const {
  const Pole* nearest = nullptr;
  for (std::size_t i = 0; i < size_; ++i)
    if (!nearest || std::abs(poles_[i].u.imag()) < std::abs(nearest->u.imag())) nearest = &poles_[i];
  return nearest ? contour.grid_away_from(nearest->u) : HankelContour::on_axis;
}

double Poles::residues(const HankelContour& contour, HankelContour::Grid grid, double b, Count count) const {
  double sum = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const Pole& pole = poles_[i];
    const Complex factor =
        count == Count::rest ? contour.pole_factor(pole.u, grid) : contour.pole_factor_less_one(pole.u, grid);
    if (factor == 0.0) continue;
    // One exponent: e^s alone may exceed the largest double.
    const double size = std::exp(b == 1 ? pole.s.real() : pole.s.real() + (1 - b) * std::log(pole.radius)) / a_;
    const double turn = pole.s.imag() + (1 - b) * pole.argument;
    sum += pole.count * size * product({std::cos(turn), std::sin(turn)}, factor).real();
  }
  return sum;
}

}  // namespace ricochet::fractional
