#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

// What the manual page and the completions read of a program's options.
namespace ricochet::console {

inline bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// "-o" and "--output", without what stands beside them.
inline std::vector<std::string> flags_of(const CLI::Option& option) {
  std::vector<std::string> flags;
  for (const std::string& name : option.get_snames()) flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) flags.push_back("--" + name);
  return flags;
}

inline std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// The first sentence, without its full stop.
inline std::string first_line(const std::string& text) {
  std::string line = text.substr(0, text.find('\n'));
  if (!line.empty() && line.back() == '.') line.pop_back();
  return line;
}

}  // namespace ricochet::console
