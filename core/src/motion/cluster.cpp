#include <ricochet/motion/cluster.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>
#include <stdexcept>

namespace ricochet {

using support::require;

std::string_view name(EncounterEnd end) noexcept {
  constexpr std::string_view names[] = {"open", "elastic rebound", "rebound with deformation", "dynamic contact",
                                        "static contact"};
  return names[static_cast<std::size_t>(end)];
}

std::string_view name(Phase phase) noexcept {
  constexpr std::string_view names[] = {"compression", "decompression", "torsion", "sliding", "rolling", "static"};
  return names[static_cast<std::size_t>(phase)];
}

namespace {

std::vector<double> radii_of(const ClusterSetup& setup) {
  check(setup);  // first of all, as everything else reads the setup
  std::vector<double> radii;
  for (const Sphere& s : setup.spheres) radii.push_back(s.radius);
  return radii;
}

double skin_of(const ClusterSetup& setup, const ClusterOptions& options) {
  support::require_not_negative("skin", options.skin);
  if (options.skin > 0 || setup.spheres.empty()) return options.skin;
  const std::vector<double> radii = radii_of(setup);
  return *std::min_element(radii.begin(), radii.end()) / 3;
}

MemoryKernel kernel_for(double alpha, const ClusterOptions& o) {
  const double shortest = 0.5 * o.step, longest = o.longest_contact > 0 ? o.longest_contact : 1e4 * o.step;
  require(longest <= 1e6 * shortest, "longest_contact", longest, "at most 5e5 steps with a fractional law");
  return affordable_kernel(alpha, {shortest, std::max(longest, shortest), o.kernel_tolerance},
                           FractionalArms::max_arms);
}

}  // namespace

Cluster::Model Cluster::prepare_model(const Interaction& interaction) {
  const double h = options_.step;
  RunLaw law = std::visit(
      [&]<class Law>(const Law& l) -> RunLaw {
        if constexpr (std::same_as<Law, Fractional>) {
          const MemoryKernel kernel = kernel_for(l.alpha(), options_);
          kernel_error_ = std::max(kernel_error_, kernel.error());
          return FractionalArms(l, kernel, h);
        } else {
          return l;
        }
      },
      interaction.law);
  double gain = 0;
  if (const auto* arms = std::get_if<FractionalArms>(&law)) {
    FractionalArms::Memory memory;
    arms->advance(memory, {0, 0}, {0, 1}, h);
    gain = arms->force({0, 1}, memory);
  }
  return {law, interaction.friction, interaction.end, gain};
}

Cluster::Cluster(const ClusterSetup& setup, const ClusterOptions& options)
    : options_(options),
      gravity_(setup.gravity),
      long_range_(setup.long_range),
      radii_(radii_of(setup)),
      neighbours_(radii_, skin_of(setup, options)) {
  support::require_positive("step", options.step);
  support::require_not_negative("longest_contact", options.longest_contact);
  const double tolerance = options.kernel_tolerance;
  require(tolerance >= 1e-12 && tolerance <= 0.1, "kernel_tolerance", tolerance, "in [1e-12, 0.1]");
  support::require_positive("solver_tolerance", options.solver_tolerance);
  require(options.max_sweeps >= 1, "max_sweeps", options.max_sweeps, "at least 1");
  for (const Sphere& s : setup.spheres) {
    masses_.push_back(s.mass());
    inertias_.push_back(s.inertia());
    inverse_mass_.push_back(1 / s.mass());
    inverse_inertia_.push_back(1 / s.inertia());
    materials_.push_back(s.material);
    state_.half_positions.push_back(s.position + 0.5 * options.step * s.velocity);
    state_.velocities.push_back(s.velocity);
    state_.spins.push_back(s.spin);
  }
  for (const Wall& w : setup.walls) {
    walls_.push_back({w.point, w.inward / norm(w.inward)});
    inverse_mass_.push_back(0);
    inverse_inertia_.push_back(0);
    materials_.push_back(w.material);
    state_.velocities.push_back({});
    state_.spins.push_back({});
  }
  for (std::size_t m : materials_) material_count_ = std::max(material_count_, m + 1);
  model_table_.assign(material_count_ * material_count_, 0);
  for (const auto& [pair, interaction] : setup.interactions) {
    if (pair.first >= material_count_ || pair.second >= material_count_) continue;
    model_table_[pair.first * material_count_ + pair.second] = static_cast<std::uint32_t>(models_.size());
    model_table_[pair.second * material_count_ + pair.first] = static_cast<std::uint32_t>(models_.size());
    models_.push_back(prepare_model(interaction));
  }
}

std::uint32_t Cluster::model_of(std::uint32_t i, std::uint32_t j) const noexcept {
  return model_table_[materials_[i] * material_count_ + materials_[j]];
}

ContactGeometry Cluster::geometry(std::uint32_t i, std::uint32_t j) const noexcept {
  const Vec3 xi = state_.half_positions[i];
  if (j < size()) return sphere_sphere(xi, radii_[i], state_.half_positions[j], radii_[j]);
  const PlaneWall& wall = walls_[j - size()];
  return sphere_wall(xi, radii_[i], wall.point, wall.inward);
}

Vec3 Cluster::relative_velocity(std::uint32_t i, std::uint32_t j) const noexcept {
  return state_.velocities[i] - state_.velocities[j];
}

Vec3 Cluster::position(std::size_t i) const noexcept {
  return state_.half_positions[i] - 0.5 * options_.step * state_.velocities[i];
}

bool Cluster::advance(std::uint64_t steps) {
  for (std::uint64_t n = 0; n < steps; ++n) step();
  const auto finite = [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  return std::all_of(state_.half_positions.begin(), state_.half_positions.end(), finite) &&
         std::all_of(state_.velocities.begin(), state_.velocities.end(), finite) &&
         std::all_of(state_.spins.begin(), state_.spins.end(), finite);
}

ClusterEnergy Cluster::energy() const noexcept {
  ClusterEnergy e;
  for (std::size_t i = 0; i < size(); ++i) {
    e.kinetic += 0.5 * masses_[i] * dot(velocity(i), velocity(i)) + 0.5 * inertias_[i] * dot(spin(i), spin(i));
    e.gravity -= masses_[i] * dot(gravity_, position(i));
  }
  for (const ContactState& c : state_.contacts) e.stored += c.stored;
  e.lost_normal = state_.lost_normal;
  e.lost_friction = state_.lost_friction;
  e.long_range_work = state_.long_range_work;
  return e;
}

Vec3 Cluster::momentum() const noexcept {
  Vec3 sum;
  for (std::size_t i = 0; i < size(); ++i) sum += masses_[i] * velocity(i);
  return sum;
}

Vec3 Cluster::angular_momentum() const noexcept {
  Vec3 sum;
  for (std::size_t i = 0; i < size(); ++i) sum += masses_[i] * cross(position(i), velocity(i)) + inertias_[i] * spin(i);
  return sum;
}

std::vector<Encounter> Cluster::take_finished() { return std::exchange(finished_, {}); }

void Cluster::restore(ClusterState state) {
  if (state.half_positions.size() != size() || state.velocities.size() != size() + walls_.size() ||
      state.spins.size() != state.velocities.size())
    throw std::invalid_argument("state: must be of the same spheres and walls");
  for (const ContactState& c : state.contacts)
    if (c.record.i >= size() || c.record.j >= size() + walls_.size() || c.model >= models_.size())
      throw std::invalid_argument("state: must have contacts of the same spheres, walls and interactions");
  state_ = std::move(state);
}

}  // namespace ricochet
