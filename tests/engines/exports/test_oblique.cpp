// Oblique impacts on a wall and of a pair, with the tangential part as `calibrate --export` writes it.

#include "../../../verify/studies/engines/oblique.hpp"

#include <catch2/catch.hpp>

using namespace ricochet;
using namespace ricochet::verify::engines;
using calibration::Engine;

namespace {

EngineProgram program_of(const ObliqueContact& what) {
  const auto program = EngineProgram::find(what.what.engine, what.what.fractional);
  REQUIRE(program);
  return *program;
}

}  // namespace

TEST_CASE("at three angles the engines rebound as ours where they have the law, at first order in the step") {
  for (const Engine engine : {Engine::liggghts, Engine::lammps, Engine::yade}) {
    INFO(text(engine));
    std::vector<ObliqueOutcome> outcomes;
    for (const ObliqueContact& what : oblique_contacts(engine))
      if (!what.what.fractional) outcomes.push_back(run(program_of(what), what));
    INFO(oblique_table(outcomes).text());
    // Linear, damped and Mindlin's, on a wall and of a pair: the law asked for or another, its rule, the order.
    CHECK(oblique_gates(outcomes).size() == 3 * 2 * 3);
    for (const ObliqueOutcome& o : outcomes) {
      const bool spring = o.what.tangential == "linear, undamped";
      CHECK(o.what.exact == (spring || (engine == Engine::lammps && o.what.tangential == "mindlin")));
    }
    for (const verify::Gate& gate : oblique_gates(outcomes)) {
      INFO(gate.name << " = " << gate.value);
      CHECK(gate.pass);
    }
  }
}

TEST_CASE("under the fractional law with friction the drivers rebound as ours, or the file stops in one without it") {
  for (const Engine engine : {Engine::liggghts, Engine::lammps}) {
    INFO(text(engine));
    std::vector<ObliqueOutcome> outcomes;
    int refused = 0;
    for (const ObliqueContact& what : oblique_contacts(engine)) try {
        if (what.what.fractional) outcomes.push_back(run(program_of(what), what));
      } catch (const Refused&) {
        ++refused;
      }
    INFO(oblique_table(outcomes).text());
    // A wall and a pair at three angles. The LAMMPS of 2021 has no friction for it.
    CHECK(outcomes.size() + refused == 2 * 3);
    CHECK(refused == (engine == Engine::lammps && outcomes.empty() ? 6 : 0));
    for (const ObliqueOutcome& o : outcomes) CHECK(o.what.exact);
    for (const verify::Gate& gate : oblique_gates(outcomes)) {
      INFO(gate.name << " = " << gate.value);
      CHECK(gate.pass);
    }
  }
}
