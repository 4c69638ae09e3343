#include "outputs.hpp"

#include "start.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/output.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

namespace ricochet::simulate {
namespace {

using console::shortest;

std::string finite_or_empty(double value) { return std::isfinite(value) ? shortest(value) : ""; }

}  // namespace

std::string spelled(Vec3 v) { return fmt::format("{} {} {}", shortest(v.x), shortest(v.y), shortest(v.z)); }

Vec3 in_cell(const Scene& scene, Vec3 x) {
  for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z})
    if (const double period = scene.setup.periodic.period.*axis; period > 0) {
      x.*axis -= period * std::floor((x.*axis - scene.cell_low.*axis) / period);
      if (!(x.*axis < scene.cell_high.*axis)) x.*axis = scene.cell_low.*axis;  // by rounding
    }
  return x;
}

// The property names that OVITO maps to particle properties by itself.
std::string frame_xyz(const Scene& scene, const Roster& roster, const Cluster& cluster) {
  const Vec3 cell = scene.cell_high - scene.cell_low, period = scene.setup.periodic.period;
  const auto repeats = [](double along) { return along > 0 ? "T" : "F"; };
  std::string frame = fmt::format(
      R"({}
Lattice="{} 0 0 0 {} 0 0 0 {}" Origin="{}" Properties=species:S:1:pos:R:3:radius:R:1:mass:R:1:velo:R:3:{} Time={} {}
)",
      cluster.size(), shortest(cell.x), shortest(cell.y), shortest(cell.z), spelled(scene.cell_low),
      "angular_velocity:R:3:id:I:1", shortest(cluster.time()),
      fmt::format(R"(pbc="{} {} {}")", repeats(period.x), repeats(period.y), repeats(period.z)));
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    const Sphere& s = roster.sphere(i);
    frame += fmt::format("{} {} {} {} {} {} {}\n", species(roster.material(i)),
                         spelled(in_cell(scene, cluster.position(i))), shortest(s.radius), shortest(s.mass()),
                         spelled(cluster.velocity(i)), spelled(cluster.spin(i)), roster.name(i));
  }
  return frame;
}

std::string energy_header() {
  return "t [s],kinetic [J],gravity [J],stored [J],lost_normal [J],lost_friction [J],total [J],contacts,strained [J],"
         "walls [J],brought [J],spheres\n";
}

std::string energy_row(const Cluster& cluster) {
  const ClusterEnergy e = cluster.energy();
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", shortest(cluster.time()), shortest(e.kinetic),
                     shortest(e.gravity), shortest(e.stored), shortest(e.lost_normal), shortest(e.lost_friction),
                     shortest(e.total()), cluster.contacts().size(), shortest(e.strained), shortest(e.wall_work),
                     shortest(e.brought), cluster.size());
}

std::string contact_header() { return "i,j,t_begin [s],t_end [s],t_separation [s],ended,phases\n"; }

std::string contact_row(const Roster& roster, const Encounter& e) {
  std::array<std::size_t, phase_count> order{};
  for (std::size_t k = 0; k < phase_count; ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return e.phase_begin[a] < e.phase_begin[b]; });
  std::vector<std::string> phases;
  for (std::size_t k : order)
    if (std::isfinite(e.phase_begin[k]))
      phases.push_back(fmt::format("{} {}", name(static_cast<Phase>(k)), shortest(e.phase_begin[k])));
  return fmt::format("{},{},{},{},{},{},{}\n", roster.name(e.i), roster.name(e.j), shortest(e.begin),
                     finite_or_empty(e.end), finite_or_empty(e.separation), name(e.how), fmt::join(phases, "; "));
}

void require_written(const std::string& path, std::uint64_t length) {
  constexpr const char* again = "start again without --resume";
  std::error_code error;
  const std::uint64_t found = std::filesystem::file_size(path, error);
  if (error) throw console::BadInput(fmt::format("{}: missing: {}; {}", path, error.message(), again));
  if (found < length)
    throw console::BadInput(fmt::format("{}: shorter than when the state was saved; {}", path, again));
}

GrowingFile::GrowingFile(std::string path, std::uint64_t length) : path_(std::move(path)), length_(length) {
  if (length > 0) require_written(path_, length);
  file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | (length == 0 ? O_CREAT | O_EXCL : 0), 0666);
  if (file_ < 0) console::throw_cannot_create(path_, errno);
  if (length == 0) return;
  kept_ = true;
  if (::ftruncate(file_, static_cast<off_t>(length)) != 0 || ::lseek(file_, 0, SEEK_END) < 0) {
    const int error = errno;
    ::close(file_);
    throw console::CannotWrite(path_, error);
  }
}

GrowingFile::~GrowingFile() {
  try {
    write_pending();
  } catch (const console::CannotWrite&) {
    // Whoever called for it has been told; here another failure is on its way.
  }
  ::close(file_);
  if (!kept_) ::unlink(path_.c_str());
}

void GrowingFile::append(const std::string& record) {
  constexpr std::size_t worth_a_call = 1 << 16;
  pending_ += record;
  if (pending_.size() >= worth_a_call) write_pending();
}

void GrowingFile::write_pending() {
  const std::string records = std::exchange(pending_, {});
  try {
    console::write_all(file_, records, path_);
  } catch (...) {
    [[maybe_unused]] const int cut = ::ftruncate(file_, static_cast<off_t>(length_));  // half a record goes again
    throw;
  }
  length_ += records.size();
}

std::uint64_t GrowingFile::flush() {
  write_pending();
  if (::fdatasync(file_) != 0 && errno != EINVAL && errno != EROFS) throw console::CannotWrite(path_, errno);
  return length_;
}

}  // namespace ricochet::simulate
