import { runInNewContext } from 'node:vm';
import { DirectedEdgesMesh, HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { quadGrid, randomPolygons, tetrahedron } from './support/meshes.js';
import { random, shuffle } from './support/random.js';

beforeAll(() => init());

const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];
const indices = [0, 1, 2, 2, 1, 3];

/** What `call` throws. */
function thrownBy(call: () => unknown): HalfedgeError {
  try {
    call();
  } catch (error) {
    return error as HalfedgeError;
  }
  throw new Error('Nothing was thrown.');
}

const facesOf = (mesh: HalfedgeMesh): number[][] => {
  const { sizes, corners } = mesh.toPolygons();
  let end = 0;
  return Array.from(sizes, (size) => {
    end += size;
    return Array.from(corners.subarray(end - size, end));
  });
};

describe('A mesh from triangles', () => {
  const arrays: [string, ArrayLike<number>, ArrayLike<number>][] = [
    ['plain arrays', positions, indices],
    ['Float32Array and Uint32Array', Float32Array.from(positions), Uint32Array.from(indices)],
    ['Float64Array and Uint16Array', Float64Array.from(positions), Uint16Array.from(indices)],
    ['Int8Array and Uint8Array', Int8Array.from(positions), Uint8Array.from(indices)],
    ['Int16Array and Int32Array', Int16Array.from(positions), Int32Array.from(indices)],
    [
      'Uint8ClampedArray and Float64Array',
      Uint8ClampedArray.from(positions),
      Float64Array.from(indices),
    ],
    ['array-like objects', { ...positions, length: 12 }, { ...indices, length: 6 }],
    [
      'views of shared memory',
      (() => {
        const view = new Float32Array(new SharedArrayBuffer(48));
        view.set(positions);
        return view;
      })(),
      (() => {
        const view = new Uint32Array(new SharedArrayBuffer(24));
        view.set(indices);
        return view;
      })(),
    ],
    [
      'views in the middle of a buffer',
      new Float32Array(Float32Array.from([9, ...positions, 9]).buffer, 4, 12),
      new Uint32Array(Uint32Array.from([9, ...indices, 9]).buffer, 4, 6),
    ],
  ];
  test.each(arrays)('takes %s, and leaves them alone', (_, points, corners) => {
    const before = [Array.from(points), Array.from(corners)];
    using mesh = HalfedgeMesh.fromTriangles(points, corners);
    expect([Array.from(points), Array.from(corners)]).toEqual(before);
    expect(Array.from(mesh.positions)).toEqual(positions);
    expect(facesOf(mesh)).toEqual([
      [0, 1, 2],
      [2, 1, 3],
    ]);
    expect(mesh.validate()).toEqual([]);
  });

  test('can be one without faces, or without anything', () => {
    using points = HalfedgeMesh.fromTriangles(positions, []);
    expect([points.vertexCount, points.edgeCount, points.faceCount]).toEqual([4, 0, 0]);
    using nothing = HalfedgeMesh.fromTriangles([], []);
    expect(nothing.vertexCount).toBe(0);
    expect(nothing.positions.length).toBe(0);
  });

  test('can be made of the live views of another mesh, while copying them makes the memory grow', () => {
    const count = 400_000;
    const numbers = Float32Array.from({ length: 3 * count }, (_, i) => i);
    using first = HalfedgeMesh.fromTriangles(numbers, []);
    const meshes: HalfedgeMesh[] = [];
    // Each input is larger than what the one before has left free, so that room for it is made.
    for (let n = 3 * 10_000; n <= 3 * count; n += 3 * 10_000) {
      const mesh = HalfedgeMesh.fromTriangles(first.positions.subarray(0, n), []);
      meshes.push(mesh);
      expect(mesh.positions[n - 1]).toBe(n - 1);
      expect(mesh.positions[0]).toBe(0);
    }
    for (const mesh of meshes) mesh.dispose();
  });
});

// A build of scattered sides touches what it needs next, also where it has put nothing yet.
test.each([
  ['HalfedgeMesh', HalfedgeMesh],
  ['DirectedEdgesMesh', DirectedEdgesMesh],
])('Scattered triangles are built in memory that holds anything: %s', (_, Mesh) => {
  const count = 4_000;
  const numbers = Array.from({ length: count }, (_, v) => v);
  const vertices = shuffle(numbers, random(3));
  const pairs = Array.from({ length: count / 4 }, (_, i) => vertices.slice(4 * i, 4 * i + 4));
  const triangles = pairs.flatMap(([a, b, c, d]) => [a, b, c, c, b, d]);
  const far = new Float32Array(3 * count).fill(1e-9); // as indices, outside of the memory
  for (let round = 0; round < 10; round++) {
    const left = Array.from({ length: 8 }, () => HalfedgeMesh.fromTriangles(far, []));
    for (const mesh of left) mesh.dispose();
    using mesh = Mesh.fromTriangles(far, triangles);
    expect([mesh.vertexCount, mesh.edgeCount]).toEqual([count, (5 * count) / 4]);
    expect(mesh.validate()).toEqual([]);
  }
});

// Sides of many triangles are divided among buckets before they are matched, if they come in random order
// and the mesh stores prev, whose array that takes.
test('Many triangles in random order become the same mesh as without prev', () => {
  const size = 460;
  const next = random(5);
  const names = shuffle(
    Array.from({ length: size * size }, (_, v) => v),
    next,
  );
  const at = (x: number, y: number) => names[y * size + x];
  const squares = Array.from({ length: (size - 1) * (size - 1) }, (_, i) => {
    const [x, y] = [i % (size - 1), Math.floor(i / (size - 1))];
    return [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
  });
  const triangles = squares
    .filter((_, i) => i % 777 !== 0)
    .flatMap(([a, b, c, d]) => [
      [a, b, c],
      [c, d, a],
    ]);
  const corners = Uint32Array.from(shuffle(triangles, next).flat());
  const points = new Float32Array(3 * size * size);
  using mesh = HalfedgeMesh.fromTriangles(points, corners);
  using without = HalfedgeMesh.fromTriangles(points, corners, { storePrev: false });
  const { prev, ...links } = mesh.connectivity;
  const { prev: none, ...others } = without.connectivity;
  expect(links).toEqual(others);
  expect(prev?.every((h, i) => links.next[h] === i)).toBe(true);
  expect(mesh.validate(3)).toEqual([]);
});

test('Arrays of another realm, such as a frame, are as good as any', () => {
  const foreign = (code: string) => runInNewContext(code);
  using mesh = HalfedgeMesh.fromTriangles(
    foreign('Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0)'),
    foreign('Uint32Array.of(0, 1, 2)'),
  );
  expect(mesh.faceCount).toBe(1);
  using compact = DirectedEdgesMesh.fromTriangles(mesh.positions, [0, 1, 2]);
  for (const from of [mesh, compact]) {
    const buffer = foreign('new Int32Array(4)') as Int32Array;
    expect(from.faceVertices(0).into(buffer)).toBe(3);
    expect([...buffer]).toEqual([0, 1, 2, 0]);
    expect(() => from.faceVertices(0).into(foreign('new Int16Array(4)') as Int32Array)).toThrow(
      'expected an Int32Array or a Uint32Array',
    );
  }
  const { mesh: read } = HalfedgeMesh.parse(
    foreign(`Uint8Array.from('OFF 0 0 0', (c) => c.charCodeAt(0)).buffer`),
  );
  expect(read.vertexCount).toBe(0);
  read.dispose();
});

describe('A mesh from polygons', () => {
  test('is the same from arrays of faces and from sizes and corners', () => {
    const { positions: points, faces } = randomPolygons(21);
    using a = HalfedgeMesh.fromPolygons(points, faces);
    const sizes = faces.map((face) => face.length);
    using b = HalfedgeMesh.fromPolygons(points, { sizes, corners: faces.flat() });
    using c = HalfedgeMesh.fromPolygons(
      points,
      faces.map((face) => Uint16Array.from(face)),
    );
    expect(facesOf(a)).toEqual(faces);
    expect(b.connectivity).toEqual(a.connectivity);
    expect(c.connectivity).toEqual(a.connectivity);
  });

  test('comes back from its own export', () => {
    const { positions: points, faces } = randomPolygons(22);
    using a = HalfedgeMesh.fromPolygons(points, faces);
    using b = HalfedgeMesh.fromPolygons(a.positions, a.toPolygons());
    expect(b.connectivity).toEqual(a.connectivity);
    expect(b.positions).toEqual(a.positions);
  });

  test.each([31, 32, 33, 34])('does not depend on the order of faces (seed %i)', (seed) => {
    const { positions: points, faces } = randomPolygons(seed);
    const order = shuffle(
      faces.map((_, f) => f),
      random(seed),
    );
    using a = HalfedgeMesh.fromPolygons(points, faces);
    using b = HalfedgeMesh.fromPolygons(
      points,
      order.map((f) => faces[f]),
    );
    expect(b.edgeCount).toBe(a.edgeCount);
    for (let h = 0; h < a.halfedgeSlots; h++) {
      const same = b.findHalfedge(a.fromVertex(h), a.toVertex(h));
      const next = a.next(h);
      const sameNext = b.findHalfedge(a.fromVertex(next), a.toVertex(next));
      expect(b.next(same)).toBe(sameNext);
      expect(a.face(h) < 0 ? -1 : order.indexOf(a.face(h))).toBe(b.face(same));
    }
  });
});

describe('A refused build', () => {
  const cases: [code: string, faces: number[][], says: RegExp, witness: object][] = [
    [
      'edge-with-many-faces',
      [
        [0, 1, 2],
        [0, 1, 3],
        [1, 0, 4],
      ], // prettier-ignore
      /0.*1/,
      {},
    ],
    [
      'opposite-orientation',
      [
        [0, 1, 2],
        [0, 1, 3],
      ],
      /0.*1/,
      {},
    ],
    [
      'duplicate-face',
      [
        [0, 1, 2],
        [1, 2, 0],
      ],
      /0.*1/,
      { faces: [0, 1] },
    ],
    ['repeated-vertex', [[0, 1, 1]], /1/, { faces: [0], vertices: [1] }],
    ['degree-below-three', [[0, 1]], /2/, { faces: [0] }],
    ['index-out-of-range', [[0, 1, 99]], /99/, { faces: [0] }],
  ];
  test.each(cases)('says %s', (code, faces, says, witness) => {
    const points = Array.from({ length: 15 }, (_, i) => i);
    const error = thrownBy(() => HalfedgeMesh.fromPolygons(points, faces));
    expect(error).toBeInstanceOf(HalfedgeError);
    expect(error).toBeInstanceOf(Error);
    expect(error.name).toBe('HalfedgeError');
    expect(error.code).toBe(code);
    expect(error.message).toMatch(says);
    expect(error.message).toMatch(/^[A-Z].*[.)]$/);
    expect(error.witness).toMatchObject(witness);
    expect(error.problems[0]).toMatchObject({ code, severity: 'error' });
    expect(error.problems.some((problem) => problem.code === code)).toBe(true);
  });

  test('says non-finite-position', () => {
    const error = thrownBy(() => HalfedgeMesh.fromTriangles([0, 0, 0, 1, Number.NaN, 0], []));
    expect(error.code).toBe('non-finite-position');
    expect(error.problems[0]).toMatchObject({ kind: 'vertex', index: 1 });
  });

  test('says pinched-vertex where two solids touch', () => {
    const { positions: points, faces } = tetrahedron();
    const other = faces.map((face) => face.map((v) => (v === 0 ? 0 : v + 3)));
    const error = thrownBy(() =>
      HalfedgeMesh.fromPolygons([...points, ...points.slice(3)], [...faces, ...other]),
    );
    expect(error.code).toBe('pinched-vertex');
    expect(error.witness.vertices).toEqual([0]);
    expect(error.problems[0]).toMatchObject({ kind: 'vertex', index: 0 });
  });

  test('lists every problem, and says how many more there are', () => {
    const error = thrownBy(() =>
      HalfedgeMesh.fromTriangles(positions, [0, 1, 1, 0, 2, 2, 3, 3, 3]),
    );
    expect(error.problems.length).toBeGreaterThanOrEqual(3);
    expect(error.message).toContain(`And ${error.problems.length - 1} more problems.`);
  });

  test('lists a thousand of a million problems, and counts them all', () => {
    const error = thrownBy(() => HalfedgeMesh.fromTriangles(positions, new Uint32Array(3_000_000)));
    expect(error.problems).toHaveLength(1000);
    expect(error.message).toMatch(/And 999999 more problems\.$/);
  });
});

describe('A clone', () => {
  test('has the same indices and its own memory', () => {
    const { positions: points, faces } = quadGrid();
    const mesh = HalfedgeMesh.fromPolygons(points, faces);
    using copy = mesh.clone();
    expect(copy.connectivity).toEqual(mesh.connectivity);
    expect(copy.positions).toEqual(mesh.positions);
    copy.positions[0] = 7;
    expect(mesh.positions[0]).toBe(0);
    mesh.dispose();
    expect(copy.positions[0]).toBe(7);
    expect(copy.validate()).toEqual([]);
  });
});

describe('Connectivity alone', () => {
  const streetBlock = [
    [0, 1, 2],
    [0, 2, 3],
    [3, 2, 1, 0],
  ];

  test('has the links of the mesh with positions', () => {
    using mesh = HalfedgeMesh.fromFaces(streetBlock);
    using placed = HalfedgeMesh.fromPolygons(new Float32Array(12), streetBlock);
    expect(mesh.connectivity).toEqual(placed.connectivity);
    expect(mesh.positions).toEqual(new Float32Array(12));
    expect(mesh.eulerCharacteristic()).toBe(2);
    expect(mesh.validate()).toEqual([]);
  });

  test('takes flat arrays, options, and more vertices than faces use', () => {
    const polygons = { sizes: [3, 3, 4], corners: streetBlock.flat() };
    using mesh = HalfedgeMesh.fromFaces(polygons, { vertexCount: 6, storePrev: false });
    expect(mesh.vertexCount).toBe(6);
    expect(mesh.isIsolatedVertex(5)).toBe(true);
    using fewer = HalfedgeMesh.fromFaces(polygons, { vertexCount: 2 });
    expect(fewer.vertexCount).toBe(4);
    using none = HalfedgeMesh.fromFaces([]);
    expect(none.vertexCount).toBe(0);
  });

  test('refuses what no memory holds, and what is no count', () => {
    expect(() => HalfedgeMesh.fromFaces([[0, 1, 4_000_000_000]])).toThrow(
      /faces has the vertex 4000000000; expected less than 268435455/,
    );
    expect(() => HalfedgeMesh.fromFaces([[0, 1, -2]])).toThrow(/-2/);
    expect(() => HalfedgeMesh.fromFaces({ sizes: [3], corners: Int32Array.of(0, 1, -2) })).toThrow(
      /-2/,
    );
    for (const vertexCount of [-1, 1.5, 2 ** 31, '4'] as number[]) {
      expect(() => HalfedgeMesh.fromFaces([], { vertexCount })).toThrow(
        /options\.vertexCount is .*; expected an integer from 0 to/,
      );
    }
    expect(() =>
      HalfedgeMesh.fromFaces([
        [0, 1, 2],
        [0, 1, 2],
      ]),
    ).toThrow(/[Ff]ace/);
  });
});
