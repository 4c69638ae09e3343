#include <ricochet/contact/laws.hpp>

#include <catch2/catch.hpp>

#include <limits>
#include <string>
#include <vector>

using namespace ricochet;

namespace {

/// "k kg/s^2, c kg/s"
std::string described(LawKind kind) {
  std::string text;
  for (const Parameter& p : kind.parameters())
    text += (text.empty() ? "" : ", ") + std::string(p.name) + (p.unit().empty() ? "" : " " + p.unit());
  return text;
}

}  // namespace

TEST_CASE("a unit is written as in the tables of the field") {
  CHECK(unit_text({}).empty());
  CHECK(unit_text({4, 0, -8}) == "kg/s^2");
  CHECK(unit_text({4, -2, -8}) == "kg/(s^2 m^(1/2))");
  CHECK(unit_text({4, -1, -4}) == "kg/(s m^(1/4))");
  CHECK(unit_text({0, 6, -3}) == "m^(3/2)/s^(3/4)");
  CHECK(unit_text({4, 4, -8}) == "kg m/s^2");
  CHECK(unit_text({0, 0, -4}) == "1/s");
  CHECK(unit_text({0, -4, -4}) == "1/(s m)");
  CHECK(unit_text({0, 5, 0}) == "m^(5/4)");
}

TEST_CASE("each law states the parameters and units that are published of it") {
  CHECK(described(kind_of<Linear>) == "k kg/s^2, c kg/s");
  CHECK(described(kind_of<KuwabaraKono>) == "k kg/(s^2 m^(1/2)), c kg/(s m^(1/2))");
  CHECK(described(kind_of<Tsuji>) == "k kg/(s^2 m^(1/2)), c kg/(s m^(1/4))");
  CHECK(described(kind_of<Hysteretic>) == "k1 kg/s^2, k2 kg/s^2");
  CHECK(described(kind_of<Fractional>) == "k kg/s^2, c kg/s, alpha");
}

TEST_CASE("a law's kind is found by its name, and by nothing else") {
  const std::vector<std::string> names{"linear",           "kuwabara-kono",   "tsuji",
                                       "hysteretic",       "fractional",      "fractional-kelvin-voigt",
                                       "fractional-hertz", "fractional-zener"};
  std::vector<std::string> all;
  for (const LawKind kind : LawKind::all()) {
    all.emplace_back(kind.name());
    REQUIRE(LawKind::named(kind.name()));
    CHECK(*LawKind::named(kind.name()) == kind);
    CHECK(LawKind::all()[kind.index()] == kind);
  }
  CHECK(all == names);
  for (const char* other : {"", "Linear", "linear ", "lin", "nonlinear"}) CHECK_FALSE(LawKind::named(other));
  CHECK(LawKind() == kind_of<Linear>);
}

TEST_CASE("a kind makes the law of its values, which names itself and gives them back") {
  const std::vector<std::vector<double>> given{
      {5000, 0.1},      {1e6, 30},       {1e6, 2},        {4000, 16000},
      {5000, 0.3, 0.2}, {5000, 20, 0.4}, {1e6, 3e3, 0.6}, {5000, 5e5, 1e-7, 0.5}};
  for (const LawKind kind : LawKind::all()) {
    CAPTURE(kind.name());
    const auto& numbers = given.at(kind.index());
    const AnyLaw law = kind.with(numbers);
    CHECK(LawKind::of(law) == kind);
    CHECK(name(law) == kind.name());
    CHECK(values(law) == numbers);
    const auto named = parameters(law);
    REQUIRE(named.size() == numbers.size());
    for (std::size_t i = 0; i < named.size(); ++i) {
      CHECK(named[i].name == kind.parameters()[i].name);
      CHECK(named[i].value == numbers[i]);
      CHECK(named[i].unit == kind.parameters()[i].unit());
    }
    std::vector<double> more = numbers;
    more.push_back(1);
    CHECK_THROWS_WITH(kind.with(more), Catch::Contains("number of parameters") && Catch::Contains("that of the law"));
  }
  CHECK_THROWS_WITH(kind_of<Tsuji>.with(std::vector<double>{1, -2}), "c = -2: must be finite and >= 0");
}

TEST_CASE("only of the fractional law a collision shows less than the parameters") {
  for (const LawKind kind : LawKind::all()) {
    const AnyLaw law = kind.with(std::vector<double>(kind.parameters().size(), 0.5));
    const bool itself = identifiable(law).front().name == parameters(law).front().name;
    CHECK(itself == (kind != kind_of<Fractional>));
  }
  const auto seen = identifiable(Fractional(4, 1, 0.5));
  REQUIRE(seen.size() == 2);
  CHECK(seen[0].value == 0.5);
  CHECK(seen[1].value == Approx(2).epsilon(1e-15));
}

TEST_CASE("a domain ends where it says, for every parameter of every law") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double smallest = std::numeric_limits<double>::denorm_min();
  const auto contains = [](const Domain& d, double x) { return d.contains(x); };
  CHECK(contains(domains::positive, smallest));
  CHECK_FALSE(contains(domains::positive, 0));
  CHECK(contains(domains::not_negative, 0));
  CHECK_FALSE(contains(domains::not_negative, -smallest));
  for (const LawKind kind : LawKind::all())
    for (const Parameter& p : kind.parameters())
      for (const double x : {infinity, std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(kind.name(), p.name, x);
        CHECK_FALSE(p.domain.contains(x));
      }
}

TEST_CASE("a law is representable whose parameters are normal, or a zero of their domain") {
  const double subnormal = std::numeric_limits<double>::min() / 2;
  CHECK(representable<Linear>({1, 0}));
  CHECK(representable<Fractional>({1, 1, 0}));
  CHECK_FALSE(representable<Linear>({0, 1}));
  CHECK_FALSE(representable<Linear>({subnormal, 1}));
  CHECK_FALSE(representable<Linear>({1, subnormal}));
  CHECK_FALSE(representable<Linear>({std::numeric_limits<double>::infinity(), 1}));
  CHECK_FALSE(representable<Fractional>({1, 0, 0.5}));
  CHECK(representable<Tsuji>({3, 2})->values() == std::array<double, 2>{3, 2});
  // What is a number but outside the domain is the caller's error.
  CHECK_THROWS_WITH(representable<Linear>({-1, 1}), "k = -1: must be finite and > 0");
}

TEST_CASE("every law ends by force, some by overlap") {
  for (const LawKind kind : LawKind::all()) {
    const bool overlap = kind == kind_of<Linear> || kind == kind_of<Tsuji> || kind == kind_of<Fractional> ||
                         kind == kind_of<FractionalKelvinVoigt>;
    CHECK(kind.ends().offer(ContactEnd::force));
    CHECK(kind.ends().offer(ContactEnd::overlap) == overlap);
    CHECK(kind.ends().both_by_default == (kind == kind_of<Linear>));
  }
}
