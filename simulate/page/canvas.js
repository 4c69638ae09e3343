// The same picture on a plain canvas, for browsers without WebGL 2: walls, then spheres from the farthest to the
// nearest, each a shaded disc as large as its outline; thousands of them by raster.js.

function makeCanvas(canvas) {
  const pen = canvas.getContext('2d', {alpha: false});
  const edge = 64, many = 2000, raster = makeRaster();
  let sprites = [], shownTable = null; // one for each colour in use
  let x, y, depth, outline, order;

  const sprite = (table, k) => {
    const disc = document.createElement('canvas');
    disc.width = disc.height = edge;
    const ink = disc.getContext('2d'), half = edge / 2;
    const shade = ink.createRadialGradient(0.72 * half, 0.62 * half, 0.05 * half, half, half, half);
    const tint = (f, gloss) => css(table[k].map(c => Math.round(Math.min(255, f * c + gloss))));
    for (const [at, f, gloss] of [[0, 1, 45], [0.25, 0.95, 4], [0.7, 0.72, 0], [1, 0.36, 0]])
      shade.addColorStop(at, tint(f, gloss));
    ink.fillStyle = shade;
    ink.beginPath();
    ink.arc(half, half, half, 0, 2 * Math.PI);
    ink.fill();
    return disc;
  };
  const prepare = count => {
    if (x && x.length >= count) return;
    [x, y, depth, outline] = [0, 1, 2, 3].map(() => new Float32Array(count));
    order = new Uint32Array(count);
  };
  const projectSpheres = ({right, up, back, eye, near}, picture, focal) => {
    const {before, after, between, jump, count, radius, swell} = picture;
    prepare(count);
    let shown = 0;
    for (let i = 0, k = 0; i < count; ++i, k += 3) {
      const dx = after[k] - before[k], dy = after[k + 1] - before[k + 1], dz = after[k + 2] - before[k + 2];
      const share = dx * dx + dy * dy + dz * dz > jump * jump ? Math.round(between) : between;
      const px = before[k] + share * dx - eye[0], py = before[k + 1] + share * dy - eye[1];
      const pz = before[k + 2] + share * dz - eye[2];
      const away = -(px * back[0] + py * back[1] + pz * back[2]), size = radius[i] * swell;
      if (away <= Math.max(near, size)) continue;
      const factor = focal / away;
      x[i] = canvas.width / 2 + factor * (px * right[0] + py * right[1] + pz * right[2]);
      y[i] = canvas.height / 2 - factor * (px * up[0] + py * up[1] + pz * up[2]);
      depth[i] = away;
      outline[i] = focal * size / Math.sqrt(away * away - size * size);
      order[shown++] = i;
    }
    return order.subarray(0, shown);
  };
  const drawSpheres = (seen, picture, focal) => {
    if (shownTable !== picture.table) sprites = [], shownTable = picture.table;
    const seenSpheres = projectSpheres(seen, picture, focal), quick = seenSpheres.length > many;
    seenSpheres.sort(quick ? (a, b) => depth[a] - depth[b] : (a, b) => depth[b] - depth[a]);
    if (quick) raster.prepare(canvas.width, canvas.height);
    for (const i of seenSpheres) {
      const r = outline[i];
      if (x[i] + r < 0 || y[i] + r < 0 || x[i] - r > canvas.width || y[i] - r > canvas.height) continue;
      const tone = picture.toneBefore[i] + picture.between * (picture.toneAfter[i] - picture.toneBefore[i]);
      const k = Math.round(255 * clamp(tone, 0, 1) - (picture.byName ? 0.5 : 0));
      if (quick) raster.put(x[i], y[i], r, depth[i], picture.radius[i] * picture.swell, picture.table[k]);
      else pen.drawImage(sprites[k] ??= sprite(picture.table, k), x[i] - r, y[i] - r, 2 * r, 2 * r);
    }
    if (quick) pen.drawImage(raster.sheet(), 0, 0);
  };
  const drawLines = ({right, up, back, eye, near}, values, length, ink, focal) => {
    const view = k => {
      const p = [values[k] - eye[0], values[k + 1] - eye[1], values[k + 2] - eye[2]];
      return [dot(p, right), dot(p, up), -dot(p, back)];
    };
    const toNear = (a, b) => a.map((c, n) => c + (near - a[2]) / (b[2] - a[2]) * (b[n] - c));
    pen.strokeStyle = css(ink);
    pen.lineWidth = Math.max(1, canvas.width / 1200);
    pen.beginPath();
    for (let k = 0; k + 5 < length; k += 6) {
      let a = view(k), b = view(k + 3);
      if (a[2] < near && b[2] < near) continue;
      if (a[2] < near) a = toNear(a, b);
      else if (b[2] < near) b = toNear(b, a);
      pen.moveTo(canvas.width / 2 + focal * a[0] / a[2], canvas.height / 2 - focal * a[1] / a[2]);
      pen.lineTo(canvas.width / 2 + focal * b[0] / b[2], canvas.height / 2 - focal * b[1] / b[2]);
    }
    pen.stroke();
  };

  return {
    name: 'a plain canvas, as this browser has no WebGL 2, or none that is quick',
    draw(seen, picture) {
      const focal = canvas.height / (2 * seen.tangent);
      pen.fillStyle = css(picture.ground);
      pen.fillRect(0, 0, canvas.width, canvas.height);
      drawLines(seen, picture.walls, picture.walls.length, picture.wallInk, focal);
      drawSpheres(seen, picture, focal);
      drawLines(seen, picture.contacts, picture.contactLength, picture.ink, focal);
    },
  };
}
