import { cpSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { root } from '../../scripts/lib/run.mjs';
import { disconnect, screenshots, withPage } from './support/browser.js';
import { page } from './support/programs.js';
import { node, packed, project, tryNode } from './support/project.js';
import { serve } from './support/server.js';

const example = (name: string) => readFileSync(join(root, 'examples', name), 'utf8');
const programs = readdirSync(join(root, 'examples')).filter((name) => name.endsWith('.mjs'));

/** Two triangles that run along their common edge in the same direction. */
const CLASHING = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 1 3\n';
const PYRAMID = `# A square pyramid without its base
v 0 0 1
v 1 0 0
v 0 1 0
v -1 0 0
v 0 -1 0
f 1 2 3
f 1 3 4
f 1 4 5
f 1 5 2
`;

let folder: string;
beforeAll(() => {
  const names = [...programs, 'page.html'];
  folder = project('examples', {
    ...Object.fromEntries(names.map((name) => [`examples/${name}`, example(name)])),
    'pyramid.obj': PYRAMID,
    'broken.off': 'OFF\n3 1 0\n0 0 0\n1 0 0\n1 one 0\n3 0 1 2\n',
    'clashing.off': CLASHING,
  });
  cpSync(join(folder, 'node_modules/halfedge/dist'), join(folder, 'dist'), { recursive: true });
});
afterAll(disconnect);

test('one_ring.mjs walks counter-clockwise around the apex', async () => {
  const ring = (await node(folder, 'examples/one_ring.mjs')).split('\n');
  const start = ring.indexOf('vertex 1');
  expect([...ring.slice(start), ...ring.slice(0, start)]).toEqual([
    'vertex 1',
    'vertex 2',
    'vertex 3',
    'vertex 4',
  ]);
});

/** One or two programs for each reference document, in both languages: CMake runs those in C++. */
const documented = [
  'openmesh_structure',
  'openmesh_traits',
  'mcguire_queries',
  'mcguire_collapse',
  'cgal_loop',
  'cgal_polyhedron',
];

test.each(documented)('%s.mjs prints what the same program in C++ prints', async (name) => {
  const printed = await node(folder, `examples/${name}.mjs`);
  expect(`${printed}\n`).toBe(example(`${name}.txt`));
});

test('planar_map.mjs prints what the program in C++ does, but for the levels of validity', async () => {
  const printed = await node(folder, 'examples/planar_map.mjs');
  expect(printed).toContain('dual of vertex 6');
  expect(example('planar_map.txt').startsWith(`${printed}\nvalid at level 2: yes`)).toBe(true);
});

test('edge_loop.mjs cuts a strip of quads, and takes it back in one step', async () => {
  expect(await node(folder, 'examples/edge_loop.mjs')).toBe(
    `a cube: 8 vertices, 12 edges, 6 faces
with a loop of 4 edges: 12 vertices, 20 edges, 10 faces
with another of 6: 18 vertices, 32 edges, 16 faces
all quads: true, problems: 0
the second taken back: 12 vertices, 20 edges, 10 faces`,
  );
});

describe('simplify.mjs', () => {
  test('prints what the program in C++ prints', async () => {
    const printed = await node(folder, 'examples/simplify.mjs');
    expect(`${printed}\n`).toBe(example('simplify.txt'));
  });

  test('reduces a file to a tenth of its triangles, and leaves its boundary where it is', async () => {
    const rows = Array.from({ length: 21 }, (_, i) => i);
    const quads = rows.slice(1).flatMap((y) => rows.slice(1).map((x) => 21 * y + x - 21));
    const grid = [
      ...rows.flatMap((y) => rows.map((x) => `v ${x} ${y} ${(x * y) / 100}`)),
      ...quads.map((v) => `f ${v} ${v + 1} ${v + 22} ${v + 21}`),
    ];
    writeFileSync(join(folder, 'grid.obj'), grid.join('\n'));
    expect(await node(folder, 'examples/simplify.mjs', 'grid.obj', 'small.ply')).toMatch(
      /^441 vertices, 800 triangles, Euler characteristic 1\n\d+ vertices, (80|79) triangles, .* 1\nvalid$/,
    );
    const info = await node(folder, 'node_modules/halfedge/dist/cli/main.js', 'info', 'small.ply');
    expect(info).toMatch(/bounding box +0 0 0 to 20 20 4$/m);
  });
});

describe('subdivide.mjs', () => {
  test('prints what the program in C++ prints', async () => {
    const printed = await node(folder, 'examples/subdivide.mjs');
    expect(`${printed}\n`).toBe(example('subdivide.txt'));
  });

  test('subdivides a file twice, by the scheme for its faces', async () => {
    const told = await node(folder, 'examples/subdivide.mjs', 'pyramid.obj', 'smooth.ply');
    expect(told).toMatch(/^64 faces; inside 1 of valence 4, 24 of valence 6; .*; valid$/);
    const info = await node(folder, 'node_modules/halfedge/dist/cli/main.js', 'info', 'smooth.ply');
    expect(info).toMatch(/^faces +64 \(64 triangles\)$/m);
  });
});

describe('flatten.mjs', () => {
  test('flattens half a sphere, with less distortion by cotangent weights', async () => {
    expect(await node(folder, 'examples/flatten.mjs')).toBe(
      `2592 triangles, 96 edges around them
equal weights: 0 triangles turned over; angles change by 5.0 degrees on average
cotangent weights: 0 triangles turned over; angles change by 2.3 degrees on average`,
    );
  });

  test('writes places in the plane as texture coordinates', async () => {
    const told = await node(folder, 'examples/flatten.mjs', 'pyramid.obj', 'flat.obj');
    expect(told).toMatch(/^4 triangles, 4 edges around them\n.* 0 triangles .*\n.* 0 triangles /);
    const lines = readFileSync(join(folder, 'flat.obj'), 'utf8').split('\n');
    const places = lines.filter((line) => line.startsWith('vt ')).map((line) => line.split(' '));
    const radii = places.map(([, u, v]) => Math.hypot(Number(u), Number(v)).toFixed(6));
    expect(radii.sort()).toEqual(['0.000000', ...Array(4).fill('1.000000')]);
  });

  test('says why a surface is no disk', async () => {
    writeFileSync(join(folder, 'closed.obj'), `${PYRAMID}f 2 5 4 3\n`);
    const { ok, output } = await tryNode(folder, 'examples/flatten.mjs', 'closed.obj');
    expect(ok).toBe(false);
    expect(output).toMatch(/^The surface can't be flattened: it has no boundary: .*\.\s*$/);
  });
});

describe('load_file.mjs', () => {
  test('tells counts, topology and validity', async () => {
    expect(await node(folder, 'examples/load_file.mjs', 'pyramid.obj')).toBe(
      `vertices              5
halfedges             16
edges                 8
faces                 4
Euler characteristic  1
components            1
boundary loops        1
genus                 0
valid                 yes`,
    );
  });

  test('tells what it repaired', async () => {
    expect(await node(folder, 'examples/load_file.mjs', 'clashing.off')).toMatch(
      /valid {17}yes\nnoticed: Face \d was turned over, to agree with its neighbours\. \(Line \d\)$/,
    );
  });

  test.each([
    ['without a file', [], /^Usage: /],
    ['for a file that is not there', ['nowhere.obj'], /^nowhere\.obj can't be read: ENOENT/],
    ['for a broken file, with the line', ['broken.off'], /^broken\.off: Line 5: .*\bone\b/],
  ])('ends with one sentence %s', async (_, args, sentence) => {
    const { ok, output } = await tryNode(folder, 'examples/load_file.mjs', ...args);
    expect(ok).toBe(false);
    expect(output).toMatch(sentence);
    expect(output.trim()).not.toContain('\n');
  });
});

describe('page.html', () => {
  /** Opens the example as it lies in the repository, with `dist/` beside its folder. */
  async function withExample(use: Parameters<typeof withPage>[1]) {
    const server = await serve(folder);
    try {
      await withPage(`${server.address}examples/page.html`, use);
    } finally {
      await server.close();
    }
  }

  const saying = (text: string) => `#answer >> text=${text}`;

  test('walks the one-ring of a vertex of choice, of a file of choice', async () => {
    await withExample(async ({ page: tab, complaints }) => {
      await tab.waitForSelector(
        saying('162 vertices, 320 faces. Around vertex 0: 42, 43, 44, 45, 46'),
      );
      await tab.fill('#vertex', '1');
      await tab.waitForSelector(saying('Around vertex 1: 50, 48, 47, 49, 51'));
      await tab.setInputFiles('#file', join(folder, 'pyramid.obj'));
      await tab.waitForSelector(saying('5 vertices, 4 faces. Around vertex 1: 2, 0, 4'));
      expect(complaints).toEqual([]);
    });
  });

  test('draws what lies around the vertex: a click walks there, or edits an edge', async () => {
    await withExample(async ({ page: tab, complaints }) => {
      await tab.waitForSelector(saying('Around vertex 0:'));
      expect(await tab.locator('#picture .ring').count()).toBe(5);
      expect(await tab.locator('#picture circle').count()).toBe(16);
      await tab.locator('#picture [data-vertex="44"] circle').click();
      await tab.waitForSelector(saying('Around vertex 44:'));
      expect(await tab.inputValue('#vertex')).toBe('44');
      expect(await tab.isDisabled('#undo')).toBe(true);
      await tab.selectOption('#operation', 'split');
      await tab.locator('#picture .spoke + .wide').first().click();
      await tab.waitForSelector(saying('163 vertices, 322 faces.'));
      await tab.click('#undo');
      await tab.waitForSelector(saying('162 vertices, 320 faces.'));
      await screenshots(tab, 'example-page');
      expect(complaints).toEqual([]);
    });
  });

  test('says what is wrong with a vertex or a file, and goes on', async () => {
    await withExample(async ({ page: tab, complaints }) => {
      await tab.fill('#vertex', '200');
      await tab.waitForSelector(saying('v is 200; expected a vertex from 0 to 161.'));
      await tab.fill('#vertex', '1');
      await tab.setInputFiles('#file', join(folder, 'broken.off'));
      await tab.waitForSelector(saying('Line 5'));
      await tab.fill('#vertex', '0');
      await tab.waitForSelector(saying('Around vertex 0: 42'));
      expect(complaints).toEqual([]);
    });
  });
});

test('the first program of the README runs as it stands', async () => {
  const readme = readFileSync(
    join(packed.folder, 'installed/node_modules/halfedge/README.md'),
    'utf8',
  );
  const [, script] = /```js\n([\s\S]*?)```/.exec(readme) ?? [];
  const map = '{ "imports": { "halfedge": "./node_modules/halfedge/dist/index.js" } }';
  const site = project('readme', {
    'index.html': page('./main.js', `<script type="importmap">${map}</script>`),
    'main.js': script,
    'bunny.obj': PYRAMID,
  });
  const server = await serve(site);
  try {
    await withPage(server.address, async ({ lines, complaints }) => {
      for (let waited = 0; lines.length < 4 && waited < 60_000; waited += 20) await pause(20);
      expect(complaints).toEqual([]);
      expect(lines.sort()).toEqual(['1', '2', '3', '4']);
    });
  } finally {
    await server.close();
  }
});
