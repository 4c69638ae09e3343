#include "document.hpp"
#include "pack.hpp"

#include <console/html.hpp>
#include <console/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::simulate {
namespace {

using console::Json;

// Where 16 bits would move the smallest sphere by more than this share of its radius, places take 32.
constexpr double visible_share = 0.005;

Json array_of(Vec3 v) { return Json{v.x, v.y, v.z}; }

template <class Count>
Json counts(std::size_t frames, const Count& count) {
  Json all = Json::array();
  for (std::size_t k = 0; k < frames; ++k) all.push_back(count(k));
  return all;
}

/// The next of 1, 2, 5, 10, … times a power of ten: the end of a legend.
double rounded_up(double value) {
  if (!(value > 0)) return 1;
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= value * (1 - 1e-12)) return digit * power;
  return 10 * power;
}

std::string element(std::string_view id, const Bytes& bytes) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, bytes.base64());
}

/// Speeds or spins of all spheres in all frames.
struct Magnitudes {
  Bytes bytes;
  Json facts;
  double error = 0;

  template <class Of>
  Magnitudes(const ShownMotion& motion, const Of& of) {
    std::vector<double> values;
    for (const SeenFrame& frame : motion.frames)
      for (const SeenGrain& g : frame.grains) values.push_back(norm(of(g)));
    const double greatest = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
    const Quanta quanta(0, greatest, false);
    for (const double value : values) bytes.add(quanta.of(value), 2);
    error = quanta.quantum / 2;
    // The colours shall tell the most of spheres apart, not a few fast ones.
    const auto most = values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size()));
    if (most != values.end()) std::nth_element(values.begin(), most, values.end());
    const double usual = most != values.end() && *most > 0.01 * greatest ? *most : greatest;
    facts = {{"quantum", quanta.quantum}, {"top", rounded_up(usual)}, {"greatest", greatest}};
  }
};

struct Places {
  Bytes bytes;
  std::array<Quanta, 3> axes;
  bool wide;

  static bool needs_width(const ShownMotion& motion, const Region& all) {
    const Vec3 extent = all.high - all.low;
    double smallest = motion.cast.front().radius;
    for (const SeenGrain& g : motion.cast) smallest = std::min(smallest, g.radius);
    return Quanta(0, std::max({extent.x, extent.y, extent.z}), false).quantum / 2 > visible_share * smallest;
  }
  Places(const ShownMotion& motion, const Region& all)
      : axes{Quanta{0, 0, false}, Quanta{0, 0, false}, Quanta{0, 0, false}}, wide(needs_width(motion, all)) {
    axes = {Quanta{all.low.x, all.high.x, wide}, Quanta{all.low.y, all.high.y, wide},
            Quanta{all.low.z, all.high.z, wide}};
    for (const SeenFrame& frame : motion.frames)
      for (const SeenGrain& g : frame.grains) {
        bytes.add(axes[0].of(g.position.x), wide ? 4 : 2);
        bytes.add(axes[1].of(g.position.y), wide ? 4 : 2);
        bytes.add(axes[2].of(g.position.z), wide ? 4 : 2);
      }
  }
  double error() const { return std::max({axes[0].quantum, axes[1].quantum, axes[2].quantum}) / 2; }
};

std::string contact_elements(const ShownMotion& motion, int index_bytes) {
  Bytes pairs, touching, towards;
  for (const auto& frame : motion.pairs)
    for (const auto& [i, j] : frame) pairs.add(i, index_bytes), pairs.add(j, index_bytes);
  for (const auto& frame : motion.touches)
    for (const auto& [i, n] : frame) {
      touching.add(i, index_bytes);
      for (const double c : {n.x, n.y, n.z})
        towards.add(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(127 * c))), 1);
    }
  return element("motion-pairs", pairs) + element("motion-touching", touching) + element("motion-towards", towards);
}

std::string sphere_elements(const ShownMotion& motion, int index_bytes) {
  Bytes radii, species, present;
  for (const SeenGrain& g : motion.cast) radii.add(static_cast<float>(g.radius)), species.add(g.species, 2);
  for (const auto& frame : motion.present)
    for (const std::uint32_t sphere : frame) present.add(sphere, index_bytes);
  return element("motion-radii", radii) + element("motion-species", species) + element("motion-present", present);
}

Json radius_range(const std::vector<SeenGrain>& cast) {
  const auto [least, greatest] =
      std::minmax_element(cast.begin(), cast.end(), [](const auto& a, const auto& b) { return a.radius < b.radius; });
  return {least->radius, greatest->radius};
}

double fastest(const SeenFrame& frame) {
  double speed = 0;
  for (const SeenGrain& g : frame.grains) speed = std::max(speed, norm(g.velocity));
  return speed;
}

Json json_of(const std::vector<WallOutline>& outlines) {
  Json walls = Json::array();
  for (const WallOutline& outline : outlines) {
    Json lines = Json::array();
    for (const Polyline& line : outline.lines) {
      Json points = Json::array();
      for (const Vec3 p : line) points.push_back(array_of(p));
      lines.push_back(points);
    }
    const WallMotion& m = outline.motion;
    walls.push_back({{"lines", lines},
                     {"point", array_of(outline.point)},
                     {"axis", array_of(outline.axis)},
                     {"velocity", array_of(m.velocity)},
                     {"spin", m.spin},
                     {"amplitude", array_of(m.amplitude)},
                     {"frequency", m.frequency}});
  }
  return walls;
}

// Within a script element only "<" could end it.
std::string facts_element(const Json& facts) {
  std::string text;
  for (const char c : facts.dump()) c == '<' ? text += "\\u003c" : text += c;
  return fmt::format("<script type=\"application/json\" id=\"motion-facts\">{}</script>\n", text);
}

}  // namespace

MotionData motion_data(const ShownMotion& motion, const std::vector<WallOutline>& outlines, Vec3 upward, Vec3 period) {
  const std::size_t frames = motion.frames.size();
  const Region all = motion.centres(), focus = with_walls(motion.focus(), outlines);
  const Places places(motion, all);
  const Magnitudes speeds(motion, [](const SeenGrain& g) { return g.velocity; });
  const Magnitudes spins(motion, [](const SeenGrain& g) { return g.spin; });
  const bool many = motion.cast.size() > 0x10000;
  const Json facts = {{"times", counts(frames, [&](std::size_t k) { return motion.frames[k].time; })},
                      {"counts", counts(frames, [&](std::size_t k) { return motion.frames[k].grains.size(); })},
                      {"pairs", counts(frames, [&](std::size_t k) { return motion.pairs[k].size(); })},
                      {"touches", counts(frames, [&](std::size_t k) { return motion.touches[k].size(); })},
                      {"fastest", counts(frames, [&](std::size_t k) { return fastest(motion.frames[k]); })},
                      {"wide", places.wide},
                      {"manySpheres", many},
                      {"origin", array_of(all.low)},
                      {"quanta", {places.axes[0].quantum, places.axes[1].quantum, places.axes[2].quantum}},
                      {"focus", {{"low", array_of(focus.low)}, {"high", array_of(focus.high)}}},
                      {"up", array_of(upward)},
                      {"speed", speeds.facts},
                      {"spin", spins.facts},
                      {"radiusRange", radius_range(motion.cast)},
                      {"species", motion.species},
                      {"walls", json_of(outlines)},
                      {"period", array_of(period)}};
  return {facts_element(facts) + element("motion-places", places.bytes) + element("motion-speeds", speeds.bytes) +
              element("motion-spins", spins.bytes) + sphere_elements(motion, many ? 4 : 2) +
              contact_elements(motion, many ? 4 : 2),
          places.error(), speeds.error, spins.error};
}

}  // namespace ricochet::simulate
