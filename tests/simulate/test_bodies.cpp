// Walls of every form, periodic space, starts, and spheres that come and go: from the scene to the files.
#include "../../simulate/src/state_file.hpp"
#include "complaints.hpp"
#include "console/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <console/exit.hpp>
#include <console/json.hpp>
#include <simulate/run.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace ricochet;
using namespace ricochet::simulate;
namespace fs = std::filesystem;

namespace {

std::string scene_of(const std::string& bodies, const std::string& duration = "0.01") {
  return R"({"duration": )" + duration + R"(, "gravity": [0, 0, -9.81],
  "materials": {"glass bead": {"density": 2500}, "steel": {}},
  "interactions": [
    {"between": ["glass bead", "glass bead"], "law": {"name": "linear", "k": 1e4, "c": 0.3},
     "friction": {"mu_static": 0.4, "model": "linear", "k_t": 8000, "c_t": 0.2}},
    {"between": ["glass bead", "steel"], "law": {"name": "linear", "k": 1e4, "c": 0.3},
     "friction": {"mu_static": 0.4, "model": "linear", "k_t": 8000, "c_t": 0.2}}],
  )" + bodies +
         "}";
}

Scene read(const std::string& bodies, const std::string& duration = "0.01") {
  return read_scene("s.json", scene_of(bodies, duration));
}

std::string complaint(const std::string& bodies) { return complaint_of(scene_of(bodies)); }

const std::string bead = R"("spheres": [{"radius": 0.01, "material": "glass bead", "position": [0, 0, 0]}], )";

std::string hopper(const std::string& number) {
  return R"("pour": [{"number": )" + number +
         R"(, "rate": 2000, "begin": 0.005, "material": "glass bead", "seed": 5,
     "radius": {"distribution": "uniform", "low": 0.0015, "high": 0.002}, "velocity": [0, 0, -0.5],
     "region": {"low": [-0.01, -0.01, 0.03], "high": [0.01, 0.01, 0.05]}}],
  "cones": [{"name": "funnel", "from": [0, 0, 0], "to": [0, 0, 0.02], "radii": [0.007, 0.02], "material": "steel"},
            {"from": [0, 0, 0.02], "to": [0, 0, 0.06], "radii": [0.02, 0.02], "material": "steel"}],
  "outlets": [{"point": [0, 0, -0.005], "inward": [0, 0, 2]}])";
}

}  // namespace

TEST_CASE("walls of every form are read, named by kind and side, and move as they say") {
  const Scene scene = read(bead + R"(
    "walls": [{"point": [0, 0, -1], "inward": [0, 0, 3], "material": "steel", "name": "floor", "velocity": [1, 2, 0]},
              {"point": [0, 0, 1], "inward": [0, 0, -1], "material": "steel", "spin": 2}],
    "boxes": [{"low": [-1, -2, -3], "high": [4, 5, 6], "material": "steel"}],
    "cylinders": [{"point": [0, 0, 0], "axis": [0, 2, 0], "radius": 0.5, "material": "steel", "spin": -3}],
    "cones": [{"from": [0, 0, -0.2], "to": [0, 0, 0.1], "radii": [0.1, 0.4], "material": "steel"}],
    "rings": [{"point": [0, 0, -0.3], "axis": [0, 0, 1], "radii": [0.02, 0.4], "material": "steel"}],
    "plates": [{"corner": [0.2, 0, 0], "edges": [[0.1, 0, 0], [0, 0.2, 0]], "material": "steel", "name": "paddle",
                "oscillation": {"amplitude": [0, 0, 0.01], "frequency": 5}}])");
  CHECK(scene.wall_names == std::vector<std::string>{"floor", "wall2", "box1 low x", "box1 high x", "box1 low y",
                                                     "box1 high y", "box1 low z", "box1 high z", "cylinder1", "cone1",
                                                     "ring1", "paddle"});
  const auto& walls = scene.setup.walls;
  CHECK(walls[0].motion.velocity == Vec3{1, 2, 0});
  CHECK(walls[1].motion.spin == 2);
  CHECK(walls[3].point.x == 4);
  CHECK(walls[3].inward == Vec3{-1, 0, 0});
  CHECK(std::get<surface::Cylinder>(walls[8].form).radius == 0.5);
  CHECK(walls[8].motion.spin == -3);
  const auto cone = std::get<surface::Cone>(walls[9].form);
  CHECK(cone.length == Approx(0.3));
  CHECK(cone.last == 0.4);
  CHECK(std::get<surface::Cone>(walls[10].form).length == 0);
  CHECK(std::get<surface::Plate>(walls[11].form).second == Vec3{0, 0.2, 0});
  CHECK(walls[11].motion.frequency == 5);
  CHECK(scene.cell_low == Vec3{-1, -2, -3});
  CHECK(scene.cell_high == Vec3{4, 5, 6});
}

TEST_CASE("walls that cannot be are refused where they stand") {
  const auto of = [](const std::string& walls) { return complaint(bead + walls); };
  CHECK(of(R"("cones": [{"from": [0, 0, 1], "to": [0, 0, 1], "radii": [1, 1], "material": "steel"}])") ==
        "/cones/0/to = [0,0,1]: must be another point than from");
  CHECK(of(R"("cones": [{"from": [0, 0, 1], "to": [0, 0, 2], "radii": [0, 1], "material": "steel"}])") ==
        "/cones/0/radii = [0,1]: must be two radii > 0");
  CHECK(of(R"("cones": [{"from": [0, 0, 1], "to": [0, 0, 2], "radii": 1, "material": "steel"}])") ==
        "/cones/0/radii = 1: must be two radii [a, b]");
  CHECK(of(R"("rings": [{"point": [0, 0, 1], "axis": [0, 0, 2], "radii": [1, 1], "material": "steel"}])") ==
        "/rings/0/radii = [1,1]: must be an inner radius, 0 of a disc, and a greater outer one");
  CHECK(of(R"("cylinders": [{"point": [0, 0, 1], "axis": [0, 0, 0], "radius": 1, "material": "steel"}])") ==
        "/cylinders/0/axis = [0,0,0]: must be a direction, not zero");
  CHECK(of(R"("cylinders": [{"point": [0, 0, 1], "axis": [0, 0, 1], "radius": 0.01, "material": "steel"}])") ==
        "/: a sphere of radius 0.01 m is no smaller than the radius of cylinder1, 0.01 m; it must be smaller");
  CHECK(of(R"("plates": [{"corner": [0, 0, 1], "edges": [[1, 0, 0], [1, 1, 0]], "material": "steel"}])") ==
        "/plates/0/edges = [[1,0,0],[1,1,0]]: must be at right angles");
  CHECK(of(R"("plates": [{"corner": [0, 0, 1], "edges": [[1, 0, 0]], "material": "steel"}])") ==
        "/plates/0/edges = [[1,0,0]]: must be two edges [[x, y, z], [x, y, z]]");
  CHECK(of(R"("plates": [{"corner": [0, 0, 1], "edges": [[1, 0, 0], [0, 1, 0]], "material": "steel", "spin": 1}])")
            .find("unknown key \"spin\"") != std::string::npos);
  CHECK(of(R"("walls": [{"point": [0, 0, -1], "inward": [0, 0, 1], "material": "steel", "name": "1"}])") ==
        "/walls/0/name = \"1\": must be a name that begins with a letter, without , ; and quotes");
  CHECK(of(R"("walls": [{"point": [0, 0, -1], "inward": [0, 0, 1], "material": "steel", "name": "a"},
                        {"point": [0, 0, -2], "inward": [0, 0, 1], "material": "steel", "name": "a"}])") ==
        "/walls/1: another wall is named \"a\"; names must differ");
  CHECK(of(R"("outlets": [{"point": [0, 0, -1], "inward": [0, 0, 0]}])") ==
        "/outlets/0/inward = [0,0,0]: must be a direction, not zero");
}

TEST_CASE("periodic borders are read, and refused where they are too near or walls do not go on") {
  const Scene scene = read(bead + R"("periodic": {"x": [-0.1, 0.2], "z": [0, 0.05]})");
  CHECK(scene.setup.periodic.period == Vec3{0.2 + 0.1, 0, 0.05});
  CHECK(complaint(bead + R"("periodic": {"x": [-0.02, 0.02]})") ==
        "/periodic/x = [-0.02,0.02]: must be borders more than 0.0469 m apart, two diameters");
  // Of a radius of 0.01: more than 4.671 of it, which no width of that many digits passes by.
  CHECK(complaint(bead + R"("periodic": {"x": [0, 0.0467]})") ==
        "/periodic/x = [0,0.0467]: must be borders more than 0.0469 m apart, two diameters");
  CHECK(complaint(bead + R"("periodic": {"x": [0, 0.0469]})") == "accepted");
  CHECK(complaint(bead + R"("periodic": {"x": [1, 0]})") ==
        "/periodic/x = [1,0]: must be two borders [low, high], low < high");
  CHECK(complaint(bead + R"("periodic": {"x": 1})") == "/periodic/x = 1: must be two borders [low, high]");
  CHECK(complaint(bead + R"("periodic": {"z": [-1, 1]}, "walls": [{"point": [0, 0, -1], "inward": [0, 0, 1],
    "material": "steel"}])") ==
        "/periodic: wall1 is not the same all along a periodic axis; it must be, as planes and cylinders along it are");
}

TEST_CASE("what falls through a periodic floor is written inside its box, by material and number") {
  const TemporaryFolder folder;
  const Scene scene = read(R"("periodic": {"z": [0, 0.1]}, "spheres": [
    {"radius": 0.01, "material": "glass bead", "position": [0, 0, 0.02]}])",
                           "0.2");
  REQUIRE(run(scene, folder.path(), false) == 0);
  std::istringstream lines(read_file(folder.path() / "trajectory.xyz"));
  std::string line;
  double greatest = 0, least = 1;
  while (std::getline(lines, line)) {
    REQUIRE(line == "1");
    std::getline(lines, line);
    REQUIRE(line.find(R"(Lattice="0.02 0 0 0 0.02 0 0 0 0.1" Origin="-0.01 -0.01 0" )") == 0);
    REQUIRE(line.find(R"( pbc="F F T")") != std::string::npos);
    std::getline(lines, line);
    std::istringstream words(line);
    std::string material;
    double x = 0, y = 0, z = 0;
    words >> material >> x >> y >> z;
    CHECK(material == "glass_bead");
    least = std::min(least, z), greatest = std::max(greatest, z);
    CHECK(line.substr(line.rfind(' ')) == " 1");
  }
  CHECK(least >= 0);
  CHECK(greatest < 0.1);
  CHECK(greatest > 0.08);
}

TEST_CASE("a packing goes on from a frame of its trajectory, overlaps and all") {
  const TemporaryFolder folder;
  const std::string box = R"("boxes": [{"low": [-0.02, -0.02, 0], "high": [0.02, 0.02, 0.1], "material": "steel"}])";
  const Scene poured = read(R"("pour": [{"number": 40, "material": "glass bead", "radius": 0.004,
    "region": {"low": [-0.02, -0.02, 0], "high": [0.02, 0.02, 0.06]}}], )" +
                                box,
                            "0.15");
  REQUIRE(run(poured, folder.path() / "poured", false) == 0);
  const auto from = [&](const std::string& frame) {
    return read_scene((folder.path() / "scene.json").string(),
                      scene_of(R"("start": {"trajectory": "poured/trajectory.xyz")" + frame + "}, " + box, "0.02"));
  };
  const Scene settled = from("");
  REQUIRE(settled.setup.spheres.size() == 40);
  CHECK(settled.remark.find("pairs overlap at the start, sphere ") != std::string::npos);
  Cluster cluster(settled.setup, settled.options);
  CHECK(cluster.contacts().size() > 10);
  CHECK(cluster.energy().stored > 0);
  // The masses, places and speeds of the last frame, to the last bit that was written.
  std::istringstream lines(read_file(folder.path() / "poured/trajectory.xyz"));
  std::string line, last;
  while (std::getline(lines, line)) last = line;
  const Sphere& s = settled.setup.spheres[39];
  std::istringstream words(last);
  std::string material;
  double x = 0, y = 0, z = 0, r = 0, m = 0, vx = 0;
  words >> material >> x >> y >> z >> r >> m >> vx;
  CHECK(s.position == Vec3{x, y, z});
  CHECK(s.radius == r);
  CHECK(s.mass() == Approx(m).epsilon(1e-15));
  CHECK(s.velocity.x == vx);
  const Scene first = from(R"(, "frame": 0)");
  for (std::size_t k = 0; k < 40; ++k) CHECK(first.setup.spheres[k].position == poured.setup.spheres[k].position);
  CHECK(first.fingerprint != settled.fingerprint);
  CHECK_THROWS_WITH(from(R"(, "frame": 101)"),
                    Catch::Contains("/start/frame = 101: must be less than 101, the number of "
                                    "frames in"));
  const auto with_file = [&](const std::string& text) {
    std::ofstream(folder.path() / "poured/trajectory.xyz") << text;
    try {
      from("");
    } catch (const console::BadInput& error) {
      const std::string message = error.what();
      return message.substr(message.find("trajectory.xyz") + 14);
    }
    return std::string("accepted");
  };
  const std::string about = "Properties=species:S:1:pos:R:3:radius:R:1:mass:R:1:velo:R:3:angular_velocity:R:3 Time=0\n";
  CHECK(with_file("1\n" + about + "glass_bead 0 0 0.05 0.01 1 0 0 0 0 0 0\n") == "accepted");
  CHECK(with_file("1\n" + about + "gold 0 0 0.05 0.01 1 0 0 0 0 0 0\n") ==
        ":3: gold: must be one of the materials of the scene");
  CHECK(with_file("1\n" + about + "steel 0 0 x 0.01 1 0 0 0 0 0 0\n") == ":3: x: must be a number");
  CHECK(with_file("1\n" + about + "steel 0 0 1 0 1 0 0 0 0 0 0\n") == ":3: radius and mass must be > 0");
  CHECK(with_file("1\n" + about + "steel 0 0\n") == ":3: 3 words; must be 12, as the properties say");
  CHECK(with_file("2\n" + about + "steel 0 0 0.05 0.01 1 0 0 0 0 0 0\n") ==
        ":3: the frame is cut short; it must have all its spheres");
  CHECK(with_file("one\n") == ":1: one: must be a number of spheres, as a frame begins");
  CHECK(with_file("1\nnothing\nsteel 0 0\n").find(":2: no \"Properties=\"") == 0);
  CHECK(with_file("1\nProperties=pos:R:3\nsteel 0 0\n").find(":2: no property \"species\"") == 0);
  const std::string narrow =
      "Properties=species:S:1:velo:R:3:radius:R:1:mass:R:1:angular_velocity:R:3:pos:R:1 Time=0\n";
  CHECK(with_file("1\n" + narrow + "steel 0 0 0 0.01 1 0 0 0 0\n") == ":2: property \"pos\": must be of 3 columns");
  const std::string wide = "Properties=species:S:1:pos:R:3:radius:R:3:mass:R:1:velo:R:3:angular_velocity:R:3 Time=0\n";
  CHECK(with_file("1\n" + wide + "steel 0 0 1 1 1 1 1 0 0 0 0 0 0\n") ==
        ":2: property \"radius\": must be of 1 column");
  CHECK(with_file("").find(": empty; must be a trajectory") == 0);
}

namespace {

// The rows of energy.csv: t, kinetic, gravity, stored, lost_normal, lost_friction, total, contacts, strained, walls,
// brought, spheres.
std::vector<std::vector<double>> energies(const TemporaryFolder& folder) {
  std::istringstream lines(read_file(folder / "energy.csv"));
  std::string line;
  std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
  }
  return rows;
}

}  // namespace

TEST_CASE("a frame for ParaView holds radius, mass, velocity and spin as the scene has them") {
  const TemporaryFolder folder;
  const Scene scene = read(R"("spheres": [{"radius": 0.01, "material": "glass bead", "position": [0, 0, 0],
    "velocity": [1, 2, 3], "spin": [4, 5, 6]}])");
  REQUIRE(run(
              scene, folder.path(), false, [] {}, Format::vtk) == 0);
  const std::string frame = read_file(folder / "vtk/spheres.000000.vtk");
  const auto behind = [&](const std::string& title) {
    REQUIRE(frame.find(title) != std::string::npos);
    return frame.substr(frame.find(title) + title.size());
  };
  const std::string scalar = " double 1\nLOOKUP_TABLE default\n";
  CHECK(behind("SCALARS radius" + scalar).starts_with("0.01\n"));
  // 4/3 pi r^3 rho
  CHECK(std::stod(behind("SCALARS mass" + scalar)) == Approx(0.010471975511965976).epsilon(1e-12));
  CHECK(behind("VECTORS velocity double\n").starts_with("1 2 3\n"));
  CHECK(behind("VECTORS spin double\n").starts_with("4 5 6\n"));
}

TEST_CASE("what a moving wall does stands in its column, and the columns make the total") {
  const TemporaryFolder folder;
  const Scene scene = read(R"("spheres": [{"radius": 0.01, "material": "glass bead", "position": [0, 0, 0.011]}],
    "walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "steel", "velocity": [0, 0, 1]}])");
  REQUIRE(run(scene, folder.path(), false) == 0);
  const auto rows = energies(folder);
  for (const auto& row : rows) {
    CHECK(row[10] == 0);  // nobody came
    const double sum = row[1] + row[2] + row[3] + row[8] + row[4] + row[5] - row[9];
    CHECK(row[6] == Approx(sum).margin(1e-12));
  }
  // A heavy wall at V gives a sphere at rest (1 + e) m V, and does V times that work, the weight aside.
  const double mass = scene.sphere(0).mass(), speed = std::sqrt(2 * rows.back()[1] / mass);
  CHECK(rows.back()[9] == Approx(mass * (speed + 9.81 * 0.01)).epsilon(0.02));
}

TEST_CASE("a pour's first sphere comes as it begins") {
  const TemporaryFolder folder;
  const Scene scene = read(R"("pour": [{"number": 3, "rate": 10, "begin": 0.005, "material": "glass bead", "seed": 5,
    "radius": 0.001, "region": {"low": [0, 0, 0], "high": [0.1, 0.1, 0.1]}}])");
  REQUIRE(run(scene, folder.path(), false) == 0);
  const auto rows = energies(folder);
  for (const auto& row : rows)
    if (row[0] < 0.005) CHECK(row[11] == 0);
  CHECK(rows.back()[11] == 1);  // the next would come at 0.105 s
}

TEST_CASE("spheres are poured over time and leave by an outlet, and the balance counts them") {
  const TemporaryFolder folder;
  REQUIRE(run(
              read(hopper("60"), "0.12"), folder.path(), false, [] {}, Format::vtk) == 0);
  const auto rows = energies(folder);
  REQUIRE(rows.size() == 101);
  double most = 0;
  for (const auto& row : rows) {
    most = std::max(most, row[11]);
    if (row[0] < 0.005) CHECK(row[11] == 0);
    CHECK(std::abs(row[6]) < 1e-3 * (std::abs(row[10]) + 1e-6));  // nobody was there: nothing to be kept
  }
  CHECK(most > 30);
  CHECK(rows.back()[11] < most);
  CHECK(rows.back()[10] > 0);
  const std::string contacts = read_file(folder.path() / "contacts.csv");
  CHECK(contacts.find("funnel") != std::string::npos);
  const console::Json series = console::Json::parse(read_file(folder.path() / "vtk/spheres.vtk.series"));
  REQUIRE(series.at("files").size() == 101);
  CHECK(series.at("files").at(100).at("name") == "spheres.000100.vtk");
  CHECK(series.at("files").at(100).at("time").get<double>() == Approx(0.12));
  // Each of those there at the end has its line in every part of the frame.
  const auto there = static_cast<std::size_t>(rows.back()[11]);
  const std::string frame = read_file(folder.path() / "vtk/spheres.000100.vtk");
  CHECK(frame.find("POINTS " + std::to_string(there) + " double") != std::string::npos);
  CHECK(static_cast<std::size_t>(std::count(frame.begin(), frame.end(), '\n')) == 8 + 1 + 1 + 8 + 2 + 8 * there);
}

TEST_CASE("a run that pours and loses spheres goes on to the same bytes wherever it was stopped") {
  const TemporaryFolder folder;
  const Scene scene = read(hopper("40"), "0.09");
  REQUIRE(run(
              scene, folder.path() / "whole", false, [] {}, Format::vtk) == 0);
  // One state after another is made the start of a run that ends at the next.
  const fs::path parts = folder.path() / "parts";
  Scene shorter = scene;
  for (const double share : {0.2, 0.45, 0.8, 1.0}) {
    shorter.steps = static_cast<std::uint64_t>(share * static_cast<double>(scene.steps));
    if (fs::exists(parts / "state.json")) {
      console::Json state = console::Json::parse(read_file(parts / "state.json"));
      state.at("complete") = false;
      state.at("checksum") = checksum(state);
      std::ofstream(parts / "state.json") << state;
    }
    REQUIRE(run(
                shorter, parts, fs::exists(parts / "state.json"), [] {}, Format::vtk) == 0);
  }
  // contacts.csv is another: a run that ends tells of contacts that last.
  for (const char* file : {"trajectory.xyz", "energy.csv", "vtk/spheres.000100.vtk", "vtk/spheres.vtk.series"})
    CHECK(read_file(parts / file) == read_file(folder.path() / "whole" / file));
}
