#include "place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace ricochet::console {
namespace {

/// Walks over a valid JSON document, value by value.
class Walker {
 public:
  explicit Walker(std::string_view text) : text_(text) { skip_to_value(); }

  std::size_t at() const { return at_; }

  /// To the value of that key or index in the value here; false, and nowhere else, if there is none.
  bool enter(std::string_view step) {
    const std::size_t start = at_;
    const bool object = here() == '{';
    if (object || here() == '[') {
      ++at_;
      skip_to_value();
      for (std::size_t index = 0; at_ < text_.size() && here() != '}' && here() != ']'; ++index) {
        std::string_view name;
        if (object) {
          const std::size_t key = at_;
          skip_value();
          name = text_.substr(key + 1, at_ - key - 2);
          skip_to_value();
        }
        if (object ? name == step : fmt::format_int(index).str() == step) return true;
        skip_value();
        skip_to_value();
      }
    }
    at_ = start;
    return false;
  }

 private:
  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_to_value() { at_ = std::min(text_.find_first_not_of(" \t\r\n,:", at_), text_.size()); }
  void skip_string() {
    for (++at_; at_ < text_.size() && here() != '"'; ++at_) at_ += here() == '\\';
    ++at_;
  }
  void skip_value() {
    int depth = 0;
    do {
      const char c = here();
      if (c == '"') {
        skip_string();
      } else if (c == '{' || c == '[' || c == '}' || c == ']') {
        depth += c == '{' || c == '[' ? 1 : -1;
        ++at_;
      } else {
        at_ = std::min(text_.find_first_of(" \t\r\n,:\"{}[]", at_), text_.size());
      }
      if (depth > 0) skip_to_value();
    } while (depth > 0 && at_ < text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::string line_and_column(const std::string& text, std::size_t offset) {
  const std::size_t end = std::min(offset, text.size());
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  const std::size_t start = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  return fmt::format("{}:{}", line, start == std::string::npos ? end + 1 : end - start);
}

std::size_t place_of(const std::string& text, const std::string& path) {
  Walker walker(text);
  for (std::size_t from = 1; from <= path.size();) {
    const std::size_t end = std::min(path.find('/', from), path.size());
    if (!walker.enter(std::string_view(path).substr(from, end - from))) break;
    from = end + 1;
  }
  return walker.at();
}

}  // namespace ricochet::console
