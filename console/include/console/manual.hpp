#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace ricochet::console {

// What a package says of a program beside its --help, from the same options: nothing here is written twice.

/// The manual page of section 1, as man reads it: name, synopsis, every option by its group, every command with its own
/// options, exit codes and what the footer says else.
std::string man_page(const CLI::App& app);

/// Completion of the program's commands, options and their words for "bash", "zsh" or "fish"; nothing for another
/// shell. An option's words are those that its description lists behind a colon; FILE and DIR are completed as paths.
std::optional<std::string> completion(const CLI::App& app, std::string_view shell);

}  // namespace ricochet::console
