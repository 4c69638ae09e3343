#pragma once

#include <ricochet/motion/cluster.hpp>

#include <array>
#include <cstdint>
#include <string>

namespace ricochet::simulate {

/// Everything a run needs to go on: the cluster's state and how long each output was then, in bytes.
struct Checkpoint {
  std::string fingerprint;
  std::array<std::uint64_t, 3> lengths{};
  bool complete = false;
  ClusterState state;
};

/// As JSON; doubles in their shortest form that reads back to the same bits.
std::string write_checkpoint(const Checkpoint& checkpoint);

/// Throws console::BadInput naming `file` if this is not one.
Checkpoint read_checkpoint(const std::string& file, const std::string& text);

}  // namespace ricochet::simulate
