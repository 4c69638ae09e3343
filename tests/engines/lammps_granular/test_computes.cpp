#include "../lammps/meeting.hpp"
#include "../runs/examples.hpp"

#include <catch2/catch.hpp>

using namespace engines;
using namespace engines::meeting;

namespace {

// In the middle of the collision, which takes 50 steps from the 60th on, a second compute is made; a little later the
// first may go.
std::string commands(bool first_goes) {
  const std::string first = " c_first[2]", second = " c_second[2]";
  const auto print = [](const std::string& values) { return "thermo_style custom step" + values + "\n"; };
  const std::string half_way = print(first) + run(80) + "print \"half way $(c_first[2]:%.17g)\"\n";
  const std::string both = "compute second all fractional/energy\n" + print(first + second) + run(5);
  const std::string last =
      first_goes ? print(second) + "uncompute first\n" + run(60) : run(60) + "print \"whole $(c_first[2]:%.17g)\"\n";
  return "compute first all fractional/energy\nthermo_modify norm no\n" + half_way + both + last +
         "print \"rest $(c_second[2]:%.17g)\"\n";
}

}  // namespace

TEST_CASE("each compute fractional/energy has what was lost since it was made, whatever becomes of others") {
  const std::string both = said("both", one_law(target(tcol, en)), commands(false));
  const double half_way = number_after(both, "half way "), whole = number_after(both, "whole "),
               rest = number_after(both, "rest ");
  CHECK(half_way > 0);
  CHECK(rest > 0);
  CHECK(half_way + rest == Approx(whole).epsilon(1e-12));
  const double kinetic = grains[0].mass() * speed * speed / 4;
  CHECK(whole == Approx((1 - en * en) * kinetic).epsilon(1e-2));
  CHECK(number_after(said("one", one_law(target(tcol, en)), commands(true)), "rest ") == rest);
}
