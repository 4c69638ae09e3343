#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/fractional_contact_table.hpp>
#include <ricochet/support/panel.hpp>
#include <ricochet/support/require.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ricochet {

using support::Panel;

/// Half octaves of e_n downwards from 1: α(e_n) is singular at e_n = 0, and on [1, √2] of anything that lies at 0 the
/// Chebyshev coefficients fall by 11.6 each.
struct FractionalContactTable::Panels {
  struct HalfOctave {
    Panel alpha, z_star, overlap_end, max_overlap, max_force;
  };
  std::vector<HalfOctave> panels;

  Panels() {
    double high = 1;
    while (high > least_en) {
      panels.push_back(half_octave(high / std::numbers::sqrt2, high));
      panels.push_back(half_octave(high / 2, high / std::numbers::sqrt2));
      high /= 2;
    }
  }

  static HalfOctave half_octave(double low, double high) {
    Panel::Row alpha{}, z_star{}, overlap_end{}, max_overlap{}, max_force{};
    for (std::size_t j = 0; j < Panel::size; ++j) {
      const FractionalContact c = fractional_contact(conversion_degree(Panel::abscissa(j, low, high)));
      alpha[j] = c.alpha;
      z_star[j] = c.z_star;
      overlap_end[j] = c.overlap_end;
      max_overlap[j] = c.max_overlap;
      max_force[j] = c.max_force;
    }
    return {Panel(alpha, low, high), Panel(z_star, low, high), Panel(overlap_end, low, high),
            Panel(max_overlap, low, high), Panel(max_force, low, high)};
  }
};

FractionalContactTable::FractionalContactTable() : panels_(std::make_shared<Panels>()) {}

FractionalContactTable::Entry FractionalContactTable::operator()(double en) const {
  support::require(en >= least_en && en <= 1, "en", en, "in [0.006, 1]");
  int exponent = 0;
  const double mantissa = std::frexp(en, &exponent);  // e_n = mantissa·2^exponent, ½ ≤ mantissa < 1; 1 = ½·2
  const bool lower = mantissa < std::numbers::sqrt2 / 2;
  const auto index = static_cast<std::size_t>(std::max(0, 2 * -exponent + (lower ? 1 : 0)));
  const Panels::HalfOctave& p = panels_->panels[index];
  return {std::max(0.0, p.alpha(en)), p.z_star(en), p.overlap_end(en), p.max_overlap(en), p.max_force(en)};
}

}  // namespace ricochet
