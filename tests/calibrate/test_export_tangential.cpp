// What the exports say of the tangential part: the force formed from a file's numbers as each engine forms it.

#include <calibrate/export.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr double radius_eff = 0.75e-3, mass_eff = 7.06858e-6, overlap = 1.7e-5, mu = 0.3;
const Linear linear(5211.5, 0.098);
const Tsuji tsuji(1.3e6, 1.46);
const LinearTangential undamped(2500), damped(2500, 0.03);
const MindlinTangential mindlin(1.5 * 1.3e6);  // 6 G*/E* = 1.5, which is ν = 0: (1−4q)/(1−2q) at q = 1/4

ExportCase with(AnyLaw law, TangentialLaw tangential) {
  return {law, ContactEnd::force, 1e-4, 0.5, {0.5, mass_eff}, radius_eff, 1000, TangentialPart{tangential, mu}};
}

/// The number that follows `mark`.
double after(const Snippet& snippet, const std::string& mark) {
  const std::size_t at = snippet.text.rfind(mark);
  INFO(snippet.text);
  REQUIRE(at != std::string::npos);
  return std::stod(snippet.text.substr(at + mark.size()));
}

/// 8 G* a of two equal bodies [N/m].
double sheared(double young, double poisson) {
  const double g = young / (2 * (1 + poisson));
  return 8 * g / (2 * (2 - poisson)) * std::sqrt(radius_eff * overlap);
}

}  // namespace

TEST_CASE("LAMMPS: linear_history takes k_t, c_t over c and mu, mindlin_rescale/force 8 G*") {
  const auto linear_history = export_law(Engine::lammps, with(linear, damped));
  const std::string mark = "tangential linear_history ";
  CHECK(after(linear_history, mark) == 2500);
  const std::string rest = linear_history.text.substr(linear_history.text.find(mark) + mark.size());
  std::size_t next = rest.find(' ') + 1;
  CHECK(std::stod(rest.substr(next)) * linear.c() == Approx(damped.c_t()).epsilon(1e-14));
  next = rest.find(' ', next) + 1;
  CHECK(std::stod(rest.substr(next)) == mu);
  CHECK(linear_history.fidelity == Fidelity::close);  // its dashpot feels the slip
  CHECK(export_law(Engine::lammps, with(linear, undamped)).fidelity == Fidelity::exact);

  const auto hertz = export_law(Engine::lammps, with(tsuji, mindlin));
  CHECK(hertz.fidelity == Fidelity::exact);
  CHECK(after(hertz, "tangential mindlin_rescale/force ") * std::sqrt(radius_eff * overlap) ==
        Approx(mindlin.spring(overlap).stiffness).epsilon(1e-14));
  CHECK(export_law(Engine::lammps, with(tsuji, undamped)).fidelity == Fidelity::exact);
  // No normal damping that is constant: nothing to multiply.
  CHECK(export_law(Engine::lammps, with(tsuji, damped)).fidelity == Fidelity::absent);
  CHECK(export_law(Engine::lammps, with(Linear(5000, 0), damped)).fidelity == Fidelity::absent);
}

TEST_CASE("LAMMPS: beside laws with a memory c_t over the damping of the linear contact of the same t_col and e_n") {
  const Fractional law(5225, 0.2964, 0.3197);
  const auto snippet = export_law(Engine::lammps, with(law, damped));
  const std::string mark = "tangential linear_history ";
  CHECK(after(snippet, mark) == 2500);
  const std::string rest = snippet.text.substr(snippet.text.find(mark) + mark.size());
  // -2 m ln(e_n)/t_col of the pair, 1e-4 s and 0.5.
  CHECK(std::stod(rest.substr(rest.find(' ') + 1)) * 2 * mass_eff * std::log(2.0) / 1e-4 ==
        Approx(damped.c_t()).epsilon(1e-14));
  CHECK(snippet.fidelity == Fidelity::close);  // its dashpot feels the slip
  // The older driver has no friction, and says so instead of running without.
  CHECK(snippet.text.find("pair_style fractional") == std::string::npos);
  CHECK(snippet.text.find("\"quit 1\"") != std::string::npos);
  CHECK(export_law(Engine::lammps, with(law, undamped)).fidelity == Fidelity::exact);
  const auto mindlin_beside = export_law(Engine::lammps, with(FractionalHertz(1e6, 3e3, 0.4), mindlin));
  CHECK(after(mindlin_beside, "tangential mindlin_rescale/force ") ==
        Approx(mindlin.k_t() / std::sqrt(radius_eff)).epsilon(1e-14));
  ExportCase elastic = with(law, damped);
  elastic.en = 1;
  CHECK(export_law(Engine::lammps, elastic).fidelity == Fidelity::absent);  // no damping to multiply
}

TEST_CASE("LIGGGHTS: kt, gammat_abs and coefficientFriction, or the moduli that shear as asked") {
  const auto hooke = export_law(Engine::liggghts, with(linear, damped));
  CHECK(after(hooke, "kt peratomtypepair 1 ") == 2500);
  CHECK(after(hooke, "gammat_abs peratomtypepair 1 ") == 0.03);
  CHECK(after(hooke, "coefficientFriction peratomtypepair 1 ") == mu);
  CHECK(hooke.text.find("tangential history absolute_damping on limitForce on tangential_damping on") !=
        std::string::npos);
  CHECK(hooke.fidelity == Fidelity::close);
  CHECK(export_law(Engine::liggghts, with(linear, undamped)).fidelity == Fidelity::exact);

  const auto hertz = export_law(Engine::liggghts, with(tsuji, mindlin));
  CHECK(sheared(after(hertz, "youngsModulus peratomtype "), after(hertz, "poissonsRatio peratomtype ")) ==
        Approx(mindlin.spring(overlap).stiffness).epsilon(1e-12));
  CHECK(after(hertz, "poissonsRatio peratomtype ") == Approx(0).margin(1e-12));
  CHECK(hertz.fidelity == Fidelity::close);
  // ν = 0.1, k_t/k = 3 (1−ν)/(2−ν).
  CHECK(after(export_law(Engine::liggghts, with(tsuji, MindlinTangential(3 * 0.9 / 1.9 * 1.3e6))),
              "poissonsRatio peratomtype ") == Approx(0.1).epsilon(1e-12));
  // k_t/k = 6 G*/E* of one material lies between 1 (ν = 1/2) and 2 (ν = −1).
  for (const double ratio : {0.99, 2.01})
    CHECK(export_law(Engine::liggghts, with(tsuji, MindlinTangential(ratio * 1.3e6))).fidelity == Fidelity::absent);
  CHECK(export_law(Engine::liggghts, with(tsuji, undamped)).fidelity == Fidelity::absent);
  CHECK(export_law(Engine::liggghts, with(linear, mindlin)).fidelity == Fidelity::absent);
}

TEST_CASE("LIGGGHTS: beside laws with a memory kt and gammat_abs of liggghts-ricochet") {
  for (const AnyLaw& law : {AnyLaw(Fractional(5225, 0.2964, 0.3197)), AnyLaw(FractionalHertz(1e6, 3e3, 0.4))}) {
    const auto snippet = export_law(Engine::liggghts, with(law, damped));
    CHECK(after(snippet, "kt peratomtypepair 1 ") == 2500);
    CHECK(after(snippet, "gammat_abs peratomtypepair 1 ") == 0.03);
    CHECK(after(snippet, "coefficientFriction peratomtypepair 1 ") == mu);
    CHECK(snippet.text.find("tangential history tangential_damping on") != std::string::npos);
    CHECK(snippet.fidelity == Fidelity::close);
    const auto spring = export_law(Engine::liggghts, with(law, undamped));
    CHECK(spring.text.find("tangential history tangential_damping off") != std::string::npos);
    CHECK(spring.fidelity == Fidelity::exact);
    CHECK(export_law(Engine::liggghts, with(law, mindlin)).fidelity == Fidelity::absent);  // constant k_t
  }
}

TEST_CASE("Yade: ks and cs of the materials in series, frictAngle; or the moduli that shear as asked") {
  const auto series = export_law(Engine::yade, with(linear, damped));
  CHECK(after(series, "ks=") == Approx(2 * 2500).epsilon(1e-14));
  CHECK(after(series, "cs=") == Approx(2 * 0.03).epsilon(1e-14));
  CHECK(std::tan(after(series, "frictAngle=")) == Approx(mu).epsilon(1e-14));
  CHECK(series.fidelity == Fidelity::close);
  CHECK(export_law(Engine::yade, with(linear, undamped)).fidelity == Fidelity::exact);
  const auto hertz = export_law(Engine::yade, with(tsuji, mindlin));
  CHECK(sheared(after(hertz, "young="), after(hertz, "poisson=")) ==
        Approx(mindlin.spring(overlap).stiffness).epsilon(1e-12));
  CHECK(hertz.fidelity == Fidelity::close);
}

TEST_CASE("MercuryDPM and MFiX: setters of the sliding species, shares of k and c") {
  const auto sliding = export_law(Engine::mercurydpm, with(linear, damped));
  CHECK(sliding.text.find("copyAndAddObject(LinearViscoelasticSlidingFrictionSpecies())") != std::string::npos);
  CHECK(after(sliding, "setSlidingStiffness(") == 2500);
  CHECK(after(sliding, "setSlidingDissipation(") == 0.03);
  CHECK(after(sliding, "setSlidingFrictionCoefficient(") == mu);
  CHECK(export_law(Engine::mercurydpm, with(tsuji, mindlin)).fidelity == Fidelity::absent);

  const auto lsd = export_law(Engine::mfix, with(linear, damped));
  CHECK(after(lsd, "KT_FAC = ") * after(lsd, "KN = ") == Approx(2500).epsilon(1e-14));
  CHECK(after(lsd, "DES_ETAT_FAC = ") * linear.c() == Approx(0.03).epsilon(1e-14));
  CHECK(after(lsd, "MEW = ") == mu);
  // MFiX refuses a share above 1.
  CHECK(export_law(Engine::mfix, with(linear, LinearTangential(6000))).fidelity == Fidelity::absent);
  const auto hertz = export_law(Engine::mfix, with(tsuji, mindlin));
  CHECK(sheared(after(hertz, "E_YOUNG(1) = "), after(hertz, "V_POISSON(1) = ")) ==
        Approx(mindlin.spring(overlap).stiffness).epsilon(1e-12));
}

TEST_CASE(
    "friction under attraction, which every engine but Yade has: a contact ended by overlap is close, and says so") {
  const auto by_overlap = [](Engine engine, double en) {
    ExportCase what = with(linear, undamped);
    what.end = ContactEnd::overlap;
    what.en = en;
    return export_law(engine, what);
  };
  const auto rubs = [](const Snippet& snippet) { return snippet.text.find("limits friction by mu |F_n|"); };
  for (const Engine engine : {Engine::lammps, Engine::liggghts, Engine::mercurydpm, Engine::mfix}) {
    CHECK(by_overlap(engine, 0.5).fidelity == Fidelity::close);
    CHECK(rubs(by_overlap(engine, 0.5)) != std::string::npos);
    CHECK(by_overlap(engine, 1).fidelity == Fidelity::exact);  // an elastic contact never attracts
  }
  CHECK(rubs(by_overlap(Engine::yade, 0.5)) == std::string::npos);
  CHECK(rubs(export_law(Engine::lammps, with(linear, undamped))) == std::string::npos);
  CHECK(rubs(export_law(Engine::mfix, with(linear, undamped))) != std::string::npos);  // it ends by overlap
  ExportCase smooth = with(linear, undamped);
  smooth.end = ContactEnd::overlap;
  smooth.tangential.reset();
  CHECK(export_law(Engine::lammps, smooth).fidelity == Fidelity::exact);
}

TEST_CASE("no engine has the rigid law, and what a file has of the tangential part it says") {
  for (const Engine engine : engines()) {
    CHECK(export_law(engine, with(linear, RigidTangential{})).fidelity == Fidelity::absent);
    CHECK(export_law(engine, with(linear, undamped))
              .text.find("Tangential: linear, k_t = 2500 kg/s^2, c_t = 0 kg/s, mu = "
                         "0.3") != std::string::npos);
  }
  ContactSet mixed{ContactEnd::force,
                   {{.name = "grain"}, {.name = "wall", .wall = true}},
                   {{0, 0, linear, 1e-4, 0.5, {0.5, mass_eff}, radius_eff, TangentialPart{undamped, mu}},
                    {0, 1, linear, 1e-4, 0.5, {0.5, mass_eff}, radius_eff, std::nullopt}}};
  CHECK_THROWS_AS(export_contacts(Engine::lammps, mixed), std::invalid_argument);
}
