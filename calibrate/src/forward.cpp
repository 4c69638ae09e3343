#include "forward.hpp"

#include "solution.hpp"

#include <ricochet/contact/fractional_contact.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::calibration {

using detail::Panel;

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

ForwardFractional::ForwardFractional() {
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    Panel::Row en{}, tau{};
    for (std::size_t j = 0; j < Panel::size; ++j) {
      const auto c = fractional_contact(Panel::abscissa(j, edges[i], edges[i + 1]));
      en[j] = c.en;
      tau[j] = c.tau;
    }
    panels_.push_back({Panel(en, edges[i], edges[i + 1]), Panel(tau, edges[i], edges[i + 1])});
  }
}

Reduced ForwardFractional::operator()(double alpha) const {
  if (alpha >= edges.back()) {
    const auto c = fractional_contact(std::min(alpha, 0.999));
    return {c.en, c.tau};
  }
  const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, alpha);
  const Pair& panel = panels_[static_cast<std::size_t>(above - edges.begin()) - 1];
  return {panel.en(alpha), panel.tau(alpha)};
}

}  // namespace ricochet::calibration
