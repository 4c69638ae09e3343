// Where the bodies of a cluster are to each other, walls that move, and spheres that come and go.
#include "contact_rows.hpp"

#include <ricochet/motion/cluster.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ricochet {

void Cluster::set_wall_velocities(double when) noexcept {
  for (std::size_t w = 0; w < walls_.size(); ++w) state_.velocities[size() + w] = walls_[w].velocity(when);
}

// What the slip gains while a sphere flies on along a surface that is no fixed plane.
Vec3 Cluster::wall_turning(const ContactState& c, double time_on) const noexcept {
  const Motion& sphere = motions_[c.record.i];
  return motion::slip_gain(wall_of(c.record.j),
                           {.position = state_.half_positions[c.record.i],
                            .velocity = sphere.velocity,
                            .spin = sphere.spin,
                            .radius = radii_[c.record.i],
                            .wall_velocity = motions_[c.record.j].velocity},
                           middle(), time_on);
}

// The sphere gains P·V and couple·Ω, over what the relative motion books: V that of the surface, halfway.
double Cluster::wall_work(const ContactState& c, const ContactGeometry& g, double normal, const FrictionImpulse& f,
                          Vec3 before) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  if (j < size() || !wall_of(j).drives()) return 0;
  const Vec3 couple = f.torsion * g.normal + cross(g.normal, f.rolling);
  const Vec3 mean = wall_velocity(i, j) + 0.5 * (before - state_.velocities[j]);
  return dot(f.sliding - normal * g.normal, mean) + dot(couple, state_.spins[j]);
}

// Whether a wall has come nearer than the list of candidates allows for: half a skin, as for a sphere.
bool Cluster::walls_moved() noexcept {
  if (!walls_travel_) return false;
  return std::any_of(walls_.begin(), walls_.end(), [&](const motion::Surface& wall) {
    return wall.moved(walls_listed_at_, middle()) > 0.5 * neighbours_.skin() * (1 - 1e-9);
  });
}

// Over the last step, of a surface that has two sides.
bool Cluster::crossed(const ContactState& c) const noexcept {
  const std::uint32_t i = c.record.i, j = c.record.j;
  if (j < size() || !wall_of(j).two_sided()) return false;
  const double h = options_.step, then = middle() - h;
  const Vec3 way = h * state_.velocities[i], now = state_.half_positions[i];
  const motion::Surface& wall = wall_of(j);
  const ContactGeometry is = wall.meet(now, radii_[i], middle()), was = wall.meet(now - way, radii_[i], then);
  if (dot(is.normal, was.normal) >= 0) return false;
  // Over a hole the normal turns round as well, far from the surface: who goes through it was nearer than its way.
  const double distances = 2 * radii_[i] - is.overlap - was.overlap;
  return distances <= (norm(way) + wall.moved(then, middle())) * (1 + 1e-9);
}

void Cluster::add_sphere(const Sphere& s) {
  const auto at = static_cast<std::ptrdiff_t>(state_.half_positions.size());  // walls stand behind
  inverse_mass_.insert(inverse_mass_.begin() + at, 1 / s.mass());
  inverse_inertia_.insert(inverse_inertia_.begin() + at, 1 / s.inertia());
  materials_.insert(materials_.begin() + at, s.material);
  state_.velocities.insert(state_.velocities.begin() + at, s.velocity);
  state_.spins.insert(state_.spins.begin() + at, s.spin);
  state_.velocity_gains.emplace_back();
  state_.spin_gains.emplace_back();
  masses_.push_back(s.mass());
  inertias_.push_back(s.inertia());
  state_.half_positions.push_back(s.position + 0.5 * options_.step * s.velocity);
}

// Walls count on from the spheres.
void Cluster::renumber_walls(std::size_t spheres_before) {
  for (ContactState& c : contacts_)
    if (c.record.j >= spheres_before) c.record.j += static_cast<std::uint32_t>(size() - spheres_before);
}

void Cluster::add(std::span<const Sphere> spheres) {
  for (const Sphere& s : spheres) {
    check(s, size() + static_cast<std::size_t>(&s - spheres.data()) + 1);
    if (s.material >= material_count_)
      throw std::invalid_argument("sphere: must be of a material that the setup has, now or later");
  }
  const double before = energy().mechanical();
  const std::size_t there = size();
  for (const Sphere& s : spheres) {
    add_sphere(s);
    radii_.push_back(s.radius);
  }
  renumber_walls(there);
  sum_drags();
  neighbours_ = NeighbourList(radii_, neighbours_.skin(), periodic_.period);
  candidates_.clear(), closed_.clear(), ranges_.clear();
  state_.brought += energy().mechanical() - before;
}

void Cluster::remove(std::span<const std::uint32_t> leaving) {
  for (std::size_t k = 0; k < leaving.size(); ++k)
    if (leaving[k] >= size() || (k > 0 && leaving[k] <= leaving[k - 1]))
      throw std::invalid_argument("spheres to remove: must be there, in ascending order");
  const double before = energy().mechanical();
  const std::size_t there = size();
  std::vector<std::uint32_t> place(there + walls_.size());
  std::uint32_t kept = 0;
  constexpr auto gone = std::numeric_limits<std::uint32_t>::max();
  for (std::uint32_t i = 0; i < place.size(); ++i)
    place[i] = std::binary_search(leaving.begin(), leaving.end(), i) ? gone : kept++;
  const auto close_up = [&](auto& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (place[i] != gone) values[place[i]] = values[i];
    values.resize(values.size() - leaving.size());
  };
  std::vector<ContactState> lasting;
  lasting.reserve(contacts_.size());
  for (ContactState& c : contacts_) {
    if (place[c.record.i] == gone || place[c.record.j] == gone) {
      models_[c.model].normal->forget(c);
      finished_.push_back(c.record);
      continue;
    }
    c.record.i = place[c.record.i], c.record.j = place[c.record.j];
    lasting.push_back(c);
  }
  contacts_ = ContactList(std::move(lasting));
  for (auto* const of_bodies : {&inverse_mass_, &inverse_inertia_, &radii_, &masses_, &inertias_}) close_up(*of_bodies);
  for (auto* const of_bodies :
       {&state_.half_positions, &state_.velocities, &state_.spins, &state_.velocity_gains, &state_.spin_gains})
    close_up(*of_bodies);
  close_up(materials_);
  count_contacts();
  sum_drags();
  neighbours_ = NeighbourList(radii_, neighbours_.skin(), periodic_.period);
  candidates_.clear(), closed_.clear(), ranges_.clear();
  state_.brought += energy().mechanical() - before;
}

}  // namespace ricochet
