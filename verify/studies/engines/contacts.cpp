#include "contacts.hpp"

#include <calibrate/calibration.hpp>
#include <calibrate/materials.hpp>
#include <console/number.hpp>
#include <ricochet/collision/peer_damping.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::engines {

using calibration::Engine;

namespace {

AnyLaw calibrated(LawKind law, ContactEnd end, double en, double mass_eff) {
  const calibration::Request request{law, end, {tcol, en, {velocity, mass_eff}}};
  return std::get<calibration::Calibration>(calibration::calibrate(request, {.method = calibration::Method::direct}))
      .law;
}

/// What the engine makes of a pair of the snippet.
Contact contact_of(const calibration::Snippet& snippet, const calibration::PairCase& pair, const Collision& gives,
                   const Encounter& who, const std::string& what) {
  using calibration::Fidelity;
  const bool exact = snippet.fidelity == Fidelity::exact;
  // A close snippet promises what it says it gives: another end of contact, or another law that meets the target.
  const bool other_end = gives.status == CollisionStatus::ended_by_force && snippet.end == ContactEnd::overlap;
  return {.engine = snippet.engine,
          .name = fmt::format("exported {}, {}{}", name(pair.law), calibration::text(snippet.end), what),
          .snippet = snippet.text,
          .end = other_end ? ContactEnd::force : snippet.end,
          .en_asked = pair.en,
          .en = gives.en,
          .tcol = gives.tcol,
          .law = exact || other_end ? std::optional(pair.law) : std::nullopt,
          .who = who,
          .fractional = calibration::is_located(pair.law, ContactEnd::force)};
}

/// Two of the spheres alone.
void add_pair(std::vector<Contact>& contacts, Engine engine, LawKind law, ContactEnd end, double en) {
  const Encounter who = two_spheres();
  const calibration::PairCase pair{
      0, 0, calibrated(law, end, en, who.mass_eff()), tcol, en, {velocity, who.mass_eff()}, who.radius_eff()};
  const auto snippet =
      calibration::export_contacts(engine, {end, {{.name = "grain", .density = who.a.density}}, {pair}});
  if (snippet.fidelity != calibration::Fidelity::absent)
    contacts.push_back(contact_of(snippet, pair, snippet.gives.front(), who, ""));
}

/// The same file makes a sphere meet the wall and another sphere.
void add_wall(std::vector<Contact>& contacts, Engine engine, LawKind law, ContactEnd end, double en) {
  calibration::ContactSet set{
      end, {{.name = "grain", .density = sphere_and_wall().a.density}, {.name = "wall", .wall = true}}, {}};
  Encounter both[] = {sphere_and_wall(), two_spheres()};
  both[1].walls = both[0].walls;
  for (const Encounter& who : both)
    set.pairs.push_back({0,
                         who.b ? std::size_t{0} : 1,
                         calibrated(law, end, en, who.mass_eff()),
                         tcol,
                         en,
                         {velocity, who.mass_eff()},
                         who.radius_eff()});
  const auto snippet = calibration::export_contacts(engine, set);
  if (snippet.fidelity == calibration::Fidelity::absent) return;
  for (std::size_t i = 0; i < 2; ++i)
    contacts.push_back(
        contact_of(snippet, set.pairs[i], snippet.gives[i], both[i], i == 0 ? ", wall" : ", beside a wall"));
}

/// Glass beads of two sizes and a steel plate, with moduli that are softened for the time step.
calibration::Materials beads_and_plate(LawKind law) {
  const ElasticSolid glass{63e6, 0.24}, steel{206e6, 0.29};
  return {.law = law,
          .velocity = velocity,
          .all = {{.name = "small", .density = 2500, .least = 1e-3, .greatest = 1e-3, .solid = glass},
                  {.name = "large", .density = 2500, .least = 3e-3, .greatest = 3e-3, .solid = glass},
                  {.name = "plate", .wall = true, .solid = steel}},
          .pairs = {{0, 0, 0.9}, {0, 1, 0.8}, {1, 1, 0.7}, {0, 2, 0.6}, {1, 2, 0.5}}};
}

/// Beads of a range of radii and the plate.
calibration::Materials sizes_and_plate(LawKind law) {
  calibration::Materials materials = beads_and_plate(law);
  materials.all.erase(materials.all.begin() + 1);
  materials.all[0].greatest = 3e-3;
  materials.pairs = {{0, 0, 0.7}, {0, 1, 0.5}};
  return materials;
}

/// A grain of `radius` as the snippet names it.
Grain grain_of(const calibration::Materials& materials, std::size_t kind, double radius) {
  const auto& all = materials.all;
  const auto grains = std::count_if(all.begin(), all.end(), [](const auto& m) { return !m.wall; });
  return {radius, all[kind].density, static_cast<int>(kind) + 1,
          grains == 1 ? "material" : "material_" + all[kind].name};
}

/// The bodies of a pair; `radius_b` is of no concern for a wall.
Encounter encounter_of(const calibration::Materials& materials, const calibration::Pair& pair, double radius_a,
                       double radius_b, double tcol) {
  Encounter who{.a = grain_of(materials, pair.a, radius_a), .velocity = materials.velocity, .tcol = tcol};
  who.grain_types = 0;
  for (const calibration::Material& m : materials.all)
    if (m.wall)
      who.walls.push_back("_" + m.name);
    else
      ++who.grain_types;
  if (who.walls.size() == 1) who.walls = {""};
  if (materials.all[pair.b].wall)
    who.met = pair.b - static_cast<std::size_t>(who.grain_types);
  else
    who.b = grain_of(materials, pair.b, radius_b);
  return who;
}

/// Every law that the engine can be given, as `calibrate --export` writes it; at one restitution with a wall, too.
void add_exports(std::vector<Contact>& contacts, Engine engine) {
  for (const double en : {0.5, 0.9})
    for (const LawKind law : LawKind::all())
      for (const auto end : {ContactEnd::overlap, ContactEnd::force}) {
        if (!law.ends().offer(end)) continue;
        add_pair(contacts, engine, law, end, en);
        if (en == 0.5) add_wall(contacts, engine, law, end, en);
      }
  const auto add = [&](const calibration::Materials& materials) {
    for (Contact& contact : contacts_of(engine, materials)) contacts.push_back(std::move(contact));
  };
  for (const LawKind law : {kind_of<Linear>, kind_of<Tsuji>}) add(beads_and_plate(law));
  for (const LawKind law : {kind_of<Linear>, kind_of<Tsuji>, kind_of<Fractional>}) add(sizes_and_plate(law));
}

const PeerDamping& peer(std::string_view id) {
  const auto all = peer_dampings();
  return *std::find_if(all.begin(), all.end(), [id](const PeerDamping& p) { return p.id == id; });
}

/// Contacts that the engine makes itself of e_n = 0.5 and Young's modulus 1e8 Pa.
class OwnFormulas {
 public:
  explicit OwnFormulas(Engine engine) : engine_(engine) {}

  void add(std::vector<Contact>& contacts, const char* id, const std::string& snippet) const {
    const PeerDamping& p = peer(id);
    const double beta = p.damping_ratio(asked), m = two_spheres().mass_eff();
    const double hertz = young_eff * std::sqrt(two_spheres().radius_eff());
    const AnyLaw law = p.law == PeerLaw::tsuji ? AnyLaw(Tsuji(hertz, beta * std::sqrt(5 * m * hertz)))
                                               : calibrated(kind_of<Linear>, ContactEnd::overlap, asked, m);
    contacts.push_back({engine_, fmt::format("own: {}", id), snippet, p.end, asked, restitution_of_damping(beta, p.end),
                        0, law, two_spheres()});
  }

  static constexpr double asked = 0.5, nu = 0.3;
  static constexpr double young_eff = 4.0 / 3.0 * 1e8 / (2 * (1 - nu * nu));  ///< 4/3 E* [Pa]

 private:
  Engine engine_;
};

void add_own_formulas(std::vector<Contact>& contacts, Engine engine) {
  const OwnFormulas own(engine);
  const std::string material =
      "fix young all property/global youngsModulus peratomtype 1e8\n"
      "fix nu all property/global poissonsRatio peratomtype 0.3\n"
      "fix en all property/global coefficientRestitution peratomtypepair 1 0.5\n"
      "pair_style gran model hertz tangential off limitForce ";
  if (engine == Engine::lammps)
    own.add(
        contacts, "lammps tsuji 2021",
        fmt::format("pair_style granular\npair_coeff * * hertz {} 0.5 damping tsuji tangential linear_nohistory 0.0 "
                    "0.0\n",
                    console::shortest(OwnFormulas::young_eff)));
  if (engine == Engine::liggghts) {
    own.add(contacts, "liggghts hertz", material + "off\npair_coeff * *\n");
    own.add(contacts, "liggghts hertz, limited", material + "on\npair_coeff * *\n");
  }
  if (engine == Engine::yade) {
    own.add(contacts, "yade tc-en",
            "material = ViscElMat(tc=1e-4, en=0.5, et=1, frictionAngle=0)\n"
            "ip2 = Ip2_ViscElMat_ViscElMat_ViscElPhys()\nlaw2 = Law2_ScGeom_ViscElPhys_Basic()\n");
    own.add(contacts, "yade mindlin 2023",
            "material = FrictMat(young=1e8, poisson=0.3, frictionAngle=0)\n"
            "law2 = Law2_ScGeom_MindlinPhys_Mindlin()\n"
            "ip2 = Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5, es=0.5)\n");
  }
}

}  // namespace

Encounter two_spheres() {
  const Grain sphere{.radius = paper::pair.radius, .density = paper::pair.density};
  return {.a = sphere, .b = sphere, .velocity = velocity, .tcol = tcol};
}

Encounter sphere_and_wall() {
  Encounter encounter = two_spheres();
  encounter.b.reset();
  encounter.walls = {""};
  return encounter;
}

std::vector<Contact> contacts_of(Engine engine, const calibration::Materials& materials) {
  const auto kept = calibration::kept_by(text(engine), materials.law);
  std::vector<calibration::PairResult> found;
  for (const auto& outcome : calibration::calibrate_pairs(materials))
    found.push_back(std::get<calibration::PairResult>(outcome));
  const auto set = calibration::contact_set(materials, found, kept);
  const auto snippet = calibration::export_contacts(engine, set);
  std::vector<Contact> contacts;
  if (snippet.fidelity == calibration::Fidelity::absent) return contacts;
  const auto middle = [&](std::size_t kind) {
    return 0.5 * (materials.all[kind].least + materials.all[kind].greatest);
  };
  for (std::size_t i = 0; i < set.pairs.size(); ++i) {
    const calibration::PairCase& pair = set.pairs[i];
    const Encounter who = encounter_of(materials, found[i].asked, middle(pair.a), middle(pair.b), pair.tcol);
    contacts.push_back(contact_of(snippet, pair, snippet.gives[i], who,
                                  fmt::format(", {} and {}", set.kinds[pair.a].name, set.kinds[pair.b].name)));
    for (const auto& s : calibration::over_sizes(materials, found[i], kept)) {
      const auto end =
          snippet.gives[i].status == CollisionStatus::ended_by_force ? ContactEnd::force : ContactEnd::overlap;
      const Collision gives = collide(s.law, s.impact, {.end = end});  // as the engine ends it
      const calibration::PairCase sized{pair.a,         pair.b,   s.law,       s.collision.tcol,
                                        s.collision.en, s.impact, s.radius_eff};
      const auto millimetres = [](double radius) { return console::significant(1e3 * radius, 3) + " mm"; };
      contacts.push_back(contact_of(
          snippet, sized, gives, encounter_of(materials, found[i].asked, s.radius_a, s.radius_b, s.collision.tcol),
          fmt::format(", {} {} and {}{}", set.kinds[pair.a].name, millimetres(s.radius_a), set.kinds[pair.b].name,
                      s.radius_b > 0 ? " " + millimetres(s.radius_b) : "")));
    }
  }
  return contacts;
}

std::vector<Contact> contacts_of(Engine engine) {
  std::vector<Contact> contacts;
  add_exports(contacts, engine);
  add_own_formulas(contacts, engine);
  return contacts;
}

}  // namespace ricochet::verify::engines
