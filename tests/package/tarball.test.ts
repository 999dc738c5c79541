import { readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { filesBelow } from '../../scripts/lib/files.mjs';
import { root } from '../../scripts/lib/run.mjs';
import { node, packed, tool } from './support/project.js';

/** What tsc makes of each module of the package, what the build adds, and what npm always ships. */
function meantToShip(): string[] {
  const sources = join(root, 'web/src');
  const modules = filesBelow(sources)
    .map((path) => relative(sources, path))
    .filter((path) => path.endsWith('.ts') && !path.includes('.d.'))
    .map((path) => `dist/${path.slice(0, -'.ts'.length)}`);
  return [
    'CHANGELOG.md',
    'LICENSE',
    'README.md',
    'package.json',
    'dist/core.js',
    'dist/core.d.ts',
    'dist/core.d.wasm.ts',
    'dist/core.wasm',
    'dist/core-base64.js',
    'dist/figure/frame.html',
    ...filesBelow(join(root, 'docs'))
      .map((path) => relative(root, path))
      .filter((path) => path.endsWith('.md')),
    // The command-line tool is no module to import: it needs no types.
    ...modules.flatMap((path) =>
      path.startsWith('dist/cli/') ? [`${path}.js`] : [`${path}.js`, `${path}.d.ts`],
    ),
  ].sort();
}

describe('The tarball', () => {
  test('holds the package and nothing else', () => {
    expect(packed.files).toEqual(meantToShip());
  });

  test('holds the guides that its README links to', () => {
    const readme = readFileSync(join(root, 'README.md'), 'utf8');
    const guides = [...readme.matchAll(/\]\((docs\/[^)#]*\.md)/g)].map(([, path]) => path);
    expect(guides.length).toBeGreaterThan(5);
    expect(packed.files).toEqual(expect.arrayContaining(guides));
  });

  test('has no dependencies, but for some that single entries need', () => {
    const manifest = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
    expect(manifest).not.toHaveProperty('dependencies');
    const { peerDependencies, peerDependenciesMeta } = manifest;
    // The oldest that work: npm installs nothing beside a release that is out of such a range, wherever it is used.
    expect(peerDependencies).toEqual({
      '@codemirror/commands': '^6.0.0',
      '@codemirror/lang-javascript': '^6.0.0',
      '@codemirror/language': '^6.2.0',
      '@codemirror/state': '^6.0.0',
      '@codemirror/view': '^6.0.0',
      '@lezer/highlight': '^1.0.0',
      acorn: '^8.9.0',
      lit: '^3.0.0',
      three: '>=0.160.0',
      'three-mesh-bvh': '>=0.7.0',
    });
    for (const name of Object.keys(peerDependencies)) {
      expect(peerDependenciesMeta[name]).toEqual({ optional: true });
    }
    const installed = JSON.parse(
      readFileSync(join(packed.folder, 'installed/package-lock.json'), 'utf8'),
    );
    expect(Object.keys(installed.packages)).toEqual(['', 'node_modules/halfedge']);
  });

  test('tells nothing of the machine it was built on', () => {
    const folder = join(packed.folder, 'installed/node_modules/halfedge');
    const telling = filesBelow(folder).filter((path) => readFileSync(path).includes(root));
    expect(telling).toEqual([]);
  });

  test('has no scripts but .js: many servers send .mjs with a type that browsers refuse', () => {
    expect(packed.files.filter((path) => path.endsWith('.mjs'))).toEqual([]);
  });

  test('has no static import that a bundler would take for one of Node', () => {
    const folder = join(packed.folder, 'installed/node_modules/halfedge/dist');
    const importing = filesBelow(folder)
      .filter((path) => path.endsWith('.js') && !path.startsWith(join(folder, 'cli/')))
      .filter((path) =>
        // Nor the command-line tool, which has some.
        /(from|import|require)\s*\(?\s*['"](node:|[^'"]*\/cli\/)/.test(readFileSync(path, 'utf8')),
      );
    expect(importing).toEqual([]);
  });

  test('has no modules that import each other in a circle, of which Rollup warns', () => {
    const folder = join(packed.folder, 'installed/node_modules/halfedge/dist');
    const imports = new Map(
      filesBelow(folder)
        .filter((path) => path.endsWith('.js') && !/standalone|base64|source/.test(path))
        .map((path) => {
          const text = readFileSync(path, 'utf8');
          const froms = text.matchAll(/^(?:import|export)\s[^;']*'(\.[^']+)'/gm);
          return [path, [...froms].map(([, to]) => join(path, '..', to))];
        }),
    );
    const done = new Set<string>();
    const circles: string[] = [];
    const follow = (path: string, way: string[]) => {
      if (way.includes(path)) circles.push([...way, path].map((to) => relative(folder, to)).join());
      if (way.includes(path) || done.has(path)) return;
      for (const to of imports.get(path) ?? []) follow(to, [...way, path]);
      done.add(path);
    };
    for (const path of imports.keys()) follow(path, []);
    expect(imports.size).toBeGreaterThan(200);
    expect(circles).toEqual([]);
  });

  test('pleases publint', async () => {
    const output = await node(root, tool('publint/src/cli.js'), 'run', packed.tarball, '--strict');
    expect(output).toContain('All good!');
  });

  test('has types that resolve everywhere, says attw', async () => {
    const attw = tool('@arethetypeswrong/cli/dist/index.js');
    const format = ['--profile', 'esm-only', '--format', 'json', '--no-definitely-typed'];
    const { analysis } = JSON.parse(await node(root, attw, packed.tarball, ...format));
    expect(Object.keys(analysis.entrypoints).sort()).toEqual([
      '.',
      './core.wasm',
      './dialects',
      './exercise',
      './exercise/judge',
      './exercise/standalone',
      './figure',
      './figure/standalone',
      './gltf',
      './inline',
      './package.json',
      './scene',
      './teaching',
      './three',
      './three/picking',
      './three/picking-thread',
      './three/webgpu',
      './worker',
      './worker-thread',
    ]);
    // What remains is CommonJS, which an ESM package does not serve.
    const problems = analysis.problems.filter(
      (problem: { resolutionKind?: string }) =>
        !['node10', 'node16-cjs'].includes(problem.resolutionKind ?? ''),
    );
    expect(problems).toEqual([]);
  });
});
