import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { readGltf, readGltfParts } from 'halfedge/gltf';
import { collected } from './support/collection.js';
import { bytesInUse, giveCornerAttributes, withFullHeap } from './support/core.js';
import {
  BYTE,
  base64,
  CORNERS,
  type Column,
  document,
  read,
  rejection,
  SQUARE,
  square,
} from './support/gltf.js';

beforeAll(() => init());

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

  test.each([
    ['one step', 0.1, 0.5, 4512345, 'V2F0'],
    ['a few steps', 10, 0.5, -4512345, 'V4F2'],
    ['many steps', 10, 0, 4512, 'V4F2'],
  ])(
    'says that a node puts a mesh so far away that it is %s wide',
    async (_, size, step, x, counts) => {
      const nodes = [
        { mesh: 0, translation: [x, 0, 5412345 * Number(step > 0)], scale: [size, size, size] },
      ];
      const { mesh, report } = await read(square({ nodes }));
      const notes = report.problems.filter(({ message }) =>
        message.includes('far from the origin'),
      );
      expect(notes.map(({ message }) => message)).toEqual(
        step === 0
          ? []
          : [
              `The positions are far from the origin for their size: as floats, which are up to ${step} apart there, they lose what is finer.`,
            ],
      );
      expect(`V${mesh.vertexCount}F${mesh.faceCount}`).toBe(counts);
    },
  );

  test('takes no vertex that is nowhere for one that is far away', async () => {
    const values = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, Number.NaN, Infinity, 0]);
    const accessors = [
      { values, type: 'VEC3' },
      { values: CORNERS, type: 'SCALAR' },
    ];
    const meshes = [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }];
    const { report } = await read(document(accessors, { meshes }));
    expect(JSON.stringify(report.problems)).not.toContain('far from the origin');
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
      {
        kind: 'vertex',
        name: 'normal',
        type: 'float32',
        components: 3,
        default: [0, 0, 0],
        onSplit: 'normalize',
      },
      {
        kind: 'vertex',
        name: 'color',
        type: 'uint8',
        components: 4,
        default: [0, 0, 0, 0],
        onSplit: 'interpolate',
      },
      {
        kind: 'halfedge',
        name: 'uv',
        type: 'float32',
        components: 2,
        default: [0, 0],
        onSplit: 'interpolate',
      },
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
    // What would fill a hole gets what the face beside it has.
    for (const h of mesh.halfedges()) {
      if (mesh.face(h) !== -1) continue;
      const beside = mesh.opposite(mesh.next(h));
      expect(uv.slice(2 * h, 2 * h + 2)).toEqual(uv.slice(2 * beside, 2 * beside + 2));
    }
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

  test('names the attributes that it does not read', async () => {
    const attributes = { POSITION: 0, TEXCOORD_1: 2, _HEAT: 3 };
    const other = { POSITION: 0, TEXCOORD_1: 2 };
    const { mesh, report } = await read(
      document(
        [
          { values: SQUARE, type: 'VEC3' },
          { values: CORNERS, type: 'SCALAR' },
          { values: new Float32Array(8), type: 'VEC2' },
          { values: new Float32Array(4), type: 'SCALAR' },
        ],
        {
          meshes: [
            {
              primitives: [
                { attributes, indices: 1 },
                { attributes: other, indices: 1 },
              ],
            },
          ],
          nodes: [{ mesh: 0 }],
        },
      ),
    );
    expect(mesh.attributes.list()).toEqual([]);
    expect(report.summary).toContain(
      'Ignored the attribute "TEXCOORD_1" of primitives (2). ' +
        'Ignored the attribute "_HEAT" of primitives (1).',
    );
  });

  test('keeps what some primitives have and others have not, or have in other types', async () => {
    const moved = SQUARE.map((x, i) => (i % 3 === 2 ? 1 : x));
    const bytes = new Uint8Array(16).map((_, i) => [255, 51, 0, 102][i % 4]);
    const shorts = new Uint16Array(12).fill(65535 / 5);
    const { mesh, report } = await read(
      document(
        [
          { values: SQUARE, type: 'VEC3' },
          { values: CORNERS, type: 'SCALAR' },
          { values: moved, type: 'VEC3' },
          { values: bytes, type: 'VEC4', normalized: true },
          { values: shorts, type: 'VEC3', normalized: true },
          { values: moved.map((x) => x + 2), type: 'VEC3' },
          { values: new Float32Array(12).fill(1), type: 'VEC3' },
        ],
        {
          meshes: [
            {
              primitives: [
                { attributes: { POSITION: 0, COLOR_0: 3 }, indices: 1 },
                { attributes: { POSITION: 2, COLOR_0: 4 }, indices: 1 },
                { attributes: { POSITION: 5, NORMAL: 6 }, indices: 1 },
              ],
            },
          ],
          nodes: [{ mesh: 0 }],
        },
      ),
    );
    expect(mesh.vertexCount).toBe(12);
    const rows = (name: string, components: number) => {
      const all = [...mesh.attributes.get('vertex', name)].map((x) => Number(x.toFixed(4)));
      return [0, 4, 8].map((v) => all.slice(v * components, (v + 1) * components));
    };
    expect(rows('color', 4)).toEqual([
      [1, 0.2, 0, 0.4],
      [0.2, 0.2, 0.2, 1],
      [1, 1, 1, 1],
    ]);
    expect(rows('normal', 3).slice(0, 2)).toEqual([
      [0, 0, 0],
      [0, 0, 0],
    ]);
    expect(report.summary).toContain(
      'Filled normal with zeros where primitives have none (2 of 3). ' +
        'Filled color with white where primitives have none (1 of 3).',
    );
  });

  test('reads rows that reach over the end of a stride, the last as well', async () => {
    // Rows of 16 bytes; the last position has 12, and the normals begin behind it.
    const floats = new Float32Array(30);
    for (let v = 0; v < 4; v++) {
      floats.set(SQUARE.subarray(3 * v, 3 * v + 3), 4 * v);
      floats.set([0, 0.6, 0.8], 15 + 4 * v);
    }
    const json = document(
      [
        { values: floats, type: 'SCALAR' },
        { values: CORNERS, type: 'SCALAR' },
      ],
      { meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 2 }, indices: 1 }] }] },
    );
    Object.assign(json.bufferViews[0], { byteStride: 16 });
    Object.assign(json.accessors[0], { type: 'VEC3', count: 4 });
    json.accessors.push({ ...json.accessors[0], ...{ byteOffset: 60 } });
    const { mesh } = await read(json);
    expect(mesh.positions).toEqual(SQUARE);
    expect(mesh.attributes.get('vertex', 'normal')).toEqual(
      Float32Array.from({ length: 12 }, (_, i) => [0, 0.6, 0.8][i % 3]),
    );
  });

  test('reads indices with bytes between them, though glTF has none', async () => {
    const indices = new Uint16Array(12).fill(9);
    for (const [i, vertex] of CORNERS.entries()) indices[2 * i] = vertex;
    const json = document(
      [
        { values: SQUARE, type: 'VEC3' },
        { values: indices, type: 'SCALAR' },
      ],
      { meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }] },
    );
    Object.assign(json.bufferViews[1], { byteStride: 4 });
    json.accessors[1].count = 6;
    const { mesh } = await read(json);
    expect([...mesh.toTriangles().indices]).toEqual([...CORNERS]);
  });

  test('says how many corners are left behind the last triangle', async () => {
    const json = square();
    json.accessors[1].count = 5;
    const { mesh, report } = await read(json);
    expect(mesh.faceCount).toBe(1);
    expect(report.summary).toMatch(
      / Ignored corners behind the last triangle of a primitive \(2\)\.$/,
    );
  });

  test('says which attributes do not fit the positions', async () => {
    const json = document(
      [
        { values: SQUARE, type: 'VEC3' },
        { values: CORNERS, type: 'SCALAR' },
        { values: new Float32Array(9), type: 'VEC3' }, // a row too few
        { values: new Float32Array(12), type: 'VEC3' }, // a number too many
      ],
      {
        meshes: [
          { primitives: [{ attributes: { POSITION: 0, NORMAL: 2, TEXCOORD_0: 3 }, indices: 1 }] },
        ],
      },
    );
    const { mesh, report } = await read(json);
    expect(mesh.attributes.list()).toEqual([]);
    expect(report.summary).toContain(
      'Ignored normal of primitives where it does not fit the positions (1). ' +
        'Ignored uv of primitives where it does not fit the positions (1).',
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
      message: expect.stringMatching(
        /^glTF: the scene can't be built without repair, which says: Face \d was turned over/,
      ),
      problems: [{ code: 'opposite-orientation', severity: 'error' }],
    });
    await expect(readGltfParts(JSON.stringify(clashing), { repair: false })).rejects.toThrow(
      /^glTF: part 0 can't be built without repair, /,
    );
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

  test('reads buffers in data: addresses without base64, byte by byte', async () => {
    const json = square();
    const [{ uri, byteLength }] = json.buffers;
    const bytes = Buffer.from(uri.slice(uri.indexOf(',') + 1), 'base64');
    // Four bytes that are two letters of UTF-8, as the exponents of floats may be.
    bytes.set([0xc3, 0xa9, 0xc3, 0x3f], 0);
    const escaped = bytes.toString('hex').replace(/../g, '%$&');
    const { mesh } = await read({ ...json, buffers: [{ uri: `data:,${escaped}`, byteLength }] });
    const [x] = new Float32Array(Uint8Array.of(0xc3, 0xa9, 0xc3, 0x3f).buffer);
    expect([...mesh.positions]).toEqual([x, ...SQUARE.subarray(1)]);
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
    expect(await rejection(read(elsewhere, Object.create(nowhere)))).toEqual(missing);
    const short = await rejection(read(elsewhere, { resource: () => new Uint8Array(3) }));
    expect(short.message).toBe(
      `glTF: buffers[0] has 3 bytes, expected ${byteLength} as the document says.`,
    );
  });

  test.each(['part #1 at 100%.bin', 'part%20%231%20at%20100%25.bin'])(
    'gets a buffer by the bare name of its file or by its address: %s',
    async (uri) => {
      const json = square();
      const [buffer] = json.buffers;
      const bytes = Buffer.from(buffer.uri.slice(buffer.uri.indexOf(',') + 1), 'base64');
      const folder = mkdtempSync(join(tmpdir(), 'gltf-'));
      try {
        writeFileSync(join(folder, 'part #1 at 100%.bin'), bytes);
        const baseUrl = pathToFileURL(join(folder, 'part.gltf'));
        const { mesh } = await read({ ...json, buffers: [{ ...buffer, uri }] }, { baseUrl });
        expect(mesh.faceCount).toBe(2);
        mesh.dispose();
      } finally {
        rmSync(folder, { recursive: true });
      }
    },
  );
});

describe('A wrong option of readGltf', () => {
  const json = square();
  const elsewhere = { ...json, buffers: [{ ...json.buffers[0], uri: 'square.bin' }] };

  test.each([
    [
      { baseUrl: '/models/' },
      RangeError,
      'options.baseUrl is "/models/"; expected the whole address',
    ],
    [{ baseUrl: 7 }, TypeError, 'options.baseUrl is 7; expected a URL or a string.'],
    [
      { resource: 'square.bin' },
      TypeError,
      'options.resource is "square.bin"; expected a function.',
    ],
    [{ resource: null }, TypeError, 'options.resource is null; expected a function.'],
    [{ repair: null }, TypeError, 'options.repair is null; expected true or false.'],
    [{ dracoLoader: null }, TypeError, 'options.dracoLoader is null; expected a DRACOLoader'],
    [{ dracoLoader: {} }, TypeError, 'options.dracoLoader is an Object; expected a DRACOLoader'],
    [{ meshoptDecoder: {} }, TypeError, 'options.meshoptDecoder is an Object; expected a Meshopt'],
  ])('is named, with what was expected: %j', async (options, type, sentence) => {
    const error = await rejection(readGltf(JSON.stringify(elsewhere), options as never));
    expect(error).toBeInstanceOf(type);
    expect(error.message).toContain(sentence);
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
