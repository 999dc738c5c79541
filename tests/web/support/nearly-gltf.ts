// Files that are nearly glTF, and what may become of them: a valid mesh, or one sentence, and soon.

import { mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { HalfedgeError, init } from 'halfedge';
import { readGltf } from 'halfedge/gltf';
import { collected } from './collection.js';
import { glbOf, mutated } from './mutate-glb.js';
import { random } from './random.js';

const FAILURES = fileURLToPath(new URL('../../../build/fuzz/failures/gltf/', import.meta.url));
/** Of the processor, as machines may be busy: nothing here is large. */
const MOST_SECONDS = 5;

const unhandled: unknown[] = [];
const onUnhandled = (reason: unknown) => unhandled.push(reason);

/** To be called once by a file of tests: `outcomeOf` also takes rejections that nobody handles for failures. */
export function watch(): void {
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
}

const real = collected('good', /\.glb$/i);
/** `test`, for what needs the files of the collection. */
export const testWithFiles = real.test;

/** The small files of the collection. */
export function smallFiles(): Uint8Array[] {
  return real.files
    .filter((file) => statSync(file).size < 20_000)
    .map((file) => new Uint8Array(readFileSync(file)));
}

/** A tetrahedron with all that is read: attributes, interleaved and sparse columns, nodes, instances. */
export function sample(): Uint8Array {
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
export async function outcomeOf(file: Uint8Array): Promise<string> {
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

/** How often files that are like these came to what; the first one that fails is kept. */
export async function outcomesNear(files: readonly Uint8Array[], runs: number, seed: number) {
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
