#include "asked.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using console::shortest;
using Number = std::optional<double>;

constexpr double default_velocity = 0.5;
constexpr double default_mass_eff = 7.06858e-6;
constexpr double default_radius = 1.5e-3, default_density = 1000;
constexpr double default_tcol = 1e-4;  // of --alpha alone, whose e_n has no part in it

/// One reading, with the names as its writer knows them.
class Reader {
 public:
  Reader(const Asked& asked, Spelling spelling, std::vector<std::string>& assumptions)
      : asked_(asked), spelling_(spelling), assumptions_(assumptions) {}

  double velocity() const {
    if (!asked_.velocity) assume("impact velocity 0.5 m/s", "--velocity");
    return positive("velocity", asked_.velocity.value_or(default_velocity));
  }
  Bodies bodies() const;
  enum class ScaleGiven { tcol, stiffness, moduli, max_overlap, steps, none };
  /// Throws unless it is exactly one; none beside alpha, which sets e_n alone.
  ScaleGiven scale_given() const;
  Scale scale(ScaleGiven given, const Bodies& bodies) const;
  Loss loss() const;
  Held held() const;
  /// Beside tcol.
  Number held_stiffness() const {
    return asked_.stiffness ? Number(positive("stiffness", *asked_.stiffness)) : std::nullopt;
  }

 private:
  std::string named(std::string_view name) const { return spelled(spelling_, name); }

  /// Of a row nobody would read it; and there are a million of them.
  void assume(std::string_view what, std::string_view names) const {
    if (spelling_ == Spelling::flags) assumptions_.push_back(fmt::format("{} ({})", what, names));
  }

  double within(std::string_view name, double value, bool ok, std::string_view accepted) const {
    if (!ok) throw BadInput(named(name), shortest(value), accepted);
    return value;
  }
  double positive(std::string_view name, double value) const {
    within(name, value, value > 0, "> 0");
    return within(name, value, value >= least_scale && value <= greatest_scale, range_of_scales);
  }
  [[noreturn]] void missing(std::string_view name, const std::string& what) const {
    throw BadInput(fmt::format("{}: missing: must be given, {}", named(name), what));
  }
  void refuse_with(std::string_view name, const Number& value, const std::string& companion) const {
    if (value) throw BadInput(named(name), shortest(*value), fmt::format("left out with {}", companion));
  }

  Number radius(std::string_view name, const Number& radius, std::string_view other, const Number& diameter) const {
    if (radius) refuse_with(other, diameter, named(name));
    if (diameter) return positive(other, *diameter) / 2;
    return radius ? Number(positive(name, *radius)) : std::nullopt;
  }
  Bodies of_spheres(const Number& first, const Number& second) const;
  Bodies assumed_bodies() const;
  double poisson(std::string_view name, double value) const {
    return within(name, value, value > -1 && value <= 0.5, "in (-1, 0.5]");
  }
  scale::Moduli moduli(const Bodies& bodies) const;
  scale::MaxOverlap max_overlap(const Bodies& bodies) const;
  scale::CollisionTime steps() const;
  struct Given {
    std::string_view name;
    Number value;
  };
  /// The place of the one that is given, nothing where none is; throws where several are.
  std::optional<std::size_t> the_one(std::span<const Given> given, std::string_view topic) const;

  const Asked& asked_;
  Spelling spelling_;
  std::vector<std::string>& assumptions_;
};

Bodies Reader::assumed_bodies() const {
  assume("effective mass 7.06858e-06 kg, two spheres of radius 1.5 mm and 1000 kg/m^3", "--mass-eff");
  return {default_mass_eff, default_radius / 2, default_radius, default_density, false};
}

/// m₁m₂/(m₁+m₂), or the sphere's mass against a wall.
Bodies Reader::of_spheres(const Number& first, const Number& second) const {
  if (!first)
    missing("radius", spelling_ == Spelling::flags
                          ? "a radius [m], > 0, with --density, --radius2, --density2 or --wall"
                          : "a radius [m], > 0, with density, radius2 or density2");
  if (!asked_.density) missing("density", fmt::format("a density [kg/m^3], > 0, with {}", named("radius")));
  const double radius = *first, density = positive("density", *asked_.density);
  const double mass = sphere_mass(radius, density);
  if (asked_.wall) {
    refuse_with("radius2", asked_.radius2, "--wall");
    refuse_with("diameter2", asked_.diameter2, "--wall");
    refuse_with("density2", asked_.density2, "--wall");
    return {mass, radius, radius, density, true};
  }
  if (!second && !asked_.density2) assume("two equal spheres", "--radius2, --density2, --wall");
  const double radius2 = second.value_or(radius);
  const double density2 = positive("density2", asked_.density2.value_or(density));
  Bodies bodies{mass / (1 + mass / sphere_mass(radius2, density2)), radius / (1 + radius / radius2),
                std::min(radius, radius2), density, true};
  if (density2 != density) bodies.density.reset();
  return bodies;
}

Bodies Reader::bodies() const {
  const Number first = radius("radius", asked_.radius, "diameter", asked_.diameter);
  const Number second = radius("radius2", asked_.radius2, "diameter2", asked_.diameter2);
  const bool spheres = first || second || asked_.density || asked_.density2 || asked_.wall;
  if (asked_.mass_eff) {
    positive("mass_eff", *asked_.mass_eff);
    if (spheres)
      refuse_with("mass_eff", asked_.mass_eff,
                  spelling_ == Spelling::flags ? "--radius, --density or --wall" : "radius or density");
    return {*asked_.mass_eff, {}, {}, {}, false};
  }
  if (!spheres) return assumed_bodies();
  const Bodies bodies = of_spheres(first, second);
  if (!(bodies.mass_eff >= least_scale && bodies.mass_eff <= greatest_scale))
    throw BadInput(fmt::format("{} and {}: effective mass", named("radius"), named("density")),
                   shortest(bodies.mass_eff) + " kg", range_of_scales);
  return bodies;
}

scale::Moduli Reader::moduli(const Bodies& bodies) const {
  if (!asked_.young) missing("young", fmt::format("a modulus [Pa], > 0, with {}", named("poisson")));
  if (!asked_.poisson) missing("poisson", fmt::format("in (-1, 0.5], with {}", named("young")));
  const ElasticSolid first{positive("young", *asked_.young), poisson("poisson", *asked_.poisson)};
  if (!asked_.young2 && !asked_.poisson2) assume("both bodies of the same material", "--young2, --poisson2");
  const ElasticSolid second{positive("young2", asked_.young2.value_or(first.young)),
                            poisson("poisson2", asked_.poisson2.value_or(first.poisson))};
  const double soften = asked_.soften.value_or(1);
  within("soften", soften, soften >= 1 && soften <= greatest_scale,
         "in [1, 1e30]: the contact modulus is divided by it");
  if (!bodies.radius_eff)
    refuse_with("mass_eff", asked_.mass_eff,
                fmt::format("{}, which wants {} and {} instead", named("young"), named("radius"), named("density")));
  return {first, second, *bodies.radius_eff, soften, asked_.match};
}

scale::MaxOverlap Reader::max_overlap(const Bodies& bodies) const {
  if (asked_.max_overlap) {
    const double length = positive("max_overlap", *asked_.max_overlap);
    if (bodies.smaller_radius)
      within("max_overlap", length, length < *bodies.smaller_radius,
             fmt::format("below {} m, the radius of the smaller sphere{}", shortest(*bodies.smaller_radius),
                         bodies.from_radii ? "" : fmt::format(" that is assumed (give {})", named("radius"))));
    return {length};
  }
  const double share = *asked_.overlap_share;
  if (!(share > 0 && share < 1))
    throw BadInput(named("max_overlap"), fmt::format("{}%", shortest(100 * share)), "in (0, 100) %, or a length");
  if (!bodies.smaller_radius)
    throw BadInput(named("max_overlap"), fmt::format("{}%", shortest(100 * share)),
                   fmt::format("a length with {}, or a percentage with {} and {}", named("mass_eff"), named("radius"),
                               named("density")));
  return {share * *bodies.smaller_radius};
}

scale::CollisionTime Reader::steps() const {
  if (!asked_.timestep) missing("timestep", fmt::format("a time step [s], > 0, with {}", named("steps")));
  if (!asked_.steps) missing("steps", fmt::format("the time steps of a collision, >= 1, with {}", named("timestep")));
  const double steps = *asked_.steps;
  within("steps", steps, steps >= 1 && steps <= 1e9 && steps == std::floor(steps), "a whole number in [1, 1e9]");
  // Rounded, so that 50 steps of 1e-6 s are 5e-05 s.
  return {*console::parse_number(console::significant(positive("timestep", *asked_.timestep) * steps, 15))};
}

std::optional<std::size_t> Reader::the_one(std::span<const Given> given, std::string_view topic) const {
  std::optional<std::size_t> one;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i].value) continue;
    if (one)
      refuse_with(given[i].name, given[i].value, fmt::format("{}: one {} is enough", named(given[*one].name), topic));
    one = i;
  }
  return one;
}

Reader::ScaleGiven Reader::scale_given() const {
  const Asked& a = asked_;
  const auto first_of = [](std::initializer_list<Number> all) {
    for (const Number& n : all)
      if (n) return n;
    return Number();
  };
  const Number own = a.tcol ? Number() : a.stiffness;  // beside tcol it is the k to hold
  const std::array scales{Given{"tcol", a.tcol}, Given{"stiffness", own},
                          Given{a.young      ? "young"
                                : a.poisson  ? "poisson"
                                : a.young2   ? "young2"
                                : a.poisson2 ? "poisson2"
                                             : "soften",
                                first_of({a.young, a.poisson, a.young2, a.poisson2, a.soften})},
                          Given{"max_overlap", first_of({a.max_overlap, a.overlap_share})},
                          Given{a.timestep ? "timestep" : "steps", first_of({a.timestep, a.steps})}};
  const auto one = the_one(scales, "scale");
  if (one) return static_cast<ScaleGiven>(*one);
  if (a.alpha) return ScaleGiven::none;
  missing("tcol",
          fmt::format("a collision time [s], > 0, or another scale: {}, {} with {}, {}, {} with {}", named("stiffness"),
                      named("young"), named("poisson"), named("max_overlap"), named("timestep"), named("steps")));
}

Scale Reader::scale(ScaleGiven given, const Bodies& bodies) const {
  switch (given) {
    case ScaleGiven::tcol: return scale::CollisionTime{positive("tcol", *asked_.tcol)};
    case ScaleGiven::stiffness: return scale::Stiffness{positive("stiffness", *asked_.stiffness)};
    case ScaleGiven::moduli: return moduli(bodies);
    case ScaleGiven::max_overlap: return max_overlap(bodies);
    case ScaleGiven::steps: return steps();
    case ScaleGiven::none: break;
  }
  assume("collision time 1e-04 s, which has no part in en", "--tcol");
  return scale::CollisionTime{default_tcol};
}

Loss Reader::loss() const {
  const Asked& a = asked_;
  const std::array losses{Given{"en", a.en}, Given{"loss_factor", a.loss_factor},
                          Given{"damping_ratio", a.damping_ratio}, Given{"alpha", holds_alpha(a) ? Number() : a.alpha}};
  const auto one = the_one(losses, "loss");
  if (!one)
    missing("en", fmt::format("a restitution in (0, 1], or another loss: {}, {}, {}", named("loss_factor"),
                              named("damping_ratio"), named("alpha")));
  switch (*one) {
    case 0: return loss::Restitution{within("en", *a.en, *a.en > 0 && *a.en <= 1, "in (0, 1]")};
    case 1: return loss::LossFactor{within("loss_factor", *a.loss_factor, *a.loss_factor >= 0, ">= 0")};
    case 2: return loss::DampingRatio{within("damping_ratio", *a.damping_ratio, *a.damping_ratio >= 0, ">= 0")};
    default: return loss::ConversionDegree{within("alpha", *a.alpha, *a.alpha >= 0 && *a.alpha < 1, "in [0, 1)")};
  }
}

Held Reader::held() const {
  Held held;
  if (holds_alpha(asked_))
    held.alpha = within("alpha", *asked_.alpha, domains::degree.contains(*asked_.alpha), domains::degree.accepted);
  if (asked_.stiffening) held.stiffening = positive("stiffening", *asked_.stiffening);
  return held;
}

}  // namespace

bool holds_alpha(const Asked& asked) { return asked.alpha && (asked.en || asked.loss_factor || asked.damping_ratio); }

void refuse_second_loss(const Asked& asked, Spelling spelling) {
  const std::string_view first = asked.en ? "en" : asked.loss_factor ? "loss_factor" : "damping_ratio";
  throw BadInput(spelled(spelling, "alpha"), shortest(*asked.alpha),
                 fmt::format("left out with {}: one loss is enough", spelled(spelling, first)));
}

std::string spelled(Spelling spelling, std::string_view name) {
  if (spelling == Spelling::columns) return std::string(name);
  std::string flag = fmt::format("--{}", name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

bool speaks_of(const Asked& asked, Topic topic) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const Field& f) { return f.topic == topic && asked.*f.member; }) ||
         (topic == Topic::scale && asked.overlap_share);
}

Asked without(Asked asked, Topic topic) {
  for (const Field& f : fields)
    if (f.topic == topic) (asked.*f.member).reset();
  if (topic == Topic::scale) asked.overlap_share.reset();
  return asked;
}

Bodies bodies_of(const Asked& asked, Spelling spelling, std::vector<std::string>& assumptions) {
  return Reader(asked, spelling, assumptions).bodies();
}

double velocity_of(const Asked& asked, Spelling spelling, std::vector<std::string>& assumptions) {
  return Reader(asked, spelling, assumptions).velocity();
}

Reading read(const Asked& asked, Spelling spelling) {
  Reading reading{};
  const Reader reader(asked, spelling, reading.assumptions);
  const auto given = reader.scale_given();
  const Loss loss = reader.loss();
  const double velocity = reader.velocity();
  reading.bodies = reader.bodies();
  reading.known = {reader.scale(given, reading.bodies), loss, {velocity, reading.bodies.mass_eff}, reader.held()};
  if (asked.tcol) reading.stiffness = reader.held_stiffness();
  if (given == Reader::ScaleGiven::stiffness) reading.spring = asked.spring;
  if (given == Reader::ScaleGiven::steps) reading.step = asked.timestep;
  return reading;
}

std::optional<TangentialRequest> tangential_of(const Asked& asked, Spelling spelling, const Scale& scale) {
  if (!asked.beta0 && !asked.mu && !asked.form) return std::nullopt;
  TangentialRequest request{.form = asked.form.value_or(TangentialForm::linear), .beta0 = asked.beta0, .mu = asked.mu};
  if (request.beta0 && !(*request.beta0 >= -1 && *request.beta0 <= 1))
    throw BadInput(spelled(spelling, "beta0"), shortest(*request.beta0), "in [-1, 1]");
  if (request.mu && !(*request.mu >= 0 && *request.mu <= greatest_scale))
    throw BadInput(spelled(spelling, "mu"), shortest(*request.mu), "in [0, 1e30]");
  const auto* moduli = std::get_if<scale::Moduli>(&scale);
  if (request.form == TangentialForm::mindlin && moduli)
    request.mindlin = mindlin_stiffness(moduli->first.young, moduli->first.poisson, moduli->second.young,
                                        moduli->second.poisson, moduli->radius_eff) /
                      moduli->soften;
  if (!request.beta0 && !request.mindlin)
    throw BadInput(
        fmt::format("{}: missing: must be given, a tangential restitution in [-1, 1]{}", spelled(spelling, "beta0"),
                    request.form == TangentialForm::mindlin
                        ? fmt::format(", or {} with {}", spelled(spelling, "young"), spelled(spelling, "poisson"))
                        : fmt::format(", with {}", asked.mu ? spelled(spelling, "mu") : "--tangential")));
  return request;
}

std::pair<std::vector<double>, Spring> parse_stiffnesses(std::string_view text) {
  for (const auto& [unit, spring] :
       {std::pair(console::count_unit, Spring::any), {"kg/s^2", Spring::linear}, {hertzian_unit, Spring::hertzian}}) {
    try {
      return {console::parse_quantities(text, unit), spring};
    } catch (const std::invalid_argument&) {  // then in another
    }
  }
  throw std::invalid_argument(fmt::format("a finite number, plain or with a unit: {} (of a spring in overlap), {}",
                                          console::unit_choices("kg/s^2"), console::unit_choices(hertzian_unit)));
}

bool fits(Spring spring, LawKind law) {
  const int metre = law.parameters().front().dimension.metre;
  return spring == Spring::any || metre == (spring == Spring::linear ? 0 : -2);
}

std::string stated(double stiffness, Spring spring) {
  const std::string_view unit = spring == Spring::linear ? "kg/s^2" : spring == Spring::hertzian ? hertzian_unit : "";
  return fmt::format("{}{}{}", shortest(stiffness), unit.empty() ? "" : " ", unit);
}

std::string spring_of(LawKind law) {
  const Parameter& first = law.parameters().front();
  return fmt::format("in {} (or plain), as the law {} has its {}", console::unit_choices(first.unit()), law.name(),
                     first.name);
}

}  // namespace ricochet::calibration
