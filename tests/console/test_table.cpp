#include <console/json.hpp>
#include <console/number.hpp>
#include <console/table.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <locale>

using namespace ricochet::console;

namespace {

Table example() {
  Table table({{"law"}, {"k", "kg/s²", {Notation::Kind::significant, 6}}, {"steps"}}, "Laws");
  table.row({"linear", 5211.519412345678, std::int64_t{30}});
  table.row({"odd, \"quoted\"", blank(), std::int64_t{7}});
  table.note("k: stiffness");
  return table;
}

}  // namespace

TEST_CASE("a table aligns its columns and carries units") {
  CHECK(example().text() ==
        "Laws\n"
        "law                  k  steps\n"
        "               [kg/s²]\n"
        "-------------  -------  -----\n"
        "linear         5211.52     30\n"
        "odd, \"quoted\"        -      7\n"
        "k: stiffness\n");
}

TEST_CASE("a table that is wider than a terminal breaks names first, then texts, and keeps its numbers whole") {
  Table table({{"which of many peers"}, {"a name of several words", "kg/s²"}, {"remark"}},
              std::string(70, 'c') + " " + std::string(60, 'd'));
  const std::string words =
      "far more than a row of a table can hold beside its numbers and names, which is why it is broken";
  table.row({std::string("one that is long"), 1234.5, words});
  table.row({std::string("two"), 1.0, std::string("short")});
  table.note(words + " " + words);
  std::vector<std::string> lines;
  const std::string text = table.text();
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    lines.push_back(text.substr(at, text.find('\n', at) - at));
  for (const std::string& line : lines) CHECK(display_width(line) <= 120);
  CHECK(lines[0] == std::string(70, 'c'));
  CHECK(lines[1] == std::string(60, 'd'));
  // The name goes over three lines before the text is touched, which needs them still.
  CHECK(text.find("one that is long   1234.5  far more") != std::string::npos);
  CHECK(table.csv().find(words) != std::string::npos);
  CHECK(table.markdown().find(words) != std::string::npos);
  CHECK(wrapped("a bb ccc", 4, 2) == std::vector<std::string>{"a bb", "  ccc"});
  CHECK(wrapped("", 4).size() == 1);
}

TEST_CASE("CSV has the unit in the header and full precision") {
  CHECK(example().csv() ==
        "law,k [kg/s²],steps\n"
        "linear,5211.519412345678,30\n"
        "\"odd, \"\"quoted\"\"\",,7\n");
}

TEST_CASE("markdown aligns numbers to the right") {
  CHECK(example().markdown() ==
        "**Laws**\n\n"
        "| law | k [kg/s²] | steps |\n"
        "| --- | ---: | ---: |\n"
        "| linear | 5211.52 | 30 |\n"
        "| odd, \"quoted\" | - | 7 |\n"
        "\nk: stiffness\n");
}

TEST_CASE("LaTeX aligns numbers to the right and words to the left") {
  Table table({{"law"}, {"k", "N/m"}});
  table.row({std::string("linear"), 1.5});
  CHECK(table.latex().find("{lr}") != std::string::npos);
}

TEST_CASE("a table takes no number that is not finite and no ragged row") {
  Table table({{"x"}});
  CHECK_THROWS_AS(table.row({std::nan("")}), std::logic_error);
  CHECK_THROWS_AS(table.row({std::numeric_limits<double>::infinity()}), std::logic_error);
  CHECK_THROWS_AS(table.row({1.0, 2.0}), std::logic_error);
  CHECK(table.rows().empty());
  table.row({number_or_blank(std::nan(""))});
  CHECK(table.csv() == "x\n\n");
}

TEST_CASE("JSON keeps full precision and refuses what is not finite") {
  CHECK(rows_of(example())[0]["k"].get<double>() == 5211.519412345678);
  CHECK(rows_of(example())[1]["k"].is_null());
  CHECK(units_of(example()) == Json{{"k", "kg/s²"}});
  const Json json{{"rows", {{{"x", 0.1}}, {{"x", std::nan("")}}}}};
  CHECK_THROWS_WITH(document(json), "JSON /rows/1/x is not a finite number");
  CHECK(document(Json{{"x", number_or_null(std::nan(""))}}) == "{\n  \"x\": null\n}\n");
}

TEST_CASE("numbers are read strictly and written shortest") {
  CHECK(parse_number("1e-4") == 1e-4);
  CHECK(parse_number("+0.5") == 0.5);
  CHECK(parse_number("-3") == -3.0);
  for (const char* text : {"", " 1", "1 ", "1,5", "abc", "nan", "inf", "1e999", "+-1", "0x10", "1e", "--1"})
    CHECK_FALSE(parse_number(text));
  CHECK(shortest(0.1) == "0.1");
  CHECK(shortest(1e-4) == "1e-04");
  CHECK(significant(5211.5194, 6) == "5211.52");
  CHECK(fixed(0.5, 3) == "0.500");
  CHECK(fixed(-4e-6, 5) == "0.00000");
  CHECK(fixed(-6e-6, 5) == "-0.00001");
  CHECK(scientific(1e-4, 2) == "1.00e-04");
}
