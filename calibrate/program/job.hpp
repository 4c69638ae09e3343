#pragma once

#include <calibrate/calibration.hpp>
#include <console/program.hpp>

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ricochet::calibration {

/// The command line as it was typed.
struct Options {
  std::optional<double> tcol, en, velocity, mass_eff, radius, density, radius2, density2, stiffness;
  bool wall = false;
  std::string law = "all", end;
  Settings settings;
  std::string method = "nlopt";
  std::string engine;  ///< of --export; empty: none
  std::string page;    ///< of --report; empty: none
  console::OutputOptions output;
};

/// Adds every option of the program to `app`.
void add_options(CLI::App& app, Options& options);

/// What the options ask for, with the defaults that had to be assumed in words.
struct Job {
  Target target;
  std::vector<Request> requests;
  std::vector<LawName> left_out;  ///< laws of "all" that do not offer the asked end
  std::vector<std::string> assumptions;
  std::optional<double> radius_eff, density;  ///< where they are known: r₁r₂/(r₁+r₂) [m], of both spheres [kg/m³]
  std::optional<double> radius;   ///< of the smaller sphere, where radii were given [m]
};

/// Throws console::BadInput naming flag, value and what is accepted.
Job job_of(const Options& options);

}  // namespace ricochet::calibration
