#include <simulate/view.hpp>

#include "document.hpp"

#include <console/exit.hpp>
#include <console/html.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ricochet::simulate {
namespace {

using console::escaped;
using console::significant;

std::string up_to(double error, std::string_view unit) { return fmt::format("{} {}", significant(error, 2), unit); }

std::string frames_shown(const ShownMotion& motion) {
  if (motion.frames.size() == motion.frames_written)
    return fmt::format("all {} that were written", motion.frames_written);
  return fmt::format("{} of the {} that were written, evenly spread, so that the page stays small",
                     motion.frames.size(), motion.frames_written);
}

std::string radii(const std::vector<SeenGrain>& cast) {
  const auto [least, greatest] =
      std::minmax_element(cast.begin(), cast.end(), [](const auto& a, const auto& b) { return a.radius < b.radius; });
  if (least->radius == greatest->radius) return fmt::format("radius {} m", significant(least->radius, 4));
  return fmt::format("radii from {} to {} m", significant(least->radius, 4), significant(greatest->radius, 4));
}

std::string facts(const Scene& scene, const ShownMotion& motion, const MotionData& data) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"Spheres", fmt::format("{}, {}", motion.cast.size(), radii(motion.cast))},
      {"Time", fmt::format("{} to {} s, in steps of {} s", significant(motion.frames.front().time, 6),
                           significant(motion.frames.back().time, 6), significant(scene.options.step, 4))},
      {"Frames", frames_shown(motion)},
      {"Between frames", "spheres move straight, and colours blend, as the page draws it"},
      {"Kept to", fmt::format("{} along each axis, {}, {}", up_to(data.place_error, "m"),
                              up_to(data.speed_error, "m/s"), up_to(data.spin_error, "1/s"))},
      {"Contacts",
       "between bodies that overlap, in the frame that is nearest; spheres are then drawn at a third of "
       "their size"}};
  std::string html = "<dl class=\"facts\">\n";
  for (const auto& [what, value] : rows) html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", what, escaped(value));
  return html + "<dt>Drawn by</dt><dd id=\"drawn\">a script, which this browser does not run</dd>\n</dl>\n";
}

constexpr const char* player = R"html(<noscript><p>The picture needs JavaScript.</p></noscript>
<section class="player" id="player" aria-label="Player" hidden>
<canvas id="stage" tabindex="0" role="application" aria-label="Picture of the spheres" aria-describedby="keys"></canvas>
<div class="controls">
<div class="run">
<button type="button" id="play" data-does="play">Play</button>
<label for="time" class="aloud">Time</label>
<input type="range" id="time" min="0" max="1" step="any" value="0">
<output id="time-text" for="time"></output>
</div>
<div class="group" role="group" aria-label="Frames">
<button type="button" data-does="back" aria-label="Frame before">|◂</button>
<button type="button" data-does="forth" aria-label="Next frame">▸|</button>
</div>
<label>Play at <select id="rate"></select></label>
</div>
<div class="legend" id="legend" role="group" aria-label="What the colours mean"></div>
<div class="controls">
<label>Colour by <select id="colour"><option value="speed">speed</option><option value="spin">spin</option>)html"
                               R"html(<option value="size">size</option><option value="material">material</option>)html"
                               R"html(</select></label>
<label><input type="checkbox" id="contacts"> Contacts</label>
<label><input type="checkbox" id="walls" checked> Walls</label>
<div class="group" role="group" aria-label="Point of view">
<button type="button" data-does="left" aria-label="Turn left">←</button>
<button type="button" data-does="right" aria-label="Turn right">→</button>
<button type="button" data-does="up" aria-label="Look from higher">↑</button>
<button type="button" data-does="down" aria-label="Look from lower">↓</button>
<button type="button" data-does="nearer" aria-label="Nearer">+</button>
<button type="button" data-does="farther" aria-label="Farther">−</button>
<button type="button" data-does="reset">Reset</button>
</div>
</div>
<p class="now" id="now"></p>
<p class="aloud" id="told" role="status"></p>
</section>
)html";

constexpr const char* help = R"html(<h2 id="how">How to look around</h2>
<p id="keys">Drag turns the view, Shift with drag or two fingers move it, the wheel or a pinch zooms. With the picture
chosen: <kbd>Space</kbd> plays and pauses, <kbd>,</kbd> and <kbd>.</kbd> step by a frame, <kbd>Home</kbd> and
<kbd>End</kbd> go to the first and the last, <kbd>[</kbd> and <kbd>]</kbd> play slower and faster, the arrows turn, with
<kbd>Shift</kbd> they move, <kbd>+</kbd> and <kbd>-</kbd> zoom, <kbd>0</kbd> resets the view, <kbd>1</kbd> to
<kbd>4</kbd> colour by speed, spin, size and material, <kbd>C</kbd> shows contacts, <kbd>W</kbd> walls.</p>
<p>The page's address may say where it begins:
<code>#time=0.1&amp;colour=size&amp;azimuth=30&amp;elevation=20&amp;zoom=1.5&amp;contacts=1&amp;walls=0</code>
(s, degrees).</p>
)html";

// The walls, and the cell of a space that repeats itself.
std::vector<WallOutline> outlines_of(const Scene& scene, const Region& focus) {
  std::vector<WallOutline> all = wall_outlines(scene.setup.walls, focus);
  if (!scene.setup.periodic.any()) return all;
  const Region cell{scene.cell_low, scene.cell_high};
  for (const WallOutline& face : wall_outlines(box_walls(cell.low, cell.high), cell)) all.push_back(face);
  return all;
}

Vec3 upward(const Scene& scene) {
  const double g = norm(scene.setup.gravity);
  return g > 0 ? -scene.setup.gravity / g : Vec3{0, 0, 1};
}

}  // namespace

std::string view_page(const Scene& scene, const std::string& folder) {
  TrajectoryFile file(folder + "/trajectory.xyz");
  const ShownMotion motion = read_motion(file, scene.setup);
  const MotionData data =
      motion_data(motion, outlines_of(scene, motion.focus()), upward(scene), scene.setup.periodic.period);
  const std::string title = scene.title.empty() ? "Spheres in motion" : scene.title;
  const std::string body = fmt::format(
      R"(<header>
<h1>{}</h1>
<p class="lead">{} spheres over {} s</p>
</header>
<main id="content">
{}<h2 id="shown">What is shown</h2>
{}{}</main>
<footer><p>Ricochet. SI units.</p></footer>
{})",
      escaped(title), motion.cast.size(), significant(motion.frames.back().time, 6), player, facts(scene, motion, data),
      help, data.elements);
  return console::html_page(title, body, {.style = view_style, .script = view_script});
}

}  // namespace ricochet::simulate
