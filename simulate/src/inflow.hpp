#pragma once

#include "roster.hpp"

#include <cstdint>
#include <vector>

namespace ricochet::simulate {

/// Who comes and who leaves while a scene runs. What it does at a step follows from the scene, the step and the bodies
/// alone, so that a run which is taken up again goes on as it would have.
class Inflow {
 public:
  /// Steps between two looks.
  static constexpr std::uint64_t look_every = 20;

  explicit Inflow(const Scene& scene) : scene_(&scene), brought_(scene.pours.size()) {}

  bool any() const noexcept { return !scene_->pours.empty() || !scene_->outlets.empty(); }
  bool due(std::uint64_t step) const noexcept { return any() && step % look_every == 0; }

  /// Spheres behind an outlet, ascending.
  std::vector<std::uint32_t> leaving(const Cluster& cluster) const;
  /// Takes them from the roster.
  static void strike(const std::vector<std::uint32_t>& leaving, Roster& roster);
  /// Brings spheres that are due and find room.
  void bring(Cluster& cluster, Roster& roster);

  /// How many each pour has brought.
  const std::vector<std::uint64_t>& brought() const noexcept { return brought_; }
  void set_brought(std::vector<std::uint64_t> brought) { brought_ = std::move(brought); }
  /// How many are due at a time and have found no room.
  std::uint64_t waiting(double time) const noexcept;

 private:
  static std::uint64_t due_of(const Pour& pour, double time) noexcept;

  const Scene* scene_;
  std::vector<std::uint64_t> brought_;
};

}  // namespace ricochet::simulate
