#pragma once

#include "../paper.hpp"

#include <console/plot.hpp>
#include <ricochet/collision/peer_damping.hpp>

#include <string_view>
#include <vector>

namespace ricochet::verify::peers {

/// Any pair would do: the restitution of both laws depends on β alone.
inline constexpr Impact impact = paper::pair.impact;

/// e_n asked: 0.05, 0.06, … 0.99.
std::vector<double> asked_restitutions();

/// What one peer makes of the restitutions asked.
struct Curve {
  PeerDamping peer;
  std::vector<double> obtained = {};  ///< over asked_restitutions()
  double worst = 0;                   ///< greatest |obtained − asked|
  double worst_at = 0;                ///< where, e_n asked
  double worst_relative = 0;          ///< greatest |obtained/asked − 1|
  double closed_form = 0;             ///< greatest relative difference from the closed form of damping_ratio.hpp
};

Curve measure(const PeerDamping& peer, const std::vector<double>& asked);

/// The curve of the peer with that id.
const Curve& find(const std::vector<Curve>& curves, std::string_view id);

/// Restitution obtained less asked, one curve for each formula and end that differs from the others.
console::Figure error_figure(const std::vector<Curve>& curves, const std::vector<double>& asked);

}  // namespace ricochet::verify::peers
