#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// A command in a ```console block of a Markdown file: "$ command", continued after a backslash, then what it prints
/// (stdout and stderr as they come). "$ echo $?" after it states its exit code, which else is 0. In what is printed "…"
/// stands for anything, a line of "…" alone for any lines.
struct Command {
  std::string text;
  std::size_t first_output;  ///< line numbers in the file, from 0; [first, last)
  std::size_t last_output;
  int exit_code = 0;
};

/// The lines of a file, without their ends.
std::vector<std::string> lines_of(const std::string& text);

/// Commands of all console blocks, in order. Throws std::runtime_error on a malformed block.
std::vector<Command> console_commands(const std::vector<std::string>& lines);

/// Commands of all blocks of shell ("```sh", or of no language), in order, without comments: a line each, as these
/// blocks show no output.
std::vector<Command> shell_commands(const std::vector<std::string>& lines);

/// True when `printed` is what `documented` says.
bool matches(const std::vector<std::string>& documented, const std::vector<std::string>& printed);
