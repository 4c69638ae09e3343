#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::calibration {

namespace {

struct Yade {
  const ContactSet& set;

  bool several() const { return set.kinds.size() > 1; }

  std::string setting() const {
    const std::string rest =
        std::string("Set NewtonIntegrator(damping=0): its default of 0.2 would slow every grain. ") +
        (frictional(set) ? "frictAngle is atan(mu)." : "Grains are frictionless here.");
    if (!several())
      return fmt::format(
          "Defines material, ip2 and law2: O.materials.append(material), and "
          "InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [ip2], [law2]). {}",
          rest);
    return fmt::format(
        "Appends the materials to O.materials; defines ig2, ip2 and law2 for InteractionLoop(ig2, [ip2], "
        "[law2]). hertzian=True makes a wall flat; without it a wall counts as a sphere of the sphere's "
        "own radius, a facet as one of twice that. {}",
        rest);
  }
  static std::string clips() {
    return "Yade clips the attractive part of this law's force, so contacts end by force; calibrate with --end force "
           "to meet the target.";
  }
  static Body one_kind_only() {
    return absent("NOT WRITTEN: LudingMat is written here for one kind of grain only, without walls.");
  }

  /// "material" and "wall_material" of the only grain and wall, with the kind's name where there are several.
  std::string name_of(std::size_t kind) const {
    if (set.kinds[kind].wall) return "wall_material" + suffix_of(set, kind);
    return set.kinds.size() - walls_of(set).size() == 1 ? "material" : "material_" + set.kinds[kind].name;
  }

  std::string material(std::size_t kind, const std::string& of, const std::string& arguments) const {
    const auto& density = set.kinds[kind].density;
    const std::string dense = density ? fmt::format("density={}, ", shortest(*density)) : "";
    return fmt::format("{} = {}({}{}, frictionAngle=0)\n", name_of(kind), of, dense, arguments);
  }

  /// f(kind) of every kind: its material's arguments.
  template <class F>
  std::string materials(const std::string& of, const F& arguments) const {
    std::string text;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < set.kinds.size(); ++i) {
      text += material(i, of, arguments(i));
      names.push_back(name_of(i));
    }
    if (!several()) return text;
    return text + fmt::format(
                      "O.materials.append([{}])\n"
                      "ig2 = [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(hertzian=True), "
                      "Ig2_Facet_Sphere_ScGeom(hertzian=True)]\n",
                      fmt::join(names, ", "));
  }

  /// A number of every pair: as it is where all have the same, else by the materials' numbers.
  template <class F>
  std::string by_pair(const F& value) const {
    const double first = value(set.pairs.front());
    if (std::all_of(set.pairs.begin(), set.pairs.end(),
                    [&](const PairCase& p) { return std::abs(value(p) - first) <= 1e-12 * first; }))
      return shortest(first);
    return matches(value);
  }
  template <class F>
  std::string matches(const F& value) const {
    std::vector<std::string> all;
    for (const PairCase& p : set.pairs)
      all.push_back(fmt::format("({}.id, {}.id, {})", name_of(p.a), name_of(p.b), shortest(value(p))));
    return fmt::format("MatchMaker(matches=[{}])", fmt::join(all, ", "));
  }

  /// "frictAngle=0.29", "frictAngle=MatchMaker(…)"; nothing without friction.
  std::string friction_angle() const {
    return frictional(set)
               ? fmt::format("frictAngle={}", by_pair([](const PairCase& p) { return std::atan(sliding_of(p).mu); }))
               : "";
  }

  /// What each kind contributes to `value` of its pairs in series; 0 where all are 0, nothing where none give them.
  template <class F>
  std::optional<std::vector<double>> members_of(const F& value) const {
    if (std::all_of(set.pairs.begin(), set.pairs.end(), [&](const PairCase& p) { return value(p) == 0; }))
      return std::vector<double>(set.kinds.size(), 0);
    const auto parts = in_series(set, value);
    return parts ? std::optional(members(*parts)) : std::nullopt;
  }

  /// Springs and dashpots of the materials, in series; nothing where none give every pair.
  std::optional<std::string> by_material() const {
    const auto kn = members_of([](const PairCase&p) { return law_of<Linear>(p).k(); }),
               cn = members_of([](const PairCase&p) { return law_of<Linear>(p).c(); }),
               ks = members_of([this](const PairCase&p) { return frictional(set) ? sliding_of(p).k_t : 0; }),
               cs = members_of([this](const PairCase&p) { return frictional(set) ? sliding_of(p).c_t : 0; });
    if (!kn || !cn || !ks || !cs) return std::nullopt;
    return materials("ViscElMat",
                     [&](std::size_t i) {
                       return fmt::format("kn={}, cn={}, ks={}, cs={}", shortest((*kn)[i]), shortest((*cn)[i]),
                                          shortest((*ks)[i]), shortest((*cs)[i]));
                     }) +
           fmt::format("ip2 = Ip2_ViscElMat_ViscElMat_ViscElPhys({})\n", friction_angle());
  }

  /// tc and en from which Yade makes k = (π² + ln²en) m'/tc² and c = −2 ln(en) m'/tc, m' being the pair's effective
  /// mass, or half the sphere's at a wall.
  struct AskedFor {
    double tc, en;
  };
  std::optional<AskedFor> asked_for(const PairCase& p) const {
    const auto& law = law_of<Linear>(p);
    const double mass = set.kinds[p.b].wall ? 0.5 * p.impact.mass_eff : p.impact.mass_eff;
    const double left = law.k() - law.c() * law.c() / (4 * mass);
    if (!(left > 0)) return std::nullopt;
    const double tc = std::numbers::pi * std::sqrt(mass / left);
    return AskedFor{tc, std::exp(-law.c() * tc / (2 * mass))};
  }
  std::optional<std::string> by_time() const {
    for (const PairCase& p : set.pairs)
      if (!asked_for(p)) return std::nullopt;
    return materials("ViscElMat", [](std::size_t) { return std::string("tc=1, en=1, et=1"); }) +
           fmt::format("ip2 = Ip2_ViscElMat_ViscElMat_ViscElPhys(tc={}, en={}, et=MatchMaker(algo='val', val=1))\n",
                       matches([this](const PairCase& p) { return asked_for(p)->tc; }),
                       matches([this](const PairCase& p) { return asked_for(p)->en; }));
  }

  static Body no_series() {
    return absent(
        "NOT WRITTEN: with friction Yade joins the springs and dashpots of both bodies' materials in series, and no "
        "materials make those of all these pairs: none may be twice as strong as that of a body with its like. Yade "
        "takes any without mu, and tsuji with mindlin.");
  }

  Body operator()(const Linear&) const {
    if (is_mindlin(set))
      return no_such_tangential("Yade", "ViscElPhys has a constant k_t; take the linear tangential law");
    const auto timed = several() && !frictional(set) ? by_time() : std::nullopt;
    const auto input = timed ? timed : by_material();
    if (!input) return frictional(set) ? no_series() : needs_materials("Yade");
    Body body{
        .fidelity = Fidelity::exact,
        .remarks = {setting(), timed ? "tc and en are what makes Yade take these k and c; the contact, whose force "
                                       "is clipped, keeps other ones. Pairs of other masses keep the collision "
                                       "time and the restitution."
                                     : "Yade joins the two grains' springs and dashpots in series, so the material "
                                       "carries twice the pair's k and c."},
        .input = *input + "law2 = Law2_ScGeom_ViscElPhys_Basic()\n"};
    if (damped_tangentially(set)) {
      body.fidelity = Fidelity::close;
      body.remarks.push_back(judges_spring_alone("Yade"));
    }
    end_otherwise(body, set, ContactEnd::force, clips());
    return body;
  }

  Body operator()(const KuwabaraKono&) const {
    return absent("NOT WRITTEN: Yade's Hertzian laws have no damping proportional to the contact radius.");
  }

  /// c = 2 betan √(m K_t), K_t = (3/2)kζ^{1/2}, and c = β√(5mk)ζ^{1/4}.
  static double betan_of(const PairCase& p) {
    return damping_ratio(law_of<Tsuji>(p), p.impact.mass_eff) * std::sqrt(5.0 / 6.0);
  }

  Body operator()(const Tsuji&) const {
    if (!knows_radii(set)) return needs_radius();
    if (frictional(set) && !is_mindlin(set))
      return no_such_tangential("Yade", "MindlinPhys lets k_t grow with the contact; take mindlin");
    if (damped_tangentially(set))
      return no_such_tangential("Yade", "MindlinPhys lets c_t change with the contact; take c_t = 0");
    const auto young = youngs_moduli(set);
    if (!young) return needs_materials("Yade");
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          "Mindlin's law knows moduli: k = (4/3) E* sqrt(R), E* = E/(2(1-nu^2)) for two equal "
                          "bodies. betan is the fraction of the critical damping of the tangent stiffness, "
                          "exact at every mass; en= would go through a polynomial, and in Yade of 2019 "
                          "through a formula for another end of contact.",
                          keeps_restitution()},
              .input = materials("FrictMat",
                                 [&](std::size_t i) {
                                   return fmt::format("young={}, poisson={}", shortest((*young)[i]),
                                                      shortest(set.kinds[i].poisson));
                                 }) +
                       fmt::format("ip2 = Ip2_FrictMat_FrictMat_MindlinPhys(betan={}, betas=0{})\n"
                                   "law2 = Law2_ScGeom_MindlinPhys_Mindlin()\n",
                                   by_pair(betan_of), frictional(set) ? ", " + friction_angle() : "")};
    if (frictional(set)) {
      body.fidelity = Fidelity::close;
      body.remarks.emplace_back("k_t = 8 G* sqrt(R) follows from the same moduli.");
      body.remarks.push_back(other_mindlin("Yade", "MindlinPhys keeps the tangential force while the contact shrinks"));
    }
    end_otherwise(body, set, ContactEnd::force, clips());
    return body;
  }

  Body operator()(const Hysteretic& law) const {
    if (frictional(set)) return no_such_tangential("Yade", "it is written here for LudingMat without friction");
    if (several()) return one_kind_only();
    if (!knows_radii(set)) return needs_radius();
    if (law.k1() == law.k2()) return absent("NOT WRITTEN: LudingMat needs kp > k1; use the linear law with c = 0.");
    const PairCase& pair = set.pairs.front();
    const double deepest = pair.impact.velocity * std::sqrt(pair.impact.mass_eff / law.k1());
    const double depth = deepest * (1 - law.k1() / law.k2()) / (2 * *pair.radius_eff);
    const double half = law.k1() / (law.k1() + 0.5 * (law.k2() - law.k1()));
    return {.fidelity = Fidelity::close,
            .remarks = {setting(),
                        fmt::format("LudingMat lets the unloading stiffness grow from k1 at no overlap to kp at a "
                                    "limit, set here to the greatest overlap of the target's impact: its collision "
                                    "time and restitution are met there alone. At half the velocity the restitution "
                                    "is {} (constant k2: {}).",
                                    rounded(std::sqrt(half)), rounded(pair.en))},
            .input = material(0, "LudingMat",
                              fmt::format("k1={}, kp={}, kc=0, ks=0, G0=0, PhiF={}", shortest(law.k1()),
                                          shortest(law.k2()), shortest(depth))) +
                     "ip2 = Ip2_LudingMat_LudingMat_LudingPhys()\nlaw2 = Law2_ScGeom_LudingPhys_Basic()\n"};
  }

  template <RemembersAll Law>
  Body operator()(const Law&) const {
    return no_memory("Yade");
  }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("Yade", Law::name);
  }
};

}  // namespace

Body write_yade(const ContactSet& set) {
  if (is_mindlin(set) && std::holds_alternative<Tsuji>(set.pairs.front().law)) {
    const auto sheared = with_shear_moduli(set);
    return sheared ? std::visit(Yade{*sheared}, set.pairs.front().law) : needs_shear_moduli("Yade");
  }
  return std::visit(Yade{set}, set.pairs.front().law);
}

}  // namespace ricochet::calibration
