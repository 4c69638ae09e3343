#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace ricochet::console {

namespace {

/// The command that was chosen, or the program itself.
const CLI::App& chosen(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

std::string spelled(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent ? fmt::format("{} {}", spelled(*parent), command.get_name()) : command.get_name();
}

std::string commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return fmt::format("{}", fmt::join(names, ", "));
}

/// "--nc: must be …" needs the flag that CLI11's text begins with.
std::string before(const std::string& text, const char* mark) { return text.substr(0, text.find(mark)); }

std::string about_extras(const CLI::App& app) {
  const auto extras = app.remaining(true);
  const std::string first = extras.empty() ? "an argument" : extras.front();
  if (!app.get_subcommands({}).empty() && app.get_subcommands().empty())
    return first.starts_with('-')
               ? fmt::format("option = {}: must be given after a command: {}", first, commands_of(app))
               : fmt::format("command = {}: must be one of {}", first, commands_of(app));
  return fmt::format("{}: not known: must be an option that `{} --help` lists", first, spelled(chosen(app)));
}

std::string about_missing(const CLI::App& app, const std::string& text) {
  const std::string name = before(text, " is required");
  if (name != "A subcommand")
    return fmt::format("{}: missing: must be given; see `{} --help`", name, spelled(chosen(app)));
  if (!app.remaining(true).empty()) return about_extras(app);
  return fmt::format("command: missing: must be one of {}", commands_of(app));
}

std::string about_count(const std::string& text) {
  const std::string flag = before(text, ": ");
  if (text.find("At Most") != std::string::npos)
    return fmt::format("{}: given {} times: must be given once", flag, text.substr(text.rfind(' ') + 1));
  return fmt::format("{}: value missing: must be followed by one", flag);
}

std::string about_conversion(const CLI::App& app, const std::string& text) {
  const std::string mark = "Could not convert: ";
  if (!text.starts_with(mark)) return text;
  const std::string given = text.substr(mark.size());
  const CLI::Option* option = chosen(app).get_option_no_throw(before(given, " = "));
  const std::string type = option ? option->get_type_name() : "";
  const bool whole = type == "N" || type == "INT" || type == "UINT";
  return fmt::format("{}: must be {}", given, whole ? "a whole number" : "a number");
}

}  // namespace

std::string told(const CLI::App& app, const CLI::ParseError& error) {
  std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) return about_extras(app);
  if (dynamic_cast<const CLI::RequiredError*>(&error)) return about_missing(app, text);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return about_count(text);
  if (dynamic_cast<const CLI::ConversionError*>(&error)) return about_conversion(app, text);
  return text;
}

}  // namespace ricochet::console
