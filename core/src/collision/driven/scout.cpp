#include "scout.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet::collision {
namespace {

constexpr double tolerance = 1e-4;   // local error of a step, relative to a component and its change
constexpr double first_step = 0.05;  // [T]
/// Slower than this at two points in a row the bodies count as never parting.
constexpr double creeping = 1e-13;

/// The larger component of what two halves of a step differ from the whole by, in tolerances.
double excess(const Instant& before, const Instant& whole, const Instant& halves) {
  const auto share = [](double from, double a, double b) {
    const double scale = std::abs(b) + std::abs(b - from);
    return a == b ? 0.0 : std::abs(a - b) / (tolerance * scale);
  };
  return std::max(share(before.overlap, whole.overlap, halves.overlap), share(before.rate, whole.rate, halves.rate));
}

/// Where a value falls to 0 on the way from one instant to the next, on a straight line.
double fallen(const Instant& from, const Instant& to, double before, double after) {
  return from.time + (to.time - from.time) * (before > after ? std::clamp(before / (before - after), 0.0, 1.0) : 1.0);
}

/// Notes in `found` what happens from one instant to the next; whether that decides the collision.
bool look(Scouted& found, const Instant& from, const Instant& to, ContactEnd end) {
  if (to.force > found.strongest.force) found.strongest = to;
  if (to.overlap > found.deepest.overlap) found.deepest = to;
  if (found.turn == 0) {
    if (found.rest.time == 0 && to.rate <= at_rest) {
      const double time = fallen(from, to, from.rate - at_rest, to.rate - at_rest);
      const double share = (time - from.time) / (to.time - from.time);
      found.rest = {time, from.overlap + share * (to.overlap - from.overlap), at_rest, to.force};
    }
    if (to.rate > 0) return false;
    found.turn = fallen(from, to, from.rate, to.rate);
  }
  if (to.rate > 0) {
    found.status = CollisionStatus::no_separation;
    return true;
  }
  const bool apart = to.overlap <= 0, slack = end == ContactEnd::force && to.force <= 0;
  if (!apart && !slack) return false;
  found.status = end == ContactEnd::force ? CollisionStatus::ended_by_force : CollisionStatus::ended_by_overlap;
  found.by_overlap = apart;
  found.end = apart ? fallen(from, to, from.overlap, to.overlap) : fallen(from, to, from.force, to.force);
  if (apart && slack) found.end = std::min(found.end, fallen(from, to, from.force, to.force));
  return true;
}

}  // namespace

Scouted scout(ScaledContact& contact, ContactEnd end, std::size_t budget, const Visit& visit) {
  Scouted found;
  Instant now = contact.touch();
  found.strongest = now;
  visit(now);
  double h = first_step;
  while (contact.evaluations() < budget) {
    contact.mark();
    const Instant whole = contact.step(now, h), half = contact.step(now, 0.5 * h);
    contact.accept();
    const Instant next = contact.step(half, 0.5 * h);
    const double error = excess(now, whole, next);
    const double factor = std::clamp(0.9 / std::cbrt(error), 0.2, 3.0);
    if (!(error <= 1)) {
      contact.back();
      h *= std::isfinite(error) ? factor : 0.2;
      if (now.time + h > now.time) continue;
      found.status = CollisionStatus::out_of_range;
      return found;
    }
    contact.accept();
    visit(next);
    if (look(found, now, half, end) || look(found, half, next, end)) return found;
    if (std::max(std::abs(now.rate), std::abs(next.rate)) < creeping || next.time > 1e100) {
      const bool fades = found.turn == 0 && found.rest.force > 0;
      found.status = fades ? CollisionStatus::permanent_contact : CollisionStatus::no_separation;
      return found;
    }
    now = next;
    h *= factor;
  }
  return found;
}

}  // namespace ricochet::collision
