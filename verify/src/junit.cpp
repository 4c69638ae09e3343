#include <verify/document.hpp>

#include <console/html.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify {

std::string junit_suite(const std::string& study, const std::vector<Gate>& gates) {
  using console::escaped;
  const auto failures = std::count_if(gates.begin(), gates.end(), [](const Gate& gate) { return !gate.pass; });
  std::string text =
      fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n", escaped(study), gates.size(), failures);
  for (const Gate& gate : gates) {
    const std::string value = std::isfinite(gate.value) ? console::shortest(gate.value) : "not finite";
    text += fmt::format("    <testcase classname=\"verify.{}\" name=\"{}\"", escaped(study), escaped(gate.name));
    text += gate.pass
                ? "/>\n"
                : fmt::format("><failure message=\"{}: must be {}\"/></testcase>\n", value, escaped(bound_text(gate)));
  }
  return text + "  </testsuite>\n";
}

std::string junit_document(const std::string& suites) {
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n{}</testsuites>\n", suites);
}

}  // namespace ricochet::verify
