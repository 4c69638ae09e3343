#pragma once

#include "hankel_contour.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ricochet::fractional {

/// How the integrand of (1/2πi) ∫ e^s s^{a−b}/(s^a − x) ds is written, so that no digit is lost.
struct Form {
  int shifts = 0;  ///< how often E_{a,b} = (E_{a,b−a} − 1/Γ(b−a))/x is applied before integrating; −1: backwards
  bool near_one = false;  ///< the integrand of E_{1,m} is subtracted
  int m = 1;              ///< integer near b
  /// s^a/(s^a − x) is written as (1 − x (s^a − 1)/(s^a − x))/(1 − x), whose first part integrates to a 1/Γ. What is
  /// left is of order a, as E_{a,a} is, where a sum over the plain integrand, which is of order 1, would leave no
  /// digits of it.
  bool near_zero = false;

  static Form choose(double a, double b, double x);
  bool operator==(const Form&) const = default;
};

/// The integrand of one form on one grid, in arrays that the compiler can sum over in lanes.
class Nodes {
 public:
  Nodes(const HankelContour& contour, HankelContour::Grid grid, double a, double b, Form form);

  double integral(double x) const {
    return form_.near_one ? integral_near_one(x) : integral_plain(form_.near_zero ? x - 1 : x);
  }

 private:
  using Row = ContourNodes::Row;
  void fill(const ContourNodes& nodes, double a, double b);
  void fill_near_zero(const ContourNodes& nodes, double a, double b);
  void fill_near_one(const ContourNodes& nodes, double a, double b);
  void multiply_by_power(const ContourNodes& nodes, double exponent);
  void multiply(int times, const Row& q_re, const Row& q_im);
  double integral_plain(double x) const;
  double integral_near_one(double x) const;

  std::size_t size_;
  Form form_;
  Row pole_re_, pole_im_, re_, im_;          // s^a, near zero s^a − 1; the numerator
  Row linear_re_, linear_im_, s_re_, s_im_;  // only near one
};

/// The poles of 1/(s^a − x) on the principal sheet, as far as the rule does not integrate them by itself.
class Poles {
 public:
  Poles(const HankelContour& contour, double a, double x);

  /// The grid that keeps clear of the pole nearest the contour.
  HankelContour::Grid grid(const HankelContour& contour) const;

  /// Σ of the residues s^{1−b} e^s/a times the contour's factor, or its factor less one.
  enum class Count { rest, rest_less_one };
  double residues(const HankelContour& contour, HankelContour::Grid grid, double b, Count count) const;

 private:
  struct Pole {
    Complex s, u;
    double radius, argument;  // of s
    int count;                // 2: with its conjugate
  };
  void add(const HankelContour& contour, double radius, double argument, double cosine, int count);

  double a_;
  std::size_t size_ = 0;
  std::array<Pole, 2> poles_{};
};

/// cos(π/a), to full relative accuracy also near a = 2, where a radius of a thousand multiplies it.
inline double cosine_of_pole(double a) { return std::sin(0.5 * std::numbers::pi * (a - 2) / a); }

/// |x|^{1/a}, with the rounding of 1/a made good, which a phase |x|^{1/a} sin(π/a) of thousands would feel.
double pole_radius(double a, double x);

/// E_{2,3}(x) = (1 − cos √−x)/(−x): its zeros are double, so nothing but a square keeps their digits.
double versine(double x);

/// Puts E together from its integral: undoes the shifts, adds E_{1,m} near one. gamma(k) = 1/Γ(b − ka), k = 0, 1, 2.
template <class Gamma>
double assemble(double x, Form form, double integral, const Gamma& gamma) {
  if (form.near_zero)  // (E_{a,b−a} − 1/Γ(b−a))/x with the two parts put together: the x cancels
    return (gamma(form.shifts) - (form.shifts == 0 ? x : 1.0) * integral) / (1 - x);
  double value = integral;
  if (form.shifts < 0) value = gamma(0) + x * value;
  for (int k = form.shifts; k > 0; --k) value = (value - gamma(k)) / x;
  if (form.near_one) value += form.m == 0 ? x * std::exp(x) : std::exp(x);
  return value;
}

/// Below this a the pair of poles at x < 0 is so near the cut that the rule integrates it to rounding.
inline constexpr double least_pole_order = 1.05;

/// Below this a the integrand differs from a constant times e^s s^{−b} by so little that the constant is taken out.
inline constexpr double least_plain_order = 0.1;

/// Below this b, E near x = 0 is as small as 1/Γ(b) ≈ b, and the first term of its series is kept apart.
inline constexpr double least_second = 0.3;

}  // namespace ricochet::fractional
