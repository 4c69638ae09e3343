#include "contacts.hpp"

#include <calibrate/calibration.hpp>
#include <calibrate/materials.hpp>
#include <console/number.hpp>
#include <ricochet/collision/peer_damping.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
          .fractional = LawKind::of(pair.law) == kind_of<Fractional>};
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

/// A grain as the snippet names it.
Grain grain_of(const calibration::Materials& materials, std::size_t kind) {
  const calibration::Material& m = materials.all[kind];
  return {m.least, m.density, static_cast<int>(kind) + 1, "material_" + m.name};
}

/// One file of every pair and the wall, `calibrate --materials`; each contact is run.
void add_materials(std::vector<Contact>& contacts, Engine engine, LawKind law) {
  const calibration::Materials materials = beads_and_plate(law);
  std::vector<calibration::PairResult> found;
  for (const auto& outcome : calibration::calibrate_pairs(materials))
    found.push_back(std::get<calibration::PairResult>(outcome));
  const auto set = calibration::contact_set(materials, found, calibration::Kept::numbers);
  const auto snippet = calibration::export_contacts(engine, set);
  if (snippet.fidelity == calibration::Fidelity::absent) return;
  for (std::size_t i = 0; i < set.pairs.size(); ++i) {
    const calibration::PairCase& pair = set.pairs[i];
    Encounter who = two_spheres();
    who.a = grain_of(materials, pair.a);
    who.b.reset();
    who.tcol = pair.tcol;
    who.grain_types = 2;
    who.walls = {""};
    if (pair.b != 2) who.b = grain_of(materials, pair.b);
    contacts.push_back(contact_of(snippet, pair, snippet.gives[i], who,
                                  fmt::format(", {} and {}", set.kinds[pair.a].name, set.kinds[pair.b].name)));
  }
}

/// Beads of a range of radii and the plate in one file: what the smallest, unlike and greatest do is what the file's
/// numbers make of the law at those sizes.
void add_sizes(std::vector<Contact>& contacts, Engine engine, LawKind law) {
  calibration::Materials materials = beads_and_plate(law);
  materials.all.erase(materials.all.begin() + 1);
  materials.all[0].greatest = 3e-3;
  materials.pairs = {{0, 0, 0.7}, {0, 1, 0.5}};
  const auto kept = calibration::kept_by(text(engine), law);
  std::vector<calibration::PairResult> found;
  for (const auto& outcome : calibration::calibrate_pairs(materials))
    found.push_back(std::get<calibration::PairResult>(outcome));
  const auto snippet = calibration::export_contacts(engine, calibration::contact_set(materials, found, kept));
  if (snippet.fidelity == calibration::Fidelity::absent) return;
  for (const auto& pair : found)
    for (const auto& s : calibration::over_sizes(materials, pair, kept)) {
      Encounter who = two_spheres();
      who.a.radius = s.radius_a;
      who.a.density = 2500;
      who.b.reset();
      who.tcol = s.collision.tcol;
      who.walls = {""};
      if (s.radius_b > 0) {
        who.b = who.a;
        who.b->radius = s.radius_b;
      }
      const calibration::PairCase sized{0,        pair.asked.b, s.law, s.collision.tcol, s.collision.en,
                                        s.impact, s.radius_eff};
      contacts.push_back(contact_of(snippet, sized, s.collision, who,
                                    fmt::format(", {} mm and {}", console::shortest(1e3 * s.radius_a),
                                                who.b ? console::shortest(1e3 * s.radius_b) + " mm" : "wall")));
    }
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
  for (const LawKind law : {kind_of<Linear>, kind_of<Tsuji>}) add_materials(contacts, engine, law);
  for (const LawKind law : {kind_of<Linear>, kind_of<Tsuji>, kind_of<Fractional>}) add_sizes(contacts, engine, law);
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
    const double beta = p.damping_ratio(asked), loss = -std::log(asked), m = two_spheres().mass_eff();
    const double hertz = young_eff * std::sqrt(two_spheres().radius_eff());
    const AnyLaw law = p.law == PeerLaw::tsuji
                           ? AnyLaw(Tsuji(hertz, beta * std::sqrt(5 * m * hertz)))
                           : AnyLaw(Linear(m * (std::numbers::pi * std::numbers::pi + loss * loss) / (tcol * tcol),
                                           2 * m * loss / tcol));
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

std::vector<Contact> contacts_of(Engine engine) {
  std::vector<Contact> contacts;
  add_exports(contacts, engine);
  add_own_formulas(contacts, engine);
  return contacts;
}

}  // namespace ricochet::verify::engines
