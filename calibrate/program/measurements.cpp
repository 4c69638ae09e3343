#include "measurements.hpp"

#include <calibrate/flights.hpp>
#include <calibrate/known.hpp>
#include <console/exit.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::calibration {
namespace {

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
  flight_time,
  bounce_start,
  bounce_end,
  bounces,
  time_sigma,
  series,
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
    {.name = "diameter", .unit = "m", .aliases = "d"},
    {.name = "flight_time", .unit = "s", .aliases = "flight,time of flight"},
    {.name = "bounce_start", .unit = "s", .aliases = "start,t_start,start time"},
    {.name = "bounce_end", .unit = "s", .aliases = "end,t_end,end time"},
    {.name = "bounces", .aliases = "number of bounces"},
    {.name = "time_sigma", .unit = "s", .aliases = "time_error"},
    {.name = "series", .aliases = "trial,run"}};

/// Do these columns make a restitution of flights, and no other?
bool by_flights(const auto& file) {
  return !file.has(en) && !file.has(rebound_height) && !file.has(rebound_velocity) &&
         (file.has(flight_time) || (file.has(bounce_start) && file.has(bounce_end)));
}

/// A file and what its columns amount to.
class Reader {
 public:
  Reader(const std::string& path, const Shots& shots)
      : file_(path, columns, console::Unknown::ignored), shots_(shots) {}

  Measured all() {
    check_head();
    Measured measured;
    if (by_flights(file_))
      add_bounces(measured.data);
    else
      while (file_.next()) measured.data.push_back(row());
    if (measured.data.empty())
      file_.fail(by_flights(file_) ? "no rows: must be two flights of a series at least"
                                   : "no rows: must be a header with velocity and en, and measurements");
    auto left = file_.ignored();
    for (const std::string& name : needless()) left.push_back(name);
    if (!left.empty()) measured.notes.push_back(fmt::format("columns that are not read: {}", fmt::join(left, ", ")));
    if (by_flights(file_))
      measured.notes.push_back(
          fmt::format("restitutions and velocities are those of flights at {} m/s^2, each from two "
                      "rows; neighbours share one, and its error with opposite signs",
                      console::shortest(standard_gravity)));
    else if (!file_.has(velocity))
      measured.notes.push_back(
          fmt::format("velocities are those of a fall at {} m/s^2", console::shortest(standard_gravity)));
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
    if (by_flights(file_)) {
      add_present(names, {velocity, drop_height});
      if (file_.has(flight_time)) add_present(names, {bounce_start, bounce_end, bounces});
    } else {
      add_present(names, {flight_time, bounce_start, bounce_end, bounces, time_sigma, series});
    }
    return names;
  }
  void add_present(std::vector<std::string>& names, std::initializer_list<std::size_t> some) const {
    for (const std::size_t column : some)
      if (file_.has(column)) names.emplace_back(columns[column].name);
  }
  bool by_height() const { return !file_.has(en) && file_.has(rebound_height); }

  void check_head() const {
    if (!file_.any()) file_.fail("no rows: must be a header with velocity and en, and measurements");
    if (by_flights(file_)) {
      check_flights();
    } else {
      need({velocity, drop_height}, "drop_height");
      need({en, rebound_height, rebound_velocity}, "rebound_height or rebound_velocity, or flight_time");
    }
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

  void check_flights() const {
    for (const std::size_t column : {en_sigma, tcol, tcol_sigma})
      if (file_.has(column)) file_.fail(fmt::format("column {}: must be left out with flights", columns[column].name));
    if (!file_.has(flight_time) && !file_.has(bounces))
      file_.fail("column bounces: missing: must be given with bounce_start and bounce_end");
    const std::size_t of = file_.has(flight_time) ? flight_time : bounce_start;
    for (const std::size_t column : {bounce_end, time_sigma})
      if (file_.has(column) && (column == time_sigma || of == bounce_start) &&
          file_.states_unit(column) != file_.states_unit(of))
        file_.fail(fmt::format("column {}: unit missing: must be given in the head of all times, or of none",
                               columns[file_.states_unit(of) ? column : of].name));
  }

  /// A row of flights. Single ones follow each other: where `before` ends.
  Flights flights(const std::optional<Flights>& before) const {
    Flights f;
    if (file_.has(time_sigma)) f.sigma = number(time_sigma);
    if (file_.has(flight_time)) {
      f.length = number(flight_time);
      if (before) f.start = before->start + before->length;
      f.sigma /= std::sqrt(2.0);  // of the flight, which has two ends
      return f;
    }
    f.start = file_.number(bounce_start, "a number in [-1e30, 1e30]");
    if (!(std::abs(f.start) <= 1e30)) file_.reject(bounce_start, "a number in [-1e30, 1e30]");
    f.length = file_.number(bounce_end, "later than bounce_start") - f.start;
    if (!(f.length > 0 && f.length <= 1e30)) file_.reject(bounce_end, "later than bounce_start");
    f.count = file_.number(bounces, "a whole number from 1 to 1e6");
    if (!(f.count >= 1 && f.count <= 1e6 && f.count == std::floor(f.count)))
      file_.reject(bounces, "a whole number from 1 to 1e6");
    if (!before) return f;
    if (f.count != before->count) file_.reject(bounces, "that of the row before, or in another series");
    if (!(f.start > before->start)) file_.reject(bounce_start, "later than in the row before, or in another series");
    if (!(f.start + f.length > before->start + before->length))
      file_.reject(bounce_end, "later than in the row before, or in another series");
    return f;
  }

  /// One of each two rows that follow each other in a series.
  void add_bounces(std::vector<Measurement>& data) {
    std::optional<Flights> before;
    std::string last;
    while (file_.next()) {
      if (file_.has(series) && file_.text(series) != last) before.reset();
      if (file_.has(series)) last = file_.text(series);
      const Flights here = flights(before);
      if (before) data.push_back(bounce(*before, here));
      before = here;
    }
  }

  Measurement bounce(const Flights& before, const Flights& after) const {
    const std::size_t column = file_.has(flight_time) ? flight_time : bounce_end;
    if (after.mean() > before.mean()) file_.reject(column, "such that flights do not grow, or in another series");
    const Bounce b = bounce_between(before, after);
    if (!(b.en > 0 && b.velocity >= 1e-30 && b.velocity <= 1e30)) file_.reject(column, "a flight of a bouncing ball");
    Measurement m{.velocity = b.velocity, .en = b.en, .en_sigma = b.en_sigma};
    m.line = file_.line();
    add_bodies(m);
    return m;
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
    m.velocity = file_.has(velocity) ? number(velocity) : std::sqrt(2 * standard_gravity * number(drop_height));
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
    return known.has(en) || known.has(rebound_height) || known.has(rebound_velocity) || by_flights(known);
  } catch (const console::BadInput&) {
    return false;
  }
}

Measured read_measurements(const std::string& path, const Shots& shots) { return Reader(path, shots).all(); }

}  // namespace ricochet::calibration
