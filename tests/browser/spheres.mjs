// What a picture of a frame of trajectory.xyz must show, from the file alone: which sphere a line of sight meets.

import {readFileSync} from 'node:fs';

/// [{time, spheres: [{place, radius}]}]
export function read_trajectory(file) {
  const lines = readFileSync(file, 'utf8').split('\n'), frames = [];
  for (let at = 0; at + 1 < lines.length;) {
    const count = Number(lines[at]), time = Number(lines[at + 1].match(/Time=(\S+)/)[1]);
    const spheres = lines.slice(at + 2, at + 2 + count).map(line => {
      const fields = line.split(' ');
      return {place: fields.slice(1, 4).map(Number), radius: Number(fields[4])};
    });
    frames.push({time, spheres});
    at += 2 + count;
  }
  return frames;
}

const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);

/// `view`: eye [m], right, up, back, tangent of half the angle of view, width and height in pixels. For each sphere in
/// front of the eye: its middle and what its outline is wide in pixels, and its distance.
export function projected(spheres, view) {
  const focal = view.height / (2 * view.tangent);
  return spheres.map(({place, radius}, index) => {
    const p = place.map((x, a) => x - view.eye[a]), depth = -dot(p, view.back), away = Math.hypot(...p);
    return {
      index, radius, depth, x: view.width / 2 + focal * dot(p, view.right) / depth,
      y: view.height / 2 - focal * dot(p, view.up) / depth, pixels: focal * radius / depth, away,
    };
  });
}

/// Along the line of sight through a pixel: how near it passes the middle of each sphere, in its radii, and where the
/// eye meets it first.
export function met(spheres, view, x, y) {
  const focal = view.height / (2 * view.tangent);
  const [a, b] = [(x - view.width / 2) / focal, (view.height / 2 - y) / focal];
  const sight = view.back.map((c, k) => a * view.right[k] + b * view.up[k] - c), length = Math.hypot(...sight);
  return spheres.map(({place, radius}, index) => {
    const p = place.map((c, k) => c - view.eye[k]), along = dot(p, sight) / length;
    const off = Math.sqrt(Math.max(0, dot(p, p) - along * along));
    const pixel = Math.hypot(...p) / focal;
    return {index, off: off / radius, clear: (off - radius) / pixel,
      first: along - Math.sqrt(Math.max(0, radius * radius - off * off))};
  });
}
