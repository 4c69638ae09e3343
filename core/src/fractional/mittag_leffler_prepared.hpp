#pragma once

#include "mittag_leffler_integral.hpp"
#include <ricochet/support/panel.hpp>

#include <array>
#include <optional>
#include <vector>

namespace ricochet::fractional {

/// E_{a,b} for many x. For a ≥ 1, near zero (−16 ≤ x) by polynomials of E. Farther out, for a ≥ least_pole_order, by
/// the pair of poles in closed form plus polynomials of the rest, which does not oscillate: on half octaves of −x, and
/// past `far`, where the rest is a power series in 1/x to rounding, one polynomial in −1/x. What remains goes by the
/// sum over the contour with its node values prepared. The polynomials interpolate values of that sum.
class PreparedMittagLeffler {
 public:
  PreparedMittagLeffler(double a, double b);

  double a() const noexcept { return a_; }
  double b() const noexcept { return b_; }
  double value(double x) const;

 private:
  static constexpr double near = -16, width = 2, top = 6;

  double by_contour(double x, Poles::Count count) const;
  double pole_pair(double x) const;
  double rest(double x) const;
  const Nodes& nodes(Form form, HankelContour::Grid grid) const;
  void prepare_near();
  void prepare_far();
  void prepare_series();

  struct FormNodes {
    Form form;
    std::array<Nodes, 2> on;
  };

  double a_, b_;
  const HankelContour& contour_;
  std::array<double, 3> gamma_{};  // 1/Γ(b − ka)
  std::vector<FormNodes> forms_;
  std::vector<support::Panel> near_panels_, far_panels_;
  std::optional<support::Panel> series_;
  double far_ = 0;
  bool split_ = false;
  double cosine_, sine_, turn_, inverse_, inverse_low_;  // of the poles' angle π/a, and of 1/a
};

}  // namespace ricochet::fractional
