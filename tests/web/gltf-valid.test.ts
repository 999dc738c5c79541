// What Khronos's own validator says of the files that `writeGltf` makes.

import validator, { type Report } from 'gltf-validator';
import { HalfedgeMesh, init } from 'halfedge';
import { type WriteGltfOptions, writeGltf } from 'halfedge/gltf';
import { rejection } from './support/gltf.js';
import {
  annulus,
  bowTie,
  build,
  pillow,
  puncturedTorus,
  randomPolygons,
  triangleAndIsolatedVertex,
} from './support/meshes.js';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

const FORMATS = ['glb', 'gltf'] as const;

const validate = (file: Uint8Array | string): Promise<Report> => {
  const options = { maxIssues: 0, writeTimestamp: false };
  return typeof file === 'string'
    ? validator.validateString(file, options)
    : validator.validateBytes(file, options);
};

/** Everything that it says, also mere information. */
const saidOf = ({ issues }: Report) =>
  issues.messages.map(({ code, pointer = '' }) => `${code} ${pointer}`.trimEnd());

/** All that it may say: texture coordinates are for a texture that somebody gives the material later. */
const UNUSED_UV = 'UNUSED_OBJECT /meshes/0/primitives/0/attributes/TEXCOORD_0';

const triangleCount = (mesh: HalfedgeMesh) =>
  mesh
    .faces()
    .toArray()
    .reduce((sum, f) => sum + Math.max(0, mesh.faceVertices(f).toArray().length - 2), 0);

/** Writes a mesh both ways. The validator must say nothing, or this, and find that many triangles. */
async function expectValid(
  mesh: HalfedgeMesh,
  { said = [], triangles = triangleCount(mesh) }: { said?: string[]; triangles?: number } = {},
): Promise<string[]> {
  const notes: string[] = [];
  for (const format of FORMATS) {
    notes.length = 0;
    const options: WriteGltfOptions = { format, onNote: (note) => notes.push(note) };
    const report = await validate(await writeGltf(mesh, options));
    expect(saidOf(report)).toEqual(said);
    expect(report.issues.truncated).toBe(false);
    expect(report.info?.totalTriangleCount).toBe(triangles);
    expect(report.info?.drawCallCount).toBe(triangles === 0 ? 0 : 1);
  }
  return notes;
}

describe('The validator of glTF finds nothing', () => {
  const shapes: [string, () => HalfedgeMesh][] = [
    ['triangles', () => HalfedgeMesh.icoSphere(2)],
    ['polygons', () => HalfedgeMesh.cube()],
    ['a boundary', () => build(annulus())],
    ['a hole', () => build(puncturedTorus())],
    ['a pinched vertex', () => build(bowTie())],
    ['two faces on the same vertices', () => build(pillow())],
    ['an isolated vertex', () => build(triangleAndIsolatedVertex())],
    [
      'a single triangle in one point',
      () => HalfedgeMesh.fromPolygons(new Float32Array(9), [[0, 1, 2]]),
    ],
  ];
  test.each(shapes)('in %s', async (_, make) => {
    using mesh = make();
    await expectValid(mesh);
  });

  test('in what has no faces, not even an empty chunk', async () => {
    using mesh = new HalfedgeMesh();
    await expectValid(mesh);
    mesh.addVertex([1, 2, 3]);
    expect(await expectValid(mesh)).toEqual(['Left out 1 vertex: there are no faces.']);
    const view = new DataView((await writeGltf(mesh)).buffer);
    expect(view.getUint32(12, true)).toBe(view.byteLength - 20); // the JSON, and nothing behind it
  });

  test('in meshes with deleted slots', async () => {
    using mesh = HalfedgeMesh.icoSphere(2);
    for (const v of [0, 5, 60, 161]) mesh.deleteVertex(v);
    expect(mesh.vertexSlots).toBeGreaterThan(mesh.vertexCount);
    await expectValid(mesh);
    for (const f of mesh.faces().toArray()) mesh.deleteFace(f);
    await expectValid(mesh);
  });

  test.each([
    ['more vertices than a byte counts', 3],
    ['more than two bytes count', 7],
  ])('in %s', async (_, steps) => {
    using mesh = HalfedgeMesh.icoSphere(steps);
    expect(mesh.vertexCount).toBeGreaterThan(steps === 3 ? 2 ** 8 : 2 ** 16);
    await expectValid(mesh, { triangles: mesh.faceCount });
  });

  test('in positions of any size, exact to the last bit of the bounds', async () => {
    using mesh = HalfedgeMesh.tetrahedron();
    const most = 3.4028234663852886e38;
    mesh.positions.set([-most, most, 1e-45, 0.1, -0, -1e-45, Math.PI, 1 / 3, 0]);
    await expectValid(mesh);
    mesh.positions[4] = Number.NaN;
    for (const format of FORMATS) {
      expect(await rejection(writeGltf(mesh, { format }))).toMatchObject({
        code: 'non-finite-position',
      });
    }
  });

  test('in triangles of two vertices, which it says are left out', async () => {
    using mesh = HalfedgeMesh.tetrahedron();
    mesh.makeLoop();
    const h = mesh.makeSegment();
    const cut = (faces: number, triangles: number) =>
      `Cut ${faces} faces into ${triangles} triangles: glTF has no polygons.`;
    expect(await expectValid(mesh)).toEqual([cut(7, 4)]);
    mesh.insertVertexOnEdge(mesh.edge(h));
    const left = 'Left out 2 triangles with a vertex at two corners.';
    expect(await expectValid(mesh, { triangles: 4 })).toEqual([cut(7, 6), left]);
    for (const f of [0, 1, 2, 3]) mesh.deleteFace(f);
    expect(await expectValid(mesh, { triangles: 0 })).toEqual([cut(3, 2), left]);
  });
});

describe('The validator of glTF finds nothing in attributes', () => {
  const kinds = ['vertex', 'halfedge'] as const;

  /** A polygon mesh with an attribute, in each row its own number. */
  function cubeWith(
    kind: (typeof kinds)[number],
    name: string,
    options: Parameters<HalfedgeMesh['attributes']['add']>[2],
    value: (i: number) => number,
  ) {
    const mesh = HalfedgeMesh.cube();
    for (const info of mesh.attributes.list()) mesh.attributes.remove(info.kind, info.name);
    const values = mesh.attributes.add(kind, name, options);
    values.forEach((_, i) => {
      values[i] = value(i);
    });
    return mesh;
  }

  test.each(kinds)('normals of the kind %s, of length 1 or not', async (kind) => {
    const odd = [0, 1e-45, 3e38, Number.NaN, Infinity, -0.5774, 0.5777];
    for (const x of odd) {
      using mesh = cubeWith(kind, 'normal', { components: 3 }, () => x);
      expect((await expectValid(mesh)).length).toBe(x < 0 ? 1 : 2);
    }
  });

  test.each(kinds)(
    'texture coordinates of the kind %s, but that there is no texture',
    async (kind) => {
      for (const x of [0.5, -1e30, Number.NaN]) {
        using mesh = cubeWith(kind, 'uv', { components: 2 }, (i) => i * x);
        await expectValid(mesh, { said: [UNUSED_UV] });
      }
    },
  );

  describe.each(kinds)('of the kind %s', (kind) => {
    test.each([3, 4])('colours of %i components and any type', async (components) => {
      for (const type of ['float32', 'float64', 'uint8', 'uint16'] as const) {
        const options = { components, type };
        const most = { float32: 1, float64: 1, uint8: 255, uint16: 65535 }[type];
        using mesh = cubeWith(kind, 'color', options, (i) => (most * (i % 8)) / 7);
        await expectValid(mesh);
      }
    });

    test('colours brighter than 1 and darker than 0, which it says are changed', async () => {
      const odd = [-1, 1.0000001, -1e-45, 3e38, Number.NaN, -Infinity];
      using mesh = cubeWith(kind, 'color', { components: 4 }, (i) => odd[i % odd.length]);
      expect((await expectValid(mesh)).slice(1)).toEqual([
        `Wrote 0 where the ${kind} attribute "color" is no finite number: glTF has no others.`,
        `Wrote the ${kind} attribute "color" brought between 0 and 1: glTF has no other colours.`,
      ]);
    });
  });

  test('of other names and kinds, which are left out', async () => {
    using mesh = cubeWith('vertex', 'Größe 🜁 \u0000"', { components: 3 }, (i) => i);
    mesh.attributes.add('face', 'material', { type: 'int32', onSplit: 'copy' });
    mesh.attributes.add('vertex', '_CUSTOM', { components: 5 });
    mesh.attributes.add('edge', 'color', { components: 3 });
    expect((await expectValid(mesh)).slice(1).map((note) => note.split(' ')[0])).toEqual(
      Array(4).fill('Left'),
    );
  });
});

describe('The validator of glTF finds nothing in random meshes', () => {
  const PER_BATCH = 40;

  /** Any float32, also those that are no numbers, or a number near 1. */
  const anyNumber = (next: () => number) =>
    next() < 0.5
      ? 2 * next() - 0.5
      : new DataView(Uint32Array.of(2 ** 32 * next()).buffer).getFloat32(0, true);

  const ATTRIBUTES = [
    ...(['float32', 'float64'] as const).flatMap((type) => [
      { name: 'normal', components: 3, type },
      { name: 'uv', components: 2, type },
    ]),
    ...(['float32', 'float64', 'uint8', 'uint16', 'int8'] as const).flatMap((type) =>
      [1, 3, 4].map((components) => ({ name: 'color', components, type })),
    ),
  ];

  function randomMesh(seed: number): HalfedgeMesh {
    const next = random(seed);
    const mesh = build(randomPolygons(seed));
    for (let i = 0; i < 40 * next(); i++) refusalOf(randomEdit(mesh, next));
    for (let i = 0; i < 3; i++) {
      const { name, ...options } = ATTRIBUTES[Math.floor(ATTRIBUTES.length * next())];
      const kind = next() < 0.5 ? 'vertex' : 'halfedge';
      if (mesh.attributes.has(kind, name)) continue;
      const values = mesh.attributes.add(kind, name, options);
      values.forEach((_, at) => {
        values[at] = options.type.startsWith('float') ? anyNumber(next) : 70000 * next();
      });
    }
    const { positions } = mesh;
    positions.forEach((_, i) => {
      const x = anyNumber(next);
      positions[i] = Number.isFinite(x) ? x : 0;
    });
    return mesh;
  }

  test.each(Array.from({ length: 8 }, (_, i) => PER_BATCH * i))(
    'of the seeds from %i on',
    async (first) => {
      let triangles = 0;
      for (let seed = first; seed < first + PER_BATCH; seed++) {
        using mesh = randomMesh(seed);
        const hasUv = mesh.attributes
          .list()
          .some(({ kind, name }) => name === 'uv' && (kind === 'vertex' || kind === 'halfedge'));
        triangles += triangleCount(mesh);
        try {
          await expectValid(mesh, { said: hasUv && mesh.faceCount > 0 ? [UNUSED_UV] : [] });
        } catch (cause) {
          throw new Error(`seed ${seed}`, { cause });
        }
      }
      expect(triangles).toBeGreaterThan(10 * PER_BATCH);
    },
  );
});

describe('The validator of glTF notices', () => {
  interface Document {
    accessors: { min: number[]; max: number[]; componentType: number; count: number }[];
    bufferViews: { byteOffset: number; byteStride?: number; byteLength: number }[];
    meshes: { primitives: { attributes: { POSITION: number }; indices: number }[] }[];
  }

  test.each<[string, string, (document: Document) => void]>([
    ['a bound that is too wide', 'ACCESSOR_MAX_MISMATCH', ({ accessors }) => accessors[0].max[1]++],
    [
      'bad alignment',
      'ACCESSOR_TOTAL_OFFSET_ALIGNMENT',
      ({ bufferViews }) => bufferViews[1].byteOffset--,
    ],
    [
      'the wrong type of indices',
      'MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT',
      ({ accessors, meshes }) => {
        accessors[meshes[0].primitives[0].indices].componentType = 5126;
      },
    ],
    ['rows beyond the end', 'ACCESSOR_TOO_LONG', ({ accessors }) => accessors[0].count++],
  ])('%s', async (_, code, change) => {
    using mesh = HalfedgeMesh.icosahedron();
    const document = JSON.parse(await writeGltf(mesh, { format: 'gltf' }));
    expect(saidOf(await validate(JSON.stringify(document)))).toEqual([]);
    change(document);
    const said = saidOf(await validate(JSON.stringify(document)));
    expect(said.map((line) => line.split(' ')[0])).toContain(code);
  });

  test('bytes that are not what the document says of them', async () => {
    using mesh = HalfedgeMesh.icosahedron();
    const bytes = await writeGltf(mesh);
    const jsonSize = new DataView(bytes.buffer).getUint32(12, true);
    new DataView(bytes.buffer).setFloat32(28 + jsonSize, 7, true);
    expect(saidOf(await validate(bytes))).toEqual([
      'ACCESSOR_MAX_MISMATCH /accessors/0/max/0',
      'ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND /accessors/0/max/0',
    ]);
    expect(saidOf(await validate(bytes.subarray(0, -4)))).toEqual([
      'GLB_UNEXPECTED_END_OF_CHUNK_DATA',
    ]);
  });
});
