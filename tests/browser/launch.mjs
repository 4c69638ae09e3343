// Where Chromium and what drives it are found, for every check of a page.

import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

/// MODULES holds node_modules.
const require_from = modules => createRequire(pathToFileURL(join(resolve(modules), 'package.json')));

export const load_playwright = modules => require_from(modules)('playwright-core');
export const axe_file = modules => join(dirname(require_from(modules).resolve('axe-core')), 'axe.min.js');

export const quiet = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync'];

export function browser_path() {
  const path = process.env.CHROMIUM ??
    ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(place => existsSync(place));
  if (path) return path;
  console.error('no Chromium found: install the package chromium, or name it in the variable CHROMIUM');
  process.exit(1);
}
