#include "export_cases.hpp"

#include <calibrate/advice.hpp>
#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/peer_damping.hpp>
#include <ricochet/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace ricochet;
using namespace ricochet::calibration;
using namespace export_cases;

namespace {

std::vector<ExportCase> all_cases() {
  return {with(linear, ContactEnd::overlap),      with(linear_by_force, ContactEnd::force),
          with(kuwabara_kono, ContactEnd::force), with(tsuji, ContactEnd::overlap),
          with(tsuji, ContactEnd::force),         with(hysteretic, ContactEnd::force),
          with(fractional, ContactEnd::force)};
}

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
  // What a damping ratio ζ and the stiffness that a modulus comes from make, at the ends of what LIGGGHTS takes.
  const auto exported = [](double stiffness, double zeta) {
    return export_law(Engine::liggghts,
                      with(Tsuji(stiffness, zeta * std::sqrt(5 * mass_eff * stiffness)), ContactEnd::overlap));
  };
  const double stiffness = 1e6 / after(exported(1e6, 0.1), "youngsModulus peratomtype ");  // of a modulus of 1 Pa
  const auto of_modulus = [&](double young) { return exported(young * stiffness, 0.1); };
  for (const auto& [young, soft, hard] :
       {std::tuple(4.99e6, true, false), {5.01e6, false, false}, {0.99e9, false, false}, {1.01e9, false, true}}) {
    CAPTURE(young);
    CHECK(acts_on(of_modulus(young), "soft_particles yes") == soft);
    CHECK(acts_on(of_modulus(young), "hard_particles yes") == hard);
    CHECK(acts_on(of_modulus(young), "soft_particles") == soft);
    CHECK(acts_on(of_modulus(young), "hard_particles") == hard);
  }
  // e = exp(−πζ/√(1−ζ²)).
  const auto of_restitution = [&](double en) {
    return exported(1.3e6, -std::log(en) / std::hypot(std::numbers::pi, std::log(en)));
  };
  CHECK(of_restitution(0.0499).fidelity == Fidelity::absent);
  CHECK(of_restitution(0.0501).fidelity == Fidelity::exact);
}

TEST_CASE("LIGGGHTS: the hysteretic model has constant k1 and k2") {
  const auto edinburgh = export_law(Engine::liggghts, with(hysteretic, ContactEnd::force));
  CHECK(edinburgh.fidelity == Fidelity::exact);
  const std::string each = " peratomtypepair 1 ";
  const double k1 = after(edinburgh, "LoadingStiffness" + each);
  CHECK(k1 == hysteretic.k1());
  CHECK(k1 * after(edinburgh, "UnloadingStiffness" + each) == Approx(hysteretic.k2()).epsilon(1e-14));
  CHECK(after(edinburgh, "overlapExponent scalar ") == 1);
  CHECK(after(edinburgh, "coefficientAdhesionStiffness" + each) == 0);
  CHECK(after(edinburgh, "coefficientRestitution" + each) == 1);
  CHECK(acts_on(edinburgh, "model edinburgh/stiffness tangential off tangential_damping off fixKc on limitForce on"));
  const auto elastic = export_law(Engine::liggghts, with(Hysteretic(4000, 4000), ContactEnd::force));
  CHECK(after(elastic, "UnloadingStiffness" + each) == 1);
}

TEST_CASE("LIGGGHTS: the fractional law goes to the project's own model") {
  const auto snippet = export_law(Engine::liggghts, with(fractional, ContactEnd::force));
  CHECK(snippet.fidelity == Fidelity::exact);
  CHECK(after(snippet, "fractionalK peratomtypepair 1 ") == fractional.k());
  CHECK(after(snippet, "fractionalC peratomtypepair 1 ") == fractional.c());
  CHECK(after(snippet, "fractionalAlpha peratomtypepair 1 ") == fractional.alpha());
  CHECK(acts_on(snippet, "pair_style gran model fractional"));
  for (const Engine engine : {Engine::yade, Engine::mercurydpm, Engine::mfix})
    CHECK(export_law(engine, with(fractional, ContactEnd::force)).fidelity == Fidelity::absent);
}

TEST_CASE("LAMMPS: the fractional law goes to the project's own driver, by the forms of both versions") {
  const auto snippet = export_law(Engine::lammps, with(fractional, ContactEnd::force));
  CHECK(snippet.fidelity == Fidelity::exact);
  CHECK(active(snippet).starts_with(
      "if \"$(version) >= 20250204\" then &\n"
      "  \"pair_style granular\" &\n"
      "  \"pair_coeff * * fractional 5225 0.2964 0.3197 damping fractional tangential linear_nohistory 0.0 0.0\" &\n"
      "else &\n"
      "  \"pair_style fractional\" &\n"
      "  \"pair_coeff * * 5225 0.2964 0.3197\"\n"
      "timestep "));
  CHECK(export_law(Engine::lammps, with(FractionalKelvinVoigt(3000, 20, 0.5), ContactEnd::overlap)).fidelity ==
        Fidelity::absent);
}

TEST_CASE("LAMMPS: laws of real solids go to the sub-models, and end the file in a driver without them") {
  const auto line = [](const AnyLaw& law) {
    const auto snippet = export_law(Engine::lammps, with(law, ContactEnd::force));
    CHECK(snippet.fidelity == Fidelity::exact);
    CHECK_FALSE(acts_on(snippet, "pair_style fractional"));
    CHECK(acts_on(snippet, "else &\n  \"print 'Ricochet: "));
    CHECK(acts_on(snippet, "\" &\n  \"quit 1\"\n"));
    return line_with(snippet, "pair_coeff");
  };
  const std::string rest = " damping fractional tangential linear_nohistory 0.0 0.0\" &";
  CHECK(line(FractionalKelvinVoigt(3000, 20, 0.5)) == "  \"pair_coeff * * fractional/kelvin_voigt 3000 20 0.5" + rest);
  CHECK(line(FractionalZener(3000, 3e5, 0.25, 0.5)) ==
        "  \"pair_coeff * * fractional/zener 3000 3e+05 0.25 0.5" + rest);
  CHECK(line(FractionalHertz(2000, 3, 0.4)) == "  \"pair_coeff * * fractional/hertz 2000 3 0.4 0.5" + rest);
}

TEST_CASE("LIGGGHTS: the laws of real solids go to the project's own models, by their parameters") {
  const FractionalKelvinVoigt kelvin_voigt(3000, 20, 0.5);
  const FractionalHertz hertz(1e6, 3e3, 0.4);
  const FractionalZener zener(3000, 3e5, 1e-9, 0.5);
  const auto of = [&](const AnyLaw& law) { return export_law(Engine::liggghts, with(law, ContactEnd::force)); };
  const auto value = [](const Snippet& snippet, const std::string& name) {
    return after(snippet, "fractional" + name + " peratomtypepair 1 ");
  };
  CHECK(value(of(kelvin_voigt), "K") == 3000);
  CHECK(value(of(kelvin_voigt), "C") == 20);
  CHECK(value(of(kelvin_voigt), "Alpha") == 0.5);
  CHECK(acts_on(of(kelvin_voigt), "pair_style gran model fractional-kelvin-voigt"));
  CHECK(value(of(zener), "K1") == 3e5);
  CHECK(value(of(zener), "Tau") == 1e-9);
  CHECK(acts_on(of(zener), "pair_style gran model fractional-zener"));
  CHECK(after(of(hertz), "characteristicVelocity scalar ") == with(hertz, ContactEnd::force).impact.velocity);
  for (const AnyLaw& law : {AnyLaw(kelvin_voigt), AnyLaw(hertz), AnyLaw(zener)}) {
    CHECK(of(law).fidelity == Fidelity::exact);
    for (const Engine engine : {Engine::yade, Engine::mercurydpm, Engine::mfix})
      CHECK(export_law(engine, with(law, ContactEnd::force)).fidelity == Fidelity::absent);
  }
  CHECK(export_law(Engine::liggghts, with(kelvin_voigt, ContactEnd::overlap)).fidelity == Fidelity::absent);
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

TEST_CASE("among laws that an engine runs in its own way, the one that gives what was asked is acted on") {
  const auto snippet = [](Fidelity fidelity, double off, const std::string& text) {
    return Snippet{Engine::yade, linear, ContactEnd::force, fidelity, {}, {}, text + "\n", off};
  };
  const auto first = snippet(Fidelity::close, 0.14, "a"), met = snippet(Fidelity::close, 1e-9, "b"),
             same = snippet(Fidelity::close, 0, "c"), none = snippet(Fidelity::absent, 0, "d");
  CHECK(combine({none, first, met, same}) == "# d\n\n# a\n\nb\n\n# c\n");
  CHECK(combine({first, snippet(Fidelity::exact, 0, "e")}) == "# a\n\ne\n");
  CHECK(combine({snippet(Fidelity::close, 1.1e-3, "a"), same}) == "# a\n\nc\n");
  CHECK(combine({snippet(Fidelity::close, 0.9e-3, "a"), same}) == "a\n\n# c\n");
  // Its own end costs Yade a seventh of the collision time; ended by force the law is run as it is.
  const auto by_overlap = export_law(Engine::yade, with(linear, ContactEnd::overlap));
  CHECK(by_overlap.off == Approx(1 - by_overlap.gives.front().tcol / 1e-4).epsilon(1e-12));
  CHECK(export_law(Engine::yade, with(linear_by_force, ContactEnd::force)).off < 1e-4);  // its numbers are rounded
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
  const auto errors =
      step_errors(linear, ContactEnd::overlap, {exact.tcol, exact.en, {0.5, mass_eff}}, Stepping::half_step);
  CHECK(step == Approx(1e-4 / steps_for(errors, 0.001, Stepping::half_step).value()).epsilon(1e-14));
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

TEST_CASE("a step that is asked for is written, with what it does to the restitution") {
  const auto asked_of = [](Engine engine, const AnyLaw& law, ContactEnd end, double step) {
    ContactSet set{end, {{.name = "grain"}}, {{0, 0, law, 1e-4, 0.5, {0.5, mass_eff}, radius_eff}}};
    set.step = step;
    return export_contacts(engine, set);
  };
  CHECK(after(asked_of(Engine::lammps, linear, ContactEnd::overlap, 2e-6), "timestep ") == 2e-6);
  CHECK(after(asked_of(Engine::liggghts, linear, ContactEnd::overlap, 2e-6), "timestep ") == 2e-6);
  CHECK(after(asked_of(Engine::yade, linear_by_force, ContactEnd::force, 2e-6), "O.dt = ") == 2e-6);
  CHECK(after(asked_of(Engine::mercurydpm, linear, ContactEnd::overlap, 2e-6), "setTimeStep(") == 2e-6);
  // MFiX divides a time of its own, which is the collision time.
  const double own = std::numbers::pi / std::sqrt(linear.k() / mass_eff - std::pow(linear.c() / mass_eff, 2) / 4);
  CHECK(after(asked_of(Engine::mfix, linear, ContactEnd::overlap, 2e-6), "DTSOLID_FACTOR = ") == std::ceil(own / 2e-6));

  const auto said = [](const Snippet& snippet) {
    std::string words = snippet.text.substr(snippet.text.find("Time step: "));
    for (std::size_t at; (at = words.find("\n# ")) != std::string::npos;) words.replace(at, 3, " ");
    return words;
  };
  const Collision exact = collide(linear, {0.5, mass_eff}, {.end = ContactEnd::overlap});
  const double error =
      step_error(linear, ContactEnd::overlap, {exact.tcol, exact.en, {0.5, mass_eff}}, 50, Stepping::half_step);
  const std::string by_lammps = said(asked_of(Engine::lammps, linear, ContactEnd::overlap, 2e-6));
  CHECK(by_lammps.starts_with("Time step: 2e-06 s (tcol/50), as asked: the restitution is up to " +
                              support::significant(100 * error, 2) + " % off; 1.25e-06 s (tcol/80) keeps it to 1 %"));
  CHECK(by_lammps.find(" warns of ") == std::string::npos);
  // What the driver says of such a step.
  const std::string coarse = said(asked_of(Engine::lammps, fractional, ContactEnd::force, 1e-5)),
                    enough = said(asked_of(Engine::lammps, fractional, ContactEnd::force, 5e-6));
  CHECK(coarse.find("(lammps-ricochet warns of fewer than 20 steps in a collision and refuses fewer than 4)") !=
        std::string::npos);
  CHECK(enough.find(" warns of ") == std::string::npos);
}

TEST_CASE("engines by name, and misuse") {
  for (const Engine engine : engines()) CHECK(engine_named(text(engine)) == engine);
  CHECK_FALSE(engine_named("edem"));
  CHECK_FALSE(engine_named("lammps-ricochet"));
  for (const Engine engine : engines()) CHECK(engine_run_by(text(engine)) == engine);
  CHECK(engine_run_by("lammps-ricochet") == Engine::lammps);
  CHECK(engine_run_by("liggghts-ricochet") == Engine::liggghts);
  CHECK_FALSE(engine_run_by(""));
  ExportCase what = with(linear, ContactEnd::overlap);
  what.en = 1.5;
  CHECK_THROWS_AS(export_law(Engine::lammps, what), std::invalid_argument);
}
