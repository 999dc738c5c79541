import { readFileSync } from 'node:fs';
import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { collected } from './support/collection.js';
import { bytesInUse } from './support/core.js';

beforeAll(() => init());

/** The error that a call throws, which must be one of the library's own. */
function errorOf(call: () => unknown): HalfedgeError {
  try {
    call();
  } catch (error) {
    if (error instanceof HalfedgeError) return error;
    throw error;
  }
  throw new Error('no error');
}

const cube = `# a cube, its faces in all forms
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1\r
v 1 0 1\r
v 1 1 1
v 0 1 1
vt 0 0
vn 0 0 1
f 4 3 2 1
f 5/1 6/1 7/1 8/1
f 1/1/1 2/1/1 6/1/1 5/1/1
f 2//1 3//1 7//1 6//1
f 3 4 8 7
f -5 -8 -4 -1
`;
const triangle = 'OFF\n# comment\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';

describe('parse', () => {
  test('reads an OBJ file, polygons and all', () => {
    const { mesh, report } = HalfedgeMesh.parse(cube);
    expect([mesh.vertexCount, mesh.edgeCount, mesh.faceCount]).toEqual([8, 12, 6]);
    expect(mesh.validate()).toEqual([]);
    expect(mesh.genus()).toBe(0);
    expect(report).toMatchObject({ format: 'obj' });
    expect(report.summary).toMatch(/^OBJ: 8 vertices, 12 edges, 6 faces\./);
    mesh.dispose();
  });

  test('reads an OFF file', () => {
    const { mesh, report } = HalfedgeMesh.parse(triangle);
    expect(report).toEqual({
      format: 'off',
      names: {},
      problems: [],
      counts: {},
      verdicts: [],
      vertexMap: Int32Array.of(0, 1, 2),
      vertexOrigin: Uint32Array.of(0, 1, 2),
      faceMap: Int32Array.of(0),
      unlisted: {},
      summary: 'OFF: 3 vertices, 3 edges, 1 face.',
    });
    expect(Array.from(mesh.positions)).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    mesh.dispose();
  });

  test('reads a binary PLY file', () => {
    const header =
      'ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n' +
      'property float y\nproperty float z\nproperty uchar red\nelement face 1\n' +
      'property list uchar int vertex_indices\nend_header\n';
    const data = new DataView(new ArrayBuffer(3 * 13 + 13));
    [0, 0, 0, 1, 0, 0, 0, 0.1, 0].forEach((x, i) => {
      data.setFloat32(13 * Math.floor(i / 3) + 4 * (i % 3), x, true);
    });
    data.setUint8(39, 3);
    [0, 1, 2].forEach((v, i) => {
      data.setInt32(40 + 4 * i, v, true);
    });
    const bytes = Buffer.concat([Buffer.from(header), Buffer.from(data.buffer)]);
    const { mesh, report } = HalfedgeMesh.parse(bytes);
    expect(report).toMatchObject({
      format: 'ply',
      summary: 'PLY: 3 vertices, 3 edges, 1 face.',
    });
    expect(mesh.attributes.list()).toEqual([
      { kind: 'vertex', name: 'red', type: 'uint8', components: 1, default: [0], onSplit: 'copy' },
    ]);
    expect(Array.from(mesh.positions)).toEqual([0, 0, 0, 1, 0, 0, 0, Math.fround(0.1), 0]);
    mesh.dispose();
  });

  test('welds the triangles of an STL file', () => {
    const facet = (...corners: string[]) =>
      `facet normal 0 0 1\nouter loop\nvertex ${corners.join('\nvertex ')}\nendloop\nendfacet\n`;
    const square = facet('0 0 0', '1 0 0', '1 1 0') + facet('-0 0 0', '1 1 0', '0 1 0');
    const { mesh, report } = HalfedgeMesh.parse(`solid\n${square}endsolid\n`);
    expect(report.summary).toBe('STL: 4 vertices, 5 edges, 2 faces.');
    expect(mesh.boundaryLoops()).toHaveLength(1);
    mesh.dispose();
    const twice = `solid\n${square}${square}endsolid\n`;
    expect(() => HalfedgeMesh.parse(twice, { repair: false })).toThrow(/Line/);
  });

  test('names faces, and their bytes, of a binary file that makes no manifold', () => {
    const data = new DataView(new ArrayBuffer(84 + 2 * 50));
    data.setUint32(80, 2, true);
    for (const triangle of [84, 134]) {
      [0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((x, i) => {
        data.setFloat32(triangle + 12 + 4 * i, x, true);
      });
    }
    const { mesh, report } = HalfedgeMesh.parse(data.buffer);
    expect(report.problems[0]?.message).toBe(
      'Face 0 has the vertices of face 1, which was left out. (Bytes 84, 134)',
    );
    mesh.dispose();
    const strict = () => HalfedgeMesh.parse(data.buffer, { repair: false });
    expect(strict).toThrow(/^Face 1 repeats face 0.*2\. \(Bytes 84, 134\)$/);
    data.setFloat32(84 + 12, Number.NaN, true);
    expect(strict).toThrow(
      'Byte 84: x of vertex 0 of triangle 0 is nan, expected a finite number (read as STL)',
    );
  });

  const encoded = new TextEncoder().encode(triangle);
  const containers: [string, string | ArrayBuffer | Uint8Array][] = [
    ['a string', triangle],
    ['a Uint8Array', encoded],
    ['a Buffer', Buffer.from(triangle)],
    ['a view inside a buffer', new Uint8Array([0, ...encoded, 0]).subarray(1, -1)],
    ['an ArrayBuffer', Uint8Array.from(encoded).buffer],
    ['a DataView', new DataView(Uint8Array.from(encoded).buffer) as never],
    [
      'shared memory',
      (() => {
        const shared = new Uint8Array(new SharedArrayBuffer(encoded.length));
        shared.set(encoded);
        return shared.buffer as never;
      })(),
    ],
  ];
  test.each(containers)('reads %s', (_, data) => {
    const { mesh } = HalfedgeMesh.parse(data);
    expect(mesh.faceCount).toBe(1);
    mesh.dispose();
  });

  test('tells what it ignored, and what it read the file as', () => {
    const { mesh, report } = HalfedgeMesh.parse(triangle, { format: 'obj', repair: false });
    expect(report.format).toBe('off');
    expect(report.problems).toHaveLength(1);
    expect(report.problems[0]).toMatchObject({ severity: 'info', kind: 'mesh', index: -1 });
    expect(report.problems[0].message).toMatch(/^Read as OFF, .*\.$/);
    expect(report.summary).toContain(report.problems[0].message);
    mesh.dispose();
  });

  const broken: [code: string, data: string, says: RegExp][] = [
    ['parse-error', 'v 0 0 0\nv 1 x 0\n', /^Line 2: .*"x"/],
    ['truncated', 'OFF\n3 1 0\n0 0 0\n', /3/],
    ['index-out-of-range', 'v 0 0 0\nf 1 2 9\n', /^Line 2: /],
    ['unknown-format', 'Dear Sir or Madam\n', /Dear/],
    ['unknown-format', '', /empty/],
    ['parse-error', 'ply\nformat ascii 1.0\nend_header\n', /^Line 3: .*element vertex/],
    ['truncated', 'solid\nfacet\nouter loop\nvertex 0 0', /^Line 4: .*z of vertex 0/],
    [
      'unsupported-format',
      'glTF',
      /^This is a GLB file, expected an OBJ, OFF, PLY or STL file: glTF is read by readGltf of halfedge\/gltf\.$/,
    ],
    ['unsupported-format', '{ "asset": {} }', /JSON .*: glTF is read by readGltf of/],
    ['unsupported-format', '<!DOCTYPE html>', /HTML or XML file, expected [^:]*\.$/],
    ['not-text', '\u0000\u0001\u0002', /Byte 0/],
  ];
  test.each(broken)('says %s', (code, data, says) => {
    try {
      HalfedgeMesh.parse(data, { repair: false });
    } catch (error) {
      expect(error).toBeInstanceOf(HalfedgeError);
      expect(error).toMatchObject({ code, message: expect.stringMatching(says) });
      expect((error as HalfedgeError).message).toMatch(/^[A-Z].*[.)]$/s);
      return;
    }
    throw new Error('It was read.');
  });

  test('leaves out faces whose vertices are missing or nowhere, and names them', () => {
    const stl = new DataView(new ArrayBuffer(84 + 2 * 50));
    stl.setUint32(80, 2, true);
    for (const triangle of [84, 134]) {
      [0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((x, i) => {
        stl.setFloat32(triangle + 12 + 4 * i, x, true);
      });
    }
    stl.setFloat32(84 + 12, Number.NaN, true);
    const index = (vertex: string) => [
      RegExp(`^Face 0 uses vertex ${vertex}: it was left out\\. \\(Line \\d+\\)$`),
    ];
    const files: [code: string, data: string | ArrayBuffer, says: RegExp[]][] = [
      [
        'index-out-of-range',
        'v 0 0 0\nv 1 0 0\nf 1 2 9\nf 1 2 3\nv 0 1 0\n',
        index('"9", but vertices have the numbers 1 to 3'),
      ],
      [
        'index-out-of-range',
        'v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -9\nf 1 2 3\n',
        index('"-9", but fewer come before it'),
      ],
      [
        'index-out-of-range',
        'OFF 3 2\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n3 0 1 2\n',
        index('3, but the last one is 2'),
      ],
      [
        'index-out-of-range',
        'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n' +
          'property float z\nelement face 2\nproperty list uchar int vertex_indices\n' +
          'end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n3 0 1 2\n',
        index('-1, but the last one is 2'),
      ],
      ['non-finite-position', stl.buffer, [/^Vertex 0 is at \(nan, 0, 0\), which is no position/]],
    ];
    for (const [code, data, says] of files) {
      const { mesh, report } = HalfedgeMesh.parse(data);
      expect([mesh.faceCount, report.counts[code as never]]).toEqual([1, 1]);
      const problems = report.problems.filter((problem) => problem.code === code);
      expect(problems.map(({ message }) => message)).toEqual(
        says.map((says) => expect.stringMatching(says)),
      );
      expect(report.verdicts).toEqual([{ face: 0, kept: false, codes: [code] }]);
      expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
      mesh.dispose();
      expect(() => HalfedgeMesh.parse(data, { repair: false })).toThrow(HalfedgeError);
    }
  });

  test('names the lines of the faces that make no manifold', () => {
    const vertices = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 2\n';
    const faces = 'f 1 2 3\n\nf 2 1 4\n# two are enough\nf 1 2 5\n';
    const strict = (data: string) => () => HalfedgeMesh.parse(data, { repair: false });
    expect(strict(vertices + faces)).toThrow(/\(Lines 6, 8, 10\)/);
    expect(strict(`${vertices}f 1 2 2\n`)).toThrow(/\(Line 6\)/);
    expect(strict('v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n')).toThrow(
      /^Vertex 2 is at \(0, nan, 0\); expected three finite numbers\. \(Line 3\)/,
    );
  });

  test('names duplicate faces in the order of their lines', () => {
    const vertices = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';
    const { mesh, report } = HalfedgeMesh.parse(`${vertices}f 3 2 1\nf 1 2 3\n\nf 1 2 3\n`);
    expect(report.problems.map(({ message }) => message)).toEqual([
      'Face 1 has the vertices of face 0, which was left out. (Lines 5, 4)',
      'Face 1 has the vertices of face 2, which was left out. (Lines 5, 7)',
    ]);
    mesh.dispose();
  });

  test('tells an OBJ file whose numbers have commas from a file of no known format', () => {
    const vertices = 'v 0,5 -0,25 1\n'.repeat(10_000);
    const { code, message } = errorOf(() => HalfedgeMesh.parse(`${vertices}f 1 2 3\n`));
    expect(code).toBe('parse-error');
    expect(message).toBe(
      'Line 1: expected a number for x of the vertex, found "0,5" (read as OBJ).',
    );
  });

  test.each([
    [undefined, 'data is undefined; expected the content of a file'],
    [null, 'data is null'],
    [5, 'data is 5'],
    [[118, 32], 'data is an array of 2 elements'],
    [{}, 'data is an Object'],
    [Promise.resolve(triangle), 'data is a Promise, which is to be awaited; expected the content'],
    [
      new Blob([triangle]),
      'data is a Blob; expected the content of a file as a string, an ArrayBuffer or a Uint8Array: await its arrayBuffer().',
    ],
    [new Response(triangle), 'an ArrayBuffer or a Uint8Array: await its arrayBuffer().'],
  ])('refuses %p as data', (data, message) => {
    expect(() => HalfedgeMesh.parse(data as unknown as string)).toThrow(TypeError);
    expect(() => HalfedgeMesh.parse(data as unknown as string)).toThrow(message);
  });

  test.each([
    'bunny.obj',
    './models/part.STL',
    'C:\\models\\part.ply',
    'https://example.com/bunny.off?raw=1',
    'https://example.com/bunny',
    'blob:https://example.com/5f6b',
    '/models/scene.glb',
    '/my models/bunny.obj',
    'My Bunny (1).ply',
  ])('tells the name of a file, %s, from what is in it', (name) => {
    for (const read of [() => HalfedgeMesh.parse(name), () => HalfedgeMesh.parseSoup(name)]) {
      const { code, message } = errorOf(read);
      expect(code).toBe('unknown-format');
      expect(message).toMatch(/^data is .*, the name of a file; expected what is in it, so fetch/);
    }
  });

  test('reads a text that names a file', () => {
    for (const text of ['#bunny.obj', 'o bunny.obj', 'mtllib bunny.obj', 'solid bunny.stl']) {
      expect(() => HalfedgeMesh.parse(text)).not.toThrow(/the name of a file/);
    }
  });

  test.each(['utf8', 'latin1'] as const)(
    'refuses a binary file that was read as %s',
    (encoding) => {
      using mesh = HalfedgeMesh.dodecahedron();
      for (const format of ['ply', 'stl', 'off'] as const) {
        const bytes = mesh.write(format, { encoding: 'binary' });
        const { code, message } = errorOf(() =>
          HalfedgeMesh.parse(Buffer.from(bytes).toString(encoding)),
        );
        expect(code).toBe('not-text');
        expect(message).toMatch(
          /^data is a string of \d+ characters, a binary file that was read as text/,
        );
      }
    },
  );

  test('reads a text of any letters that is filled up with NULs', () => {
    using mesh = HalfedgeMesh.parse(`# Würfel \uFFFD\n${triangle}\0\0\0\r\n\0`).mesh;
    expect(mesh.faceCount).toBe(1);
  });

  test('spells what cannot be seen in a number that is none', () => {
    for (const [hidden, spelt] of [
      ['\ufeff', '\\xef\\xbb\\xbf'],
      ['\u00a0', '\\xc2\\xa0'],
      ['\u200b', '\\xe2\\x80\\x8b'],
    ]) {
      const { message } = errorOf(() => HalfedgeMesh.parse(`v 0 0 0\nv 1${hidden}2 0 0\n`));
      expect(message).toContain(
        `Line 2: expected a number for x of the vertex, found "1${spelt}2"`,
      );
    }
    const { message } = errorOf(() => HalfedgeMesh.parse('v 0 0 0\nv \u22121 0 0\n'));
    expect(message).toContain('found "\u22121"');
  });

  test('refuses wrong options', () => {
    const parse = (options: unknown) => () => HalfedgeMesh.parse(triangle, options as never);
    expect(parse(null)).toThrow(new TypeError('options is null; expected an object.'));
    expect(parse({ format: 'gif' })).toThrow(RangeError);
    expect(parse({ format: 'gif' })).toThrow(
      `options.format is "gif"; expected 'obj', 'off', 'ply' or 'stl'.`,
    );
    expect(parse({ format: 3 })).toThrow(TypeError);
    expect(parse({ attributes: 1 })).toThrow('options.attributes is 1; expected true or false.');
    expect(parse({ repair: 'yes' })).toThrow(`options.repair is "yes"; expected true or false.`);
  });

  test('refuses a buffer that was transferred away', () => {
    const { buffer } = Uint8Array.from(encoded);
    structuredClone(buffer, { transfer: [buffer] });
    expect(() => HalfedgeMesh.parse(buffer)).toThrow('data is a detached buffer');
  });
});

const good = collected('good');
good.test('parse reads every good OBJ, OFF, PLY and STL file there is', () => {
  const refused: string[] = [];
  for (const file of good.files) {
    try {
      const { mesh } = HalfedgeMesh.parse(readFileSync(file));
      expect([file, mesh.validate().filter(({ severity }) => severity === 'error')]).toEqual([
        file,
        [],
      ]);
      mesh.dispose();
    } catch (error) {
      refused.push(`${file}: ${(error as HalfedgeError).code}`);
    }
  }
  expect(refused).toEqual([]);
});

const nasty = collected('nasty');
nasty.test('parse reads or explains every nasty file there is', () => {
  let meshes = 0;
  for (const file of nasty.files) {
    try {
      const { mesh } = HalfedgeMesh.parse(readFileSync(file));
      expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
      mesh.dispose();
      meshes++;
    } catch (error) {
      expect([file, String(error)]).toEqual([
        file,
        expect.stringMatching(/^HalfedgeError: .{20,}/s),
      ]);
    }
  }
  expect(meshes).toBeGreaterThan(45);
});

describe('parseSoup', () => {
  const spoilt = `OFF
5 4 0
0 0 0
1 0 0
0 1 0
1 1 0
nan 0 0
3 0 1 2
4 1 3 2 4
2 0 1
3 2 1 99
`;

  test('gives the faces of a file as they stand there, and the mesh that parse makes of them', () => {
    const { positions, faces, format, notes } = HalfedgeMesh.parseSoup(spoilt);
    expect(Array.from(positions)).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, NaN, 0, 0]);
    expect(faces.sizes).toEqual(Uint32Array.of(3, 4, 2, 3));
    expect(faces.corners).toEqual(Uint32Array.of(0, 1, 2, 1, 3, 2, 4, 0, 1, 2, 1, 99));
    expect({ format, notes }).toEqual({ format: 'off', notes: [] });
    const soup = HalfedgeMesh.fromSoup(positions, faces);
    const file = HalfedgeMesh.parse(spoilt);
    expect(soup.report.counts).toEqual(file.report.counts);
    expect(soup.report.faceMap).toEqual(file.report.faceMap);
    expect(soup.mesh.toBytes()).toEqual(file.mesh.toBytes());
    soup.mesh.dispose();
    file.mesh.dispose();
  });

  test('gives what the file says beside positions, a row for each item', () => {
    const { attributes, names, positions } = HalfedgeMesh.parseSoup(
      'v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 1 0 1 1 1\nvt 0.5 0.25\nvt 1 0\n' +
        'f 1 2 3\nusemtl wood\nf 2/2 4/1 3/2\n',
    );
    expect(positions).toHaveLength(12);
    expect(names).toEqual({ material: ['', 'wood'] });
    expect(attributes).toEqual([
      {
        name: 'uv',
        item: 'corner',
        type: 'float32',
        components: 2,
        values: Float32Array.of(0, 0, 0, 0, 0, 0, 1, 0, 0.5, 0.25, 1, 0),
      },
      {
        name: 'color',
        item: 'vertex',
        type: 'float32',
        components: 3,
        values: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1),
      },
      {
        name: 'material',
        item: 'face',
        type: 'int32',
        components: 1,
        values: Int32Array.of(0, 1),
      },
    ]);
    expect(HalfedgeMesh.parseSoup(triangle, { attributes: false }).attributes).toEqual([]);
  });

  test('leaves the triangles of STL apart if asked', () => {
    const { mesh } = HalfedgeMesh.parse(cube);
    const stl = mesh.write('stl', { encoding: 'binary' });
    mesh.dispose();
    expect(HalfedgeMesh.parseSoup(stl).positions).toHaveLength(3 * 8);
    const { positions, faces } = HalfedgeMesh.parseSoup(stl, { weld: false });
    expect(positions).toHaveLength(9 * 12);
    expect(faces.corners).toEqual(Uint32Array.from({ length: 36 }, (_, i) => i));
    const numbers = new DataView(stl.buffer, stl.byteOffset);
    for (let t = 0; t < 12; t++) {
      for (let i = 0; i < 9; i++) {
        expect(positions[9 * t + i]).toBe(numbers.getFloat32(84 + 50 * t + 12 + 4 * i, true));
      }
    }
  });

  test('loses no memory, whatever becomes of it', () => {
    HalfedgeMesh.parseSoup(cube);
    const before = bytesInUse();
    HalfedgeMesh.parseSoup(`${cube}vt 0 0\nf 1/1 2/1 3/1\n`);
    expect(() => HalfedgeMesh.parseSoup(cube, { weld: 1 as never })).toThrow(TypeError);
    expect(bytesInUse()).toBe(before);
  });

  test('says the size of triangles, too', () => {
    expect(HalfedgeMesh.parseSoup(triangle).faces.sizes).toEqual(Uint32Array.of(3));
  });

  test('takes bytes and a format, and throws what parse throws', () => {
    const bytes = new TextEncoder().encode(cube);
    expect(HalfedgeMesh.parseSoup(bytes, { format: 'obj' }).faces.sizes).toHaveLength(6);
    expect(() => HalfedgeMesh.parseSoup('OFF\n3 1 0\n0 0 0\n')).toThrow(HalfedgeError);
    expect(() => HalfedgeMesh.parseSoup(triangle, { format: 'dae' as 'obj' })).toThrow(RangeError);
    expect(() => HalfedgeMesh.parseSoup(7 as never)).toThrow(TypeError);
  });
});
