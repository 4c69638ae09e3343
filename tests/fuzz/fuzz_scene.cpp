// Any text as a scene file: a scene, or one line that says what is wrong with it.

#include <console/exit.hpp>
#include <simulate/scene.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    ricochet::simulate::read_scene("scene.json", text);
  } catch (const ricochet::console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
  return 0;
}
