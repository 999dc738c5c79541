import { DirectedEdgesMesh, HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { newArray } from '../../dist/arguments.js';

beforeAll(() => init());

const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];
const indices = [0, 1, 2, 2, 1, 3];

function raise(message: string): never {
  throw new Error(message);
}

test.each([
  ['too large', Uint8Array.of(0, 0, 0, 9, 0, 0), Float32Array.of(0, 1, 1, 0, 1, 1)],
  ['floats', Float32Array.of(0, 0, 0, 1, 0, 0), Float32Array.of(0, 1, 1, 0, 1, 1)],
  ['before integers', Uint8Array.of(0, 0, 0, 1, 0, 0), Uint8Array.of(0, 1, 1, 0, 1, 1)],
])('Positions that were not exchanged are not told to be: %s', (_, points, corners) => {
  const build = () => HalfedgeMesh.fromTriangles(points, corners);
  expect(build).toThrow(expect.objectContaining({ code: 'repeated-vertex' }));
});

describe('A wrong argument of a build', () => {
  const typeErrors: [string, () => unknown, string][] = [
    [
      'no positions',
      () => HalfedgeMesh.fromTriangles(undefined as never, []),
      'positions is undefined; expected an array',
    ],
    [
      'a string',
      () => HalfedgeMesh.fromTriangles('123' as never, []),
      'positions is "123"; expected an array',
    ],
    [
      'a number',
      () => HalfedgeMesh.fromTriangles(9 as never, []),
      'positions is 9; expected an array',
    ],
    [
      'an object',
      () => HalfedgeMesh.fromTriangles({} as never, []),
      'positions is an Object; expected an array',
    ],
    [
      'an array-like with a wrong length',
      () => HalfedgeMesh.fromTriangles({ length: -3 }, []),
      'positions is an Object; expected an array',
    ],
    [
      'a function',
      () => HalfedgeMesh.fromTriangles((() => 1) as never, []),
      'positions is a function; expected an array',
    ],
    [
      'a DataView',
      () => HalfedgeMesh.fromTriangles(new DataView(new ArrayBuffer(12)) as never, []),
      'positions is a DataView; expected an array',
    ],
    [
      'an ArrayBuffer',
      () => HalfedgeMesh.fromTriangles(new ArrayBuffer(12) as never, []),
      'positions is an ArrayBuffer; expected an array',
    ],
    [
      'bigints',
      () => HalfedgeMesh.fromTriangles(new BigInt64Array(3) as never, []),
      'positions is a BigInt64Array of 3 elements; expected numbers, not bigints.',
    ],
    [
      'bigints among the elements',
      () => HalfedgeMesh.fromTriangles([0, 0, 1n] as never, []),
      'positions[2] is the bigint 1n; expected a number.',
    ],
    [
      'a hole',
      () => HalfedgeMesh.fromTriangles(Object.assign(Array(3), { 0: 0, 2: 0 }), []),
      'positions[1] is undefined; expected a number.',
    ],
    [
      'a string among the elements',
      () => HalfedgeMesh.fromTriangles([0, '1', 0] as never, []),
      'positions[1] is "1"; expected a number.',
    ],
    [
      'a symbol among the elements',
      () => HalfedgeMesh.fromTriangles([0, Symbol('x'), 0] as never, []),
      'positions[1] is a symbol; expected a number.',
    ],
    [
      'null for indices',
      () => HalfedgeMesh.fromTriangles(positions, null as never),
      'indices is null; expected an array',
    ],
    [
      'a string among the indices',
      () => HalfedgeMesh.fromTriangles(positions, [0, '1', 2] as never),
      'indices[1] is "1"; expected an index',
    ],
    [
      'indices before positions',
      () => HalfedgeMesh.fromTriangles(Uint16Array.from(indices), Float32Array.from(positions)),
      'positions is a Uint16Array and indices a Float32Array; expected positions first, then indices.',
    ],
    [
      'indices before positions, of Directed Edges',
      () =>
        DirectedEdgesMesh.fromTriangles(Uint32Array.from(indices), Float64Array.from(positions)),
      'positions is a Uint32Array and indices a Float64Array; expected positions first, then indices.',
    ],
    [
      'null for a face',
      () => HalfedgeMesh.fromPolygons(positions, [[0, 1, 2], null] as never),
      'faces[1] is null; expected an array',
    ],
    [
      'a string in a face',
      () => HalfedgeMesh.fromPolygons(positions, [[0, 1, 'x']] as never),
      'faces[0][2] is "x"; expected an index',
    ],
    [
      'numbers for faces',
      () => HalfedgeMesh.fromPolygons(positions, [0, 1, 2] as never),
      'faces[2] is 2; expected an array',
    ],
    [
      'no faces',
      () => HalfedgeMesh.fromPolygons(positions, undefined as never),
      'faces is undefined; expected an array of faces',
    ],
    [
      'no sizes',
      () => HalfedgeMesh.fromPolygons(positions, { corners: [] } as never),
      'faces.sizes is undefined; expected an array',
    ],
    [
      'no options object',
      () => HalfedgeMesh.fromTriangles(positions, indices, 5 as never),
      'options is 5; expected an object.',
    ],
    [
      'null options',
      () => HalfedgeMesh.fromPolygons(positions, [], null as never),
      'options is null; expected an object.',
    ],
  ];
  test.each(typeErrors)('(%s) is a TypeError that names it', (_, call, message) => {
    expect(call).toThrow(TypeError);
    expect(call).toThrow(message);
  });

  const rangeErrors: [string, () => unknown, string][] = [
    [
      'too few positions',
      () => HalfedgeMesh.fromTriangles([1, 2], []),
      'positions has 2 elements; expected a multiple of 3',
    ],
    [
      'too few indices',
      () => HalfedgeMesh.fromTriangles(positions, [0, 1]),
      'indices has 2 elements; expected a multiple of 3',
    ],
    [
      'a fraction',
      () => HalfedgeMesh.fromTriangles(positions, [0, 1, 1.5]),
      'indices[2] is 1.5; expected an index',
    ],
    [
      'a fraction in floats',
      () => HalfedgeMesh.fromTriangles(positions, Float32Array.of(0, 1, 1.5)),
      'indices[2] is 1.5; expected an index',
    ],
    [
      'NaN',
      () => HalfedgeMesh.fromTriangles(positions, [0, Number.NaN, 2]),
      'indices[1] is NaN; expected an index',
    ],
    [
      '-1',
      () => HalfedgeMesh.fromTriangles(positions, [0, -1, 2]),
      'indices[1] is -1; expected an index',
    ],
    [
      '-1 in signed integers',
      () => HalfedgeMesh.fromTriangles(positions, Int16Array.of(0, -1, 2)),
      'indices[1] is -1; expected an index',
    ],
    [
      '2^32',
      () => HalfedgeMesh.fromTriangles(positions, [0, 1, 2 ** 32]),
      'indices[2] is 4294967296; expected an index, an integer from 0 to 4294967294.',
    ],
    [
      '-1 in a face',
      () => HalfedgeMesh.fromPolygons(positions, [[0, 1, -1]]),
      'faces[0][2] is -1; expected an index',
    ],
    [
      'a negative size',
      () => HalfedgeMesh.fromPolygons(positions, { sizes: Int8Array.of(-1), corners: [0] }),
      'sizes[0] is -1; expected',
    ],
    [
      'corners without sizes',
      () => HalfedgeMesh.fromPolygons(positions, { sizes: [], corners: [0, 1, 2] }),
      'faces.sizes is empty, but faces.corners has 3 elements',
    ],
    [
      'a position beyond floats',
      () => HalfedgeMesh.fromTriangles([0, 1e39, 0], []),
      'positions[1] is 1e+39; expected a number that fits a 32-bit float.',
    ],
    [
      'the same in doubles',
      () => HalfedgeMesh.fromTriangles(Float64Array.of(0, 0, -1e300), []),
      'positions[2] is -1e+300; expected a number that fits',
    ],
  ];
  test.each(rangeErrors)('(%s) is a RangeError that names it', (_, call, message) => {
    expect(call).toThrow(RangeError);
    expect(call).toThrow(message);
  });

  test('that lies about its size is refused by the core', () => {
    for (const sizes of [[4], [3, 3], [0xffff_fffe, 5], [2]]) {
      expect(() => HalfedgeMesh.fromPolygons(positions, { sizes, corners: [0, 1, 2] })).toThrow(
        HalfedgeError,
      );
    }
  });

  test('whose buffer was transferred away is a TypeError', () => {
    const gone = Float32Array.from(positions);
    structuredClone(gone.buffer, { transfer: [gone.buffer] });
    expect(() => HalfedgeMesh.fromTriangles(gone, indices)).toThrow(TypeError);
    expect(() => HalfedgeMesh.fromTriangles(gone, indices)).toThrow(
      'positions is a detached Float32Array',
    );
    using mesh = HalfedgeMesh.cube();
    for (const build of [
      () => HalfedgeMesh.fromPolygons(positions, gone as never),
      () => HalfedgeMesh.fromFaces(gone as never),
      () => HalfedgeMesh.fromSoup(positions, gone),
    ]) {
      expect(build).toThrow('faces is a detached Float32Array');
    }
    expect(() => mesh.addFace(gone)).toThrow('vertices is a detached Float32Array');
  });

  test('whose buffer was made shorter is a TypeError', () => {
    type Resizable = ArrayBuffer & { resize(bytes: number): void };
    const Buffers = ArrayBuffer as unknown as new (n: number, to: object) => Resizable;
    const cut = <View>(view: (buffer: Resizable) => View) => {
      const buffer = new Buffers(36, { maxByteLength: 36 });
      const made = view(buffer);
      buffer.resize(4);
      return made;
    };
    const why = 'that reaches beyond its buffer, which was made shorter; expected one with its';
    const fixed = cut((buffer) => new Float32Array(buffer, 0, 9));
    expect(() => HalfedgeMesh.fromTriangles(fixed, indices)).toThrow(
      new TypeError(`positions is a Float32Array ${why} elements.`),
    );
    expect(() => HalfedgeMesh.fromSoup(positions, fixed)).toThrow(
      new TypeError(`faces is a Float32Array ${why} elements.`),
    );
    for (const view of [
      cut((buffer) => new DataView(buffer, 8)),
      cut((buffer) => new Uint8Array(buffer, 8)),
    ]) {
      const error = new TypeError(`data is a view ${why} bytes.`);
      expect(() => HalfedgeMesh.parse(view as Uint8Array)).toThrow(error);
    }
    const gone = new DataView(new ArrayBuffer(8));
    structuredClone(gone.buffer, { transfer: [gone.buffer] });
    expect(() => HalfedgeMesh.fromBytes(gone)).toThrow('bytes is a detached buffer');
  });

  test('that is huge and empty costs no memory', () => {
    const faces = { length: 4_000_000_000 };
    expect(() => HalfedgeMesh.fromTriangles(faces as never, [])).toThrow('positions[3999999999]');
    expect(() => HalfedgeMesh.fromPolygons([], faces as never)).toThrow('faces[3999999999]');
  });

  test('cannot lie about the length of a typed array', () => {
    const lying = Float32Array.of(1, 2, 3);
    Object.defineProperty(lying, 'length', { value: 3_000_000 });
    using mesh = HalfedgeMesh.fromTriangles(lying, []);
    expect(mesh.vertexCount).toBe(1);
    expect(Array.from(mesh.positions)).toEqual([1, 2, 3]);
  });

  test('whose getters call the library themselves does no harm', () => {
    const meshes: HalfedgeMesh[] = [];
    const hostile = new Proxy([0, 0, 0, 1, 0, 0, 0, 1, 0], {
      get(target, key) {
        if (key === '4') meshes.push(HalfedgeMesh.fromTriangles(new Float32Array(3_000_000), []));
        return Reflect.get(target, key);
      },
    });
    using mesh = HalfedgeMesh.fromTriangles(hostile, [0, 1, 2]);
    expect(Array.from(mesh.positions)).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    expect(meshes.length).toBeGreaterThan(0);
    for (const other of meshes) other.dispose();

    let reads = 0;
    const growing = new Proxy([0, 0, 0], {
      get: (target, key) => (key === 'length' ? 3 * ++reads : Reflect.get(target, Number(key) % 3)),
    });
    expect(() => HalfedgeMesh.fromTriangles(growing as never, []).dispose()).not.toThrow();
    const angry = {
      length: 3,
      get 1(): number {
        throw new Error('mine');
      },
      0: 0,
      2: 0,
    };
    expect(() => HalfedgeMesh.fromTriangles(angry, [])).toThrow('mine');
  });
});

test.each([3, 100])('A list of %i items is read once, whatever its getters do', (count) => {
  using mesh = new HalfedgeMesh();
  const corners = Array.from({ length: 200 }, () => mesh.addVertex());
  const meshes: HalfedgeMesh[] = [];
  const reads: Record<string, number> = {};
  const hostile = new Proxy(corners.slice(0, count), {
    get(target, key) {
      reads[String(key)] = (reads[String(key)] ?? 0) + 1;
      if (key === '1') {
        meshes.push(HalfedgeMesh.fromTriangles(new Float32Array(6_000_000), []));
        mesh.addFace(corners.slice(-3)); // a short list of its own
      }
      return Reflect.get(target, key);
    },
  });
  mesh.addFace(corners.slice(-6, -3)); // what a short list is read into is there now
  const f = mesh.addFace(hostile);
  expect([...mesh.faceVertices(f)]).toEqual(corners.slice(0, count));
  expect(reads).toEqual(
    Object.fromEntries([['length', 1], ...corners.slice(0, count).map((i) => [i, 1])]),
  );
  for (const other of meshes) other.dispose();
});

test.each([
  [new (class Vector3 {})(), 'a Vector3'],
  [new Uint8Array(2), 'a Uint8Array of 2 elements'],
  [new URL('https://example.com'), 'a URL'],
  [new Error('no'), 'an Error'],
  [{ x: 1 }, 'an Object'],
  [Object.create(null), 'an Object'],
  [{ constructor: 3 }, 'an Object'],
  [{ constructor: { name: 'no class' } }, 'an Object'],
  [{ [Symbol.toStringTag]: 'X'.repeat(99) }, `a ${'X'.repeat(37)}...`],
  [Object.defineProperty({}, 'constructor', { get: () => raise('no') }), 'an object'],
])('Sentences say of which class an object is: %#', (value, name) => {
  using mesh = HalfedgeMesh.cube();
  expect(() => mesh.validate(value as never)).toThrow(
    `level is ${name}; expected an integer from 0 to 4, or 'geometry'.`,
  );
});

test('A mesh of another copy of the package is told from one of this copy', async () => {
  class HalfedgeMesh2 {}
  Object.defineProperty(HalfedgeMesh2, 'name', { value: 'HalfedgeMesh' });
  using mesh = HalfedgeMesh.cube();
  expect(() => mesh.append(new HalfedgeMesh2() as never)).toThrow(
    'other is a HalfedgeMesh; expected a HalfedgeMesh that this copy of the package has made.',
  );
});

test('A list is no object with options', () => {
  using mesh = HalfedgeMesh.cube();
  for (const list of [[0], new Uint32Array(1), new DataView(new ArrayBuffer(1)), new Set([0])]) {
    for (const call of [
      () => mesh.star(list as never),
      () => mesh.fillHoles(list as never),
      () => HalfedgeMesh.fromTriangles(positions, indices, list as never),
    ]) {
      expect(call).toThrow(TypeError);
      expect(call).toThrow(
        /^(items|options) is an? \w+( of 1 element)?; expected a plain object\.$/,
      );
    }
  }
});

test('A mesh is no options of another one', () => {
  using mesh = HalfedgeMesh.cube();
  using directed = DirectedEdgesMesh.fromTriangles(positions, indices);
  expect(() => new HalfedgeMesh(mesh as never)).toThrow(
    new TypeError(
      'options is a HalfedgeMesh; expected an object such as { storePrev }: to copy a mesh, use its clone().',
    ),
  );
  for (const [options, name] of [
    [directed, 'a DirectedEdgesMesh'],
    [Promise.resolve({ storePrev: false }), 'a Promise, which is to be awaited'],
    [new ArrayBuffer(8), 'an ArrayBuffer'],
    [new Map([['storePrev', false]]), 'a Map'],
  ] as const) {
    expect(() => new HalfedgeMesh(options as never)).toThrow(
      new TypeError(`options is ${name}; expected a plain object.`),
    );
  }
});

test('Options may be those of a class, or what a module exports', async () => {
  class Options {
    storePrev = false;
  }
  const module = await import('./support/options.js');
  for (const options of [new Options(), module, Object.create(null)]) {
    using mesh = HalfedgeMesh.cube(options);
    expect(mesh.connectivity.prev).toHaveLength(24 * Number(options.storePrev ?? true));
  }
});

test('A count that is too large is told how large it may be', () => {
  const mesh = HalfedgeMesh.tetrahedron();
  for (const call of [
    () => mesh.keepLargestComponents(2 ** 31),
    () => mesh.reserve(2 ** 31, 0, 0),
  ]) {
    expect(call).toThrow(/ is 2147483648; expected an integer from 0 to 2147483647\.$/);
  }
  expect(() => mesh.keepLargestComponents(-1)).toThrow('count is -1; expected an integer from 0.');
  mesh.dispose();
});

test('What JavaScript has no room for is told by what it is for, copy or not', () => {
  expect(() => newArray('the sums of normals', Float64Array, 2 ** 53)).toThrow(
    expect.objectContaining({
      code: 'out-of-memory',
      message: `An array for the sums of normals needs room for ${2 ** 53} numbers, more than JavaScript has.`,
    }),
  );
});
