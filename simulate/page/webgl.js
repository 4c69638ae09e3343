// Spheres as squares that face the eye, each just as large as the sphere's outline; for every pixel the line of sight
// is cut with the sphere, which gives shade and depth exactly. One call draws all.

const sphereVertex = `#version 300 es
in vec2 corner; in vec3 before, after; in float radius, toneBefore, toneAfter;
uniform mat3 axes; uniform vec3 eye; uniform vec4 lens; uniform float between, swell, jump;
out vec3 sight; flat out vec3 centre; flat out float size; flat out float tone;
vec4 project(vec3 p) { return vec4(lens.x * p.x, lens.y * p.y, lens.z * p.z + lens.w, -p.z); }
void main() {
  // What leaps by more than a share of the picture was put elsewhere: it does not fly there.
  float share = distance(before, after) > jump ? step(0.5, between) : between;
  tone = mix(toneBefore, toneAfter, share);
  centre = (mix(before, after, share) - eye) * axes;
  size = radius * swell;
  float away = max(length(centre), 1.001 * size);
  vec3 w = centre / away, u = normalize(cross(w, vec3(0.0, 1.0, 0.0001))), v = cross(u, w);
  float outline = size / sqrt(1.0 - size * size / (away * away));
  sight = centre + 1.02 * outline * (corner.x * u + corner.y * v);
  gl_Position = project(sight);
}`;

const sphereFragment = `#version 300 es
precision highp float;
in vec3 sight; flat in vec3 centre; flat in float size; flat in float tone;
uniform vec4 lens; uniform sampler2D table;
out vec4 colour;
void main() {
  vec3 along = normalize(sight);
  float reach = dot(along, centre);
  vec3 off = reach * along - centre;
  float left = size * size - dot(off, off);
  float edge = (size - length(off)) / max(fwidth(length(off)), 1e-9);
  float cover = clamp(edge + 0.5, 0.0, 1.0);
  if (cover <= 0.0) discard;
  vec3 hit = (reach - sqrt(max(left, 0.0))) * along;
  if (hit.z > -1e-4) discard;
  vec3 normal = (hit - centre) / size;
  vec3 light = normalize(vec3(-0.4, 0.6, 0.75));
  float bright = 0.5 + 0.55 * max(dot(normal, light), 0.0);
  float gloss = pow(max(dot(reflect(-light, normal), -along), 0.0), 40.0);
  float rim = mix(0.6, 1.0, smoothstep(0.0, 0.4, dot(normal, -along)));
  colour = vec4(texture(table, vec2(tone, 0.5)).rgb * bright * rim + 0.22 * gloss, cover);
  gl_FragDepth = clamp(0.5 - 0.5 * (lens.z * hit.z + lens.w) / hit.z, 0.0, 1.0);
}`;

const lineVertex = `#version 300 es
in vec3 place; uniform mat3 axes; uniform vec3 eye; uniform vec4 lens;
void main() {
  vec3 p = (place - eye) * axes;
  gl_Position = vec4(lens.x * p.x, lens.y * p.y, lens.z * p.z + lens.w, -p.z);
}`;
const lineFragment = `#version 300 es
precision mediump float; uniform vec3 ink; out vec4 colour; void main() { colour = vec4(ink, 1.0); }`;

function makeProgram(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return null;
  return {
    program, place: name => gl.getAttribLocation(program, name),
    uniform: (set, name, ...values) => gl[set](gl.getUniformLocation(program, name), ...values),
  };
}

/// Does the main processor do a graphics card's work? Then thousands of spheres take it seconds.
function inSoftware(gl) {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER);
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/// A renderer by WebGL 2, or null where the browser has none, or, of `many` spheres, none but in software.
function makeWebgl(canvas, many) {
  const gl = canvas.getContext('webgl2', {antialias: true, alpha: false, failIfMajorPerformanceCaveat: many});
  if (!gl || gl.isContextLost() || (many && inSoftware(gl))) return null;
  const spheres = makeProgram(gl, sphereVertex, sphereFragment), lines = makeProgram(gl, lineVertex, lineFragment);
  if (!spheres || !lines) return null;
  const buffers = {}, held = {};
  const use = (name, place, width, values, divisor, fresh) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers[name] ??= gl.createBuffer());
    if (fresh || held[name] !== values) gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    held[name] = values;
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, width, gl.FLOAT, false, 0, 0);
    gl.vertexAttribDivisor(place, divisor);
  };
  const square = new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]);
  const sphereArray = gl.createVertexArray(), lineArray = gl.createVertexArray();
  const texture = gl.createTexture();
  let shownTable = null;

  const aim = (program, seen) => {
    gl.useProgram(program.program);
    const {right, up, back, near, far, tangent, aspect} = seen;
    program.uniform('uniformMatrix3fv', 'axes', false, [...right, ...up, ...back]);
    program.uniform('uniform3fv', 'eye', seen.eye);
    program.uniform('uniform4f', 'lens', 1 / (tangent * aspect), 1 / tangent, (near + far) / (near - far),
      2 * near * far / (near - far));
  };
  const drawSpheres = (seen, picture) => {
    aim(spheres, seen);
    gl.bindVertexArray(sphereArray);
    use('square', spheres.place('corner'), 2, square, 0, false);
    for (const [name, width] of [['before', 3], ['after', 3], ['toneBefore', 1], ['toneAfter', 1], ['radius', 1]])
      use(name, spheres.place(name), width, picture[name], 1, picture.fresh);
    for (const name of ['between', 'swell', 'jump']) spheres.uniform('uniform1f', name, picture[name]);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    if (shownTable !== picture.table) {
      const texels = new Uint8Array(picture.table.flatMap(c => [...c, 255]));
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
      for (const [key, value] of [['MIN_FILTER', 'LINEAR'], ['MAG_FILTER', 'LINEAR'], ['WRAP_S', 'CLAMP_TO_EDGE'],
        ['WRAP_T', 'CLAMP_TO_EDGE']]) gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${key}`], gl[value]);
      shownTable = picture.table;
    }
    gl.enable(gl.SAMPLE_ALPHA_TO_COVERAGE);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, picture.count);
    gl.disable(gl.SAMPLE_ALPHA_TO_COVERAGE);
  };
  const drawLines = (seen, name, values, length, ink, fresh) => {
    if (!length) return;
    aim(lines, seen);
    gl.bindVertexArray(lineArray);
    use(name, lines.place('place'), 3, values, 0, fresh);
    lines.uniform('uniform3fv', 'ink', ink.map(c => c / 255));
    gl.drawArrays(gl.LINES, 0, length / 3);
  };

  return {
    name: 'WebGL',
    draw(seen, picture) {
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(...picture.ground.map(c => c / 255), 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      drawSpheres(seen, picture);
      drawLines(seen, 'walls', picture.walls, picture.walls.length, picture.wallInk, true);
      drawLines(seen, 'contacts', picture.contacts, picture.contactLength, picture.ink, true);
    },
  };
}
