import { HalfedgeMesh, type ItemSet, init } from 'halfedge';
import { bytesInUse } from './support/core.js';

beforeAll(() => init());

const arrays = ({ vertices, edges, faces }: ItemSet) => ({
  vertices: [...vertices],
  edges: [...edges],
  faces: [...faces],
});
const sorted = (items: Iterable<number>) => [...items].sort((a, b) => a - b);

describe('The kind of a surface', () => {
  test('is told by isClosed, isTriangleMesh and isQuadMesh', () => {
    const kind = (mesh: HalfedgeMesh) => {
      const all = [mesh.isClosed(), mesh.isTriangleMesh(), mesh.isQuadMesh()];
      mesh.dispose();
      return all;
    };
    expect(kind(HalfedgeMesh.cube())).toEqual([true, false, true]);
    expect(kind(HalfedgeMesh.icosahedron())).toEqual([true, true, false]);
    expect(kind(HalfedgeMesh.grid(2))).toEqual([false, false, true]);
    expect(kind(HalfedgeMesh.cone(5, { base: 'open' }))).toEqual([false, true, false]);
    expect(kind(HalfedgeMesh.uvSphere(5, 4, { storePrev: false }))).toEqual([true, false, false]);
    expect(kind(new HalfedgeMesh())).toEqual([true, true, true]);
  });
});

describe('kRing', () => {
  test('has a row for each distance', () => {
    using mesh = HalfedgeMesh.grid(6, 6); // 7 x 7 vertices, quads: distances as a taxi has them
    const { offsets, items } = mesh.kRing(24, 3);
    expect([...offsets]).toEqual([0, 1, 5, 13, 25]);
    expect(items[0]).toBe(24);
    expect(sorted(items.subarray(1, 5))).toEqual([17, 23, 25, 31]);
    const [x, y] = [(v: number) => v % 7, (v: number) => Math.floor(v / 7)];
    items.forEach((v, i) => {
      const d = Math.abs(x(v) - 3) + Math.abs(y(v) - 3);
      expect(i >= offsets[d] && i < offsets[d + 1]).toBe(true);
    });
  });

  test('goes on to all that is connected, from several vertices', () => {
    using mesh = HalfedgeMesh.grid(4, 1);
    expect([...mesh.kRing([0, 4, 0], Infinity).offsets]).toEqual([0, 2, 6, 9, 10]);
    expect([...mesh.kRing([], 5).offsets]).toEqual([0]);
    expect([...mesh.kRing(3, 0).items]).toEqual([3]);
  });

  test('refuses what is no vertex and no distance', () => {
    using mesh = HalfedgeMesh.cube();
    const before = bytesInUse();
    expect(() => mesh.kRing(8, 1)).toThrow(
      new RangeError('vertices is 8; expected a vertex from 0 to 7.'),
    );
    expect(() => mesh.kRing([0, 9], 1)).toThrow('vertices[1] is 9; expected a vertex from 0 to 7.');
    expect(() => mesh.kRing([-1], 1)).toThrow(RangeError);
    expect(() => mesh.kRing('0' as never, 1)).toThrow(TypeError);
    for (const k of [-1, 1.5, Number.NaN]) {
      expect(() => mesh.kRing(0, k)).toThrow(
        `k is ${k}; expected an integer from 0 on, or Infinity.`,
      );
    }
    expect(() => mesh.kRing(0, '1' as never)).toThrow(TypeError);
    expect(bytesInUse()).toBe(before);
  });
});

describe('Star, closure and link', () => {
  test('take the maps of append for what they lead to', () => {
    const mesh = HalfedgeMesh.grid(2, 2);
    const added = mesh.append(HalfedgeMesh.tetrahedron());
    const star = mesh.star(added);
    expect([...star.vertices]).toEqual([...added.vertices]);
    expect(star.faces).toHaveLength(4);
    expect(() => mesh.star({ halfedges: [0] } as never)).toThrow(
      'items has the name "halfedges"; expected vertices, edges or faces.',
    );
  });

  test('are those of the circulators around a vertex', () => {
    using mesh = HalfedgeMesh.icoSphere(2);
    for (const v of mesh.vertices()) {
      expect(arrays(mesh.star({ vertices: [v] }))).toEqual({
        vertices: [v],
        edges: sorted(mesh.vertexEdges(v)),
        faces: sorted(mesh.vertexFaces(v)),
      });
      const link = mesh.link({ vertices: [v] });
      expect([...link.vertices]).toEqual(sorted(mesh.vertexVertices(v)));
      expect(link.edges).toHaveLength(mesh.valence(v));
      expect(link.faces).toHaveLength(0);
    }
  });

  test('fit together', () => {
    using mesh = HalfedgeMesh.grid(3, 3, { storePrev: false });
    const items = { vertices: [0], edges: [5], faces: Uint32Array.of(8) };
    const star = mesh.star(items);
    const closed = mesh.closure(star);
    const open = mesh.star(mesh.closure(items));
    const without = (a: Uint32Array, b: Uint32Array) => [...a].filter((i) => !b.includes(i));
    expect(arrays(mesh.link(items))).toEqual({
      vertices: without(closed.vertices, open.vertices),
      edges: without(closed.edges, open.edges),
      faces: without(closed.faces, open.faces),
    });
    expect(arrays(mesh.closure({ faces: [4] }))).toEqual({
      vertices: sorted(mesh.faceVertices(4)),
      edges: sorted(mesh.faceEdges(4)),
      faces: [4],
    });
    expect(arrays(mesh.star({}))).toEqual({ vertices: [], edges: [], faces: [] });
  });

  test('take items in a Set, or as a range', () => {
    using mesh = HalfedgeMesh.torus(6, 5);
    const around = mesh.vertexFaces(7).toArray();
    const star = mesh.star({ faces: around });
    expect(mesh.star({ faces: new Set(around) })).toEqual(star);
    expect(mesh.star({ faces: mesh.vertexFaces(7) })).toEqual(star);
    expect(mesh.kRing(mesh.faceVertices(3), 1)).toEqual(
      mesh.kRing(mesh.faceVertices(3).toArray(), 1),
    );
    expect(mesh.allEdgeFaces(mesh.vertexEdges(7))).toEqual(
      mesh.allEdgeFaces('ccw', mesh.vertexEdges(7).toArray()),
    );
    expect(mesh.allVertexFaces('cw', new Set([4, 2]).values())).toEqual(
      mesh.allVertexFaces('cw', [4, 2]),
    );
    using part = mesh.extract(mesh.vertexFaces(7)).mesh;
    expect(part.faceCount).toBe(4);
    expect(mesh.cutEdges(mesh.vertexEdges(7))).toHaveLength(4);
    const corners = mesh.faceVertices(20).toArray();
    mesh.deleteFace(20, { keepIsolatedVertices: true });
    expect(mesh.addFace(new Set(corners))).toBe(20);
    const refused = { faces: new Set([3, 99]) };
    expect(() => mesh.star(refused)).toThrow('items.faces[1] is 99; expected a face from 0 to 29.');
    expect(() => mesh.extract(new Map([[1, 2]]) as never)).toThrow(
      'faces[0] is an array of 2 elements; expected a face, which is an integer.',
    );
    expect(() => mesh.extract('12' as never)).toThrow('faces is "12"; expected an array of faces.');
  });

  test('say which items there are, of a number that is none of them', () => {
    using mesh = HalfedgeMesh.grid(2, 2);
    const outside = mesh.face(mesh.boundaryLoops()[0]); // NONE
    for (const faces of [[0, outside], Int32Array.of(0, outside), new Set([0, outside])]) {
      expect(() => mesh.extract(faces)).toThrow(
        new RangeError('faces[1] is -1; expected a face from 0 to 3.'),
      );
    }
    expect(() => mesh.allVertexFaces('ccw', [1.5])).toThrow(
      new RangeError('vertices[0] is 1.5; expected a vertex from 0 to 8.'),
    );
    expect(() => mesh.star({ edges: [Number.NaN] })).toThrow(
      new RangeError('items.edges[0] is NaN; expected an edge from 0 to 11.'),
    );
  });

  test('refuse what are no items, and leak nothing', () => {
    using mesh = HalfedgeMesh.cube();
    const before = bytesInUse();
    expect(() => mesh.star(null as never)).toThrow('items is null; expected an object.');
    expect(() => mesh.link({ vertex: [0] } as never)).toThrow(
      new TypeError('items has the name "vertex"; expected vertices, edges or faces.'),
    );
    expect(() => mesh.star({ vertices: [0], face: [1] } as never)).toThrow(
      new TypeError('items has the name "face"; expected vertices, edges or faces.'),
    );
    expect(() => mesh.star({ vertices: 3 as never })).toThrow(
      /^items.vertices is 3; expected an array/,
    );
    expect(() => mesh.link({ edges: [12] })).toThrow(
      new RangeError('items.edges[0] is 12; expected an edge from 0 to 11.'),
    );
    expect(() => mesh.kRing([0, 8], 1)).toThrow('vertices[1] is 8; expected a vertex from 0 to 7.');
    expect(() => mesh.closure({ faces: [-1] })).toThrow(RangeError);
    mesh.connectivity.next[3] = 3;
    mesh.connectivity.toVertex.fill(77);
    expect(() => mesh.closure({ faces: [0, 1, 2, 3, 4, 5] })).toThrow(
      expect.objectContaining({ code: 'corrupt-connectivity' }),
    );
    expect(bytesInUse()).toBe(before);
  });
});
