#include "forward.hpp"

#include "solution.hpp"

#include <ricochet/collision/fractional_contact.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::calibration {

using support::Panel;

namespace {

Reduced collided(LawName law, ContactEnd end, double log_group) {
  const auto out = unit_collision(law, {0, log_group}, end);
  return {out.en, out.tcol};
}

}  // namespace

ForwardDamped::ForwardDamped(LawName law, ContactEnd end) : law_(law), end_(end) {
  for (std::size_t i = 0; i < count; ++i) {
    const double from = low + static_cast<double>(i) * width, to = from + width;
    Panel::Row en{}, tcol{};
    bool parted = true;
    for (std::size_t j = 0; j < Panel::size; ++j) {
      const Reduced r = collided(law, end, Panel::abscissa(j, from, to));
      en[j] = r.en;
      tcol[j] = r.tcol;
      parted = parted && r.tcol > 0;
    }
    if (!parted) break;
    panels_.push_back({Panel(en, from, to), Panel(tcol, from, to)});
  }
}

Reduced ForwardDamped::operator()(double log_group) const {
  const double place = (log_group - low) / width;
  if (!(place >= 0 && place < static_cast<double>(panels_.size()))) return collided(law_, end_, log_group);
  const Pair& panel = panels_[static_cast<std::size_t>(place)];
  return {panel.en(log_group), panel.tcol(log_group)};
}

ForwardFractional::ForwardFractional(ContactEnd end)
    : end_(end),
      edges_(end == ContactEnd::force ? std::vector{0.0, 0.25, 0.5, 0.7, 0.82, 0.89, 0.94, 0.97}
                                      : std::vector{0.02, 0.1, 0.3, 0.6, 1.0}) {
  const auto alpha_at = [&](double x) { return end == ContactEnd::force ? x : overlap_limit * (1 - x) * (1 + x); };
  for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
    Panel::Row en{}, tau{};
    for (std::size_t j = 0; j < Panel::size; ++j) {
      const auto c = fractional_contact(alpha_at(Panel::abscissa(j, edges_[i], edges_[i + 1])), end);
      en[j] = c.en;
      tau[j] = c.tau;
    }
    panels_.push_back({Panel(en, edges_[i], edges_[i + 1]), Panel(tau, edges_[i], edges_[i + 1])});
  }
}

double ForwardFractional::variable(double alpha) const {
  return end_ == ContactEnd::force ? alpha : std::sqrt(1 - alpha / overlap_limit);
}

Reduced ForwardFractional::operator()(double alpha) const {
  const double x = variable(alpha);
  if (!(x >= edges_.front() && x <= edges_.back())) {
    const auto c = fractional_contact(alpha, end_);
    return {c.en, c.tau};
  }
  const auto above = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, x);
  const Pair& panel = panels_[static_cast<std::size_t>(above - edges_.begin()) - 1];
  return {panel.en(x), panel.tau(x)};
}

}  // namespace ricochet::calibration
