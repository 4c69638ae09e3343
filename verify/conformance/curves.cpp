#include "curves.hpp"

#include <console/gnuplot.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace ricochet::verify::conformance {

namespace {

constexpr std::array families{"normal", "oblique"};

/// Of all cases of the family that the engine ran, by the steps in a collision.
std::map<double, double> greatest_errors(const EngineGrade& e, const std::string& family) {
  std::map<double, double> most;
  for (const CaseGrade& c : e.cases) {
    if (c.of->family != family || !c.worst()) continue;
    const std::vector<double>& steps = c.worst()->steps_in_scale;
    for (std::size_t i = 0; i < steps.size(); ++i) most[steps[i]] = std::max(most[steps[i]], c.error_at(i));
  }
  std::erase_if(most, [](const auto& at) { return !(at.second > 0); });
  return most;
}

/// Without what gnuplot takes for marks.
std::string plain(std::string words) {
  for (char& c : words)
    if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) c = ' ';
  return words;
}

}  // namespace

std::optional<console::Figure> error_curves(const std::vector<EngineGroup>& groups) {
  console::SeriesFile file("errors.csv", "steps,error");
  console::Plot plot{.layout = console::Layout{.rows = 1,
                                               .columns = 2,
                                               .left = 0.09,
                                               .right = 0.975,
                                               .bottom = 0.14 + 0.055 * static_cast<double>(groups.size()),
                                               .top = 0.93,
                                               .between_columns = 0.09}};
  std::string finding;
  std::size_t series = 0;
  for (const char* family : families) {
    console::Panel panel{.title = fmt::format("family {}", family),
                         .x = {.label = "steps in a collision", .log = true},
                         .y = {.label = "greatest error, share of scale", .log = true, .format = "10^{%T}"}};
    std::vector<std::string> at_finest;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const std::map<double, double> errors = greatest_errors(*groups[i].front(), family);
      if (errors.empty()) continue;
      file.begin();
      for (const auto& [steps, error] : errors)
        file.add(fmt::format("{},{}", console::shortest(steps), console::shortest(error)));
      at_finest.push_back(fmt::format("{} {} % at {}", labels(groups[i]),
                                      console::significant(100 * errors.rbegin()->second, 2),
                                      console::shortest(errors.rbegin()->first)));
      panel.curves.push_back({.file = file.name(),
                              .rows = file.rows(series++),
                              .what = "1:2",
                              .style = fmt::format("linespoints lt {} lw 1.6 pt {} ps 0.7", i % 7 + 1, i + 4),
                              .title = plain(labels(groups[i]))});
    }
    if (panel.curves.empty()) continue;
    finding += fmt::format("{}Family {}: {}.", finding.empty() ? "" : " ", family, fmt::join(at_finest, "; "));
    plot.panels.push_back(std::move(panel));
  }
  if (plot.panels.empty()) return std::nullopt;
  plot.panels.front().key = fmt::format("at screen 0.5,0.01 center bottom maxrows {}", groups.size());
  return console::Figure{"errors",
                         "The greatest error of an answer, as a share of its scale, among all cases of a family that "
                         "an engine ran, against the steps in a collision. Where a curve levels off, a case converges "
                         "elsewhere.",
                         plot,
                         {file.data()},
                         900,
                         400 + 24 * static_cast<int>(groups.size()),
                         finding};
}

}  // namespace ricochet::verify::conformance
