#include "../lammps/deck.hpp"

namespace engines {

std::string target(double tcol, double en) { return "target " + number(tcol) + " " + number(en); }

std::string parameters(double k, double c, double alpha) { return number(k) + " " + number(c) + " " + number(alpha); }

std::string memory(double time) { return "memory " + number(time); }

std::string tallied() { return "energy yes"; }

std::string pair_style(const std::string& settings) { return "pair_style fractional " + settings + "\n"; }

std::string pair_coeff(const std::string& types, const std::string& law, const std::string&) {
  return "pair_coeff " + types + " " + law + "\n";
}

std::string wall(const std::string& name, const std::string& group, const std::string& planes, const std::string& law,
                 const std::string& settings) {
  return "fix " + name + " " + group + " wall/fractional " + planes + " " + law + " " + settings + "\n";
}

std::string after_restart(const std::string&) { return ""; }

std::string energies() {
  std::string text = "compute pairs all pair fractional\n";
  for (const auto& [name, place] : {std::pair{"stored", "[1]"}, {"lost", "[2]"}}) {
    text += std::string("variable ") + name + " equal c_pairs" + place;
    for (const char* axis : {"x", "y", "z"}) text += std::string("+f_wall_") + axis + "plane" + place;
    text += "\n";
  }
  return text;
}

}  // namespace engines
