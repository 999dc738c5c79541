import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { EXPECTED, program } from './support/programs.js';
import { node, project } from './support/project.js';
import { type RunningServer, serve } from './support/server.js';

const fromGiven = (kind: string) => `
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
const address = import.meta.resolve('halfedge/core.wasm');
const bytes = await readFile(new URL(address));
const wasm = {
  'a URL': () => new URL(address),
  'a string': () => address,
  'a file path': () => fileURLToPath(address),
  'an ArrayBuffer': () => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length),
  'a Uint8Array': () => new Uint8Array(bytes),
  'a Buffer inside of a larger one': () => Buffer.concat([Buffer.alloc(7), bytes]).subarray(7),
  'a WebAssembly.Module': () => new WebAssembly.Module(bytes),
}['${kind}']();
`;

const inspect = `
const prototypes = [Object, Array, Function, String, Number, Map, Uint32Array, Float32Array];
const names = () => JSON.stringify([
  Object.getOwnPropertyNames(globalThis),
  ...prototypes.map(({ prototype }) => Reflect.ownKeys(prototype).map(String)),
  ['uncaughtException', 'unhandledRejection', 'exit'].map((event) => process.listenerCount(event)),
]);
globalThis.fetch; // Node defines some globals on first use.
const before = names();
const { init, HalfedgeMesh } = await import('halfedge');
await init();
HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]).dispose();
console.log(names() === before ? 'as before' : 'changed');
`;

describe('Installed, in Node,', () => {
  test('it runs five lines', async () => {
    const folder = project('five-lines', {
      'main.mjs': `
import { HalfedgeMesh, init } from 'halfedge';
await init();
const mesh = HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]);
for (const v of mesh.vertexVertices(0)) console.log(v);
`,
    });
    expect(await node(folder, 'main.mjs')).toBe('1\n2\n3');
  });

  test('a bare import has the exports, the same from both entries', async () => {
    const folder = project('exports', {
      'main.mjs': `
import * as main from 'halfedge';
import * as inline from 'halfedge/inline';
console.log(JSON.stringify([Object.keys(main), Object.keys(inline)]));
`,
    });
    const [main, inline] = JSON.parse(await node(folder, 'main.mjs'));
    expect(main).toEqual(expect.arrayContaining(['HalfedgeError', 'HalfedgeMesh', 'NONE', 'init']));
    expect(inline).toEqual(main);
  });

  test('a CommonJS program can import it', async () => {
    const folder = project('commonjs', {
      'main.cjs': `
import('halfedge').then(async ({ init, HalfedgeMesh }) => {
  await init();
  console.log(new HalfedgeMesh().vertexCount);
});
`,
    });
    expect(await node(folder, 'main.cjs')).toBe('0');
  });

  test('a CommonJS program can require it', async () => {
    const folder = project('required', {
      'main.cjs': `
const { init, HalfedgeMesh } = require('halfedge');
init().then(() => console.log(new HalfedgeMesh().vertexCount));
`,
    });
    expect(await node(folder, '--no-warnings', 'main.cjs')).toBe('0');
  });

  test('it leaves prototypes, globals and the handlers of the process alone', async () => {
    const folder = project('globals', { 'main.mjs': inspect });
    expect(await node(folder, 'main.mjs')).toBe('as before');
  });

  test('it runs in a worker thread, also on a module compiled outside', async () => {
    const folder = project('threads', {
      'main.mjs': `
import { readFileSync } from 'node:fs';
import { Worker } from 'node:worker_threads';
const module = new WebAssembly.Module(readFileSync(new URL(import.meta.resolve('halfedge/core.wasm'))));
for (const workerData of [{}, { wasm: module }]) {
  const worker = new Worker(new URL('./worker.mjs', import.meta.url), { workerData });
  await new Promise((resolve) => worker.on('exit', resolve));
}
`,
      'worker.mjs': `
import { workerData } from 'node:worker_threads';
${program('console.log', { options: 'workerData' })}`,
    });
    expect(await node(folder, 'main.mjs')).toBe(`${EXPECTED}\n${EXPECTED}`);
  });

  test('`halfedge/inline` runs without its .wasm', async () => {
    const folder = project('inline', {
      'main.mjs': `
import { rmSync } from 'node:fs';
rmSync(new URL(import.meta.resolve('halfedge/core.wasm')));
${program('console.log', { from: 'halfedge/inline' })}`,
    });
    expect(await node(folder, 'main.mjs')).toBe(EXPECTED);
  });

  test.each([
    'a URL',
    'a string',
    'a file path',
    'an ArrayBuffer',
    'a Uint8Array',
    'a Buffer inside of a larger one',
    'a WebAssembly.Module',
  ])('it takes its WebAssembly as %s', async (kind) => {
    const folder = project('wasm', {
      'main.mjs': fromGiven(kind) + program('console.log', { options: '{ wasm }' }),
    });
    expect(await node(folder, 'main.mjs')).toBe(EXPECTED);
  });

  test('a file that is not WebAssembly is told by its name and its first bytes', async () => {
    const folder = project('not-wasm', {
      'page.html': '<!doctype html><title>Welcome</title>',
      'main.mjs': program('console.log', { options: "{ wasm: './page.html' }" }),
    });
    const output = await node(folder, 'main.mjs');
    expect(output).toContain('HalfedgeError not-webassembly: ');
    expect(output).toContain(pathToFileURL(join(folder, 'page.html')).href);
    expect(output).toContain('<!doctype html>');
  });

  test('a missing file is told by its name', async () => {
    const folder = project('missing', {
      'main.mjs': program('console.log', { options: "{ wasm: './nowhere.wasm' }" }),
    });
    const output = await node(folder, 'main.mjs');
    expect(output).toContain('HalfedgeError init-failed: ');
    expect(output).toContain(pathToFileURL(join(folder, 'nowhere.wasm')).href);
  });

  describe('from a server,', () => {
    let server: RunningServer;
    let folder: string;
    beforeAll(async () => {
      folder = project('served', {});
      server = await serve(join(folder, 'node_modules/halfedge/dist'));
    });
    afterAll(() => server.close());

    test('it takes its WebAssembly by address', async () => {
      const main = program('console.log', { options: `{ wasm: '${server.address}core.wasm' }` });
      expect(await node(folder, '--input-type=module', '--eval', main)).toBe(EXPECTED);
    });

    test('an answer of 404 is told with the address', async () => {
      const address = `${server.address}nowhere.wasm`;
      const main = program('console.log', { options: `{ wasm: '${address}' }` });
      const output = await node(folder, '--input-type=module', '--eval', main);
      expect(output).toContain('HalfedgeError init-failed: ');
      expect(output).toContain(`${address}: the server answered 404`);
    });
  });
});
