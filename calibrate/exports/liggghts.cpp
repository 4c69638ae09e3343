#include "body.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cctype>
#include <cmath>
#include <concepts>

namespace ricochet::calibration {

namespace {

/// A material property under a fix of our own name; `values` in the order that LIGGGHTS wants.
std::string property(std::string_view name, std::string_view kind, const std::vector<double>& values) {
  std::string line = fmt::format("fix ricochet_{0} all property/global {0} {1}", name, kind);
  for (const double value : values) line += " " + shortest(value);
  return line;
}

/// "fractionalK" of k, "fractionalAlpha" of alpha.
std::string fractional_property(std::string_view parameter) {
  std::string word(parameter);
  word.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
  return "fractional" + word;
}

struct Liggghts {
  const ContactSet& set;

  std::string limit() const { return set.end == ContactEnd::force ? "limitForce on" : "limitForce off"; }

  std::string setting() const {
    const std::size_t types = set.kinds.size();
    std::string text = types == 1 ? "Include after create_box with one atom type (with more, each property wants the "
                                    "full matrix). "
                                  : fmt::format("Include after create_box with {} atom types:", types);
    for (std::size_t i = 0; types > 1 && i < types; ++i)
      text += fmt::format(" {} {}{}", i + 1, set.kinds[i].name, i + 1 < types ? "," : ". ");
    if (!walls_of(set).empty())
      text += fmt::format("{} Meshes are mesh n_meshes 1 meshes NAME there. ", where_walls_are(set));
    text += "Needs atom_style granular, newton off and communicate single vel yes.";
    return text + (frictional(set) ? "" : " tangential off has no friction; put your model in its place.");
  }

  /// A model's words with its tangential part.
  std::string model(std::string_view normal) const {
    return fmt::format("{} tangential {}", normal, frictional(set) ? "history" : "off");
  }
  const char* damping() const { return damped_tangentially(set) ? "tangential_damping on" : "tangential_damping off"; }
  std::string k_t() const {
    return matrix("kt", [this](const PairCase& p) { return frictional(set) ? sliding_of(p).k_t : 0; });
  }
  std::string c_t() const {
    return matrix("gammat_abs", [this](const PairCase& p) { return frictional(set) ? sliding_of(p).c_t : 0; });
  }
  std::string mu() const {
    return matrix("coefficientFriction", [](const PairCase& p) { return sliding_of(p).mu; });
  }
  static std::string keeps_strain() {
    return other_mindlin("LIGGGHTS",
                         "tangential history keeps the elongation while the stiffness grows with the "
                         "contact, so that the force grows with it");
  }
  static Body constant_with_hertz() {
    return no_such_tangential("LIGGGHTS", "its Hertzian models let k_t grow with the contact; take mindlin");
  }
  static Body dashpot_with_hertz() {
    return no_such_tangential("LIGGGHTS", "its Hertzian models let c_t change with the contact; take c_t = 0");
  }

  /// f(pair) of every two types.
  template <class F>
  std::string matrix(std::string_view name, const F& f) const {
    const std::size_t types = set.kinds.size();
    std::vector<double> values;
    for (std::size_t i = 0; i < types; ++i)
      for (std::size_t j = 0; j < types; ++j) values.push_back(f(pair_or_stand_in(set, i, j)));
    return property(name, fmt::format("peratomtypepair {}", types), values);
  }
  std::string constant(std::string_view name, double value) const {
    return matrix(name, [value](const PairCase&) { return value; });
  }

  /// A wall wants the settings of its model behind its own words.
  std::string with_style(const std::vector<std::string>& properties, std::string_view model,
                         const std::string& settings = "") const {
    const std::string set_so = settings.empty() ? "" : " " + settings;
    std::string text =
        fmt::format("{}\npair_style gran model {}{}\npair_coeff * *\n", fmt::join(properties, "\n"), model, set_so);
    for (const std::size_t wall : walls_of(set)) {
      const WallPlane plane = plane_of(set, wall);
      text += fmt::format(
          "variable ricochet_wall{0} index \"primitive type {1} {4}plane {5}.0\"\n"
          "fix ricochet_wall{0} all wall/gran model {2} ${{ricochet_wall{0}}}{3}\n",
          suffix_of(set, wall), wall + 1, model, set_so, plane.axis, plane.place);
    }
    return text;
  }

  Body operator()(const Linear&) const {
    if (is_mindlin(set))
      return no_such_tangential("LIGGGHTS", "hooke/stiffness has a constant k_t; take the linear tangential law");
    Body body{
        .fidelity = Fidelity::exact,
        .remarks = {setting(),
                    fmt::format("absolute_damping on takes c in kg/s as it is; without it LIGGGHTS wants gamman per "
                                "effective mass, {} here. limitForce on clips the attractive part of the force.",
                                of_each(set, damping_per_mass, "1/s"))},
        .input = with_style({matrix("kn", [](const PairCase& p) { return law_of<Linear>(p).k(); }), k_t(),
                             matrix("gamman_abs", [](const PairCase& p) { return law_of<Linear>(p).c(); }), c_t()},
                            model("hooke/stiffness"), fmt::format("absolute_damping on {} {}", limit(), damping()))};
    if (frictional(set)) {
      body.input = mu() + "\n" + body.input;
      body.remarks.emplace_back("tangential history takes k_t as kt and c_t as gammat_abs.");
    }
    if (damped_tangentially(set)) {
      body.fidelity = Fidelity::close;
      body.remarks.push_back(judges_spring_alone("LIGGGHTS"));
    }
    return body;
  }

  Body operator()(const KuwabaraKono&) const {
    if (!knows_radii(set)) return needs_radius();
    if (frictional(set) && !is_mindlin(set)) return constant_with_hertz();
    if (damped_tangentially(set)) return dashpot_with_hertz();
    const auto stiffness = [](const PairCase& p) { return law_of<KuwabaraKono>(p).k() / std::sqrt(*p.radius_eff); };
    const auto damping = [](const PairCase& p) {
      return law_of<KuwabaraKono>(p).c() / (p.impact.mass_eff * std::sqrt(*p.radius_eff));
    };
    const auto shear = [this](const PairCase& p) { return frictional(set) ? mindlin_modulus(p) : 0; };
    Body body{.fidelity = Fidelity::exact,
              .remarks = {setting(),
                          "hertz/stiffness multiplies kn by sqrt(R overlap), gamman by that and the effective "
                          "mass: k/sqrt(R), c/(m sqrt(R)).",
                          tied_to_pair()},
              .input = with_style(
                  {matrix("kn", stiffness), matrix("kt", shear), matrix("gamman", damping), constant("gammat", 0)},
                  model("hertz/stiffness"), fmt::format("{} tangential_damping off", limit()))};
    if (frictional(set)) grow_with_contact(body, "kt is 8 G*, multiplied by the contact radius as kn is.");
    return body;
  }

  /// Mindlin's law as LIGGGHTS has it.
  void grow_with_contact(Body& body, std::string remark) const {
    body.fidelity = Fidelity::close;
    body.input = mu() + "\n" + body.input;
    body.remarks.push_back(std::move(remark));
    body.remarks.push_back(keeps_strain());
  }

  /// The restitution that makes LIGGGHTS take this law's damping; NaN of an overdamped one.
  static double asked_for(const PairCase& pair) {
    return logarithmic_restitution(damping_ratio(law_of<Tsuji>(pair), pair.impact.mass_eff)).value_or(std::nan(""));
  }

  Body operator()(const Tsuji&) const {
    if (!knows_radii(set)) return needs_radius();
    if (frictional(set) && !is_mindlin(set)) return constant_with_hertz();
    if (damped_tangentially(set)) return dashpot_with_hertz();
    for (const PairCase& pair : set.pairs)
      if (const double en = asked_for(pair); !(en > 0.05))
        return absent(
            fmt::format("NOT WRITTEN: LIGGGHTS refuses a coefficientRestitution of 0.05 or less, this law needs {}.",
                        std::isnan(en) ? "an overdamped one" : shortest(en)));
    const auto young = youngs_moduli(set);
    if (!young) return needs_materials("LIGGGHTS");
    Body body{
        .fidelity = Fidelity::exact,
        .remarks = {setting(),
                    "hertz knows moduli, not stiffnesses: k = (4/3) E* sqrt(R), E* = E/(2(1-nu^2)) for "
                    "two equal bodies.",
                    keeps_restitution()},
        .input = with_style(materials(*young), model("hertz"), fmt::format("{} tangential_damping off", limit()))};
    if (frictional(set)) grow_with_contact(body, "k_t = 8 G* sqrt(R) follows from the same moduli.");
    if (set.end == ContactEnd::force)
      body.remarks.push_back(
          fmt::format("LIGGGHTS derives the damping for a force that may attract, so with limitForce on it rebounds "
                      "faster than asked; the coefficientRestitution below is the one whose damping gives {}.",
                      of_each(set, [](const PairCase& p) { return p.en; })));
    return body;
  }

  std::vector<std::string> materials(const std::vector<double>& young) const {
    std::vector<std::string> properties;
    std::vector<double> poisson;
    bool soft = false, hard = false;
    for (std::size_t i = 0; i < young.size(); ++i) {
      soft = soft || young[i] < 5e6;
      hard = hard || young[i] > 1e9;
      poisson.push_back(set.kinds[i].poisson);
    }
    if (soft) properties.push_back("soft_particles yes");
    if (hard) properties.push_back("hard_particles yes");
    properties.push_back(property("youngsModulus", "peratomtype", young));
    properties.push_back(property("poissonsRatio", "peratomtype", poisson));
    properties.push_back(matrix("coefficientRestitution", asked_for));
    return properties;
  }

  Body operator()(const Hysteretic&) const {
    if (frictional(set)) return no_such_tangential("LIGGGHTS", "edinburgh/stiffness takes its own stiffness for k_t");
    std::vector<std::string> properties{
        matrix("LoadingStiffness", [](const PairCase& p) { return law_of<Hysteretic>(p).k1(); }),
        matrix("UnloadingStiffness",
               [](const PairCase& p) { return law_of<Hysteretic>(p).k2() / law_of<Hysteretic>(p).k1(); })};
    for (const char* none : {"coefficientAdhesionStiffness", "pullOffForce", "surfaceEnergy"})
      properties.push_back(constant(none, 0));
    properties.push_back(constant("coefficientRestitution", 1));
    for (const char* exponent : {"overlapExponent", "adhesionExponent"})
      properties.push_back(property(exponent, "scalar", {1}));
    return {
        .fidelity = Fidelity::exact,
        .remarks = {setting(),
                    "edinburgh/stiffness with fixKc on, exponent 1 and no adhesion has constant k1 and k2; the k2 "
                    "of luding grows with the overlap."},
        .input = with_style(properties, model("edinburgh/stiffness"), "tangential_damping off fixKc on limitForce on")};
  }

  /// Why a law of liggghts-ricochet can't be given so; nothing where it can.
  std::optional<Body> refused_by_driver(std::string_view law) const {
    if (set.end != ContactEnd::force)
      return absent(fmt::format("NOT WRITTEN: normal {} ends contacts by force; export with --end force.", law));
    if (is_mindlin(set))
      return no_such_tangential("LIGGGHTS",
                                fmt::format("normal {} has a constant k_t; take the linear tangential law", law));
    return std::nullopt;
  }

  /// A law of liggghts-ricochet by `properties`, with the tangential part.
  Body by_driver(std::string_view law, std::vector<std::string> properties, std::vector<std::string> remarks) const {
    Body body{.fidelity = Fidelity::exact, .remarks = std::move(remarks)};
    body.remarks.insert(body.remarks.begin(), setting());
    std::string settings;
    if (frictional(set)) {
      properties.insert(properties.end(), {mu(), k_t(), c_t()});
      settings = damping();
      body.remarks.emplace_back("kt is k_t and gammat_abs c_t, as they are.");
    }
    body.input = with_style(properties, model(law), settings);
    if (damped_tangentially(set)) {
      body.fidelity = Fidelity::close;
      body.remarks.push_back(judges_spring_alone("LIGGGHTS"));
    }
    return body;
  }

  Body operator()(const Fractional&) const {
    if (auto refused = refused_by_driver(Fractional::name)) return *refused;
    const std::vector<std::string> by_target{matrix("collisionTime", [](const PairCase& p) { return p.tcol; }),
                                             matrix("coefficientRestitution", [](const PairCase& p) { return p.en; })};
    const std::string driver = "Run with liggghts-ricochet, which adds this model to LIGGGHTS.";
    if (!set.other_sizes.empty())
      return by_driver(Fractional::name, by_target,
                       {driver, "Pairs of every size have this collision time and restitution."});
    return by_driver(Fractional::name,
                     {matrix("fractionalK", [](const PairCase& p) { return law_of<Fractional>(p).k(); }),
                      matrix("fractionalC", [](const PairCase& p) { return law_of<Fractional>(p).c(); }),
                      matrix("fractionalAlpha", [](const PairCase& p) { return law_of<Fractional>(p).alpha(); })},
                     {driver + " Only c^alpha k^(1-alpha) acts, for every pair alike.",
                      fmt::format("For the same collision time and restitution at every pair's own mass, give in place "
                                  "of the three properties: {}",
                                  fmt::join(by_target, " and "))});
  }

  /// A law of real solids, by its parameters.
  template <RemembersAll Law>
  Body operator()(const Law&) const {
    if (auto refused = refused_by_driver(Law::name)) return *refused;
    std::vector<std::string> properties;
    for (std::size_t i = 0; i < Law::parameters.size(); ++i) {
      const std::string_view name = Law::parameters[i].name;
      properties.push_back(
          matrix(fractional_property(name), [&](const PairCase& p) { return law_of<Law>(p).values()[i]; }));
    }
    if (std::same_as<Law, FractionalHertz>)
      properties.push_back(property("characteristicVelocity", "scalar", {set.pairs.front().impact.velocity}));
    return by_driver(Law::name, std::move(properties),
                     {"Run with liggghts-ricochet, which adds this model to LIGGGHTS. The parameters are those of "
                      "every pair alike, whatever its masses and radii."});
  }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("LIGGGHTS", Law::name);
  }
};

}  // namespace

Body write_liggghts(const ContactSet& set) {
  if (is_mindlin(set) && std::holds_alternative<Tsuji>(set.pairs.front().law)) {
    const auto sheared = with_shear_moduli(set);
    return sheared ? std::visit(Liggghts{*sheared}, set.pairs.front().law) : needs_shear_moduli("LIGGGHTS");
  }
  return std::visit(Liggghts{set}, set.pairs.front().law);
}

}  // namespace ricochet::calibration
