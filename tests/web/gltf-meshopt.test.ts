import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { readGltf } from 'halfedge/gltf';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { BYTE, base64, FLOAT, read, rejection, SHORT } from './support/gltf.js';
import { random } from './support/random.js';

declare const THREE: string;

beforeAll(async () => {
  await init();
  await MeshoptEncoder.ready;
});

const UNSIGNED = 5125;
const EXT = 'EXT_meshopt_compression';
const KHR = 'KHR_meshopt_compression';

interface Rows {
  readonly values: ArrayBufferView;
  readonly count: number;
  readonly mode: 'ATTRIBUTES' | 'TRIANGLES' | 'INDICES';
  readonly filter?: string;
}

/**
 * A document as gltfpack writes it: each view compressed in buffer 0, and in buffer 1, which has no
 * bytes, where it would lie if it weren't.
 */
function compressed(views: readonly Rows[], rest: object, name = EXT) {
  const packed = views.map(({ values, count, mode }) => {
    const { buffer, byteOffset, byteLength } = values;
    const bytes = new Uint8Array(buffer as ArrayBuffer, byteOffset, byteLength);
    const stride = byteLength / count;
    return MeshoptEncoder.encodeGltfBuffer(bytes, count, stride, mode, name === KHR ? 1 : 0);
  });
  const ends = (sizes: number[]) =>
    sizes.map((_, i) => sizes.slice(0, i + 1).reduce((a, b) => a + b));
  const [packedEnds, rawEnds] = [
    ends(packed.map(({ length }) => length)),
    ends(views.map(({ values }) => values.byteLength)),
  ];
  const uri = `data:application/octet-stream;base64,${base64(...packed)}`;
  return {
    asset: { version: '2.0' },
    extensionsUsed: [name, 'KHR_mesh_quantization'],
    extensionsRequired: [name, 'KHR_mesh_quantization'],
    buffers: [
      { byteLength: packedEnds.at(-1) as number, uri },
      { byteLength: rawEnds.at(-1) as number, extensions: { [name]: { fallback: true } } },
    ],
    bufferViews: views.map(({ values: { byteLength }, count, mode, filter }, i) => ({
      buffer: 1,
      byteOffset: rawEnds[i] - byteLength,
      byteLength,
      ...(mode === 'ATTRIBUTES' ? { byteStride: byteLength / count } : {}),
      extensions: {
        [name]: {
          buffer: 0,
          byteOffset: packedEnds[i] - packed[i].length,
          byteLength: packed[i].length,
          byteStride: byteLength / count,
          count,
          mode,
          ...(filter ? { filter } : {}),
        },
      },
    })),
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    ...rest,
  };
}

const accessor = (bufferView: number, componentType: number, count: number, type: string) => ({
  ...{ bufferView, componentType, count, type },
});

/** A sphere, its positions and corners compressed. */
function sphere(name = EXT) {
  const mesh = HalfedgeMesh.icoSphere(3);
  const { indices } = mesh.toTriangles();
  const positions = mesh.positions.slice();
  const [vertices, corners] = [mesh.vertexCount, indices.length];
  const json = compressed(
    [
      { values: positions, count: vertices, mode: 'ATTRIBUTES' },
      { values: indices, count: corners, mode: 'TRIANGLES' },
    ],
    {
      accessors: [accessor(0, FLOAT, vertices, 'VEC3'), accessor(1, UNSIGNED, corners, 'SCALAR')],
    },
    name,
  );
  return { mesh, json, positions, indices };
}

/** The corners of each face, each beginning with its smallest. */
const faces = (mesh: HalfedgeMesh) =>
  [...mesh.faces()]
    .map((f): number[] => [...mesh.faceVertices(f)])
    .map((face) => {
      const first = face.indexOf(Math.min(...face));
      return [...face.slice(first), ...face.slice(0, first)].join(' ');
    })
    .sort();

describe('Geometry that meshopt has compressed', () => {
  test.each([
    [EXT, undefined],
    [KHR, THREE === 'three' ? undefined : MeshoptDecoder], // the oldest one's is older than that extension
    [EXT, MeshoptDecoder],
  ])('is read (%s)', async (name, meshoptDecoder) => {
    const { mesh, json } = sphere(name);
    const opened = await read(json, { meshoptDecoder });
    expect(opened.report.problems).toEqual([]);
    expect(opened.report.format).toBe('gltf');
    expect([...opened.mesh.positions]).toEqual([...mesh.positions]);
    expect(faces(opened.mesh)).toEqual(faces(mesh));
  });

  test('is read where positions and normals lie in one view, and corners as a sequence', async () => {
    const { mesh, positions, indices } = sphere();
    const count = mesh.vertexCount;
    const rows = new Float32Array(6 * count);
    for (let v = 0; v < count; v++) {
      const at = positions.subarray(3 * v, 3 * v + 3);
      rows.set(at, 6 * v);
      rows.set(at, 6 * v + 3); // of length 1
    }
    const json = compressed(
      [
        { values: rows, count, mode: 'ATTRIBUTES' },
        { values: Uint16Array.from(indices), count: indices.length, mode: 'INDICES' },
      ],
      {
        accessors: [
          accessor(0, FLOAT, count, 'VEC3'),
          accessor(1, SHORT, indices.length, 'SCALAR'),
          { ...accessor(0, FLOAT, count, 'VEC3'), byteOffset: 12 },
        ],
        meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 2 }, indices: 1 }] }],
      },
    );
    const opened = await read(json);
    expect([...opened.mesh.positions]).toEqual([...mesh.positions]);
    expect(faces(opened.mesh)).toEqual(faces(mesh));
    const normals = opened.mesh.attributes.get('vertex', 'normal');
    expect([...(normals ?? [])]).toEqual([...mesh.positions]);
  });

  test('is read where positions are quantised, or rounded by a filter', async () => {
    const { mesh, positions, indices } = sphere();
    const count = mesh.vertexCount;
    const bytes = new Uint8Array(4 * count);
    positions.forEach((x, i) => {
      bytes[4 * Math.floor(i / 3) + (i % 3)] = Math.round(127.5 + 127.5 * x);
    });
    const bits = 16;
    const filtered = MeshoptEncoder.encodeFilterExp(positions, count, 12, bits);
    const corners = { values: indices, count: indices.length, mode: 'TRIANGLES' } as const;
    const views = [
      [{ values: bytes, count, mode: 'ATTRIBUTES' } as const, 2 / 255, BYTE],
      [
        { values: filtered, count, mode: 'ATTRIBUTES', filter: 'EXPONENTIAL' } as const,
        2 ** (2 - bits),
        FLOAT,
      ],
    ] as const;
    for (const [rows, error, type] of views) {
      const isByte = type === BYTE;
      const json = compressed([rows, corners], {
        accessors: [
          { ...accessor(0, type, count, 'VEC3'), normalized: isByte },
          accessor(1, UNSIGNED, indices.length, 'SCALAR'),
        ],
      });
      const opened = await read(json);
      expect(opened.mesh.vertexCount).toBe(count);
      expect(faces(opened.mesh)).toEqual(faces(mesh));
      opened.mesh.positions.forEach((x, i) => {
        const expected = isByte ? (1 + mesh.positions[i]) / 2 : mesh.positions[i];
        expect(Math.abs(x - expected)).toBeLessThan(error);
      });
    }
  });

  test.each([
    ['buffer', 7, 'parse-error', `extensions.${EXT}.buffer is 7, expected an index from 0 to 1.`],
    ['byteLength', 1e6, 'parse-error', 'of buffer 0.'],
    ['byteStride', 13, 'parse-error', 'byteStride is 13, expected a size of rows of ATTRIBUTES.'],
    ['count', 100, 'parse-error', 'is 1200 bytes, 100 rows of 12, expected 7704 as the view has.'],
    ['count', 1e9, 'too-large', 'has 12000000000 bytes, expected at most 2147483648.'],
    ['count', 1.5, 'parse-error', 'count is 1.5, expected an integer from 0.'],
    ['mode', 'ZIP', 'parse-error', 'mode is "ZIP", expected ATTRIBUTES, TRIANGLES, INDICES.'],
    ['byteLength', 100, 'parse-error', "glTF: three.js can't read the file: Malformed buffer data"],
  ])('is refused where %s is %p (%s)', async (key, value, code, sentence) => {
    const { json } = sphere();
    Object.assign(json.bufferViews[0].extensions[EXT], { [key]: value });
    const error = await rejection(read(json));
    expect(error).toBeInstanceOf(HalfedgeError);
    expect(error.message).toContain(sentence);
    expect(error.code).toBe(code);
  });

  test('gives a mesh or a HalfedgeError whatever is changed in its bytes', async () => {
    const seed = 7;
    const next = random(seed);
    const { json } = sphere();
    const [head, data] = (json.buffers[0].uri as string).split(',');
    let refused = 0;
    for (let round = 0; round < 200; round++) {
      const bytes = Buffer.from(data, 'base64');
      bytes[Math.floor(next() * bytes.length)] = Math.floor(next() * 256);
      const buffers = [{ ...json.buffers[0], uri: `${head},${base64(bytes)}` }, json.buffers[1]];
      const outcome = await readGltf(JSON.stringify({ ...json, buffers })).catch((error) => error);
      if (outcome instanceof Error) {
        expect([seed, round, outcome]).toEqual([seed, round, expect.any(HalfedgeError)]);
        refused += 1;
      } else {
        const wrong = outcome.mesh
          .validate()
          .filter(({ severity }: { severity: string }) => severity === 'error');
        expect([seed, round, wrong]).toEqual([seed, round, []]);
        outcome.mesh.dispose();
      }
    }
    expect(refused).toBeGreaterThan(0);
    expect(refused).toBeLessThan(200);
  });
});
