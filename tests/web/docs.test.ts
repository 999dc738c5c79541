import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { DirectedEdgesMesh, HalfedgeMesh, init } from 'halfedge';
import { filesBelow } from '../../scripts/lib/files.mjs';
import { root } from '../../scripts/lib/run.mjs';

const pages = ['README.md', 'CHANGELOG.md', 'bench/README.md', 'examples/README.md']
  .map((name) => join(root, name))
  .concat(filesBelow(join(root, 'docs')).filter((path: string) => path.endsWith('.md')));

/** The lines of a page that are not code. */
function prose(path: string): string {
  return readFileSync(path, 'utf8').replaceAll(/^```.*?^```/gms, '');
}

/** What a `#` can lead to, as GitHub makes it of the headings. */
function anchors(path: string): Set<string> {
  const found = new Set<string>();
  for (const [, heading] of prose(path).matchAll(/^#+ +(.*)$/gm)) {
    const words = heading.replaceAll(/\[([^\]]*)\]\([^)]*\)/g, '$1').toLowerCase();
    const slug = words.replaceAll(/[^\p{L}\p{N}_ -]/gu, '').replaceAll(' ', '-');
    let anchor = slug;
    for (let n = 1; found.has(anchor); n++) anchor = `${slug}-${n}`;
    found.add(anchor);
  }
  return found;
}

test.each(pages.map((path) => relative(root, path)))('links of %s lead somewhere', (name) => {
  const path = join(root, name);
  const links = [...prose(path).matchAll(/\]\((?!https?:)([^)#\s]*)(#[^)\s]*)?\)/g)];
  const broken = links.filter(([, file, anchor]) => {
    const target = file === '' ? path : resolve(dirname(path), file);
    return !existsSync(target) || (anchor && !anchors(target).has(anchor.slice(1)));
  });
  expect(broken.map(([link]) => link)).toEqual([]);
});

test.each(pages.map((path) => relative(root, path)))(
  'rows of tables in %s have as many cells as their heads',
  (name) => {
    const cells = (row: string) => row.split(/(?<!\\)\|/).length - 2;
    const tables = prose(join(root, name)).matchAll(/^\|.*\n\|[-:| ]+\|\n(?:\|.*\n?)*/gm);
    const wrong = [...tables].flatMap(([table]) => {
      const [head = '', ...rows] = table.trimEnd().split('\n');
      return rows.filter((row) => cells(row) !== cells(head));
    });
    expect(wrong).toEqual([]);
  },
);

/** Said by pages of the npm package that link to what it leaves out. */
const NEEDS_REPOSITORY = /^Links that lead out of `docs` need the repository: /m;

test.each(
  pages.map((path) => relative(root, path)).filter((name) => /^(docs|CHANGELOG)/.test(name)),
)('%s links to files of the npm package, or says that others are in the repository', (name) => {
  const path = join(root, name);
  const files = [...prose(path).matchAll(/\]\((?!https?:)([^)#\s]+)/g)]
    .map(([, file]) => relative(root, resolve(dirname(path), file)))
    .filter((file) => !/^(README|CHANGELOG|docs\/[^/]+|docs\/reference\/[^/]+)\.md$/.test(file));
  if (files.some((file) => file.startsWith('docs/'))) expect(files).toEqual([]);
  expect(NEEDS_REPOSITORY.test(prose(path))).toBe(files.length > 0);
});

test('docs/editing.md explains all policies of attributes, and that undo neither adds nor removes any', async () => {
  await init();
  const { attributes, history } = HalfedgeMesh.cube();
  const policies = () => attributes.add('face', 'heat', { onSplit: 'x' as 'copy' });
  expect(policies).toThrow(/expected '/);
  const rows = prose(join(root, 'docs/editing.md'));
  try {
    policies();
  } catch (error) {
    const [, list] = (error as Error).message.split('expected ');
    const names = [...list.matchAll(/'([\w-]+)'/g)].map(([, name]) => name);
    expect(names.filter((name) => !rows.includes(`\n| \`${name}\``))).toEqual([]);
  }
  history.enabled = true;
  attributes.add('face', 'heat');
  expect(history.canUndo).toBe(false);
  attributes.remove('face', 'heat');
  expect(history.canUndo).toBe(false);
  expect(rows).toContain("Adding or removing a column isn't undone");
});

test('README.md says what the npm package has of what it links to', () => {
  const guides = /^(CHANGELOG|docs\/.+)\.md$/;
  const files = [...prose(join(root, 'README.md')).matchAll(/\]\((?!https?:)([^)#\s]+)/g)];
  expect(files.filter(([, file]) => !guides.test(file)).length).toBeGreaterThan(0);
  expect(readFileSync(join(root, 'README.md'), 'utf8')).toMatch(
    /^The npm package has the guides, the reference and the changelog\. The pictures and all other links of this page need the\s+repository\.$/m,
  );
});

/** The public names of a class and of those that it extends. */
function namesOf(type: typeof HalfedgeMesh | typeof DirectedEdgesMesh): string[] {
  const names = new Set<string>();
  for (let own = type.prototype; own !== Object.prototype; own = Object.getPrototypeOf(own)) {
    for (const name of Object.getOwnPropertyNames(own)) names.add(name);
  }
  for (let own = type; own !== Function.prototype; own = Object.getPrototypeOf(own)) {
    for (const name of Object.getOwnPropertyNames(own)) names.add(`${type.name}.${name}`);
  }
  const ofAll = [
    'constructor',
    ...['length', 'name', 'prototype'].map((name) => `${type.name}.${name}`),
  ];
  return [...names].filter((name) => !ofAll.includes(name));
}

test.each([
  ['mesh.md', HalfedgeMesh, 200],
  ['directed-edges.md', DirectedEdgesMesh, 60],
] as const)('docs/reference/%s has all that the class has', (file, type, least) => {
  const headings = prose(join(root, 'docs/reference', file)).matchAll(/^#+ (.*)$/gm);
  const shown = new Set(Array.from(headings, ([, heading]) => heading));
  const names = namesOf(type);
  expect(names.length).toBeGreaterThan(least);
  expect(names.filter((name) => !shown.has(name))).toEqual([]);
});

test.each([
  ['bundlers.md', 'core-base64.js', /larger, or (\d+) kB\s+with gzip/],
  ['figure.md', 'figure/standalone.js', /file is ([\d,]+) kB with gzip/],
  ['exercise.md', 'exercise/standalone.js', /file is ([\d,]+) kB with gzip/],
])('docs/%s tells the size of dist/%s', (page, file, sentence) => {
  const [, size] = sentence.exec(prose(join(root, 'docs', page))) ?? [];
  const told = 1000 * Number(size?.replace(',', ''));
  const actual = gzipSync(readFileSync(join(root, 'dist', file)), { level: 9 }).length;
  expect(Math.abs(told / actual - 1)).toBeLessThan(0.03);
});

test('the calls that the README lists run one after the other', async () => {
  await init();
  const [, text] = /^## Meshes and circulators\s+```js\n(.*?)^```/ms.exec(
    readFileSync(join(root, 'README.md'), 'utf8'),
  ) as RegExpExecArray;
  const given = {
    HalfedgeMesh,
    positions: Float32Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 2, 0, 1, 2, 0, 2, 2, 0]),
    indices: Uint32Array.of(0, 1, 2, 0, 2, 3),
    faces: [0],
    ...{ h: 0, v: 0, e: 0, f: 0, a: 0, b: 1, x: 1, y: 2, z: 3 },
  };
  const run = new Function(...Object.keys(given), `${text}\nreturn mesh.disposed;`);
  expect(run(...Object.values(given))).toBe(true);
});
