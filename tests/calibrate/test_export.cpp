#include <catch2/catch.hpp>

#include <calibrate/advice.hpp>
#include <calibrate/export.hpp>
#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/peer_damping.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

// The pair of Table II of the paper: two spheres, r = 1.5 mm, 1000 kg/m³.
constexpr double radius_eff = 0.75e-3, mass_eff = 7.06858e-6;

ExportCase with(AnyLaw law, ContactEnd end) {
  return {.law = law,
          .end = end,
          .tcol = 1e-4,
          .en = 0.5,
          .impact = {0.5, mass_eff},
          .radius_eff = radius_eff,
          .density = 1000};
}

const Linear linear(7316, 0.098), linear_by_force(5211.5, 0.098);
const KuwabaraKono kuwabara_kono(1389289, 33.845);
const Tsuji tsuji(1.3e6, 1.46);
const Hysteretic hysteretic(3924, 15697);
const Fractional fractional(5225, 0.2964, 0.3197);

std::vector<ExportCase> all_cases() {
  return {with(linear, ContactEnd::overlap),      with(linear_by_force, ContactEnd::force),
          with(kuwabara_kono, ContactEnd::force), with(tsuji, ContactEnd::overlap),
          with(tsuji, ContactEnd::force),         with(hysteretic, ContactEnd::force),
          with(fractional, ContactEnd::force)};
}

/// The lines of a snippet that an engine acts on.
std::string active(const Snippet& snippet) {
  std::istringstream lines(snippet.text);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && !line.starts_with("#") && !line.starts_with("//") && !line.starts_with("!"))
      kept += line + "\n";
  return kept;
}

/// The number that follows `mark` in what the engine acts on.
double after(const Snippet& snippet, const std::string& mark) {
  const std::string text = active(snippet);
  const std::size_t at = text.find(mark);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + mark.size()));
}

bool acts_on(const Snippet& snippet, const std::string& words) {
  return active(snippet).find(words) != std::string::npos;
}

/// The line that holds `words` of what the engine acts on.
std::string line_with(const Snippet& snippet, const std::string& words) {
  std::istringstream lines(active(snippet));
  for (std::string line; std::getline(lines, line);)
    if (line.find(words) != std::string::npos) return line;
  FAIL("no line with " << words);
  return {};
}

constexpr double overlap = 1.7e-5, rate = -0.21;  // any instant of a contact

template <class Law>
double law_force(const Law& law) {
  return law.force({overlap, rate}, {});
}

std::string file(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("LAMMPS: the force formed from the snippet's numbers as LAMMPS forms it is the law's") {
  const double contact_radius = std::sqrt(radius_eff * overlap);
  const auto hooke = export_law(Engine::lammps, with(linear, ContactEnd::overlap));
  std::istringstream numbers(active(hooke).substr(active(hooke).find("hooke ") + 6));
  double stiffness, damping;
  numbers >> stiffness >> damping;
  CHECK(stiffness * overlap + damping * rate == Approx(law_force(linear)).epsilon(1e-14));
  CHECK(acts_on(hooke, "damping velocity"));
  CHECK_FALSE(acts_on(hooke, "limit_damping"));
  CHECK(acts_on(export_law(Engine::lammps, with(linear, ContactEnd::force)), "limit_damping"));

  const auto viscoelastic = export_law(Engine::lammps, with(kuwabara_kono, ContactEnd::force));
  numbers = std::istringstream(active(viscoelastic).substr(active(viscoelastic).find("hertz ") + 6));
  numbers >> stiffness >> damping;
  CHECK(contact_radius * (stiffness * overlap + damping * mass_eff * rate) ==
        Approx(law_force(kuwabara_kono)).epsilon(1e-14));
  CHECK(acts_on(viscoelastic, "damping viscoelastic"));

  // One file for every version: before and since there is a damping that takes a restitution.
  const auto hertz = export_law(Engine::lammps, with(tsuji, ContactEnd::overlap));
  CHECK(acts_on(hertz, "if \"$(version) >= 20240627\" then"));
  const std::string since = line_with(hertz, "damping coeff_restitution"), until = line_with(hertz, "damping tsuji");
  numbers = std::istringstream(since.substr(since.find("hertz ") + 6));
  numbers >> stiffness >> damping;
  const double spring = stiffness * contact_radius, log_en = std::log(damping);
  const double factor = -std::sqrt(1.5) * 2 * std::sqrt(5.0 / 6) * log_en / std::hypot(std::numbers::pi, log_en);
  CHECK(spring * overlap + factor * std::sqrt(mass_eff * spring) * rate == Approx(law_force(tsuji)).epsilon(1e-12));
  numbers = std::istringstream(until.substr(until.find("hertz ") + 6));
  numbers >> stiffness >> damping;
  CHECK(stiffness * contact_radius == spring);
  CHECK(spring * overlap + marshall_polynomial(damping) * std::sqrt(mass_eff * spring) * rate ==
        Approx(law_force(tsuji)).epsilon(1e-12));
}

TEST_CASE("LAMMPS: strong damping takes the polynomial below zero, none at all leaves it") {
  const Tsuji strong(1e6, 3 * std::sqrt(mass_eff * 1e6));
  const auto snippet = export_law(Engine::lammps, with(strong, ContactEnd::force));
  CHECK(acts_on(snippet, "\"$(version) >= 20260101\" then &\n  \"print"));  // that polynomial is another
  std::istringstream numbers(active(snippet).substr(active(snippet).find("hertz ") + 6));
  double stiffness, argument;
  numbers >> stiffness >> argument;
  CHECK(argument < 0);
  CHECK(marshall_polynomial(argument) == Approx(3).epsilon(1e-12));
  CHECK(acts_on(export_law(Engine::lammps, with(Tsuji(1e6, 0), ContactEnd::overlap)), "damping velocity"));
  const Tsuji faint(1e6, 1e-4 * std::sqrt(mass_eff * 1e6));  // under the polynomial's least value
  CHECK(export_law(Engine::lammps, with(faint, ContactEnd::overlap)).fidelity == Fidelity::absent);
}

TEST_CASE("LIGGGHTS: the force formed from the snippet's numbers as LIGGGHTS forms it is the law's") {
  const std::string each = " peratomtypepair 1 ";
  const double contact_radius = std::sqrt(radius_eff * overlap);
  const auto hooke = export_law(Engine::liggghts, with(linear, ContactEnd::overlap));
  CHECK(after(hooke, " kn" + each) * overlap + after(hooke, " gamman_abs" + each) * rate ==
        Approx(law_force(linear)).epsilon(1e-14));
  CHECK(acts_on(hooke, "absolute_damping on"));
  CHECK(acts_on(hooke, "limitForce off"));

  const auto stiffness = export_law(Engine::liggghts, with(kuwabara_kono, ContactEnd::force));
  CHECK(contact_radius *
            (after(stiffness, " kn" + each) * overlap + mass_eff * after(stiffness, " gamman" + each) * rate) ==
        Approx(law_force(kuwabara_kono)).epsilon(1e-14));
  CHECK(acts_on(stiffness, "limitForce on"));

  for (const auto end : {ContactEnd::overlap, ContactEnd::force}) {
    const auto hertz = export_law(Engine::liggghts, with(tsuji, end));
    const double nu = after(hertz, "poissonsRatio peratomtype ");
    const double modulus = 1 / (2 * (1 - nu * nu) / after(hertz, "youngsModulus peratomtype "));
    const double log_en = std::log(after(hertz, "coefficientRestitution" + each));
    const double beta = log_en / std::sqrt(log_en * log_en + std::numbers::pi * std::numbers::pi);
    const double damping = -2 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(2 * modulus * contact_radius * mass_eff);
    CHECK(4.0 / 3.0 * modulus * contact_radius * overlap + damping * rate == Approx(law_force(tsuji)).epsilon(1e-13));
    CHECK(acts_on(hertz, end == ContactEnd::force ? "limitForce on" : "limitForce off"));
  }
}

TEST_CASE("LIGGGHTS: moduli outside its usual range are allowed, restitutions outside it can't be") {
  CHECK(acts_on(export_law(Engine::liggghts, with(Tsuji(1e4, 0.01), ContactEnd::overlap)), "soft_particles yes"));
  CHECK(acts_on(export_law(Engine::liggghts, with(Tsuji(1e8, 0.01), ContactEnd::overlap)), "hard_particles yes"));
  const Tsuji lossy(1.3e6, 0.9 * std::sqrt(5 * mass_eff * 1.3e6));
  CHECK(export_law(Engine::liggghts, with(lossy, ContactEnd::force)).fidelity == Fidelity::absent);
}

TEST_CASE("LIGGGHTS: the hysteretic model reaches k2 at the deepest overlap of the target's impact") {
  const auto luding = export_law(Engine::liggghts, with(hysteretic, ContactEnd::force));
  CHECK(luding.fidelity == Fidelity::close);
  const std::string each = " peratomtypepair 1 ";
  const double k1 = after(luding, "LoadingStiffness" + each), k2 = k1 * after(luding, "UnloadingStiffness" + each);
  const double limit = k2 / (k2 - k1) * after(luding, "coefficientPlasticityDepth" + each) * 2 * radius_eff;
  CHECK(k1 == hysteretic.k1());
  CHECK(k2 == Approx(hysteretic.k2()).epsilon(1e-14));
  CHECK(limit == Approx(collide(hysteretic, {0.5, mass_eff}).max_overlap).epsilon(1e-12));
}

TEST_CASE("LIGGGHTS: the fractional law goes to the project's own model") {
  const auto snippet = export_law(Engine::liggghts, with(fractional, ContactEnd::force));
  CHECK(snippet.fidelity == Fidelity::exact);
  CHECK(after(snippet, "fractionalK peratomtypepair 1 ") == fractional.k());
  CHECK(after(snippet, "fractionalC peratomtypepair 1 ") == fractional.c());
  CHECK(after(snippet, "fractionalAlpha peratomtypepair 1 ") == fractional.alpha());
  CHECK(acts_on(snippet, "pair_style gran model fractional"));
  for (const Engine engine : {Engine::lammps, Engine::yade, Engine::mercurydpm, Engine::mfix})
    CHECK(export_law(engine, with(fractional, ContactEnd::force)).fidelity == Fidelity::absent);
}

TEST_CASE("Yade: the force formed from the snippet's numbers as Yade forms it is the law's") {
  const auto viscel = export_law(Engine::yade, with(linear, ContactEnd::force));
  CHECK(0.5 * after(viscel, "kn=") * overlap + 0.5 * after(viscel, "cn=") * rate ==
        Approx(law_force(linear)).epsilon(1e-14));

  const auto mindlin = export_law(Engine::yade, with(tsuji, ContactEnd::force));
  const double nu = after(mindlin, "poisson=");
  const double k = 4.0 / 3.0 * after(mindlin, "young=") / (2 * (1 - nu * nu)) * std::sqrt(radius_eff);
  const double damping = 2 * std::sqrt(mass_eff * 1.5 * k * std::sqrt(overlap)) * after(mindlin, "betan=");
  CHECK(k * std::pow(overlap, 1.5) + damping * rate == Approx(law_force(tsuji)).epsilon(1e-13));
}

TEST_CASE("MercuryDPM: the force formed from the snippet's numbers as MercuryDPM forms it is the law's") {
  const auto linear_species = export_law(Engine::mercurydpm, with(linear, ContactEnd::overlap));
  CHECK(after(linear_species, "setStiffness(") * overlap + after(linear_species, "setDissipation(") * rate ==
        Approx(law_force(linear)).epsilon(1e-14));

  const double geometry = 4.0 / 3.0 * std::sqrt(radius_eff * overlap);
  const auto hertz = export_law(Engine::mercurydpm, with(tsuji, ContactEnd::overlap));
  const double stiffness = geometry * after(hertz, "setEffectiveElasticModulus(");
  CHECK(stiffness * overlap + after(hertz, "setDissipation(") * std::sqrt(mass_eff * stiffness) * rate ==
        Approx(law_force(tsuji)).epsilon(1e-13));

  const auto bshp = export_law(Engine::mercurydpm, with(kuwabara_kono, ContactEnd::force));
  const double spring = geometry * after(bshp, "setEffectiveElasticModulus(");
  CHECK(spring * overlap + 1.5 * after(bshp, "setDissipation(") * spring * rate ==
        Approx(law_force(kuwabara_kono)).epsilon(1e-13));

  const auto plastic = export_law(Engine::mercurydpm, with(hysteretic, ContactEnd::force));
  CHECK(plastic.fidelity == Fidelity::exact);
  CHECK(acts_on(plastic, "setPlasticParameters(3924, 15697, 0, 1)"));
  CHECK(acts_on(plastic, "setDoConstantUnloadingStiffness(true)"));
}

TEST_CASE("MFiX: the force formed from the snippet's numbers as MFiX forms it is the law's") {
  const auto damping_factor = [](double en) {
    return std::abs(std::log(en)) / std::hypot(std::numbers::pi, std::log(en));
  };
  const auto lsd = export_law(Engine::mfix, with(linear, ContactEnd::overlap));
  const double kn = after(lsd, "KN = ");
  CHECK(kn * overlap + 2 * std::sqrt(kn * mass_eff) * damping_factor(after(lsd, "DES_EN_INPUT(1) = ")) * rate ==
        Approx(law_force(linear)).epsilon(1e-13));

  const auto hertz = export_law(Engine::mfix, with(tsuji, ContactEnd::overlap));
  const double nu = after(hertz, "V_POISSON(1) = ");
  const double k = 4.0 / 3.0 * std::sqrt(radius_eff) * after(hertz, "E_YOUNG(1) = ") / (2 * (1 - nu * nu));
  const double c = std::sqrt(5 * k * mass_eff) * damping_factor(after(hertz, "DES_EN_INPUT(1) = "));
  CHECK(k * std::pow(overlap, 1.5) + c * std::pow(overlap, 0.25) * rate == Approx(law_force(tsuji)).epsilon(1e-13));
}

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

TEST_CASE("an engine that ends contacts otherwise is said to, with what comes out") {
  const auto yade = export_law(Engine::yade, with(linear, ContactEnd::overlap));
  CHECK(yade.fidelity == Fidelity::close);
  CHECK(yade.gives.front().en ==
        Approx(restitution_of_damping(damping_ratio(linear, mass_eff), ContactEnd::force)).epsilon(1e-12));
  CHECK(yade.text.find("GIVES INSTEAD: collision time 8.6") != std::string::npos);
  const auto mercury = export_law(Engine::mercurydpm, with(linear_by_force, ContactEnd::force));
  CHECK(mercury.fidelity == Fidelity::close);
  CHECK(mercury.gives.front().status == CollisionStatus::ended_by_overlap);
  const Linear overdamped(1000, 1);
  CHECK(export_law(Engine::mercurydpm, with(overdamped, ContactEnd::force)).fidelity == Fidelity::absent);
}

TEST_CASE("laws that are scaled by the radius are not written without it") {
  ExportCase what = with(tsuji, ContactEnd::overlap);
  what.radius_eff.reset();
  for (const Engine engine : engines()) {
    const auto snippet = export_law(engine, what);
    CHECK(snippet.fidelity == Fidelity::absent);
    CHECK(active(snippet).empty());
    CHECK(snippet.text.find("--radius") != std::string::npos);
  }
}

TEST_CASE("one file of several laws acts on one of them") {
  std::vector<Snippet> snippets;
  for (const ExportCase& what : all_cases()) snippets.push_back(export_law(Engine::yade, what));
  const Snippet whole{Engine::yade, linear, ContactEnd::force, Fidelity::exact, {}, {}, combine(snippets)};
  CHECK(active(whole) == active(snippets[1]));  // the first exact one: Yade ends contacts by force
}

TEST_CASE("the snippets read as agreed") {
  for (const Engine engine : engines()) {
    std::vector<Snippet> snippets;
    for (const ExportCase& what : all_cases()) snippets.push_back(export_law(engine, what));
    const std::string name = std::string(text(engine));
    const std::string text = combine(snippets);
    CHECK(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    const std::string golden = RICOCHET_SOURCE_DIR "/tests/calibrate/golden/" + name + ".txt";
    if (std::getenv("RICOCHET_UPDATE_DOCS")) std::ofstream(golden) << text;  // as for the documents
    CAPTURE(name);
    CHECK(text == file(golden));
  }
}

TEST_CASE("a snippet sets the step that keeps the restitution, for the touch at its worst") {
  const auto lammps = export_law(Engine::lammps, with(linear, ContactEnd::overlap));
  const double step = after(lammps, "timestep ");
  const Collision exact = lammps.gives.front();
  const auto errors = step_errors(linear, ContactEnd::overlap, {exact.tcol, exact.en, {0.5, mass_eff}});
  CHECK(step == Approx(1e-4 / steps_for(errors, 0.001).value()).epsilon(1e-14));
  CHECK(after(export_law(Engine::yade, with(linear_by_force, ContactEnd::force)), "O.dt = ") > 0);
  CHECK(after(export_law(Engine::mercurydpm, with(linear, ContactEnd::overlap)), "setTimeStep(") == step);
  // MFiX divides pi/sqrt(k/m - (c/m)^2/4), which ended by overlap is the collision time itself, into whole steps; of a
  // Hertzian contact it takes the same of its k.
  const auto lsd = export_law(Engine::mfix, with(linear, ContactEnd::overlap));
  const double own = std::numbers::pi / std::sqrt(linear.k() / mass_eff - std::pow(linear.c() / mass_eff, 2) / 4);
  CHECK(own == Approx(1e-4).epsilon(1e-4));
  CHECK(after(lsd, "DTSOLID_FACTOR = ") == std::ceil(own / step));
  const auto hertz = export_law(Engine::mfix, with(tsuji, ContactEnd::overlap));
  const double factor = after(hertz, "DTSOLID_FACTOR = ");
  const double log_en = std::log(after(hertz, "DES_EN_INPUT(1) = "));
  const double as_if = std::sqrt((std::pow(std::numbers::pi, 2) + log_en * log_en) * mass_eff / tsuji.k());
  const double same = after(export_law(Engine::lammps, with(tsuji, ContactEnd::overlap)), "timestep ");
  CHECK(as_if / factor <= same);
  CHECK((factor == 10 || as_if / (factor - 1) > same));
}

TEST_CASE("engines by name, and misuse") {
  for (const Engine engine : engines()) CHECK(engine_named(text(engine)) == engine);
  CHECK_FALSE(engine_named("edem"));
  ExportCase what = with(linear, ContactEnd::overlap);
  what.en = 1.5;
  CHECK_THROWS_AS(export_law(Engine::lammps, what), std::invalid_argument);
}
