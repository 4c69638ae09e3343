#include "measurements.hpp"

#include <calibrate/known.hpp>
#include <console/exit.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::calibration {
namespace {

constexpr double gravity = 9.80665;  // [m/s²], the standard one

enum Column : std::size_t {
  velocity,
  drop_height,
  en,
  rebound_height,
  rebound_velocity,
  en_sigma,
  tcol,
  tcol_sigma,
  mass,
  radius,
  diameter,
  count
};
constexpr std::array<console::CsvColumn, count> columns{
    console::CsvColumn{.name = "velocity",
                       .unit = "m/s",
                       .aliases = "v,v0,v_n,v_in,v_i,speed,impact velocity,impact speed,velocity in"},
    {.name = "drop_height", .unit = "m", .aliases = "h,h0,height,drop,fall height"},
    {.name = "en", .aliases = "e,e_n,cor,restitution,coefficient of restitution,restitution coefficient"},
    {.name = "rebound_height", .unit = "m", .aliases = "h1,h_r,bounce height,rebound"},
    {.name = "rebound_velocity", .unit = "m/s", .aliases = "v1,v_r,v_out,rebound speed,velocity out"},
    {.name = "en_sigma", .aliases = "e_sigma,sigma,sigma_e,sigma_en,en_error,e_error,std,sd,standard deviation"},
    {.name = "tcol", .unit = "s", .aliases = "t_c,t_col,collision time,contact time,contact duration"},
    {.name = "tcol_sigma", .unit = "s", .aliases = "sigma_t,sigma_tcol,tcol_error"},
    {.name = "mass", .unit = "kg", .aliases = "m"},
    {.name = "radius", .unit = "m", .aliases = "r"},
    {.name = "diameter", .unit = "m", .aliases = "d"}};

/// A file and what its columns amount to.
class Reader {
 public:
  Reader(const std::string& path, const Shots& shots)
      : file_(path, columns, console::Unknown::ignored), shots_(shots) {}

  Measured all() {
    check_head();
    Measured measured;
    while (file_.next()) measured.data.push_back(row());
    if (measured.data.empty()) file_.fail("no rows: must be a header with velocity and en, and measurements");
    auto left = file_.ignored();
    for (const std::string& name : needless()) left.push_back(name);
    if (!left.empty()) measured.notes.push_back(fmt::format("columns that are not read: {}", fmt::join(left, ", ")));
    if (!file_.has(velocity))
      measured.notes.push_back(fmt::format("velocities are those of a fall at {} m/s^2", console::shortest(gravity)));
    return measured;
  }

 private:
  /// One of these must be there; the first of several is read.
  void need(std::initializer_list<std::size_t> choices, const char* others) const {
    if (std::none_of(choices.begin(), choices.end(), [&](std::size_t c) { return file_.has(c); }))
      file_.fail(fmt::format("column {}: missing: must be given, or {}", columns[*choices.begin()].name, others));
  }

  /// Known columns that another makes needless.
  std::vector<std::string> needless() const {
    std::vector<std::string> names;
    if (file_.has(velocity) && file_.has(drop_height) && !by_height()) names.emplace_back(columns[drop_height].name);
    for (const std::size_t column : {rebound_height, rebound_velocity})
      if (file_.has(column) && (file_.has(en) || (column == rebound_velocity && by_height())))
        names.emplace_back(columns[column].name);
    return names;
  }
  bool by_height() const { return !file_.has(en) && file_.has(rebound_height); }

  void check_head() const {
    if (!file_.any()) file_.fail("no rows: must be a header with velocity and en, and measurements");
    need({velocity, drop_height}, "drop_height");
    need({en, rebound_height, rebound_velocity}, "rebound_height or rebound_velocity");
    if (by_height() && !file_.has(drop_height))
      file_.fail("column drop_height: missing: must be given with rebound_height");
    if (file_.has(tcol) != file_.has(tcol_sigma)) file_.fail("tcol and tcol_sigma: must be given together");
    if (file_.has(tcol) && !file_.has(en_sigma))
      file_.fail("column en_sigma: missing: must be given with tcol, to weigh one against the other");
    if (file_.states_unit(tcol) && file_.has(tcol_sigma) && !file_.states_unit(tcol_sigma))
      file_.fail("column tcol_sigma: unit missing: must be given in the head, as tcol has one");
    if (file_.has(radius) && file_.has(diameter)) file_.fail("column = diameter: must be left out with radius");
    if ((file_.has(radius) || file_.has(diameter)) && !file_.has(mass) && !shots_.density)
      file_.fail("column mass: missing: must be given with radius or diameter, or --density");
  }

  double number(std::size_t column) const {
    const char* accepted = column == en ? "in (0, 1]" : "a number in [1e-30, 1e30]";
    const double value = file_.number(column, accepted);
    if (!(value > 0) || (column == en ? value > 1 : value < 1e-30 || value > 1e30)) file_.reject(column, accepted);
    return value;
  }

  double restitution(double impact_velocity) const {
    if (file_.has(en)) return number(en);
    const std::size_t column = by_height() ? rebound_height : rebound_velocity;
    const double ratio =
        column == rebound_height ? number(column) / number(drop_height) : number(column) / impact_velocity;
    if (ratio > 1) file_.reject(column, column == rebound_height ? "at most the drop height" : "at most the velocity");
    return column == rebound_height ? std::sqrt(ratio) : ratio;
  }

  /// The pair's mass and radius: those of the sphere before a wall, half of them between equals.
  void add_bodies(Measurement& m) const {
    const double share = shots_.wall ? 1 : 0.5;
    if (file_.has(radius)) m.radius_eff = share * number(radius);
    if (file_.has(diameter)) m.radius_eff = share * number(diameter) / 2;
    if (file_.has(mass)) m.mass_eff = share * number(mass);
    if (!file_.has(mass) && m.radius_eff > 0) m.mass_eff = share * sphere_mass(m.radius_eff / share, *shots_.density);
  }

  Measurement row() const {
    Measurement m{};
    m.line = file_.line();
    m.velocity = file_.has(velocity) ? number(velocity) : std::sqrt(2 * gravity * number(drop_height));
    m.en = restitution(m.velocity);
    if (file_.has(en_sigma)) m.en_sigma = number(en_sigma);
    if (file_.has(tcol)) m.tcol = number(tcol);
    if (file_.has(tcol_sigma)) m.tcol_sigma = number(tcol_sigma);
    add_bodies(m);
    return m;
  }

  console::CsvReader file_;
  const Shots& shots_;
};

}  // namespace

bool states_restitution(const std::string& path, const console::CsvHead& head) {
  try {
    const console::CsvColumns known(path, head, columns, console::Unknown::ignored);
    return known.has(en) || known.has(rebound_height) || known.has(rebound_velocity);
  } catch (const console::BadInput&) {
    return false;
  }
}

Measured read_measurements(const std::string& path, const Shots& shots) { return Reader(path, shots).all(); }

}  // namespace ricochet::calibration
