#pragma once

#include <calibrate/known.hpp>
#include <calibrate/tangential.hpp>
#include <console/quantity.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::calibration {

/// Of what spring a stiffness is by the unit that was stated with it.
enum class Spring {
  any,       ///< none was stated: the law's own
  linear,    ///< kg/s², of kζ
  hertzian,  ///< kg/(s² m^{1/2}), of kζ^{3/2}
};

/// What somebody says of a contact, by flags or in the row of a file: numbers in SI units, as far as they are given.
struct Asked {
  std::optional<double> tcol, stiffness, young, poisson, young2, poisson2, soften, max_overlap, overlap_share, timestep,
      steps;
  std::optional<double> en, loss_factor, damping_ratio, alpha, stiffening;
  std::optional<double> beta0, mu;
  std::optional<double> velocity, mass_eff, radius, diameter, density, radius2, diameter2, density2;
  bool wall = false;
  LinearMatch match = LinearMatch::time;
  Spring spring = Spring::any;              ///< of `stiffness`
  std::optional<TangentialForm> form = {};  ///< of the tangential law
};

/// What a number of `Asked` is about; of `scale` and `loss` one is enough, but for an alpha beside another loss, which
/// is then held.
enum class Topic { scale, loss, held, impact, tangential };

/// A number of `Asked`: its name in files (a flag has two dashes before it and one for each underscore), its unit,
/// whether flags take a list of it, what it means, and other names that columns have for it.
struct Field {
  std::string_view name, unit;
  std::optional<double> Asked::*member;
  Topic topic;
  bool curve = false;
  std::string_view meaning;
  std::string_view aliases = {};
  bool share = true;  ///< where it has no unit: it may be a percentage

  /// As console/quantity.hpp and console/csv.hpp take it.
  constexpr std::string_view read_in() const { return unit.empty() && !share ? console::count_unit : unit; }
};

/// Another unit that a stiffness may have.
inline constexpr std::string_view hertzian_unit = "kg/(s^2 m^(1/2))";

/// All but `overlap_share`, which is max_overlap in percent.
inline constexpr std::array fields{
    Field{"tcol", "s", &Asked::tcol, Topic::scale, true, "collision time to reach", "t_c,t_col,collision time"},
    Field{"stiffness", "kg/s^2", &Asked::stiffness, Topic::scale, true,
          "the law's stiffness, in its own unit; beside --tcol the k that fractional holds, and "
          "fractional-kelvin-voigt, whose alpha then follows"},
    Field{"young", "Pa", &Asked::young, Topic::scale, true, "Young's modulus, with --poisson"},
    Field{"poisson", "", &Asked::poisson, Topic::scale, false, "Poisson's ratio", {}, false},
    Field{"young2", "Pa", &Asked::young2, Topic::scale, false, "of the other body or the wall (default --young)"},
    Field{"poisson2",
          "",
          &Asked::poisson2,
          Topic::scale,
          false,
          "of the other body or the wall (default --poisson)",
          {},
          false},
    Field{
        "soften", "", &Asked::soften, Topic::scale, true, "divide the contact modulus by this factor, >= 1", {}, false},
    Field{"max_overlap", "m", &Asked::max_overlap, Topic::scale, true,
          "greatest overlap, a length or a percentage of the smaller radius"},
    Field{"timestep", "s", &Asked::timestep, Topic::scale, true, "time step of the engine, with --steps"},
    Field{"steps", "", &Asked::steps, Topic::scale, true, "time steps that a collision shall have", {}, false},
    Field{"en", "", &Asked::en, Topic::loss, true, "restitution to reach, in (0, 1]", "e,e_n,cor,restitution"},
    Field{"loss_factor", "", &Asked::loss_factor, Topic::loss, true, "tan delta of the material (fractional)"},
    Field{"damping_ratio", "", &Asked::damping_ratio, Topic::loss, true,
          "c/(2 sqrt(m k)) (linear), c/sqrt(5 m k) (tsuji)"},
    Field{"alpha", "", &Asked::alpha, Topic::loss, true,
          "conversion degree (fractional), in [0, 1); beside another loss what the laws of real solids hold, in [0, 1] "
          "(default 0.5)"},
    Field{"stiffening",
          "",
          &Asked::stiffening,
          Topic::held,
          true,
          "k1/k that fractional-zener holds (default 100)",
          {},
          false},
    Field{"velocity", "m/s", &Asked::velocity, Topic::impact, true, "impact velocity (default 0.5)",
          "v,v0,speed,impact velocity"},
    Field{"mass_eff", "kg", &Asked::mass_eff, Topic::impact, true, "effective mass m1 m2/(m1+m2) (default 7.06858e-6)"},
    Field{"radius", "m", &Asked::radius, Topic::impact, true,
          "radius of the sphere, with --density instead of --mass-eff"},
    Field{"diameter", "m", &Asked::diameter, Topic::impact, true, "its diameter instead"},
    Field{"density", "kg/m^3", &Asked::density, Topic::impact, false, "density of the sphere"},
    Field{"radius2", "m", &Asked::radius2, Topic::impact, false, "radius of the other sphere (default --radius)"},
    Field{"diameter2", "m", &Asked::diameter2, Topic::impact, false, "its diameter instead"},
    Field{"density2", "kg/m^3", &Asked::density2, Topic::impact, false,
          "density of the other sphere (default --density)"},
    Field{"beta0", "", &Asked::beta0, Topic::tangential, true,
          "tangential restitution of a contact that sticks, in [-1, 1] (alias --et)", "beta_0,et,e_t", false},
    Field{"mu", "", &Asked::mu, Topic::tangential, true, "coefficient of friction", "friction", false},
};

/// How names are written to the one who gave them.
enum class Spelling { flags, columns };
/// "--max-overlap" or "max_overlap".
std::string spelled(Spelling spelling, std::string_view name);

/// The bodies of one contact.
struct Bodies {
  double mass_eff = 0;                               ///< [kg]
  std::optional<double> radius_eff, smaller_radius;  ///< where they are known [m]
  std::optional<double> density;                     ///< of both [kg/m³], where it is the same and known
  bool from_radii = false;                           ///< radii were given, not assumed
};

/// A `Known` with what had to be assumed for it.
struct Reading {
  Known known;
  Bodies bodies;
  std::optional<double> stiffness;       ///< beside tcol: the k that is held, see `holds_stiffness`
  Spring spring = Spring::any;           ///< of the stiffness that is the scale
  std::optional<double> step;            ///< the engine's time step, where that and a number of them is the scale [s]
  std::vector<std::string> assumptions;  ///< in words
};

/// Mass and radii. Throws console::BadInput naming what is wrong.
Bodies bodies_of(const Asked& asked, Spelling spelling, std::vector<std::string>& assumptions);
/// The impact velocity, 0.5 m/s where none is given.
double velocity_of(const Asked& asked, Spelling spelling, std::vector<std::string>& assumptions);

/// One scale, one loss and the impact. Throws console::BadInput naming what is missing, contradicts itself or lies
/// outside its domain, and what is accepted.
Reading read(const Asked& asked, Spelling spelling);

/// The numbers of a stiffness, one or a list, and of which spring they are. Throws std::invalid_argument saying what is
/// accepted.
std::pair<std::vector<double>, Spring> parse_stiffnesses(std::string_view text);
/// What is asked of the contact in its tangent plane, `scale` and `bodies` being known; nothing where it is not asked
/// for. Throws console::BadInput naming what is missing or outside its domain.
std::optional<TangentialRequest> tangential_of(const Asked& asked, Spelling spelling, const Scale& scale);

/// Is it the spring of that law's stiffness?
bool fits(Spring spring, LawKind law);
/// "5000 kg/s^2": the number with the unit that was stated.
std::string stated(double stiffness, Spring spring);
/// "in kg/s^2, …, as the law linear has its k": what a stiffness of that law must be in.
std::string spring_of(LawKind law);

/// Is an α given that is no loss, as another one is?
bool holds_alpha(const Asked& asked);
/// That there is no law to hold it.
[[noreturn]] void refuse_second_loss(const Asked& asked, Spelling spelling);

/// Are there numbers of that topic?
bool speaks_of(const Asked& asked, Topic topic);
/// Without those of that topic.
Asked without(Asked asked, Topic topic);

}  // namespace ricochet::calibration
