#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace ricochet::console {

class Passing;

/// A folder for this process alone that is gone, with the files in it, at the end of the scope and on a signal that
/// ends the program. It holds files only. What an end that nothing can catch leaves is removed by the next one made
/// in the same place.
class ScratchFolder {
 public:
  /// Among the system's temporary files. Throws CannotWrite.
  ScratchFolder();
  /// Hidden in a folder that exists. Throws BadInput with the reason.
  explicit ScratchFolder(const std::string& inside);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }
  /// Throws CannotWrite naming the file.
  void write(const std::string& name, std::string_view bytes) const;
  /// All of a file; empty when there is none.
  std::string read(const std::string& name) const;

 private:
  int make(const std::string& inside, std::string_view prefix);

  std::string path_;
  int held_ = -1;  // open, and locked, as long as the folder is ours
  std::unique_ptr<Passing> passing_;
};

}  // namespace ricochet::console
