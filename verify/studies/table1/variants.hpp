#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/instant.hpp>
#include <ricochet/contact/fractional.hpp>

#include <string>

namespace ricochet::verify::table1 {

/// (59) holds the rate over each step, and the paper does not name the method that steps the motion. With three rates
/// to hold and two methods, neither known to be the paper's, these are what its Table I may have been made by.
enum class Held {
  left,  ///< the step's first rate, as (59) is written
  mean,  ///< the mean of its first and last
  chord  ///< the overlap's chord: L1
};
enum class Stepper { heun, rk4 };

struct Variant {
  Held held;
  Stepper stepper;
};
std::string name(Variant variant);

/// The motion m ζ'' = −c^α k^{1−α} D^α ζ from t_b on, at the end of `steps` > 0 equal steps to `time` [s]. D^α by (59),
/// Σ w_l [(t−t_l)^{1−α} − (t−t_{l+1})^{1−α}]/Γ(2−α) with the held rates w_l, at the stages of the running step by what
/// is known there. Orders in the step: left 1; mean and chord between 2−α, which the last steps leave of a held rate,
/// and 2, which its mean does. The force is that of the end, from whole steps.
/// Domain: 0 < α < 1.
Instant end_of(Variant variant, const Fractional& law, const Impact& impact, double time, int steps);

}  // namespace ricochet::verify::table1
