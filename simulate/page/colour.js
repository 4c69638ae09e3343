// Colours that stand for numbers get steadily lighter, those that stand for names are Okabe and Ito's: readers with
// any colour vision tell both apart. One table of 256 colours at a time, and what it means.

const ramp = [[84, 72, 178], [50, 120, 200], [36, 165, 160], [140, 205, 95], [252, 222, 80]];
const named = [[230, 159, 0], [86, 180, 233], [0, 158, 115], [204, 121, 167], [213, 94, 0], [240, 228, 66],
  [0, 114, 178], [140, 140, 140]];

function rampTable() {
  return Array.from({length: 256}, (unused, k) => {
    const at = k / 255 * (ramp.length - 1), i = Math.min(Math.floor(at), ramp.length - 2);
    return ramp[i].map((c, a) => Math.round(c + (at - i) * (ramp[i + 1][a] - c)));
  });
}

const namedTable = () => Array.from({length: 256}, (unused, k) => named[k % named.length]);
const css = ([r, g, b]) => `rgb(${r},${g},${b})`;

const prefixes = [[1e-9, 'n'], [1e-6, 'µ'], [1e-3, 'm'], [1, ''], [1e3, 'k']];
/// Three digits and a unit, with the prefix that suits `like`; 1/s has none.
function quantity(value, unit, like = value) {
  const [factor, prefix] = unit === '1/s' || like === 0 ? [1, '']
    : prefixes.findLast(([f]) => Math.abs(like) >= 0.9999995 * f) ?? prefixes[0];
  const digits = Number((value / factor).toPrecision(3));
  return `${Math.abs(digits) >= 1e5 ? digits.toExponential() : digits} ${prefix}${unit}`;
}

/// What can be shown by colour: for each the place in the table, from 0 to 1, of the k-th sphere of a frame.
function makeColourings(motion) {
  const {facts} = motion;
  const moving = (name, values, {quantum, top, greatest}, unit) => ({
    name, unit, table: rampTable(), range: [0, top], beyond: greatest > top,
    tone: (frame, k) => Math.min(1, quantum / top * values[motion.start(frame) + k]),
  });
  const [least, greatest] = facts.radiusRange;
  return {
    speed: moving('Speed', motion.speeds, facts.speed, 'm/s'),
    spin: moving('Spin', motion.spins, facts.spin, '1/s'),
    size: {
      name: 'Radius', unit: 'm', table: rampTable(), range: [least, greatest], beyond: false,
      tone: (frame, k) =>
        greatest > least ? (motion.metres[motion.present(frame)[k]] - least) / (greatest - least) : 0.5,
    },
    material: {
      name: 'Material', names: facts.species, table: namedTable(),
      tone: (frame, k) => (motion.species[motion.present(frame)[k]] % 256 + 0.5) / 256,
    },
  };
}

function showLegend(element, colouring) {
  element.replaceChildren();
  const add = (parent, tag, text, style = '') => {
    const made = document.createElement(tag);
    made.textContent = text;
    made.style.cssText = style;
    return parent.appendChild(made);
  };
  if (colouring.names) {
    add(element, 'span', `${colouring.name}: `);
    colouring.names.forEach((name, k) => {
      const entry = add(element, 'span', '');
      entry.className = 'entry';
      add(entry, 'span', '', `background:${css(colouring.table[k % 256])}`).className = 'swatch';
      entry.append(name);
    });
    return;
  }
  const [low, high] = colouring.range;
  add(element, 'span', colouring.name);
  const scale = add(element, 'span', '');
  scale.className = 'scale';
  const stops = colouring.table.filter((unused, k) => k % 15 === 0).map(css).join(',');
  add(scale, 'span', '', `background:linear-gradient(90deg,${stops})`).className = 'bar';
  if (low === high) return void add(scale, 'span', `all ${quantity(low, colouring.unit)}`);
  const ticks = add(scale, 'span', '');
  ticks.className = 'ticks';
  for (const at of [0, 0.5, 1]) {
    const value = low + at * (high - low);
    add(ticks, 'span', `${at === 1 && colouring.beyond ? '≥ ' : ''}${quantity(value, colouring.unit, high)}`);
  }
}
