// Every figure in a folder, or in a page with those for phones, as Chromium draws it: no text leaves the picture, lies
// on another text or on a mark, or has a line of any kind but the grid running through it; and every titled curve has
// its title in a key.
//
//     node check_figures.mjs FOLDER|PAGE.html MODULES

import {readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';

import {browser_path, load_playwright, quiet} from './launch.mjs';

const [place, modules] = process.argv.slice(2);

/// Names and SVG.
function figures() {
  if (!place.endsWith('.html'))
    return readdirSync(place).filter(name => name.endsWith('.svg')).sort()
      .map(name => [name, readFileSync(join(place, name), 'utf8')]);
  const carried = / (srcset|src)="data:image\/svg\+xml;charset=utf-8,([^"]*)"/g;
  return [...readFileSync(place, 'utf8').matchAll(carried)].map(([, kind, address], i) =>
    [`picture ${i + 1}${kind === 'srcset' ? ', for a phone' : ''}`, decodeURIComponent(address)]);
}

/// In the page: what is wrong with its one figure. Boxes shrink by what a font leaves free around its letters.
function complaints() {
  const svg = document.querySelector('svg'), frame = svg.getBoundingClientRect();
  const shrunk = box => ({left: box.left + 1, right: box.right - 1, top: box.top + 0.22 * box.height,
    bottom: box.bottom - 0.22 * box.height});
  const turned = node => {
    const m = node.getScreenCTM();
    return Math.abs(m.b) > 1e-6;
  };
  const texts = [...svg.querySelectorAll('text')].filter(node => node.textContent.trim() !== '').map(node => {
    const box = node.getBoundingClientRect();
    // A turned text leaves its free space left and right.
    const inner = turned(node) ? {left: box.left + 0.22 * box.width, right: box.right - 0.22 * box.width,
      top: box.top + 1, bottom: box.bottom - 1} : shrunk(box);
    return {words: node.textContent.trim(), box, inner};
  }).filter(text => text.box.width > 0);
  const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
  const found = [];
  for (const {words, inner} of texts)
    if (inner.left < frame.left || inner.right > frame.right || inner.top < frame.top || inner.bottom > frame.bottom)
      found.push(`"${words}" leaves the picture`);
  texts.forEach((a, i) => texts.slice(i + 1).forEach(b => {
    if (meet(a.inner, b.inner)) found.push(`"${a.words}" lies on "${b.words}"`);
  }));
  // What is drawn but the grid, which lies behind everything: curves, axes, frames, ticks and other lines without a
  // filling; and marks, by their boxes.
  for (const path of svg.querySelectorAll('path, polyline, line, rect')) {
    const style = getComputedStyle(path);
    if (path.closest('defs') || path.matches('.gridline')) continue;
    if (style.stroke === 'none' || (style.fill !== 'none' && path.localName !== 'line')) continue;
    const length = path.getTotalLength(), matrix = path.getScreenCTM();
    for (let at = 0; at <= length; at += 1.5) {
      const p = path.getPointAtLength(at).matrixTransform(matrix);
      const over = texts.find(({inner}) => p.x > inner.left && p.x < inner.right && p.y > inner.top &&
        p.y < inner.bottom);
      if (over) {
        found.push(`a line runs through "${over.words}"`);
        break;
      }
    }
  }
  for (const mark of svg.querySelectorAll('use')) {
    if (mark.closest('defs')) continue;
    const over = texts.find(({inner}) => meet(inner, mark.getBoundingClientRect()));
    if (over) found.push(`a mark lies on "${over.words}"`);
  }
  // gnuplot draws a curve's key in the curve's group, which it names by the title; a key without room it leaves out.
  for (const curve of svg.querySelectorAll('g[id^="gnuplot_plot_"]')) {
    const title = curve.querySelector('title')?.textContent ?? '';
    if (!title.startsWith('gnuplot_plot_') && !curve.querySelector('text')) found.push(`no key has "${title}"`);
  }
  return {texts: texts.length, found};
}

const browser = await load_playwright(modules).chromium.launch({executablePath: browser_path(), args: quiet});
const page = await browser.newPage({viewport: {width: 1280, height: 1600}});
const files = figures();
let failed = 0;
for (const [name, written] of files) {
  const svg = written.replace(/^<\?xml[^]*?\?>|<!DOCTYPE[^>]*>/g, '');
  await page.setContent(`<!DOCTYPE html><body style="margin:0">${svg}</body>`);
  const {texts, found} = await page.evaluate(complaints);
  if (texts === 0) found.push('no text at all');
  for (const complaint of found) console.error(`${name}: ${complaint}`);
  failed += found.length > 0;
}
await browser.close();
if (files.length === 0) console.error(`${place} has no figure`);
console.log(`${files.length} figures, ${failed} with something to complain of`);
process.exit(failed > 0 || files.length === 0 ? 1 : 0);
