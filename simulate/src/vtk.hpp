#pragma once

#include "roster.hpp"

#include <console/output.hpp>

#include <string>

namespace ricochet::simulate {

/// One frame as a legacy VTK file of points, in text: radius, number, material (as the scene counts them, from 0),
/// mass, velocity and spin of each, and the time as field data TIME.
std::string frame_vtk(const Scene& scene, const Roster& roster, const Cluster& cluster);

/// Frames for ParaView in a folder: spheres.000000.vtk, … and spheres.vtk.series, which says their times.
class VtkFolder {
 public:
  /// Made if missing; the first `frames` outputs of the scene are there. Without any, what comes in goes again at the
  /// end of the scope unless it is kept.
  VtkFolder(const std::string& folder, const Scene& scene, std::uint64_t frames);
  ~VtkFolder();
  VtkFolder(const VtkFolder&) = delete;
  VtkFolder& operator=(const VtkFolder&) = delete;

  void add(const std::string& frame, double time);  ///< each file whole or not at all
  void keep() noexcept { kept_ = true; }

 private:
  std::string path(const std::string& name) const;
  void write_series() const;

  console::MadeFolder folder_;
  std::vector<double> times_;
  bool kept_;
};

}  // namespace ricochet::simulate
