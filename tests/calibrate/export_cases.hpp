#pragma once

#include <catch2/catch.hpp>

#include <calibrate/export.hpp>

#include <sstream>
#include <string>

// Laws to be exported, and what an engine reads in a snippet.
namespace export_cases {

using namespace ricochet;
using namespace ricochet::calibration;

// The pair of Table II of the paper: two spheres, r = 1.5 mm, 1000 kg/m³.
inline constexpr double radius_eff = 0.75e-3, mass_eff = 7.06858e-6;

inline ExportCase with(AnyLaw law, ContactEnd end) {
  return {.law = law,
          .end = end,
          .tcol = 1e-4,
          .en = 0.5,
          .impact = {0.5, mass_eff},
          .radius_eff = radius_eff,
          .density = 1000};
}

inline const Linear linear(7316, 0.098), linear_by_force(5211.5, 0.098);
inline const KuwabaraKono kuwabara_kono(1389289, 33.845);
inline const Tsuji tsuji(1.3e6, 1.46);
inline const Hysteretic hysteretic(3924, 15697);
inline const Fractional fractional(5225, 0.2964, 0.3197);

/// The lines of a snippet that an engine acts on.
inline std::string active(const Snippet& snippet) {
  std::istringstream lines(snippet.text);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && !line.starts_with("#") && !line.starts_with("//") && !line.starts_with("!"))
      kept += line + "\n";
  return kept;
}

/// The number that follows `mark` in what the engine acts on.
inline double after(const Snippet& snippet, const std::string& mark) {
  const std::string text = active(snippet);
  const std::size_t at = text.find(mark);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + mark.size()));
}

inline bool acts_on(const Snippet& snippet, const std::string& words) {
  return active(snippet).find(words) != std::string::npos;
}

/// The line that holds `words` of what the engine acts on.
inline std::string line_with(const Snippet& snippet, const std::string& words) {
  std::istringstream lines(active(snippet));
  for (std::string line; std::getline(lines, line);)
    if (line.find(words) != std::string::npos) return line;
  FAIL("no line with " << words);
  return {};
}

inline constexpr double overlap = 1.7e-5, rate = -0.21;  // any instant of a contact

}  // namespace export_cases
