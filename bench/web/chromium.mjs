// The benchmark in Chromium, the one of the system.

import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { chromium } from 'playwright-core';
import { root, which } from '../../scripts/lib/run.mjs';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.wasm': 'application/wasm',
};

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
  const server = createServer(serve);
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const executablePath = which('chromium') ?? which('chromium-browser');
  const browser = await chromium.launch({ executablePath, args: FLAGS });
  try {
    return await use(browser, `http://127.0.0.1:${server.address().port}`);
  } finally {
    await browser.close();
    server.close();
  }
}

async function serve(request, response) {
  const { pathname } = new URL(request.url, 'http://localhost');
  // Isolated pages have a finer clock.
  response.setHeader('Cross-Origin-Opener-Policy', 'same-origin');
  response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp');
  try {
    const body = await readFile(join(root, normalize(decodeURIComponent(pathname))));
    response.setHeader('Content-Type', TYPES[extname(pathname)] ?? 'text/plain');
    response.end(body);
  } catch {
    response.writeHead(404).end('Not found');
  }
}
