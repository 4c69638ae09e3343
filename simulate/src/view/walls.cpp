#include "walls.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet::simulate {
namespace {

/// All points p with (p − point)·inward ≥ 0; `inward` is a unit vector.
struct HalfSpace {
  Vec3 point, inward;
  double height(Vec3 p) const { return dot(p - point, inward); }
};

/// What of a polygon lies in the half-space, by Sutherland and Hodgman's walk around its edges.
Polyline clipped(const Polyline& polygon, const HalfSpace& side) {
  Polyline inside;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    const double over_a = side.height(a), over_b = side.height(b);
    if (over_a >= 0) inside.push_back(a);
    if ((over_a >= 0) != (over_b >= 0)) inside.push_back(a + over_a / (over_a - over_b) * (b - a));
  }
  return inside;
}

Polyline square(const HalfSpace& wall, Vec3 around, double half_edge) {
  const Vec3 n = wall.inward, centre = around - wall.height(around) * n;
  const Vec3 helper = std::abs(n.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = half_edge / norm(cross(n, helper)) * cross(n, helper), v = cross(n, u);
  return {centre + u + v, centre - u + v, centre - u - v, centre + u - v};
}

// Where walls that nothing bounds are cut.
Region reach_of(const Region& focus) {
  const Vec3 extent = focus.high - focus.low;
  const double margin = 0.25 * std::max({extent.x, extent.y, extent.z});
  const Vec3 room = {margin, margin, margin};
  return {focus.low - room, focus.high + room};
}

std::vector<HalfSpace> around(const Region& r) {
  return {{r.low, {1, 0, 0}},   {r.low, {0, 1, 0}},   {r.low, {0, 0, 1}},
          {r.high, {-1, 0, 0}}, {r.high, {0, -1, 0}}, {r.high, {0, 0, -1}}};
}

}  // namespace

std::vector<Polyline> wall_outlines(const std::vector<Wall>& walls, const Region& focus) {
  const Region region = reach_of(focus);
  std::vector<HalfSpace> planes;
  planes.reserve(walls.size());
  for (const Wall& wall : walls) planes.push_back({wall.point, wall.inward / norm(wall.inward)});
  const std::vector<HalfSpace> cuts = around(region);
  std::vector<Polyline> outlines;
  for (std::size_t w = 0; w < planes.size(); ++w) {
    // Wide enough to hold the whole region, however the plane lies in it.
    Polyline face = square(planes[w], 0.5 * (region.low + region.high), norm(region.high - region.low));
    for (const HalfSpace& cut : cuts) face = clipped(face, cut);
    for (std::size_t other = 0; other < planes.size(); ++other)
      if (other != w) face = clipped(face, planes[other]);
    if (face.size() < 3) continue;
    face.push_back(face.front());
    outlines.push_back(face);
  }
  return outlines;
}

Region with_walls(const Region& focus, const std::vector<Polyline>& outlines) {
  const Region reach = reach_of(focus);
  const double near = 1e-9 * norm(reach.high - reach.low);
  Region all = focus;
  for (const Polyline& outline : outlines)
    for (const Vec3 p : outline) {
      const std::vector<HalfSpace> cuts = around(reach);
      if (std::any_of(cuts.begin(), cuts.end(), [&](const HalfSpace& cut) { return cut.height(p) < near; })) continue;
      all.low = {std::min(all.low.x, p.x), std::min(all.low.y, p.y), std::min(all.low.z, p.z)};
      all.high = {std::max(all.high.x, p.x), std::max(all.high.y, p.y), std::max(all.high.z, p.z)};
    }
  return all;
}

}  // namespace ricochet::simulate
