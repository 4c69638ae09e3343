#pragma once

#include <simulate/scene.hpp>

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace ricochet::simulate {

/// Which spheres of the scene are there, in the order in which the cluster counts them: more come, some leave.
class Roster {
 public:
  explicit Roster(const Scene& scene) : scene_(&scene), who_(scene.setup.spheres.size()) {
    std::iota(who_.begin(), who_.end(), 0u);
  }

  std::size_t size() const noexcept { return who_.size(); }
  const std::vector<std::uint32_t>& who() const noexcept { return who_; }
  std::vector<std::uint32_t>& who() noexcept { return who_; }
  const Sphere& sphere(std::size_t k) const noexcept { return scene_->sphere(who_[k]); }
  const std::string& material(std::size_t k) const noexcept { return scene_->materials[scene_->stuff[who_[k]]]; }
  /// Of a body as the cluster counts them: a sphere's number in the scene, from 1, or a wall's name.
  std::string name(std::size_t body) const {
    return body < who_.size() ? std::to_string(who_[body] + 1) : scene_->wall_names[body - who_.size()];
  }

 private:
  const Scene* scene_;
  std::vector<std::uint32_t> who_;
};

}  // namespace ricochet::simulate
