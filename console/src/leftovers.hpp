#pragma once

#include <string>
#include <string_view>

#include <sys/types.h>

namespace ricochet::console {

// A program that is killed (SIGKILL, a loss of power) leaves its temporary files. They carry the number of its process
// and are locked while it lives: the next program that makes one in the same folder removes what belongs to nobody.

/// ".<name>.<pid>.<attempt>.part"
std::string temporary_name(std::string_view name, int attempt);
/// "<prefix><pid>-XXXXXX", for mkdtemp()
std::string scratch_name(std::string_view prefix);

/// What scratch folders are called that lie hidden among the files of a user, and among the system's temporary ones.
inline constexpr std::string_view hidden_scratch = ".ricochet-", system_scratch = "ricochet-";

/// Holds an open temporary file or folder as ours for as long as it is open.
void hold(int descriptor) noexcept;

/// Removes temporary files and the scratch folders of that prefix in `folder` whose process is gone. Says nothing:
/// what cannot be removed is no fault of this run.
void remove_leftovers(const std::string& folder, std::string_view scratch_prefix);

}  // namespace ricochet::console
