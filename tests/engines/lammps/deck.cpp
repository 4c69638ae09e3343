#include "deck.hpp"

namespace engines {

std::string preamble(const Box& box, const std::string& processors) {
  return "units si\natom_style sphere\natom_modify map array\nboundary " + std::string(box.boundary) +
         "\nnewton off\ncomm_modify vel yes\nprocessors " + processors + "\n";
}

std::string neighbours(const std::string& skin, const std::string& rebuilds) {
  return "neighbor " + skin + " bin\nneigh_modify " + rebuilds + "\n";
}

std::string one_law(const std::string& law, const std::string& settings) {
  return pair_style(settings) + pair_coeff("* *", law, settings);
}

std::string planes(const std::string& axis, const std::string& low, const std::string& high, const std::string& law,
                   const std::string& settings) {
  return wall("wall_" + axis, "all", axis + " " + low + " " + high, law, settings);
}

std::string move(double dt) { return "fix move all nve/sphere\ntimestep " + number(dt) + "\n"; }

std::string dump(const std::string& file, int every) { return dump_command(file, every, "format line"); }

std::string run(int steps) { return "run " + std::to_string(steps) + "\n"; }

}  // namespace engines
