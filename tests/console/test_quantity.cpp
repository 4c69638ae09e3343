#include <catch2/catch.hpp>
#include <console/quantity.hpp>

#include <numbers>
#include <vector>

using namespace ricochet::console;

TEST_CASE("numbers carry units as people write them, rounded once") {
  struct Case {
    const char *text, *si;
    double value;
  };
  for (const auto& [text, si, value] : {Case{"20us", "s", 20e-6},
                                        {"20 µs", "s", 20e-6},
                                        {"20μs", "s", 20e-6},
                                        {"0.3ms", "s", 0.3e-3},
                                        {"7ns", "s", 7e-9},
                                        {"3s", "s", 3},
                                        {"1e-4", "s", 1e-4},
                                        {"+1.1e3mm", "m", 1.1},
                                        {"5um", "m", 5e-6},
                                        {"2m", "m", 2},
                                        {"3g", "kg", 3e-3},
                                        {"7.7mg", "kg", 7.7e-6},
                                        {"65GPa", "Pa", 65e9},
                                        {"10MPa", "Pa", 10e6},
                                        {"4kPa", "Pa", 4e3},
                                        {"9Pa", "Pa", 9},
                                        {"2.5g/cm^3", "kg/m^3", 2500},
                                        {"5N/m", "kg/s^2", 5},
                                        {"5kN/m", "kg/s^2", 5e3},
                                        {"5N/m^1.5", "kg/(s^2 m^(1/2))", 5},
                                        {"5 N/m^(3/2)", "kg/(s^2 m^(1/2))", 5},
                                        {"2MN/m^1.5", "kg/(s^2 m^(1/2))", 2e6},
                                        {"12", "1", 12},
                                        {"300mm/s", "m/s", 0.3},
                                        {"1%", "", 0.01},
                                        {"0.5", "", 0.5},
                                        {"1rad", "rad", 1},
                                        {"180deg", "rad", std::numbers::pi}}) {
    CAPTURE(text);
    REQUIRE(parse_quantity(text, si));
    CHECK(*parse_quantity(text, si) == value);
  }
  for (const auto& [text, si] : {std::pair("", "s"),
                                 {"s", "s"},
                                 {"20kg", "s"},
                                 {"20  us", "s"},
                                 {"20us ", "s"},
                                 {"nan", "s"},
                                 {"inf", ""},
                                 {"1e400", ""},
                                 {"1e300GPa", "Pa"},
                                 {"+-1", ""},
                                 {"1-", ""},
                                 {"30deg", ""},
                                 {"5N/mm", "kg/(s^2 m^(1/2))"},
                                 {"5N/m^1.5", "kg/s^2"},
                                 {"100%", "1"},
                                 {"1,5", ""},
                                 {"0x10", ""}}) {
    CAPTURE(text);
    CHECK_FALSE(parse_quantity(text, si));
  }
}

TEST_CASE("lists and ranges of numbers") {
  using Values = std::vector<double>;
  CHECK(parse_quantities("0.5", "") == Values{0.5});
  CHECK(parse_quantities("0.1,0.2,5e-1", "") == Values{0.1, 0.2, 0.5});
  CHECK(parse_quantities("1us,2ms", "s") == Values{1e-6, 2e-3});
  CHECK(parse_quantities("0.3:0.9:0.1", "") == Values{0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9});
  CHECK(parse_quantities("0.9:0.3:-0.3", "") == Values{0.9, 0.6, 0.3});
  CHECK(parse_quantities("1:2:0.4", "") == Values{1, 1.4, 1.8});
  CHECK(parse_quantities("2:2:1", "") == Values{2});
  CHECK(parse_quantities("1us:3us:1us", "s") == Values{1e-6, 2e-6, 3e-6});
  CHECK(parse_quantities("0:9999:1", "").size() == 10000);
  for (const auto& [text, accepted] :
       {std::pair("1,2,5us", "a list with a unit at every number or at none"),
        {"1:2:1us", "a list with a unit at every number or at none"},
        {"1,,2", "a finite number, plain or with a unit: s, ms, us or ns"},
        {"1:2", "from:to:step, a list a,b,c or one number"},
        {"1:2:3:4", "from:to:step, a list a,b,c or one number"},
        {"1:2:0", "from:to:step with a step that leads from one to the other, 10000 values at most"},
        {"1:2:-1", "from:to:step with a step that leads from one to the other, 10000 values at most"},
        {"0:10000:1", "from:to:step with a step that leads from one to the other, 10000 values at most"}}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(parse_quantities(text, "s"), accepted);
  }
}

TEST_CASE("the units that are known are said") {
  CHECK(unit_choices("s") == "s, ms, us or ns");
  CHECK(unit_choices("Pa") == "Pa, kPa, MPa or GPa");
  CHECK(unit_choices("kg/s^2") == "kg/s^2, N/m, N/mm, kN/m or MN/m");
  CHECK(unit_choices("rad") == "rad or deg");
  CHECK(unit_choices("") == "%");
  CHECK(unit_choices("furlong") == "furlong");
}
