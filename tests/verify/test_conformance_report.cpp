#include "../console/temporary_folder.hpp"
#include "conformance_cases.hpp"

#include "../../verify/conformance/badge.hpp"
#include "../../verify/conformance/causes.hpp"
#include "../../verify/conformance/page.hpp"
#include "../../verify/conformance/ricochet_run.hpp"
#include "../../verify/conformance/show.hpp"

#include <verify/conformance.hpp>
#include <verify/program.hpp>

#include <console/json.hpp>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

using namespace ricochet;
using namespace ricochet::verify;
using namespace ricochet::verify::conformance;

namespace {

const std::string stored = RICOCHET_SOURCE_DIR "/data/conformance";

EngineGrade grades_of(const Results& results) {
  static const std::vector<Answered> all = answered(all_cases());
  EngineGrade engine{results, {}};
  for (const Answered& one : all) {
    const CaseResult* result = results.find(one.of.name);
    engine.cases.push_back(grade(one, result));
    if (result) engine.cases.back().causes = causes(one, *result, engine.cases.back());
  }
  return engine;
}

/// One line a case: verdict, order or difference, cause.
std::string lines_of(const EngineGrade& engine) {
  std::string text;
  for (const CaseGrade& c : engine.cases)
    text += fmt::format("{} | {} | {} | {}\n", c.of->name, conformance::text(c.verdict), in_short(c), why(c));
  return text;
}

struct Ran {
  int code;
  std::string out;
};

Ran run(std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  Studies checks;
  checks.push_back(conformance_check());
  arguments.insert(arguments.begin(), {"verify", "conformance"});
  arguments.insert(arguments.end(), {"-o", out});
  std::vector<const char*> words;
  words.reserve(arguments.size());
  for (const std::string& a : arguments) words.push_back(a.c_str());
  const int code = run_verify({}, checks, static_cast<int>(words.size()), words.data());
  return {code, code <= 1 ? read_file(out) : ""};
}

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

}  // namespace

TEST_CASE("conformance: our own stepping is right in every case") {
  const EngineGrade ours = grades_of(run_ricochet(all_cases()));
  for (const CaseGrade& c : ours.cases) {
    INFO(c.of->name << ": " << why(c));
    CHECK(c.verdict <= Verdict::converges);
  }
  CHECK(ours.run() == ours.cases.size());
  CHECK(ours.right() == ours.cases.size());
}

TEST_CASE("conformance: the grades of every engine are what they were") {
  std::size_t engines = 0;
  for (const auto& entry : std::filesystem::directory_iterator(stored)) {
    if (entry.path().extension() != ".csv") continue;
    const std::string name = entry.path().stem().string();
    INFO(name);
    const std::string text = lines_of(grades_of(read_results(entry.path().string(), all_cases())));
    const std::string golden = RICOCHET_SOURCE_DIR "/tests/verify/golden/" + name + ".txt";
    if (std::getenv("RICOCHET_UPDATE_DOCS")) std::ofstream(golden) << text;  // as for the documents
    CHECK(text == read_file(golden));
    ++engines;
  }
  CHECK(engines >= 6);
}

TEST_CASE("conformance: short words for a grade") {
  const Answered a = answered_case("wall-elastic");
  const auto of = [&](const auto& error) {
    const CaseResult result = off_by(a, a.of.steps, error);
    CaseGrade g = grade(a, &result);
    g.causes = causes(a, result, g);
    return std::pair(in_short(g), why(g));
  };
  CHECK(of([](int) { return 0.0; }) == std::pair<std::string, std::string>("exact", ""));
  CHECK(of([](int n) { return 1.0 / n; }).first == "order 1.0");
  const auto [off, because] = of([](int) { return 0.05; });
  CHECK(off == "off by 5 %");
  CHECK(because == "no known cause fits; 10 % of the energy too much");
  CHECK(of([](int) { return -0.05; }).second == "no known cause fits; 9.8 % of the energy too little");
  CHECK(of([](int n) { return n == 25 || n == 100 || n == 400 ? 0.1 : 0.3; }).first == "does not converge");
  CaseGrade none{.of = &a.of};
  none.note = "no such law";
  CHECK(in_short(none) == "not run");
  CHECK(why(none) == "no such law");
}

TEST_CASE("conformance: tables and JSON of several engines") {
  const std::vector<EngineGrade> engines{grades_of(read_results(stored + "/lammps-29Sep2021.csv", all_cases())),
                                         grades_of(read_results(stored + "/yade-2023.02a.csv", all_cases()))};
  const console::Table counts = engine_table(engines), beside = side_by_side(engines, Heads::names),
                       all = grade_table(engines);
  CHECK(counts.rows().size() == 2);
  CHECK(beside.rows().size() == all_cases().size());
  CHECK(beside.columns().size() == 3);
  CHECK(beside.columns()[2].name == "Yade 2023.02a");
  CHECK(side_by_side(engines, Heads::numbers).columns()[2].name == "2");
  CHECK(all.rows().size() == 2 * all_cases().size());
  for (const auto& row : counts.rows()) {
    std::int64_t sum = 0;
    for (std::size_t i = 4; i < row.size(); ++i) sum += std::get<std::int64_t>(row[i]);
    CHECK(sum == static_cast<std::int64_t>(all_cases().size()));
  }
  const console::Json json = to_json(engines[1]);
  CHECK(json["engine"] == "Yade");
  CHECK(json["cases"].size() == all_cases().size());
  const auto& overlap = json["cases"][1];
  CHECK(overlap["case"] == "normal-linear-overlap");
  CHECK(overlap["verdict"] == "converges elsewhere");
  CHECK(overlap["causes"][0]["repeated"] == true);
  CHECK(overlap["answers"][0]["errors"].size() == overlap["answers"][0]["steps"].size());
  CHECK(double(overlap["energy"]["limit"]) > double(overlap["energy"]["exact"]));
}

TEST_CASE("conformance: the badge counts what was run") {
  const EngineGrade yade = grades_of(read_results(stored + "/yade-2023.02a.csv", all_cases()));
  CHECK(file_stem(yade.results) == "yade-2023-02a");
  const std::string svg = badge(yade);
  CHECK(has(svg, fmt::format("Yade 2023.02a: {} of {} cases right", yade.right(), yade.run())));
  CHECK(has(svg, "fill=\"#e69f00\""));
  CHECK(yade.run() + yade.count(Verdict::not_run) == yade.cases.size());
  const EngineGrade ours = grades_of(read_results(stored + "/simulate-0.1.0.csv", all_cases()));
  CHECK(ours.right() == ours.run());
  CHECK(has(badge(ours), "fill=\"#56b4e9\""));
  // An engine's name is text.
  EngineGrade odd{{"<b>", "1&2", "", ""}, {}};
  CHECK(has(badge(odd), "&lt;b&gt; 1&amp;2"));
  CHECK(has(badge(odd), "fill=\"#e69f00\""));
}

TEST_CASE("conformance: the page says what is right, what is not and why, and where the cases are from") {
  const EngineGrade yade = grades_of(read_results(stored + "/yade-2023.02a.csv", all_cases()));
  const std::string page = conformance_page({yade}, {{"version", "Ricochet 0"}});
  CHECK(has(page, fmt::format("{} of the {} cases that it ran converge", yade.right(), yade.run())));
  CHECK(has(page, "All that was run is right in: torsion, floor"));
  CHECK(has(page, "attraction is clipped"));
  CHECK(has(page, "<dt>does not converge</dt><dd>the values do not settle, and u is above 1 %</dd>"));
  for (const Case& c : all_cases()) CHECK(has(page, ">" + c.name + "<"));
  CHECK_FALSE(has(page, "http-equiv"));
}

TEST_CASE("verify conformance: what ran nothing or broke down does not pass, and no task is passed over") {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& name, const std::string& rows) {
    std::ofstream(folder / name) << "# engine: E\n# version: 1\ncase,steps,body,x,y,z,vx,vy,vz,wx,wy,wz,note\n" << rows;
    return folder / name;
  };
  const std::string none = "normal-elastic,,,,,,,,,,,,no words for it\n";
  CHECK(run({"--results", file("none.csv", none)}).code == 1);
  CHECK(run({"--results", file("empty.csv", "")}).code == 2);
  const std::string broken = file("broken.csv", none + "normal-linear-force,,,,,,,,,,,,failed: segfault\n");
  const Ran ran = run({"--results", broken, "--format", "json"});
  CHECK(ran.code == 1);
  CHECK(has(ran.out, "E 1: normal-linear-force: runs (failed: segfault)"));
  CHECK(run({"--list", "--results", stored}).code == 2);
  CHECK(run({"--cases", folder / "cases", "--badge", folder / "badges"}).code == 2);
  CHECK(run({"--run", "ricochet", "--report", folder / "page.html"}).code == 2);
  // Two files of one engine have one name between them.
  const std::string again = file("again.csv", none);
  CHECK(run({"--results", broken, again, "--badge", folder / "badges"}).code == 2);
}

TEST_CASE("verify conformance: exit codes and what is written") {
  const TemporaryFolder folder;
  const Ran list = run({"--list", "--format", "csv"});
  CHECK(list.code == 0);
  CHECK(list.out.starts_with("case,family,title,source\nnormal-linear-force,normal,"));
  CHECK(run({"--cases", folder / "cases"}).code == 0);
  CHECK(read_file(folder / "cases/dem05.json").starts_with("{\n  \"schema\": \"ricochet/case/1\""));

  const std::string ours = folder / "ours.csv";
  const Ran own = run({"--run", "ricochet"});
  CHECK(own.code == 0);
  std::ofstream(ours) << own.out;
  CHECK(own.out.starts_with("# engine: Ricochet\n"));
  const Ran right = run({"--results", ours, "--format", "json"});
  CHECK(right.code == 0);
  const auto json = console::Json::parse(right.out);
  CHECK(json["schema"] == "ricochet/conformance/1");
  CHECK(json["counts"]["failed"] == 0);
  CHECK(json["counts"]["passed"] == all_cases().size() + 2);

  // An engine that is off fails; the stored ones are shown beside each other and not judged.
  CHECK(run({"--results", stored + "/yade-2023.02a.csv"}).code == 1);
  CHECK(run({"--results", ours, "--results", stored}).code == 1);
  const Ran compared = run({"--report", folder / "page.html", "--badge", folder / "badges"});
  CHECK(compared.code == 0);
  CHECK(has(compared.out, "Cases by engine"));
  CHECK(has(read_file(folder / "page.html"), "Contact models in engines"));
  CHECK(has(read_file(folder / "badges/liggghts-3-8-0.svg"), "LIGGGHTS 3.8.0"));

  CHECK(run({"--results", ours, "--report", ours}).code == 2);
  CHECK(read_file(ours) == own.out);
  CHECK(run({"--results", folder / "none.csv"}).code == 2);
  CHECK(run({"--run", "lammps"}).code == 2);
  std::filesystem::create_directory(folder / "empty");
  CHECK(run({"--results", folder / "empty"}).code == 2);
  std::ofstream(folder / "empty/bad.csv") << "# engine: a\n# version: b\ncase,note\ndem99,no\n";
  CHECK(run({"--results", folder / "empty"}).code == 2);
}
