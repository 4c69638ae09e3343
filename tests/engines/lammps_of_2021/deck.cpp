#include "deck.hpp"

namespace engines {

std::string engine_command(int ranks) {
  std::string command;
  if (ranks > 1) command = RICOCHET_MPIEXEC " --allow-run-as-root --oversubscribe -np " + std::to_string(ranks) + " ";
  return command + RICOCHET_LAMMPS_DRIVER " -in in.deck";
}

std::filesystem::path runs_folder() { return RICOCHET_LAMMPS_RUNS; }

std::string preamble(const Box& box, const std::string& processors) {
  return "units si\natom_style sphere\natom_modify map array\nboundary " + std::string(box.boundary) +
         "\nnewton off\ncomm_modify vel yes\nprocessors " + processors + "\n";
}

std::string neighbours(const std::string& skin, const std::string& rebuilds) {
  return "neighbor " + skin + " bin\nneigh_modify " + rebuilds + "\n";
}

std::string target(double tcol, double en) { return "target " + number(tcol) + " " + number(en); }

std::string pair_style(const std::string& law, const std::string& settings) {
  return "pair_style fractional " + settings + "\npair_coeff * * " + law + "\n";
}

std::string walls(const std::string& axis, const std::string& low, const std::string& high, const std::string& law,
                  const std::string& settings) {
  return "fix wall_" + axis + " all wall/fractional " + axis + " " + low + " " + high + " " + law + " " + settings +
         "\n";
}

std::string move(double dt) { return "fix move all nve/sphere\ntimestep " + number(dt) + "\n"; }

std::string dump(const std::string& file, int every) { return dump_command(file, every, "format line"); }

std::string run(int steps) { return "run " + std::to_string(steps) + "\n"; }

}  // namespace engines
