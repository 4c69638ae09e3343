#include <console/exit.hpp>
#include <console/harmless.hpp>

#include <fmt/format.h>

#include <unistd.h>

#include <string>
#include <system_error>

namespace ricochet::console {

BadInput::BadInput(std::string_view flag, std::string_view value, std::string_view accepted)
    : std::runtime_error(fmt::format("{} = {}: must be {}", flag, value, accepted)) {}

CannotWrite::CannotWrite(std::string_view path, int error)
    : Failed(fmt::format("{}: cannot write: {}", path, std::generic_category().message(error))) {}

Exit exit_code(const std::exception& error) {
  if (dynamic_cast<const BadInput*>(&error) || dynamic_cast<const std::invalid_argument*>(&error))
    return Exit::bad_input;
  if (dynamic_cast<const Unreachable*>(&error)) return Exit::unreachable;
  return Exit::failed;
}

void complain(std::string_view program, std::string_view message) {
  std::string line = fmt::format("{}: ", program);
  while (!message.empty() && message.back() == '\n') message.remove_suffix(1);
  for (std::size_t control = 0; !message.empty(); message.remove_prefix(control > 0 ? control : 1)) {
    control = control_length(message);
    if (message.front() == '\n')
      line += "; ";
    else if (control > 0)
      for (const char c : message.substr(0, control)) line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      line += message.front();
  }
  line += '\n';
  // One write, so that lines of concurrent processes do not mix; a closed stderr leaves nobody to tell.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
}

}  // namespace ricochet::console
