#include "../lammps/deck.hpp"

#include <cstdlib>
#include <stdexcept>

namespace engines {

namespace {

std::string from_environment(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr) throw std::runtime_error(std::string(name) + " is not set: see tests/engines/debian13.sh");
  return value;
}

// A granular model has a damping and a tangential part, said or not.
std::string granular(const std::string& law, const std::string& settings) {
  std::string text = law;
  if (settings.find("damping") == std::string::npos) text += " damping fractional";
  text += " " + settings;
  if (settings.find("tangential") == std::string::npos) text += " tangential linear_nohistory 0 0";
  return text;
}

}  // namespace

std::string engine_command(int ranks) {
  return from_environment("RICOCHET_LAMMPS_RUN") + " " + std::to_string(ranks) + " -in in.deck";
}

std::filesystem::path runs_folder() { return from_environment("RICOCHET_LAMMPS_RUNS"); }

std::string target(double tcol, double en) { return "fractional/target " + number(tcol) + " " + number(en); }

std::string parameters(double k, double c, double alpha) {
  return "fractional " + number(k) + " " + number(c) + " " + number(alpha);
}

std::string memory(double time) { return "damping fractional/memory " + number(time); }

std::string tallied() { return ""; }

std::string pair_style(const std::string&) { return "pair_style granular\n"; }

std::string pair_coeff(const std::string& types, const std::string& law, const std::string& settings) {
  return "pair_coeff " + types + " " + granular(law, settings) + "\n";
}

std::string wall(const std::string& name, const std::string& group, const std::string& planes, const std::string& law,
                 const std::string& settings) {
  return "fix " + name + " " + group + " wall/gran granular " + granular(law, settings) + " " + planes + "\n";
}

// Without its style said again a restarted pair granular has no cutoff.
std::string after_restart(const std::string& styles) { return styles; }

std::string energies() {
  return "compute normal all fractional/energy\nvariable stored equal c_normal[1]\nvariable lost equal c_normal[2]\n";
}

}  // namespace engines
