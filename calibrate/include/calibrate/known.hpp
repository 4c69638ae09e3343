#pragma once

#include <calibrate/calibration.hpp>
#include <calibrate/direct_calibrator.hpp>
#include <ricochet/collision/scale_and_loss.hpp>

#include <optional>
#include <string_view>
#include <variant>

namespace ricochet::calibration {

/// What is known of a contact instead of a `Target`: see ricochet/collision/scale_and_loss.hpp.
struct Known {
  Scale scale;
  Loss loss;
  Impact impact;
  Held held = {};  ///< what both leave open of the laws of real solids
};

/// 4π/3 r³ρ of a sphere [kg].
double sphere_mass(double radius, double density) noexcept;

/// "tcol", "stiffness", "young", "max_overlap".
std::string_view name(const Scale& scale) noexcept;
/// "en", "loss_factor", "damping_ratio", "alpha".
std::string_view name(const Loss& loss) noexcept;

/// What is told of an e_n out of reach said of the loss from which that e_n came; anything else as it is.
Infeasible in_terms_of(Infeasible missed, const Loss& loss);

/// What it comes to for one law and end: the target, and for the fractional law the k to hold where the scale is a
/// stiffness. Infeasible where the loss is past `loss_limit`, e_n below 1e-300, or where no double carries the law.
/// Throws std::invalid_argument for a value outside its domain, a law that has no such loss, and a scale whose t_col is
/// not in [1e-30, 1e30] s.
std::variant<Request, Infeasible> request_of(LawKind law, ContactEnd end, const Known& known);
/// The same with the tables of the direct method: microseconds instead of milliseconds, but for an overlap, which takes
/// one collision.
std::variant<Request, Infeasible> request_of(LawKind law, ContactEnd end, const Known& known,
                                             const DirectCalibrator& calibrator);

/// `calibrate` of that request. The answer's `achieved` is what it does; its target is in `request_of`.
Outcome calibrate(LawKind law, ContactEnd end, const Known& known, const Settings& settings = {});

}  // namespace ricochet::calibration
