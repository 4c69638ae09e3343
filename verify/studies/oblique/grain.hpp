#pragma once

#include <ricochet/collision/oblique.hpp>

#include <array>
#include <string>
#include <vector>

namespace ricochet::verify::oblique {

/// The aluminium oxide sphere of Kharaz, Gorham and Salman, Powder Technol. 120, 281 (2001): 5 mm, 4000 kg/m³, 3.9 m/s,
/// with the μ that all who compute it take.
inline constexpr double radius = 2.5e-3, density = 4000, speed = 3.9, mu = 0.092;

/// Against a wall, `degrees` from the normal, without spin.
ObliqueImpact at_angle(double degrees);

/// A pair of a normal and a tangential law, and whose it is.
struct Contact {
  std::string name;
  AnyLaw normal;
  TangentialContact tangential;
};

/// rigid, linear, mindlin. Both springs as MFiX's DEM05 has them (tests/dem/DEM05): k_n = 1.72e7, k_t = 1.48e7 N/m; and
/// by Hertz and Mindlin for aluminium oxide on glass, 4.1968e9 and 5.4084e9 N/m^(3/2). All without loss.
std::array<Contact, 3> contacts();

/// Aluminium oxide on a rigid plane, e_n = 0.98 by Tsuji's law and Mindlin's: test 4 of Chung & Ooi.
Contact chung_ooi();

/// What is measured of an impact; angles in degrees from the normal, spin as it is made by rolling onwards.
struct Rebound {
  double et = 0, spin = 0, angle = 0, contact_angle = 0;
};
Rebound rebound(const Contact& contact, double degrees);

/// One point read off a published figure.
struct Point {
  std::string quantity;  ///< "et", "spin", "angle"
  double degrees = 0, value = 0;
};
std::vector<Point> read_points(const std::string& file);
/// The quantity of a point; `of_contact_point`: its angle, not the centre's.
double value_of(const Rebound& rebound, const std::string& quantity, bool of_contact_point = false);

}  // namespace ricochet::verify::oblique
