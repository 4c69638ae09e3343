#pragma once

#include "../../verify/studies/selection.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace ricochet::verify {

/// What a command line selects of the cases of a study.
inline Selection parsed_selection(std::vector<std::string> arguments) {
  CLI::App app;
  Selection wanted;
  wanted.add_options(app);
  std::reverse(arguments.begin(), arguments.end());
  app.parse(arguments);
  return wanted;
}

}  // namespace ricochet::verify
