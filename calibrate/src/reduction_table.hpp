#pragma once

#include <ricochet/collision/reduction.hpp>
#include <ricochet/support/panel.hpp>

#include <cmath>
#include <vector>

namespace ricochet::calibration {

/// A PowerLaw's k and c in the units of the target (m = v₀ = t_col = 1) as functions of the loss λ = −ln e_n.
/// Where a Hertzian contact ends by force, at an overlap like λ (Kuwabara-Kono) or λ^{4/5} (Tsuji), fractional powers
/// of λ appear in both, so λ = 0 is a branch point: panels are octaves of λ (the Chebyshev coefficients of a function
/// singular at 0 fall by 5.8 each on [1, 2]) up to λ = 1/2, and of equal width from there on. They hold polynomials
/// through values of the numerical collision. Error: 1e-11 relative, 1e-14/λ more in c.
template <class Law>
class ReductionTable {
 public:
  static constexpr double least_loss = 0x1p-14;   ///< e_n = 0.99994
  static constexpr double greatest_loss = 5.375;  ///< e_n = 0.0046

  explicit ReductionTable(ContactEnd end);

  // loss = 0 or in [least_loss, greatest_loss)
  double stiffness(double loss) const { return loss == 0 ? elastic_ : panel(loss).k(loss); }
  ParameterValues<Law> operator()(double loss) const {
    if (loss == 0) return {elastic_, 0};
    const Pair& found = panel(loss);
    return {found.k(loss), loss * found.c_over_loss(loss)};
  }

 private:
  struct Pair {
    support::Panel k, c_over_loss;
  };

  static constexpr int octaves = 13;
  static constexpr double wide_from = 0.5, width = 0.375;

  static double low_edge(int i) { return i < octaves ? std::ldexp(least_loss, i) : wide_from + (i - octaves) * width; }
  const Pair& panel(double loss) const {
    const int i =
        loss < wide_from ? octaves + 1 + std::ilogb(loss) : octaves + static_cast<int>((loss - wide_from) / width);
    return panels_[static_cast<std::size_t>(i)];
  }

  double elastic_;
  std::vector<Pair> panels_;
};

}  // namespace ricochet::calibration
