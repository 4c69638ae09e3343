#include "body.hpp"

#include <calibrate/advice.hpp>
#include <ricochet/collision/peer_damping.hpp>
#include <ricochet/support/root.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>

namespace ricochet::calibration {

namespace {

/// The argument at which LAMMPS's polynomial is `eta` = c/√(mk). It falls monotonically, and LAMMPS takes arguments
/// below 0 as well, so every eta above its least value (at 1) has one.
std::optional<double> polynomial_argument(double eta) {
  double low = -1;
  const double high = 1;
  if (eta < marshall_polynomial(high)) return std::nullopt;
  while (marshall_polynomial(low) < eta) low *= 2;
  return support::root([=](double x) { return marshall_polynomial(x) - eta; }, low, high);
}

/// Where damping coeff_restitution exists: pull request 4068 of lammps/lammps, first in the release of 27 June 2024.
constexpr int knows_restitution = 20240627;
/// In this year the polynomial of damping tsuji was multiplied by sqrt(2), pull request 5113.
constexpr int polynomial_changed = 20260101;
/// Since then lammps-ricochet adds its laws to pair granular; to LAMMPS of before it adds a pair style and a wall, of
/// the fractional law alone, without friction.
constexpr int takes_our_laws = 20250204;

struct Lammps {
  const ContactSet& set;

  /// The normal damping [kg/s] that LAMMPS multiplies its tangential damping by, where it is constant during a contact.
  /// Of laws with a memory `damping fractional` says that of the linear contact with the same t_col and e_n.
  static double damping_of(const PairCase& p) {
    if (const auto* law = std::get_if<Linear>(&p.law)) return law->c();
    return is_located(p.law, ContactEnd::force) ? -2 * p.impact.mass_eff * std::log(p.en) / p.tcol : 0;
  }

  /// "linear_history k_t x_t mu" with x_t = c_t/c.
  std::string tangential(const PairCase& p) const {
    if (!frictional(set)) return "linear_nohistory 0.0 0.0";
    const auto [k_t, c_t, mu] = sliding_of(p);
    return fmt::format("{} {} {} {}", is_mindlin(set) ? "mindlin_rescale/force" : "linear_history",
                       shortest(is_mindlin(set) ? mindlin_modulus(p) : k_t),
                       shortest(c_t > 0 ? c_t / damping_of(p) : 0), shortest(mu));
  }

  /// Why LAMMPS can't be given the tangential dashpots; nothing where it can.
  std::optional<Body> without_dashpots() const {
    if (!frictional(set)) return std::nullopt;
    for (const PairCase& p : set.pairs)
      if (sliding_of(p).c_t > 0 && !(damping_of(p) > 0))
        return no_such_tangential(
            "LAMMPS",
            "its tangential damping is a multiple of the normal one, which is 0 or changes during "
            "the contact; take the undamped form, c_t = 0");
    return std::nullopt;
  }

  /// What follows pair_coeff or wall/gran granular: `normal` with its two numbers, stiffness and damping, and the kind
  /// of damping that the second one sets.
  std::string contact(const PairCase& p, std::string_view normal, double stiffness, double strength,
                      std::string_view damping) const {
    return fmt::format("{} {} {} damping {} tangential {}{}", normal, shortest(stiffness), shortest(strength), damping,
                       tangential(p), set.end == ContactEnd::force ? " limit_damping" : "");
  }

  /// The command that gives the pair, up to its contact.
  std::string before(const PairCase& pair) const {
    if (!set.kinds[pair.b].wall)
      return set.kinds.size() - walls_of(set).size() == 1
                 ? "pair_coeff * * "
                 : fmt::format("pair_coeff {} {} ", std::min(pair.a, pair.b) + 1, std::max(pair.a, pair.b) + 1);
    return fmt::format("fix {} {} wall/gran granular ", fix_of(pair), group_of(pair.a));
  }
  /// What stands behind it: where a wall is.
  std::string behind(const PairCase& pair) const {
    return set.kinds[pair.b].wall ? fmt::format(" ${{ricochet_wall{}}}", suffix_of(set, pair.b)) : "";
  }
  bool one_grain() const { return set.kinds.size() - walls_of(set).size() == 1; }
  std::string group_of(std::size_t grain) const { return one_grain() ? "all" : "ricochet_" + set.kinds[grain].name; }
  std::string fix_of(const PairCase& pair) const {
    return fmt::format("ricochet_wall{}{}", suffix_of(set, pair.b), one_grain() ? "" : "_" + set.kinds[pair.a].name);
  }

  /// command(pair) of every pair of grains, or of every contact with a wall.
  template <class F>
  std::vector<std::string> commands(bool at_walls, const F& command) const {
    std::vector<std::string> all;
    for (const PairCase& pair : set.pairs)
      if (set.kinds[pair.b].wall == at_walls) all.push_back(command(pair));
    return all;
  }
  /// Where the walls are, and the grains that meet them.
  std::string places() const {
    std::string text;
    for (const std::size_t wall : walls_of(set)) {
      const WallPlane plane = plane_of(set, wall);
      const std::string at = fmt::format("{}.0", plane.place);
      text += fmt::format("variable ricochet_wall{} index \"{}plane {}\"\n", suffix_of(set, wall), plane.axis,
                          plane.above ? "NULL " + at : at + " NULL");
    }
    for (std::size_t i = 0; !walls_of(set).empty() && !one_grain() && i < set.kinds.size(); ++i)
      if (!set.kinds[i].wall) text += fmt::format("group {} type {}\n", group_of(i), i + 1);
    return text;
  }
  /// command(pair) of every pair of grains, then of every wall.
  template <class F>
  std::string all(const F& command) const {
    return fmt::format("pair_style granular\n{}{}{}", fmt::join(commands(false, command), ""), places(),
                       fmt::join(commands(true, command), ""));
  }
  /// The same in every version.
  template <class F>
  std::string each(const F& contact_of) const {
    return all(
        [&](const PairCase& pair) { return fmt::format("{}{}{}\n", before(pair), contact_of(pair), behind(pair)); });
  }

  /// Types, walls and groups.
  std::string bodies() const {
    std::string text;
    for (std::size_t i = 0; !one_grain() && i < set.kinds.size(); ++i)
      if (!set.kinds[i].wall) text += fmt::format("{}type {} is {}", i ? ", " : "Atom ", i + 1, set.kinds[i].name);
    if (!text.empty()) text += ". ";
    if (!walls_of(set).empty()) {
      text += where_walls_are(set) + " ";
      if (!one_grain())
        text += "A group holds the grains that there are: include after they are made, and pour into these groups. ";
    }
    return text;
  }
  std::string_view spring() const {
    return !frictional(set) ? "The tangential part is frictionless; put yours in its place."
           : is_mindlin(set)
               ? "mindlin_rescale/force multiplies its stiffness by the contact radius sqrt(R overlap): 8 G*."
               : "linear_history takes k_t as it is.";
  }
  std::string setting() const {
    std::string text =
        fmt::format("{}Needs atom_style sphere, newton off and comm_modify vel yes. {} ", bodies(), spring());
    if (damped_tangentially(set))
      text +=
          "Its damping is a multiple of the normal one, c_t/c. The styles gran/hooke/history take gamma_t = "
          "c_t/m, 1/s. ";
    return text + "limit_damping clips the attractive part of the force (contact ended by force).";
  }

  Body operator()(const Linear&) const {
    if (!set.other_sizes.empty()) return by_ratio();
    return {.fidelity = Fidelity::exact,
            .remarks = {setting(),
                        fmt::format("damping velocity takes c in kg/s as it is, for every pair. The styles gran/hooke "
                                    "and gran/hooke/history take it per effective mass instead: gamma_n = {} here.",
                                    of_each(set, damping_per_mass, "1/s"))},
            .input = each([this](const PairCase& p) {
              return contact(p, "hooke", law_of<Linear>(p).k(), law_of<Linear>(p).c(), "velocity");
            })};
  }

  Body operator()(const KuwabaraKono&) const {
    if (!knows_radii(set)) return needs_radius();
    return {.fidelity = Fidelity::exact,
            .remarks = {setting(),
                        "hertz multiplies its stiffness by the contact radius sqrt(R overlap), damping "
                        "viscoelastic by that and the effective mass: k/sqrt(R), c/(m sqrt(R)).",
                        tied_to_pair()},
            .input = each([this](const PairCase& p) {
              const auto& law = law_of<KuwabaraKono>(p);
              const double root = std::sqrt(*p.radius_eff);
              return contact(p, "hertz", law.k() / root, law.c() / (p.impact.mass_eff * root), "viscoelastic");
            })};
  }

  /// Laws whose damping is a share of √(mK): linear, K = k, and Tsuji's, K = k√ζ. `normal` is LAMMPS's word, and the
  /// stiffness what it multiplies by the overlap or √(R ζ³).
  struct Ratio {
    std::string_view normal;
    double stiffness;
    double eta;   ///< c/√(mk), what the polynomial has to give
    double beta;  ///< the damping ratio
  };
  static Ratio ratio_of(const PairCase& p) {
    const double m = p.impact.mass_eff;
    if (const auto* law = std::get_if<Linear>(&p.law))
      return {"hooke", law->k(), law->c() / std::sqrt(m * law->k()), damping_ratio(*law, m)};
    const auto& law = law_of<Tsuji>(p);
    return {"hertz", law.k() / std::sqrt(*p.radius_eff), law.c() / std::sqrt(m * law.k()), damping_ratio(law, m)};
  }

  /// One contact by version: through a restitution where that exists, through the polynomial before.
  std::string by_version(const PairCase& p) const {
    const auto [normal, stiffness, eta, beta] = ratio_of(p);
    if (eta == 0) return fmt::format("{}{}{}\n", before(p), contact(p, normal, stiffness, 0, "velocity"), behind(p));
    const auto en = logarithmic_restitution(beta);
    const std::string since =
        en ? "\"" + before(p) + contact(p, normal, stiffness, *en, "coeff_restitution") + behind(p) + "\""
           : "\"print 'Ricochet: no damping of this version is that strong for sure'\" quit";
    const std::string until = before(p) + contact(p, normal, stiffness, *polynomial_argument(eta), "tsuji") + behind(p);
    return fmt::format("if \"$(version) >= {}\" then &\n  {} &\nelse &\n  \"{}\"\n",
                       en ? knows_restitution : polynomial_changed, since, until);
  }

  Body by_ratio() const {
    bool elastic = true;
    for (const PairCase& p : set.pairs) {
      const double eta = ratio_of(p).eta;
      elastic = elastic && eta == 0;
      if (eta > 0 && !polynomial_argument(eta))
        return absent(fmt::format(
            "NOT WRITTEN: the polynomial of damping tsuji never falls below 0.0003, this law needs {}.", rounded(eta)));
    }
    Body body{.fidelity = Fidelity::exact, .remarks = {setting()}, .input = all([this](const PairCase& p) {
                                                                     return by_version(p);
                                                                   })};
    if (elastic) return body;
    body.remarks.push_back(fmt::format(
        "From version {} on damping coeff_restitution takes a restitution for a force that may attract; the number "
        "below is the one whose damping this law has. Before, damping tsuji turns its number into c/sqrt(m k) by a "
        "polynomial that was fitted for the particle's mass and is applied to the pair's: asked for {} it would not "
        "give it. The number below is the argument at which the polynomial has this law's value, not a restitution; "
        "from 2026 on the polynomial is multiplied by sqrt(2).",
        knows_restitution, rounded(set.pairs.front().en)));
    body.remarks.push_back(keeps_restitution());
    return body;
  }

  Body operator()(const Tsuji&) const { return knows_radii(set) ? by_ratio() : needs_radius(); }

  Body operator()(const Hysteretic&) const {
    return absent("NOT WRITTEN: pair_style granular of this version has no plastic loading and unloading.");
  }

  /// "5225 0.2964 0.3197": k, c and alpha, or what else the law has.
  static std::string numbers(const PairCase& p) {
    std::vector<std::string> all;
    for (const double value : values(p.law)) all.push_back(shortest(value));
    return fmt::format("{}", fmt::join(all, " "));
  }
  /// "fractional/kelvin_voigt" of the law fractional-kelvin-voigt.
  static std::string model_of(std::string_view law) {
    std::string model(law);
    std::replace(model.begin(), model.end(), '-', '_');
    if (const auto kind = model.find('_'); kind != std::string::npos) model[kind] = '/';
    return model;
  }

  /// What `if` does: the commands that follow `then` or `else`.
  static std::string branch(const std::vector<std::string>& lines) {
    return fmt::format("\"{}\"", fmt::join(lines, "\" &\n  \""));
  }
  /// `style`, then command(pair) of every pair of grains and of every wall.
  template <class F>
  std::string branch(const char* style, const F& command) const {
    std::vector<std::string> lines{style};
    for (const bool at_walls : {false, true})
      for (std::string& line : commands(at_walls, command)) lines.push_back(std::move(line));
    return branch(lines);
  }
  using Words = std::function<std::string(const PairCase&)>;
  /// Both forms of lammps-ricochet: `model` with its numbers of pair granular, `law` of the older pair style, if it has
  /// this law.
  std::string by_driver(const Words& model, const Words& law) const {
    const std::string since = branch("pair_style granular", [&](const PairCase& p) {
      return fmt::format("{}{} damping fractional tangential {}{}", before(p), model(p), tangential(p), behind(p));
    });
    const std::string until = law && !frictional(set)
                                  ? branch("pair_style fractional",
                                           [&](const PairCase& p) {
                                             return set.kinds[p.b].wall
                                                        ? fmt::format("fix {} {} wall/fractional{} {}", fix_of(p),
                                                                      group_of(p.a), behind(p), law(p))
                                                        : before(p) + law(p);
                                           })
                                  : branch({"print 'Ricochet: " + std::string(older_driver) + "'", "quit 1"});
    return fmt::format("{}if \"$(version) >= {}\" then &\n  {} &\nelse &\n  {}\n", places(), takes_our_laws, since,
                       until);
  }
  static constexpr std::string_view older_driver =
      "before LAMMPS of 4 Feb 2025 lammps-ricochet has the fractional law alone, without friction";

  Body remembering(std::string_view name, const Words& model, const Words& law, const std::string& remark) const {
    if (set.end != ContactEnd::force)
      return absent(fmt::format("NOT WRITTEN: {} ends contacts by force; export with --end force.", model_of(name)));
    const bool older = law && !frictional(set);
    std::string needs = fmt::format(
        "{}Run with lammps-ricochet, which adds this law to LAMMPS. Needs atom_style sphere and comm_modify vel yes; "
        "{} {}",
        bodies(),
        older ? fmt::format("before version {} also newton off, and walls are planes.", takes_our_laws)
              : fmt::format("{}: there this file stops with these words.", older_driver),
        spring());
    if (damped_tangentially(set))
      needs += " Its damping is a multiple of what damping fractional gives, -2 m ln(en)/tcol.";
    return {.fidelity = Fidelity::exact, .remarks = {needs, remark}, .input = by_driver(model, law)};
  }

  Body operator()(const Fractional&) const {
    if (set.other_sizes.empty())
      return remembering(
          Fractional::name, [](const PairCase& p) { return "fractional " + numbers(p); }, numbers,
          fmt::format(
              "Only c^alpha k^(1-alpha) acts, for every pair alike. For the same collision time and restitution "
              "at every pair's own mass write fractional/target {0} in place of fractional and its numbers{1}.",
              target(set.pairs.front()),
              frictional(set) ? "" : fmt::format("; before version {} target alone", takes_our_laws)));
    return remembering(
        Fractional::name, [](const PairCase& p) { return "fractional/target " + target(p); },
        [](const PairCase& p) { return "target " + target(p); },
        "Pairs of every size have this collision time and restitution.");
  }
  static std::string target(const PairCase& p) { return fmt::format("{} {}", shortest(p.tcol), shortest(p.en)); }

  /// The model of a law of real solids, by its parameters.
  static std::string solid(const PairCase& p) {
    const std::string words = fmt::format("{} {}", model_of(name(p.law)), numbers(p));
    return std::holds_alternative<FractionalHertz>(p.law) ? fmt::format("{} {}", words, shortest(p.impact.velocity))
                                                          : words;
  }
  template <RemembersAll Law>
  Body operator()(const Law&) const {
    return remembering(Law::name, solid, {},
                       "The parameters are those of every pair alike, whatever its masses and radii.");
  }

  /// Any law of which nothing is said above.
  template <class Law>
  Body operator()(const Law&) const {
    return no_such_law("LAMMPS", Law::name);
  }
};

}  // namespace

Body write_lammps(const ContactSet& set) {
  const Lammps lammps{set};
  if (auto refused = lammps.without_dashpots()) return *refused;
  Body body = std::visit(lammps, set.pairs.front().law);
  if (damped_tangentially(set) && body.fidelity == Fidelity::exact) {
    body.fidelity = Fidelity::close;
    body.remarks.push_back(dashpot_feels_slip("LAMMPS"));
  }
  return body;
}

}  // namespace ricochet::calibration
