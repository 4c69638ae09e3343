// The page of --view, without a browser: what it reads, keeps and says. What it shows is tested in tests/browser.
#include "../../simulate/src/view/document.hpp"
#include "../../simulate/src/view/pack.hpp"
#include "../console/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <console/exit.hpp>
#include <simulate/view.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

using namespace ricochet;
using namespace ricochet::simulate;

namespace {

const std::string plain = "Properties=species:S:1:pos:R:3:radius:R:1 ";

std::string write(const TemporaryFolder& folder, const std::string& text) {
  std::ofstream(folder / "trajectory.xyz") << text;
  return folder / "trajectory.xyz";
}

/// Frames at 0, 1, 2, … s of one sphere that is at x = time.
std::string march(int frames) {
  std::string text;
  for (int k = 0; k < frames; ++k)
    text += "1\n" + plain + "Time=" + std::to_string(k) + "\nm0 " + std::to_string(k) + " 0 0 0.5\n";
  return text;
}

std::string element(const std::string& page, const std::string& id) {
  const auto begin = page.find('>', page.find("id=\"" + id + "\"")) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

/// Base64 read back by search in the alphabet, 16 bits a number.
std::vector<std::uint32_t> numbers_in(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : base64) {
    if (c == '=') break;
    word = word << 6 | static_cast<std::uint32_t>(digits.find(c)), bits += 6;
    if (bits >= 8) bits -= 8, bytes.push_back(static_cast<std::uint8_t>(word >> bits));
  }
  std::vector<std::uint32_t> numbers;
  for (std::size_t k = 0; k + 1 < bytes.size(); k += 2) numbers.push_back(bytes[k] + 256u * bytes[k + 1]);
  return numbers;
}

ClusterSetup with_walls(std::vector<Wall> walls) {
  ClusterSetup setup;
  setup.walls = std::move(walls);
  return setup;
}

bool has(const Polyline& line, Vec3 p) {
  return std::any_of(line.begin(), line.end(), [&](Vec3 q) { return norm(p - q) < 1e-12; });
}

}  // namespace

TEST_CASE("a trajectory is read by the names of its columns") {
  const TemporaryFolder folder;
  TrajectoryFile file(write(folder,
                            "2\nLattice=\"1 0 0 0 1 0 0 0 Time=9\" Time=0.5 "
                            "Properties=id:I:1:radius:R:1:velo:R:3:mass:R:1:species:S:1:pos:R:3\n"
                            "7 0.1 1 2 3 9 glass 4 5 6\n3 0.2 0 0 -1e-3 9 steel 0 0 0\n"
                            "0\nProperties=pos:R:3:radius:R:1 Time=1\n"));
  REQUIRE(file.size() == 2);
  const SeenFrame frame = file.frame(0);
  CHECK(frame.time == 0.5);
  CHECK(frame.grains[0].position == Vec3{4, 5, 6});
  CHECK(frame.grains[0].velocity == Vec3{1, 2, 3});
  CHECK(frame.grains[0].spin == Vec3{});
  CHECK(frame.grains[0].radius == 0.1);
  CHECK(frame.grains[0].id == 7);
  CHECK(frame.grains[1].velocity.z == -1e-3);
  CHECK(file.species() == std::vector<std::string>{"glass", "steel"});
  CHECK(file.frame(1).grains.empty());
}

TEST_CASE("what is wrong in a trajectory is told with its line") {
  const TemporaryFolder folder;
  const auto told = [&](const std::string& text) -> std::string {
    try {
      TrajectoryFile file(write(folder, text));
      for (std::size_t k = 0; k < file.size(); ++k) file.frame(k);
    } catch (const console::BadInput& e) {
      const std::string what = e.what();
      return what.substr(what.find("trajectory.xyz") + 14);
    }
    return "nothing";
  };
  CHECK(told(march(2)) == "nothing");
  CHECK(told("") == ": holds no frame");
  CHECK(told("x\n") == ":1: must be the number of spheres of a frame");
  CHECK(told(march(1) + "2\n" + plain + "Time=1\nm0 0 0 0 1\n") == ":4: the frame of 2 spheres is not whole");
  CHECK(told("1\n" + plain + "\nm0 0 0 0 1\n") == ":2: must hold Time=, a number");
  CHECK(told("1\nTime=0\nm0 0 0 0 1\n") == ":2: Properties: must hold pos in 3 columns");
  CHECK(told("1\nTime=0 Properties=pos:R:x\nm0\n") == ":2: Properties: must be name:type:columns, one after the other");
  CHECK(told("1\n" + plain + "Time=0\nm0 0 0 1\n") == ":3: 4 columns: must be 5, as Properties says");
  CHECK(told("1\n" + plain + "Time=0\nm0 0 0 nan 1\n") == ":3: nan: must be a finite number");
  CHECK(told("1\n" + plain + "Time=0\nm0 0 0 0 0\n") == ":3: the radius must be > 0");
  CHECK(told("1\nTime=0 Properties=pos:R:3:radius:R:1:id:I:1\n0 0 0 1 -2\n") == ":3: -2: must be a sphere's number");
}

TEST_CASE("a long run is thinned evenly, from its first frame to its last") {
  const TemporaryFolder folder;
  TrajectoryFile file(write(folder, march(101)));
  CHECK(read_motion(file, {}).frames.size() == 101);
  const ShownMotion thinned = read_motion(file, {}, 26);
  REQUIRE(thinned.frames.size() == 26);
  for (std::size_t k = 0; k < 26; ++k) CHECK(thinned.frames[k].time == 4 * static_cast<double>(k));
  CHECK(read_motion(file, {}, 1).frames.size() == 2);
  CHECK(read_motion(file, {}, 1).frames.back().time == 100);
  const ShownMotion uneven = read_motion(file, {}, 40);
  for (std::size_t k = 1; k < 40; ++k) {
    const double gap = uneven.frames[k].time - uneven.frames[k - 1].time;
    CHECK((gap == 2 || gap == 3));
  }
}

TEST_CASE("contacts of a page are the bodies that overlap") {
  const TemporaryFolder folder;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1, 1);
  std::ostringstream text;
  text.precision(17);
  text << "60\n" << plain << "Time=0.25\n";
  std::vector<Vec3> x;
  for (int i = 0; i < 60; ++i) {
    x.push_back({place(random), place(random), place(random)});
    text << "m0 " << x.back().x << ' ' << x.back().y << ' ' << x.back().z << " 0.2\n";
  }
  TrajectoryFile file(write(folder, text.str()));
  // A plane that has risen to z = −0.5 by then, and a cylinder about x.
  Wall plane{.point = {0, 0, -1}}, cylinder{.inward = {2, 0, 0}, .form = surface::Cylinder{1.1}};
  plane.motion.velocity = {0, 0, 2};
  const ShownMotion motion = read_motion(file, with_walls({plane, cylinder}));
  std::size_t pairs = 0, touches = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    for (std::size_t j = i + 1; j < 60; ++j) pairs += norm(x[i] - x[j]) < 0.4;
    touches += x[i].z < -0.3;
    touches += std::hypot(x[i].y, x[i].z) > 0.9;
  }
  CHECK(motion.pairs[0].size() == pairs);
  CHECK(motion.touches[0].size() == touches);
  CHECK(pairs > 10);
  for (const auto& [i, towards] : motion.touches[0]) {
    const bool down = norm(towards - Vec3{0, 0, -1}) < 1e-12;
    const Vec3 out = Vec3{0, x[i].y, x[i].z} / std::hypot(x[i].y, x[i].z);
    CHECK((down || norm(towards - out) < 1e-12));
  }
}

TEST_CASE("spheres that come and go are known by their ids") {
  const TemporaryFolder folder;
  const std::string head = "Properties=pos:R:3:radius:R:1:id:I:1 Time=";
  TrajectoryFile file(
      write(folder, "2\n" + head + "0\n0 0 0 1 4\n1 0 0 2 9\n2\n" + head + "1\n1 0 0 2 9\n5 0 0 3 12\n"));
  const ShownMotion motion = read_motion(file, {});
  CHECK(motion.cast.size() == 3);
  CHECK(motion.present[0] == std::vector<std::uint32_t>{0, 1});
  CHECK(motion.present[1] == std::vector<std::uint32_t>{1, 2});
  TrajectoryFile swapped(write(folder, "1\n" + head + "0\n0 0 0 1 4\n1\n" + head + "1\n0 0 0 2 4\n"));
  CHECK_THROWS_WITH(read_motion(swapped, {}), Catch::Contains("sphere 4 has another radius at 1 s"));
}

TEST_CASE("a sphere that went astray does not make the others small") {
  const TemporaryFolder folder;
  std::string text;
  for (int k = 0; k < 300; ++k) text += "m0 " + std::to_string(k % 10) + " 0 0 0.5\n";
  TrajectoryFile file(write(folder, "301\n" + plain + "Time=0\n" + text + "m0 5000 0 0 0.5\n"));
  const Region focus = read_motion(file, {}).focus();
  CHECK(focus.low.x == -0.5);
  CHECK(focus.high.x == Approx(9 + 9 + 1 + 0.5));  // the extent and two radii farther, and a radius
  CHECK(read_motion(file, {}).centres().high.x == 5000);
}

TEST_CASE("a page keeps numbers to half a quantum, both ends exactly") {
  for (const bool wide : {false, true}) {
    const Quanta quanta(-3, 5, wide);
    CHECK(quanta.quantum == Approx(8 / (std::pow(2.0, wide ? 32 : 16) - 1)));
    CHECK(quanta.of(-3) == 0);
    CHECK(quanta.of(5) == quanta.greatest);
    for (double x = -3; x <= 5; x += 0.0371)
      CHECK(std::abs(-3 + quanta.quantum * quanta.of(x) - x) <= quanta.quantum / 2 * (1 + 1e-6));
  }
  CHECK(Quanta(2, 2, false).of(2) == 0);
  // RFC 4648, section 10.
  const auto base64 = [](std::string_view text) {
    Bytes bytes;
    for (const char c : text) bytes.add(static_cast<std::uint32_t>(c), 1);
    return bytes.base64();
  };
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  Bytes bytes;
  bytes.add(0x01020304u, 4), bytes.add(1.0f);
  CHECK(bytes.base64() == "BAMCAQAAgD8=");
}

TEST_CASE("walls are drawn as far as they bound the spheres") {
  const Region focus{{0, 0, 0}, {1, 1, 1}};
  const auto box = wall_outlines(box_walls({-0.1, 0, 0}, {1, 1.1, 1}), focus);
  REQUIRE(box.size() == 6);
  for (const double x : {-0.1, 1.0})
    for (const double y : {0.0, 1.1})
      for (const double z : {0.0, 1.0}) {
        int faces = 0;
        for (const WallOutline& wall : box) faces += has(wall.lines[0], {x, y, z});
        CHECK(faces == 3);
      }
  CHECK(with_walls(focus, box).low.x == Approx(-0.1));
  // A lone floor is cut a quarter of the extent outside, and does not make the picture larger.
  const auto floor = wall_outlines({Wall{.point = {0, 0, -0.1}}}, focus);
  REQUIRE(floor[0].lines[0].size() == 5);
  CHECK(has(floor[0].lines[0], {-0.25, 1.25, -0.1}));
  CHECK(with_walls(focus, floor).low.z == 0);
  // A wall that lies elsewhere shows nothing.
  CHECK(wall_outlines({Wall{.point = {0, 0, -9}}}, focus)[0].lines[0].empty());
}

TEST_CASE("round walls and plates are drawn where they are") {
  const Region focus{{-1, -1, -1}, {1, 1, 1}};
  const Wall drum{.point = {0, 0, 0}, .inward = {0, 3, 0}, .form = surface::Cylinder{2}, .motion = {.spin = 4}};
  const Wall front{.point = {0, -0.5, 0}, .inward = {0, 1, 0}};
  const auto outlines = wall_outlines({drum, front}, focus);
  CHECK(outlines[0].motion.spin == 4);
  double greatest = -9;
  for (const Polyline& line : outlines[0].lines)
    for (const Vec3 p : line) {
      CHECK(std::hypot(p.x, p.z) == Approx(2));
      CHECK((p.y == Approx(-0.5) || p.y == Approx(1)));  // the plane, and as far as the spheres go
      greatest = std::max(greatest, p.y);
    }
  CHECK(greatest == Approx(1));
  CHECK(outlines[1].lines.empty());  // the drum's rim shows it
  const Wall cone{.point = {0, 0, 1}, .inward = {0, 0, -1}, .form = surface::Cone{2, 3, 1}};
  const auto funnel = wall_outlines({cone}, focus);
  for (const Polyline& line : funnel[0].lines)
    for (const Vec3 p : line) CHECK(std::hypot(p.x, p.y) == Approx(2 + p.z));
  const Wall plate{.point = {1, 0, 0}, .form = surface::Plate{{1, 0, 0}, {0, 2, 0}}};
  CHECK(wall_outlines({plate}, focus)[0].lines[0] == Polyline{{1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 0, 0}});
}

TEST_CASE("the page holds the trajectory to what it says, and no markup of the scene's") {
  const TemporaryFolder folder;
  std::ostringstream text;
  text.precision(17);
  for (int k = 0; k < 3; ++k) {
    text << "2\nProperties=species:S:1:pos:R:3:radius:R:1:velo:R:3 Time=" << 0.1 * k << "\n";
    text << "a<b> " << 0.1 * k << " 0.3 -0.2 0.05 3 4 0\nc " << 0.77 << " 0.3 0.4 0.02 0 0 " << k << "\n";
  }
  write(folder, text.str());
  Scene scene;
  scene.title = "</title><script>alert(1)</script>";
  scene.setup.gravity = {0, -2, 0};
  const std::string page = view_page(scene, folder.path());
  CHECK(page.find("<script>alert") == std::string::npos);
  CHECK(page.find("&lt;script&gt;alert(1)") != std::string::npos);
  CHECK(page.find("http") == std::string::npos);
  const auto facts = nlohmann::json::parse(element(page, "motion-facts"));
  CHECK(facts["species"] == std::vector<std::string>{"a<b>", "c"});
  CHECK(facts["up"] == std::vector<double>{0, 1, 0});
  CHECK(facts["fastest"][1] == 5.0);
  CHECK(facts["speed"]["top"] == 5.0);
  CHECK(facts["radiusRange"] == std::vector<double>{0.02, 0.05});
  const auto places = numbers_in(element(page, "motion-places"));
  REQUIRE(places.size() == 18);
  const auto at = [&](std::size_t k) {
    return facts["origin"][k % 3].get<double>() + facts["quanta"][k % 3].get<double>() * places[k];
  };
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(std::abs(at(6 * k) - 0.1 * static_cast<double>(k)) <= 0.77 / 65535 / 2 * (1 + 1e-9));
    CHECK(at(6 * k + 1) == 0.3);
    CHECK(at(6 * k + 5) == Approx(0.4));
  }
  CHECK(page.find("<dd>5.9e-06 m along each axis, 3.8e-05 m/s") != std::string::npos);  // 0.77 and 5 / 65535 / 2
  const auto speeds = numbers_in(element(page, "motion-speeds"));
  CHECK(speeds == std::vector<std::uint32_t>{65535, 0, 65535, 13107, 65535, 26214});
}
