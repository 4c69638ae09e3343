#include "option_names.hpp"

#include <console/manual.hpp>

#include <ricochet/version.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace ricochet::console {

namespace {

/// Text as roff prints it: no line is a request, and a minus is one that can be searched for and copied.
std::string roff(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if ((c == '.' || c == '\'') && (i == 0 || text[i - 1] == '\n'))
      out += fmt::format("\\&{}", c);
    else
      out += c;
  }
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string option_entry(const CLI::Option& option) {
  std::string names;
  for (const std::string& flag : flags_of(option))
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(flag));
  if (names.empty())
    names = fmt::format("\\fI{}\\fR", roff(option.get_name(true)));
  else if (takes_value(option))
    names += fmt::format(" \\fI{}\\fR", roff(option.get_type_name()));
  return fmt::format(".TP\n{}\n{}{}\n", names, roff(option.get_description()),
                     option.get_required() ? " (required)" : "");
}

/// Every option under its group; the group that CLI11 gives by itself comes under `heading`.
std::string options_of(const CLI::App& app, const std::string& heading) {
  std::string text;
  std::vector<std::string> groups;
  for (const CLI::Option* option : app.get_options())
    if (std::find(groups.begin(), groups.end(), option->get_group()) == groups.end())
      groups.push_back(option->get_group());
  for (const std::string& group : groups) {
    if (group.empty()) continue;  // hidden
    text += group == "Options" ? heading : fmt::format(".SS \"{}\"\n", roff(group));
    for (const CLI::Option* option : app.get_options())
      if (option->get_group() == group) text += option_entry(*option);
  }
  return text;
}

std::string synopsis(const CLI::App& app) {
  std::string text = fmt::format("\\fB{}\\fR", app.get_name());
  if (!commands_of(app).empty()) text += " \\fICOMMAND\\fR";
  text += " [\\fIOPTION\\fR]...";
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) text += fmt::format(" \\fI{}\\fR", roff(option->get_name(true)));
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(".TH {} 1 \"\" \"ricochet {}\" \"Ricochet\"\n", upper(app.get_name()), version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", app.get_name(), roff(first_line(app.get_description())));
  text += fmt::format(".SH SYNOPSIS\n{}\n", synopsis(app));
  text += fmt::format(".SH DESCRIPTION\n{}\n", roff(app.get_description()));
  text += options_of(app, ".SH OPTIONS\n");
  const auto commands = commands_of(app);
  if (!commands.empty()) text += ".SH COMMANDS\n";
  for (const CLI::App* command : commands)
    text += fmt::format(".SS \"{}\"\n{}\n{}", roff(command->get_name()), roff(command->get_description()),
                        options_of(*command, ""));
  if (!app.get_footer().empty()) text += fmt::format(".SH NOTES\n{}\n", roff(app.get_footer()));
  return text;
}

}  // namespace ricochet::console
