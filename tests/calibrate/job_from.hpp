#pragma once

#include <job.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <vector>

/// What the program makes of a command line.
inline ricochet::calibration::Job job_from(std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  CLI::App app("tested", "calibrate");
  ricochet::calibration::Options options;
  ricochet::calibration::add_options(app, options);
  app.parse(words);
  return ricochet::calibration::job_of(options);
}
