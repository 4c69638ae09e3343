#pragma once

#include "grade.hpp"

#include <string>

namespace ricochet::verify::conformance {

/// "lammps-29-sep-2021": what files of an engine are called.
std::string file_stem(const Results& results);

/// A badge as SVG: the engine and how many of the cases that it ran converge to the answer; blue if all, else orange.
std::string badge(const EngineGrade& engine);

}  // namespace ricochet::verify::conformance
