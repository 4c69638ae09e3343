#include "../console/temporary_folder.hpp"
#include "conformance_cases.hpp"

#include "../../verify/conformance/badge.hpp"
#include "../../verify/conformance/causes.hpp"
#include "../../verify/conformance/curves.hpp"
#include "../../verify/conformance/groups.hpp"
#include "../../verify/conformance/half_step.hpp"
#include "../../verify/conformance/matrix.hpp"
#include "../../verify/conformance/page.hpp"
#include "../../verify/conformance/ricochet_run.hpp"
#include "../../verify/conformance/show.hpp"

#include <verify/conformance.hpp>
#include <verify/program.hpp>

#include <console/json.hpp>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace ricochet;
using namespace ricochet::verify;
using namespace ricochet::verify::conformance;

namespace {

const std::string stored = RICOCHET_SOURCE_DIR "/data/conformance";

EngineGrade grades_of(const Results& results) {
  static const std::vector<Answered> all = answered(all_cases());
  EngineGrade engine{results, {}};
  for (const Answered& one : all) engine.cases.push_back(explained(one, results.find(one.of.name)));
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
  const std::string goldens = RICOCHET_SOURCE_DIR "/tests/verify/golden/";
  for (const auto& entry : std::filesystem::directory_iterator(stored)) {
    if (entry.path().extension() != ".csv") continue;
    const std::string name = entry.path().stem().string();
    INFO(name);
    const std::string text = lines_of(grades_of(read_results(entry.path().string(), all_cases())));
    const std::string golden = goldens + name + ".txt";
    if (std::getenv("RICOCHET_UPDATE_DOCS")) std::ofstream(golden) << text;  // as for the documents
    CHECK(text == read_file(golden));
    ++engines;
  }
  using Files = std::filesystem::directory_iterator;
  CHECK(engines == static_cast<std::size_t>(std::distance(Files(goldens), Files())));
}

TEST_CASE("conformance: short words for a grade") {
  const Answered a = answered_case("wall-elastic");
  const auto of = [&](const auto& error) {
    const CaseResult result = off_by(a, a.of.steps, error);
    const CaseGrade g = explained(a, &result);
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
  const console::Table counts = engine_table(engines), beside = side_by_side(engines), all = grade_table(engines);
  CHECK(counts.rows().size() == 2);
  CHECK(beside.rows().size() == all_cases().size());
  CHECK(beside.columns().size() == 3);
  CHECK(beside.columns()[2].name == "2");
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

TEST_CASE("conformance: a grade says the orders that were to be expected") {
  const EngineGrade yade = grades_of(read_results(stored + "/yade-2023.02a.csv", all_cases()));
  const console::Table table = grade_table({yade});
  const auto column = [&](const char* name) {
    std::size_t k = 0;
    while (table.columns().at(k).name != name) ++k;
    return k;
  };
  const console::Json cases = to_json(yade)["cases"];
  // Tsuji's force begins like ζ^(1/4) ζ', Kuwabara and Kono's like ζ^(1/2) ζ'.
  for (const auto& [name, located, said] : {std::tuple("normal-linear-force", 2.0, "1 or 2"),
                                            {"normal-tsuji-force", 1.25, "1 or 1.25"},
                                            {"normal-kuwabara-kono-force", 1.5, "1 or 1.5"}}) {
    CAPTURE(name);
    std::size_t row = 0;
    while (std::get<std::string>(table.rows().at(row)[column("case")]) != name) ++row;
    CHECK(std::get<std::string>(table.rows()[row][column("order_expected")]) == said);
    CHECK(cases.at(row).at("case") == name);
    CHECK(cases.at(row).at("expected_order") == console::Json{{"leapfrog", 1.0}, {"located", located}});
  }
}

namespace {

/// "#rrggbb" of the badge's right half.
std::array<int, 3> colour_of(const EngineGrade& engine) {
  const std::string svg = badge(engine), before = "height=\"22\" fill=\"#";
  const std::size_t at = svg.find(before, svg.find("333333")) + before.size();
  std::array<int, 3> parts{};
  for (std::size_t i = 0; i < 3; ++i) parts[i] = std::stoi(svg.substr(at + 2 * i, 2), nullptr, 16);
  return parts;
}

/// An engine of which so many cases are right, wrong and not run.
EngineGrade made_of(std::size_t right, std::size_t wrong, std::size_t not_run) {
  EngineGrade engine{{"E", "1", "", ""}, {}};
  for (const auto& [count, verdict] : {std::pair(right, Verdict::converges), std::pair(wrong, Verdict::elsewhere),
                                       std::pair(not_run, Verdict::not_run)})
    for (std::size_t i = 0; i < count; ++i) engine.cases.push_back({.verdict = verdict});
  return engine;
}

double distance(std::array<int, 3> a, std::array<int, 3> b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

TEST_CASE("conformance: the badge counts what was run") {
  const EngineGrade yade = grades_of(read_results(stored + "/yade-2023.02a.csv", all_cases()));
  CHECK(file_stem(yade.results) == "yade-2023-02a");
  CHECK(has(badge(yade), fmt::format("Yade 2023.02a: {} of {} right, {} not run", yade.right(), yade.run(),
                                     yade.count(Verdict::not_run))));
  CHECK(yade.run() + yade.count(Verdict::not_run) == yade.cases.size());
  CHECK(has(badge(made_of(50, 0, 0)), "E 1: 50 of 50 right<"));
  // Steps that are too coarse tell nothing.
  EngineGrade coarse = made_of(3, 0, 0);
  coarse.cases.front().verdict = Verdict::too_coarse;
  CHECK(has(badge(coarse), "2 of 2 right, 1 not run"));
  // An engine's name is text.
  EngineGrade odd{{"<b>", "1&2", "", ""}, {}};
  CHECK(has(badge(odd), "&lt;b&gt; 1&amp;2"));
}

TEST_CASE("conformance: the badge's colour is by the share that is right and by how much was run") {
  const auto blue = colour_of(made_of(50, 0, 0)), orange = colour_of(made_of(0, 50, 0)),
             gray = colour_of(made_of(0, 0, 50));
  CHECK(blue == std::array{0x56, 0xb4, 0xe9});
  CHECK(orange == std::array{0xe6, 0x9f, 0x00});
  CHECK(gray == std::array{0xdd, 0xdd, 0xdd});
  CHECK(colour_of({{"E", "1", "", ""}, {}}) == gray);
  // Right in all three that it ran of 50 is nearly gray, and the more was run the bluer it is.
  double before = 0;
  for (const std::size_t ran : {3, 10, 25, 40}) {
    const auto colour = colour_of(made_of(ran, 0, 50 - ran));
    CHECK(distance(colour, gray) > before);
    CHECK(distance(colour, gray) == Approx(static_cast<double>(ran) / 50 * distance(blue, gray)).margin(2));
    before = distance(colour, gray);
  }
  for (const std::size_t right : {10, 25, 40})
    CHECK(distance(colour_of(made_of(right, 50 - right, 0)), orange) ==
          Approx(static_cast<double>(right) / 50 * distance(blue, orange)).margin(2));
}

TEST_CASE("conformance: the page says what is right, what is not and why, and where the cases are from") {
  std::vector<EngineGrade> engines;
  for (const char* name : {"yade-2023.02a", "lammps-29Sep2021", "yade-2025.2.0"})
    engines.push_back(grades_of(read_results(stored + "/" + name + ".csv", all_cases())));
  const EngineGrade& yade = engines.front();
  const std::string page = conformance_page(engines, {{"version", "Ricochet 0"}});
  CHECK(has(page, fmt::format("{} of the {} cases that it ran converge", yade.right(), yade.run())));
  CHECK(has(page, "All that was run is right in: torsion, floor"));
  CHECK(has(page,
            "<dt><span class=\"sign wander\">✗ no limit</span>does not converge</dt><dd>the values do not settle, "
            "and u is above 1 %</dd>"));
  for (const Case& c : all_cases()) CHECK(has(page, ">" + c.name + "<"));
  CHECK_FALSE(has(page, "http-equiv"));
  CHECK(has(page, "<img src=\"data:image/svg+xml"));
  const auto count = [&](const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) ++n;
    return n;
  };
  // One cell an engine and case, in the colour of its verdict.
  std::size_t cells = 0;
  const std::pair<Verdict, const char*> colours[] = {
      {Verdict::exact, "exact"},       {Verdict::converges, "right"}, {Verdict::too_coarse, "coarse"},
      {Verdict::another_rule, "rule"}, {Verdict::elsewhere, "else"},  {Verdict::does_not_converge, "wander"},
      {Verdict::not_run, "not-run"}};
  REQUIRE(std::size(colours) == std::size(verdicts));
  for (const auto& [v, colour] : colours) {
    std::size_t graded = 0;
    for (const EngineGrade& e : engines) graded += e.count(v);
    CHECK(count(fmt::format("<td class=\"{}\"", colour)) == graded);
    CHECK(has(page, fmt::format("<span class=\"sign {}\">", colour)));
    cells += graded;
  }
  CHECK(cells == 3 * all_cases().size());
  // Versions of which all that is shown is the same have a section together, and each cause is told once for both.
  CHECK(count("<h2 id=\"engine-yade") == 1);
  CHECK(has(page, ">Yade 2023.02a, 2025.2.0</h2>"));
  CHECK(has(page, "<span id=\"engine-yade-2025-2-0\"></span>"));
  CHECK(count("<th scope=\"row\" class=\"wide\">contacts end by force: attraction is clipped") == 1);
  CHECK(count(">ViscElPhys has no torsion<") == 1);
}

TEST_CASE("conformance: what is said of 100 steps was run with 100 steps") {
  const Answered a = answered_case("wall-elastic");
  const auto page_of = [&](const std::vector<int>& steps) {
    const CaseResult runs = off_by(a, steps, [](int n) { return 0.7 / n; });
    return conformance_page({EngineGrade{{"E", "1", "", ""}, {explained(a, &runs)}}}, {{"version", "Ricochet 0"}});
  };
  CHECK(has(page_of({25, 50, 100, 200}), "At 100 steps a collision, what converges is off by 0.7 % of its scale"));
  for (const std::vector<int>& steps : {std::vector{10, 20, 40, 80}, {1000, 2000, 4000, 8000}, {20, 60, 180, 540}})
    CHECK_FALSE(has(page_of(steps), "At 100 steps"));
}

TEST_CASE("conformance: the curves are of the greatest error of a family's cases at each step") {
  const Case straight{.name = "a", .family = "normal"}, other{.name = "b", .family = "normal"},
      slanted{.name = "c", .family = "oblique"}, spinning{.name = "d", .family = "torsion"};
  const auto graded = [](const Case& of, const std::vector<double>& steps, const std::vector<double>& error) {
    Graded g;
    g.steps_in_scale = steps, g.error = error;
    return CaseGrade{.of = &of, .verdict = Verdict::converges, .answers = {g}};
  };
  EngineGrade one{{"First", "1_0", "", ""}, {}}, two{{"Second", "2", "", ""}, {}};
  one.cases = {graded(straight, {10, 20}, {0.1, -0.03}), graded(other, {10, 20, 40}, {-0.2, 0.02, 0.0125}),
               graded(slanted, {25, 50}, {0.5, 0}), graded(spinning, {10}, {9})};
  two.cases = {graded(straight, {10, 20}, {0.4, 0.3})};
  const auto figure = error_curves({{&one}, {&two}});
  REQUIRE(figure);
  REQUIRE(figure->data.size() == 1);
  // An error of 0 has no place on a logarithmic axis.
  CHECK(figure->data[0].bytes == "steps,error\n10,0.2\n20,0.03\n40,0.0125\n10,0.4\n20,0.3\n25,0.5\n");
  CHECK(figure->finding ==
        "Family normal: First 1_0 1.2 % at 40; Second 2 30 % at 20. Family oblique: First 1_0 50 % at 25.");
  const auto& panels = figure->plot.panels;
  REQUIRE(panels.size() == 2);
  REQUIRE(panels[0].curves.size() == 2);
  REQUIRE(panels[1].curves.size() == 1);
  const auto check_rows = [](const console::Curve& curve, std::size_t first, std::size_t last) {
    CHECK(curve.rows.value().first == first);
    CHECK(curve.rows.value().last == last);
  };
  check_rows(panels[0].curves[0], 0, 2);
  check_rows(panels[0].curves[1], 3, 4);
  check_rows(panels[1].curves[0], 5, 5);
  CHECK(panels[0].curves[0].title == "First 1 0");
  EngineGrade none{{"None", "1", "", ""}, {}};
  none.cases = {graded(spinning, {10}, {9})};
  CHECK_FALSE(error_curves({{&none}}));
}

TEST_CASE("conformance: engines are put together by all that is shown of them") {
  const Results results = read_results(stored + "/yade-2023.02a.csv", all_cases());
  std::vector<EngineGrade> engines{grades_of(results), grades_of(results), grades_of(results)};
  engines[1].results.version = "2";
  engines[2].results.engine = "Other";
  CHECK(grouped(engines).size() == 1);
  CHECK(labels(grouped(engines).front()) == "Yade 2023.02a, 2; Other 2023.02a");
  for (Graded& g : engines[1].cases[0].answers) g.error[0] *= 2;
  REQUIRE(grouped(engines).size() == 2);
  CHECK(grouped(engines)[0].size() == 2);
  // A reason is one only where it is of the same cases.
  const auto why = reasons(engines, {Verdict::not_run});
  CHECK(std::all_of(why.begin(), why.end(), [](const Reason& r) { return r.engines.size() == 3; }));
  CHECK(why.size() == 8);
}

TEST_CASE("conformance: what the printed digits leave open is said, and is no difference") {
  const Answered a = answered_case("normal-linear-force");
  const TemporaryFolder folder;
  /// As an engine would print runs that are off by `by` of the scale.
  const auto printed = [&](const char* format, double by) {
    const CaseResult exact = off_by(a, a.of.steps, [&](int) { return by; });
    std::string rows = "# engine: E\n# version: 1\ncase,steps,body,x,y,z,vx,vy,vz,wx,wy,wz\n";
    for (const Run& run : exact.runs)
      for (std::size_t i = 0; i < run.bodies.size(); ++i) {
        const auto number = [&](double v) { return fmt::format(fmt::runtime(format), v); };
        const Body& b = run.bodies[i];
        rows += fmt::format("{},{},{},{},0,0,{},0,0,0,0,0\n", a.of.name, run.steps, i + 1, number(b.position.x),
                            number(b.velocity.x));
      }
    std::ofstream(folder / "e.csv") << rows;
    const Results results = read_results(folder / "e.csv", {a.of});
    return explained(a, &results.cases[0]);
  };
  CHECK(printed("{:.17g}", 0).verdict == Verdict::exact);
  CHECK(printed("{:.17g}", 2e-6).verdict == Verdict::elsewhere);
  CHECK(why(printed("{:.17g}", 2e-6)) == "no known cause fits");
  // Six digits of v are 5e-7 m/s or less, 1e-6 of 0.5 m/s; those of x, 5e-9 m, are flown in 2e-4 of the collision.
  const CaseGrade six = printed("{:.6g}", 0);
  CHECK(six.verdict == Verdict::exact);
  CHECK(has(why(six), "the digits printed leave 0.0"));
  CHECK(printed("{:.6g}", 2e-6).verdict <= Verdict::converges);
  CHECK(printed("{:.6g}", 2e-3).verdict == Verdict::elsewhere);
  // Digits that leave more than 1 % open tell nothing.
  CHECK(printed("{:.2g}", 0).verdict == Verdict::too_coarse);
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
  // Whatever runs there are beside, few or enough.
  const Answered fine = answered_case("wall-elastic");
  for (const std::size_t count : {std::size_t(3), fine.of.steps.size()}) {
    CaseResult some =
        off_by(fine, {fine.of.steps.begin(), fine.of.steps.begin() + std::ptrdiff_t(count)}, [](int) { return 0.0; });
    some.note = "Failed: at 900 steps";
    std::ofstream(folder / "partly.csv") << results_text({"E", "1", "", "", {some}});
    const Ran partly = run({"--results", folder / "partly.csv", "--format", "json"});
    CHECK(partly.code == 1);
    CHECK(has(partly.out, "E 1: wall-elastic: runs (Failed: at 900 steps"));
  }
  // What is right because its runs were repeated passes by how far they are off the steps repeated here.
  const Answered falls = answered_case("dem01-fall");
  CaseResult few{falls.of.name};
  for (const int steps : {50, 100, 200, 400}) {
    few.runs.push_back(half_step_run(falls.of, steps, Velocities::at_steps).value());
    few.runs.back().bodies[0].position.x += 1e-9 * falls.answers[0].scale;
  }
  std::ofstream(folder / "few.csv") << results_text({"E", "1", "", "", {few}});
  const Ran repeated = run({"--results", folder / "few.csv", "--format", "json"});
  CHECK(repeated.code == 0);
  const console::Json gates = console::Json::parse(repeated.out)["gates"];
  const console::Json& last = gates.back();
  CHECK(last["name"] == "E 1: dem01-fall: off steps of what was asked, repeated here, share of scale");
  CHECK(double(last["value"]) == Approx(1e-9).epsilon(0.01));
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
