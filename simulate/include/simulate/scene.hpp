#pragma once

#include <ricochet/motion/cluster.hpp>
#include <simulate/region.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ricochet::simulate {

/// Spheres that come while the scene runs: `count` of setup.later, from `first` on.
struct Pour {
  PourRegion region;
  std::size_t first = 0, count = 0;
  double rate = 0;   ///< at most so many a second
  double begin = 0;  ///< of the first [s]
  std::uint64_t seed = 0;
};

/// Who is behind this plane leaves.
struct Outlet {
  Vec3 point, inward;
};

/// A scene file, read and checked: docs/scenes.md says what it holds. Spheres count as in setup.spheres, then as in
/// setup.later; their numbers in files are one more.
struct Scene {
  std::string title;  ///< as the file gives it; mostly empty
  ClusterSetup setup;
  ClusterOptions options;          ///< with the step chosen
  std::uint64_t steps = 0;         ///< that the run takes
  std::uint64_t output_every = 1;  ///< steps
  StiffestContact stiffest;
  std::vector<std::string> materials;   ///< their names
  std::vector<std::uint32_t> stuff;     ///< material of each sphere; Sphere::material may tell sizes apart too
  std::vector<std::string> wall_names;  ///< as given, or wall1, box1 low x, …
  std::vector<Pour> pours;              ///< those with a rate
  std::vector<Outlet> outlets;
  Vec3 cell_low{}, cell_high{};  ///< of the trajectory's box: periods, else boxes, else what the spheres take
  std::string remark;            ///< what the user should know before the run; mostly empty
  std::string fingerprint;       ///< of everything above that the file says, for --resume

  std::size_t sphere_count() const noexcept { return setup.spheres.size() + setup.later.size(); }
  const Sphere& sphere(std::size_t k) const noexcept {
    return k < setup.spheres.size() ? setup.spheres[k] : setup.later[k - setup.spheres.size()];
  }
};

/// Reads the text of a scene. `file` names it in messages, and says from where a start is sought. Throws
/// console::BadInput with one line "file:line:column: …" for a syntax error, else "file:line:column: /path/to/value
/// = …: must be …", for a repeated key, every unknown key, wrong type, number out of range, missing pair of materials,
/// spheres that find no room or lie deep in each other, and a step too large for the stiffest contact.
Scene read_scene(const std::string& file, const std::string& text);

}  // namespace ricochet::simulate
