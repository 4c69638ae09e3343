#pragma once

#include <string>

namespace engines {

/// What a run of examples/lammps/`example` prints, which ends with this exit code.
std::string output_of(const std::string& example, int code = 0);
/// The number after the last of these words.
double number_after(const std::string& text, const std::string& words);
/// That box_of_grains.lammps has kept its total energy.
void check_box_of_grains(const std::string& output);

}  // namespace engines
