#include <verify/document.hpp>

#include <console/html.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <cmath>

namespace ricochet::verify {

std::string junit_suite(const std::string& study, const StudyResult& result) {
  using console::escaped;
  const Counts counts = counts_of(result);
  const auto opened = [&](const std::string& name) {
    return fmt::format("    <testcase classname=\"verify.{}\" name=\"{}\"", escaped(study), escaped(name));
  };
  std::string text = fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n",
                                 escaped(study), result.gates.size() + counts.skipped, counts.failed, counts.skipped);
  for (const Gate& gate : result.gates) {
    const std::string value = std::isfinite(gate.value) ? console::shortest(gate.value) : "not finite";
    text += opened(gate.name) + (gate.pass ? "/>\n"
                                           : fmt::format("><failure message=\"{}: must be {}\"/></testcase>\n", value,
                                                         escaped(bound_text(gate))));
  }
  for (const std::string& what : result.skipped) text += opened(what) + "><skipped/></testcase>\n";
  return text + "  </testsuite>\n";
}

std::string junit_document(const std::string& suites) {
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n{}</testsuites>\n", suites);
}

}  // namespace ricochet::verify
