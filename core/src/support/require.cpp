#include <ricochet/support/require.hpp>
#include <ricochet/support/text.hpp>

#include <stdexcept>
#include <string>

namespace ricochet::support {

void reject(std::string_view name, double value, std::string_view accepted) {
  throw std::invalid_argument(std::string(name) + " = " + shortest(value) + ": must be " + std::string(accepted));
}

}  // namespace ricochet::support
