#pragma once

#include <console/exit.hpp>
#include <console/table.hpp>

#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ricochet::console {

/// The options that all programs share.
struct OutputOptions {
  Format format = Format::table;
  std::string file = {};  ///< empty: stdout
};

/// Adds --format table|json|csv|markdown, with `reports` also latex|junit, and -o,--output FILE.
void add_output_options(CLI::App& app, OutputOptions& options, bool reports = false);

/// Adds --version, printing "<program> <version>".
void add_version(CLI::App& app);

/// Adds an option that takes one finite number; anything else is "--en = abc: must be a finite number".
/// Independent of the locale. `target` keeps its value when the option is absent.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const std::string& description);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        const std::string& description);

/// Adds an option that takes a whole number from 1 to `greatest`; anything else is "--threads = 0: must be a whole
/// number from 1 to 256".
CLI::Option* add_count(CLI::App& app, const std::string& name, std::optional<unsigned>& target, unsigned greatest,
                       const std::string& description);

/// How this program was run: "./ricochet simulate" where the script did it (it says so in RICOCHET_RUN_BY), else its
/// name.
std::string run_as(const std::string& program);

/// A word of a command line that a POSIX shell reads as this text.
std::string shell_word(const std::string& text);

/// The command line that a POSIX shell reads as this one.
std::string typed(const std::string& program, int argc, const char* const* argv);

/// Parses the command line into `app` and runs `body`. Every way out is an exit code and at most one line
/// "<program>: …" on stderr: a wrong command line is bad input, --help and --version are done, exceptions map as
/// exit_code() says; the library's "mass_eff = -1: must be …" is reported under the flag's name, "--mass-eff = -1".
/// SIGPIPE and SIGXFSZ are ignored, so that a reader who leaves and a file that grows past the limit show as write
/// errors (failed) like a full disk does.
int run_program(CLI::App& app, int argc, const char* const* argv, const std::function<Exit()>& body);

}  // namespace ricochet::console
