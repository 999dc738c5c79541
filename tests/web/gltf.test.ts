import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { readGltf, readGltfParts, writeGltf } from 'halfedge/gltf';
import { collected } from './support/collection.js';
import { bytesInUse, giveCornerAttributes, withFullHeap } from './support/core.js';
import { random } from './support/random.js';

beforeAll(() => init());

const base64 = (...arrays: ArrayBufferView[]) =>
  Buffer.concat(
    arrays.map(({ buffer, byteOffset, byteLength }) => Buffer.from(buffer, byteOffset, byteLength)),
  ).toString('base64');

const FLOAT = 5126;
const SHORT = 5123;
const BYTE = 5121;

interface Column {
  values: Float32Array | Uint16Array | Uint8Array;
  type: string;
  normalized?: boolean;
}

/** A glTF document with a view and an accessor for each column, and whatever else it has. */
function document(columns: Column[], rest: object) {
  let size = 0;
  const views = columns.map(({ values }) => {
    const view = { buffer: 0, byteOffset: size, byteLength: values.byteLength };
    size += Math.ceil(values.byteLength / 4) * 4;
    return view;
  });
  const bytes = new Uint8Array(size);
  columns.forEach(({ values }, i) => {
    bytes.set(new Uint8Array(values.buffer), views[i].byteOffset);
  });
  return {
    asset: { version: '2.0' },
    buffers: [{ byteLength: size, uri: `data:application/octet-stream;base64,${base64(bytes)}` }],
    bufferViews: views,
    accessors: columns.map(({ values, type, normalized = false }, i) => ({
      bufferView: i,
      componentType: { Float32Array: FLOAT, Uint16Array: SHORT, Uint8Array: BYTE }[
        values.constructor.name
      ] as number,
      count: values.length / { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[type as 'VEC3'],
      type,
      normalized,
    })),
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }] as object[],
    ...rest,
  };
}

const SQUARE = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
const CORNERS = new Uint16Array([0, 1, 2, 0, 2, 3]);

/** A square of two triangles, with changes. */
const square = (rest: object = {}) =>
  document(
    [
      { values: SQUARE, type: 'VEC3' },
      { values: CORNERS, type: 'SCALAR' },
    ],
    {
      meshes: [{ name: 'Square.001', primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
      ...rest,
    },
  );

const read = (json: object, options = {}) => readGltf(JSON.stringify(json), options);

async function rejection(promise: Promise<unknown>): Promise<HalfedgeError> {
  return promise.then(
    () => {
      throw new Error('It resolved.');
    },
    (error) => error,
  );
}

describe('readGltf', () => {
  test('reads triangles, with the positions of the file', async () => {
    const { mesh, report } = await read(square());
    expect(mesh.validate()).toEqual([]);
    expect([...mesh.positions]).toEqual([...SQUARE]);
    expect([...mesh.toTriangles().indices]).toEqual([...CORNERS]);
    expect(report).toMatchObject({
      format: 'gltf',
      problems: [],
      summary: 'glTF: 4 vertices, 5 edges, 2 faces.',
    });
  });

  test.each([
    ['a strip', 5, [0, 1, 3, 2]],
    ['a fan', 6, [0, 1, 2, 3]],
    ['triangles without indices', 4, undefined],
  ])('reads %s', async (_, mode, indices) => {
    const whole = indices === undefined;
    const positions = whole ? new Float32Array(18) : SQUARE;
    if (whole)
      CORNERS.forEach((v, i) => {
        positions.set(SQUARE.subarray(3 * v, 3 * v + 3), 3 * i);
      });
    const columns: Column[] = [{ values: positions, type: 'VEC3' }];
    if (!whole) columns.push({ values: new Uint16Array(indices), type: 'SCALAR' });
    const primitive = { attributes: { POSITION: 0 }, mode, ...(whole ? {} : { indices: 1 }) };
    const { mesh } = await read(document(columns, { meshes: [{ primitives: [primitive] }] }));
    expect([mesh.vertexCount, mesh.edgeCount, mesh.faceCount]).toEqual([4, 5, 2]);
    const area = mesh.toTriangles().indices.reduce((sum, _v, i, all) => {
      if (i % 3 !== 0) return sum;
      const [a, b, c] = [0, 1, 2].map((k) => mesh.position(all[i + k]));
      return sum + ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }, 0);
    expect(area).toBe(1); // both counter-clockwise
  });

  test('puts each mesh where its node stands; mirrored ones are turned over', async () => {
    const nodes = [
      { children: [1, 2], translation: [10, 0, 0] },
      { mesh: 0, scale: [2, 2, 2] },
      { mesh: 0, scale: [-1, 1, 1], translation: [0, 5, 0] },
    ];
    const { mesh } = await read(square({ nodes }));
    expect([...mesh.positions]).toEqual([
      ...[10, 0, 0, 12, 0, 0, 12, 2, 0, 10, 2, 0],
      ...[10, 5, 0, 9, 5, 0, 9, 6, 0, 10, 6, 0],
    ]);
    const ccw = (f: number) => {
      const [a, b, c] = [...mesh.faceVertices(f)].map((v) => mesh.position(v));
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
    };
    expect([...mesh.faces()].map(ccw)).toEqual([true, true, true, true]);
  });

  test('reads normals, colours and texture coordinates, of corners where there are seams', async () => {
    const json = document(
      [
        { values: new Float32Array([...SQUARE, 0, 0, 0, 1, 1, 0]), type: 'VEC3' },
        { values: new Uint16Array([0, 1, 2, 4, 5, 3]), type: 'SCALAR' },
        { values: new Float32Array(18).map((_, i) => (i % 3 === 2 ? 1 : 0)), type: 'VEC3' },
        { values: new Float32Array([0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5, 1, 1]), type: 'VEC2' },
        {
          values: new Uint8Array(24).map((_, i) => [9, 8, 7, 255][i % 4]),
          type: 'VEC4',
          normalized: true,
        },
      ],
      {
        meshes: [
          {
            primitives: [
              { attributes: { POSITION: 0, NORMAL: 2, TEXCOORD_0: 3, COLOR_0: 4 }, indices: 1 },
            ],
          },
        ],
        // The scale bends normals, were they only multiplied.
        nodes: [{ mesh: 0, rotation: [Math.SQRT1_2, 0, 0, Math.SQRT1_2], scale: [1, 2, 1] }],
      },
    );
    const { mesh } = await read(json);
    expect(mesh.vertexCount).toBe(4);
    expect(mesh.attributes.list()).toEqual([
      { kind: 'vertex', name: 'normal', type: 'float32', components: 3, onSplit: 'normalize' },
      { kind: 'vertex', name: 'color', type: 'uint8', components: 4, onSplit: 'interpolate' },
      { kind: 'halfedge', name: 'uv', type: 'float32', components: 2, onSplit: 'interpolate' },
    ]);
    const normal = mesh.attributes.get('vertex', 'normal');
    for (let v = 0; v < 4; v++) {
      expect(normal[3 * v]).toBeCloseTo(0);
      expect(normal[3 * v + 1]).toBeCloseTo(-1); // a quarter turn around x takes z to -y
      expect(normal[3 * v + 2]).toBeCloseTo(0);
    }
    expect([...mesh.attributes.get('vertex', 'color')]).toEqual(
      [1, 2, 3, 4].flatMap(() => [9, 8, 7, 255]),
    );
    const uv = mesh.attributes.get('halfedge', 'uv');
    const corner = (f: number, v: number) => {
      const h = [...mesh.faceHalfedges(f)].find((found) => mesh.toVertex(found) === v) as number;
      return [uv[2 * h], uv[2 * h + 1]];
    };
    expect([corner(0, 0), corner(1, 0)]).toEqual([
      [0, 0],
      [0.5, 0.5],
    ]);
    expect([corner(0, 2), corner(1, 2)]).toEqual([
      [1, 1],
      [1, 1],
    ]);
  });

  test('reads quantised and interleaved positions, whose last row ends with the file', async () => {
    const bytes = new Uint8Array([0, 0, 0, 99, 255, 0, 0, 99, 0, 255, 0]);
    const json = {
      asset: { version: '2.0' },
      extensionsUsed: ['KHR_mesh_quantization'],
      extensionsRequired: ['KHR_mesh_quantization'],
      buffers: [{ byteLength: 11, uri: `data:;base64,${base64(bytes)}` }],
      bufferViews: [{ buffer: 0, byteLength: 11, byteStride: 4 }],
      accessors: [{ bufferView: 0, componentType: BYTE, normalized: true, count: 3, type: 'VEC3' }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    };
    const { mesh } = await read(json); // without scenes and nodes, too
    expect([...mesh.positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  });

  test('says what it does not read', async () => {
    const primitives = [
      { attributes: { POSITION: 0 }, mode: 1 },
      { attributes: { POSITION: 0 }, indices: 1, targets: [{ POSITION: 0 }], material: 0 },
    ];
    const { mesh, report } = await read(
      square({
        meshes: [{ primitives }],
        materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
        textures: [{ source: 0 }],
        images: [{ uri: 'nowhere.png' }],
      }),
    );
    expect(mesh.faceCount).toBe(2);
    expect(report.summary).toMatch(
      / Ignored primitives of lines \(1\)\. Ignored morph targets of primitives \(1\)\.$/,
    );
  });

  test('mends what makes no manifold, or refuses it', async () => {
    const clashing = document(
      [
        { values: SQUARE, type: 'VEC3' },
        { values: new Uint16Array([0, 1, 2, 0, 3, 2]), type: 'SCALAR' },
      ],
      { meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }] },
    );
    const { mesh, report } = await read(clashing);
    expect(mesh.validate()).toEqual([]);
    expect(report.counts).toEqual({ 'opposite-orientation': 1 });
    const before = bytesInUse();
    const error = await rejection(read(clashing, { repair: false }));
    expect(error).toMatchObject({
      code: 'opposite-orientation',
      problems: [{ code: 'opposite-orientation', severity: 'error' }],
    });
    expect(bytesInUse()).toBe(before);
    expect((await rejection(read(clashing, { repair: 'no' }))).message).toBe(
      'options.repair is "no"; expected true or false.',
    );
  });

  test('gives all attributes also where adding them lets the memory grow', () => {
    const sphere = HalfedgeMesh.icoSphere(5);
    const positions = sphere.positions.slice();
    const { indices } = sphere.toTriangles();
    const { mesh, report } = HalfedgeMesh.fromSoup(positions, indices);
    const attributes = ['normal', 'color'].map((name) => ({
      name,
      components: 3,
      values: positions.map((x) => x / 2),
    }));
    withFullHeap(() => giveCornerAttributes(mesh, report, indices, attributes));
    for (const name of ['normal', 'color']) {
      expect(mesh.attributes.get('vertex', name)).toEqual(positions.map((x) => x / 2));
    }
    mesh.dispose();
    sphere.dispose();
  });

  test('keeps vertices apart where it is not to weld', async () => {
    const positions = new Float32Array([...SQUARE, 0, 0, 0, 1, 1, 0]);
    const json = document(
      [
        { values: positions, type: 'VEC3' },
        { values: new Uint16Array([0, 1, 2, 4, 5, 3]), type: 'SCALAR' },
      ],
      { meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }] },
    );
    expect((await read(json)).mesh.vertexCount).toBe(4);
    expect((await read(json, { weld: false })).mesh.vertexCount).toBe(6);
  });

  test('gets buffers in other files from where it is told', async () => {
    const json = square();
    const [{ uri, byteLength }] = json.buffers;
    const bytes = Buffer.from(uri.slice(uri.indexOf(',') + 1), 'base64');
    const elsewhere = { ...json, buffers: [{ uri: 'square.bin', byteLength }] };
    const asked: string[] = [];
    const resource = async (name: string) => {
      asked.push(name);
      return new Uint8Array(bytes);
    };
    expect((await read(elsewhere, { resource })).mesh.faceCount).toBe(2);
    expect(asked).toEqual(['square.bin']);
    expect(await rejection(read(elsewhere))).toMatchObject({ code: 'missing-resource' });
    const nowhere = { baseUrl: pathToFileURL('/no/such/folder/square.gltf') };
    const missing = await rejection(read(elsewhere, nowhere));
    expect(missing.message).toMatch(/folder\/square\.bin can't be loaded: ENOENT/);
    const short = await rejection(read(elsewhere, { resource: () => new Uint8Array(3) }));
    expect(short.message).toBe(
      `glTF: buffers[0] has 3 bytes, expected ${byteLength} as the document says.`,
    );
  });
});

describe('readGltfParts', () => {
  test('makes a mesh of each primitive of each node, with the name of its mesh', async () => {
    const parts = await readGltfParts(
      JSON.stringify(
        square({
          nodes: [
            { mesh: 0, children: [1] },
            { mesh: 0, translation: [0, 0, 1] },
          ],
        }),
      ),
    );
    expect(parts.map(({ name, mesh }) => [name, mesh.faceCount, mesh.position(0)])).toEqual([
      ['Square.001', 2, [0, 0, 0]],
      ['Square.001', 2, [0, 0, 1]],
    ]);
  });
});

describe('writeGltf', () => {
  const shown = (mesh: HalfedgeMesh) => ({
    positions: [...mesh.positions],
    triangles: [...mesh.toTriangles().indices],
    attributes: mesh.attributes.list().map(({ kind, name }) => [kind, name]),
  });

  test.each(['glb', 'gltf'] as const)('writes %s that reads back bit for bit', async (format) => {
    const mesh = HalfedgeMesh.icoSphere(3);
    mesh.positions.forEach((x, i) => {
      mesh.positions[i] = x * Math.fround(Math.PI) + 1e-7 * i;
    });
    const written = await writeGltf(mesh, { format });
    expect(typeof written).toBe(format === 'glb' ? 'object' : 'string');
    const again = await readGltf(written);
    expect(again.report.format).toBe(format);
    expect(shown(again.mesh)).toEqual(shown(mesh));
  });

  test('keeps attributes, with their seams and their types', async () => {
    const mesh = HalfedgeMesh.icosahedron();
    const normal = mesh.attributes.add('vertex', 'normal', { components: 3, onSplit: 'normalize' });
    normal.set(
      mesh.positions.map((x, i, p) => {
        const v = i - (i % 3);
        return x / Math.hypot(p[v], p[v + 1], p[v + 2]);
      }),
    );
    const uv = mesh.attributes.add('halfedge', 'uv', { components: 2 });
    uv.forEach((_, i) => {
      uv[i] = Math.fround((i >> 3) / 30);
    });
    const color = mesh.attributes.add('vertex', 'color', { type: 'uint8', components: 4 });
    color.forEach((_, i) => {
      color[i] = (37 * i) % 256;
    });
    const { mesh: again } = await readGltf(await writeGltf(mesh));
    expect(again.vertexCount).toBe(12);
    expect([...again.toTriangles().indices]).toEqual([...mesh.toTriangles().indices]);
    expect([...again.attributes.get('vertex', 'normal')]).toEqual([...normal]);
    expect([...again.attributes.get('vertex', 'color')]).toEqual([...color]);
    const corners = (of: HalfedgeMesh) => {
      const values = of.attributes.get('halfedge', 'uv');
      return [...of.faces()].map((f) =>
        [...of.faceHalfedges(f)].map((h) => [of.toVertex(h), values[2 * h], values[2 * h + 1]]),
      );
    };
    expect(corners(again)).toEqual(corners(mesh));
  });

  test('keeps seams and colours also where making the buffers lets the memory grow', async () => {
    const mesh = HalfedgeMesh.icoSphere(5);
    const color = mesh.attributes.add('halfedge', 'color', { type: 'uint8', components: 4 });
    color.forEach((_, i) => {
      color[i] = (i >> 2) % 251;
    });
    const kept = color.slice();
    const again = await readGltf(await withFullHeap(() => writeGltf(mesh)));
    const read = again.mesh.attributes.get('halfedge', 'color');
    expect(read.length).toBe(kept.length);
    const corner = (of: HalfedgeMesh, values: ArrayLike<number>, a: number, b: number) =>
      values[4 * of.findHalfedge(a, b)];
    for (let h = 0; h < mesh.halfedgeSlots; h += 97) {
      const [a, b] = [mesh.fromVertex(h), mesh.toVertex(h)];
      expect(corner(again.mesh, read, a, b)).toBe(corner(mesh, kept, a, b));
    }
    again.mesh.dispose();
    mesh.dispose();
  });

  test('cuts polygons into triangles, and leaves the mesh as it is', async () => {
    const mesh = HalfedgeMesh.cube();
    const before = mesh.toBytes();
    const { mesh: again } = await readGltf(await writeGltf(mesh));
    expect([again.vertexCount, again.faceCount, again.isClosed()]).toEqual([8, 12, true]);
    expect(mesh.toBytes()).toEqual(before);
  });

  test('writes meshes without faces, without vertices, and with deleted slots', async () => {
    const holes = HalfedgeMesh.icoSphere(1);
    holes.deleteVertex(0);
    const { mesh } = await readGltf(await writeGltf(holes));
    expect([mesh.vertexCount, mesh.faceCount]).toEqual([holes.vertexCount, holes.faceCount]);
    const point = new HalfedgeMesh();
    expect((await readGltf(await writeGltf(point))).mesh.faceCount).toBe(0);
    point.addVertex([1, 2, 3]);
    expect((await readGltf(await writeGltf(point))).mesh.faceCount).toBe(0);
  });

  test('leaves the globals of Node alone, also when two write at once', async () => {
    const meshes = [HalfedgeMesh.cube(), HalfedgeMesh.icosahedron()];
    const written = await Promise.all(meshes.map((mesh) => writeGltf(mesh)));
    expect(written.map(({ length }) => length > 100)).toEqual([true, true]);
    expect(globalThis.FileReader).toBeUndefined();
  });

  test('says what is not in the file', async () => {
    const mesh = HalfedgeMesh.cube();
    for (const { kind, name } of mesh.attributes.list()) mesh.attributes.remove(kind, name);
    const notesOf = async () => {
      const notes: string[] = [];
      await writeGltf(mesh, { onNote: (note) => notes.push(note) });
      return notes;
    };
    const cut = 'Cut 6 faces into 12 triangles: glTF has no polygons.';
    expect(await notesOf()).toEqual([cut]);
    mesh.attributes.add('vertex', 'uv', { components: 2, type: 'float64' });
    mesh.attributes.add('vertex', 'color', { components: 3, type: 'int8' });
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    mesh.attributes.add('halfedge', 'color', { components: 1 });
    mesh.attributes.add('face', 'material', { type: 'int32', onSplit: 'copy' });
    expect(await notesOf()).toEqual([
      cut,
      'Wrote the vertex attribute "uv" as 32-bit floats.',
      'Left out the vertex attribute "color": in glTF it has no values of int8.',
      'Left out the vertex attribute "uv": halfedges have it as well.',
      'Left out the halfedge attribute "color": in glTF it has 3 or 4 components, not 1.',
      'Left out the face attribute "material": glTF has no place for it.',
    ]);
    for (const f of [...mesh.faces()]) mesh.deleteFace(f);
    mesh.addVertex([1, 2, 3]);
    expect((await notesOf())[0]).toMatch(/^Left out \d+ vert(ex|ices): there are no faces\.$/);
    mesh.dispose();
  });

  test.each(['glb', 'gltf'] as const)(
    'fails where its own bytes can not be read back: %s',
    async (format) => {
      const mesh = HalfedgeMesh.cube();
      const reading = import.meta.jest
        .spyOn(Blob.prototype, 'arrayBuffer')
        .mockRejectedValue(new Error('No memory left.'));
      const error = await rejection(writeGltf(mesh, { format }));
      reading.mockRestore();
      expect(error).toMatchObject({
        code: 'write-error',
        message: "three.js can't write the mesh: No memory left.",
      });
      expect(globalThis.FileReader).toBeUndefined();
      expect((await writeGltf(mesh, { format })).length).toBeGreaterThan(100);
      mesh.dispose();
    },
  );

  test('refuses what is no mesh, and no format', async () => {
    expect((await rejection(writeGltf({} as HalfedgeMesh))).message).toMatch(/^mesh is an Object/);
    const bad = writeGltf(HalfedgeMesh.cube(), { format: 'doc' as 'glb' });
    expect((await rejection(bad)).message).toBe(
      "options.format is \"doc\"; expected 'glb' or 'gltf'.",
    );
  });
});

describe('A glTF file that is none', () => {
  const changed = (change: (json: ReturnType<typeof square>) => void) => {
    const json = square();
    change(json);
    return JSON.stringify(json);
  };
  const set = (path: string, value: unknown) =>
    changed((json) => {
      const keys = path.split('.');
      const last = keys.pop() as string;
      const at = keys.reduce(
        (object, key) => (object as Record<string, object>)[key],
        json as object,
      );
      (at as Record<string, unknown>)[last] = value;
    });

  const broken = [
    ['', 'unknown-format', 'The file is empty (0 bytes)'],
    ['{"asset":', 'parse-error', 'Byte 0: what follows is not the JSON of a glTF file: '],
    [
      '[]',
      'parse-error',
      'glTF: The JSON of the file is an array of 0 elements, expected an object.',
    ],
    ['{}', 'parse-error', 'glTF: asset is undefined, expected an object.'],
    [set('asset.version', '1.0'), 'unsupported-format', 'asset.version is "1.0"'],
    [set('meshes', 7), 'parse-error', 'glTF: meshes is 7, expected an array.'],
    [
      set('meshes.0.primitives.0.attributes.POSITION', 9),
      'parse-error',
      'attributes.POSITION is 9, expected an index from 0 to 1.',
    ],
    [set('meshes.0.primitives.0.mode', 7), 'parse-error', 'mode is 7'],
    [set('nodes.0.mesh', 3), 'parse-error', 'nodes[0].mesh is 3'],
    [set('nodes', [{ children: [1] }, { children: [0] }]), 'parse-error', 'below itself'],
    [set('nodes', [{ children: [0] }]), 'parse-error', 'nodes[0] is a child of nodes'],
    [set('nodes', [{ children: [1, 1] }, {}]), 'parse-error', 'expected one parent'],
    [set('nodes.0.scale', [1, 'x', 1]), 'parse-error', 'nodes[0].scale is an array of 3 elements'],
    [
      set('accessors.0.count', 5),
      'truncated',
      'accessors[0] has 5 rows, which need 60 bytes, but bufferViews[0] has 48.',
    ],
    [set('accessors.0.count', -1), 'parse-error', 'accessors[0].count is -1'],
    [set('accessors.0.count', 2 ** 60), 'parse-error', 'accessors[0].count is 1152921504606847000'],
    [set('accessors.0.componentType', 5124), 'parse-error', 'componentType is 5124'],
    [set('accessors.0.type', 'toString'), 'parse-error', 'accessors[0].type is "toString"'],
    [set('accessors.0.byteOffset', 2), 'parse-error', 'byteOffset is 2, expected a multiple of 4'],
    [
      set('accessors.0', { componentType: FLOAT, count: 4e9, type: 'VEC3' }),
      'too-large',
      'accessors[0] has 4000000000 rows of zeros',
    ],
    [set('bufferViews.0.byteLength', 4000), 'parse-error', 'bufferViews[0] is bytes 0 to 4000'],
    [set('buffers.0.byteLength', 4000), 'truncated', 'buffers[0] has 60 bytes, expected 4000'],
    [
      set('buffers.0.uri', 'data:;base64,*'),
      'parse-error',
      'buffers[0].uri is a broken data: address',
    ],
    [set('buffers.0.uri', undefined), 'truncated', 'buffers[0] has no address'],
    [
      set('extensionsRequired', ['KHR_draco_mesh_compression']),
      'unsupported-format',
      "it needs three.js's DRACOLoader as options.dracoLoader.",
    ],
    [
      set('extensionsRequired', ['EXT_meshopt_compression']),
      'unsupported-format',
      'options.meshoptDecoder',
    ],
    [
      set('extensionsRequired', ['ACME_points']),
      'unsupported-format',
      'requires the extension "ACME_points"',
    ],
  ];
  const bySentence = broken.map(([text, code, sentence]) => [sentence, code, text]);

  test.each(bySentence)('is told: %s (%s)', async (sentence, code, text) => {
    const error = await rejection(readGltf(text));
    expect(error).toBeInstanceOf(HalfedgeError);
    expect(error.message).toContain(sentence);
    expect(error.code).toBe(code);
  });

  test('is told when a GLB file is cut, at every byte', async () => {
    const glb = await writeGltf(HalfedgeMesh.tetrahedron());
    for (let length = 0; length < glb.length; length++) {
      const error = await rejection(readGltf(glb.subarray(0, length)));
      expect(error).toBeInstanceOf(HalfedgeError);
      expect(['truncated', 'parse-error', 'unknown-format', 'not-text']).toContain(error.code);
    }
  });

  test('gives a mesh or a HalfedgeError whatever is changed in it', async () => {
    const quiet = ['warn', 'error'].map((name) =>
      import.meta.jest.spyOn(console, name as 'warn').mockImplementation(() => {}),
    );
    const original = await writeGltf(HalfedgeMesh.icoSphere(1));
    const seed = 20;
    const next = random(seed);
    const endings = new Set<string>();
    for (let round = 0; round < 400; round++) {
      const bytes = original.slice();
      const changes = 1 + Math.floor(4 * next());
      for (let i = 0; i < changes; i++) {
        // Mostly in the header and the JSON.
        const range = next() < 0.8 ? Math.min(900, bytes.length) : bytes.length;
        bytes[Math.floor(range * next())] = Math.floor(256 * next());
      }
      try {
        const { mesh } = await readGltf(bytes);
        const errors = mesh.validate().filter(({ severity }) => severity === 'error');
        expect({ seed, round, errors }).toEqual({ seed, round, errors: [] });
        mesh.dispose();
        endings.add('mesh');
      } catch (error) {
        if (!(error instanceof HalfedgeError))
          throw new Error(`Seed ${seed}, round ${round}`, { cause: error });
        endings.add(error.code);
      }
    }
    expect(endings).toContain('mesh');
    expect(endings.size).toBeGreaterThan(2);
    for (const spy of quiet) spy.mockRestore();
  });
});

describe('The collection', () => {
  const gltf = /\.(gltf|glb)$/;
  const parts = { good: collected('good', gltf), nasty: collected('nasty', gltf) };

  collected(['good', 'nasty'], gltf).test.each(['good', 'nasty'] as const)(
    '%s glTF files give a valid mesh or a sentence',
    async (name) => {
      const { files } = parts[name];
      expect(files.length).toBeGreaterThan(3);
      for (const file of files) {
        try {
          const { mesh } = await readGltf(pathToFileURL(file));
          expect([file, mesh.validate().filter(({ severity }) => severity === 'error')]).toEqual([
            file,
            [],
          ]);
          mesh.dispose();
        } catch (error) {
          expect(error).toBeInstanceOf(HalfedgeError);
          // Of the good ones, one has lost its buffer.
          if (name === 'good')
            expect([file, (error as HalfedgeError).code]).toEqual([file, 'missing-resource']);
        }
      }
    },
  );

  const pins = collected('good', /^pins\.glb$/);
  pins.test('a GLB file is read as three.js reads it', async () => {
    const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
    const bytes = new Uint8Array(readFileSync(pins.files[0]));
    const { mesh } = await readGltf(bytes);
    const { scene } = await new GLTFLoader().parseAsync(bytes.slice().buffer, '');
    let triangles = 0;
    scene.traverse((object) => {
      const { geometry } = object as { geometry?: { index: { count: number } } };
      triangles += (geometry?.index.count ?? 0) / 3;
    });
    expect(mesh.faceCount).toBe(triangles);
  });
});
