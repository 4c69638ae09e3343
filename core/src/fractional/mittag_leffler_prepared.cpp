#include "mittag_leffler_prepared.hpp"

#include "reciprocal_gamma.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::fractional {

using std::numbers::pi;

PreparedMittagLeffler::PreparedMittagLeffler(double a, double b)
    : a_(a),
      b_(b),
      contour_(contour_for(b)),
      cosine_(cosine_of_pole(a)),
      sine_(std::sin(pi / a)),
      turn_((1 - b) * (pi / a)),
      inverse_(1 / a),
      inverse_low_(std::fma(-inverse_, a, 1.0) / a) {
  for (int k = 0; k < 3; ++k) gamma_[static_cast<std::size_t>(k)] = reciprocal_gamma_of_difference(b, k * a);
  for (double x : {-100.0, -10.0, -0.5, 0.5, 5.0}) {  // one in every range that Form::choose tells apart
    const Form form = Form::choose(a, b, x);
    if (std::none_of(forms_.begin(), forms_.end(), [&](const FormNodes& f) { return f.form == form; }))
      forms_.push_back({form,
                        {Nodes(contour_, HankelContour::on_axis, a, b, form),
                         Nodes(contour_, HankelContour::off_axis, a, b, form)}});
  }
  if (a >= 1) prepare_near();
  if (a >= least_pole_order && b <= 4) prepare_far();  // for larger b, |s^{1−b}| at the poles exceeds E
}

void PreparedMittagLeffler::prepare_near() {
  const auto f = [&](double x) { return by_contour(x, Poles::Count::rest); };
  double low = near;
  while (low < top) {
    near_panels_.emplace_back(f, low, low + width);
    low += width;
  }
}

void PreparedMittagLeffler::prepare_far() {
  const auto f = [&](double z) { return by_contour(-z, Poles::Count::rest_less_one); };
  // From |x|^{1/a} = 40 + 2b on, 16 terms of the series with the best remainder polynomial are below 1e-17.
  far_ = std::min(1e6, std::pow(40 + 2 * b_, a_));
  double low = -near;
  while (low < far_) {
    const double middle = low * std::numbers::sqrt2;
    far_panels_.emplace_back(f, low, middle);
    far_panels_.emplace_back(f, middle, 2 * low);
    low *= 2;
  }
  if (far_ < 1e6) prepare_series();
}

// rest = w/Γ(b−a) + w²·series(w), w = −1/x, wherever the leading term may vanish; else rest = w·series(w).
void PreparedMittagLeffler::prepare_series() {
  const Form form = Form::choose(a_, b_, -far_);
  split_ = form.shifts == 2;
  const auto f = [&](double w) {
    const double x = -1 / w;
    if (!split_) return by_contour(x, Poles::Count::rest_less_one) / w;
    const Poles poles(contour_, a_, x);
    const HankelContour::Grid grid = poles.grid(contour_);
    return nodes(form, grid).integral(x) - gamma_[2] +
           x * x * poles.residues(contour_, grid, b_, Poles::Count::rest_less_one);
  };
  series_.emplace(f, 0.0, 1 / far_);
}

double PreparedMittagLeffler::value(double x) const {
  if (x == 0) return gamma_[0];
  if (a_ == 2 && b_ == 3) return versine(x);
  if (b_ < least_second && std::abs(x) < 1) return by_contour(x, Poles::Count::rest);
  if (x >= near && !near_panels_.empty()) return near_panels_[static_cast<std::size_t>((x - near) / width)](x);
  if (x < near && !far_panels_.empty()) return pole_pair(x) + rest(x);
  return by_contour(x, Poles::Count::rest);
}

double PreparedMittagLeffler::pole_pair(double x) const {
  const double z = -x, log_z = std::log(z);
  const double radius = std::pow(z, inverse_) * (1 + inverse_low_ * log_z);
  const double fall = radius * cosine_;
  if (fall < -745) return 0;
  const double power = b_ == 1 ? 1.0 : std::exp((1 - b_) * inverse_ * log_z);
  return 2 / a_ * power * std::exp(fall) * std::cos(radius * sine_ + turn_);
}

double PreparedMittagLeffler::rest(double x) const {
  const double z = -x;
  if (z >= far_ && series_) {
    const double w = 1 / z;
    return split_ ? w * (gamma_[1] + w * (*series_)(w)) : w * (*series_)(w);
  }
  int octave = 0;
  const double mantissa = std::frexp(z / -near, &octave);  // z/16 = mantissa·2^octave, ½ ≤ mantissa < 1
  return far_panels_[2 * static_cast<std::size_t>(octave - 1) + (mantissa >= std::numbers::sqrt2 / 2 ? 1 : 0)](z);
}

double PreparedMittagLeffler::by_contour(double x, Poles::Count count) const {
  const Poles poles(contour_, a_, x);
  const HankelContour::Grid grid = poles.grid(contour_);
  const Form form = Form::choose(a_, b_, x);
  const auto gamma = [&](int k) { return gamma_[static_cast<std::size_t>(k)]; };
  return assemble(x, form, nodes(form, grid).integral(x), gamma) + poles.residues(contour_, grid, b_, count);
}

const Nodes& PreparedMittagLeffler::nodes(Form form, HankelContour::Grid grid) const {
  return std::find_if(forms_.begin(), forms_.end(), [&](const FormNodes& f) { return f.form == form; })->on[grid];
}

}  // namespace ricochet::fractional
