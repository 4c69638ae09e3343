// What the page carries: numbers as JSON, long arrays as base64 of little-endian numbers. Places are handed on in
// units of half the diagonal of what the picture shows, around its middle: graphics cards count in single precision.

function bytesOf(id) {
  const element = document.getElementById(id);
  const text = element.textContent.trim();
  element.remove(); // megabytes that nobody needs twice
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  return Uint8Array.from(atob(text), c => c.charCodeAt(0));
}

function sums(counts) {
  const all = [0];
  for (const count of counts) all.push(all[all.length - 1] + count);
  return all;
}

function readMotion() {
  const facts = JSON.parse(document.getElementById('motion-facts').textContent);
  const Places = facts.wide ? Uint32Array : Uint16Array, Index = facts.manySpheres ? Uint32Array : Uint16Array;
  const places = new Places(bytesOf('motion-places').buffer);
  const pairs = new Index(bytesOf('motion-pairs').buffer);
  const touching = new Index(bytesOf('motion-touching').buffer);
  const towards = new Int8Array(bytesOf('motion-towards').buffer);
  const speeds = new Uint16Array(bytesOf('motion-speeds').buffer);
  const spins = new Uint16Array(bytesOf('motion-spins').buffer);
  const radii = new Float32Array(bytesOf('motion-radii').buffer);
  const species = new Uint16Array(bytesOf('motion-species').buffer);
  const present = new Index(bytesOf('motion-present').buffer);
  const {low, high} = facts.focus;
  const middle = low.map((x, a) => (x + high[a]) / 2);
  const scale = 2 / Math.hypot(...low.map((x, a) => high[a] - x));
  const starts = sums(facts.counts), pairStarts = sums(facts.pairs), touchStarts = sums(facts.touches);
  const scaled = point => point.map((x, a) => (x - middle[a]) * scale);
  const origin = scaled(facts.origin), quanta = facts.quanta.map(x => x * scale);

  return {
    facts, scale, middle, scaled, species, radii: radii.map(r => r * scale), metres: radii,
    frames: facts.times.length, most: Math.max(...facts.counts), speeds, spins,
    count: frame => facts.counts[frame],
    start: frame => starts[frame],
    present: frame => present.subarray(starts[frame], starts[frame + 1]),
    period: facts.period.map(x => x * scale),
    corners: [0, 1, 2, 3, 4, 5, 6, 7].map(k => scaled([0, 1, 2].map(a => (k >> a) & 1 ? high[a] : low[a]))),
    places(frame, out) {
      const from = 3 * starts[frame], length = 3 * facts.counts[frame];
      for (let k = 0; k < length; ++k) out[k] = origin[k % 3] + quanta[k % 3] * places[from + k];
    },
    pairs: frame => pairs.subarray(2 * pairStarts[frame], 2 * pairStarts[frame + 1]),
    touching: frame => touching.subarray(touchStarts[frame], touchStarts[frame + 1]),
    towards: frame => towards.subarray(3 * touchStarts[frame], 3 * touchStarts[frame + 1]),
  };
}
