#include "walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

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

Polyline plane_face(std::size_t wall, const std::vector<HalfSpace>& planes, const Region& region) {
  // Wide enough to hold the whole region, however the plane lies in it.
  Polyline face = square(planes[wall], 0.5 * (region.low + region.high), norm(region.high - region.low));
  for (const HalfSpace& cut : around(region)) face = clipped(face, cut);
  for (std::size_t other = 0; other < planes.size(); ++other)
    if (other != wall) face = clipped(face, planes[other]);
  if (!face.empty()) face.push_back(face.front());
  return face;
}

/// Around the axis: rims of two radii, and lines from one to the other.
std::vector<Polyline> round_lines(Vec3 point, Vec3 axis, double length, double first, double last) {
  constexpr int corners = 72, lines_every = 6;
  const Polyline frame = square({{}, axis}, {}, 1);  // its corners stand at 45° to two directions across the axis
  const Vec3 u = 0.5 * (frame[0] - frame[1]), v = 0.5 * (frame[0] - frame[3]);
  Polyline near, far;
  std::vector<Polyline> lines;
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    const Vec3 out = std::cos(angle) * u + std::sin(angle) * v;
    near.push_back(point + first * out);
    far.push_back(point + length * axis + last * out);
    if (k < corners && k % lines_every == 0) lines.push_back({near.back(), far.back()});
  }
  if (first > 0) lines.push_back(near);
  if (last > 0) lines.push_back(far);
  return lines;
}

bool across(Vec3 axis, const HalfSpace& plane) { return std::abs(dot(plane.inward, axis)) > 1 - 1e-9; }

struct Drawn {
  const Wall& wall;
  Vec3 axis;
  const std::vector<HalfSpace>& planes;
  const Region& focus;

  std::vector<Polyline> operator()(const surface::Cylinder& form) const {
    // As far as the spheres go, or planes across the axis let it.
    double from = -std::numeric_limits<double>::infinity(), to = -from, low = to, high = from;
    for (const double x : {focus.low.x, focus.high.x})
      for (const double y : {focus.low.y, focus.high.y})
        for (const double z : {focus.low.z, focus.high.z}) {
          const double along = dot(Vec3{x, y, z} - wall.point, axis);
          low = std::min(low, along), high = std::max(high, along);
        }
    for (const HalfSpace& plane : planes)
      if (across(axis, plane)) {
        const double along = dot(plane.point - wall.point, axis);
        dot(plane.inward, axis) > 0 ? from = std::max(from, along) : to = std::min(to, along);
      }
    from = std::isfinite(from) ? from : low, to = std::isfinite(to) ? to : high;
    return round_lines(wall.point + from * axis, axis, to - from, form.radius, form.radius);
  }
  std::vector<Polyline> operator()(const surface::Cone& form) const {
    return round_lines(wall.point, axis, form.length, form.first, form.last);
  }
  std::vector<Polyline> operator()(const surface::Plate& form) const {
    const Vec3 a = wall.point, b = a + form.first, c = b + form.second, d = a + form.second;
    return {{a, b, c, d, a}};
  }
  std::vector<Polyline> operator()(const surface::Plane&) const { return {}; }  // drawn with the others
};

/// Whether a cylinder's own rim shows where the plane is.
bool ends_a_cylinder(const HalfSpace& plane, const std::vector<Wall>& walls) {
  return std::any_of(walls.begin(), walls.end(), [&](const Wall& w) {
    return std::holds_alternative<surface::Cylinder>(w.form) && across(w.inward / norm(w.inward), plane);
  });
}

}  // namespace

std::vector<WallOutline> wall_outlines(const std::vector<Wall>& walls, const Region& focus) {
  const Region region = reach_of(focus);
  std::vector<HalfSpace> planes;
  for (const Wall& wall : walls)
    if (std::holds_alternative<surface::Plane>(wall.form))
      planes.push_back({wall.point, wall.inward / norm(wall.inward)});
  std::vector<WallOutline> outlines;
  std::size_t plane = 0;
  for (const Wall& wall : walls) {
    const bool plate = std::holds_alternative<surface::Plate>(wall.form);
    WallOutline outline{{}, wall.point, plate ? Vec3{0, 0, 1} : wall.inward / norm(wall.inward), wall.motion};
    if (std::holds_alternative<surface::Plane>(wall.form)) {
      if (!ends_a_cylinder(planes[plane], walls)) outline.lines.push_back(plane_face(plane, planes, region));
      outline.motion.spin = 0;  // the plane is the same, and where it is cut does not turn
      ++plane;
    } else {
      outline.lines = std::visit(Drawn{wall, outline.axis, planes, focus}, wall.form);
    }
    outlines.push_back(outline);
  }
  return outlines;
}

Region with_walls(const Region& focus, const std::vector<WallOutline>& outlines) {
  const Region reach = reach_of(focus);
  const double near = 1e-9 * norm(reach.high - reach.low);
  const std::vector<HalfSpace> cuts = around(reach);
  const auto bounded = [&](Vec3 p) {
    return std::all_of(cuts.begin(), cuts.end(), [&](const HalfSpace& cut) { return cut.height(p) > near; });
  };
  Region all = focus;
  for (const WallOutline& outline : outlines)
    for (const Polyline& line : outline.lines)
      for (const Vec3 p : line)
        if (bounded(p)) {
          all.low = {std::min(all.low.x, p.x), std::min(all.low.y, p.y), std::min(all.low.z, p.z)};
          all.high = {std::max(all.high.x, p.x), std::max(all.high.y, p.y), std::max(all.high.z, p.z)};
        }
  return all;
}

}  // namespace ricochet::simulate
