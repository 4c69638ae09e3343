#include "svg_theme.hpp"

#include <console/html.hpp>

#include <fmt/format.h>

namespace ricochet::console {

namespace {

/// A colour of the palette and what takes its place on a dark ground.
struct Pair {
  int red, green, blue;
  const char* dark;
};
constexpr Pair pairs[] = {{0, 0, 0, "#e4e6ea"},      {0, 114, 178, "#45a3e6"},  {213, 94, 0, "#ff8a3d"},
                          {0, 158, 115, "#2fc79a"},  {230, 159, 0, "#f4b73f"},  {204, 121, 167, "#e2a0c5"},
                          {86, 180, 233, "#9ad5f8"}, {118, 118, 118, "#a9b0bc"}};

/// The rule that repaints whatever has this colour as stroke, as fill or as the colour that points inherit.
std::string rule(const std::string& written, const std::string& dark) {
  std::string css;
  for (const char* property : {"stroke", "fill", "color"})
    css += fmt::format(R"([{0}="{1}"]{{{0}:{2}}})", property, written, dark);
  return css;
}

std::string dark_rules() {
  std::string css = rule("black", "#e4e6ea") + rule("gray", "#a9b0bc") + rule("#ffffff", "#1b1e24") +
                    rule("#FFFFFF", "#1b1e24") + ".gridline{stroke:#363b45}feFlood{flood-color:#1b1e24}";
  for (const Pair& pair : pairs) {
    css += rule(fmt::format("rgb({:3}, {:3}, {:3})", pair.red, pair.green, pair.blue), pair.dark);
    css += rule(fmt::format("rgb({},{},{})", pair.red, pair.green, pair.blue), pair.dark);
  }
  return css;
}

void replace_between(std::string& text, const std::string& open, const std::string& close, const std::string& content) {
  const auto first = text.find(open);
  if (first == std::string::npos) return;
  const auto last = text.find(close, first);
  text.replace(first + open.size(), last - first - open.size(), content);
}

}  // namespace

std::string themed(std::string svg, const std::string& title, const std::string& description) {
  replace_between(svg, "<title>", "</title>", escaped(title));
  replace_between(svg, "<desc>", "</desc>", escaped(description));
  const std::string style = fmt::format(
      "<style>:root{{color-scheme:light dark}}@media screen and (prefers-color-scheme:dark){{{}}}</style>\n",
      dark_rules());
  if (const auto at = svg.find("<title>"); at != std::string::npos) svg.insert(at, style);
  return svg;
}

}  // namespace ricochet::console
