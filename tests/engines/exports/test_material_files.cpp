// The example files of data/materials, as `calibrate --materials FILE --export ENGINE` writes them, in the engines.

#include "material_files.hpp"

#include "../../../verify/studies/engines/outcome.hpp"

#include <catch2/catch.hpp>

using namespace ricochet;
using calibration::Engine;

namespace {

/// Runs every pair of the file at every size that it has; how many ran.
std::size_t run_in(Engine engine, const std::string& name) {
  std::size_t ran = 0;
  for (const verify::engines::Contact& contact : verify::engines::contacts_of(engine, materials_of(name))) {
    const auto program = verify::engines::EngineProgram::find(engine, contact.fractional);
    INFO(name << " in " << text(engine) << ": " << contact.name);
    REQUIRE(program);
    const verify::engines::Outcome outcome = verify::engines::run(*program, contact);
    CHECK(outcome.limit.en == Approx(contact.en).epsilon(1e-3));
    CHECK(outcome.limit.tcol == Approx(contact.tcol).epsilon(1e-3));
    ++ran;
  }
  return ran;
}

}  // namespace

TEST_CASE("glass on steel: both pairs by Tsuji's law in LIGGGHTS, LAMMPS and Yade") {
  for (const Engine engine : {Engine::liggghts, Engine::lammps, Engine::yade})
    CHECK(run_in(engine, "glass_on_steel.json") == 2);
}

TEST_CASE("spheres of three sizes: six pairs, and seven more at the ends of the range of radii") {
  for (const Engine engine : {Engine::liggghts, Engine::lammps, Engine::yade})
    CHECK(run_in(engine, "three_sizes.json") == 13);
}

TEST_CASE("seeds in a hopper: three sizes of pair, two of each wall, by the fractional law in LIGGGHTS and LAMMPS") {
  for (const Engine engine : {Engine::liggghts, Engine::lammps}) CHECK(run_in(engine, "hopper.json") == 3 + 3 + 2 + 2);
  CHECK(run_in(Engine::yade, "hopper.json") == 0);
}
