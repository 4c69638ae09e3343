// A picture of a run for a document, of the page that `simulate --view` wrote:
//   node picture.mjs PAGE.html#time=0.2&azimuth=30 OUT.jpg|OUT.png MODULES [WIDTH HEIGHT]
// Drawn by WebGL in software, light, without the page around it.

import {writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {browser_path, load_playwright, quiet} from './launch.mjs';

const [page_file, out, modules, width = '720', height = '480'] = process.argv.slice(2);
const [file, hash = ''] = page_file.split('#');
const {chromium} = load_playwright(modules);
const browser = await chromium.launch({executablePath: browser_path(), headless: true,
  args: [...quiet, '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist']});
try {
  const page = await browser.newPage({viewport: {width: 1280, height: 900}, colorScheme: 'light'});
  await page.goto(`${pathToFileURL(resolve(file)).href}#${hash}`);
  const address = await page.evaluate(({size, kind}) => {
    const stage = document.getElementById('stage');
    Object.assign(stage.style, {width: size[0], height: size[1], border: '0'});
    window.ricochetView.draw();
    return stage.toDataURL(kind, 0.88);
  }, {size: [`${width}px`, `${height}px`], kind: out.endsWith('.png') ? 'image/png' : 'image/jpeg'});
  writeFileSync(out, Buffer.from(address.split(',')[1], 'base64'));
} finally {
  await browser.close();
}
