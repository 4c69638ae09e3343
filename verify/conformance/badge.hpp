#pragma once

#include "grade.hpp"

#include <string>

namespace ricochet::verify::conformance {

/// "lammps-29-sep-2021": what files of an engine are called.
std::string file_stem(const Results& results);

/// A badge as SVG: the engine, how many of the cases that it ran converge to the answer, and how many it did not run.
/// Its colour goes from orange to blue with the share that is right of what was run, and from gray to full with the
/// share of all cases that was run: blue is right in all of them. A bar below has the shares themselves: right, wrong,
/// not run.
std::string badge(const EngineGrade& engine);

}  // namespace ricochet::verify::conformance
