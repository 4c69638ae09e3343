#pragma once

#include <ricochet/motion/cluster.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ricochet::simulate {

/// A scene file, read and checked: docs/scenes.md says what it holds.
struct Scene {
  std::string title;  ///< as the file gives it; mostly empty
  ClusterSetup setup;
  ClusterOptions options;          ///< with the step chosen
  std::uint64_t steps = 0;         ///< that the run takes
  std::uint64_t output_every = 1;  ///< steps
  StiffestContact stiffest;
  std::vector<std::string> body_names;  ///< spheres 1, 2, …; walls as named, or wall1, wall2, …
  std::string remark;                   ///< what the user should know before the run; mostly empty
  std::string fingerprint;              ///< of everything above that the file says, for --resume
};

/// Reads the text of a scene. `file` only names it in messages. Throws console::BadInput with one line
/// "file:line:column: …" for a syntax error, else "file:line:column: /path/to/value = …: must be …", for a repeated
/// key, every unknown key, wrong type, number out of range, missing pair of materials, overlap at the start, and a step
/// too large for the stiffest contact.
Scene read_scene(const std::string& file, const std::string& text);

}  // namespace ricochet::simulate
