// Any text as a file of materials: materials, or one line that says what is wrong with it.

#include <console/exit.hpp>
#include <materials.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>

using namespace ricochet;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    calibration::read_materials("materials.json", text);
  } catch (const console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
  return 0;
}
