// Any text as what an engine gave for the conformance cases: end states of finite numbers that can be graded, or one
// line that says what is wrong.

#include "../../verify/conformance/causes.hpp"

#include "memory_file.hpp"

#include <console/exit.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

using namespace ricochet;
using namespace ricochet::verify::conformance;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<Case> cases = all_cases();
  static const std::vector<Answered> all = answered(cases);
  const MemoryFile file(data, size);
  try {
    const Results results = read_results(file.path(), cases);
    for (const Answered& one : all) {
      const CaseResult* result = results.find(one.of.name);
      if (!result) continue;
      for (const Run& run : result->runs)
        for (const Body& b : run.bodies)
          if (!std::isfinite(norm(b.position) + norm(b.velocity) + norm(b.spin))) throw std::logic_error("no number");
      const CaseGrade graded = grade(one, result);
      if (graded.verdict != Verdict::not_run && graded.answers.empty()) throw std::logic_error("nothing was graded");
      for (const Graded& g : graded.answers)
        for (const double error : g.error)
          if (!std::isfinite(error + g.limit.value + g.limit.uncertainty))
            throw std::logic_error("an impossible error");
    }
  } catch (const console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
  return 0;
}
