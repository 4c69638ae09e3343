#pragma once

#include <ricochet/contact/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::simulate {

/// One grain at one moment, SI units.
struct SeenGrain {
  Vec3 position, velocity, spin;
  double radius = 0;
  std::uint32_t species = 0;  ///< in the order in which the file names them
  std::uint64_t id = 0;       ///< its own in all frames; its place in the frame where the file tells none
};

struct SeenFrame {
  double time = 0;
  std::vector<SeenGrain> grains;
};

/// Frames of an extended XYZ file, in any order: positions and radii, and what else of species, velocities, spins and
/// ids it holds; other columns are passed over. Memory is that of one frame, and of where each begins.
class TrajectoryFile {
 public:
  /// Finds the frames. Throws console::BadInput "file:line: …" where it is not whole frames.
  explicit TrajectoryFile(std::string path);

  std::size_t size() const { return places_.size(); }  ///< frames
  std::size_t grains(std::size_t frame) const { return places_[frame].grains; }
  SeenFrame frame(std::size_t number);
  const std::vector<std::string>& species() const { return species_; }  ///< of the frames read so far

 private:
  struct Place {
    std::streamoff at;  // of its second line
    std::size_t line, grains;
  };
  // Where in a row each quantity begins; `columns` of what the file does not hold.
  struct Layout {
    std::size_t species, position, radius, velocity, spin, id, columns;
  };

  Layout layout(std::string_view properties, std::size_t line) const;
  SeenGrain grain(std::string_view row, const Layout& layout, std::size_t line);
  std::uint32_t number_of(std::string_view species);
  [[noreturn]] void fail(std::size_t line, std::string_view what) const;

  std::string path_;
  std::ifstream file_;
  std::vector<Place> places_;
  std::vector<std::string> species_;
  std::map<std::string, std::uint32_t, std::less<>> numbers_;
  std::vector<std::string_view> fields_;  // of the row being read
};

}  // namespace ricochet::simulate
