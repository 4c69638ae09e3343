#include "meeting.hpp"

#include <catch2/catch.hpp>

using namespace engines;
using namespace engines::meeting;

TEST_CASE("minimisation and steps within steps are refused") {
  const std::string good = one_law(target(tcol, en));
  CHECK(contains(said("minimize", good, run(70) + "minimize 0 1e-3 10 10\n", 1), "minimize knows no time"));
  CHECK(contains(said("respa", good, run(70) + "run_style respa 2 2 pair 1\n" + run(10), 1), "run_style respa"));
}

TEST_CASE("soft contacts, and contacts that lost their memory, are told of") {
  const std::string soft = "% of the smaller radius";
  CHECK(contains(said("soft", one_law(target(20 * tcol, en)), run(500)), soft));
  for (const char* reset : {"reset_timestep 0\n", ""})
    for (const int steps : {10, 70}) {  // as many as before, too
      const std::string output = said("reset", one_law(target(tcol, en)), run(70) + reset + run(steps));
      CHECK_FALSE(contains(output, soft));
      CHECK(contains(output, "reset_timestep while grains touch") == (*reset != 0));
    }
}
