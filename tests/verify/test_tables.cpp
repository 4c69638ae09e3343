#include "parsed_selection.hpp"

#include "../../verify/studies/convergence_figures.hpp"
#include "../../verify/studies/convergence_tables.hpp"
#include "../../verify/studies/selection.hpp"

#include <verify/document.hpp>

#include <console/exit.hpp>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <string>

using namespace ricochet;
using namespace ricochet::verify;

namespace {

/// A case whose errors are N^{−order}, and nothing but rounding where there is no order.
Convergence case_of(const char* scheme, const char* function, double alpha, std::optional<double> order) {
  Convergence c{.statement = {scheme, function, alpha, order, 0.1}};
  for (std::size_t n = 10; n <= 1250; n *= 5) {
    c.steps.push_back(n);
    c.errors.push_back(order ? std::pow(static_cast<double>(n), -*order) : 1e-16);
    c.values.push_back(c.errors.back());
  }
  return c;
}

std::vector<Convergence> two_schemes() {
  return {case_of("A", "t", 0.1, 2), case_of("A", "t", 0.5, 2), case_of("A", "t^2", 0.1, std::nullopt),
          case_of("B", "t", 0.1, 1)};
}

Selection selected(std::vector<std::string> arguments) {
  Selection wanted = parsed_selection(std::move(arguments));
  wanted.check({"A", "B, fine"}, {"t", "t^2"});
  return wanted;
}

}  // namespace

TEST_CASE("the long table has one row a mesh, under the promised header") {
  const std::string csv = long_table(two_schemes()).csv();
  CHECK(csv.starts_with(
      "scheme,function,alpha,n,dt,error,pairwise_order,stated_order,pass\nA,t,0.1,10,0.1,0.01,,2,true\n"));
  CHECK(csv.find("\nA,t^2,0.1,50,0.02,1e-16,0,,true\n") != std::string::npos);
  const auto rows = long_table(two_schemes()).rows();
  CHECK(rows.size() == 4 * 4);
  // Meshes are refined by five here: the order is still that of the power.
  CHECK(std::get<double>(rows[1][6]) == Approx(2).epsilon(1e-12));
  CHECK(std::get<double>(rows[13][6]) == Approx(1).epsilon(1e-12));
}

TEST_CASE("each scheme has a compact table with an order column an alpha, no wider than a terminal") {
  const auto tables = scheme_tables(two_schemes());
  REQUIRE(tables.size() == 2);
  CHECK(tables[0].columns().size() == 2 + 2 * 2);
  CHECK(tables[1].columns().size() == 2 + 2);
  // Two functions of four meshes, each followed by "stated" and "observed".
  CHECK(tables[0].rows().size() == 2 * (4 + 2));
  std::vector<Convergence> all;
  for (const double alpha : studied_orders) all.push_back(case_of("A", "t^1.5, all nodes", alpha, 2));
  const std::string text = scheme_tables(all)[0].text();
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    CHECK(console::display_width(text.substr(at, text.find('\n', at) - at)) <= 120);
}

TEST_CASE("the summary says what failed") {
  auto all = two_schemes();
  CHECK(std::get<std::int64_t>(summary_table(all, "").rows()[0][2]) == 3);
  all[1].statement.order = 2.2;  // observed 2, allowed 0.1: twice too far
  const auto row = summary_table(all, "").rows()[0];
  CHECK(std::get<std::int64_t>(row[2]) == 2);
  CHECK(std::get<double>(row[5]) == Approx(2).epsilon(1e-9));
  CHECK(std::get<std::string>(row[6]) == "t, α = 0.5");
  CHECK(scheme_tables(all)[0].text().find("FAILS") != std::string::npos);
}

TEST_CASE("one figure a scheme that has an order, with the stated slope in every panel") {
  const auto figures = convergence_figures(two_schemes(), "toy");
  REQUIRE(figures.size() == 2);
  CHECK(figures[0].name == "toy-a");
  CHECK(console::script_of(figures[0].plot).find("α = 0.1") != std::string::npos);
  CHECK(console::script_of(figures[0].plot).find("set label '2' at") != std::string::npos);
  CHECK(console::script_of(figures[1].plot).find("set label '1' at") != std::string::npos);
  CHECK(convergence_figures({case_of("C", "t", 0.1, std::nullopt)}, "toy").empty());
  CHECK(figures[0].data[0].bytes.find("\n\"t\",0.5,10,0.01\n") != std::string::npos);
  CHECK(figures[0].finding == "In 2 cases the observed order is within 0.00 of the stated one.");
}

TEST_CASE("the triangle of a stated order has that slope, and stands below the curve") {
  // From 10 steps on, over the two next: from (n1, top) straight down, and along to n2.
  const double order = 2;
  const auto figure = convergence_figures({case_of("A", "t", 0.1, order)}, "toy").front();
  std::smatch corner;
  const std::string script = console::script_of(figure.plot);
  REQUIRE(std::regex_search(script, corner,
                            std::regex("set object polygon from ([^,]+),([^ ]+) to ([^,]+),([^ ]+) to ([^,]+),")));
  const auto number = [&](std::size_t i) { return std::stod(corner[i].str()); };
  const double n1 = number(1), top = number(2), bottom = number(4), n2 = number(5);
  CHECK(number(3) == n1);
  CHECK(n2 > n1);
  CHECK(std::log(top / bottom) / std::log(n2 / n1) == Approx(order).epsilon(1e-12));
  CHECK(top < std::pow(n1, -order));
}

TEST_CASE("what a user asks for is what is measured, and a wrong word is refused") {
  CHECK(selected({}).everything());
  CHECK(selected({"--summary"}).summary_only());
  const Selection one = selected({"--scheme", "B, fine", "--alpha", "0.2,0.3", "--steps", "10,30,90"});
  CHECK_FALSE(one.everything());
  for (const auto& [option, value] : {std::pair("--scheme", "A"), std::pair("--function", "t"),
                                      std::pair("--alpha", "0.2"), std::pair("--steps", "10,20,40")})
    CHECK_FALSE(selected({option, value}).everything());
  CHECK(one.scheme("B, fine"));
  CHECK_FALSE(one.scheme("A"));
  CHECK(one.function("t"));
  CHECK(one.alphas() == std::vector<double>{0.2, 0.3});
  CHECK(one.steps(4096) == std::vector<std::size_t>{10, 30, 90});
  CHECK(selected({"--alpha", "0.2"}).steps(64) == std::vector<std::size_t>{16, 32, 64});
  CHECK_THROWS_AS(selected({"--scheme", "C"}), console::BadInput);
  CHECK_THROWS_AS(selected({"--function", "t^3"}), console::BadInput);
  CHECK_THROWS_AS(selected({"--alpha", "0.98"}), console::BadInput);
  CHECK_THROWS_AS(selected({"--alpha", "x"}), CLI::ValidationError);
  CHECK_THROWS_AS(selected({"--steps", "10,20"}), console::BadInput);
  CHECK_THROWS_AS(selected({"--steps", "10,20,20"}), console::BadInput);
  CHECK_THROWS_AS(selected({"--steps", "10,20.5,30"}), CLI::ValidationError);
  CHECK_THROWS_AS(selected({"--steps", "3,20,30"}), CLI::ValidationError);
}

TEST_CASE("JUnit has a test case a gate, a failure that says the bound, and what was skipped") {
  StudyResult result;
  result.gates = {at_most("calm <b> & \"c\"", 0.5, 1), at_most("high", 2, 1), at_most("none", std::nan(""), 1)};
  result.skipped = {"an engine"};
  const std::string suite = junit_suite("toy", result);
  CHECK(suite ==
        "  <testsuite name=\"toy\" tests=\"4\" failures=\"2\" skipped=\"1\">\n"
        "    <testcase classname=\"verify.toy\" name=\"calm &lt;b&gt; &amp; &quot;c&quot;\"/>\n"
        "    <testcase classname=\"verify.toy\" name=\"high\"><failure message=\"2: must be &lt;= 1\"/></testcase>\n"
        "    <testcase classname=\"verify.toy\" name=\"none\"><failure message=\"not finite: must be &lt;= "
        "1\"/></testcase>\n"
        "    <testcase classname=\"verify.toy\" name=\"an engine\"><skipped/></testcase>\n"
        "  </testsuite>\n");
  CHECK(junit_document(suite).starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite "));
}

TEST_CASE("LaTeX is a booktabs table with its own signs escaped") {
  console::Table table({{"law"}, {"α_1", "%"}}, "50 % & more");
  table.row({"a_b", 0.5}).row({"[c]", console::blank()}).note("x < y");
  CHECK(table.latex() ==
        "\\begin{table}\n\\centering\n\\caption{50 \\% \\& more}\n\\begin{tabular}{lr}\n\\toprule\n"
        "law & $\\alpha$\\_1 \\\\\n & [\\%] \\\\\n\\midrule\na\\_b & 0.5 \\\\\n{}[c] & - \\\\\n\\bottomrule\n"
        "\\end{tabular}\n\\par\\smallskip\\footnotesize x $<$ y\n\\end{table}\n");
}
