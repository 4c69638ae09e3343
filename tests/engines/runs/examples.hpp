#pragma once

#include <string>

namespace engines {

/// What a run of the file `example` of the checkout prints, which ends with this exit code; other commands may take the
/// place of its last `run`.
std::string output_of(const std::string& example, int code = 0, const std::string& last = "");
/// The number after the last of these words.
double number_after(const std::string& text, const std::string& words);
/// That box_of_grains.lammps has kept its total energy.
void check_box_of_grains(const std::string& output);
/// Runs a rotating drum for a while: its wall must take along the so many grains in it, and lose none.
void check_rotating_drum(const std::string& example, int grains);

}  // namespace engines
