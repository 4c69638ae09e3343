#include "body.hpp"

#include <calibrate/materials.hpp>
#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/support/require.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace ricochet::calibration {

Body absent(std::string why) { return {.remarks = {std::move(why)}}; }

Body no_such_law(std::string_view engine, std::string_view law) {
  return absent(fmt::format("NOT WRITTEN: {} has no {} law.", engine, law));
}

Body no_memory(std::string_view engine) {
  return absent(
      fmt::format("NOT WRITTEN: {} has no law with memory; LIGGGHTS and LAMMPS run it through liggghts-ricochet and "
                  "lammps-ricochet.",
                  engine));
}

Body needs_radius() {
  return absent(
      "NOT WRITTEN: this law's input depends on the grains' radius here. Give --radius and --density "
      "instead of --mass-eff.");
}

Body needs_materials(std::string_view engine) {
  return absent(
      fmt::format("NOT WRITTEN: {} makes a pair's stiffness of both bodies' material, and no materials make "
                  "those of all these pairs. Give moduli or stiffnesses of materials, or other collision "
                  "times.",
                  engine));
}

std::string tied_to_pair() {
  return "The numbers hold for pairs of this effective mass and radius; other sizes get another law.";
}

std::string keeps_restitution() {
  return "Pairs of other masses and radii keep the restitution; their collision time follows from the same material.";
}

bool knows_radii(const ContactSet& set) {
  return std::all_of(set.pairs.begin(), set.pairs.end(), [](const PairCase& p) { return p.radius_eff.has_value(); });
}

const PairCase* find_pair(const ContactSet& set, std::size_t a, std::size_t b) {
  for (const PairCase& pair : set.pairs)
    if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)) return &pair;
  return nullptr;
}

const PairCase& pair_or_stand_in(const ContactSet& set, std::size_t a, std::size_t b) {
  if (const PairCase* pair = find_pair(set, a, b)) return *pair;
  for (const PairCase& pair : set.pairs)
    if (pair.a == a || pair.b == a || pair.a == b || pair.b == b) return pair;
  return set.pairs.front();
}

std::vector<std::size_t> walls_of(const ContactSet& set) {
  std::vector<std::size_t> walls;
  for (std::size_t i = 0; i < set.kinds.size(); ++i)
    if (set.kinds[i].wall) walls.push_back(i);
  return walls;
}

std::string suffix_of(const ContactSet& set, std::size_t kind) {
  return walls_of(set).size() == 1 ? "" : "_" + set.kinds[kind].name;
}

WallPlane plane_of(const ContactSet& set, std::size_t kind) {
  constexpr std::array axes{'z', 'x', 'y'};
  const std::vector<std::size_t> walls = walls_of(set);
  const auto place = std::find(walls.begin(), walls.end(), kind) - walls.begin();
  const int further = static_cast<int>(place) / static_cast<int>(axes.size());
  return {axes[static_cast<std::size_t>(place) % axes.size()], further, further > 0};
}

std::string where_walls_are(const ContactSet& set) {
  std::vector<std::string> places;
  for (const std::size_t wall : walls_of(set)) {
    const WallPlane plane = plane_of(set, wall);
    places.push_back(
        fmt::format("ricochet_wall{} is the plane {} = {}", suffix_of(set, wall), plane.axis, plane.place));
  }
  if (places.empty()) return "";
  const bool one = places.size() == 1;
  return fmt::format("Set {} to where the {} before you include this file; without, {}.",
                     one ? "the variable" : "these variables", one ? "wall is" : "walls are", fmt::join(places, ", "));
}

std::optional<std::vector<double>> in_series(const ContactSet& set,
                                             const std::function<double(const PairCase&)>& value) {
  constexpr double same = 1e-9;
  std::vector<double> parts(set.kinds.size(), 0);
  for (const PairCase& pair : set.pairs)
    if (pair.a == pair.b) parts[pair.a] = 0.5 / value(pair);
  for (const std::size_t wall : walls_of(set))
    for (const PairCase& pair : set.pairs)
      if (pair.b == wall && parts[wall] == 0 && parts[pair.a] > 0) {
        const double left = 1 / value(pair) - parts[pair.a];
        if (left < -same * parts[pair.a]) return std::nullopt;
        parts[wall] = left < same * parts[pair.a] ? 0 : left;
      }
  for (const PairCase& pair : set.pairs)
    if (!(std::abs((parts[pair.a] + parts[pair.b]) * value(pair) - 1) <= same)) return std::nullopt;
  return parts;
}

double effective_modulus(double hertz_stiffness, double radius_eff) {
  return 0.75 * hertz_stiffness / std::sqrt(radius_eff);
}

std::vector<double> members(const std::vector<double>& parts) {
  constexpr double rigid = 1e12;
  std::vector<double> all;
  all.reserve(parts.size());
  for (const double part : parts) all.push_back(part > 0 ? 1 / part : rigid / parts.front());
  return all;
}

std::optional<std::vector<double>> youngs_moduli(const ContactSet& set) {
  const auto parts = in_series(
      set, [](const PairCase& pair) { return effective_modulus(values(pair.law).front(), *pair.radius_eff); });
  if (!parts) return std::nullopt;
  std::vector<double> moduli = members(*parts);
  for (std::size_t i = 0; i < moduli.size(); ++i) moduli[i] *= 1 - set.kinds[i].poisson * set.kinds[i].poisson;
  return moduli;
}

std::optional<double> logarithmic_restitution(double damping_ratio) {
  if (damping_ratio >= 1) return std::nullopt;
  return restitution_of_damping(damping_ratio, ContactEnd::overlap);
}

bool frictional(const ContactSet& set) { return set.pairs.front().tangential.has_value(); }

Sliding sliding_of(const PairCase& pair) {
  const TangentialPart& part = pair.tangential.value();
  const std::vector<double> all = values(part.law);
  return {all.at(0), all.at(1), part.mu};
}

bool is_mindlin(const ContactSet& set) {
  return frictional(set) && std::holds_alternative<MindlinTangential>(set.pairs.front().tangential->law);
}

bool damped_tangentially(const ContactSet& set) {
  return frictional(set) &&
         std::any_of(set.pairs.begin(), set.pairs.end(), [](const PairCase& p) { return sliding_of(p).c_t > 0; });
}

double mindlin_modulus(const PairCase& pair) { return sliding_of(pair).k_t / std::sqrt(pair.radius_eff.value()); }

std::string dashpot_feels_slip(std::string_view engine) {
  return fmt::format(
      "{}'s tangential dashpot feels the whole slip of a contact that slides: the law asked for has its slider in "
      "series with spring and dashpot. The rebound differs where the contact slides and c_t > 0.",
      engine);
}

std::string judges_spring_alone(std::string_view engine) {
  return fmt::format(
      "{} compares the spring's force alone with mu R and adds the dashpot's only while the contact sticks: the law "
      "asked for compares their sum. The rebound differs where the contact slides and c_t > 0.",
      engine);
}

std::string other_mindlin(std::string_view engine, std::string_view does) {
  return fmt::format(
      "{}: {}. The law asked for keeps the force while the contact grows and the strain while it shrinks, so that no "
      "energy is made (LAMMPS: mindlin_rescale/force).",
      engine, does);
}

namespace {

/// Whether the moduli that make each pair's E* make its G* as well, to 1e-6.
bool shears_as_asked(const ContactSet& set) {
  const auto young = youngs_moduli(set);
  if (!young) return false;
  // (2−ν)/G of a body [1/Pa], G = E/(2(1+ν)).
  const auto gives_way = [&](std::size_t i) {
    const double nu = set.kinds[i].poisson;
    return 2 * (2 - nu) * (1 + nu) / (*young)[i];
  };
  return std::all_of(set.pairs.begin(), set.pairs.end(), [&](const PairCase& p) {
    return std::abs(mindlin_modulus(p) * (gives_way(p.a) + gives_way(p.b)) / 8 - 1) <= 1e-6;
  });
}

}  // namespace

std::optional<ContactSet> with_shear_moduli(const ContactSet& set) {
  if (shears_as_asked(set)) return set;
  // Of equal materials q = G*/E* = (1−ν)/(2(2−ν)), and k_t/k = 8G*√R/((4/3)E*√R) = 6q.
  const PairCase& first = set.pairs.front();
  const double q = sliding_of(first).k_t / (6 * values(first.law).front()), nu = (1 - 4 * q) / (1 - 2 * q);
  if (!(q < 1.0 / 3 && nu <= 0.5)) return std::nullopt;
  ContactSet other = set;
  for (BodyKind& kind : other.kinds) kind.poisson = nu;
  return shears_as_asked(other) ? std::optional(other) : std::nullopt;
}

Body needs_shear_moduli(std::string_view engine) {
  return absent(fmt::format(
      "NOT WRITTEN: {} makes k_t = 8 G* sqrt(R) of the moduli that make k, and no Poisson's ratio gives this one of "
      "all pairs: k_t/k must lie between 1 and 2, the same for all pairs or as their materials give it.",
      engine));
}

Body no_such_tangential(std::string_view engine, std::string_view why) {
  return absent(fmt::format("NOT WRITTEN: {}'s tangential part can't be given beside this law: {}.", engine, why));
}

std::string of_each(const ContactSet& set, double (*value)(const PairCase&), std::string_view unit) {
  std::vector<std::string> all;
  for (const PairCase& p : set.pairs)
    all.push_back(set.pairs.size() == 1
                      ? shortest(value(p))
                      : fmt::format("{} ({}, {})", rounded(value(p)), set.kinds[p.a].name, set.kinds[p.b].name));
  return fmt::format("{}{}{}", fmt::join(all, ", "), unit.empty() ? "" : " ", unit);
}

double damping_per_mass(const PairCase& pair) { return law_of<Linear>(pair).c() / pair.impact.mass_eff; }

void end_otherwise(Body& body, const ContactSet& set, ContactEnd engine_end, std::string remark) {
  if (set.end == engine_end) return;
  body.fidelity = Fidelity::close;
  body.other_end = engine_end;
  body.remarks.insert(body.remarks.begin(), std::move(remark));
}

}  // namespace ricochet::calibration
