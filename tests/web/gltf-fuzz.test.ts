// Files that are nearly glTF: each gives a valid mesh, or one sentence; soon, and nothing is left behind.
//
// `npm run fuzz -- gltf --minutes 5` tries such files for so long, see tests/fuzz/gltf.fuzz.ts.

import { HalfedgeMesh } from 'halfedge';
import { readGltf } from 'halfedge/gltf';
import { bytesInUse } from './support/core.js';
import { glbOf } from './support/mutate-glb.js';
import {
  outcomeOf,
  outcomesNear,
  sample,
  smallFiles,
  testWithFiles,
  watch,
} from './support/nearly-gltf.js';

watch();

test('the sample is read whole', async () => {
  const { mesh, report } = await readGltf(sample());
  expect([mesh.faceCount, report.counts]).toEqual([8, {}]);
  expect([...mesh.position(3)]).toEqual([1, 2, 7]); // the sparse one
  mesh.dispose();
});

test('files like the sample', async () => {
  expect(await outcomeOf(sample())).toBe('a mesh');
  const before = bytesInUse();
  const outcomes = await outcomesNear([sample()], 300, 1);
  expect(bytesInUse()).toBe(before);
  const common = ['a mesh', 'parse-error', 'truncated', 'unsupported-format'];
  expect(common.filter((outcome) => (outcomes.get(outcome) ?? 0) < 3)).toEqual([]);
}, 120_000);

testWithFiles(
  'files like those of the collection',
  async () => {
    const files = smallFiles();
    expect(files.length).toBeGreaterThan(3);
    await outcomesNear(files, 40, 1);
  },
  120_000,
);

const TRIANGLE = Buffer.from(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer).toString('base64');
/** A document with one triangle, and something odd. */
const odd = (rest: object) =>
  new TextEncoder().encode(
    JSON.stringify({
      asset: { version: '2.0' },
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ bufferView: 0, componentType: 5126, type: 'VEC3', count: 3 }],
      bufferViews: [{ buffer: 0, byteLength: 36 }],
      buffers: [{ byteLength: 36, uri: `data:;base64,${TRIANGLE}` }],
      ...rest,
    }),
  );

test.each<[string, object, string]>([
  ['nothing odd', {}, 'a mesh'],
  ['a node below itself', { nodes: [{ mesh: 0, children: [0] }] }, 'parse-error'],
  ['two nodes below each other', { nodes: [{ children: [1] }, { children: [0] }] }, 'parse-error'],
  [
    'nodes 20,000 deep',
    { nodes: Array.from({ length: 20_000 }, (_, i) => (i ? { children: [i - 1] } : { mesh: 0 })) },
    'parse-error',
  ],
  [
    'a count of 2^32',
    { accessors: [{ bufferView: 0, componentType: 5126, type: 'VEC3', count: 2 ** 32 }] },
    'truncated',
  ],
  [
    'a count of 2^40 and no buffer',
    { accessors: [{ componentType: 5126, type: 'VEC3', count: 2 ** 40 - 1 }] },
    'too-large',
  ],
  ['a buffer of 2^39 bytes', { buffers: [{ byteLength: 2 ** 39, uri: 'data:,' }] }, 'truncated'],
  [
    'positions in the plane',
    { accessors: [{ bufferView: 0, componentType: 5126, type: 'VEC2', count: 4 }] },
    'parse-error',
  ],
  [
    'positions with four coordinates',
    { accessors: [{ bufferView: 0, componentType: 5121, type: 'VEC4', count: 9 }] },
    'parse-error',
  ],
  [
    'indices that are floats',
    { meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 0 }] }] },
    'parse-error',
  ],
  ['a primitive of another mesh', { nodes: [{ mesh: 1 }] }, 'parse-error'],
])('%s', async (_, rest, outcome) => {
  expect(await outcomeOf(odd(rest))).toBe(outcome);
});

test('a large mesh in very many places is refused before it is put there', async () => {
  const count = 30_000;
  const bytes = new Uint8Array(12 * count);
  const file = glbOf(
    {
      asset: { version: '2.0' },
      nodes: Array.from({ length: 3000 }, () => ({ mesh: 0 })),
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ bufferView: 0, componentType: 5126, type: 'VEC3', count }],
      bufferViews: [{ buffer: 0, byteLength: bytes.length }],
      buffers: [{ byteLength: bytes.length }],
    },
    bytes,
  );
  expect(await outcomeOf(file)).toBe('too-large');
  const { mesh } = HalfedgeMesh.parse('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  expect(mesh.faceCount).toBe(1);
  mesh.dispose();
});
