#include "command_line.hpp"

#include <console/manual.hpp>
#include <console/number.hpp>
#include <console/output.hpp>
#include <console/program.hpp>

#include <ricochet/version.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <string_view>
#include <system_error>

namespace ricochet::console {

namespace {

const std::map<std::string, Format> formats{{"table", Format::table}, {"json", Format::json},
                                            {"csv", Format::csv},     {"markdown", Format::markdown},
                                            {"latex", Format::latex}, {"junit", Format::junit}};

bool has_flag(const CLI::App& app, const std::string& flag) {
  if (app.get_option_no_throw(flag)) return true;
  const auto chosen = app.get_subcommands();
  return std::any_of(chosen.begin(), chosen.end(), [&](const CLI::App* sub) { return has_flag(*sub, flag); });
}

/// "mass_eff = -1: must be …", as the library says it, becomes "--mass-eff = -1: …" where there is such an option.
std::string in_flags(const CLI::App& app, const std::string& message) {
  const auto end = message.find(" = ");
  if (end == std::string::npos) return message;
  std::string flag = "--" + message.substr(0, end);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return has_flag(app, flag) ? flag + message.substr(end) : message;
}

/// A standard descriptor that is closed would be given to the next file that is opened, and complaints would land in
/// it. Reading the one that takes its place finds nothing, and writing to it fails as before.
void occupy_standard_descriptors() {
  int file = 0;
  while ((file = ::open("/dev/null", O_RDONLY)) >= 0 && file <= STDERR_FILENO) {
  }
  if (file >= 0) ::close(file);
}

/// An option that was given without a text is a slip, not an option left out.
void require_texts(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& text :
         option->count() > 0 && option->get_items_expected_max() > 0 ? option->results() : std::vector<std::string>{})
      if (text.empty()) throw BadInput(fmt::format("{} = '': must not be empty", option->get_name()));
  for (const CLI::App* command : app.get_subcommands()) require_texts(*command);
}

/// What packages ask a program for, in words that --help leaves out: --man-page, and --completion SHELL. False for any
/// other command line.
bool describes_itself(const CLI::App& app, int argc, const char* const* argv) {
  const std::string_view asked = argc > 1 ? argv[1] : "";
  if (asked == "--man-page" && argc == 2) {
    write_stdout(man_page(app));
    return true;
  }
  if (asked != "--completion") return false;
  const std::string shell = argc == 3 ? argv[2] : "";
  const auto text = completion(app, shell);
  if (!text) throw BadInput("--completion", shell.empty() ? "''" : shell, "bash, zsh or fish");
  write_stdout(*text);
  return true;
}

Exit parse_and_run(CLI::App& app, int argc, const char* const* argv, const std::function<Exit()>& body) {
  if (describes_itself(app, argc, argv)) return Exit::done;
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    write_stdout(app.help());
    return Exit::done;
  } catch (const CLI::CallForVersion& version) {
    write_stdout(fmt::format("{}\n", version.what()));
    return Exit::done;
  } catch (const CLI::ParseError& error) {
    throw BadInput(told(app, error));
  }
  require_texts(app);
  const Exit result = body();
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) throw Failed("standard output: cannot write");
  return result;
}

template <class Target>
CLI::Option* add_any_number(CLI::App& app, const std::string& name, Target& target, const std::string& description) {
  const auto read = [&target, name](const std::string& text) {
    const auto value = parse_number(text);
    // CLI11 turns a thrown ParseError into its own way out, which run_program reports.
    if (!value) throw CLI::ValidationError(fmt::format("{} = {}: must be a finite number", name, text));
    target = *value;
  };
  return app.add_option_function<std::string>(name, read, description)->type_name("NUMBER");
}

}  // namespace

void add_output_options(CLI::App& app, OutputOptions& options, bool reports) {
  const std::string accepted = reports ? "json, csv, markdown, latex or junit" : "json, csv or markdown";
  const auto read = [&options, reports, accepted](const std::string& name) {
    const auto found = formats.find(name);
    const bool known = found != formats.end();
    if (!known || (!reports && (found->second == Format::latex || found->second == Format::junit)))
      throw CLI::ValidationError(fmt::format("--format = {}: must be table, {}", name, accepted));
    options.format = found->second;
  };
  app.add_option_function<std::string>("--format", read, "table (default), " + accepted)->type_name("FORMAT");
  app.add_option("-o,--output", options.file, "write to this file, whole or not at all")->type_name("FILE");
}

void add_version(CLI::App& app) {
  app.set_version_flag("--version", fmt::format("{} {}", app.get_name(), ricochet::version),
                       "print the version and exit");
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const std::string& description) {
  return add_any_number(app, name, target, description);
}

CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        const std::string& description) {
  return add_any_number(app, name, target, description);
}

CLI::Option* add_count(CLI::App& app, const std::string& name, std::optional<unsigned>& target, unsigned greatest,
                       const std::string& description) {
  const auto read = [&target, name, greatest](const std::string& text) {
    const auto value = parse_number(text);
    if (!value || *value < 1 || *value > greatest || *value != std::floor(*value))
      throw CLI::ValidationError(fmt::format("{} = {}: must be a whole number from 1 to {}", name, text, greatest));
    target = static_cast<unsigned>(*value);
  };
  return app.add_option_function<std::string>(name, read, description)->type_name("INT");
}

std::string run_as(const std::string& program) {
  const char* const script = std::getenv("RICOCHET_RUN_BY");
  return script ? fmt::format("{} {}", shell_word(script), program) : program;
}

std::string shell_word(const std::string& text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%+,-./:=@_";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) c == '\'' ? word += "'\\''" : word += c;
  return word + "'";
}

std::string typed(const std::string& program, int argc, const char* const* argv) {
  std::string line = run_as(program);
  for (int i = 1; i < argc; ++i) line += " " + shell_word(argv[i]);
  return line;
}

int run_program(CLI::App& app, int argc, const char* const* argv, const std::function<Exit()>& body) {
  occupy_standard_descriptors();
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  try {
    return static_cast<int>(parse_and_run(app, argc, argv, body));
  } catch (const std::invalid_argument& error) {
    complain(app.get_name(), in_flags(app, error.what()));
    return static_cast<int>(Exit::bad_input);
  } catch (const std::bad_alloc&) {
    complain(app.get_name(), "out of memory");
  } catch (const std::filesystem::filesystem_error& error) {
    complain(app.get_name(), error.what());
  } catch (const std::system_error& error) {  // of threads alone: std::thread says no more than why
    complain(app.get_name(), fmt::format("cannot start a thread: {}", error.code().message()));
  } catch (const std::exception& error) {
    complain(app.get_name(), error.what());
    return static_cast<int>(exit_code(error));
  } catch (...) {
    complain(app.get_name(), "unknown error");
  }
  return static_cast<int>(Exit::failed);
}

}  // namespace ricochet::console
