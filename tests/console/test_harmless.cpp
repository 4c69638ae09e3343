#include <console/harmless.hpp>
#include <console/table.hpp>

#include <catch2/catch.hpp>

using namespace ricochet::console;

TEST_CASE("control characters of ASCII and of Latin-1's second set are found, other letters are not") {
  for (const std::string text : {"\x1b[2J", "\x7f", "a\tb", "\x01",
                                 "\xc2\x9b"
                                 "31m",
                                 "\xc2\x80", "\xc2\x9f"}) {
    CAPTURE(text);
    CHECK(has_controls(text));
    CHECK_FALSE(is_harmless(text));
  }
  for (const std::string text : {"", "en", "Stoß α", "\xc2\xa0", "\xc2", "1-2", "a=b"}) {
    CAPTURE(text);
    CHECK_FALSE(has_controls(text));
    CHECK(is_harmless(text));
    CHECK(without_controls(text) == text);
  }
  CHECK(control_length("\xc2\x9b"
                       "31m") == 2);
  CHECK(without_controls("a\x1b[2J\n\xc2\x9b"
                         "b") == "a?[2J??b");
  CHECK(without_controls("a\n\x1b", true) == "a\n?");
}

TEST_CASE("a word that begins like a spreadsheet's formula is not harmless") {
  for (const std::string word : {"=cmd|' /C calc'!A0", "+1", "-x", "@sum"}) CHECK_FALSE(is_harmless(word));
}

TEST_CASE("what a terminal would obey comes out of no table") {
  Table table({{"name"}}, "of \x1b[2J");
  table
      .row({std::string("a\x1b"
                        "b\xc2\x9b"
                        "c")})
      .note("\x07 bell");
  for (const Format format : {Format::table, Format::csv, Format::markdown, Format::latex}) {
    const std::string text = table.render(format);
    CHECK(text.find_first_of("\x1b\x07") == std::string::npos);
    CHECK(text.find("\xc2\x9b") == std::string::npos);
    CHECK(text.find("a?b?c") != std::string::npos);
  }
}
