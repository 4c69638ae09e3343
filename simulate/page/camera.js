// Where the picture is taken from: a distance from a target, an azimuth about the upward direction and an elevation
// over the plane across it. The view's axes are right, up and back (towards the eye).

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const sum = (...terms) => [0, 1, 2].map(a => terms.reduce((s, [f, v]) => s + f * v[a], 0));
const unit = v => v.map(x => x / Math.hypot(...v));
const clamp = (x, low, high) => Math.min(high, Math.max(low, x));

function makeCamera(upward, corners) {
  const first = unit(cross(Math.abs(upward[1]) < 0.9 ? [0, 1, 0] : [0, 0, 1], upward)), second = cross(upward, first);
  const tangent = Math.tan(Math.PI / 10); // of half the angle of view, upward
  const camera = {azimuth: 0, elevation: 0, zoom: 1, target: [0, 0, 0], tangent};

  camera.reset = () => Object.assign(camera, {azimuth: -60, elevation: 15, zoom: 1, target: [0, 0, 0]});
  camera.turn = (azimuth, elevation) => {
    camera.azimuth = (camera.azimuth + azimuth) % 360;
    camera.elevation = clamp(camera.elevation + elevation, -90, 90);
  };
  camera.magnify = factor => { camera.zoom = clamp(camera.zoom * factor, 0.1, 100); };
  /// By shares of the picture's height.
  camera.shift = (x, y) => {
    const {right, up, distance} = camera.seen(1);
    camera.target = sum([1, camera.target], [-x * 2 * tangent * distance, right], [-y * 2 * tangent * distance, up]);
  };
  /// All that a drawing needs for a picture of this width over height.
  camera.seen = aspect => {
    const [ca, sa] = [Math.cos, Math.sin].map(f => f(camera.azimuth * Math.PI / 180));
    const [ce, se] = [Math.cos, Math.sin].map(f => f(camera.elevation * Math.PI / 180));
    const right = sum([-sa, first], [ca, second]);
    const back = sum([ce * ca, first], [ce * sa, second], [se, upward]), up = cross(back, right);
    // The corners of what shall be seen lie within the picture: |x| / (distance − z) <= tangent of each.
    const needed = corners.map(p => dot(p, back) +
      Math.max(Math.abs(dot(p, right)) / Math.min(aspect, 4), Math.abs(dot(p, up))) / tangent);
    const distance = 1.04 * Math.max(...needed) / camera.zoom;
    const eye = sum([1, camera.target], [distance, back]);
    return {right, up, back, eye, distance, aspect, tangent, near: 0.02 * distance, far: distance + 40};
  };
  camera.reset();
  return camera;
}
