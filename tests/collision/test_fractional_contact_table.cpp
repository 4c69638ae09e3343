#include <catch2/catch.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/fractional_contact_table.hpp>

#include <algorithm>
#include <cmath>

using namespace ricochet;

TEST_CASE("the table of fractional contacts agrees with the closed form everywhere") {
  const FractionalContactTable table;
  constexpr int points = 400;  // 26 to a panel of 16 nodes, never on a node
  for (int i = 0; i <= points; ++i) {
    const double en = std::min(1.0, std::pow(0.006, 1 - i / static_cast<double>(points)));
    const auto entry = table(std::max(en, 0.006));
    const FractionalContact c = fractional_contact(conversion_degree(std::max(en, 0.006)));
    INFO("en = " << en);
    CHECK(std::abs(entry.alpha - c.alpha) < 1e-12);
    CHECK(std::abs(entry.z_star / c.z_star - 1) < 1e-11);
    CHECK(std::abs(entry.overlap_end - c.overlap_end) < 1e-12);
    CHECK(std::abs(entry.max_overlap / c.max_overlap - 1) < 1e-11);
    CHECK(std::abs(entry.max_force / c.max_force - 1) < 1e-11);
  }
  CHECK_THROWS_WITH(table(0.005), "en = 0.005: must be in [0.006, 1]");
  CHECK_THROWS_AS(table(1.1), std::invalid_argument);
}
