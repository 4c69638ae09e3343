#include "badge.hpp"

#include "show.hpp"

#include <console/html.hpp>
#include <console/plot.hpp>
#include <console/table.hpp>

#include <fmt/format.h>

#include <cmath>

namespace ricochet::verify::conformance {

namespace {

constexpr int height = 22, padding = 10, bar = 3;
constexpr double letter = 6.6;  // mean width in a sans-serif face of 11 px, with something to spare

constexpr const char* pale = "#dddddd";

/// From one colour "#rrggbb" to another.
std::string mixed(std::string_view from, std::string_view to, double share) {
  std::string colour = "#";
  for (std::size_t i = 1; i < 7; i += 2) {
    const auto part = [&](std::string_view c) { return std::stoi(std::string(c.substr(i, 2)), nullptr, 16); };
    colour += fmt::format("{:02x}", std::lround(part(from) + share * (part(to) - part(from))));
  }
  return colour;
}

double share(std::size_t part, std::size_t of) {
  return of > 0 ? static_cast<double>(part) / static_cast<double>(of) : 0;
}

std::string colour_of(const EngineGrade& e) {
  const std::string judged = mixed(console::palette::orange, console::palette::sky, share(e.right(), e.run()));
  return mixed(pale, judged, share(e.run(), e.cases.size()));
}

int width_of(const std::string& words) {
  return 2 * padding + static_cast<int>(std::lround(letter * static_cast<double>(console::display_width(words))));
}

}  // namespace

std::string file_stem(const Results& results) { return console::slug(label(results)); }

std::string badge(const EngineGrade& engine) {
  const std::size_t not_run = engine.cases.size() - engine.run();
  const std::string left = label(engine.results), right = fmt::format("{} of {} right", engine.right(), engine.run()) +
                                                          (not_run > 0 ? fmt::format(", {} not run", not_run) : "");
  const int first = width_of(left), second = width_of(right);
  const auto part = [&](std::size_t count) {
    return static_cast<int>(std::lround(second * share(count, engine.cases.size())));
  };
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" role="img" aria-label="{title}">
<title>{title}</title>
<rect width="{a}" height="{h}" fill="#333333"/><rect x="{a}" width="{b}" height="{h}" fill="{colour}"/>
<rect x="{a}" y="{y}" width="{b}" height="{bar}" fill="#ffffff"/>
<rect x="{a}" y="{y}" width="{ran}" height="{bar}" fill="{wrong}"/>
<rect x="{a}" y="{y}" width="{good}" height="{bar}" fill="{fine}"/>
<g font-family="Verdana, DejaVu Sans, sans-serif" font-size="11" text-anchor="middle">
<text x="{x1}" y="14" fill="#ffffff">{left}</text><text x="{x2}" y="14" fill="#000000">{right}</text>
</g>
</svg>
)",
      fmt::arg("w", first + second), fmt::arg("h", height), fmt::arg("a", first), fmt::arg("b", second),
      fmt::arg("colour", colour_of(engine)), fmt::arg("y", height - bar), fmt::arg("bar", bar),
      fmt::arg("ran", part(engine.run())), fmt::arg("good", part(engine.right())),
      fmt::arg("wrong", console::palette::vermilion), fmt::arg("fine", console::palette::blue),
      fmt::arg("x1", first / 2), fmt::arg("x2", first + second / 2),
      fmt::arg("title", console::escaped(fmt::format("Conformance of contacts, {}: {}", left, right))),
      fmt::arg("left", console::escaped(left)), fmt::arg("right", console::escaped(right)));
}

}  // namespace ricochet::verify::conformance
