#include "temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <console/csv.hpp>
#include <console/exit.hpp>

#include <array>
#include <vector>

using namespace ricochet::console;

namespace {

std::vector<std::string> fields_of(std::string_view line) {
  std::array<std::string_view, 4> fields;
  const auto count = split_csv(line, fields);
  if (!count) return {"refused"};
  return {fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(*count)};
}

}  // namespace

TEST_CASE("a line of CSV falls into its fields") {
  using Fields = std::vector<std::string>;
  CHECK(fields_of("a,b") == Fields{"a", "b"});
  CHECK(fields_of(" a\t, \"b, c\" ,") == Fields{"a", "b, c", ""});
  CHECK(fields_of("") == Fields{""});
  CHECK(fields_of("\"\",x") == Fields{"", "x"});
  CHECK(fields_of("a,b,c,d") == Fields{"a", "b", "c", "d"});
  CHECK(fields_of("a,b,c,d,e") == Fields{"refused"});
  CHECK(fields_of("a,\"b") == Fields{"refused"});
  CHECK(fields_of("\"a\"b,c") == Fields{"refused"});
  CHECK(fields_of("\"") == Fields{"refused"});
  CHECK(is_csv_remark(" \t"));
  CHECK(is_csv_remark("# x"));
  CHECK_FALSE(is_csv_remark("x"));
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
