#pragma once

#include <console/json.hpp>
#include <simulate/run.hpp>
#include <simulate/scene.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ricochet::simulate {

/// Everything a run needs to go on: the cluster's state and how long each output was then, in bytes.
struct Checkpoint {
  std::array<std::uint64_t, 3> lengths{};
  bool complete = false;
  Format format = Format::xyz;
  std::vector<std::uint32_t> present;  ///< which spheres of the scene, as they count in `state`
  std::vector<std::uint64_t> brought;  ///< by each pour
  ClusterState state;
};

/// As JSON, with the scene's fingerprint; doubles in their shortest form that reads back to the same bits. Bodies count
/// as in the scene, walls after the spheres that are there; memories are the numbers of the law that is named.
std::string write_checkpoint(const Scene& scene, const Checkpoint& checkpoint);

/// Of all that a state says besides its "checksum": the fingerprint of that as JSON without blanks.
std::string checksum(console::Json state);

/// Reads what was written for the same scene, every value checked against it. Throws console::BadInput with one line
/// that names `file`: of a file that is no whole JSON, of another kind, version or scene, or changed since it was
/// saved; else with the place, the value and what is accepted.
Checkpoint read_checkpoint(const std::string& file, const std::string& text, const Scene& scene);

}  // namespace ricochet::simulate
