#pragma once

#include <memory>

namespace ricochet {

/// The fractional contact that ends by force, as functions of its restitution: for calibrating many targets. Piecewise
/// polynomials through values of `conversion_degree` and `fractional_contact`, computed when the table is made (some
/// 50 ms); a look-up takes some 50 ns. Error: 1e-12 in α, 1e-11 relative in z_star and the greatest overlap and force,
/// 1e-12 in overlap_end; proved against the slow path in tests/contact. Immutable, cheap to copy, thread-safe.
class FractionalContactTable {
 public:
  struct Entry {
    double alpha;        ///< conversion degree
    double z_star;       ///< A t_col^{2−α}
    double overlap_end;  ///< [v₀ t_col]
    double max_overlap;  ///< [v₀ t_col]
    double max_force;    ///< [m v₀/t_col]
  };
  static constexpr double least_en = 0.006;

  FractionalContactTable();

  /// 0.006 ≤ e_n ≤ 1; throws std::invalid_argument otherwise.
  Entry operator()(double en) const;

 private:
  struct Panels;
  std::shared_ptr<const Panels> panels_;
};

}  // namespace ricochet
