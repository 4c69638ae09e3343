#include "oblique.hpp"

#include "../slider.hpp"

#include <calibrate/advice.hpp>
#include <calibrate/calibration.hpp>
#include <console/exit.hpp>
#include <ricochet/collision/oblique.hpp>
#include <ricochet/collision/tangential_restitution.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify::engines {

namespace {

using calibration::Engine;
using console::Notation;

constexpr double mu = 0.3, en = 0.8, beta0 = 0.5, poisson = 0.3;
/// So slow that arms and normal are those of the first touch: the overlap is 2e-5 of the radius, a pair turns by less
/// than 1e-4.
constexpr double slow = 1e-3;  // m/s
/// Sticks nearly throughout, both, slides throughout: rigid friction would slide from 62° on.
constexpr double angles[] = {20, 45, 70};

/// The normal law and the tangential part of a contact between bodies of effective mass m.
struct Laws {
  AnyLaw normal;
  calibration::TangentialPart part;
};

/// The laws of the round trip by name.
struct Kind {
  const char* name = "";
  LawKind normal{};
  Laws (*make)(const AnyLaw& normal, double mass_eff) = nullptr;
};

Laws undamped(const AnyLaw& normal, double m) {
  return {normal, {tangential_for(beta0, tcol, m, StickingForm::undamped), mu}};
}
Laws damped(const AnyLaw& normal, double m) {
  return {normal, {tangential_for(beta0, tcol, m, StickingForm::damped), mu}};
}
/// k_t = 8 G*√R of the moduli that make k: k_t/k = 3 (1−ν)/(2−ν).
Laws mindlin(const AnyLaw& normal, double) {
  return {normal, {MindlinTangential(3 * (1 - poisson) / (2 - poisson) * values(normal).front()), mu}};
}

const Kind kinds[] = {{"linear, undamped", kind_of<Linear>, undamped},
                      {"linear, damped", kind_of<Linear>, damped},
                      {"mindlin", kind_of<Tsuji>, mindlin},
                      {"linear, undamped", kind_of<Fractional>, undamped}};

Encounter at_angle(Encounter who, double angle) {
  who.velocity = slow;
  who.across = slow * std::tan(angle * std::numbers::pi / 180);
  return who;
}

/// What our oblique collision makes of it.
ObliqueCollision ours(const Laws& laws, const Encounter& who) {
  const ImpactBody a{.mass = who.a.mass(), .radius = who.a.radius, .velocity = {who.velocity, who.across, 0}};
  const ImpactBody b = who.b ? ImpactBody{.mass = who.b->mass(), .radius = who.b->radius} : ImpactBody::wall();
  return collide(laws.normal, TangentialContact{.law = laws.part.law, .friction = Friction(mu, mu, 0)},
                 ObliqueImpact{.normal = {1, 0, 0}, .i = a, .j = b});
}

Rule rule_of(Engine engine) {
  if (engine == Engine::liggghts) return {true, Rule::Keeps::strain};
  if (engine == Engine::yade) return {true, Rule::Keeps::force};
  return {};
}

/// R of the two laws that are run here.
double repelling(const AnyLaw& law, const Approach& state) {
  const auto* linear = std::get_if<Linear>(&law);
  return std::max(0.0, linear ? linear->force(state, {}) : std::get<Tsuji>(law).force(state, {}));
}

/// The engine's rule stepped by leapfrog; the overlap's share of the arms and the turning of the normal left out:
/// u' = (7/2) T/m, V' = T/m, and of a sphere of mass m_a r ω' = (5/2) T/m_a.
ObliqueMeasured stepped(const Rule& rule, const Laws& laws, const Encounter& who, double step) {
  double overlap = -steps_before_touch * step * who.velocity, rate = who.velocity;
  double slip = who.across, across = who.across, turned = 0;
  Slider slider(rule);
  for (long n = 0; n <= std::lround(who.duration() / step); ++n) {
    if (overlap > 0) {
      const double force = repelling(laws.normal, {overlap, rate});
      const double traction = slider.act(spring(laws.part.law, overlap), slip, step, mu * force);
      rate -= force / who.mass_eff() * step;
      slip += 3.5 * traction / who.mass_eff() * step;
      across += traction / who.mass_eff() * step;
      turned += 2.5 * traction / who.a.mass() * step;
    }
    overlap += rate * step;
  }
  return {across / who.across, std::abs(turned) / std::hypot(who.velocity, who.across)};
}

/// In the limit of small steps, by two of them.
ObliqueMeasured by_rule(const Rule& rule, const Laws& laws, const Encounter& who) {
  constexpr double steps = 20000;
  const ObliqueMeasured coarse = stepped(rule, laws, who, who.tcol / steps),
                        fine = stepped(rule, laws, who, who.tcol / (2 * steps));
  return {2 * fine.et - coarse.et, 2 * fine.spin - coarse.spin};
}

calibration::PairCase pair_of(const Kind& kind, const Encounter& who) {
  const Impact impact{slow, who.mass_eff()};
  const calibration::Request request{kind.normal, ContactEnd::force, {tcol, en, impact}};
  const AnyLaw normal =
      std::get<calibration::Calibration>(calibration::calibrate(request, {.method = calibration::Method::direct})).law;
  const Laws laws = kind.make(normal, who.mass_eff());
  return {0, who.b ? std::size_t{0} : 1, laws.normal, tcol, en, impact, who.radius_eff(), laws.part};
}

}  // namespace

std::vector<ObliqueContact> oblique_contacts(Engine engine) {
  std::vector<ObliqueContact> contacts;
  for (const Kind& kind : kinds) {
    Encounter both[] = {sphere_and_wall(), two_spheres()};
    both[1].walls = both[0].walls;
    calibration::ContactSet set{ContactEnd::force,
                                {{.name = "grain", .density = both[0].a.density, .poisson = poisson},
                                 {.name = "wall", .wall = true, .poisson = poisson}},
                                {pair_of(kind, both[0]), pair_of(kind, both[1])}};
    const auto snippet = calibration::export_contacts(engine, set);
    if (snippet.fidelity == calibration::Fidelity::absent) continue;
    for (std::size_t i = 0; i < 2; ++i)
      for (const double angle : angles) {
        const Encounter who = at_angle(both[i], angle);
        const auto& pair = set.pairs[i];
        const ObliqueCollision c = ours({pair.law, *pair.tangential}, who);
        const double speed = std::hypot(who.velocity, who.across);
        const bool fractional = calibration::is_located(pair.law, ContactEnd::force);
        const ObliqueMeasured exact{c.et.value(), norm(c.spin_i) * who.a.radius / speed};
        contacts.push_back({.what = {.engine = engine,
                                     .name = fmt::format("{}, {}", kind.normal.name(), i == 0 ? "wall" : "pair"),
                                     .snippet = snippet.text,
                                     .end = ContactEnd::force,
                                     .en_asked = en,
                                     .en = en,
                                     .tcol = tcol,
                                     .law = pair.law,
                                     .who = who,
                                     .fractional = fractional},
                            .tangential = kind.name,
                            .angle = angle,
                            .exact = snippet.fidelity == calibration::Fidelity::exact,
                            .ours = exact,
                            .rule = fractional ? exact : by_rule(rule_of(engine), {pair.law, *pair.tangential}, who)});
      }
  }
  return contacts;
}

double ObliqueOutcome::difference(const ObliqueMeasured& a, const ObliqueMeasured& b) const {
  const double across = std::sin(what.angle * std::numbers::pi / 180);
  return std::max(across * std::abs(a.et - b.et), std::abs(a.spin - b.spin));
}

ObliqueOutcome run(const EngineProgram& program, const ObliqueContact& what) {
  const Encounter& who = what.what.who;
  std::vector<double> steps;
  for (const int n : resolutions) steps.push_back(who.tcol / n);
  ObliqueOutcome outcome{.what = what};
  const double speed = std::hypot(who.velocity, who.across);
  for (const Trajectory& path : program.run(what.what.snippet, who, steps)) {
    if (path.size() < 3) throw console::Failed(fmt::format("no trajectory came back of {}", what.what.name));
    outcome.at.push_back({path.back().across / who.across, std::abs(path.back().spin) * who.a.radius / speed});
  }
  const ObliqueMeasured &coarse = outcome.at[at_200], &fine = outcome.at[finest];
  outcome.limit = {2 * fine.et - coarse.et, 2 * fine.spin - coarse.spin};
  return outcome;
}

namespace {

/// The three angles of one contact, one after the other as they were run.
using Angles = std::vector<const ObliqueOutcome*>;
std::vector<Angles> by_contact(const std::vector<ObliqueOutcome>& outcomes) {
  std::vector<Angles> all;
  for (const ObliqueOutcome& o : outcomes) {
    if (o.what.angle == angles[0]) all.emplace_back();
    all.back().push_back(&o);
  }
  return all;
}

/// The greatest error over the angles at each step.
std::vector<double> errors_of(const Angles& contact) {
  std::vector<double> errors(std::size(resolutions), 0);
  for (std::size_t i = 0; i < errors.size(); ++i)
    for (const ObliqueOutcome* o : contact) errors[i] = std::max(errors[i], o->error(i));
  return errors;
}

/// Slope of log error over log step, by least squares over all steps.
double order_of(const std::vector<double>& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(errors.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = -std::log(resolutions[i]), y = std::log(errors[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string label(const ObliqueContact& c) {
  return fmt::format("{}: {}, {}", text(c.what.engine), c.what.name, c.tangential);
}

}  // namespace

console::Table oblique_table(const std::vector<ObliqueOutcome>& outcomes) {
  const Notation five{Notation::Kind::fixed, 5}, power{Notation::Kind::scientific, 1};
  console::Table table({{"engine"},
                        {"contact"},
                        {"tangential"},
                        {"angle", "°", {Notation::Kind::fixed, 0}},
                        {"e_t, ours", "", five},
                        {"e_t, rule", "", five},
                        {"e_t, limit", "", five},
                        {"spin, ours", "v/r", five},
                        {"spin, limit", "v/r", five},
                        {"error, tcol/25", "", power},
                        {"error, tcol/400", "", power},
                        {"order"},
                        {"law"}},
                       "Oblique impacts: tangential restitution of the centres and spin after");
  for (const Angles& contact : by_contact(outcomes)) {
    const std::string order = fmt::format("{:.2f}", order_of(errors_of(contact)));
    for (const ObliqueOutcome* o : contact)
      table.row({std::string(text(o->what.what.engine)), o->what.what.name, o->what.tangential, o->what.angle,
                 o->what.ours.et, o->what.rule.et, o->limit.et, o->what.ours.spin, o->limit.spin, o->error(0),
                 o->error(finest), o == contact.front() ? order : std::string(),
                 std::string(o->what.exact ? "the same" : "another")});
  }
  table.note(fmt::format(
      "mu = {}, e_n = {}, beta0 = {}, {} m/s along the normal. ours: the oblique collision, exact to 1e-9; rule: what "
      "the "
      "engine is said to do, stepped here; limit: the engine's, extrapolated to step 0. error: of e_t and spin from "
      "the "
      "rule, in units of the velocity; order: of the greatest over the angles. another: the engine's law differs from "
      "the one asked for, as its file says.",
      mu, en, beta0, slow));
  return table;
}

std::vector<Gate> oblique_gates(const std::vector<ObliqueOutcome>& outcomes) {
  std::vector<Gate> gates;
  for (const Angles& contact : by_contact(outcomes)) {
    double ours = 0, rule = 0;
    for (const ObliqueOutcome* o : contact) {
      ours = std::max(ours, o->difference(o->limit, o->what.ours));
      rule = std::max(rule, o->difference(o->limit, o->what.rule));
    }
    const std::string name = label(contact.front()->what), limit = ": e_t and spin in the limit, from ";
    if (contact.front()->what.exact)
      gates.push_back(at_most(name + limit + "ours", ours, 1e-3));
    else
      gates.push_back(at_least(name + limit + "ours, which is another law", ours, 1e-3));
    if (!contact.front()->what.what.fractional) gates.push_back(at_most(name + limit + "its rule", rule, 1e-3));
    gates.push_back(between(name + ": order in the step", order_of(errors_of(contact)), 0.7, 1.3));
  }
  return gates;
}

console::Json oblique_rows(const std::vector<ObliqueOutcome>& outcomes) {
  console::Json rows = console::Json::array();
  for (const ObliqueOutcome& o : outcomes) {
    console::Json et = console::Json::array(), spin = console::Json::array();
    for (const ObliqueMeasured& m : o.at) et.push_back(m.et), spin.push_back(m.spin);
    rows.push_back({{"engine", text(o.what.what.engine)},
                    {"contact", o.what.what.name},
                    {"tangential", o.what.tangential},
                    {"angle_deg", o.what.angle},
                    {"same_law", o.what.exact},
                    {"et_ours", o.what.ours.et},
                    {"spin_ours", o.what.ours.spin},
                    {"et_rule", o.what.rule.et},
                    {"spin_rule", o.what.rule.spin},
                    {"et", et},
                    {"spin", spin},
                    {"et_limit", o.limit.et},
                    {"spin_limit", o.limit.spin}});
  }
  return rows;
}

}  // namespace ricochet::verify::engines
