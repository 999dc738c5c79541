// The browser that the suites share: Debian's, driven by playwright-core.

import { chromium } from 'playwright-core';
import { which } from '../../scripts/lib/run.mjs';

/** Starts Chromium as a server that test files connect to. */
export function launchChromium() {
  const executablePath = which('chromium') ?? which('chromium-browser');
  if (!executablePath) throw new Error('There is no Chromium on PATH: `npm run setup tests`.');
  const quiet = ['background-networking', 'component-update', 'sync', 'quic'];
  const args = ['--no-sandbox', '--no-first-run', ...quiet.map((name) => `--disable-${name}`)];
  // WebGL in software: it runs where there is no graphics card.
  args.push('--use-angle=swiftshader', '--enable-unsafe-swiftshader');
  return chromium.launchServer({ executablePath, args });
}
