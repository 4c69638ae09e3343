// The pictures of the documents are those that the studies draw now: the same words and marks, lines within half a
// pixel; not what is said about their numbers, whose last digits are a machine's own.
//
//     node check_gallery.mjs DOCS REPORT [--update]    copies the report's figures over those that differ

import {copyFileSync, existsSync, readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';

const [documents, report, update] = process.argv.slice(2);
const pictures = join(documents, 'pictures');

/// Numbers, and what stands between them.
function parts(file) {
  const drawn = readFileSync(file, 'utf8').replace(/<desc[^>]*>[^]*?<\/desc>/, '');
  return drawn.split(/(-?\d+(?:\.\d+)?)/);
}

function differ(a, b) {
  if (a.length !== b.length) return true;
  return a.some((part, i) => i % 2 === 0 ? part !== b[i] : Math.abs(Number(part) - Number(b[i])) > 0.5);
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
console.log(`${shown.size} pictures`);
process.exit(failed > 0 || shown.size === 0 ? 1 : 0);
