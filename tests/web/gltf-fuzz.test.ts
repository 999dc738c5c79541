// Files that are nearly glTF: each gives a valid mesh, or one sentence; soon, and nothing is left behind.
//
// `npm run fuzz -- gltf --minutes 5` goes on with other seeds for so long.

import { mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { readGltf } from 'halfedge/gltf';
import { collected } from './support/collection.js';
import { bytesInUse } from './support/core.js';
import { glbOf, mutated } from './support/mutate-glb.js';
import { random } from './support/random.js';

const FAILURES = fileURLToPath(new URL('../../build/fuzz/failures/gltf/', import.meta.url));
/** Beyond the files that are always tried, and the first seed of those. */
const SECONDS = Number(process.env.HALFEDGE_FUZZ_SECONDS ?? 0);
const SEED = Number(process.env.HALFEDGE_FUZZ_SEED ?? 1);
/** Of the processor, as machines may be busy: nothing here is large. */
const MOST_SECONDS = 5;

const unhandled: unknown[] = [];
const onUnhandled = (reason: unknown) => unhandled.push(reason);

beforeAll(async () => {
  await init();
  process.on('unhandledRejection', onUnhandled);
  // three.js tells the console of what it doesn't like.
  for (const name of ['warn', 'error'] as const) {
    import.meta.jest.spyOn(console, name).mockImplementation(() => {});
  }
});
afterAll(() => {
  process.off('unhandledRejection', onUnhandled);
});

/** A tetrahedron with all that is read: attributes, interleaved and sparse columns, nodes, instances. */
function sample(): Uint8Array {
  const floats = Float32Array.of(
    ...[0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1], // xyz and a normal
    ...[0, 0, 1, 0, 0, 1, 1, 1], // uv
    ...[1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1], // color
    ...[0, 0, 2], // instead of the last position
    ...[1, 0, 0, 2, 0, 0], // where instances stand
  );
  const bytes = new Uint8Array(floats.byteLength + 16);
  bytes.set(new Uint8Array(floats.buffer));
  bytes.set([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 3], floats.byteLength);
  const column = (bufferView: number, type: string, count: number, rest = {}) => ({
    ...{ bufferView, componentType: 5126, type, count },
    ...rest,
  });
  const index = { componentType: 5121, type: 'SCALAR', bufferView: 5 };
  const view = (first: number, length: number, rest = {}) => ({
    ...{ buffer: 0, byteOffset: 4 * first, byteLength: 4 * length, ...rest },
  });
  return glbOf(
    {
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: [0, 2] }],
      nodes: [
        { children: [1], translation: [1, 2, 3], name: 'root' },
        { mesh: 0, scale: [2, -2, 2], rotation: [0, 0, 0, 1] },
        {
          mesh: 1,
          matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1],
          extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: 6 } } },
        },
      ],
      meshes: [
        {
          name: 'one',
          primitives: [
            { attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2, COLOR_0: 3 }, indices: 4 },
          ],
        },
        { primitives: [{ attributes: { POSITION: 5 }, mode: 5, material: 0 }] },
      ],
      materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
      accessors: [
        column(0, 'VEC3', 4, {
          sparse: {
            count: 1,
            indices: { bufferView: 5, byteOffset: 12, componentType: 5121 },
            values: { bufferView: 3 },
          },
        }),
        column(0, 'VEC3', 4, { byteOffset: 12 }),
        column(1, 'VEC2', 4),
        column(2, 'VEC3', 4),
        { ...index, count: 12 },
        column(2, 'VEC3', 4),
        column(4, 'VEC3', 2),
      ],
      bufferViews: [
        view(0, 24, { byteStride: 24 }),
        view(24, 8),
        view(32, 12),
        view(44, 3),
        view(47, 6),
        view(53, 4),
      ],
      buffers: [{ byteLength: bytes.length }],
      extensionsUsed: ['EXT_mesh_gpu_instancing'],
    },
    bytes,
  );
}

/** What becomes of a file: "a mesh", or the code of its error. Throws what no user may meet. */
async function outcomeOf(file: Uint8Array): Promise<string> {
  const begin = process.cpuUsage();
  let outcome = 'a mesh';
  try {
    const resource = () => new Uint8Array(100);
    const { mesh } = await readGltf(file, { resource });
    expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
    mesh.dispose();
  } catch (error) {
    if (!(error instanceof HalfedgeError)) throw error;
    expect(error.message).toMatch(/^[A-Z"g][^\n]{15,}[.)]$/);
    expect(error.message.length).toBeLessThan(500);
    outcome = error.code;
  }
  const { user, system } = process.cpuUsage(begin);
  expect((user + system) / 1e6).toBeLessThan(MOST_SECONDS);
  expect(unhandled).toEqual([]);
  return outcome;
}

/** Tries files that are like these, and keeps the one that fails. */
async function fuzz(files: readonly Uint8Array[], runs: number, seed: number) {
  const outcomes = new Map<string, number>();
  for (let run = 0; run < runs; run++) {
    const file = mutated(files[run % files.length], random(seed * 1_000_003 + run));
    try {
      const outcome = await outcomeOf(file);
      outcomes.set(outcome, (outcomes.get(outcome) ?? 0) + 1);
    } catch (error) {
      const path = `${FAILURES}seed-${seed}-run-${run}.glb`;
      mkdirSync(FAILURES, { recursive: true });
      writeFileSync(path, file);
      throw new Error(`Run ${run} of seed ${seed} fails, see ${path}`, { cause: error });
    }
  }
  return outcomes;
}

test('the sample is read whole', async () => {
  const { mesh, report } = await readGltf(sample());
  expect([mesh.faceCount, report.counts]).toEqual([8, {}]);
  expect([...mesh.position(3)]).toEqual([1, 2, 7]); // the sparse one
  mesh.dispose();
});

test('files like the sample', async () => {
  expect(await outcomeOf(sample())).toBe('a mesh');
  const before = bytesInUse();
  const outcomes = await fuzz([sample()], 300, SEED);
  expect(bytesInUse()).toBe(before);
  // None of these is rare.
  for (const outcome of ['a mesh', 'parse-error', 'truncated', 'unsupported-format']) {
    expect([outcome, outcomes.get(outcome) ?? 0]).toEqual([outcome, expect.any(Number)]);
    expect(outcomes.get(outcome)).toBeGreaterThan(2);
  }
}, 120_000);

const real = collected('good', /\.glb$/i);
const small = () =>
  real.files
    .filter((file) => statSync(file).size < 20_000)
    .map((file) => new Uint8Array(readFileSync(file)));

real.test(
  'files like those of the collection',
  async () => {
    const files = small();
    expect(files.length).toBeGreaterThan(3);
    await fuzz(files, 40, SEED);
  },
  120_000,
);

const longer = SECONDS > 0 ? test : test.skip;
longer(
  `files with other seeds, for ${SECONDS} s`,
  async () => {
    const end = performance.now() + 1000 * SECONDS;
    const files = [sample(), sample(), ...small()];
    const total = new Map<string, number>();
    let seed = SEED;
    while (performance.now() < end) {
      for (const [outcome, count] of await fuzz(files, 500, ++seed)) {
        total.set(outcome, (total.get(outcome) ?? 0) + count);
      }
    }
    console.log(`seeds ${SEED + 1} to ${seed}:`, Object.fromEntries(total));
  },
  1000 * SECONDS + 120_000,
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
