#include <catch2/catch.hpp>
#include <ricochet/contact/fractional_collocation.hpp>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

using namespace ricochet;

TEST_CASE("24 collocation nodes reproduce the tabulated fractional contacts to 1e-10") {
  std::ifstream table(RICOCHET_SOURCE_DIR "/data/fractional_contact_reference.csv");
  int rows = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'a') continue;
    for (char& c : line)
      if (c == ',') c = ' ';
    double alpha = 0, z_star = 0, tau = 0, en = 0, overlap_end = 0, z_max = 0, t_max = 0, max_overlap = 0;
    std::istringstream(line) >> alpha >> z_star >> tau >> en >> overlap_end >> z_max >> t_max >> max_overlap;
    INFO("alpha = " << alpha);
    const FractionalSolution s = collocate_collision(alpha, 24);
    REQUIRE(s.separated);
    CHECK(std::abs(s.tcol / tau - 1) < 1e-10);
    CHECK(std::abs(s.en / en - 1) < 1e-10);
    CHECK(std::abs(s.overlap_end / tau - overlap_end) < 1e-10 * max_overlap);
    CHECK(std::abs(s.t_max_overlap / tau / t_max - 1) < 1e-10);
    CHECK(std::abs(s.max_overlap / tau / max_overlap - 1) < 1e-10);
    CHECK(s.solves == 1);
    ++rows;
  }
  CHECK(rows == 12);
}

TEST_CASE("collocation knows which collisions do not end") {
  CHECK_FALSE(collocate_collision(1).separated);
  CHECK_FALSE(collocate_collision(1.5).separated);
  CHECK(collocate_collision(0.4008, 40, ContactEnd::overlap).separated);
  CHECK_FALSE(collocate_collision(0.401, 40, ContactEnd::overlap).separated);
  CHECK_THROWS_WITH(collocate_collision(2), "alpha = 2: must be in [-1, 2)");
  CHECK_THROWS_WITH(collocate_collision(0.5, 3), "nodes = 3: must be in 4...120");
}

TEST_CASE("collocation of the elastic spring is the half sine") {
  const FractionalSolution s = collocate_collision(0, 24);
  CHECK(s.tcol == Approx(3.14159265358979323846).epsilon(1e-14));
  CHECK(s.en == Approx(1).epsilon(1e-13));
  CHECK(s.max_force == Approx(1).epsilon(1e-13));
  CHECK(s.max_overlap == Approx(1).epsilon(1e-13));
}
