// Every number that a run writes, against what is known of the motion by another way.
#include "console/temporary_folder.hpp"
#include <catch2/catch.hpp>
#include <simulate/run.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::simulate;

namespace {

using std::numbers::pi;
using Lines = std::vector<std::string>;

Lines split(const std::string& text, char separator) {
  Lines parts;
  std::stringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

/// A run in a folder that is gone afterwards.
struct Written {
  Lines trajectory, energy, contacts;

  explicit Written(const std::string& scene) {
    const TemporaryFolder folder;
    REQUIRE(run(read_scene("s.json", scene), folder.path(), false) == 0);
    for (const auto& [lines, name] : {std::pair(&trajectory, "trajectory.xyz"), std::pair(&energy, "energy.csv"),
                                      std::pair(&contacts, "contacts.csv")}) {
      *lines = split(read_file(folder / name), '\n');
    }
  }
};

std::vector<double> numbers(const Lines& fields, std::size_t from = 0) {
  std::vector<double> all;
  for (std::size_t i = from; i < fields.size(); ++i) all.push_back(std::stod(fields[i]));
  return all;
}

void check_close(const std::vector<double>& found, const std::vector<double>& known, double relative) {
  REQUIRE(found.size() == known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i] == Approx(known[i]).epsilon(relative).margin(1e-14));
  }
}

double mass(double radius, double density) { return 4.0 / 3 * pi * radius * radius * radius * density; }

/// A sphere (r = 0.01 m, 2000 kg/m³) that touches a wall at 1 ms with (vx, 0, −1) m/s; k makes the collision of the
/// undamped linear law take 2 ms.
constexpr double r = 0.01, density = 2000;
double stiffness() { return mass(r, density) * std::pow(pi / 2e-3, 2); }
std::string bounce(double c, const std::string& end, const std::string& friction, double vx,
                   const std::string& duration) {
  std::ostringstream scene;
  scene.precision(17);
  scene << R"({"duration": )" << duration << R"(, "output_interval": 0.0005, "step": 2e-6,
    "materials": {"grain": {"density": 2000}, "plate": {}},
    "interactions": [{"between": ["grain", "plate"], "law": {"name": "linear", "k": )"
        << stiffness() << R"(, "c": )" << c << R"(, "end": ")" << end << R"("})" << friction << R"(}],
    "spheres": [{"radius": 0.01, "material": "grain", "position": [0, 0, 0.011], "velocity": [)"
        << vx << R"(, 0, -1]}], "walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "plate"}]})";
  return scene.str();
}

}  // namespace

TEST_CASE("a trajectory holds positions, velocities and spins of its own time, radii and masses, in SI units") {
  const Written out(R"({"duration": 0.2, "output_interval": 0.1, "step": 0.001, "gravity": [0, 0, -9.81],
    "materials": {"a": {"density": 2000}, "b": {"density": 500}},
    "interactions": [{"between": ["a", "b"], "law": {"name": "hysteretic", "k1": 1, "k2": 1}}],
    "spheres": [
      {"radius": 0.01, "material": "a", "position": [0.1, 0.2, 1], "velocity": [1, -2, 3], "spin": [4, 5, -6]},
      {"radius": 0.02, "material": "b", "position": [5, 6, 7]}]})");
  REQUIRE(out.trajectory.size() == 12);
  REQUIRE(out.energy.size() == 4);
  CHECK(out.energy[0] ==
        "t [s],kinetic [J],gravity [J],stored [J],lost_normal [J],lost_friction [J],total [J],contacts,strained [J],"
        "walls [J],brought [J],spheres");
  const double m = mass(0.01, 2000), heavy = mass(0.02, 500), g = 9.81, inertia = 0.4 * m * 0.01 * 0.01;
  for (std::size_t frame = 0; frame < 3; ++frame) {
    CAPTURE(frame);
    // A free fall is met exactly by the scheme.
    const double t = 0.1 * static_cast<double>(frame), fallen = 0.5 * g * t * t, vz = 3 - g * t;
    CHECK(out.trajectory[4 * frame] == "2");
    const std::string& about = out.trajectory[4 * frame + 1];
    // Without walls the box is what the spheres take at the start: x from 0.09 to 5.02, …
    CHECK(about.find("Lattice=\"4.9") == 0);
    CHECK(about.find("Origin=\"0.09000000000000001 0.19 0.99\" ") != std::string::npos);
    CHECK(about.find("Properties=species:S:1:pos:R:3:radius:R:1:mass:R:1:velo:R:3:angular_velocity:R:3:id:I:1 Time=") !=
          std::string::npos);
    CHECK(about.find(R"( pbc="F F F")") != std::string::npos);
    CHECK(std::stod(about.substr(about.find("Time=") + 5)) == Approx(t).margin(1e-15));
    const Lines first = split(out.trajectory[4 * frame + 2], ' '), second = split(out.trajectory[4 * frame + 3], ' ');
    CHECK(first[0] == "a");
    CHECK(second[0] == "b");
    check_close(numbers(first, 1), {0.1 + t, 0.2 - 2 * t, 1 + 3 * t - fallen, 0.01, m, 1, -2, vz, 4, 5, -6, 1}, 1e-12);
    check_close(numbers(second, 1), {5, 6, 7 - fallen, 0.02, heavy, 0, 0, -g * t, 0, 0, 0, 2}, 1e-12);
    const double kinetic = 0.5 * m * (1 + 4 + vz * vz) + 0.5 * inertia * (16 + 25 + 36) + 0.5 * heavy * g * t * g * t;
    const double potential = m * g * (1 + 3 * t - fallen) + heavy * g * (7 - fallen);
    check_close(numbers(split(out.energy[frame + 1], ',')),
                {t, kinetic, potential, 0, 0, 0, kinetic + potential, 0, 0, 0, 0, 2}, 1e-12);
  }
}

TEST_CASE("a collision is written with its times, its end and its phases, and its energy goes over into the spring") {
  const Written out(bounce(0, "force", "", 0, "0.004"));
  REQUIRE(out.contacts.size() == 2);
  CHECK(out.contacts[0] == "i,j,t_begin [s],t_end [s],t_separation [s],ended,phases");
  const Lines row = split(out.contacts[1], ',');
  CHECK(row[0] == "1");
  CHECK(row[1] == "wall1");
  // Half a period of the spring; second order in a step of a 1000th of it.
  check_close({std::stod(row[2]), std::stod(row[3]), std::stod(row[4])}, {1e-3, 3e-3, 3e-3}, 1e-6);
  const Lines phases = split(row[6], ';');
  REQUIRE(phases.size() == 2);
  CHECK(phases[0].find("compression ") == 0);
  CHECK(phases[1].find(" decompression ") == 0);
  CHECK(std::stod(phases[0].substr(12)) == Approx(1e-3).epsilon(1e-6));
  CHECK(std::stod(phases[1].substr(15)) == Approx(2e-3).epsilon(1e-6));
  const double all = 0.5 * mass(r, density);
  for (std::size_t n = 0; n <= 8; ++n) {
    CAPTURE(n);
    const double t = 5e-4 * static_cast<double>(n), phase = pi / 2e-3 * std::clamp(t - 1e-3, 0.0, 2e-3);
    const double stored = all * std::pow(std::sin(phase), 2);
    const auto found = numbers(split(out.energy[n + 1], ','));
    CHECK(found[0] == Approx(t));
    CHECK(found[1] == Approx(all - stored).margin(1e-5 * all));
    CHECK(found[3] == Approx(stored).margin(1e-5 * all));
    CHECK(found[6] == Approx(all).epsilon(1e-5));
    CHECK(found[7] == (n > 2 && n < 6 ? 1 : found[7]));
  }
}

TEST_CASE("what dashpot and friction took stands in its own column") {
  // Ended by force e = exp(−β/√(1−β²) (π − atan(2β√(1−β²)/(1−2β²)))), after Schwager & Pöschel, Granular Matter 9,
  // 465 (2007); gross sliding loses μ(1+e)m v_n (u_t − (7/4) μ(1+e)v_n).
  const double m = mass(r, density), beta = 0.1, c = 2 * beta * std::sqrt(m * stiffness()), mu = 0.05, vx = 2;
  const double root = std::sqrt(1 - beta * beta);
  const double e = std::exp(-beta / root * (pi - std::atan2(2 * beta * root, 1 - 2 * beta * beta)));
  const double push = mu * (1 + e);
  const Written out(bounce(c, "force", R"(, "friction": {"mu_static": 0.05})", vx, "0.004"));
  const auto last = numbers(split(out.energy.back(), ','));
  CHECK(last[4] == Approx(0.5 * m * (1 - e * e)).epsilon(1e-4));
  // The arm of friction is shorter than r by half the overlap, here 3 % of r at most: the slip slows down later.
  CHECK(last[5] == Approx(push * m * (vx - 1.75 * push)).epsilon(3e-3));
  const auto sphere = numbers(split(out.trajectory.back(), ' '), 1);
  CHECK(sphere[5] == Approx(vx - push).epsilon(1e-5));
  CHECK(sphere[7] == Approx(e).epsilon(1e-5));
  CHECK(sphere[9] == Approx(2.5 * push / r).epsilon(0.03));
  CHECK(split(out.contacts[1], ',')[6].find("sliding") != std::string::npos);
}

TEST_CASE("a contact that is still open when the run ends has a row without an end") {
  const Written out(bounce(0, "force", "", 0, "0.002"));
  REQUIRE(out.contacts.size() == 2);
  const Lines row = split(out.contacts[1], ',');
  CHECK(std::stod(row[2]) == Approx(1e-3).epsilon(1e-6));
  CHECK(row[3].empty());
  CHECK(row[4].empty());
  CHECK(row[5] == "open");
}

TEST_CASE("a step may be a 20th of the shortest collision, and no more") {
  const auto with_step = [](double share) {
    std::string scene = bounce(0, "force", "", 0, "0.004");
    const double tcol = 2e-3;
    const std::string was = "\"step\": 2e-6";
    return scene.replace(scene.find(was), was.size(), "\"step\": " + std::to_string(share * tcol));
  };
  CHECK_NOTHROW(read_scene("s.json", with_step(1 / 20.2)));
  CHECK_THROWS_WITH(read_scene("s.json", with_step(1 / 19.8)), Catch::Contains("a 20th of the 0.002 s that"));
}

TEST_CASE("a step resolves the walls that swing") {
  const auto with_step = [](const std::string& step) {
    return read_scene("s.json", R"({"duration": 0.001, )" + step + R"("materials": {"g": {"density": 2500}},
    "interactions": [{"between": ["g", "g"], "law": {"name": "linear", "k": 1e2, "c": 0}}],
    "walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "g",
               "oscillation": {"amplitude": [0, 0, 1e-5], "frequency": 50000}}],
    "spheres": [{"radius": 0.01, "material": "g", "position": [0, 0, 0.02]}]})");
  };
  CHECK(with_step("").options.step == Approx(2e-5 / 200));
  CHECK_NOTHROW(with_step("\"step\": 9.9e-7, "));
  CHECK_THROWS_WITH(with_step("\"step\": 1.01e-6, "),
                    Catch::EndsWith(" s, a 20th of the 2e-05 s that a wall takes to swing"));
}

TEST_CASE("what springs hold stands under its own name: both swing, along the normal with m, across it with (2/7) m") {
  constexpr double r = 0.002, k = 1e8, k_t = 3e7, away = 1, along = 0.1, t = 1.1e-6;
  const double m = 4.0 / 3 * pi * r * r * r * 2500, m_t = 2.0 / 7 * m;
  const Written run(R"({"duration": 1.1e-6, "materials": {"g": {"density": 2500}, "w": {}},
    "interactions": [{"between": ["g", "w"], "law": {"name": "linear", "k": 1e8, "c": 0},
                      "friction": {"mu_static": 1e6, "model": "linear", "k_t": 3e7, "torsion": false}},
                     {"between": ["g", "g"], "law": {"name": "linear", "k": 1e8, "c": 0}}],
    "walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "w"}],
    "spheres": [{"material": "g", "radius": 0.002, "position": [0, 0, 0.002], "velocity": [0.1, 0, -1]}]})");
  const Lines names = split(run.energy.front(), ','), values = split(run.energy.back(), ',');
  const auto column = [&](const std::string& name) {
    return std::stod(values.at(static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())));
  };
  const auto held = [t](double mass, double stiffness, double speed) {
    const double s = std::sin(std::sqrt(stiffness / mass) * t);
    return 0.5 * mass * speed * speed * s * s;
  };
  CHECK(column("stored [J]") == Approx(held(m, k, away)).epsilon(2e-3));
  CHECK(column("strained [J]") == Approx(held(m_t, k_t, along)).epsilon(2e-3));
  CHECK(column("total [J]") == Approx(0.5 * m * (away * away + along * along)).epsilon(1e-3));
}
