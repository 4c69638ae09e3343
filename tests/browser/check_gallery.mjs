// The pictures of the documents are those that the studies draw now: the same words and marks, lines within half a
// pixel; not what is said about their numbers, whose last digits are a machine's own. In the gallery each is drawn by
// the command of its section.
//
//     node check_gallery.mjs DOCS REPORT [--update]    copies the report's figures over those that differ

import {copyFileSync, existsSync, readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';

const [documents, report, update] = process.argv.slice(2);
const pictures = join(documents, 'pictures');

const near = 0.5;  // pixels

/// Numbers, and what stands between them; and the lines, whose corners may be others on another machine.
function parts(file) {
  const lines = [];
  const drawn = readFileSync(file, 'utf8').replace(/<desc[^>]*>[^]*?<\/desc>/, '').replace(
    / d='(M[-\d.,MLZ\s]*)'/g, (_, path) => {
      for (const line of path.split('M').slice(1))
        lines.push(line.trim().split(/[\sLZ]+/).filter(corner => corner).map(corner => corner.split(',').map(Number)));
      return '';
    });
  return {words: drawn.split(/(-?\d+(?:\.\d+)?)/), lines};
}

function distance([x, y], [ax, ay], [bx, by]) {
  const [along_x, along_y] = [bx - ax, by - ay], square = along_x ** 2 + along_y ** 2;
  const share = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * along_x + (y - ay) * along_y) / square)) : 0;
  return Math.hypot(x - ax - share * along_x, y - ay - share * along_y);
}

/// A corner of one that the other does not pass.
function leaves(line, other) {
  return line.some(corner => !other.some((next, i) => distance(corner, other[Math.max(0, i - 1)], next) <= near));
}

function differ(a, b) {
  if (a.words.length !== b.words.length || a.lines.length !== b.lines.length) return true;
  if (a.words.some((part, i) => i % 2 === 0 ? part !== b.words[i] : Math.abs(Number(part) - Number(b.words[i])) > near))
    return true;
  return a.lines.some((line, i) => leaves(line, b.lines[i]) || leaves(b.lines[i], line));
}

const shown = new Set();
for (const name of [...readdirSync(documents).filter(name => name.endsWith('.md')).map(name => join(documents, name)),
  join(documents, '..', 'README.md')])
  for (const [, picture] of readFileSync(name, 'utf8').matchAll(/\]\((?:docs\/)?pictures\/([\w-]+\.svg)\)/g))
    shown.add(picture);

let failed = 0;
for (const picture of [...shown].sort()) {
  const ours = join(pictures, picture), theirs = join(report, picture);
  const wrong = !existsSync(theirs) ? 'no study draws it'
    : !existsSync(ours) ? 'is missing' : differ(parts(ours), parts(theirs)) ? 'is not what its study draws now' : '';
  if (!wrong) continue;
  if (update && existsSync(theirs)) {
    copyFileSync(theirs, ours);
    console.log(`${picture}: updated`);
  } else {
    console.error(`${picture}: ${wrong}`);
    ++failed;
  }
}
for (const file of readdirSync(pictures))
  if (file.endsWith('.svg') && !shown.has(file)) {
    console.error(`${file}: no document shows it`);
    ++failed;
  }
const drawn_by = new Map(JSON.parse(readFileSync(join(report, 'report.json'), 'utf8')).studies
  .map(({name, files}) => [name, files ?? []]));
for (const section of readFileSync(join(documents, 'gallery.md'), 'utf8').split('\n## ').slice(1)) {
  const files = [...section.matchAll(/verify (\w+) --figures/g)].flatMap(([, study]) => drawn_by.get(study) ?? []);
  for (const [, picture] of section.matchAll(/\]\(pictures\/([\w-]+\.svg)\)/g))
    if (!files.includes(picture)) {
      console.error(`gallery.md: ${picture} is not drawn by the command of its section`);
      ++failed;
    }
}
console.log(`${shown.size} pictures`);
process.exit(failed > 0 || shown.size === 0 ? 1 : 0);
