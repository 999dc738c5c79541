// The benchmark in Chromium, the one of the system.

import { chromium } from 'playwright-core';
import { which } from '../../scripts/lib/run.mjs';
import { withServer } from './server.mjs';

/**
 * `--no-concurrent-recompilation`: on a busy machine with few processors the compiler threads of V8 can
 * starve for minutes, and then code that never left its lower tiers would be measured.
 */
const FLAGS = ['--no-sandbox', '--js-flags=--no-concurrent-recompilation,--expose-gc'];

export async function inChromium({ say, ...options }) {
  return withChromium(async (browser, address) => {
    const page = await browser.newPage();
    page.on('console', (message) => say(message.text()));
    await page.goto(`${address}/bench/web/page.html`);
    await page.waitForFunction(() => 'bench' in globalThis);
    const measured = await page.evaluate((given) => globalThis.bench(given), options);
    return { engine: `Chromium ${browser.version()}`, ...measured };
  });
}

/** Calls `use(browser, address)`; the project's files are served below the address. */
export async function withChromium(use) {
  const executablePath = which('chromium') ?? which('chromium-browser');
  const browser = await chromium.launch({ executablePath, args: FLAGS });
  try {
    return await withServer((address) => use(browser, address));
  } finally {
    await browser.close();
  }
}
