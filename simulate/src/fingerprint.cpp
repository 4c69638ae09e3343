#include "fingerprint.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace ricochet::simulate {

std::string fingerprint(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return fmt::format_int(hash).str();
}

}  // namespace ricochet::simulate
