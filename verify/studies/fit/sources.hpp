#pragma once

#include <calibrate/fit.hpp>

#include <array>
#include <string>
#include <vector>

namespace ricochet::verify {

/// A file of data/ with restitutions at speeds, and what is drawn of it.
struct Source {
  std::string file, label;
  bool measured = true;  ///< false: a published fit, sampled, without any noise
};
const std::vector<Source>& sources();

/// Its rows; a bouncing ball's as its flights tell them.
std::vector<calibration::Measurement> read(const Source& source);

/// Every law, and the fractional one with an α that follows the speed.
std::vector<calibration::Fit> all_fits(const std::vector<calibration::Measurement>& data);

/// The one of these that is of that law; throws std::logic_error where there is none.
const calibration::Fit& fit_of(const std::vector<calibration::Fit>& fits, LawKind law, bool alpha_of_speed = false);

/// e_n along the normal of an oblique impact, from its tangential restitution e_t and the angle of its rebound, as the
/// velocities make it: tan(rebound) = (e_t/e_n) tan(impact).
struct NormalRestitution {
  double angle;      ///< of the impact [degrees]
  double velocity;   ///< along the normal [m/s]
  double en, sigma;  ///< σ of an angle that is off by `reading_error`
};
inline constexpr double reading_error = 0.3;  ///< [degrees], see data/oblique_kharaz2001_second_reading.csv

/// Of Kharaz's alumina at 3.9 m/s, at the angles of one reading of the figures; e_t is taken between its own angles.
std::vector<NormalRestitution> alumina(const std::string& file);

}  // namespace ricochet::verify
