#pragma once

#include "roster.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ricochet::simulate {

/// A place brought back into the cell where space repeats itself.
Vec3 in_cell(const Scene& scene, Vec3 position);
/// Three numbers with spaces between them, to the last bit.
std::string spelled(Vec3 v);
/// One frame of extended XYZ.
std::string frame_xyz(const Scene& scene, const Roster& roster, const Cluster& cluster);
std::string energy_row(const Cluster& cluster);
std::string contact_row(const Roster& roster, const Encounter& encounter);
std::string energy_header();
std::string contact_header();

/// Throws console::BadInput where a file that a state says has `length` bytes at least is missing or shorter.
void require_written(const std::string& path, std::uint64_t length);

/// A file that grows by whole records and holds nothing else, even when the disk is full or the program is stopped.
class GrowingFile {
 public:
  /// Cut to `length`; of 0 a new one, which goes again at the end of the scope unless it is kept. Throws
  /// console::BadInput or CannotWrite where the path cannot be written and, for a length, see above.
  GrowingFile(std::string path, std::uint64_t length);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Throws console::CannotWrite with the path and the reason.
  void append(const std::string& record);
  std::uint64_t flush();  ///< to the disc; the length now
  void keep() noexcept { kept_ = true; }

 private:
  void write_pending();

  std::string path_, pending_;
  std::uint64_t length_;
  int file_ = -1;
  bool kept_ = false;
};

}  // namespace ricochet::simulate
