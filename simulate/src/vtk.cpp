#include "vtk.hpp"

#include "outputs.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <unistd.h>

namespace ricochet::simulate {
namespace {

using console::shortest;

std::string line(Vec3 v) { return spelled(v) + '\n'; }

constexpr const char* series_file = "spheres.vtk.series";

std::string file_of(std::size_t frame) { return fmt::format("spheres.{:06}.vtk", frame); }

}  // namespace

std::string frame_vtk(const Scene& scene, const Roster& roster, const Cluster& cluster) {
  const std::size_t n = cluster.size();
  std::string frame = fmt::format(
      "# vtk DataFile Version 3.0\nspheres that simulate moves\nASCII\nDATASET POLYDATA\n"
      "FIELD FieldData 1\nTIME 1 1 double\n{}\nPOINTS {} double\n",
      shortest(cluster.time()), n);
  for (std::size_t i = 0; i < n; ++i) frame += line(in_cell(scene, cluster.position(i)));
  frame += fmt::format("VERTICES {} {}\n", n, 2 * n);
  for (std::size_t i = 0; i < n; ++i) frame += fmt::format("1 {}\n", i);
  frame += fmt::format("POINT_DATA {}\n", n);
  const auto scalars = [&](const char* name, const char* type, auto&& value) {
    frame += fmt::format("SCALARS {} {} 1\nLOOKUP_TABLE default\n", name, type);
    for (std::size_t i = 0; i < n; ++i) frame += fmt::format("{}\n", value(i));
  };
  scalars("radius", "double", [&](std::size_t i) { return shortest(roster.sphere(i).radius); });
  scalars("mass", "double", [&](std::size_t i) { return shortest(roster.sphere(i).mass()); });
  scalars("number", "int", [&](std::size_t i) { return roster.name(i); });
  scalars("material", "int", [&](std::size_t i) { return scene.stuff[roster.who()[i]]; });
  frame += "VECTORS velocity double\n";
  for (std::size_t i = 0; i < n; ++i) frame += line(cluster.velocity(i));
  frame += "VECTORS spin double\n";
  for (std::size_t i = 0; i < n; ++i) frame += line(cluster.spin(i));
  return frame;
}

VtkFolder::VtkFolder(const std::string& folder, const Scene& scene, std::uint64_t frames)
    : folder_(folder), kept_(frames > 0) {
  for (std::uint64_t k = 0; k < frames; ++k)
    times_.push_back(static_cast<double>(k * scene.output_every) * scene.options.step);
}

VtkFolder::~VtkFolder() {
  if (kept_) return;
  for (std::size_t k = 0; k < times_.size(); ++k) ::unlink(path(file_of(k)).c_str());
  ::unlink(path(series_file).c_str());
}

std::string VtkFolder::path(const std::string& name) const { return fmt::format("{}/{}", folder_.path(), name); }

void VtkFolder::add(const std::string& frame, double time) {
  console::write_atomically(path(file_of(times_.size())), frame);
  times_.push_back(time);
  write_series();
}

void VtkFolder::write_series() const {
  std::string series = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n";
  for (std::size_t k = 0; k < times_.size(); ++k)
    series += fmt::format("    {{\"name\": \"{}\", \"time\": {}}}{}\n", file_of(k), shortest(times_[k]),
                          k + 1 < times_.size() ? "," : "");
  console::write_atomically(path(series_file), series + "  ]\n}\n");
}

}  // namespace ricochet::simulate
