// Any text as a file of convergence data: cases of meshes with finite numbers, or one line that says what is wrong.

#include "../../verify/src/order_file.hpp"

#include "memory_file.hpp"

#include <console/exit.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

using namespace ricochet;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  try {
    for (const verify::OrderCase& one : verify::read_order_file(file.path()).cases) {
      if (one.h.size() != one.value.size()) throw std::logic_error("a mesh that was lost");
      for (const double h : one.h)
        if (!(std::isfinite(h) && h > 0)) throw std::logic_error("an impossible mesh");
      for (const double value : one.value)
        if (!std::isfinite(value)) throw std::logic_error("an impossible value");
    }
  } catch (const console::BadInput& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) throw std::logic_error("more than one line");
  }
  return 0;
}
