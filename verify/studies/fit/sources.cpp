#include "sources.hpp"

#include "../paper.hpp"

#include <verify/registry.hpp>

#include <calibrate/flights.hpp>
#include <console/csv.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace ricochet::verify {
namespace {

using namespace calibration;

// Any mass will do where there are no collision times: e_n then depends on the combinations that the fit reports.
constexpr double mass = paper::pair.impact.mass_eff;

constexpr double radian = std::numbers::pi / 180;

std::string path_of(const std::string& file) { return data_folder() + "/" + file + ".csv"; }

std::vector<Measurement> of_flights(const std::string& path) {
  constexpr std::array columns{console::CsvColumn{"bounce_start", "s", true},
                               console::CsvColumn{"bounce_end", "s", true}, console::CsvColumn{"bounces", "", true}};
  console::CsvReader file(path, columns);
  std::vector<Measurement> data;
  std::optional<Flights> before;
  while (file.next()) {
    const Flights here{file.number(0), file.number(1) - file.number(0), file.number(2)};
    if (before) {
      const Bounce b = bounce_between(*before, here);
      data.push_back({b.velocity, b.en});
    }
    before = here;
  }
  return data;
}

/// Between its neighbours, along a straight line; nothing outside.
std::optional<double> between(const std::vector<std::pair<double, double>>& points, double x) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [a, ya] = points[i - 1];
    const auto [b, yb] = points[i];
    if (x >= a && x <= b) return std::lerp(ya, yb, (x - a) / (b - a));
  }
  return std::nullopt;
}

}  // namespace

const std::vector<Source>& sources() {
  static const std::vector<Source> all{
      {"restitution_ice_bridges1984", "frosted ice, 210 K (Bridges et al. 1984, their fit)", false},
      {"restitution_ice_hatzes1988", "compacted frost, 123 K (Hatzes et al. 1988, their fit)", false},
      {"restitution_ice_supulver1995", "frost-free ice, 100 K (Supulver et al. 1995, their fit)", false},
      {"flights_steel_ball", "a steel ball on metallic glass (an amateur's sound track)"}};
  return all;
}

std::vector<Measurement> read(const Source& source) {
  if (source.measured) return of_flights(path_of(source.file));
  constexpr std::array columns{console::CsvColumn{"velocity", "m/s", true}, console::CsvColumn{"en", "", true}};
  console::CsvReader file(path_of(source.file), columns);
  std::vector<Measurement> data;
  while (file.next()) data.push_back({file.number(0), file.number(1)});
  return data;
}

std::vector<Fit> all_fits(const std::vector<Measurement>& data) {
  std::vector<Fit> fits;
  for (const LawKind law : LawKind::all()) fits.push_back(fit_law({law, ContactEnd::force, mass}, data));
  fits.push_back(fit_law({kind_of<Fractional>, ContactEnd::force, mass, true}, data));
  return fits;
}

const Fit& fit_of(const std::vector<Fit>& fits, LawKind law, bool alpha_of_speed) {
  const auto found = std::find_if(fits.begin(), fits.end(), [&](const Fit& fit) {
    return fit.request.law == law && fit.request.alpha_of_speed == alpha_of_speed;
  });
  if (found == fits.end()) throw std::logic_error("no fit of that law");
  return *found;
}

std::vector<NormalRestitution> alumina(const std::string& file) {
  constexpr std::array columns{console::CsvColumn{"quantity", "", true},
                               console::CsvColumn{"impact_angle_deg", "", true}, console::CsvColumn{"value", "", true}};
  constexpr double speed = 3.9;
  console::CsvReader reader(path_of(file), columns);
  std::vector<std::pair<double, double>> et, angle;
  while (reader.next()) {
    if (reader.text(0) == "et") et.emplace_back(reader.number(1), reader.number(2));
    if (reader.text(0) == "angle") angle.emplace_back(reader.number(1), reader.number(2));
  }
  std::vector<NormalRestitution> found;
  for (const auto& [before, after] : angle) {
    const auto tangential = between(et, before);
    if (!tangential) continue;
    const double en = *tangential * std::tan(radian * before) / std::tan(radian * after);
    found.push_back({before, speed * std::cos(radian * before), en,
                     en * 2 * radian * reading_error / std::sin(2 * radian * after)});
  }
  return found;
}

}  // namespace ricochet::verify
