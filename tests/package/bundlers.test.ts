import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { filesBelow } from '../../scripts/lib/files.mjs';
import { disconnect, titleOf, visit } from './support/browser.js';
import { EXPECTED, page, program, startWorker, TITLE } from './support/programs.js';
import { node, project, tool } from './support/project.js';
import { type RunningServer, STRICT_POLICY, serve, serveWith } from './support/server.js';

/** Shows what the page says and what its worker says, when both are there. */
const BOTH = `
const said = {};
const say = (who) => (text) => {
  said[who] = text;
  if (said.page && said.worker) document.title = said.page + ', in a worker ' + said.worker;
};
`;
const EXPECTED_OF_BOTH = `${EXPECTED}, in a worker ${EXPECTED}`;

const sources = {
  'package.json': '{ "private": true, "type": "module" }',
  'src/index.js': BOTH + program("say('page')") + startWorker("say('worker')"),
  'src/worker.js': program('postMessage'),
};

afterAll(disconnect);

/** Visits a page and closes its server. */
async function visitOnce(server: RunningServer) {
  try {
    return await visit(server.address);
  } finally {
    await server.close();
  }
}

const wasmBelow = (folder: string) => filesBelow(folder).filter((path) => path.endsWith('.wasm'));

describe.each(['vite', 'vite-7'])('Through %s', (name) => {
  const vite = tool(`${name}/bin/vite.js`);
  const atAnyPort = ['--host', '127.0.0.1', '--port', '0'];
  let folder: string;
  let output: string;
  beforeAll(async () => {
    folder = project(name, { ...sources, 'index.html': page('/src/index.js') });
    output = await node(folder, vite, 'build');
  });

  test('it is built without a warning, its WebAssembly a hashed asset', () => {
    expect(output).not.toMatch(/warn|externalized|node:/i);
    const assets = readdirSync(join(folder, 'dist/assets'));
    expect(assets.filter((asset) => asset.endsWith('.wasm'))).toEqual([
      expect.stringMatching(/^core-[\w-]{8}\.wasm$/),
    ]);
  });

  test('the build runs in a page and in a worker, under the strict policy', async () => {
    const server = await serve(join(folder, 'dist'), { policy: STRICT_POLICY });
    const { title, complaints } = await visitOnce(server);
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED_OF_BOTH);
  });

  test('the build runs in its preview', async () => {
    const { title, complaints } = await visitOnce(
      await serveWith(folder, vite, 'preview', ...atAnyPort),
    );
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED_OF_BOTH);
  });

  test('the development server runs it in a page and in a worker', async () => {
    const { title, complaints } = await visitOnce(await serveWith(folder, vite, ...atAnyPort));
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED_OF_BOTH);
  });
});

describe('Through webpack', () => {
  let folder: string;
  let stats: { errors: unknown[]; warnings: unknown[] };
  beforeAll(async () => {
    folder = project('webpack', sources);
    const webpack = tool('webpack/bin/webpack.js');
    // Without its hint at every asset over 244 KiB: core.wasm is larger, as is three.js. What counts is
    // the compressed size, for which there is a budget.
    const options = ['--mode', 'production', '--no-performance', '--json', 'stats.json'];
    await node(folder, webpack, ...options);
    stats = JSON.parse(readFileSync(join(folder, 'stats.json'), 'utf8'));
    writeFileSync(join(folder, 'dist/index.html'), page('main.js'));
  });

  test('it is built without a warning, its WebAssembly a hashed asset', () => {
    expect(stats.errors).toEqual([]);
    expect(stats.warnings).toEqual([]);
    expect(wasmBelow(join(folder, 'dist'))).toEqual([
      expect.stringMatching(/\/[0-9a-f]{20}\.wasm$/),
    ]);
  });

  test('the build runs in a page and in a worker, under the strict policy', async () => {
    const server = await serve(join(folder, 'dist'), { policy: STRICT_POLICY });
    const { title, complaints } = await visitOnce(server);
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED_OF_BOTH);
  });
});

describe('Through esbuild', () => {
  test('what it leaves behind is told with what to do about it', async () => {
    const folder = project('esbuild-module', {
      'main.js': program(TITLE),
      'index.html': page('bundle.js'),
    });
    const options = ['--bundle', '--format=esm', '--outfile=bundle.js'];
    await node(folder, tool('esbuild/bin/esbuild'), 'main.js', ...options);
    const server = await serve(folder);
    const told = await titleOf(server.address);
    expect(told).toContain('/core.wasm: the server answered 404');
    expect(told).toContain(
      'copy it from halfedge/dist to the folder of the script, or import from',
    );
    copyFileSync(join(folder, 'node_modules/halfedge/dist/core.wasm'), join(folder, 'core.wasm'));
    expect(await visitOnce(server)).toMatchObject({ title: EXPECTED, complaints: [] });
  });

  test('`halfedge/inline` becomes one file that runs without a server', async () => {
    const folder = project('esbuild', {
      'main.js': program(TITLE, { from: 'halfedge/inline' }),
    });
    const options = ['--bundle', '--minify', '--format=iife', '--outfile=bundle.js'];
    const output = await node(folder, tool('esbuild/bin/esbuild'), 'main.js', ...options);
    expect(output).not.toMatch(/warning/i);
    const script = readFileSync(join(folder, 'bundle.js'), 'utf8');
    const file = join(folder, 'single.html');
    writeFileSync(file, `<!doctype html><meta charset="utf-8"><script>${script}</script>`);
    const { title, complaints, requests } = await visit(`file://${file}`);
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED);
    expect(requests).toHaveLength(1);
  });
});
