// Opens a page in headless Chromium and holds it against what the reports promise:
//   node check_page.mjs PAGE.html MODULES [SHOTS]
// no error in the console, no request to any network, every picture there and legible on a phone, every link leading
// somewhere and opening what is folded there, nothing wider than the window from 320 to 3840 pixels, an order of focus
// that follows the page, and no finding of axe-core in light or dark.
// MODULES holds node_modules; SHOTS, if given, receives screenshots.

import {existsSync, mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {basename, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

import {axe_file, browser_path, load_playwright, quiet} from './launch.mjs';

const [page_file, modules, shots] = process.argv.slice(2);
const {chromium} = load_playwright(modules);
const address = pathToFileURL(resolve(page_file)).href;
const found = [];
const report = (what, detail) => found.push(`${what}: ${detail}`);

async function check_links(page) {
  const broken = await page.evaluate(() => {
    const missing = [];
    for (const link of document.querySelectorAll('a[href]')) {
      const target = link.getAttribute('href');
      if (target.startsWith('#') && !document.getElementById(target.slice(1))) missing.push(target);
    }
    return missing;
  });
  for (const target of broken) report('link into nowhere', target);
  const files = await page.$$eval('a[href]', links => links.map(link => link.href));
  for (const href of new Set(files)) {
    if (!href.startsWith('file:')) report('link out of the report', href);
    else if (!existsSync(fileURLToPath(href.split('#')[0]))) report('link to a missing file', href);
  }
}

async function check_pictures(page) {
  await page.evaluate(() => Promise.all([...document.images].map(image => image.decode().catch(() => {}))));
  const missing = await page.$$eval('img', images => images
    .filter(i => !i.complete || i.naturalWidth === 0 || !i.alt).map(i => i.alt || i.src.slice(0, 80)));
  for (const alt of missing) report('picture missing or without alternative text', alt);
}

/// On a phone each figure has a picture of its own, whose letters are not much smaller than they were drawn.
async function check_phone(page, scheme) {
  await page.setViewportSize({width: 390, height: 844});
  const small = await page.evaluate(async () => {
    const found = [];
    for (const image of document.querySelectorAll('figure img')) {
      await image.decode();
      const [, width] = /viewBox="0 0 (\d+)/.exec(decodeURIComponent(image.currentSrc)) ?? [];
      const scale = image.clientWidth / Number(width);
      if (image.currentSrc === image.src || !(scale >= 0.75))
        found.push(`${image.alt.slice(0, 60)}: ${scale.toFixed(2)}`);
    }
    return found;
  });
  for (const picture of small) report(`picture on a phone, ${scheme}`, picture);
}

/// A link to what is folded opens it.
async function check_folds(page) {
  const folded = await page.evaluate(() => {
    const inside = [...document.querySelectorAll('a[href^="#"]')].find(
      link => document.getElementById(link.getAttribute('href').slice(1))?.closest('details:not([open])'));
    inside?.setAttribute('data-checked', '');
    return Boolean(inside);
  });
  if (!folded) return;
  const link = page.locator('a[data-checked]');
  await link.click();
  const shown = a => document.getElementById(a.getAttribute('href').slice(1)).checkVisibility();
  await page.waitForFunction(shown, await link.elementHandle(), {timeout: 5000}).catch(() => {});
  if (!await link.evaluate(shown)) report('link', `${await link.getAttribute('href')} leaves folded what it leads to`);
}

/// Everything that can be focused comes in the order of the page, and the focus never gets stuck.
async function check_keyboard(page) {
  const focusable = 'a[href],button:not([hidden]),summary,[tabindex="0"]';
  const stops = Math.min(60, await page.$$eval(focusable, all => all.filter(e => e.checkVisibility()).length));
  let last = -1;
  for (let i = 0; i < stops; ++i) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => [...document.querySelectorAll('*')].indexOf(document.activeElement));
    if (at <= last) return report('keyboard', `stop ${i + 1} does not follow stop ${i}`);
    last = at;
  }
}

async function check_copying(page) {
  for (const button of await page.locator('button[data-copy]:visible').all()) {
    await button.click();
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    const [id, wanted] = await button.evaluate(
      ({dataset}) => [dataset.copy, document.getElementById(dataset.copy).textContent]);
    if (copied !== wanted) report('copy button', `the clipboard does not hold ${id}`);
  }
}

async function check_axe(page, scheme) {
  await page.evaluate(() => { for (const d of document.querySelectorAll('details')) d.open = true; });
  const {violations} = await page.evaluate(() => window.axe.run(document, {resultTypes: ['violations']}));
  for (const v of violations)
    report(`axe-core, ${scheme}`, `${v.id}: ${v.help}: ${v.nodes.length} times, ` +
      `first ${v.nodes[0].target.join(' ')} (${v.nodes[0].failureSummary?.split('\n')[1]?.trim()})`);
  return violations.length;
}

const profile = mkdtempSync(join(tmpdir(), 'ricochet-browser-'));
let pages = 0;
try {
  for (const scheme of ['light', 'dark']) {
    const context = await chromium.launchPersistentContext(join(profile, scheme), {
      executablePath: browser_path(), headless: true, colorScheme: scheme,
      args: [...quiet, '--disable-gpu', '--disable-3d-apis'],
      viewport: {width: 1440, height: 900}, permissions: ['clipboard-read', 'clipboard-write']});
    const page = await context.newPage();
    page.on('console', message => {
      if (['error', 'warning'].includes(message.type())) report('console', message.text());
    });
    page.on('pageerror', error => report('script', error.message));
    page.on('request', request => { if (!/^(file|data|blob):/.test(request.url())) report('request', request.url()); });
    page.on('requestfailed', request => report('request failed', request.url().slice(0, 100)));
    await page.goto(address, {waitUntil: 'load'});
    if (!await page.title()) report('title', 'missing');
    await check_pictures(page);
    if (scheme === 'light') {
      await check_links(page);
      await check_keyboard(page);
      await check_copying(page);
      await check_folds(page);
    }
    await check_phone(page, scheme);
    for (const width of [320, 390, 768, 1440, 3840]) {
      await page.setViewportSize({width, height: width > 2000 ? 2160 : 900});
      const wide = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      if (wide > 0) report('horizontal scroll', `${wide} pixels at a width of ${width}, ${scheme}`);
      if (shots && width !== 3840)
        await page.screenshot(
          {path: join(shots, `${basename(page_file, '.html')}-${scheme}-${width}.png`), fullPage: true});
      ++pages;
    }
    await page.setViewportSize({width: 1440, height: 900});
    await page.addScriptTag({path: axe_file(modules)});
    await check_axe(page, scheme);
    await context.close();
  }
} finally {
  rmSync(profile, {recursive: true, force: true, maxRetries: 5, retryDelay: 200});
}
for (const line of found) console.error(line);
console.log(`${basename(page_file)}: ${pages} views, ${found.length} findings`);
process.exit(found.length ? 1 : 0);
