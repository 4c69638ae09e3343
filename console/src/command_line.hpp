#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace ricochet::console {

/// What CLI11 found wrong with the command line, in our words: the flag, the value, what is accepted.
std::string told(const CLI::App& app, const CLI::ParseError& error);

}  // namespace ricochet::console
