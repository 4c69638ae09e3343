// Any words as calibrate's command line, one a line of input: a job, or one line that says what is wrong with it.

#include "job.hpp"

#include <console/exit.hpp>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ricochet;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < size; ++i) {
    if (data[i] == '\n')
      words.emplace_back();
    else if (data[i] != 0)
      words.back() += static_cast<char>(data[i]);  // a word of a command line holds no NUL
  }
  std::vector<std::string> reversed(words.rbegin(), words.rend());  // as CLI11 wants them
  CLI::App app("fuzzed", "calibrate");
  calibration::Options options;
  try {
    calibration::add_options(app, options);
    app.parse(reversed);
    const calibration::Job job = calibration::job_of(options);
    const Impact& impact = job.known.impact;
    if (!(std::isfinite(impact.mass_eff) && impact.mass_eff > 0 && std::isfinite(impact.velocity) &&
          impact.velocity > 0))
      throw std::logic_error("a job with an impossible impact");
    if (job.wanted.empty() && job.left_out.empty()) throw std::logic_error("a job without work");
  } catch (const CLI::ParseError&) {
  } catch (const console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
  return 0;
}
