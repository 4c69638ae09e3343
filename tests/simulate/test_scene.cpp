#include <catch2/catch.hpp>
#include <console/exit.hpp>
#include <ricochet/collision/collision.hpp>
#include <simulate/scene.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <regex>
#include <sstream>

using namespace ricochet;
using namespace ricochet::simulate;

namespace {

const std::string good = R"({
  "duration": 0.01,
  "materials": {"grain": {"density": 1000}, "plate": {}},
  "interactions": [
    {"between": ["grain", "grain"], "law": {"name": "linear", "k": 1000, "c": 1}},
    {"between": ["grain", "plate"], "law": {"name": "fractional", "k": 1000, "c": 1, "alpha": 0.3},
     "friction": {"mu_static": 0.5}}
  ],
  "spheres": [
    {"radius": 0.01, "material": "grain", "position": [0, 0, 0.02]},
    {"radius": 0.01, "material": "grain", "position": [0, 0, 0.05], "velocity": [0, 0, -1]}
  ],
  "walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "plate"}]
})";

std::string with(const std::string& from, const std::string& to) {
  std::string text = good;
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string placed_complaint(const std::string& text) {
  try {
    read_scene("s.json", text);
  } catch (const console::BadInput& error) {
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  return "accepted";
}

// Without line and column where a JSON path follows, which must be there.
std::string complaint(const std::string& text) {
  static const std::regex place(R"(^s\.json:\d+:\d+: /)");
  const std::string message = placed_complaint(text);
  CHECK(message.rfind("s.json: /", 0) == std::string::npos);
  return std::regex_replace(message, place, "s.json: /");
}

}  // namespace

TEST_CASE("how sharply contacts are solved together can be said") {
  CHECK(read_scene("s.json", good).options.solver_tolerance == ClusterOptions{}.solver_tolerance);
  const auto asked = [](const std::string& tolerance) {
    return with("\"duration\": 0.01,", "\"duration\": 0.01, \"solver_tolerance\": " + tolerance + ",");
  };
  CHECK(read_scene("s.json", asked("1e-6")).options.solver_tolerance == 1e-6);
  CHECK(complaint(asked("0.1")) == "s.json: /solver_tolerance = 0.1: must be at most 0.01");
}

TEST_CASE("brackets in brackets end somewhere, whatever they are in") {
  const auto nested = [](std::size_t depth) {
    return with("\"duration\": 0.01", "\"duration\": " + std::string(depth, '[') + std::string(depth, ']'));
  };
  CHECK(placed_complaint(nested(100'000)) == "s.json:2:78: brackets in more than 64 brackets; must be fewer");
  CHECK(placed_complaint(nested(63)).find("/duration = [[[") != std::string::npos);
  CHECK(placed_complaint(with("\"duration\"",
                              "\"title\": \"" + std::string(1'000'000, '[') + "\\\"[\", \"duration\"")) == "accepted");
}

TEST_CASE("a scene is read with its defaults and a step that resolves the stiffest contact") {
  const Scene scene = read_scene("s.json", good);
  CHECK(scene.setup.spheres.size() == 2);
  CHECK(scene.setup.interactions.at({0, 1}).friction.mu_dynamic() == 0.5);
  CHECK(scene.options.step <= scene.stiffest.tcol / 200);
  CHECK(double(scene.output_every) * scene.options.step == Approx(1e-4).epsilon(1e-14));
  CHECK(double(scene.steps) * scene.options.step == Approx(0.01).epsilon(1e-12));
}

TEST_CASE("every mistake in a scene is one line that says where, what, and what is accepted") {
  CHECK(complaint(good) == "accepted");
  CHECK(complaint(good + "}") == "s.json:14:2: no JSON: must be one object as docs/scenes.md describes");
  CHECK(complaint(with("0.01,", "0.01,,")).rfind("s.json:2:20: no JSON", 0) == 0);
  CHECK(complaint(with("0.01,", "1e999,")) == "s.json:2:15: 1e999: must be at most 1.8e308 in size");
  CHECK(complaint(with("\"walls\"", "\"wals\"")).rfind("s.json: /: unknown key \"wals\"; known are schema,", 0) == 0);
  CHECK(complaint(with("\"walls\"", "\"duration\"")) ==
        "s.json: key \"duration\" is given twice in one object; it must be given once");
  CHECK(complaint(with("\"radius\": 0.01", "\"radius\": -0.01")) ==
        "s.json: /spheres/0/radius = -0.01: must be a number > 0");
  CHECK(complaint(with("\"radius\": 0.01", "\"radius\": \"big\"")) ==
        "s.json: /spheres/0/radius = \"big\": must be a number > 0");
  CHECK(complaint(with("\"radius\": 0.01, ", "")) == "s.json: /spheres/0: \"radius\" is missing; it must be given");
  CHECK(complaint(with("[0, 0, 0.05]", "[0, 0]")) ==
        "s.json: /spheres/1/position = [0,0]: must be three numbers [x, y, z]");
  CHECK(complaint(with("0.05", "0.029")) ==
        "s.json: /spheres/1: overlaps /spheres/0 by 0.011 m at the start; it must be less than a radius, 0.01 m");
  CHECK(complaint(with("0.02]", "-0.001]")) ==
        "s.json: /spheres/0: overlaps wall1 by 0.011 m at the start; it must be less than a radius, 0.01 m");
  CHECK(complaint(with("0.01,", "0,")) == "s.json: /duration = 0: must be a number > 0");
  CHECK(complaint(with("\"duration\"", "\"step\": 0.005, \"duration\""))
            .rfind("s.json: /step = 0.005: must be at most the output interval", 0) == 0);
  CHECK(complaint(with("\"duration\"", "\"step\": 0.002, \"output_interval\": 0.01, \"duration\""))
            .rfind("s.json: /step = 0.002: must be at most 0.000", 0) == 0);
  CHECK(complaint(with("[\"grain\", \"plate\"]", "[\"plate\", \"plate\"]")) ==
        "s.json: /interactions: no entry between \"grain\" and \"plate\", which can meet; it must be given");
  CHECK(complaint(with("[\"grain\", \"plate\"]", "[\"grain\", \"grain\"]")) ==
        "s.json: /interactions/1/between = [\"grain\",\"grain\"]: must be a pair that is given once");
  CHECK(complaint(with("[\"grain\", \"plate\"]", "[\"grain\", \"plate\"], \"breakage_energy\": -1"))
            .find("breakage_energy = -1: must be a number >= 0") != std::string::npos);
  CHECK(complaint(with("\"alpha\": 0.3", "\"alpha\": -0.3")) ==
        "s.json: /interactions/1/law/alpha = -0.3: must be in [0, 1]");
  CHECK(complaint(with("\"alpha\": 0.3", "\"alpha\": 1.3")) ==
        "s.json: /interactions/1/law/alpha = 1.3: must be in [0, 1]");
  CHECK(complaint(with("\"linear\"", "\"hooke\"")) ==
        "s.json: /interactions/0/law/name = \"hooke\": must be linear or kuwabara-kono or tsuji or hysteretic or "
        "fractional or fractional-kelvin-voigt or fractional-hertz or fractional-zener");
  CHECK(complaint(with("\"mu_static\": 0.5", "\"mu_static\": 0.5, \"mu_dynamic\": 0.6")) ==
        "s.json: /interactions/1/friction/mu_dynamic = 0.6: must be at most mu_static");
  CHECK(complaint(with("\"material\": \"plate\"", "\"material\": \"plat\"")) ==
        "s.json: /walls/0/material = \"plat\": must be one of the materials grain, plate");
  CHECK(complaint(with("{\"density\": 1000}", "{}")) ==
        "s.json: /spheres/0: \"density\" is missing; the sphere or its material must give it");
  CHECK(complaint(with("\"inward\": [0, 0, 1]", "\"inward\": [0, 0, 0]")) ==
        "s.json: /walls/0/inward = [0,0,0]: must be a direction, not zero");
  CHECK(complaint(with("\"plate\": {}", "\"=plate\": {}")) ==
        "s.json: /materials/=plate: must have a name of printable characters that begins with none of = + - @");
  CHECK(complaint(with("\"plate\": {}", "\"pl\\u001bate\": {}"))
            .ends_with("must have a name of printable characters that begins with none of = + - @"));
  CHECK(complaint("[]").rfind("s.json: / = []: must be an object", 0) == 0);
  CHECK(complaint("").rfind("s.json:1:1: no JSON", 0) == 0);
}

TEST_CASE("springs in the tangent plane are read, those of a restitution for each pair's own mass") {
  const auto friction = [](const std::string& more) {
    return with(R"({"mu_static": 0.5})", R"({"mu_static": 0.5, )" + more + "}");
  };
  // On the plate; where springs are each pair's own, grains are sorts of their own.
  const auto read = [](const std::string& text) {
    const ClusterSetup setup = read_scene("s.json", text).setup;
    return setup.interactions.at(std::minmax(setup.spheres[0].material, setup.walls[0].material));
  };
  const Sphere grain{0.01, 1000};
  const double m = grain.mass(), turning = 3.5 * grain.inertia() / m;

  const Interaction plain = read(friction(R"("model": "linear", "k_t": 800, "c_t": 0.5)"));
  CHECK(values(plain.tangential) == std::vector<double>{800, 0.5});
  CHECK(name(plain.tangential) == "linear");
  CHECK(plain.torsion.limit == Torsion::Limit::none);
  CHECK(plain.rolling.spring.stiffness == 0);
  CHECK(name(read(friction(R"("model": "rigid")")).tangential) == "rigid");

  // Springs against torsion and rolling swing as that against sliding does: k = (7/2) (J/m) k_t.
  const Interaction turns =
      read(friction(R"("model": "linear", "k_t": 800, "c_t": 0.5, "torsion": true, "mu_rolling": 0.1)"));
  CHECK(turns.torsion.limit == Torsion::Limit::disc);
  CHECK(turns.torsion.spring.stiffness == Approx(turning * 800).epsilon(1e-14));
  CHECK(turns.rolling.spring.damping == Approx(turning * 0.5).epsilon(1e-14));
  CHECK(turns.rolling.mu == 0.1);

  // β₀ within the law's own t_col: k_t = m_t (π² + ln² β₀)/t_col², c_t = −2 m_t ln β₀/t_col.
  const double tcol = collide(Fractional(1000, 1, 0.3), {1, m}).tcol, loss = std::log(0.6);
  const auto sprung = values(read(friction(R"("model": "linear", "beta0": 0.6)")).tangential);
  const double squares = std::pow(std::numbers::pi, 2) + loss * loss;
  CHECK(sprung[0] == Approx(2.0 / 7 * m * squares / (tcol * tcol)).epsilon(1e-12));
  CHECK(sprung[1] == Approx(-4.0 / 7 * m * loss / tcol).epsilon(1e-12));

  // Mindlin of moduli: k_t = 8 G* √R*, 1/G* = 4 (2−ν)(1+ν)/E of like bodies, R* = r on a plate.
  std::string hertz = friction(R"("model": "mindlin")");
  const std::string law = R"({"name": "fractional", "k": 1000, "c": 1, "alpha": 0.3})";
  hertz.replace(hertz.find(law), law.size(), R"({"name": "tsuji", "en": 0.9, "young": 1e6, "poisson": 0.3})");
  CHECK(values(read(hertz).tangential)[0] == Approx(8 * 1e6 / (4 * 1.7 * 1.3) * std::sqrt(0.01)).epsilon(1e-12));
}

TEST_CASE("a mistake in springs is one line that says where, what, and what is accepted") {
  const auto said = [](const std::string& more) {
    return complaint(with(R"({"mu_static": 0.5})", R"({"mu_static": 0.5, )" + more + "}"));
  };
  const std::string at = "s.json: /interactions/1/friction";
  CHECK(said(R"("model": "hooke")") == at + "/model = \"hooke\": must be rigid or linear or mindlin");
  CHECK(said(R"("model": "linear")") ==
        at + ": \"k_t\" or \"beta0\" is missing; one must be given with the model linear");
  CHECK(said(R"("model": "mindlin")") ==
        at + ": \"k_t\" is missing; it must be given, or the law by \"en\", \"young\" and \"poisson\"");
  CHECK(said(R"("model": "linear", "k_t": 0)") == at + "/k_t = 0: must be a number > 0");
  CHECK(said(R"("model": "linear", "k_t": 1, "c_t": -1)") == at + "/c_t = -1: must be a number >= 0");
  CHECK(said(R"("model": "linear", "beta0": 1.5)") == at + "/beta0 = 1.5: must be in (0, 1]");
  CHECK(said(R"("model": "linear", "beta0": 0.5, "k_t": 1)") == at + "/k_t = 1: must be left out with beta0");
  CHECK(said(R"("model": "mindlin", "beta0": 0.5)") == at + "/beta0 = 0.5: must be left out with the model mindlin");
  CHECK(said(R"("model": "linear", "k_t": 1, "torsion": 1)") == at + "/torsion = 1: must be true or false");
  CHECK(said(R"("model": "linear", "k_t": 1, "mu_rolling": 0.1, "rolling_arm": 1)") ==
        at + "/mu_rolling = 0.1: must be left out with rolling_arm");
  CHECK(said(R"("model": "mindlin", "k_t": 1, "torsion": true)") ==
        at + ": \"velocity\" is missing; these springs depend on the impact velocity for which they are made");
  CHECK(said(R"("k_t": 1)").find("k_t") != std::string::npos);
  CHECK(said(R"("torsion": false)") == at + "/torsion = false: must be true with the model rigid");
  CHECK(said(R"("torsion": true, "mu_rolling": 0.1)") == "accepted");
}

TEST_CASE("a mistake in a scene is told by line and column") {
  CHECK(placed_complaint(with("\"radius\": 0.01", "\"radius\": -0.01"))
            .rfind("s.json:10:16: /spheres/0/radius = -0.01", 0) == 0);
  CHECK(placed_complaint(with("\"radius\": 0.01, ", "")).rfind("s.json:10:5: /spheres/0: ", 0) == 0);
  CHECK(placed_complaint(with("[0, 0, 0.05]", "[0, 0]")).rfind("s.json:11:55: /spheres/1/position", 0) == 0);
  CHECK(placed_complaint(with("[0, 0, 0.05]", "[0, 0, \"}\\\"]\"]")).rfind("s.json:11:62: /spheres/1/position/2", 0) ==
        0);
  CHECK(placed_complaint(with("\"density\": 1000", "\"density\": 0"))
            .rfind("s.json:3:38: /materials/grain/density = 0", 0) == 0);
  CHECK(placed_complaint("[]").rfind("s.json:1:1: / = []", 0) == 0);
}

TEST_CASE("the scene that docs/scenes.md shows is a good scene") {
  std::ifstream in(RICOCHET_SOURCE_DIR "/docs/scenes.md");
  std::stringstream text;
  text << in.rdbuf();
  const std::string page = text.str(), open = "```json\n";
  const std::size_t first = page.find(open);
  REQUIRE(first != std::string::npos);
  const std::size_t begin = first + open.size();
  const Scene scene = read_scene("docs/scenes.md", page.substr(begin, page.find("```", begin) - begin));
  CHECK(scene.setup.interactions.size() == 2);
  CHECK(scene.setup.interactions.at({0, 1}).end == ContactEnd::overlap);
  CHECK(scene.setup.walls.size() == 1);
}

TEST_CASE("the default step resolves overdamped contacts as well") {
  // One sphere on a plate, damping ratio β. With 20 steps in m/c the midpoint rule errs by (1/20)²/12 an e-folding of
  // the velocity, of which a rebound has 4 ln 2β; as much again for either end. Second order: doubling the steps leaves
  // a quarter.
  for (const double beta : {0.1, 2.0, 5.0, 20.0, 50.0}) {
    const double radius = 0.01, mass = 4.0 / 3 * std::numbers::pi * 1e-6 * 1000, k = 1000;
    const double c = 2 * beta * std::sqrt(mass * k);
    ClusterSetup setup;
    setup.spheres.push_back({radius, 1000, {0, 0, radius + 1e-7}, {0, 0, -1}, {}, 0});
    setup.walls.push_back({{0, 0, 0}, {0, 0, 1}, 1});
    setup.interactions.insert({{0, 1}, {Linear(k, c)}});
    const double tcol = stiffest_contact(setup).tcol;
    const Collision exact = collide(Linear(k, c), {1, mass});
    CHECK(tcol <= std::numbers::pi * std::sqrt(mass / k) * (1 + 1e-12));
    CHECK(tcol <= 10 * mass / c * (1 + 1e-12));
    const auto error_of = [&](double step) {
      Cluster cluster(setup, {.step = step});
      while (cluster.contacts().empty() || cluster.contacts()[0].record.end == Encounter::never) cluster.step();
      const double lasted = cluster.contacts()[0].record.end - cluster.contacts()[0].record.begin;
      return std::max(std::abs(cluster.velocity(0).z / exact.en - 1), std::abs(lasted / exact.tcol - 1));
    };
    const double error = error_of(tcol / 200);
    CAPTURE(beta, error);
    const double foldings = std::max(1.0, 4 * std::log(2 * beta));
    CHECK(error < 3 * foldings / (12 * 20 * 20));
    CHECK(error_of(tcol / 400) < 0.5 * error);
  }
}

TEST_CASE("the scenes of the project are good scenes") {
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RICOCHET_SOURCE_DIR "/data/scenes")) {
    std::ifstream in(entry.path());
    std::stringstream text;
    text << in.rdbuf();
    CAPTURE(entry.path().string());
    CHECK_NOTHROW(read_scene(entry.path().filename().string(), text.str()));
    ++found;
  }
  CHECK(found >= 4);
}

TEST_CASE("of the three grains on a slope one rests, one rolls, one slides") {
  std::ifstream in(RICOCHET_SOURCE_DIR "/data/scenes/slope.json");
  std::stringstream text;
  text << in.rdbuf();
  const Scene scene = read_scene("slope.json", text.str());
  Cluster cluster(scene.setup, scene.options);
  REQUIRE(cluster.advance(scene.steps));
  const double t = cluster.time(), along = scene.setup.gravity.x, across = -scene.setup.gravity.z;
  CHECK(std::abs(cluster.velocity(0).x) < 1e-9 * 0.005);
  // The springs take the load up within some collision times, 1 ms, and the arm is r less 0.013 % of it.
  CHECK(cluster.velocity(1).x == Approx(5.0 / 7 * along * t).epsilon(1e-3));
  CHECK(cluster.velocity(2).x == Approx((along - 0.05 * across) * t).epsilon(1e-3));
}

TEST_CASE("a scene of bodies that would pass through each other is refused with the numbers") {
  // Two spheres (r = 0.01 m, k = 1e4 kg/s²) at 100 m/s came out on the other side.
  const auto at = [](double speed, const std::string& aside = "0") {
    return R"({"duration": 0.01, "materials": {"g": {"density": 2000}},
  "interactions": [{"between": ["g", "g"], "law": {"name": "linear", "k": 1e4, "c": 0}}],
  "spheres": [{"radius": 0.01, "material": "g", "position": [0, 0, 0], "velocity": [)" +
           std::to_string(speed) + R"(, 0, 0]},
    {"radius": 0.01, "material": "g", "position": [0.03, )" +
           aside + R"(, 0]}]})";
  };
  // m_eff = m/2 = 4.18879e-3 kg: v t_col/pi = v sqrt(m_eff/k) = 6.47e-4 s v
  CHECK(placed_complaint(at(100)) ==
        "s.json:4:5: /spheres/1: meets /spheres/0 at 100 m/s and would go 0.0647 m into it (v t_col/pi), past a radius "
        "of 0.01 m; it must be slower, or their law stiffer, or \"insist\" true");
  // So fast that a step of the default would carry it past the other unseen.
  CHECK(placed_complaint(at(1e4)).find("/spheres/1: meets /spheres/0 at 1e+04 m/s and would go 6.47 m") !=
        std::string::npos);
  CHECK(placed_complaint(at(23.10)) == "accepted");
  CHECK(placed_complaint(at(23.25)) != "accepted");
  CHECK(read_scene("s.json", at(15.40)).remark.empty());
  CHECK(read_scene("s.json", at(15.50)).remark ==
        "/spheres/1 meets /spheres/0 at 15.5 m/s and would go 0.01 m into it (v t_col/pi), past a radius of 0.01 m");
  std::string insisting = at(100);
  insisting.replace(1, 0, "\"insist\": true, ");
  CHECK(read_scene("s.json", insisting).remark.find("/spheres/1 meets /spheres/0 at 100 m/s and would go 0.0647 m") ==
        0);
  CHECK(placed_complaint(at(100, "0.0201")) == "accepted");     // flies by
  CHECK(placed_complaint(at(100, "0.0199999")) == "accepted");  // grazes
  CHECK(placed_complaint(at(-100)) == "accepted");
  const std::string falling =
      with("\"position\": [0, 0, 0.02]", "\"position\": [0, 0, 0.02], \"velocity\": [0, 0, -80]");
  CHECK(placed_complaint(falling).find("/spheres/0: meets wall1 at 80 m/s and would go ") != std::string::npos);
  CHECK(placed_complaint(with("\"position\": [0, 0, 0.02]", "\"position\": [0, 0, 0.9], \"velocity\": [0, 0, -80]")) ==
        "accepted");  // not within the run
  // Across the border of a space that repeats itself the other is the next on the way, or where it is.
  const auto around = [&](double speed, const std::string& borders) {
    std::string scene = at(speed);
    return placed_complaint(scene.replace(1, 0, R"("periodic": {"x": )" + borders + "}, "));
  };
  CHECK(around(-100, "[-0.05, 0.05]").find("/spheres/1: meets /spheres/0 at 100 m/s and would go 0.0647 m") !=
        std::string::npos);
  CHECK(around(100, "[-0.05, 0.05]").find("/spheres/1: meets /spheres/0 at 100 m/s") != std::string::npos);
  CHECK(around(-15, "[-0.05, 0.05]") == "accepted");
}

TEST_CASE("a place along a periodic axis must be one that doubles can tell") {
  const auto at = [](const std::string& y) {
    return placed_complaint(R"({"duration": 0.01, "periodic": {"y": [-0.1, 0.1]}, "materials": {"g": {"density": 2000}},
  "interactions": [{"between": ["g", "g"], "law": {"name": "linear", "k": 1e4, "c": 0}}],
  "spheres": [{"radius": 0.01, "material": "g", "position": [0, )" +
                            y + ", 0]}]}");
  };
  CHECK(at("1.99e5") == "accepted");
  CHECK(at("-2.01e5").find("/spheres/0/position") != std::string::npos);
  CHECK(at("1e308").find("must be a million periods off at most along a periodic axis") != std::string::npos);
}
