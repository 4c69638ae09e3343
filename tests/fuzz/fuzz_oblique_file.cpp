// Any text as a laboratory's file of oblique impacts: measurements whose every number is finite, or one line that says
// what is wrong with it.

#include "arguments.hpp"
#include "memory_file.hpp"
#include "oblique_fit_run.hpp"

#include <console/exit.hpp>

#include <stdexcept>
#include <string>
#include <vector>

using namespace ricochet;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  try {
    if (!calibration::is_oblique(file.path())) return 0;
    std::vector<std::string> ignored;
    for (const calibration::ObliqueMeasurement& m : calibration::read_oblique(file.path(), 1, ignored)) {
      expect_finite({m.normal_velocity, m.tangential_velocity});
      for (const auto& observed : {m.et, m.rebound_angle, m.spin})
        if (observed) expect_finite({observed->value, observed->sigma});
      if (!(m.normal_velocity > 0 && m.tangential_velocity > 0)) throw std::logic_error("an impossible impact");
    }
  } catch (const console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
  return 0;
}
