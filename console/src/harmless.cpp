#include <console/harmless.hpp>

#include <algorithm>

namespace ricochet::console {

std::size_t control_length(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0xff; };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  return byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) <= 0x9f ? 2 : 0;
}

bool has_controls(std::string_view text) noexcept {
  for (; !text.empty(); text.remove_prefix(1))
    if (control_length(text) > 0) return true;
  return false;
}

std::string without_controls(std::string text, bool lines) {
  if (!has_controls(text)) return text;
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t control = lines && text[at] == '\n' ? 0 : control_length(std::string_view(text).substr(at));
    plain += control > 0 ? '?' : text[at];
    at += std::max<std::size_t>(control, 1);
  }
  return plain;
}

bool is_harmless(std::string_view word) noexcept { return word.find_first_of("=+-@") != 0 && !has_controls(word); }

}  // namespace ricochet::console
