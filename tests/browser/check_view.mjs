// The page of `simulate --view` in headless Chromium, drawn by WebGL (in software) and on the plain canvas that stands
// in for it:
//   node check_view.mjs PAGE.html TRAJECTORY.xyz MODULES [SHOTS]
// lines of sight through random pixels meet a sphere, and one of its colour, just where the trajectory says so;
// contacts, keys, mouse, buttons and the slider do what the page says; no finding of axe-core, no error in the console,
// no request to a network, nothing wider than the window. Of more than 2000 spheres, which the page does not draw by
// WebGL in software, pixels alone are looked at. SHOTS, if given, receives screenshots.

import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {axe_file, browser_path, load_playwright, quiet} from './launch.mjs';
import {check_controls} from './view_controls.mjs';
import {met, projected, read_trajectory} from './spheres.mjs';

const [page_file, trajectory, modules, shots] = process.argv.slice(2);
const address = pathToFileURL(resolve(page_file)).href;
const {chromium} = load_playwright(modules);
const frames = read_trajectory(trajectory);
const crowd = frames[0].spheres.length > 2000;
const found = [];
let checks = 0;
const hold = (good, what, detail = '') => {
  checks += 1;
  if (!good) found.push(`${what}: ${detail}`);
};

const kinds = {
  WebGL: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
  canvas: ['--disable-gpu', '--disable-3d-apis'],
};

/// Draws a moment seen from somewhere, and hands over the pixels and where the eye was, in metres.
const photograph = async (page, wanted) => {
  const shot = await take(page, wanted);
  return {...shot, pixels: Buffer.from(shot.pixels, 'base64')};
};
const take = (page, wanted) => page.evaluate(({frame, azimuth, elevation, zoom, colour, contacts}) => {
  const view = window.ricochetView, stage = document.getElementById('stage');
  Object.assign(view.state, {moment: frame, colour, contacts, walls: false});
  view.camera.reset();
  Object.assign(view.camera, {azimuth, elevation, zoom});
  const seen = view.draw(), copy = document.createElement('canvas');
  Object.assign(copy, {width: stage.width, height: stage.height});
  const pen = copy.getContext('2d');
  pen.drawImage(stage, 0, 0);
  const {right, up, back, tangent} = seen, {middle, scale} = view.motion;
  let pixels = '';
  for (const byte of pen.getImageData(0, 0, copy.width, copy.height).data) pixels += String.fromCharCode(byte);
  return {
    pixels: btoa(pixels), // an array of a million numbers would take long
    ground: getComputedStyle(stage).backgroundColor.match(/\d+/g).map(Number),
    ink: getComputedStyle(stage).color.match(/\d+/g).map(Number),
    table: view.colourings[colour].table, range: view.colourings[colour].range,
    view: {right, up, back, tangent, width: copy.width, height: copy.height,
      eye: seen.eye.map((x, a) => middle[a] + x / scale)},
  };
}, wanted);

const pixel = (shot, x, y) => {
  const at = 4 * (Math.floor(y) * shot.view.width + Math.floor(x));
  return [...shot.pixels.subarray(at, at + 3)];
};
const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/// A quick generator of the same numbers each time.
function numbers(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

/// The nearest to 1 of the cosines between the pixel, less any gloss, and colours of the table.
function colour_place(rgb, table) {
  const tint = c => c.map(x => x - 0.6 * Math.min(...c));
  const cosine = (a, b) => (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (Math.hypot(...a) * Math.hypot(...b) || 1);
  const fits = table.map(entry => cosine(tint(rgb), tint(entry)));
  return fits.indexOf(Math.max(...fits)) / 255;
}

/// Lines of sight through random pixels, against the trajectory.
async function check_pixels(page, kind) {
  const random = numbers(7), seen = {hit: 0, missed: 0, coloured: 0, wrong: 0};
  for (const [share, azimuth, elevation, zoom] of [[0, 20, 10, 1], [0.4, -130, 35, 1.5], [1, 75, -20, 1]]) {
    const frame = Math.round(share * (frames.length - 1)), {spheres} = frames[frame];
    const shot = await photograph(page, {frame, azimuth, elevation, zoom, colour: 'size', contacts: false});
    for (let k = 0; k < 1500; ++k) {
      const x = Math.floor(random() * shot.view.width) + 0.5, y = Math.floor(random() * shot.view.height) + 0.5;
      const all = met(spheres, shot.view, x, y), nearest = Math.min(...all.map(m => m.clear));
      if (Math.abs(nearest) < 1.5) continue; // on an outline
      const drawn = apart(pixel(shot, x, y), shot.ground) > 12;
      seen[nearest < 0 ? 'hit' : 'missed'] += 1;
      hold(drawn === nearest < 0, `${kind}, frame ${frame}`,
        `${nearest < 0 ? 'no sphere' : 'a sphere'} at pixel ${x}, ${y} (${nearest.toFixed(1)} pixels from an outline)`);
      const hits = all.filter(m => m.clear < 0).sort((a, b) => a.first - b.first);
      if (!hits.length || hits[0].off > 0.6) continue;
      const [low, high] = shot.range, wanted = (spheres[hits[0].index].radius - low) / (high - low);
      seen.coloured += 1;
      if (Math.abs(colour_place(pixel(shot, x, y), shot.table) - wanted) > 0.12) seen.wrong += 1;
    }
  }
  hold(seen.hit > 300 && seen.missed > 300 && seen.coloured > 100, `${kind}, pixels`, `only ${JSON.stringify(seen)}`);
  // Painted from far to near by their middles, spheres of unlike size may hide each other the wrong way round.
  const by_pixel = crowd || kind.startsWith('WebGL');
  hold(seen.wrong <= (by_pixel ? 0 : 0.02 * seen.coloured), `${kind}, colours`, JSON.stringify(seen));
  return seen;
}

/// Half way between the middles of two spheres that overlap stands a line, in front of what is small now.
async function check_contacts(page, kind) {
  const frame = frames.length - 1, {spheres} = frames[frame];
  const shot = await photograph(page, {frame, azimuth: 20, elevation: 30, zoom: 1, colour: 'size', contacts: true});
  const small = spheres.map(s => ({...s, radius: 0.35 * s.radius}));
  let lines = 0;
  for (let i = 0; i < spheres.length; ++i)
    for (let j = i + 1; j < spheres.length; ++j) {
      const [a, b] = [spheres[i], spheres[j]];
      if (Math.hypot(...a.place.map((x, k) => x - b.place[k])) > a.radius + b.radius) continue;
      const half = a.radius / (a.radius + b.radius), place = a.place.map((x, k) => x + half * (b.place[k] - x));
      const [{x, y}] = projected([{place, radius: a.radius}], shot.view);
      if (met(small, shot.view, x, y).some(m => m.clear < 3)) continue;
      lines += 1;
      const near = [-1, 0, 1].flatMap(u => [-1, 0, 1].map(v => apart(pixel(shot, x + u, y + v), shot.ink)));
      hold(Math.min(...near) < 0.6 * apart(shot.ink, shot.ground), // a pixel wide, it covers half of one at least
        `${kind}, contacts`, `no line from sphere ${i + 1} to ${j + 1}`);
    }
  hold(lines > 3, `${kind}, contacts`, `only ${lines} in sight`);
  return lines;
}

async function check_look(page, kind, scheme) {
  await page.addScriptTag({path: axe_file(modules)});
  for (const width of [320, 390, 1280, 2560]) {
    await page.setViewportSize({width, height: 900});
    await page.waitForTimeout(60);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    hold(wide <= 0, `${kind}, ${scheme}`, `${wide} pixels too wide at ${width}`);
    if (shots) await page.screenshot({path: join(shots, `view-${kind}-${scheme}-${width}.png`), fullPage: true});
  }
  const {violations} = await page.evaluate(() => window.axe.run(document, {resultTypes: ['violations']}));
  hold(!violations.length, `${kind}, ${scheme}, axe-core`,
    violations.map(v => `${v.id}: ${v.help}: ${v.nodes[0].target.join(' ')}`).join('; '));
  await page.setViewportSize({width: 1280, height: 900});
}

/// A lost context is no end: the plain canvas takes over.
async function check_loss(page) {
  await page.evaluate(() => document.getElementById('stage').getContext('webgl2').getExtension('WEBGL_lose_context')
    .loseContext());
  await page.waitForFunction(() => document.getElementById('drawn').textContent.startsWith('a plain canvas'));
  await check_pixels(page, 'canvas after a loss');
}

/// One page of a crowd: pixels alone.
async function check_crowd(browser, kind) {
  const page = await open(browser, 'light');
  hold((await page.textContent('#drawn')).startsWith('a plain canvas'), kind, 'a crowd is drawn in software');
  const {hit, missed, coloured} = await check_pixels(page, kind);
  console.log(`${kind}, a crowd: ${hit} lines of sight met a sphere, ${missed} none, ${coloured} colours`);
}

async function open(browser, colorScheme, hash = '') {
  const page = await browser.newPage({viewport: {width: 1280, height: 900}, colorScheme});
  page.on('console', m => hold(!['error', 'warning'].includes(m.type()), 'console', m.text()));
  page.on('pageerror', error => hold(false, 'script', error.message));
  page.on('request', request => hold(/^(file|data|blob):/.test(request.url()), 'request', request.url()));
  await page.goto(address + hash, {waitUntil: 'load'});
  return page;
}

for (const [kind, flags] of Object.entries(kinds)) {
  const browser = await chromium.launch({executablePath: browser_path(), headless: true, args: [...quiet, ...flags]});
  try {
    if (crowd) {
      await check_crowd(browser, kind);
      continue;
    }
    for (const scheme of ['light', 'dark']) {
      const page = await open(browser, scheme);
      const drawn = await page.textContent('#drawn');
      hold(drawn.startsWith(kind === 'WebGL' ? 'WebGL' : 'a plain canvas'), kind, `drawn by ${drawn}`);
      await check_look(page, kind, scheme);
      const {hit, missed, coloured} = await check_pixels(page, `${kind}, ${scheme}`.replace(', light', ''));
      const lines = await check_contacts(page, kind);
      if (scheme === 'light') await check_controls(page, hold, kind, frames);
      if (scheme === 'dark' && kind === 'WebGL') await check_loss(page);
      console.log(`${kind}, ${scheme}: ${hit} lines of sight met a sphere, ${missed} none, ${coloured} colours, ` +
        `${lines} contacts`);
      await page.close();
    }
    const there = await open(browser, 'light', '#time=1e9&colour=material&azimuth=15&zoom=2&contacts=1&walls=0&x=y');
    const begun = await there.evaluate(() => ({...window.ricochetView.state, ...window.ricochetView.camera}));
    hold(begun.moment === frames.length - 1 && begun.colour === 'material' && begun.azimuth === 15 &&
      begun.zoom === 2 && begun.contacts && !begun.walls, `${kind}, address`, JSON.stringify(begun));
  } finally {
    await browser.close();
  }
}
for (const line of found.slice(0, 20)) console.error(line);
console.log(`${checks} checks, ${found.length} findings`);
process.exit(found.length ? 1 : 0);
