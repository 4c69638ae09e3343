#include <ricochet/support/require.hpp>
#include <ricochet/support/text.hpp>

#include <stdexcept>
#include <string>

namespace ricochet::support {

void reject(const char* name, double value, const char* accepted) {
  throw std::invalid_argument(name + (" = " + shortest(value)) + ": must be " + accepted);
}

}  // namespace ricochet::support
