#include "case_json.hpp"

namespace ricochet::verify::conformance {

namespace {

using console::Json;

Json json(Vec3 v) { return {v.x, v.y, v.z}; }

Json json(const Body& b) {
  return {{"radius", b.radius},           {"mass", b.mass},
          {"inertia", b.inertia()},       {"position", json(b.position)},
          {"velocity", json(b.velocity)}, {"spin", json(b.spin)}};
}

Json named(std::string_view name, const std::vector<double>& values, std::span<const Parameter> parameters) {
  Json all = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) all[std::string(parameters[i].name)] = values[i];
  return {{"name", name}, {"parameters", all}};
}

Json json(const std::optional<Meeting>& meeting) {
  if (!meeting) return nullptr;
  const LawKind kind = LawKind::of(meeting->law);
  Json law = named(kind.name(), values(meeting->law), kind.parameters());
  law["end"] = meeting->end == ContactEnd::force ? "force" : "overlap";
  return law;
}

/// All that an engine needs to do as the case asks.
std::string rule_of(const TangentialContact& contact) {
  std::string rule =
      "Spring and dashpot side by side, a slider behind both. u: velocity of body 1 at the contact less that of the "
      "other there, across the normal; xi: strain of the spring, 0 at the touch, turned with the normal; T: force on "
      "body 1; F = max(0, normal force of repulsion). A contact sticks, xi' = u and T = -k xi - c u, while |T| <= mu "
      "F; "
      "else it slides, T = -mu F q with q the direction of k xi + c u, and the spring follows what the slider leaves: "
      "c xi' = mu F q - k xi (c = 0: xi = mu F q/k). As a step dt: K = k + c/dt, T = -k xi - K u dt, shortened to mu F "
      "where it is longer, then xi = (c xi/dt - T)/K.";
  if (std::holds_alternative<MindlinTangential>(contact.law))
    rule +=
        " k = k_t sqrt(overlap): while it grows the force stays (xi falls as 1/k), while it shrinks the strain stays "
        "(the force falls as k).";
  if (contact.torsion.limit != Torsion::Limit::none)
    rule +=
        " Torsion: the same about the normal, xi an angle, u the spin of body 1 less that of the other, the limit arm "
        "a "
        "mu F with a half the chord of the overlap, sqrt(overlap (2 r - overlap)) on a wall.";
  if (contact.rolling.mu > 0)
    rule +=
        " Rolling: the same across the normal, xi an angle, u the spin of body 1 less that of the other, the limit "
        "mu_rolling R F with 1/R = 1/r1 + 1/r2.";
  return rule;
}

Json json(const std::optional<TangentialContact>& contact) {
  if (!contact) return nullptr;
  Json law = named(name(contact->law), values(contact->law), parameters_of(contact->law));
  law["mu"] = contact->friction.mu_static();
  const Torsion& t = contact->torsion;
  law["torsion"] = t.limit == Torsion::Limit::none
                       ? Json(false)
                       : Json{{"arm", t.arm}, {"stiffness", t.spring.stiffness}, {"damping", t.spring.damping}};
  law["mu_rolling"] = contact->rolling.mu;
  law["k_rolling"] = contact->rolling.spring.stiffness;
  law["c_rolling"] = contact->rolling.spring.damping;
  law["rule"] = rule_of(*contact);
  return law;
}

Json json(const Answer& a, const std::string& how) {
  return {{"quantity", name(a.quantity)},
          {"body", a.body},
          {"value", a.value},
          {"scale", a.scale},
          {"error", a.error},
          {"how", how},
          {"required", a.required}};
}

}  // namespace

Json to_json(const Orders& expected) { return {{"leapfrog", expected.leapfrog}, {"located", expected.located}}; }

Json to_json(const Case& of) {
  Json bodies = Json::array(), walls = Json::array(), all = Json::array();
  for (const Body& b : of.bodies) bodies.push_back(json(b));
  for (const Plane& w : of.walls) walls.push_back({{"point", json(w.point)}, {"normal", json(w.normal)}});
  for (const Answer& a : answers(of)) all.push_back(json(a, of.how));
  return {{"schema", "ricochet/case/1"},
          {"case", of.name},
          {"family", of.family},
          {"title", of.title},
          {"source", of.source},
          {"bodies", bodies},
          {"walls", walls},
          {"gravity", json(of.gravity)},
          {"law", json(of.law)},
          {"wall_law", json(of.wall_law)},
          {"tangential", json(of.tangential)},
          {"flight_steps", of.flight_steps},
          {"time_scale", of.time_scale},
          {"steps", of.steps},
          {"duration", of.duration},
          {"answers", all},
          {"expected_order", to_json(of.orders)}};
}

}  // namespace ricochet::verify::conformance
