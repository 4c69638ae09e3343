#include "../console/temporary_folder.hpp"

#include <ricochet/verify/order.hpp>

#include <verify/order_check.hpp>
#include <verify/program.hpp>

#include <console/json.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

using namespace ricochet;
using namespace ricochet::verify;
using Verdict = ObservedOrder::Verdict;

namespace {

/// C h^p on meshes that are not halved.
ObservedOrder of_power(double p, const OrderClaim& claim) {
  return observe_order([p](double h) { return 3 * std::pow(h, p); }, refined(0.2, 5, 1.7), claim);
}

}  // namespace

TEST_CASE("an order is observed on any refinement and judged from both sides, the bound included on neither") {
  // Of a pure power every pairwise order is p, to the rounding of three or four logarithms.
  for (const double p : {0.4, 1.0, 1.9, 2.0, 3.5}) {
    const ObservedOrder o = of_power(p, {.stated = p});
    CHECK(o.verdict == Verdict::confirmed);
    CHECK(o.order == Approx(p).epsilon(1e-12));
    CHECK(o.uncertainty < 1e-12);
    CHECK(o.first == 0);
    CHECK(o.last == 5);
    CHECK(o.floor == 0);
    for (std::size_t i = 1; i < 5; ++i) CHECK(o.pairwise[i] == Approx(p).epsilon(1e-12));
    CHECK(std::isnan(o.pairwise[0]));
    CHECK(of_power(p, {.stated = p + 0.099}));
    CHECK(of_power(p, {.stated = p - 0.099}));
    CHECK(of_power(p, {.stated = p + 0.101}).verdict == Verdict::lower);
    CHECK(of_power(p, {.stated = p - 0.101}).verdict == Verdict::higher);
  }
}

TEST_CASE("the order of the meshes and the sign of the errors do not matter") {
  const std::vector<double> h{0.1, 0.4, 0.05, 0.2}, e{-0.01, 0.16, 0.0025, -0.04};
  const ObservedOrder o = observe_order(h, e, {.stated = 2});
  CHECK(o);
  CHECK(o.h == std::vector<double>{0.4, 0.2, 0.1, 0.05});
  CHECK(o.error == std::vector<double>{0.16, 0.04, 0.01, 0.0025});
}

TEST_CASE("rounding at the fine end is found, said and left out") {
  // h⁴ from 1e-4 falls below the noise of 1e-13 after eight halvings; twenty times the noise stands on mesh 6.
  std::mt19937_64 random(2004);
  std::normal_distribution<double> noise(0, 1e-13);
  const ObservedOrder o =
      observe_order([&](double h) { return std::pow(h, 4) + noise(random); }, refined(0.1, 11), {.stated = 4});
  CHECK(o.verdict == Verdict::confirmed);
  CHECK(o.floor > 2e-14);
  CHECK(o.floor < 5e-13);
  CHECK(o.last >= 5);
  CHECK(o.last <= 8);
  CHECK(o.error[o.last - 1] >= 20 * o.floor);
  CHECK(o.said.find("near the floor") != std::string::npos);
}

TEST_CASE("coarse meshes whose errors fall unevenly do not hide the floor of rounding") {
  // h⁴ − 40 h⁶ changes its sign at h = 0.158: uneven, but far above rounding.
  std::mt19937_64 random(2004);
  std::normal_distribution<double> noise(0, 1e-13);
  const auto error = [&](double h) { return std::pow(h, 4) - 40 * std::pow(h, 6) + noise(random); };
  const ObservedOrder o = observe_order(error, refined(0.4, 13), {.stated = 4});
  CHECK(o.verdict == Verdict::confirmed);
  CHECK(o.floor > 2e-14);
  CHECK(o.floor < 5e-13);
  CHECK(o.first > 0);
}

TEST_CASE("errors that stop falling above what rounding may make are the scheme's own") {
  const auto plateau = [](double h) { return h * h + 1e-6; };
  CHECK(observe_order(plateau, refined(0.1, 12), {.stated = 2}).verdict == Verdict::lower);
  CHECK(observe_order(plateau, refined(0.1, 12), {.stated = 2, .rounding = 1e-5}).verdict == Verdict::confirmed);
  CHECK(observe_order([](double) { return 1e-3; }, refined(0.1, 5), {.stated = 2}).verdict == Verdict::lower);
}

TEST_CASE("nothing is concluded from rounding alone, or from exact zeros") {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 1e-15);
  const ObservedOrder o = observe_order([&](double) { return noise(random); }, refined(0.1, 8), {.stated = 2});
  CHECK(o.verdict == Verdict::undecided);
  CHECK(o.said.find("floor of rounding") != std::string::npos);
  CHECK(observe_order([](double) { return 0.0; }, refined(0.1, 4), {.stated = 2}).verdict == Verdict::undecided);
}

TEST_CASE("the pre-asymptotic range is found, said and left out") {
  // h² + 50 h⁴: pairwise orders fall from near 4 to 2; log₂((1+50h²)/(1+12.5h²)) ≤ 0.1 below h ≈ 0.04.
  const ObservedOrder o =
      observe_order([](double h) { return h * h + 50 * std::pow(h, 4); }, refined(0.4, 10), {.stated = 2});
  CHECK(o.verdict == Verdict::confirmed);
  CHECK(o.h[o.first] < 0.11);
  CHECK(o.h[o.first] > 0.02);
  CHECK(o.said.find("pre-asymptotic above h = ") != std::string::npos);
}

TEST_CASE("orders that have not settled decide nothing") {
  // Pairwise orders 2.3 and 1.7: the slope is 2, but it is not known to 0.1.
  const std::vector<double> h{1, 0.5, 0.25}, e{1, std::exp2(-2.3), std::exp2(-4.0)};
  const ObservedOrder o = observe_order(h, e, {.stated = 2});
  CHECK(o.order == Approx(2).epsilon(1e-12));
  CHECK(o.uncertainty == Approx(0.3).epsilon(1e-12));
  CHECK(o.verdict == Verdict::undecided);
  CHECK(observe_order(h, e, {.stated = 2, .allowed = 0.31}).verdict == Verdict::confirmed);
}

TEST_CASE("values are judged against the finest mesh or the extrapolated limit") {
  const auto h = refined(0.4, 12);
  const auto values = [&h](double p) {
    std::vector<double> v;
    for (const double step : h) v.push_back(3 + std::pow(step, p));
    return v;
  };
  for (const double p : {1.0, 2.0, 3.0}) {
    // The finest mesh's own error adds at most log₂(1/(1 − 1/50)) = 0.03 to a pairwise order.
    const ObservedOrder finest = observe_order_by_finest(h, values(p), {.stated = p});
    CHECK(finest);
    CHECK(finest.order >= p);
    CHECK(finest.order < p + 0.03);
    // Exact for a pure power, but for the rounding of values near 3.
    const ObservedOrder limit = observe_order_by_richardson(h, values(p), {.stated = p});
    CHECK(limit);
    CHECK(limit.order == Approx(p).margin(1e-3));
    CHECK(limit.h.size() == h.size() - 1);
    for (const double wrong : {p - 0.2, p + 0.2}) {
      CHECK_FALSE(observe_order_by_finest(h, values(p), {.stated = wrong}));
      CHECK_FALSE(observe_order_by_richardson(h, values(p), {.stated = wrong}));
    }
  }
}

TEST_CASE("misuse of the order gate is refused by name") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const std::vector<double> h{0.4, 0.2, 0.1}, e{4, 2, 1};
  CHECK_THROWS_WITH(observe_order(h, std::vector<double>{1, 2}, {.stated = 1}), Catch::Contains("meshes = 3"));
  CHECK_THROWS_WITH(observe_order(std::vector<double>{1, 2}, std::vector<double>{1, 2}, {.stated = 1}),
                    "meshes = 2: must be at least 3");
  CHECK_THROWS_WITH(observe_order(std::vector<double>{1, 0, 2}, e, {.stated = 1}), Catch::Contains("h = 0"));
  CHECK_THROWS_WITH(observe_order(std::vector<double>{1, 2, 2}, e, {.stated = 1}), Catch::Contains("must stand once"));
  CHECK_THROWS_AS(observe_order(h, std::vector<double>{1, nan, 2}, {.stated = 1}), std::invalid_argument);
  for (const double wrong : {0.0, -1.0, nan, inf}) {
    CHECK_THROWS_WITH(observe_order(h, e, {.stated = wrong}), Catch::Contains("stated = "));
    CHECK_THROWS_WITH(observe_order(h, e, {.stated = 1, .allowed = wrong}), Catch::Contains("allowed = "));
  }
  CHECK_THROWS_WITH(observe_order(h, e, {.stated = 1, .rounding = -1}), Catch::Contains("rounding = -1"));
  CHECK_THROWS_AS(observe_order_by_richardson(h, e, {.stated = 1}), std::invalid_argument);
  CHECK_THROWS_AS(observe_order_by_finest(h, e, {.stated = 1}), std::invalid_argument);
}

namespace {

struct Ran {
  int code;
  std::string out;
};

/// `verify order FILE …` of a file with that text.
Ran run(const std::string& csv, std::vector<const char*> arguments) {
  const TemporaryFolder folder;
  const std::string in = folder / "in.csv", out = folder / "out";
  std::ofstream(in) << csv;
  Studies checks;
  checks.push_back(order_check());
  arguments.insert(arguments.begin(), {"verify", "order", in.c_str()});
  arguments.insert(arguments.end(), {"-o", out.c_str()});
  const int code = run_verify({}, checks, static_cast<int>(arguments.size()), arguments.data());
  return {code, code <= 1 ? read_file(out) : ""};
}

constexpr const char* second_order = "scheme,case,n,error\nmine,a,10,1e-2\nmine,a,20,2.5e-3\nmine,a,40,6.25e-4\n";

}  // namespace

TEST_CASE("verify order: exit codes and JSON") {
  const Ran good = run(second_order, {"--stated", "2", "--format", "json"});
  CHECK(good.code == 0);
  const auto json = console::Json::parse(good.out);
  CHECK(json["schema"] == "ricochet/order/1");
  CHECK(json["gates"][0]["name"] == "mine, a: order");
  CHECK(json["gates"][0]["pass"] == true);
  CHECK(double(json["gates"][0]["bound"][0]) == Approx(1.9));
  CHECK(json["rows"].size() == 3);
  CHECK(json["rows"][0]["pairwise_order"].is_null());
  CHECK(double(json["rows"][2]["pairwise_order"]) == Approx(2));
  CHECK(json["rows"][1]["h"] == 1 / 20.0);
  const auto& fit = json["fits"][0];
  CHECK(fit["scheme"] == "mine");
  CHECK(fit["case"] == "a");
  CHECK(double(fit["order"]) == Approx(2));
  CHECK(fit["range"] == console::Json({0.1, 0.025}));
  CHECK(fit["floor"].is_null());
  CHECK(run(second_order, {"--stated", "1.85"}).code == 1);
  CHECK(run(second_order, {"--stated", "2.15"}).code == 1);
  CHECK(run(second_order, {"--stated", "2.15", "--allowed", "0.2"}).code == 0);
}

TEST_CASE("verify order: an order that has not settled fails, although it is the stated one") {
  // Pairwise orders 2.3 and 1.7.
  const char* unsettled = "h,error\n1,1\n0.5,0.20306309908\n0.25,0.0625\n";
  const Ran ran = run(unsettled, {"--stated", "2", "--format", "json"});
  CHECK(ran.code == 1);
  const auto gate = console::Json::parse(ran.out)["gates"][0];
  CHECK(gate["name"] == "data: uncertainty of the order");
  CHECK(double(gate["value"]) == Approx(0.3).epsilon(1e-6));
  CHECK(run(unsettled, {"--stated", "2", "--allowed", "0.31"}).code == 0);
}

TEST_CASE("verify order: CSV and JUnit") {
  const Ran csv = run(second_order, {"--stated", "2", "--format", "csv"});
  CHECK(csv.out.starts_with("scheme,case,h,error,pairwise_order,in_range\nmine,a,0.1,0.01,,true\n"));
  const Ran junit = run(second_order, {"--stated", "3", "--format", "junit"});
  CHECK(junit.code == 1);
  CHECK(junit.out.find("<testsuite name=\"order\" tests=\"1\" failures=\"1\" skipped=\"0\">") != std::string::npos);
  CHECK(junit.out.find("<failure message=\"") != std::string::npos);
}

TEST_CASE("verify order: values and their references") {
  std::string csv = "h,value\n";
  for (const double h : refined(0.1, 9)) {
    std::ostringstream row;
    row.precision(17);
    row << h << ',' << 1 + h * h << '\n';
    csv += row.str();
  }
  CHECK(run(csv, {"--stated", "2", "--reference", "finest"}).code == 0);
  CHECK(run(csv, {"--stated", "2", "--reference", "richardson"}).code == 0);
  CHECK(run(csv, {"--stated", "1", "--reference", "finest"}).code == 1);
  CHECK(run(csv, {"--stated", "1", "--reference", "richardson"}).code == 1);
  CHECK(run(csv, {"--stated", "2", "--reference", "exact"}).code == 2);
}

TEST_CASE("verify order: bad input") {
  CHECK(run("h,error\n1,1\n", {"--stated", "1"}).code == 2);              // too few
  CHECK(run("h,error\n1,1\n.5,x\n", {"--stated", "1"}).code == 2);        // no number
  CHECK(run("h,error\n1,1\n.5\n", {"--stated", "1"}).code == 2);          // a field is missing
  CHECK(run("h,n,error\n1,1,1\n", {"--stated", "1"}).code == 2);          // both
  CHECK(run("x,error\n1,1\n", {"--stated", "1"}).code == 2);              // neither
  CHECK(run("h,error,value\n1,1,1\n", {"--stated", "1"}).code == 2);      // both
  CHECK(run("h,error\n1,1\n1,2\n.5,2\n", {"--stated", "1"}).code == 2);   // twice
  CHECK(run("h,error\n-1,1\n1,2\n.5,2\n", {"--stated", "1"}).code == 2);  // negative
  CHECK(run("", {"--stated", "1"}).code == 2);
  // What a spreadsheet or a terminal would obey.
  for (const std::string word : {"=cmd|' /C calc'!A0", "@sum", "\x1b[2J"})
    for (const std::string column : {"scheme", "case"}) {
      CAPTURE(word, column);
      CHECK(run(column + ",h,error\n" + word + ",.4,.16\n" + word + ",.2,.04\n" + word + ",.1,.01\n", {"--stated", "2"})
                .code == 2);
    }
  CHECK(run(second_order, {"--stated", "0"}).code == 2);
  CHECK(run(second_order, {"--stated", "2", "--allowed", "-1"}).code == 2);
  CHECK(run(second_order, {"--stated", "2", "--reference", "best"}).code == 2);
  CHECK(run(second_order, {}).code == 2);
}
