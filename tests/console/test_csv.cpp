#include "temporary_folder.hpp"

#include "../../console/src/place.hpp"

#include <catch2/catch.hpp>
#include <console/csv.hpp>
#include <console/exit.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace ricochet::console;

namespace {

constexpr std::array four{CsvColumn{"a"}, CsvColumn{"b"}, CsvColumn{"c"}, CsvColumn{"d"}};
constexpr std::array speeds{CsvColumn{"velocity", "m/s", true}, CsvColumn{"en", "", true}, CsvColumn{"tcol", "s"}};

/// The fields of a row under a head of as many columns.
std::vector<std::string> fields_of(const std::string& line, const std::string& head = "a,b") {
  std::array<std::string_view, 4> fields;
  try {
    CsvColumns("f", {head, 1}, four).split(line, fields);
  } catch (const BadInput& error) {
    return {error.what()};
  }
  return {fields.begin(), fields.begin() + 1 + std::count(head.begin(), head.end(), ',')};
}

std::string complaint_of(const std::string& head) {
  try {
    CsvColumns("f.csv", {head, 3}, speeds);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "none";
}

/// What a file of these bytes tells of velocity and tcol.
std::vector<double> numbers_in(const std::string& bytes) {
  const TemporaryFolder folder;
  std::ofstream(folder / "f", std::ios::binary) << bytes;
  CsvReader file(folder / "f", speeds);
  std::vector<double> numbers;
  while (file.next()) {
    numbers.push_back(file.number(0));
    if (file.has(2)) numbers.push_back(file.number(2));
  }
  return numbers;
}

}  // namespace

TEST_CASE("a line of CSV falls into its fields") {
  using Fields = std::vector<std::string>;
  CHECK(fields_of("a,b") == Fields{"a", "b"});
  CHECK(fields_of(" a\t, \"b, c\" ,", "a,b,c") == Fields{"a", "b, c", ""});
  CHECK(fields_of("", "a") == Fields{""});
  CHECK(fields_of("\"\",x") == Fields{"", "x"});
  CHECK(fields_of("a,b,c,d", "a,b,c,d") == Fields{"a", "b", "c", "d"});
  CHECK(fields_of("1,2", "b,a") == Fields{"2", "1"});
  CHECK(fields_of("a,b,c") == Fields{"fields = 3: must be 2, one a column"});
  CHECK(fields_of("a,\"b") == Fields{"row = a,\"b: must be a row of CSV"});
  CHECK(fields_of("\"a\"b,c") == Fields{"row = \"a\"b,c: must be a row of CSV"});
  CHECK(fields_of("\"") == Fields{"row = \": must be a row of CSV"});
  CHECK(fields_of(std::string(CsvColumns::most, ',')).front().ends_with("must be a row of CSV"));
  CHECK(is_csv_remark(" \t"));
  CHECK(is_csv_remark("# x"));
  CHECK(is_csv_remark(" ;;;"));
  CHECK(is_csv_remark(","));
  CHECK(is_csv_remark("sep=;"));
  CHECK_FALSE(is_csv_remark(";# x"));
  CHECK_FALSE(is_csv_remark("sep=;e"));
  CHECK_FALSE(is_csv_remark("x"));
}

TEST_CASE("files come with commas, semicolons or tabs, decimal commas, marks and line ends of any system") {
  const std::vector<double> expected{0.5, 1e-4, 2, 3e-4};
  CHECK(numbers_in("velocity,en,tcol\n0.5,1,1e-4\n2,1,3e-4") == expected);
  CHECK(numbers_in("velocity;en;tcol\n0,5;1;1e-4\n2;1;0,0003") == expected);
  CHECK(numbers_in("velocity;en;tcol\n0.5;1;1e-4\n2;1;3e-4\n") == expected);
  CHECK(numbers_in("velocity\ten\ttcol\n0,5\t1\t1e-4\n2\t1\t3e-4\n") == expected);
  CHECK(numbers_in("\xef\xbb\xbf# lab\r\n\r\nVelocity (m/s),EN,tcol [s]\r\n0.5,1,1e-4\r\n2,1,3e-4\r\n") == expected);
}

TEST_CASE("units of a head are converted with one rounding") {
  CHECK(numbers_in("velocity [mm/s],en,tcol [us]\n300,1,77.2\n1.1e3,1,0.1\n") ==
        std::vector<double>{0.3, 77.2e-6, 1.1, 1e-7});
  CHECK(numbers_in("velocity (cm/s);en;tcol (µs)\n0,07;1;1E+2\n") == std::vector<double>{0.0007, 1e-4});
}

TEST_CASE("what is wrong with a head is said with file and line") {
  CHECK(complaint_of("velocity,en") == "none");
  CHECK(complaint_of("velocity,en [-]") == "none");
  CHECK(complaint_of("velocity,e") == "f.csv:3: column = e: must be one of velocity [m/s], en, tcol [s]");
  CHECK(complaint_of("velocity [mph],en") == "f.csv:3: column = velocity [mph]: must be in m/s, cm/s or mm/s");
  CHECK(complaint_of("velocity,en [s]") == "f.csv:3: column = en [s]: must be one of velocity [m/s], en, tcol [s]");
  CHECK(complaint_of("velocity,EN,en") == "f.csv:3: column = en: must be given once");
  CHECK(complaint_of("velocity") == "f.csv:3: column en: missing: must be given");
  CHECK(complaint_of("\"velocity") == "f.csv:3: header = \"velocity: must be a row of CSV");
}

TEST_CASE("columns go by other names, and those that nobody asked for are left and told of") {
  constexpr std::array names{CsvColumn{.name = "velocity", .unit = "m/s", .aliases = "v,speed"},
                             CsvColumn{.name = "en", .aliases = "e,COR"}};
  const CsvColumns columns("f", {"No.,Speed (mm/s),cor,remark [x]", 1}, names, Unknown::ignored);
  CHECK(columns.ignored() == std::vector<std::string>{"No.", "remark [x]"});
  std::array<std::string_view, 2> fields;
  columns.split("7,300,0.5,nice", fields);
  CHECK(columns.number(0, fields[0]) == 0.3);
  CHECK(columns.number(1, fields[1]) == 0.5);
  const auto complaint = [&](const std::string& head, Unknown unknown) {
    CHECK_THROWS_WITH(CsvColumns("f", {head, 1}, names, unknown), Catch::Contains("f:1: "));
    try {
      CsvColumns("f", {head, 1}, names, unknown);
    } catch (const BadInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(complaint("v,e,x", Unknown::refused) == "f:1: column = x: must be one of velocity [m/s], en");
  CHECK(complaint("v,speed", Unknown::ignored) == "f:1: column = velocity: must be given once");
  CHECK(complaint("a,b", Unknown::ignored) == "f:1: column = a: must be one of velocity [m/s], en");
  // One heading with something else between its words: the separator is what is wrong.
  CHECK(complaint("v e", Unknown::ignored) ==
        "f:1: header = v e: must be names between commas, semicolons or tabs, of velocity [m/s], en");
  CHECK(complaint("v|e", Unknown::ignored).starts_with("f:1: header = v|e: must be names between commas"));
}

TEST_CASE("what is wrong with a row is said with file and line") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& bytes) {
    std::ofstream(folder / "f", std::ios::binary) << bytes;
    CsvReader file(folder / "f", speeds);
    while (file.next()) file.number(0);
    file.fail("read");
  };
  CHECK_THROWS_WITH(read("velocity,en\n# x\n1\n"), Catch::EndsWith("f:3: fields = 1: must be 2, one a column"));
  CHECK_THROWS_WITH(read("velocity,en\nx,1\n"), Catch::EndsWith("f:2: velocity = x: must be a finite number"));
  CHECK_THROWS_WITH(read("velocity;en\n1.000,5;1\n"),
                    Catch::EndsWith("velocity = 1.000,5: must be a finite number, without separators of thousands"));
  CHECK_THROWS_WITH(read("velocity,en\n,1\n"), Catch::EndsWith("f:2: velocity = nothing: must be a finite number"));
  CHECK_THROWS_WITH(read("velocity,en\n1,1\n"), Catch::EndsWith("f:3: read"));
  CHECK_THROWS_WITH(read(""), Catch::EndsWith("f:1: read"));
}

TEST_CASE("a file has one decimal sign: what may mean thousands is refused by name") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& bytes) {
    std::ofstream(folder / "f", std::ios::binary) << bytes;
    CsvReader file(folder / "f", speeds);
    std::vector<double> all;
    while (file.next()) all.push_back(file.number(0));
    return all;
  };
  // "1.234" means 1234 where others have a decimal comma, before it or behind it.
  CHECK_THROWS_WITH(read("velocity;en\n0,5;0,7\n1.234;0,5\n"),
                    Catch::EndsWith("f:3: velocity = 1.234: must be a finite number, with a decimal comma as the "
                                    "file's other numbers"));
  CHECK_THROWS_WITH(read("velocity;en\n1.234;0,5\n"), Catch::Contains("f:2: velocity = 1.234"));
  CHECK_THROWS_WITH(read("velocity\ten\n0.5\t1\n1,234\t1\n"),
                    Catch::EndsWith("with a decimal point as the file's other numbers"));
  CHECK_THROWS_WITH(read("velocity;en\n1,234.5;1\n"), Catch::EndsWith("without separators of thousands"));
  CHECK_THROWS_WITH(read("velocity;en\n1.234.567;0,5\n"), Catch::EndsWith("as the file's other numbers"));
  CHECK_THROWS_WITH(read("velocity,en\n\"1,234.5\",1\n"), Catch::EndsWith("without separators of thousands"));
  // One sign throughout is that of decimals.
  CHECK(read("velocity;en\n1,234;0,5\n2;1\n") == std::vector{1.234, 2.0});
  CHECK(read("velocity;en\n1.234;0.5\n12;1\n") == std::vector{1.234, 12.0});
  CHECK(read("tcol;velocity;en\n1;1,5;1\n2;1,25;1\n") == std::vector{1.5, 1.25});
}

TEST_CASE("of columns of one name a file has that of its unit") {
  constexpr std::array<CsvColumn, 2> names{CsvColumn{.name = "stiffness", .unit = "kg/s^2"},
                                           CsvColumn{.name = "stiffness", .unit = "kg/(s^2 m^(1/2))"}};
  const auto has = [&](const std::string& head) {
    const CsvColumns columns("f", {head, 1}, names);
    return std::pair(columns.has(0), columns.has(1));
  };
  CHECK(has("stiffness") == std::pair(true, false));
  CHECK(has("stiffness [kN/m]") == std::pair(true, false));
  CHECK(has("stiffness [MN/m^1.5]") == std::pair(false, true));
  CHECK_THROWS_WITH(has("stiffness [N/m],stiffness [N/m^1.5]"), Catch::Contains("must be given once"));
  CHECK_THROWS_WITH(has("stiffness [Pa]"), Catch::EndsWith("column = stiffness [Pa]: must be in kg/s^2, N/m, N/mm, "
                                                           "kN/m or MN/m; or in kg/(s^2 m^(1/2)), N/m^1.5, kN/m^1.5, "
                                                           "MN/m^1.5 or GN/m^1.5"));
}

TEST_CASE("a file comes in blocks of whole lines, whatever the block size") {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 200; ++i) text += std::string(static_cast<std::size_t>(i % 17), 'x') + (i % 3 ? "\n" : "\r\n");
  text += "last";
  std::ofstream(folder / "f", std::ios::binary) << text;
  for (const std::size_t size : {1, 5, 64, 100000}) {
    LineBlocks source(folder / "f", size);
    CHECK(source.size() == text.size());
    LineBlocks::Block block;
    std::string all;
    std::size_t line = 1;
    while (source.next(block)) {
      CHECK(block.first_line == line);
      all += block.text;
      for (std::string_view rest = block.text; !rest.empty(); ++line)
        CHECK(take_line(rest).find('\r') == std::string_view::npos);
    }
    CHECK(all == text);
    CHECK(line == 202);
  }
}

TEST_CASE("what is not a file of lines is refused") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(LineBlocks(folder / "none"), BadInput);
  std::ofstream(folder / "long") << "a\n" << std::string(3 * LineBlocks::longest_line, 'x');
  LineBlocks source(folder / "long");
  LineBlocks::Block block;
  const auto drain = [&] {
    while (source.next(block)) {
    }
  };
  CHECK_THROWS_WITH(drain(), Catch::Contains("long:2: line of more than 1048576 bytes"));
  CHECK_THROWS_WITH(LineBlocks(folder / ""), Catch::EndsWith("cannot be read: is a directory"));
}

TEST_CASE("the place of a value in JSON is found behind strings that hold quotes and brackets") {
  const std::string text = "{\"a\": \"x\\\"y]}\",\n \"b\": [1, {\"c\": 2}]}";
  const auto place = [&](const char* path) { return line_and_column(text, place_of(text, path)); };
  CHECK(place("/a") == "1:7");
  CHECK(place("/b") == "2:7");
  CHECK(place("/b/0") == "2:8");
  CHECK(place("/b/1/c") == "2:17");
  CHECK(place("/b/1/d") == "2:11");  // as far as it leads
}
