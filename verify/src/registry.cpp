#include <verify/registry.hpp>

#include <filesystem>
#include <system_error>

namespace ricochet::verify {

#define STUDY(name) std::unique_ptr<Study> name##_study();
#include "../studies.inc"
#undef STUDY

Studies all_studies() {
  Studies studies;
#define STUDY(name) studies.push_back(name##_study());
#include "../studies.inc"
#undef STUDY
  return studies;
}

std::string data_folder() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto installed = program.parent_path() / RICOCHET_DATA_INSTALLED;
    if (std::filesystem::is_directory(installed, error)) return installed.lexically_normal().string();
  }
  return RICOCHET_DATA_BUILT;
}

}  // namespace ricochet::verify
