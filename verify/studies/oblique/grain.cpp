#include "grain.hpp"

#include <verify/study.hpp>

#include <ricochet/collision/damping_ratio.hpp>

#include <console/csv.hpp>

#include <cmath>
#include <numbers>

namespace ricochet::verify::oblique {

namespace {

using std::numbers::pi;

double mass() { return 4.0 / 3 * pi * radius * radius * radius * density; }
double in_degrees(double radians) { return radians * 180 / pi; }

}  // namespace

ObliqueImpact at_angle(double degrees) {
  const double angle = degrees * pi / 180;
  return {.i = {mass(), radius, {speed * std::sin(angle), 0, speed * std::cos(angle)}, {}}};
}

std::array<Contact, 3> contacts() {
  const Friction friction(mu, mu, 0);
  return {Contact{"rigid", Linear(1.72e7, 0), {RigidTangential{}, friction}},
          Contact{"linear", Linear(1.72e7, 0), {LinearTangential(1.48e7), friction}},
          Contact{"mindlin", Tsuji(4.1968e9, 0), {MindlinTangential(5.4084e9), friction}}};
}

Contact chung_ooi() {
  const double young = 380e9, poisson = 0.23, shear = young / (2 * (1 + poisson));
  const double k = 4.0 / 3 * young / (1 - poisson * poisson) * std::sqrt(radius);
  const double c = damping_of_restitution(0.98, ContactEnd::force) * std::sqrt(5 * mass() * k);
  return {"mindlin", Tsuji(k, c), {MindlinTangential::of(shear / (2 - poisson), radius), Friction(mu, mu, 0)}};
}

Rebound rebound(const Contact& contact, double degrees) {
  const ObliqueImpact impact = at_angle(degrees);
  const ObliqueCollision out = collide(contact.normal, contact.tangential, impact);
  const Vec3 v = out.velocity_i;
  // Without v_t the limit of small angles is as good: e_t is a ratio.
  const double et = out.et ? *out.et : rebound(contact, 1e-6).et;
  return {et, -out.spin_i.y, in_degrees(std::atan2(v.x, -v.z)),
          in_degrees(std::atan2(v.x + radius * out.spin_i.y, -v.z))};
}

std::vector<Point> read_points(const std::string& file) {
  constexpr std::array columns{console::CsvColumn{"quantity", "", true},
                               console::CsvColumn{"impact_angle_deg", "", true}, console::CsvColumn{"value", "", true}};
  console::CsvReader source(data_folder() + "/" + file, columns);
  std::vector<Point> points;
  while (source.next()) points.push_back({std::string(source.text(0)), source.number(1), source.number(2)});
  return points;
}

double value_of(const Rebound& r, const std::string& quantity, bool of_contact_point) {
  if (quantity == "et") return r.et;
  if (quantity == "spin") return r.spin;
  return of_contact_point ? r.contact_angle : r.angle;
}

}  // namespace ricochet::verify::oblique
