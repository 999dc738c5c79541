import { HalfedgeMesh, init, type Rows } from 'halfedge';
import { quadGrid, randomPolygons, triangleAndIsolatedVertex } from './support/meshes.js';
import { random, shuffle } from './support/random.js';
import { Reference } from './support/reference.js';

beforeAll(() => init());

const rowsOf = ({ offsets, items }: Rows): number[][] =>
  Array.from({ length: offsets.length - 1 }, (_, i) =>
    Array.from(items.subarray(offsets[i], offsets[i + 1])),
  );
/** The rows that are not what is expected; for so many that `toEqual` would take seconds. */
const differing = (rows: Rows, expected: (i: number) => Iterable<number>): number[] =>
  rowsOf(rows).flatMap((row, i) => (row.join() === [...expected(i)].join() ? [] : [i]));
const reversed = <T>(rows: T[][]): T[][] => rows.map((row) => [...row].reverse());

describe('All rings in one call', () => {
  test.each([11, 12, 13, 14, 15, 16, 17, 18])('are those of the faces (seed %i)', (seed) => {
    const input = randomPolygons(seed);
    using mesh = HalfedgeMesh.fromPolygons(input.positions, input.faces);
    const reference = new Reference(input);

    const spokes = Array.from({ length: reference.vertexCount }, (_, v) => reference.spokesCw(v));
    const outgoing = spokes.map((row, v) => row.map(({ to }) => mesh.findHalfedge(v, to)));
    const aroundVertices: [Rows, Rows, number[][]][] = [
      [
        mesh.allVertexVertices('cw'),
        mesh.allVertexVertices('ccw'),
        spokes.map((row) => row.map(({ to }) => to)),
      ],
      [
        mesh.allVertexFaces('cw'),
        mesh.allVertexFaces('ccw'),
        spokes.map((row) => row.map(({ face }) => face).filter((face) => face >= 0)),
      ],
      [mesh.allVertexOutgoingHalfedges('cw'), mesh.allVertexOutgoingHalfedges('ccw'), outgoing],
      [
        mesh.allVertexIncomingHalfedges('cw'),
        mesh.allVertexIncomingHalfedges('ccw'),
        outgoing.map((row) => row.map((h) => h ^ 1)),
      ],
      [
        mesh.allVertexEdges('cw'),
        mesh.allVertexEdges('ccw'),
        outgoing.map((row) => row.map((h) => h >> 1)),
      ],
    ];
    for (const [cw, ccw, expected] of aroundVertices) {
      expect(rowsOf(cw)).toEqual(expected);
      expect(rowsOf(ccw)).toEqual(reversed(expected));
    }

    const sides = input.faces.map((_, f) => reference.sidesCcw(f));
    const inFaces = sides.map((row) => row.map(([a, b]) => mesh.findHalfedge(a, b)));
    const aroundFaces: [Rows, Rows, number[][]][] = [
      [mesh.allFaceVertices('ccw'), mesh.allFaceVertices('cw'), input.faces],
      [mesh.allFaceHalfedges('ccw'), mesh.allFaceHalfedges('cw'), inFaces],
      [
        mesh.allFaceEdges('ccw'),
        mesh.allFaceEdges('cw'),
        inFaces.map((row) => row.map((h) => h >> 1)),
      ],
      [
        mesh.allFaceFaces('ccw'),
        mesh.allFaceFaces('cw'),
        sides.map((row) => row.map(([a, b]) => reference.faceOf(b, a)).filter((f) => f >= 0)),
      ],
    ];
    for (const [ccw, cw, expected] of aroundFaces) {
      expect(rowsOf(ccw)).toEqual(expected);
      expect(rowsOf(cw)).toEqual(reversed(expected));
    }

    const edges = Array.from({ length: mesh.edgeCount }, (_, e) => [2 * e, 2 * e + 1]);
    expect(rowsOf(mesh.allEdgeHalfedges())).toEqual(edges);
    expect(rowsOf(mesh.allEdgeVertices())).toEqual(
      edges.map((row) => row.map((h) => mesh.toVertex(h))),
    );
    expect(rowsOf(mesh.allEdgeFaces())).toEqual(
      edges.map((row) => row.map((h) => mesh.face(h)).filter((f) => f >= 0)),
    );
  });

  test('are counter-clockwise unless asked otherwise', () => {
    const { positions, faces } = quadGrid();
    using mesh = HalfedgeMesh.fromPolygons(positions, faces);
    expect(mesh.allVertexVertices()).toEqual(mesh.allVertexVertices('ccw'));
    expect(mesh.allFaceVertices()).toEqual(mesh.allFaceVertices('ccw'));
    expect(rowsOf(mesh.allVertexVertices())[5]).toEqual([9, 4, 1, 6]);
  });

  test('have an empty row for an isolated vertex', () => {
    const { positions, faces } = triangleAndIsolatedVertex();
    using mesh = HalfedgeMesh.fromPolygons(positions, faces);
    expect(rowsOf(mesh.allVertexVertices('cw'))[3]).toEqual([]);
    expect(rowsOf(mesh.allVertexFaces('cw', [3, 0, 3]))).toEqual([[], [0], []]);
  });

  test('of an empty mesh are no rows', () => {
    using mesh = new HalfedgeMesh();
    expect(mesh.allVertexVertices()).toEqual({
      offsets: Uint32Array.of(0),
      items: new Uint32Array(0),
    });
  });

  test('are copies, which outlive the mesh', () => {
    const { positions, faces } = quadGrid();
    const mesh = HalfedgeMesh.fromPolygons(positions, faces);
    const { offsets, items } = mesh.allFaceVertices();
    mesh.connectivity.toVertex.fill(0);
    mesh.dispose();
    expect(rowsOf({ offsets, items })).toEqual(faces);
    expect(items.buffer.byteLength).toBe(4 * items.length);
  });
});

describe('Rows that are written over', () => {
  const { positions, faces } = quadGrid();
  let mesh: HalfedgeMesh;
  beforeEach(() => {
    mesh = HalfedgeMesh.fromPolygons(positions, faces);
  });
  afterEach(() => mesh.dispose());

  test('come back in the same arrays, of every kind of ring', () => {
    const all = [
      ['allVertexVertices', 'allVertexOutgoingHalfedges', 'allVertexIncomingHalfedges'],
      ['allVertexEdges', 'allVertexFaces'],
      ['allFaceVertices', 'allFaceHalfedges', 'allFaceEdges', 'allFaceFaces'],
      ['allEdgeVertices', 'allEdgeHalfedges', 'allEdgeFaces'],
    ] as const;
    for (const method of all.flat()) {
      const expected = mesh[method]('cw');
      const into = {
        offsets: expected.offsets.slice().fill(99),
        items: expected.items.slice().fill(99),
      };
      const rows = mesh[method]('cw', undefined, into);
      expect(rows.offsets).toBe(into.offsets);
      expect(rows.items).toBe(into.items);
      expect(rows).toEqual(expected);
    }
    const few = { offsets: new Uint32Array(2), items: new Uint32Array(4) };
    expect(mesh.allFaceVertices('ccw', [3], few).items).toBe(few.items);
    expect(mesh.allEdgeVertices([0], undefined, few).items.buffer).toBe(few.items.buffer);
  });

  test('are the first part of longer arrays, and new ones where they are too short', () => {
    const whole = mesh.allFaceFaces();
    mesh.deleteFace(0);
    const expected = mesh.allFaceFaces();
    expect(expected.items.length).toBeLessThan(whole.items.length);
    const rows = mesh.allFaceFaces('ccw', undefined, whole);
    expect(rows).toEqual(expected);
    expect(rows.offsets).toBe(whole.offsets);
    expect(rows.items.buffer).toBe(whole.items.buffer);

    const short = { offsets: new Uint32Array(3), items: rows.items.slice(1) };
    const made = mesh.allFaceFaces('ccw', undefined, short);
    expect(made).toEqual(expected);
    expect(made.offsets.buffer).not.toBe(short.offsets.buffer);
    expect(made.items.buffer).not.toBe(short.items.buffer);
    expect(short.items).toEqual(rows.items.slice(1));

    const sent = mesh.allFaceFaces();
    structuredClone(sent, { transfer: [sent.offsets.buffer, sent.items.buffer] });
    expect(mesh.allFaceFaces('ccw', undefined, sent)).toEqual(expected);
  });

  test('are rows', () => {
    const ask = (into: unknown) => () => mesh.allFaceFaces('ccw', undefined, into as Rows);
    expect(ask(new Uint32Array(99))).toThrow(
      'into is a Uint32Array of 99 elements; expected rows of an earlier call: offsets and items, both Uint32Arrays.',
    );
    expect(ask(null)).toThrow('into is null; expected rows of an earlier call');
    expect(ask({ offsets: new Uint32Array(99), items: new Int32Array(99) })).toThrow(TypeError);
    expect(ask({ offsets: [0], items: new Uint32Array(99) })).toThrow('into is an Object;');
  });
});

describe('Rings of a list of items', () => {
  const { positions, faces } = quadGrid();
  let mesh: HalfedgeMesh;
  beforeAll(() => {
    mesh = HalfedgeMesh.fromPolygons(positions, faces);
  });
  afterAll(() => mesh.dispose());

  test('come in the order of the list, as often as named', () => {
    expect(rowsOf(mesh.allVertexVertices('cw', [5, 1, 5]))).toEqual([
      [6, 1, 4, 9],
      [0, 5, 2],
      [6, 1, 4, 9],
    ]);
    expect(rowsOf(mesh.allFaceFaces('ccw', Uint8Array.of(4, 0)))).toEqual([
      [3, 1, 5, 7],
      [1, 3],
    ]);
    expect(rowsOf(mesh.allEdgeFaces([mesh.findEdge(1, 5)]))).toHaveLength(1);
    expect(rowsOf(mesh.allVertexEdges('ccw', []))).toEqual([]);
  });

  test('refuse an item that is not there, and say where it was named', () => {
    const ask = (list: ArrayLike<number>) => () => mesh.allVertexVertices('ccw', list);
    expect(ask([0, 16])).toThrow(
      new RangeError('vertices[1] is 16; expected a vertex from 0 to 15.'),
    );
    expect(ask(Int32Array.of(3, -1))).toThrow(
      new RangeError('vertices[1] is -1; expected a vertex from 0 to 15.'),
    );
    using holed = mesh.clone();
    holed.deleteFace(4);
    expect(() => holed.allFaceVertices('cw', [0, 4])).toThrow(
      new RangeError('faces[1] is face 4, which was deleted; expected a live one.'),
    );
    holed.deleteEdge(0);
    expect(() => holed.allEdgeFaces('ccw', Uint8Array.of(0))).toThrow('edges[0] is edge 0, which');
    expect(ask([0.5])).toThrow('vertices[0] is 0.5');
    expect(ask(['1'] as unknown as number[])).toThrow(TypeError);
    expect(ask('01' as unknown as number[])).toThrow(TypeError);
  });

  test('take a direction for edges, too, which have one order in both', () => {
    const expected = rowsOf(mesh.allEdgeVertices());
    for (const direction of ['ccw', 'cw'] as const) {
      expect(rowsOf(mesh.allEdgeVertices(direction))).toEqual(expected);
      expect(rowsOf(mesh.allEdgeVertices(direction, [3, 2]))).toEqual([expected[3], expected[2]]);
    }
    expect(() => mesh.allEdgeFaces('up' as 'cw')).toThrow(RangeError);
    expect(() => mesh.allEdgeFaces(null as never)).toThrow(TypeError);
  });

  test('refuse a direction that is none', () => {
    expect(() => mesh.allVertexVertices('up' as 'cw')).toThrow(
      new RangeError(`direction is "up"; expected 'ccw' or 'cw'.`),
    );
    expect(() => mesh.allFaceFaces(1 as unknown as 'cw')).toThrow(TypeError);
  });
});

// Vertices and faces in no order, and so many that builds and rings touch their memory in blocks.
describe('A large mesh in no order', () => {
  const side = 200;
  const { faces: quads } = quadGrid(side, side);
  const triangles = quads.flatMap(([a, b, c, d]) => [
    [a, b, c],
    [a, c, d],
  ]);
  test.each([
    ['triangles', triangles],
    ['quads', quads],
  ])('of %s is what its faces say', (_, faces) => {
    const next = random(1);
    const names = shuffle(
      Array.from({ length: side * side }, (_, v) => v),
      next,
    );
    const renamed = shuffle([...faces], next).map((face) => face.map((v) => names[v]));
    const positions = Float32Array.from({ length: 3 * side * side }, next);
    using mesh = HalfedgeMesh.fromPolygons(positions, renamed);

    expect(mesh.validate()).toEqual([]);
    expect(mesh.edgeCount).toBe(side * side + faces.length - 1); // Euler: a disk
    expect(differing(mesh.allFaceVertices(), (f) => renamed[f])).toEqual([]);
    expect(differing(mesh.allVertexVertices(), (v) => mesh.vertexVertices(v))).toEqual([]);
    expect(differing(mesh.allFaceFaces('cw'), (f) => mesh.faceFaces(f, 'cw'))).toEqual([]);
  });
});
