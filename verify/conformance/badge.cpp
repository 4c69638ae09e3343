#include "badge.hpp"

#include "show.hpp"

#include <console/html.hpp>
#include <console/plot.hpp>
#include <console/table.hpp>

#include <fmt/format.h>

#include <cmath>

namespace ricochet::verify::conformance {

namespace {

constexpr int height = 20, padding = 10;
constexpr double letter = 6.6;  // mean width in a sans-serif face of 11 px, with something to spare

int width_of(const std::string& words) {
  return 2 * padding + static_cast<int>(std::lround(letter * static_cast<double>(console::display_width(words))));
}

}  // namespace

std::string file_stem(const Results& results) { return console::slug(label(results)); }

std::string badge(const EngineGrade& engine) {
  const std::string left = label(engine.results),
                    right = fmt::format("{} of {} cases right", engine.right(), engine.run());
  const bool all = engine.run() > 0 && engine.right() == engine.run();
  const int first = width_of(left), second = width_of(right);
  // Dark on both colours: white on orange is too pale to read.
  const char* colour = all ? console::palette::sky : console::palette::orange;
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" role="img" aria-label="{title}">
<title>{title}</title>
<rect width="{a}" height="{h}" fill="#333333"/><rect x="{a}" width="{b}" height="{h}" fill="{colour}"/>
<g font-family="Verdana, DejaVu Sans, sans-serif" font-size="11" text-anchor="middle">
<text x="{x1}" y="14" fill="#ffffff">{left}</text><text x="{x2}" y="14" fill="#000000">{right}</text>
</g>
</svg>
)",
      fmt::arg("w", first + second), fmt::arg("h", height), fmt::arg("a", first), fmt::arg("b", second),
      fmt::arg("colour", colour), fmt::arg("x1", first / 2), fmt::arg("x2", first + second / 2),
      fmt::arg("title", console::escaped(fmt::format("Conformance of contacts, {}: {}", left, right))),
      fmt::arg("left", console::escaped(left)), fmt::arg("right", console::escaped(right)));
}

}  // namespace ricochet::verify::conformance
