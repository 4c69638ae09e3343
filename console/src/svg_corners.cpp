#include "svg_corners.hpp"

#include <console/number.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace ricochet::console {

namespace {

constexpr double tolerance = 0.1;  // pixels

struct Corner {
  double x, y;
  std::string_view text;  ///< "96.00,281.61"
};

/// From the straight line between two others, from its nearer end where it lies beyond.
double distance(const Corner& p, const Corner& a, const Corner& b) {
  const double along_x = b.x - a.x, along_y = b.y - a.y, square = along_x * along_x + along_y * along_y;
  const double share =
      square > 0 ? std::clamp(((p.x - a.x) * along_x + (p.y - a.y) * along_y) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - share * along_x, p.y - a.y - share * along_y);
}

/// Which corners stay.
std::vector<bool> kept(const std::vector<Corner>& line) {
  std::vector<bool> keep(line.size());
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> parts{{0, line.size() - 1}};
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double off = distance(line[i], line[first], line[last]); off > most) {
        most = off;
        farthest = i;
      }
    if (farthest == first) continue;
    keep[farthest] = true;
    parts.insert(parts.end(), {{first, farthest}, {farthest, last}});
  }
  return keep;
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n'; }

/// The word at `at`, which moves behind it; empty at the end.
std::string_view word(std::string_view text, std::size_t& at) {
  while (at < text.size() && is_space(text[at])) ++at;
  const std::size_t first = at;
  while (at < text.size() && !is_space(text[at])) ++at;
  return text.substr(first, at - first);
}

/// What a path of straight lines does: "M1,2 L3,4 … Z"; another path as it is.
class Path {
 public:
  explicit Path(std::string_view written) : written_(written) {}

  std::string thinned() {
    std::size_t at = 0;
    for (std::string_view next = word(written_, at); !next.empty(); next = word(written_, at)) {
      if (next == "Z") {
        end_line();
        text_ += "Z ";
      } else if (!add(next)) {
        return std::string(written_);
      }
    }
    end_line();
    if (text_.ends_with(' ')) text_.pop_back();
    return text_;
  }

 private:
  /// "M1,2" begins a line, "L3,4" goes on.
  bool add(std::string_view corner) {
    const auto comma = corner.find(',');
    if (comma == std::string_view::npos || (corner.front() != 'M' && (corner.front() != 'L' || line_.empty())))
      return false;
    if (corner.front() == 'M') end_line();
    const auto x = parse_number(corner.substr(1, comma - 1));
    const auto y = parse_number(corner.substr(comma + 1));
    if (!x || !y) return false;
    line_.push_back({*x, *y, corner.substr(1)});
    return true;
  }

  void end_line() {
    if (line_.empty()) return;
    const std::vector<bool> keep = kept(line_);
    for (std::size_t i = 0; i < line_.size(); ++i)
      if (keep[i]) text_ += (i == 0 ? "M" : "L") + std::string(line_[i].text) + " ";
    line_.clear();
  }

  std::string_view written_;
  std::string text_;
  std::vector<Corner> line_;
};

std::string with_thin_paths(const std::string& svg) {
  constexpr std::string_view opening = " d='";
  std::string thin;
  std::size_t from = 0;
  for (auto at = svg.find(opening); at != std::string::npos; at = svg.find(opening, from)) {
    const auto first = at + opening.size(), last = std::min(svg.find('\'', first), svg.size());
    thin.append(svg, from, first - from);
    thin += Path(std::string_view(svg).substr(first, last - first)).thinned();
    from = last;
  }
  return thin.append(svg, from);
}

/// `<g …>` with nothing but space up to its end.
std::string without_empty_groups(const std::string& svg) {
  constexpr std::string_view opening = "<g ", closing = "</g>";
  std::string full;
  std::size_t from = 0;
  for (auto at = svg.find(opening); at != std::string::npos; at = svg.find(opening, at + 1)) {
    std::size_t end = svg.find('>', at);
    if (end == std::string::npos) break;
    while (++end < svg.size() && is_space(svg[end])) {
    }
    if (svg.compare(end, closing.size(), closing) != 0) continue;
    full.append(svg, from, at - from);
    from = end + closing.size();
    if (from < svg.size() && svg[from] == '\n') ++from;
  }
  return full.append(svg, from);
}

}  // namespace

std::string with_fewer_corners(const std::string& svg) { return without_empty_groups(with_thin_paths(svg)); }

}  // namespace ricochet::console
