// Oblique impacts on a wall and of a pair, with the tangential part as `calibrate --export` writes it.

#include "../../../verify/studies/engines/oblique.hpp"

#include <catch2/catch.hpp>

using namespace ricochet;
using namespace ricochet::verify::engines;
using calibration::Engine;

TEST_CASE("at three angles the engines rebound as ours where they have the law, at first order in the step") {
  for (const Engine engine : {Engine::liggghts, Engine::lammps, Engine::yade}) {
    const auto program = EngineProgram::find(engine);
    INFO(text(engine));
    REQUIRE(program);
    std::vector<ObliqueOutcome> outcomes;
    for (const ObliqueContact& what : oblique_contacts(engine)) outcomes.push_back(run(*program, what));
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
