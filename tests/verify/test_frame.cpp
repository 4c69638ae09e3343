#include "../console/temporary_folder.hpp"

#include <verify/program.hpp>
#include <verify/report.hpp>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <regex>
#include <utility>

using namespace ricochet;
using namespace ricochet::verify;

namespace {

/// A study whose gate passes as long as the value given on the command line stays small.
class Toy : public Study {
 public:
  explicit Toy(std::string name = "toy", double x = 0.5) : name_(std::move(name)), x_(x) {}
  std::string name() const override { return name_; }
  std::string title() const override { return "All about x"; }
  std::string claim() const override { return "x is small"; }
  void add_options(CLI::App& app) override { app.add_option("--x", x_, "a number"); }
  StudyResult run(const RunOptions& options) override {
    if (x_ > 100) throw std::runtime_error("x broke");
    StudyResult result;
    result.tables.emplace_back(std::vector<console::Column>{{"x", "m"}, {"thorough"}}, "A table");
    result.tables[0].row({x_, options.thorough});
    result.gates = {at_most("x is small", x_, 1)};
    result.extra["nc"] = 3;
    return result;
  }

 private:
  std::string name_;
  double x_;
};

struct Ran {
  int code;
  std::string out;
};

/// Runs `verify` with the given studies and arguments, the output through -o.
Ran run(const Studies& studies, std::vector<const char*> arguments) {
  const TemporaryFolder folder;
  const std::string file = folder / "out";
  arguments.insert(arguments.begin(), "verify");
  arguments.insert(arguments.end(), {"-o", file.c_str()});
  const int code = run_verify(studies, {}, static_cast<int>(arguments.size()), arguments.data());
  return {code, read_file(file)};
}

/// With one toy study.
Ran run(std::vector<const char*> arguments) {
  Studies studies;
  studies.push_back(std::make_unique<Toy>());
  return run(studies, std::move(arguments));
}

}  // namespace

TEST_CASE("gates pass on the right side only, and never for what is not a number") {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(at_most("", 1, 1).pass);
  CHECK_FALSE(at_most("", std::nextafter(1, 2), 1).pass);
  CHECK(at_least("", 1, 1).pass);
  CHECK_FALSE(at_least("", std::nextafter(1, 0), 1).pass);
  CHECK(between("", 1.5, 1, 2).pass);
  CHECK_FALSE(between("", 0.5, 1, 2).pass);
  CHECK_FALSE(between("", 2.5, 1, 2).pass);
  CHECK(near("", 2.0625, 2, 0.0625).pass);
  CHECK_FALSE(near("", 2.2, 2, 0.1).pass);
  CHECK_FALSE(near("", 1.8, 2, 0.1).pass);
  CHECK(holds("", true).pass);
  CHECK_FALSE(holds("", false).pass);
  for (const double value : {nan, inf, -inf}) {
    CHECK_FALSE(at_most("", value, 1).pass);
    CHECK_FALSE(at_least("", value, 1).pass);
    CHECK_FALSE(between("", value, -1, 1).pass);
  }
  CHECK(to_json(at_most("a", nan, 1)).dump() ==
        R"({"name":"a","value":null,"kind":"at_most","bound":1.0,"pass":false})");
  CHECK(to_json(near("a", 2, 2, 0.5)).dump() ==
        R"({"name":"a","value":2.0,"kind":"between","bound":[1.5,2.5],"pass":true})");
}

TEST_CASE("a study prints its tables and gates") {
  const Ran ran = run({"toy"});
  CHECK(ran.code == 0);
  CHECK(ran.out ==
        "A table\n  x  thorough\n[m]\n---  --------\n0.5  no\n"
        "\nGates\ngate        value  bound  pass\n----------  -----  -----  ----\nx is small    0.5  <= 1   yes\n");
}

TEST_CASE("a failed gate is exit code 1, with the output") {
  const Ran ran = run({"toy", "--x", "2", "--format", "json"});
  CHECK(ran.code == 1);
  const auto json = console::Json::parse(ran.out);
  CHECK(json["schema"] == "ricochet/toy/1");
  CHECK(json["gates"][0]["pass"] == false);
  CHECK(json["rows"][0]["x"] == 2.0);
  CHECK(json["units"]["x"] == "m");
  CHECK(json["nc"] == 3);
}

TEST_CASE("CSV carries the data alone") { CHECK(run({"toy", "--format", "csv"}).out == "x [m],thorough\n0.5,false\n"); }

TEST_CASE("an unknown study, or none, is bad input and a broken one failed") {
  CHECK(run({"none"}).code == 2);
  CHECK(run({}).code == 2);
  const Ran broken = run({"toy", "--x", "101"});
  CHECK(broken.code == 4);
  CHECK(broken.out.empty());
}

TEST_CASE("all runs every study thoroughly and writes the report") {
  const TemporaryFolder folder;
  const Ran ran = run({"all", "--report", (folder / "report").c_str(), "--format", "json"});
  CHECK(ran.code == 0);
  const auto json = console::Json::parse(ran.out);
  CHECK(json["schema"] == "ricochet/all/1");
  CHECK(json["gates"][0]["name"] == "toy: x is small");
  CHECK(json["studies"][0]["rows"][0]["thorough"] == true);
  CHECK(read_file(folder / "report/toy.csv") == "x [m],thorough\n0.5,true\n");
  CHECK(console::Json::parse(read_file(folder / "report/report.json"))["studies"][0]["files"] ==
        console::Json({"toy.json", "toy-gates.csv", "toy.csv"}));
  CHECK(read_file(folder / "report/index.html").find("1 gate passed, none failed.") != std::string::npos);
  CHECK(console::Json::parse(read_file(folder / "report/toy.json"))["schema"] == "ricochet/toy/1");
  CHECK(console::Json::parse(run({"all", "--quick", "--format", "json"}).out)["studies"][0]["rows"][0]["thorough"] ==
        false);
}

TEST_CASE("all fails where one study does, wherever it stands, and its CSV has every cell of every study") {
  for (const double first : {0.5, 2.0}) {
    Studies studies;
    studies.push_back(std::make_unique<Toy>("one", first));
    studies.push_back(std::make_unique<Toy>("two", 2.5 - first));
    const Ran ran = run(studies, {"all", "--quick", "--format", "csv"});
    CHECK(ran.code == 1);
    const std::string x = first == 2 ? "2" : "0.5", other = first == 2 ? "0.5" : "2";
    CHECK(ran.out == "study,table,row,column,unit,value\none,A table,1,x,m," + x +
                         "\none,A table,1,thorough,,false\ntwo,A table,1,x,m," + other +
                         "\ntwo,A table,1,thorough,,false\n");
  }
}

TEST_CASE("the facts say what was run, and the time that a reproducible build sets") {
  ::setenv("SOURCE_DATE_EPOCH", "86400", 1);  // the second day of 1970
  const Facts all = facts(true), quick = facts(false);
  ::unsetenv("SOURCE_DATE_EPOCH");
  const auto fact = [](const Facts& of, const std::string& what) {
    return std::find_if(of.begin(), of.end(), [&](const auto& f) { return f.first == what; })->second;
  };
  CHECK(fact(all, "time") == "1970-01-02 00:00 UTC");
  CHECK(fact(all, "extent") == "every study, thoroughly");
  CHECK(fact(quick, "extent") == "every study, without what takes long (--quick)");
  CHECK(fact(all, "version").starts_with("Ricochet "));
}

TEST_CASE("the report is one page that loads nothing, with what failed before what passed") {
  Toy toy;
  StudyResult result = toy.run({});
  result.gates = {at_most("calm <b>", 0.1, 1), at_most("near its bound", 0.9, 1), at_most("beyond", 2, 1),
                  holds("true", true)};
  result.verdict = "x is 0.5.";
  result.remarks = {{"Eq. (1)", "Printed wrongly."}};
  result.skipped = {"an engine"};
  std::vector<Outcome> outcomes(2);
  outcomes[0].study = outcomes[1].study = &toy;
  outcomes[0].result = result;
  outcomes[1].error = "x broke";
  const std::string page = report_page(outcomes, {{"version", "Ricochet 1"}});
  CHECK(page.find("http") == std::string::npos);
  CHECK(page.find("3 gates passed, 1 failed, 1 skipped; 1 study broke down.") != std::string::npos);
  // Of the overview, as it is read: passed, failed, skipped.
  const auto line = page.find("<td>failed</td>");
  REQUIRE(line != std::string::npos);
  std::string numbers = page.substr(line, page.find("x is 0.5.", line) - line);
  numbers = std::regex_replace(numbers, std::regex("<[^>]*>"), " ");
  CHECK(std::regex_match(numbers, std::regex(" *failed +3 +1 +1 *")));
  CHECK(page.find("Skipped here: an engine.") != std::string::npos);
  CHECK(page.find("<a href=\"#study-toy\">All about x</a>") < page.find("<h2 id=\"study-toy\">All about x "));
  CHECK(page.find("How this page was made</h2>") > page.find("<h2 id=\"study-toy\">"));
  CHECK(page.find("calm &lt;b&gt;") != std::string::npos);
  CHECK(page.find("beyond") < page.find("near its bound"));
  CHECK(page.find("near its bound") < page.find("calm"));
  CHECK(page.find("Broke down:</strong> x broke") != std::string::npos);
  CHECK(page.find("Printed wrongly.") != std::string::npos);
  const auto json = report_json(outcomes, {{"version", "Ricochet 1"}});
  CHECK(json["schema"] == "ricochet/report/1");
  CHECK(json["counts"] == console::Json{{"passed", 3}, {"failed", 1}, {"skipped", 1}});
  CHECK(json["studies"][0]["skipped"] == console::Json{"an engine"});
  CHECK(json["gates"].size() == 4);
  CHECK(json["studies"][1]["error"] == "x broke");
}

TEST_CASE("how much of its room a gate's value takes") {
  CHECK(room_taken(at_most("", 1, 4)) == 0.25);
  CHECK(room_taken(at_least("", 4, 1)) == 0.25);
  CHECK(room_taken(between("", 2.5, 1, 3)) == 0.5);
  CHECK(room_taken(at_most("", 2, 1)) == 2);
  CHECK_FALSE(room_taken(holds("", true)));
  CHECK_FALSE(room_taken(at_most("", std::nan(""), 1)));
}
