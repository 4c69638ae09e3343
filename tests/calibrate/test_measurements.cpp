// Lab files as `calibrate --fit` reads them, and what flights of a bouncing ball say.
#include "console/temporary_folder.hpp"

#include <calibrate/flights.hpp>
#include <catch2/catch.hpp>
#include <console/exit.hpp>
#include <measurements.hpp>

#include <cmath>

using namespace ricochet::calibration;

namespace {

Measured reading(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder / "lab.csv";
  std::ofstream(path) << text;
  try {
    return read_measurements(path);
  } catch (const ricochet::console::BadInput& bad) {
    const std::string said = bad.what();
    throw ricochet::console::BadInput(said.substr(said.rfind('/') + 1));
  }
}

}  // namespace

TEST_CASE("a restitution of more than 1 is no measurement") {
  CHECK(reading("velocity,en\n1,1\n").data.at(0).en == 1);
  CHECK_THROWS_WITH(reading("velocity,en\n1,1\n2,1.0000001\n"), "lab.csv:3: en = 1.0000001: must be in (0, 1]");
  CHECK_THROWS_WITH(reading("velocity,en\n1,1.05\n"), "lab.csv:2: en = 1.05: must be in (0, 1]");
  CHECK_THROWS_WITH(reading("velocity,en\n1,0\n"), "lab.csv:2: en = 0: must be in (0, 1]");
  CHECK_THROWS_WITH(reading("v,v1\n1,1.05\n"), "lab.csv:2: rebound_velocity = 1.05: must be at most the velocity");
}

TEST_CASE("two flights, one after the other, are their ratio") {
  const Bounce b = bounce_between({0, 0.5, 1, 0.002}, {0.5, 0.4, 1, 0.002});
  CHECK(b.en == Approx(0.8).epsilon(1e-15));
  CHECK(b.velocity == Approx(9.80665 * 0.25).epsilon(1e-15));
  // e = 1 − (a − b)/c with a = 0.5 ± √2 0.002 in the numerator and in c, as the instants err.
  CHECK(b.en_sigma == Approx(0.002 / 0.5 * std::sqrt(2 + 2 * 0.64)).epsilon(1e-14));
}

TEST_CASE("runs of flights give the restitution that made them, exactly where it is constant") {
  // 0.3 s and 0.9 of it each time: three flights, two that nobody timed, three more.
  const Flights first{1, 0.3 + 0.27 + 0.243, 3}, second{1 + 0.813 + 0.2187 + 0.19683, 0.177147 * 2.71, 3};
  const Bounce b = bounce_between(first, second);
  CHECK(b.en == Approx(0.9).epsilon(1e-14));
  CHECK(b.velocity == Approx(9.80665 / 4 * (0.3 + 0.19683)).epsilon(1e-14));
  // A ball that loses nothing flies as long as ever.
  const Bounce kept = bounce_between({0, 1, 4}, {2, 1, 4});
  CHECK(kept.en == 1);
  CHECK(kept.velocity == Approx(9.80665 * 0.25 / 2));
}

TEST_CASE("the error of a restitution from flights is that of its four instants") {
  const Flights before{0, 2.501, 10, 0.001}, after{4.835, 2.177, 10, 0.001};
  constexpr double h = 1e-5;
  double square = 0;
  for (int instant = 0; instant < 4; ++instant) {
    const auto moved = [&](double by) {
      Flights a = before, b = after;
      if (instant == 0) a.start += by, a.length -= by;
      if (instant == 1) a.length += by;
      if (instant == 2) b.start += by, b.length -= by;
      if (instant == 3) b.length += by;
      return bounce_between(a, b).en;
    };
    square += std::pow(0.001 * (moved(h) - moved(-h)) / (2 * h), 2);
  }
  CHECK(bounce_between(before, after).en_sigma == Approx(std::sqrt(square)).epsilon(1e-6));
}

TEST_CASE("flights that no bouncing ball makes are named") {
  CHECK_THROWS_WITH(bounce_between({0, 0, 1}, {1, 1, 1}), "length of flights = 0: must be finite and > 0");
  CHECK_THROWS_WITH(bounce_between({0, 1, 1}, {1, 1, 2}), "count of flights = 2: must be that of the flights before");
  CHECK_THROWS_WITH(bounce_between({1, 1, 1}, {1, 1, 1}), "start of flights = 1: must be later than that before");
  CHECK_THROWS_WITH(bounce_between({0, 1, 1}, {1, 1.1, 1}), "mean flight = 1.1: must be at most that before");
  CHECK_THROWS_WITH(bounce_between({0, 3, 3}, {0.5, 1, 3}), "end of flights = 1.5: must be later than that before");
}

TEST_CASE("the steel ball's restitutions are those of its flights by hand") {
  const auto data = read_measurements(RICOCHET_SOURCE_DIR "/data/flights_steel_ball.csv").data;
  REQUIRE(data.size() == 8);
  // From the first two runs, e^10 = 1 − (2.501 − 2.177)/4.835, and from the last two, 1 − (0.309 − 0.213)/1.442.
  CHECK(data[0].en == Approx(std::pow(1 - 0.324 / 4.835, 0.1)).epsilon(1e-12));
  CHECK(data[7].en == Approx(std::pow(1 - 0.096 / 1.442, 0.1)).epsilon(1e-12));
  CHECK(data[0].velocity == Approx(1.186847).epsilon(1e-6));
  CHECK(data[7].velocity == Approx(0.132353).epsilon(1e-5));
  CHECK(data[0].en_sigma == 0);
  CHECK(data[0].line == 7);
}

TEST_CASE("flights of several drops are read by their series, with their errors") {
  const Measured read = reading(
      "trial,Flight (ms),time_error [ms],mass [g]\na,500,2,10\na,400,2,10\na,330,2,10\nb,450,2,10\nb,350,2,10\n");
  REQUIRE(read.data.size() == 3);
  CHECK(read.data[0].en == Approx(0.8));
  CHECK(read.data[0].en_sigma == Approx(0.8 * 0.002 * std::sqrt(1 / 0.25 + 1 / 0.16)));  // of two flights, ± 2 ms each
  CHECK(read.data[1].en == Approx(0.825));
  CHECK(read.data[2].en == Approx(35.0 / 45));
  CHECK(read.data[2].velocity == Approx(9.80665 * 0.225));
  CHECK(read.data[2].mass_eff == Approx(0.005));
  CHECK(read.data[2].line == 6);
  CHECK(read.notes.at(0) ==
        "restitutions and velocities are those of flights at 9.80665 m/s^2, each from two rows; neighbours share one, "
        "and its error with opposite signs");
}

TEST_CASE("what is wrong with flights is named by its line") {
  const std::string runs = "bounce_start,bounce_end,bounces\n0,2.5,10\n";
  CHECK_THROWS_WITH(reading("flight_time\n0.5\n0.6\n"),
                    "lab.csv:3: flight_time = 0.6: must be such that flights do "
                    "not grow, or in another series");
  CHECK_THROWS_WITH(reading("flight_time\n0.5\n"), "lab.csv:3: no rows: must be two flights of a series at least");
  CHECK_THROWS_WITH(reading("start,end\n0,1\n"),
                    "lab.csv:1: column bounces: missing: must be given with bounce_start and bounce_end");
  CHECK_THROWS_WITH(reading("flight_time,en_sigma\n0.5,1\n"),
                    "lab.csv:1: column en_sigma: must be left out with flights");
  CHECK_THROWS_WITH(reading("flight_time [ms],time_sigma\n0.5,1\n"),
                    "lab.csv:1: column time_sigma: unit missing: must be given in the head of all times, or of none");
  CHECK_THROWS_WITH(reading(runs + "5,7,8\n"),
                    "lab.csv:3: bounces = 8: must be that of the row before, or in another "
                    "series");
  CHECK_THROWS_WITH(reading(runs + "5,5,10\n"), "lab.csv:3: bounce_end = 5: must be later than bounce_start");
  CHECK_THROWS_WITH(reading(runs + "-1,1,10\n"),
                    "lab.csv:3: bounce_start = -1: must be later than in the row before, or in another series");
  CHECK_THROWS_WITH(reading(runs + "1,2,10\n"),
                    "lab.csv:3: bounce_end = 2: must be later than in the row before, or in another series");
  CHECK_THROWS_WITH(reading(runs + "5,7,1.5\n"), "lab.csv:3: bounces = 1.5: must be a whole number from 1 to 1e6");
}

TEST_CASE("flights beside a restitution are not read, nor are speeds beside flights") {
  const auto notes = reading("velocity,en,flight_time,series\n1,0.5,0.4,a\n").notes;
  CHECK(notes.at(0) == "columns that are not read: flight_time, series");
  const Measured read = reading("flight_time,velocity,bounces\n0.5,9,1\n0.4,9,1\n");
  CHECK(read.data.at(0).velocity == Approx(9.80665 * 0.25));
  CHECK(read.notes.at(0) == "columns that are not read: velocity, bounces");
}
