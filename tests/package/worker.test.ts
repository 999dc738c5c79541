import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { disconnect, titleOf, visit } from './support/browser.js';
import { page, TITLE } from './support/programs.js';
import { install, node, project, tool } from './support/project.js';
import { type RunningServer, STRICT_POLICY, serve, serveWith } from './support/server.js';

/** Its second face is turned over, its third is no face. */
const FILE = 'v 0 0 0\\nv 1 0 0\\nv 1 1 0\\nv 0 1 0\\nf 1 2 3\\nf 1 4 3\\nf 1 1 1\\n';
const EXPECTED = 'OBJ: 2 faces, valid, same as here. Line 1: nonsense is told.';

/** Parses a file and a broken one in a worker, and hands a line about that to `show`. */
const program = (
  show: string,
  { halfedge = 'halfedge', worker = 'halfedge/worker', options = '{}' } = {},
) => `
import { HalfedgeError, HalfedgeMesh, init } from '${halfedge}';
import { parseInWorker } from '${worker}';

const show = ${show};

async function compare() {
  await init();
  const { mesh, report } = await parseInWorker(new Blob(['${FILE}']), ${options});
  const here = HalfedgeMesh.parse('${FILE}');
  const same = String(here.mesh.toBytes()) === String(mesh.toBytes()) && here.report.summary === report.summary;
  const error = await parseInWorker('nonsense', ${options}).catch((error) => error);
  return [
    report.format.toUpperCase() + ': ' + mesh.faceCount + ' faces,',
    mesh.validate().length === 0 ? 'valid,' : 'not valid,',
    same ? 'same as here.' : 'not the same as here.',
    error instanceof HalfedgeError && /^Line 1.*nonsense/.test(error.message) ? 'Line 1: nonsense is told.' : error,
  ].join(' ');
}

compare().then(show, (error) => show(error.name + ' ' + error.code + ': ' + error.message));
`;

const sources = {
  'package.json': '{ "private": true, "type": "module" }',
  'src/index.js': program(TITLE),
};

const atAnyPort = ['--host', '127.0.0.1', '--port', '0'];

afterAll(disconnect);

/** What a page says that can't do it. */
async function titleOnceThere(server: RunningServer): Promise<string> {
  try {
    return await titleOf(server.address);
  } finally {
    await server.close();
  }
}

async function expectWorking(server: RunningServer, path = '') {
  try {
    const { title, complaints } = await visit(server.address + path);
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED);
  } finally {
    await server.close();
  }
}

describe('Installed, a worker makes meshes', () => {
  test('in Node, where it keeps no process alive', async () => {
    const folder = project('worker-node', { 'main.mjs': program('console.log') });
    expect(await node(folder, 'main.mjs')).toBe(EXPECTED);
  });

  test('in Node, many jobs in one, without being terminated', async () => {
    const folder = project('worker-jobs', {
      'main.mjs': `
import { init } from 'halfedge';
import { createMeshWorker } from 'halfedge/worker';
await init();
const worker = createMeshWorker();
const meshes = await Promise.all([1, 2, 3].map(() => worker.parse('${FILE}')));
console.log(meshes.map(({ mesh }) => mesh.faceCount).join());
`,
    });
    expect(await node(folder, 'main.mjs')).toBe('2,2,2');
  });

  test('in a page without a bundler, under the strict policy', async () => {
    const dist = './node_modules/halfedge/dist';
    const folder = project('worker-site', {
      'index.html': page('./main.js'),
      'main.js': program(TITLE, { halfedge: `${dist}/index.js`, worker: `${dist}/worker.js` }),
    });
    await expectWorking(await serve(folder, { policy: STRICT_POLICY }));
  });

  test('in a page that imports the package from another site', async () => {
    const folder = project('worker-cdn', {});
    const cdn = await serve(join(folder, 'node_modules/halfedge'), { origins: '*' });
    try {
      const dist = `${cdn.address}dist`;
      writeFileSync(join(folder, 'index.html'), page('./main.js'));
      const options = { halfedge: `${dist}/index.js`, worker: `${dist}/worker.js` };
      writeFileSync(join(folder, 'main.js'), program(TITLE, options));
      await expectWorking(await serve(folder));
    } finally {
      await cdn.close();
    }
  });

  describe.each(['vite', 'vite-7'])('through %s', (name) => {
    const vite = tool(`${name}/bin/vite.js`);
    let folder: string;
    let output: string;
    beforeAll(async () => {
      folder = project(`worker-${name}`, { ...sources, 'index.html': page('/src/index.js') });
      output = await node(folder, vite, 'build');
    });

    test('built without a warning, under the strict policy', async () => {
      expect(output).not.toMatch(/warn|externalized|node:/i);
      const assets = readdirSync(join(folder, 'dist/assets'));
      expect(assets.filter((asset) => asset.endsWith('.wasm'))).toHaveLength(1);
      await expectWorking(await serve(join(folder, 'dist'), { policy: STRICT_POLICY }));
    });

    test('in development', async () => {
      await expectWorking(await serveWith(folder, vite, ...atAnyPort));
    });

    test('in development, with its copies in a folder of another name', async () => {
      const config = "export default { cacheDir: 'node_modules/.cache/vite/client' };";
      writeFileSync(join(folder, 'vite.config.js'), config); // as in Nuxt
      await expectWorking(await serveWith(folder, vite, ...atAnyPort));
    });
  });

  test('through Vite and webpack only where one is used: a picker has its own', async () => {
    const script = "import { MeshPicker } from 'halfedge/three/picking'; console.log(MeshPicker);";
    const folder = project('worker-unused', {
      'package.json': sources['package.json'],
      'src/index.js': script,
      'index.html': page('/src/index.js'),
    });
    install(folder, ['three', 'three-mesh-bvh']);
    await node(folder, tool('vite/bin/vite.js'), 'build', '--outDir', 'vite');
    const options = ['--mode', 'production', '--no-performance', '--json', 'stats.json'];
    await node(folder, tool('webpack/bin/webpack.js'), ...options);
    const scripts = readdirSync(join(folder, 'vite/assets')).filter((name) => /thread/.test(name));
    expect(scripts).toEqual([expect.stringMatching(/^picking-thread-/)]);
    expect(readFileSync(join(folder, 'stats.json'), 'utf8')).not.toContain('/worker-thread.js');
  });

  describe('through Vite in development, installed above the project,', () => {
    const workspace = (name: string, config = '{}') =>
      project(name, {
        'package.json': '{ "private": true, "workspaces": ["app"] }',
        'app/package.json': sources['package.json'],
        'app/index.html': page('/src/index.js'),
        'app/src/index.js': sources['src/index.js'],
        'app/vite.config.js': `export default ${config};`,
      });
    const develop = (name: string, folder: string) =>
      serveWith(join(folder, 'app'), tool(`${name}/bin/vite.js`), ...atAnyPort);

    test('from Vite 8 on', async () => {
      await expectWorking(await develop('vite', workspace('workspace-vite')));
    });

    test('in Vite 7, which has to leave the package as it is, as the error says', async () => {
      const server = await develop('vite-7', workspace('workspace-vite-7'));
      const advice = "optimizeDeps: { exclude: ['halfedge'] }";
      expect(await titleOnceThere(server)).toContain(`In Vite up to 7, set ${advice}.`);
      const folder = workspace('workspace-vite-7-excluded', `{ ${advice} }`);
      await expectWorking(await develop('vite-7', folder));
    });
  });

  describe('through esbuild', () => {
    const esbuild = tool('esbuild/bin/esbuild');
    const inline = program(TITLE, { halfedge: 'halfedge/inline' });

    test('as its guide says, into modules with core.wasm beside them', async () => {
      const guide = readFileSync('docs/bundlers.md', 'utf8');
      const [, command] = /^esbuild (main\.js .*)$/m.exec(guide) ?? [];
      const [, worker] = /^const worker = (.*mesh-worker\.js.*);$/m.exec(guide) ?? [];
      const folder = project('worker-esbuild', {
        'main.js': program(TITLE, { options: `{ worker: ${worker} }` }),
        'mesh-worker.js': "import 'halfedge/worker-thread';",
        'dist/page/index.html': page('../main.js'), // not beside the bundle
      });
      await node(folder, esbuild, ...String(command).split(' '));
      const wasm = join(folder, 'node_modules/halfedge/dist/core.wasm');
      copyFileSync(wasm, join(folder, 'dist/core.wasm'));
      await expectWorking(await serve(join(folder, 'dist'), { policy: STRICT_POLICY }), 'page/');
    });

    test.each([
      ['esm', 'its script could not be loaded. Some bundlers (Angular, Bun, esbuild, Rollup)'],
      ['iife', 'this script has no address (it was bundled as something else than a module)'],
    ])('as %s without these, the error says what to do', async (format, message) => {
      const folder = project(`worker-esbuild-${format}`, {
        'index.html': page('main.js'),
        'index.js': inline,
      });
      await node(folder, esbuild, 'main=index.js', '--bundle', `--format=${format}`, '--outdir=.');
      const title = await titleOnceThere(await serve(folder));
      expect(title).toContain(message);
      expect(title).toContain('pass { worker: () => new Worker(...) }');
    });
  });

  describe('through esbuild, for Node,', () => {
    const esbuild = tool('esbuild/bin/esbuild');
    const bundle = async (name: string, options: string, ...args: string[]) => {
      const folder = project(name, {
        'package.json': sources['package.json'],
        'main.js': `import { Worker } from 'node:worker_threads';\n${program('console.log', { halfedge: 'halfedge/inline', options })}`,
        'mesh-worker.js': "import 'halfedge/worker-thread';",
      });
      await node(folder, esbuild, '--bundle', '--platform=node', '--outdir=dist', ...args);
      return folder;
    };

    test('as its guide says, with a second entry for workers', async () => {
      const guide = readFileSync('docs/bundlers.md', 'utf8');
      expect(guide).toContain("import { Worker } from 'node:worker_threads'");
      const [, worker] = /^const worker = (.*mesh-worker\.js.*);$/m.exec(guide) ?? [];
      const entries = ['main.js', 'mesh-worker.js', '--splitting', '--format=esm'];
      const folder = await bundle('worker-esbuild-node', `{ worker: ${worker} }`, ...entries);
      expect(await node(folder, 'dist/main.js')).toBe(EXPECTED);
    });

    test('without that, the error says what to do', async () => {
      const folder = await bundle('worker-esbuild-node-left', '{}', 'main.js', '--format=esm');
      expect(await node(folder, 'dist/main.js')).toMatch(
        /Cannot find module .*worker-thread\.js'\. Some bundlers .* pass { worker: \(\) => new Worker\(\.\.\.\) } with that\.$/,
      );
    });

    test('the error says where there are no workers, and nothing of bundles', async () => {
      const lacking = '--banner:js=delete process.getBuiltinModule;'; // as in Cloudflare Workers
      const args = ['main.js', '--format=cjs', '--out-extension:.js=.cjs', lacking];
      const folder = await bundle('worker-esbuild-nowhere', '{}', ...args);
      expect(await node(folder, 'dist/main.cjs')).toBe(
        'HalfedgeError worker-failed: The worker failed: Error: there are no workers here.',
      );
    });
  });

  test('through webpack, without a warning, under the strict policy', async () => {
    const folder = project('worker-webpack', sources);
    const options = ['--mode', 'production', '--no-performance', '--json', 'stats.json'];
    await node(folder, tool('webpack/bin/webpack.js'), ...options);
    const stats = JSON.parse(readFileSync(join(folder, 'stats.json'), 'utf8'));
    expect([stats.errors, stats.warnings]).toEqual([[], []]);
    writeFileSync(join(folder, 'dist/index.html'), page('main.js'));
    await expectWorking(await serve(join(folder, 'dist'), { policy: STRICT_POLICY }));
  });
});
