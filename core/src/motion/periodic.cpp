#include <ricochet/motion/periodic.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>

namespace ricochet {
namespace {

// Spheres brought into the cell from 0 on, then copies of those near its low sides, beyond the high ones.
struct Unrolled {
  std::vector<Vec3> positions;
  std::vector<double> radii;
  std::vector<std::uint32_t> whose;

  void bring_home(double Vec3::*axis, double period) {
    for (Vec3& p : positions) p.*axis -= period * std::floor(p.*axis / period);
  }
  void repeat(double Vec3::*axis, double period, double reach) {
    for (std::size_t k = 0, n = positions.size(); k < n; ++k) {
      if (positions[k].*axis > reach) continue;
      Vec3 copy = positions[k];
      copy.*axis += period;
      positions.push_back(copy), radii.push_back(radii[k]), whose.push_back(whose[k]);
    }
  }
};

}  // namespace

std::vector<NearPair> near_pairs(std::span<const Vec3> positions, std::span<const double> radii, double skin,
                                 const Periodic& periodic) {
  if (!periodic.any() || positions.empty()) return near_pairs(positions, radii, skin);
  Unrolled all{{positions.begin(), positions.end()}, {radii.begin(), radii.end()}, {}};
  for (std::uint32_t k = 0; k < positions.size(); ++k) all.whose.push_back(k);
  // A hair more, for what bringing home rounds away.
  const double reach = (2 * *std::max_element(radii.begin(), radii.end()) + skin) * (1 + 1e-6);
  for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const double period = periodic.period.*axis;
    if (period == 0) continue;
    support::require(period > 2 * reach, "period", period, "0 or more than 4 of the greatest radius and two skins");
    all.bring_home(axis, period);
    all.repeat(axis, period, reach);
  }
  std::vector<NearPair> pairs = near_pairs(all.positions, all.radii, skin * (1 + 1e-9));
  for (NearPair& p : pairs) {
    const auto [i, j] = std::minmax(all.whose[p.i], all.whose[p.j]);
    p = {i, j};
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace ricochet
