#include "export_cases.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;
using namespace export_cases;

namespace {

constexpr double wall_mass = 2 * mass_eff, wall_radius = 2 * radius_eff;

/// A grain of the pair above that meets a wall, and another grain.
ContactSet beside_wall(const AnyLaw& at_wall, const AnyLaw& grains, ContactEnd end) {
  return {end,
          {{.name = "grain", .density = 1000}, {.name = "wall", .wall = true}},
          {{0, 1, at_wall, 1e-4, 0.5, {0.5, wall_mass}, wall_radius},
           {0, 0, grains, 1e-4, 0.5, {0.5, mass_eff}, radius_eff}}};
}

const Linear linear_at_wall(2 * 5211.5, 2 * 0.098);
const Tsuji tsuji_at_wall(2.1e6, 1.46 * 2.1 / 1.3);

/// The numbers behind `mark`, as many as there are.
std::vector<double> all_after(const Snippet& snippet, const std::string& mark) {
  const std::string text = active(snippet);
  const std::size_t at = text.find(mark);
  REQUIRE(at != std::string::npos);
  std::istringstream line(text.substr(at + mark.size(), text.find('\n', at) - at - mark.size()));
  std::vector<double> numbers;
  for (double number; line >> number;) numbers.push_back(number);
  return numbers;
}

double hertz_modulus(double k, double radius) { return 0.75 * k / std::sqrt(radius); }

}  // namespace

TEST_CASE("with a wall both contacts are written, each by its own numbers") {
  const ContactSet set = beside_wall(linear_at_wall, linear_by_force, ContactEnd::force);
  const auto liggghts = export_contacts(Engine::liggghts, set);
  CHECK(all_after(liggghts, " kn peratomtypepair 2 ") == std::vector{5211.5, 10423.0, 10423.0, 10423.0});
  CHECK(all_after(liggghts, " gamman_abs peratomtypepair 2 ") == std::vector{0.098, 0.196, 0.196, 0.196});
  CHECK(acts_on(liggghts, "variable ricochet_wall index \"primitive type 2 zplane 0.0\""));
  CHECK(acts_on(liggghts,
                "fix ricochet_wall all wall/gran model hooke/stiffness tangential off ${ricochet_wall} "
                "absolute_damping on limitForce on tangential_damping off"));

  const auto lammps = export_contacts(Engine::lammps, set);
  CHECK(line_with(lammps, "pair_coeff") ==
        "pair_coeff * * hooke 5211.5 0.098 damping velocity tangential linear_nohistory 0.0 0.0 limit_damping");
  CHECK(
      line_with(lammps, "fix ") ==
      "fix ricochet_wall all wall/gran granular hooke 10423 0.196 damping velocity tangential linear_nohistory 0.0 0.0 "
      "limit_damping ${ricochet_wall}");

  const auto mercury = export_contacts(Engine::mercurydpm, beside_wall(linear_at_wall, linear, ContactEnd::overlap));
  CHECK(acts_on(mercury, "auto species_grain_wall = speciesHandler.getMixedObject(species_grain, species_wall);"));
  CHECK(acts_on(mercury, "species_grain_wall->setStiffness(10423);"));
  CHECK(acts_on(mercury, "species_grain->setStiffness(7316);"));

  const auto mfix = export_contacts(Engine::mfix, beside_wall(linear_at_wall, linear, ContactEnd::overlap));
  CHECK(after(mfix, "KN = ") == 7316);
  CHECK(after(mfix, "KN_W = ") == 10423);
  CHECK(restitution_of_damping(damping_ratio(linear_at_wall, wall_mass), ContactEnd::overlap) ==
        Approx(after(mfix, "DES_EN_WALL_INPUT(1) = ")).epsilon(1e-14));
}

TEST_CASE("with a wall, moduli of both materials give both Hertzian stiffnesses, in each engine's own radius") {
  const ContactSet set = beside_wall(tsuji_at_wall, tsuji, ContactEnd::force);
  const double of_grains = hertz_modulus(tsuji.k(), radius_eff),
               of_wall = hertz_modulus(tsuji_at_wall.k(), wall_radius);
  const auto joined = [](double a, double b) { return 1 / ((1 - 0.09) / a + (1 - 0.09) / b); };

  const auto young = all_after(export_contacts(Engine::liggghts, set), " youngsModulus peratomtype ");
  CHECK(joined(young[0], young[0]) == Approx(of_grains).epsilon(1e-13));
  CHECK(joined(young[0], young[1]) == Approx(of_wall).epsilon(1e-13));

  // With hertzian=True Yade's walls are flat, R = r; else they count as spheres of the sphere's own radius.
  const auto yade = export_contacts(Engine::yade, set);
  const std::string grain = line_with(yade, "material = FrictMat"), wall = line_with(yade, "wall_material = FrictMat");
  const auto modulus = [](const std::string& line) { return std::stod(line.substr(line.find("young=") + 6)); };
  CHECK(joined(modulus(grain), modulus(grain)) == Approx(of_grains).epsilon(1e-13));
  CHECK(4.0 / 3 * joined(modulus(grain), modulus(wall)) * std::sqrt(wall_radius) ==
        Approx(tsuji_at_wall.k()).epsilon(1e-12));
  CHECK(acts_on(yade, "Ig2_Wall_Sphere_ScGeom(hertzian=True), Ig2_Facet_Sphere_ScGeom(hertzian=True)]"));
  CHECK(acts_on(yade, "MatchMaker(matches=[(material.id, wall_material.id, "));
  CHECK(acts_on(yade, "O.materials.append([material, wall_material])"));

  const auto mfix = export_contacts(Engine::mfix, beside_wall(tsuji_at_wall, tsuji, ContactEnd::overlap));
  CHECK(joined(after(mfix, "E_YOUNG(1) = "), after(mfix, "EW_YOUNG = ")) == Approx(of_wall).epsilon(1e-13));
}

TEST_CASE("Yade with a wall: the k and c that it makes of tc and en, with half the sphere's mass at the wall") {
  const auto yade = export_contacts(Engine::yade, beside_wall(linear_at_wall, linear_by_force, ContactEnd::force));
  const auto number = [&](const std::string& of, const std::string& pair) {
    const std::string text = line_with(yade, "ip2 = ");
    const std::string list = text.substr(text.find(" " + of + "=") == std::string::npos ? text.find("(" + of + "=")
                                                                                        : text.find(" " + of + "="));
    return std::stod(list.substr(list.find(pair) + pair.size()));
  };
  for (const bool wall : {false, true}) {
    const std::string pair = wall ? "(material.id, wall_material.id, " : "(material.id, material.id, ";
    const double mass = wall ? wall_mass / 2 : mass_eff, tc = number("tc", pair), log_en = std::log(number("en", pair));
    const Linear& law = wall ? linear_at_wall : linear_by_force;
    CHECK((std::numbers::pi * std::numbers::pi + log_en * log_en) * mass / (tc * tc) == Approx(law.k()).epsilon(1e-13));
    CHECK(-2 * log_en * mass / tc == Approx(law.c()).epsilon(1e-13));
  }
}

TEST_CASE("Yade's springs in series, where no tc and en give the damping, reach a wall of twice the stiffness") {
  const Linear damped(5211.5, 0.75 * 2 * std::sqrt(5211.5 * mass_eff));  // past 1/sqrt(2) at the wall
  const Linear at_wall(2 * damped.k(), 2 * damped.c() * 1.1);
  const auto series = [](const Snippet& yade, const char* mark) {
    const auto number = [&](const std::string& line) { return std::stod(line.substr(line.find(mark) + 3)); };
    const double a = number(line_with(yade, "material = Visc")), b = number(line_with(yade, "wall_material = Visc"));
    return std::pair(a * a / (a + a), a * b / (a + b));
  };
  const auto yade =
      export_contacts(Engine::yade, beside_wall(Linear(2 * damped.k(), 1.995 * damped.c()), damped, ContactEnd::force));
  REQUIRE(yade.fidelity == Fidelity::exact);
  CHECK(series(yade, "kn=").first == Approx(5211.5).epsilon(1e-14));
  CHECK(series(yade, "kn=").second == Approx(10423).epsilon(1e-11));
  CHECK(series(yade, "cn=").second == Approx(1.995 * damped.c()).epsilon(1e-11));
  const auto beyond = export_contacts(Engine::yade, beside_wall(at_wall, damped, ContactEnd::force));
  CHECK(beyond.fidelity == Fidelity::absent);
  CHECK(active(beyond).empty());
}

TEST_CASE("no two kinds of wall stand in one place until the deck places them, and the file says where they are") {
  ContactSet set{ContactEnd::force, {{.name = "grain"}}, {{0, 0, linear_by_force, 1e-4, 0.5, {0.5, mass_eff}, {}}}};
  for (const char* name : {"floor", "side", "back", "lid"}) {
    set.pairs.push_back({0, set.kinds.size(), linear_at_wall, 1e-4, 0.5, {0.5, wall_mass}, {}});
    set.kinds.push_back({.name = name, .wall = true});
  }
  const auto lammps = export_contacts(Engine::lammps, set), liggghts = export_contacts(Engine::liggghts, set);
  CHECK(line_with(lammps, "ricochet_wall_floor index") == "variable ricochet_wall_floor index \"zplane 0.0 NULL\"");
  CHECK(line_with(lammps, "ricochet_wall_side index") == "variable ricochet_wall_side index \"xplane 0.0 NULL\"");
  CHECK(line_with(lammps, "ricochet_wall_back index") == "variable ricochet_wall_back index \"yplane 0.0 NULL\"");
  CHECK(line_with(lammps, "ricochet_wall_lid index") == "variable ricochet_wall_lid index \"zplane NULL 1.0\"");
  CHECK(acts_on(liggghts, "variable ricochet_wall_side index \"primitive type 3 xplane 0.0\""));
  CHECK(acts_on(liggghts, "variable ricochet_wall_lid index \"primitive type 5 zplane 1.0\""));
  for (const Snippet& snippet : {lammps, liggghts}) {
    std::string words = snippet.remarks.front();
    CHECK(words.find("Set these variables to where the walls are before you include this file; without, "
                     "ricochet_wall_floor is the plane z = 0, ricochet_wall_side is the plane x = 0, "
                     "ricochet_wall_back is the plane y = 0, ricochet_wall_lid is the plane z = 1.") !=
          std::string::npos);
  }
}

TEST_CASE("grains of several kinds: one command or matrix entry a pair") {
  ContactSet set{ContactEnd::force,
                 {{.name = "small"}, {.name = "large"}, {.name = "floor", .wall = true}},
                 {{0, 0, Linear(100, 1), 1e-4, 0.5, {1, 1e-6}, {}},
                  {0, 1, Linear(200, 2), 1e-4, 0.5, {1, 2e-6}, {}},
                  {1, 1, Linear(300, 3), 1e-4, 0.5, {1, 3e-6}, {}},
                  {0, 2, Linear(400, 4), 1e-4, 0.5, {1, 4e-6}, {}},
                  {1, 2, Linear(500, 5), 1e-4, 0.5, {1, 5e-6}, {}}}};
  CHECK(all_after(export_contacts(Engine::liggghts, set), " kn peratomtypepair 3 ") ==
        std::vector<double>{100, 200, 400, 200, 300, 500, 400, 500, 400});
  const auto lammps = export_contacts(Engine::lammps, set);
  CHECK(line_with(lammps, "pair_coeff 1 2").find("hooke 200 2 ") != std::string::npos);
  CHECK(line_with(lammps, "group ricochet_large") == "group ricochet_large type 2");
  CHECK(line_with(lammps, "fix ricochet_wall_large ricochet_large wall/gran").find("hooke 500 5 ") !=
        std::string::npos);
  CHECK(export_contacts(Engine::mfix, set).fidelity == Fidelity::absent);
}

TEST_CASE("grains of a range of sizes: the numbers that keep the restitution of each") {
  ContactSet set{ContactEnd::overlap, {{.name = "grain"}}, {{0, 0, linear, 1e-4, 0.5, {0.5, mass_eff}, radius_eff}}};
  set.other_sizes = {{0, 0, linear, 1e-4, 0.5, {0.5, 8 * mass_eff}, 2 * radius_eff}};
  const std::string line = line_with(export_contacts(Engine::lammps, set), "damping coeff_restitution");
  std::istringstream numbers(line.substr(line.find("hooke ") + 6));
  double stiffness, en;
  numbers >> stiffness >> en;
  CHECK(stiffness == linear.k());
  CHECK(en == Approx(restitution_of_damping(damping_ratio(linear, mass_eff), ContactEnd::overlap)).epsilon(1e-14));

  ContactSet seeds{ContactEnd::force, {{.name = "seed"}}, {{0, 0, fractional, 1e-4, 0.5, {0.5, mass_eff}, radius_eff}}};
  seeds.other_sizes = seeds.pairs;
  const auto liggghts = export_contacts(Engine::liggghts, seeds);
  CHECK(after(liggghts, "collisionTime peratomtypepair 1 ") == 1e-4);
  CHECK(after(liggghts, "coefficientRestitution peratomtypepair 1 ") == 0.5);
  const auto lammps = export_contacts(Engine::lammps, seeds);
  CHECK(acts_on(lammps, "\"pair_coeff * * fractional/target 1e-04 0.5 damping fractional "));
  CHECK(acts_on(lammps, "\"pair_coeff * * target 1e-04 0.5\"\n"));
}

TEST_CASE("LAMMPS: grains of two kinds and a wall under the fractional law, in both forms of the driver") {
  const auto law = [](double k) { return Fractional(k, 0.5, 0.25); };
  const ContactSet set{ContactEnd::force,
                       {{.name = "small"}, {.name = "large"}, {.name = "floor", .wall = true}},
                       {{0, 2, law(400), 1e-4, 0.5, {1, 4e-6}, {}},
                        {1, 2, law(500), 1e-4, 0.5, {1, 5e-6}, {}},
                        {0, 0, law(100), 1e-4, 0.5, {1, 1e-6}, {}},
                        {1, 0, law(200), 1e-4, 0.5, {1, 2e-6}, {}},
                        {1, 1, law(300), 1e-4, 0.5, {1, 3e-6}, {}}}};
  const std::string rest = " 0.5 0.25 damping fractional tangential linear_nohistory 0.0 0.0";
  const std::string lines =
      "variable ricochet_wall index \"zplane 0.0 NULL\"\n"
      "group ricochet_small type 1\n"
      "group ricochet_large type 2\n"
      "if \"$(version) >= 20250204\" then &\n"
      "  \"pair_style granular\" &\n"
      "  \"pair_coeff 1 1 fractional 100" +
      rest +
      "\" &\n"
      "  \"pair_coeff 1 2 fractional 200" +
      rest +
      "\" &\n"
      "  \"pair_coeff 2 2 fractional 300" +
      rest +
      "\" &\n"
      "  \"fix ricochet_wall_small ricochet_small wall/gran granular fractional 400" +
      rest +
      " ${ricochet_wall}\" &\n"
      "  \"fix ricochet_wall_large ricochet_large wall/gran granular fractional 500" +
      rest +
      " ${ricochet_wall}\" &\n"
      "else &\n"
      "  \"pair_style fractional\" &\n"
      "  \"pair_coeff 1 1 100 0.5 0.25\" &\n"
      "  \"pair_coeff 1 2 200 0.5 0.25\" &\n"
      "  \"pair_coeff 2 2 300 0.5 0.25\" &\n"
      "  \"fix ricochet_wall_small ricochet_small wall/fractional ${ricochet_wall} 400 0.5 0.25\" &\n"
      "  \"fix ricochet_wall_large ricochet_large wall/fractional ${ricochet_wall} 500 0.5 0.25\"\n"
      "timestep ";
  CHECK(active(export_contacts(Engine::lammps, set)).starts_with(lines));
}

TEST_CASE("a set that makes no sense is refused") {
  const ContactSet good = beside_wall(linear_at_wall, linear, ContactEnd::force);
  ContactSet bad = good;
  bad.pairs.clear();
  CHECK_THROWS_AS(export_contacts(Engine::lammps, bad), std::invalid_argument);
  bad = good;
  bad.pairs[0].law = tsuji;
  CHECK_THROWS_AS(export_contacts(Engine::lammps, bad), std::invalid_argument);
  bad = good;
  std::swap(bad.pairs[0].a, bad.pairs[0].b);
  CHECK_THROWS_AS(export_contacts(Engine::lammps, bad), std::invalid_argument);
}
