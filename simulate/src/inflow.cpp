#include "inflow.hpp"

#include "crowd.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet::simulate {
namespace {

constexpr int most_tries = 100;  // for the place of one sphere at one look

}  // namespace

std::vector<std::uint32_t> Inflow::leaving(const Cluster& cluster) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; !scene_->outlets.empty() && i < cluster.size(); ++i) {
    const Vec3 x = cluster.position(i);
    if (std::ranges::any_of(scene_->outlets, [&](const Outlet& o) { return dot(x - o.point, o.inward) < 0; }))
      found.push_back(i);
  }
  return found;
}

void Inflow::strike(const std::vector<std::uint32_t>& leaving, Roster& roster) {
  auto gone = leaving.begin();
  std::uint32_t k = 0;
  std::erase_if(roster.who(), [&](std::uint32_t) {
    const bool leaves = gone != leaving.end() && *gone == k;
    ++k;
    if (leaves) ++gone;
    return leaves;
  });
}

std::uint64_t Inflow::due_of(const Pour& pour, double time) noexcept {
  if (time < pour.begin) return 0;
  return std::min<std::uint64_t>(pour.count, 1 + static_cast<std::uint64_t>((time - pour.begin) * pour.rate));
}

std::uint64_t Inflow::waiting(double time) const noexcept {
  std::uint64_t count = 0;
  for (std::size_t p = 0; p < brought_.size(); ++p) count += due_of(scene_->pours[p], time) - brought_[p];
  return count;
}

void Inflow::bring(Cluster& cluster, Roster& roster) {
  const double now = cluster.time();
  if (waiting(now) == 0) return;
  double largest = 0;
  for (std::size_t k = 0; k < scene_->sphere_count(); ++k) largest = std::max(largest, scene_->sphere(k).radius);
  Crowd crowd(largest, scene_->setup.periodic, scene_->setup.walls, now);
  for (std::size_t i = 0; i < cluster.size(); ++i) crowd.add(cluster.position(i), roster.sphere(i).radius);
  std::vector<Sphere> coming;
  for (std::size_t p = 0; p < brought_.size(); ++p) {
    const Pour& pour = scene_->pours[p];
    Random random(pour.seed, cluster.steps() + 2);  // 0 and 1 are for the start
    for (bool found = true; found && brought_[p] < due_of(pour, now);) {
      const std::size_t number = pour.first + brought_[p];
      Sphere s = scene_->setup.later[number];
      found = false;
      for (int tries = 0; tries < most_tries && !found; ++tries) {
        s.position = pour.region.somewhere(s.radius, random);
        found = crowd.room_for(s.position, s.radius);
      }
      if (!found) break;
      crowd.add(s.position, s.radius);
      coming.push_back(s);
      roster.who().push_back(static_cast<std::uint32_t>(scene_->setup.spheres.size() + number));
      ++brought_[p];
    }
  }
  if (!coming.empty()) cluster.add(coming);
}

}  // namespace ricochet::simulate
