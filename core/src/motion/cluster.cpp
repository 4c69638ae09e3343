#include "contact_rows.hpp"

#include <ricochet/motion/cluster.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ricochet {

using support::require;

std::string_view name(EncounterEnd end) noexcept {
  constexpr std::string_view names[] = {"open",
                                        "elastic rebound",
                                        "rebound with deformation",
                                        "dynamic contact",
                                        "static contact",
                                        "permanent contact",
                                        "breakage"};
  static_assert(std::size(names) == encounter_end_count);
  return names[static_cast<std::size_t>(end)];
}

std::string_view name(Phase phase) noexcept {
  constexpr std::string_view names[] = {"compression", "decompression", "torsion", "sliding", "rolling", "static"};
  return names[static_cast<std::size_t>(phase)];
}

namespace {

constexpr std::uint32_t no_model = std::numeric_limits<std::uint32_t>::max();

std::vector<double> radii_of(const ClusterSetup& setup) {
  check(setup);  // first of all, as everything else reads the setup
  std::vector<double> radii;
  radii.reserve(setup.spheres.size());
  for (const Sphere& s : setup.spheres) radii.push_back(s.radius);
  return radii;
}

double skin_of(const ClusterSetup& setup, const ClusterOptions& options) {
  support::require_not_negative("skin", options.skin);
  if (options.skin > 0 || setup.spheres.empty()) return options.skin;
  const std::vector<double> radii = radii_of(setup);
  return *std::min_element(radii.begin(), radii.end()) / 3;
}

}  // namespace

Cluster::Cluster(const ClusterSetup& setup, const ClusterOptions& options)
    : options_(options),
      gravity_(setup.gravity),
      long_range_(setup.long_range),
      radii_(radii_of(setup)),
      periodic_(setup.periodic),
      neighbours_(radii_, skin_of(setup, options), periodic_.period) {
  support::require_positive("step", options.step);
  support::require_not_negative("longest_contact", options.longest_contact);
  const double tolerance = options.kernel_tolerance;
  require(tolerance >= 1e-12 && tolerance <= 0.1, "kernel_tolerance", tolerance, "in [1e-12, 0.1]");
  support::require_positive("solver_tolerance", options.solver_tolerance);
  require(options.max_sweeps >= 1, "max_sweeps", options.max_sweeps, "at least 1");
  require(options.threads >= 1 && options.threads <= 256, "threads", options.threads, "in [1, 256]");
  if (options.threads > 1) workers_ = std::make_unique<motion::Workers>(static_cast<std::size_t>(options.threads));
  add_bodies(setup);
  add_models(setup.interactions);
  find_touching();  // who overlaps at the start
}

void Cluster::add_bodies(const ClusterSetup& setup) {
  for (const Sphere& s : setup.spheres) add_sphere(s);
  for (const Wall& w : setup.walls) {
    walls_.emplace_back(w);
    walls_travel_ = walls_travel_ || walls_.back().travels();
    walls_swing_ = walls_swing_ || walls_.back().swings();
    walls_drive_ = walls_drive_ || walls_.back().drives();
    inverse_mass_.push_back(0);
    inverse_inertia_.push_back(0);
    materials_.push_back(w.material);
    state_.velocities.push_back({});
    state_.spins.push_back(walls_.back().spin());
  }
  set_wall_velocities(0);
  drags_.assign(inverse_mass_.size(), 0);
  for (std::size_t m : materials_) material_count_ = std::max(material_count_, m + 1);
  for (const Sphere& s : setup.later) material_count_ = std::max(material_count_, s.material + 1);
}

void Cluster::add_models(const Interactions& interactions) {
  model_table_.assign(material_count_ * material_count_, no_model);
  KernelsMade made;
  for (const auto& [pair, interaction] : interactions) {
    if (pair.first >= material_count_ || pair.second >= material_count_) continue;
    model_table_[pair.first * material_count_ + pair.second] = static_cast<std::uint32_t>(models_.size());
    model_table_[pair.second * material_count_ + pair.first] = static_cast<std::uint32_t>(models_.size());
    auto normal = interaction.law.contacts(
        {options_.step, interaction.end, options_.longest_contact, options_.kernel_tolerance, &made});
    kernel_error_ = std::max(kernel_error_, normal->kernel_error());
    const TangentialContact tangential{interaction.tangential, interaction.friction, interaction.torsion,
                                       interaction.rolling};
    Model& model = models_.emplace_back(Model{tangential,
                                              false,
                                              false,
                                              interaction.end,
                                              interaction.breakage_energy,
                                              normal->constant_drag(),
                                              0,
                                              0,
                                              std::move(normal),
                                              0,
                                              {}});
    model.compliant =
        compliant(interaction.tangential) && model.rubs();  // where all limits are 0 no spring is strained
    has_springs_ = has_springs_ || model.compliant;
    drags_vary_ = drags_vary_ || !model.drag;
    if (!model.compliant) continue;
    model.turns = motion::compliant::turns(tangential);
    model.damping = spring(interaction.tangential, 0).damping;
    model.turning_damping = std::max(interaction.torsion.spring.damping, interaction.rolling.spring.damping);
  }
}

std::uint32_t Cluster::model_of(std::uint32_t i, std::uint32_t j) const noexcept {
  return model_table_[materials_[i] * material_count_ + materials_[j]];
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
  for (const ContactState& c : contacts_) e.stored += c.stored, e.strained += c.strained;
  e.lost_normal = state_.lost_normal;
  e.lost_friction = state_.lost_friction;
  e.long_range_work = state_.long_range_work;
  e.wall_work = state_.wall_work;
  e.brought = state_.brought;
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

ClusterState Cluster::state() const {
  ClusterState state = state_;
  state.contacts = contacts_.in_order();
  for (const ContactState& c : contacts_) {
    const motion::NormalContacts& normal = *models_[c.model].normal;
    ContactMemory memory{std::string(normal.law()), std::vector<double>(normal.memory_size())};
    normal.save(c, memory.values);
    state.memories.push_back(std::move(memory));
  }
  return state;
}

void Cluster::check_contacts(const ClusterState& state) const {
  if (state.memories.size() != state.contacts.size())
    throw std::invalid_argument("state: must have one memory a contact");
  std::pair<std::uint32_t, std::uint32_t> last{0, 0};  // of no contact, as i < j
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    const std::pair pair(state.contacts[k].record.i, state.contacts[k].record.j);
    if (!(last < pair && pair.first < pair.second && pair.first < size() && pair.second < size() + walls_.size()))
      throw std::invalid_argument("state: must have contacts of the same spheres and walls, ordered by pair");
    last = pair;
    const motion::NormalContacts& normal = *models_[model_of(pair.first, pair.second)].normal;
    const auto described = [](std::string_view law, std::size_t values) {
      return std::string(law) + " with " + std::to_string(values) + " numbers";
    };
    const ContactMemory& memory = state.memories[k];
    if (memory.law != normal.law() || memory.values.size() != normal.memory_size())
      throw std::invalid_argument("state: memory of bodies " + std::to_string(pair.first) + " and " +
                                  std::to_string(pair.second) + " = " + described(memory.law, memory.values.size()) +
                                  ": must be " + described(normal.law(), normal.memory_size()));
  }
}

void Cluster::restore(ClusterState state) {
  if (state.half_positions.size() != size() || state.velocities.size() != size() + walls_.size() ||
      state.spins.size() != state.velocities.size())
    throw std::invalid_argument("state: must be of the same spheres and walls");
  for (std::vector<Vec3>* gains : {&state.velocity_gains, &state.spin_gains}) {
    if (gains->empty()) gains->resize(size());
    if (gains->size() != size()) throw std::invalid_argument("state: must have one gain a sphere, or none");
  }
  check_contacts(state);
  for (const ContactState& c : contacts_) models_[c.model].normal->forget(c);
  state_ = std::move(state);
  contacts_ = ContactList(std::exchange(state_.contacts, {}));
  for (std::size_t w = 0; w < walls_.size(); ++w) state_.spins[size() + w] = walls_[w].spin();
  set_wall_velocities(time());
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    ContactState& c = contacts_[k];
    c.model = model_of(c.record.i, c.record.j);
    models_[c.model].normal->restore(c, state_.memories[k].values);
  }
  state_.memories.clear();
  count_contacts();
  mark_closed();
  sum_drags();
}

std::optional<Breakthrough> Cluster::breakthrough() const noexcept {
  for (const ContactState& c : contacts_) {
    const auto [i, j] = std::pair(c.record.i, c.record.j);
    const double radius = j < size() ? std::min(radii_[i], radii_[j]) : radii_[i];
    const bool across = crossed(c);
    if (c.approach.overlap > Breakthrough::share * radius || across)
      return Breakthrough{i, j, norm(relative_velocity(i, j)), across ? 1 : Breakthrough::share};
  }
  for (std::uint32_t i = 0; i < size(); ++i)
    if (const double speed = norm(state_.velocities[i]); speed * options_.step > radii_[i])
      return Breakthrough{.i = i, .j = i, .speed = speed};
  return std::nullopt;
}

}  // namespace ricochet
