// The explorer as a user meets it: the page with its first mesh, then a mesh of a million faces, from the file to
// a picture at rest, pointing, orbiting, edits. `npm run bench:explorer`; `-- 100000` for other numbers of faces.

import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { argv } from 'node:process';
import { brotliCompressSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import { build, preview } from 'vite';
import { HalfedgeMesh, init } from '../../dist/index.js';
import { root, which } from '../../scripts/lib/run.mjs';
import { edit, orbit, point, prepare, watchOpening } from './explorer-page.mjs';

const SAMPLES = 24;
const explorer = join(root, 'web/explorer');

await init();
const folder = mkdtempSync(join(tmpdir(), 'halfedge-'));
const { faces, file } = largeFile(Number(argv[2]) || 1e6);
// Beside the page that tests may be served, which is in another folder.
const outDir = join(root, 'build/explorer-bench');
await build({ root: explorer, logLevel: 'error', build: { outDir, emptyOutDir: true } });
const server = await preview({
  root: explorer,
  logLevel: 'warn',
  build: { outDir },
  preview: { port: 0, open: false },
});
const browser = await chromium.launch({
  executablePath: which('chromium') ?? which('chromium-browser'),
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
try {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  page.setDefaultTimeout(300_000); // a busy machine takes its time
  await page.addInitScript(prepare);
  const cpu = await cpuOf(page);
  const rows = [...(await first(page)), ...(await large(page, cpu))];
  console.log(table(`Chromium ${browser.version()}; ${faces.toLocaleString('en-GB')} faces`, rows));
} finally {
  await browser.close();
  await server.close();
  rmSync(folder, { recursive: true });
}

/** A torus of so many triangles, as a file. */
function largeFile(count) {
  const around = Math.round(Math.sqrt(count / 4)) * 2;
  const mesh = HalfedgeMesh.torus(around, around / 2, { triangles: true });
  const path = join(folder, 'large.ply');
  writeFileSync(path, mesh.write('ply'));
  return { faces: mesh.faceCount, file: path };
}

/** Returns a function that tells the milliseconds of CPU that the page's main thread has taken. */
async function cpuOf(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  return async () => {
    const { metrics } = await session.send('Performance.getMetrics');
    return 1000 * metrics.find(({ name }) => name === 'TaskDuration').value;
  };
}

/** The page with its first mesh. */
async function first(page) {
  const began = performance.now();
  await page.goto(server.resolvedUrls.local[0]);
  await page.waitForSelector('html[data-state=ready] main.stage[data-mesh]');
  const shown = performance.now() - began;
  const loaded = await page.evaluate(() =>
    performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname),
  );
  const size = (kind) => {
    const contents = loaded
      .filter((path) => path.endsWith(kind))
      .map((path) => readFileSync(join(outDir, path)));
    return kilobytes(contents.reduce((sum, bytes) => sum + brotliCompressSync(bytes).length, 0));
  };
  return [
    ['the page until its first mesh can be used', milliseconds(shown)],
    ['its JavaScript, compressed (brotli)', size('.js')],
    ['its WebAssembly, compressed', size('.wasm')],
  ];
}

/** The large mesh. */
async function large(page, cpu) {
  await page.evaluate(watchOpening);
  const idle = await cpu();
  await page.setInputFiles('[data-file]', file);
  await page.waitForSelector('html[data-state=ready] main.stage[data-mesh="large.ply"]', {
    timeout: 300_000,
  });
  const opening = (await cpu()) - idle;
  const { chosen, decoded, rested } = await page.evaluate(() => globalThis.stages);
  await page.waitForTimeout(15_000); // until the tree has grown
  const pointing = await page.evaluate(point, { times: SAMPLES, pause: 60 });
  const before = await cpu();
  const frames = await page.evaluate(orbit, SAMPLES);
  const turning = ((await cpu()) - before) / frames.length;
  const edits = await page.evaluate(edit, 6);
  return [
    [
      `the file (${kilobytes(statSync(file).size)}) until it is decoded, by a worker`,
      milliseconds(decoded - chosen),
    ],
    ['from there to a picture that can be used', milliseconds(rested - decoded)],
    ['CPU of the main thread for both', milliseconds(opening)],
    ['what is under the pointer', median(pointing)],
    ['our code in a frame of an orbit', median(frames)],
    ['CPU of the main thread for such a frame', milliseconds(turning)],
    ['a flip, until the next frame is drawn', median(edits.map(({ took }) => took))],
    [
      'uploaded to the graphics card because of it',
      kilobytes(middle(edits.map(({ bytes }) => bytes))),
    ],
  ];
}

function middle(values) {
  return values.toSorted((a, b) => a - b)[values.length >> 1];
}

function milliseconds(time) {
  return `${time < 99.5 ? time.toPrecision(2) : Math.round(time).toLocaleString('en-GB')} ms`;
}

function kilobytes(bytes) {
  return `${Math.ceil(bytes / 1000).toLocaleString('en-GB')} kB`;
}

function median(times) {
  return `${milliseconds(middle(times))} (worst ${milliseconds(Math.max(...times))})`;
}

function table(title, rows) {
  return [[title, ''], ['---', '---:'], ...rows]
    .map((cells) => `| ${cells.join(' | ')} |`)
    .join('\n');
}
