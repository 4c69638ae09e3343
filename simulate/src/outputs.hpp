#pragma once

#include <simulate/scene.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace ricochet::simulate {

std::string frame_xyz(const Scene& scene, const Cluster& cluster);       ///< one frame of extended XYZ
std::string energy_row(const Cluster& cluster);
std::string contact_row(const Scene& scene, const Encounter& encounter);
std::string energy_header();
std::string contact_header();

/// A file that grows. Cut to `length` when opened.
class GrowingFile {
 public:
  GrowingFile(std::string path, std::uint64_t length);
  void append(const std::string& bytes);
  std::uint64_t flush();  ///< to the disc; the length now

 private:
  struct Close {
    void operator()(std::FILE* f) const noexcept { std::fclose(f); }
  };
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t length_;
};

}  // namespace ricochet::simulate
