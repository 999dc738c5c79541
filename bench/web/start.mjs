// `npm run bench:start`: what a page loads of the core, and how long `init()` takes. Prints Markdown.

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { root } from '../../scripts/lib/run.mjs';
import { withChromium } from './chromium.mjs';

const STARTS = 15;

const rows = [
  ['file', 'bytes', 'gzip -9', 'brotli'],
  ['---', '---:', '---:', '---:'],
];
for (const name of ['core.wasm', 'core.js']) {
  const bytes = readFileSync(join(root, 'dist', name));
  const sizes = [bytes, gzipSync(bytes, { level: 9 }), brotliCompressSync(bytes)];
  rows.push([name, ...sizes.map(({ length }) => length.toLocaleString('en-GB'))]);
}
print(rows);

print([
  ['`init()`', 'median, ms', 'fastest, ms'],
  ['---', '---:', '---:'],
  row(`Node ${process.version.slice(1)}`, inNode()),
  await withChromium(async (browser, address) =>
    row(`Chromium ${browser.version()}`, await inPages(browser, address)),
  ),
]);

/** Each time in a process of its own. */
function inNode() {
  const program = `
    import { init } from 'halfedge';
    const start = performance.now();
    await init();
    console.log(performance.now() - start);`;
  const start = () =>
    execFileSync(process.execPath, ['--input-type=module', '--eval', program], { cwd: root });
  return Array.from({ length: STARTS }, () => Number(start()));
}

/** Each time in a page that has nothing in its cache. */
async function inPages(browser, address) {
  const times = [];
  while (times.length < STARTS) {
    const context = await browser.newContext();
    const page = await context.newPage();
    await page.goto(`${address}/bench/web/blank.html`);
    times.push(
      await page.evaluate(async () => {
        const { init } = await import('/dist/index.js');
        const start = performance.now();
        await init();
        return performance.now() - start;
      }),
    );
    await context.close();
  }
  return times;
}

function row(engine, times) {
  const sorted = [...times].sort((a, b) => a - b);
  return [engine, sorted[sorted.length >> 1].toFixed(1), sorted[0].toFixed(1)];
}

function print(table) {
  console.log(`${table.map((cells) => `| ${cells.join(' | ')} |`).join('\n')}\n`);
}
