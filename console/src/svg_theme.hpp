#pragma once

#include <string>

namespace ricochet::console {

/// gnuplot's SVG with a title, a description, and a style sheet that repaints it on dark pages. gnuplot writes colours
/// as presentation attributes, which any style sheet overrides.
std::string themed(std::string svg, const std::string& title, const std::string& description);

}  // namespace ricochet::console
