#pragma once

#include "asked.hpp"

#include <calibrate/calibration.hpp>
#include <console/program.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace ricochet::calibration {

/// A number that was given as a list, and where its values go, one after the other.
struct Curve {
  std::string flag;
  const Field* field;
  std::optional<double> Asked::*member;
  std::vector<double> values;
};

/// The command line as it was typed.
struct Options {
  Asked asked;
  std::optional<Curve> curve;
  std::string law, end;  ///< empty: not given
  std::string with;      ///< parameters of --with; empty: none
  Settings settings;
  std::string method;   ///< empty: not given
  std::string targets;  ///< the file of --targets; empty: none
  std::optional<unsigned> threads;
  std::string fit, figures;  ///< the file of --fit, the folder of --figures; empty: none
  bool alpha_of_speed = false;
  std::vector<std::string> given;  ///< the options that were typed, "--law"
  std::string engine;              ///< of --export; empty: none
  std::string page;                ///< of --report; empty: none
  std::optional<double> load;      ///< of --load [N]
  std::string materials;           ///< the file of --materials; empty: none
  console::OutputOptions output;
  std::string command;  ///< all of it, as a shell reads it
};

/// Adds every option of the program to `app`.
void add_options(CLI::App& app, Options& options);

/// Throws console::BadInput naming the first option that was typed and is none of `accepted`, which go with `mode`.
void take_only(const Options& options, std::string_view mode, const std::vector<std::string>& accepted);
/// Was that option typed, "--match"?
bool was_given(const Options& options, std::string_view flag);
/// The flags of a topic, "--velocity", "--mass-eff", …, and `others`.
std::vector<std::string> flags_of(std::initializer_list<Topic> topics, std::vector<std::string> others);

/// A law and end that is asked for.
struct Wanted {
  LawKind law;
  ContactEnd end = ContactEnd::force;
};

/// What the options ask for, with the defaults that had to be assumed in words.
struct Job {
  Known known;                       ///< scale and loss: of a calibration; the impact: always
  std::optional<AnyLaw> given = {};  ///< the law of --with, whose collision alone is asked for
  std::optional<double> stiffness;   ///< beside a collision time: the k that is held, see `holds_stiffness`
  Spring spring = Spring::any;       ///< of the stiffness that is the scale
  std::optional<double> step;        ///< the engine's time step, where it was asked for [s]
  std::vector<Wanted> wanted;
  std::vector<Infeasible> left_out;  ///< laws of "all" that do not offer the asked end, loss or stiffness
  std::vector<std::string> assumptions;
  std::optional<double> radius_eff, density;  ///< where they are known: r₁r₂/(r₁+r₂) [m], of both spheres [kg/m³]
  std::optional<double> radius;               ///< of the smaller sphere, where radii were given [m]
  std::optional<TangentialRequest> tangential = {};
  bool wall = false;                ///< the contact is one of the sphere with a wall
  std::optional<double> load = {};  ///< constant, that presses the bodies together [N]
  std::string title = {};           ///< what was asked for, where that is not `known`
};

/// Throws console::BadInput naming flag, value and what is accepted.
Job job_of(const Options& options);

/// Throws console::BadInput where --match was typed and nothing follows it: no moduli, or a single law whose k is
/// Hertz's own.
void require_match_to_matter(const Options& options, const Scale& scale);

/// "tcol = 1e-04 s, en = 0.5", or what else was asked for, or of which law.
std::string asked_text(const Job& job);

/// What a row of a file takes where it has no such column, or the field is empty.
struct TargetDefaults {
  LawKind law = kind_of<Fractional>;
  ContactEnd end = ContactEnd::force;
  Asked asked = {};
};

/// Throws as job_of does.
TargetDefaults target_defaults(const Options& options);

/// "linear, kuwabara-kono, … or fractional".
std::string law_names();
/// The law of that name; throws console::BadInput with `flag`.
LawKind law_named(std::string_view flag, std::string_view name);
ContactEnd end_named(std::string_view flag, std::string_view name);
/// Does a stiffness beside a collision time and a restitution mean a k of that law?
bool holds_stiffness(LawKind law) noexcept;
inline constexpr std::string_view who_holds_stiffness = "only fractional and fractional-kelvin-voigt hold a k";
/// The laws that have such a loss: "linear or tsuji".
std::string laws_with(const Loss& loss);

}  // namespace ricochet::calibration
