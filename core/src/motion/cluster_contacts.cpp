// How contacts of a cluster begin and end.
#include "contact_rows.hpp"

#include <ricochet/motion/cluster.hpp>

#include <algorithm>

namespace ricochet {
namespace {

// How long ago the distance |D − Vs| was R, for spheres that now overlap, D² < R²: the positive root of a quadratic.
double time_since_touch(Vec3 D, Vec3 V, double R) noexcept {
  const double along = -dot(D, V), depth = std::max(0.0, R * R - dot(D, D)), v2 = dot(V, V);
  const double root = std::sqrt(along * along + v2 * depth);
  return along + root > 0 ? depth / (along + root) : Encounter::never;
}

// The same for spheres that now are apart again.
double time_since_separation(Vec3 D, Vec3 V, double R) noexcept {
  const double along = dot(D, V), gap = std::max(0.0, dot(D, D) - R * R), v2 = dot(V, V);
  const double root = std::sqrt(std::max(0.0, along * along - v2 * gap));
  return along + root > 0 ? gap / (along + root) : 0.0;
}

}  // namespace

void Cluster::list_candidates() {
  neighbours_.update(state_.half_positions);
  candidates_.clear();
  ++rebuilds_;
  walls_listed_at_ = middle();
  const auto pairs = neighbours_.pairs();
  std::size_t k = 0;
  for (std::uint32_t i = 0; i < size(); ++i) {
    for (; k < pairs.size() && pairs[k].i == i; ++k) candidates_.push_back(pairs[k]);
    for (std::uint32_t w = 0; w < walls_.size(); ++w)
      if (walls_[w].meet(state_.half_positions[i], radii_[i], middle()).overlap >= -neighbours_.skin())
        candidates_.push_back({i, static_cast<std::uint32_t>(size()) + w});
  }
  split();
  mark_closed();
}

// About as much work for each thread, whose the spheres are until the next list.
void Cluster::split() {
  const auto spheres = static_cast<std::uint32_t>(size());
  const std::size_t work = candidates_.size() + spheres;
  lowest_.assign(spheres, spheres);
  for (const auto [i, j] : candidates_)
    if (j < spheres) lowest_[j] = std::min(lowest_[j], i);
  losses_.resize((spheres + group_of_losses - 1) / group_of_losses);
  ranges_.resize(workers_ ? workers_->threads() : 1);
  std::uint32_t sphere = 0;
  std::size_t candidate = 0;
  for (std::size_t n = 0; n < ranges_.size(); ++n) {
    Range& range = ranges_[n];
    range.first = sphere, range.first_candidate = candidate;
    while (sphere < spheres && candidate + sphere < work * (n + 1) / ranges_.size()) {
      sphere = std::min(spheres, sphere + group_of_losses);
      while (candidate < candidates_.size() && candidates_[candidate].i < sphere) ++candidate;
    }
    range.last = sphere, range.last_candidate = candidate;
  }
}

inline bool Cluster::touches(std::uint32_t i, std::uint32_t j) const noexcept {
  if (j >= size()) return geometry(i, j).overlap > 0;
  const Vec3 d = branch(i, j);
  const double reach = radii_[i] + radii_[j];
  return dot(d, d) < reach * reach;
}

// Which candidates have met or parted; false: the list has to be made anew first.
bool Cluster::find_changed() {
  each_range([this](Range& range) {
    range.changed.clear();
    range.listed = neighbours_.lists(state_.half_positions, range.first, range.last);
    for (std::size_t k = range.first_candidate; k < range.last_candidate; ++k)
      if (touches(candidates_[k].i, candidates_[k].j) != (closed_[k] != 0)) range.changed.push_back(k);
  });
  return std::all_of(ranges_.begin(), ranges_.end(), [](const Range& range) { return range.listed; });
}

void Cluster::find_touching() {
  if (walls_moved() || ranges_.empty()) list_candidates();
  if (!find_changed()) {
    list_candidates();
    find_changed();
  }
  std::vector<ContactState> born;
  for (const Range& range : ranges_)
    for (const std::size_t k : range.changed) {
      if (closed_[k] == 0) {
        born.push_back(begin_contact(candidates_[k].i, candidates_[k].j));
        add_drag(born.back(), 1);
      } else {
        separated_.push_back(contacts_.place_of(candidates_[k]));
      }
      closed_[k] = closed_[k] == 0 ? 1 : 0;
    }
  if (!separated_.empty() || !born.empty()) exchange(born);
}

void Cluster::count_contacts() noexcept {
  for (Model& model : models_) model.contacts = 0;
  for (const ContactState& c : contacts_) ++models_[c.model].contacts;
}

// Candidates and contacts are both in the order of their pairs. A contact that is no candidate has flown apart by more
// than the skin.
void Cluster::mark_closed() {
  closed_.assign(candidates_.size(), 0);
  separated_.clear();
  std::size_t near = 0;
  for (std::uint32_t k = 0; k < contacts_.size(); ++k) {
    const NearPair pair = pair_of(contacts_[k]);
    while (near < candidates_.size() && candidates_[near] < pair) ++near;
    if (near < candidates_.size() && candidates_[near] == pair)
      closed_[near] = 1;
    else
      separated_.push_back(k);
  }
}

ContactState Cluster::begin_contact(std::uint32_t i, std::uint32_t j) {
  const double h = options_.step;
  const Vec3 v = relative_velocity(i, j);
  const ContactGeometry now = geometry(i, j);
  const double longest = state_.steps == 0 ? 0.5 * h : h;  // nobody touched before time 0
  ContactState c;
  c.record.i = i, c.record.j = j;
  c.model = model_of(i, j);
  if (j < size()) {
    const Vec3 d = branch(i, j);
    c.lag = std::min(longest, time_since_touch(d, -v, radii_[i] + radii_[j]));
    const Vec3 at_touch = d + c.lag * v;
    const double distance = norm(at_touch);
    c.approach = {radii_[i] + radii_[j] - distance, distance > 0 ? dot(v, at_touch) / distance : dot(v, now.normal)};
  } else {
    const double rate = dot(v, now.normal);
    c.lag = rate > 0 ? std::min(longest, now.overlap / rate) : longest;
    c.approach = {now.overlap - rate * c.lag, rate};
  }
  const bool overlapped_at_start = state_.steps == 0 && c.lag == longest;
  if (!overlapped_at_start) c.approach.overlap = 0;  // what is left is rounding
  c.record.begin = std::max(0.0, middle() - c.lag);
  c.record.phase_begin[static_cast<std::size_t>(Phase::compression)] = c.record.begin;
  models_[c.model].normal->begin(c);
  c.fresh = !overlapped_at_start;  // who rests on another since before time 0 has not just touched it
  const Vec3 surface = now.arm_i * state_.spins[i] + now.arm_j * state_.spins[j];
  c.speed_scale = norm(v) + norm(surface) + std::sqrt(norm(gravity_) * (now.arm_i + now.arm_j));
  return c;
}

void Cluster::finish(ContactState& c, const ContactGeometry& g) {
  const std::uint32_t i = c.record.i, j = c.record.j;
  const double h = options_.step;
  const Vec3 v = relative_velocity(i, j);
  const double rate = dot(v, g.normal);
  double since =
      j < size() ? time_since_separation(branch(i, j), -v, radii_[i] + radii_[j]) : (rate < 0 ? g.overlap / rate : 0.0);
  since = std::min(since, h);
  c.record.separation = time() + 0.5 * h - since;
  if (c.record.end == Encounter::never) {
    // From the memory's time to the separation the force is taken as linear; where it became attractive, (25) came
    // first.
    const double span = std::max(0.0, c.lag - since);
    const double at_separation = models_[c.model].normal->force_at(c, {0, rate}, span);
    const bool by_force = models_[c.model].end == ContactEnd::force && c.force > 0 && at_separation < 0;
    c.record.end = c.record.separation - (by_force ? span * at_separation / (at_separation - c.force) : 0.0);
    c.record.how = by_force ? EncounterEnd::deformed_rebound : EncounterEnd::elastic_rebound;
    // The last impulse covered the time up to t_n; the force lasted until t_e.
    const double rest = c.record.end - time();
    const double slope = span > 0 ? (at_separation - c.force) / span : 0.0;
    const double impulse = by_force ? -0.5 * slope * rest * std::max(0.0, rest) : at_separation * rest;
    push(c, g, impulse);
    state_.wall_work += wall_work(c, g, impulse, {}, state_.velocities[j]);
    state_.lost_normal += impulse * rate;
  }
  state_.lost_normal += c.stored;  // what the memory still held is forgotten
  state_.lost_friction += c.strained;
  models_[c.model].normal->forget(c);
  if (options_.records) finished_.push_back(c.record);
}

// Ends those that are separated, takes in those that are born.
void Cluster::exchange(const std::vector<ContactState>& born) {
  std::sort(separated_.begin(), separated_.end());
  for (const std::uint32_t k : separated_) {
    ContactState& c = contacts_[k];
    add_drag(c, -1);
    --models_[c.model].contacts;
    finish(c, geometry(c.record.i, c.record.j));
  }
  for (const ContactState& c : born) ++models_[c.model].contacts;
  contacts_.exchange(separated_, born);
  separated_.clear();
}

}  // namespace ricochet
