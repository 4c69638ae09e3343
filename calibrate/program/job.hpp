#pragma once

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

/// The command line as it was typed.
struct Options {
  std::optional<double> tcol, en, velocity, mass_eff, radius, density, radius2, density2, stiffness;
  bool wall = false;
  std::string law, end;  ///< empty: not given
  Settings settings;
  std::string method;   ///< empty: not given
  std::string targets;  ///< the file of --targets; empty: none
  std::optional<unsigned> threads;
  std::string fit, figures;  ///< the file of --fit, the folder of --figures; empty: none
  bool alpha_of_speed = false;
  std::vector<std::string> given;  ///< the options that were typed, "--law"
  std::string engine;              ///< of --export; empty: none
  std::string page;                ///< of --report; empty: none
  std::string materials;           ///< the file of --materials; empty: none
  console::OutputOptions output;
};

/// Adds every option of the program to `app`.
void add_options(CLI::App& app, Options& options);

/// Throws console::BadInput naming the first option that was typed and is none of `accepted`, which go with `mode`.
void take_only(const Options& options, std::string_view mode, std::initializer_list<std::string_view> accepted);

/// What the options ask for, with the defaults that had to be assumed in words.
struct Job {
  Target target;
  std::vector<Request> requests;
  std::vector<LawKind> left_out;  ///< laws of "all" that do not offer the asked end
  std::vector<std::string> assumptions;
  std::optional<double> radius_eff, density;  ///< where they are known: r₁r₂/(r₁+r₂) [m], of both spheres [kg/m³]
  std::optional<double> radius;               ///< of the smaller sphere, where radii were given [m]
  bool wall = false;                          ///< the contact is one of the sphere with a wall
};

/// Throws console::BadInput naming flag, value and what is accepted.
Job job_of(const Options& options);

/// What a row of a file takes where it has no such column, or the field is empty.
struct TargetDefaults {
  LawKind law = kind_of<Fractional>;
  ContactEnd end = ContactEnd::force;
  Impact impact;
  std::optional<double> stiffness = {};
  std::vector<std::string> assumptions = {};  ///< what of the mass had to be assumed, in words
};

/// Throws as job_of does.
TargetDefaults target_defaults(const Options& options);

/// "linear, kuwabara-kono, … or fractional".
std::string law_names();
/// The law of that name; throws console::BadInput with `flag`.
LawKind law_named(std::string_view flag, std::string_view name);
ContactEnd end_named(std::string_view flag, std::string_view name);

}  // namespace ricochet::calibration
