// Walls of several kinds as a file has them where the deck does not say where they are.

#include "material_files.hpp"

#include "../../../verify/studies/engines/outcome.hpp"

#include <console/child.hpp>
#include <console/scratch.hpp>

#include <catch2/catch.hpp>

#include <sstream>

using namespace ricochet;
using calibration::Engine;

namespace {

/// A seed of 2.5 mm in the corner x = 0, z = 0, which flies into both at 1 m/s.
std::string corner(Engine engine) {
  const bool lammps = engine == Engine::lammps;
  const std::string types = lammps ? "1" : "3";
  return "units si\natom_style " + std::string(lammps ? "sphere\ncomm_modify" : "granular\ncommunicate single") +
         " vel yes\natom_modify map array\nboundary f f f\nnewton off\n"
         "region box block -0.001 0.02 -0.01 0.01 -0.001 0.02 units box\ncreate_box " +
         types +
         " box\nneighbor 0.001 bin\nneigh_modify delay 0\ninclude law\n"
         "create_atoms 1 single 0.00251 0 0.00251 units box\nset group all diameter 5e-3 density 1100\n"
         "velocity all set -1 0 -1\nfix move all nve/sphere\nrun 120\n"
         "variable x equal vx[1]\nvariable z equal vz[1]\nprint \"after ${x} ${z}\"\n";
}

}  // namespace

TEST_CASE("the first kind of wall stands at z = 0 and the second at x = 0: a seed meets each once") {
  for (const Engine engine : {Engine::lammps, Engine::liggghts}) {
    INFO(text(engine));
    const auto program = verify::engines::EngineProgram::find(engine, true);
    REQUIRE(program);
    const console::ScratchFolder folder;
    folder.write("law", verify::engines::contacts_of(engine, materials_of("hopper.json")).front().snippet);
    folder.write("deck", corner(engine));
    const console::Ran ran = console::run({{program->command(), "-in", "deck", "-log", "none"}, folder.path()});
    INFO(ran.out << ran.err);
    const auto at = ran.out.rfind("after ");
    REQUIRE(at != std::string::npos);
    double x = 0, z = 0;
    std::istringstream(ran.out.substr(at + 6)) >> x >> z;
    CHECK(z == Approx(0.7).epsilon(2e-3));  // the hopper's, which comes first in the file
    CHECK(x == Approx(0.3).epsilon(2e-3));
  }
}
