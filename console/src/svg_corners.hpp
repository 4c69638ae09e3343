#pragma once

#include <string>

namespace ricochet::console {

/// gnuplot's SVG with every line through as few of its corners as leave none further than a tenth of a pixel from it
/// (Ramer, Douglas and Peucker), and without groups that hold nothing: what no screen shows.
std::string with_fewer_corners(const std::string& svg);

}  // namespace ricochet::console
