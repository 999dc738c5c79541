import { HalfedgeMesh, init, NONE } from 'halfedge';
import { expectRefused, facesOf, stateOf } from './support/editing.js';
import { build, oneSquare, quadGrid, tetrahedron, twoTriangles } from './support/meshes.js';

beforeAll(() => init());

describe('addVertex', () => {
  test('adds isolated vertices, where they are wanted, in deleted slots first', () => {
    using mesh = new HalfedgeMesh();
    expect(mesh.addVertex()).toBe(0);
    expect(mesh.addVertex([1, 2, 3])).toBe(1);
    expect(mesh.addVertex(new Float32Array([4, 5, 6]))).toBe(2);
    expect(Array.from(mesh.positions)).toEqual([0, 0, 0, 1, 2, 3, 4, 5, 6]);
    expect(mesh.isIsolatedVertex(2)).toBe(true);
    mesh.deleteVertex(1);
    expect([mesh.vertexCount, mesh.vertexSlots]).toEqual([2, 3]);
    expect(mesh.addVertex([7, 8, 9])).toBe(1);
    expect(mesh.position(1)).toEqual([7, 8, 9]);
  });
});

describe('addFace', () => {
  test('builds a mesh face by face, in any order', () => {
    const { positions, faces } = quadGrid();
    using mesh = new HalfedgeMesh();
    for (let i = 0; i < positions.length; i += 3) mesh.addVertex(positions.slice(i, i + 3));
    const order = [4, 0, 8, 2, 6, 1, 3, 5, 7];
    for (const f of order) expect(mesh.checkAddFace(faces[f])).toBe(null);
    order.forEach((f, i) => void expect(mesh.addFace(faces[f])).toBe(i));
    expect(mesh.faceVertices(0).toArray()).toEqual(faces[4]);
    expect(mesh.validate()).toEqual([]);
    expect(facesOf(mesh)).toEqual(facesOf(build({ positions, faces })));
  });

  test('takes faces of more corners than fit the short list', () => {
    using mesh = new HalfedgeMesh();
    const corners = Array.from({ length: 100 }, (_, i) => mesh.addVertex([i, i * i, 0]));
    expect(mesh.addFace(Uint16Array.from(corners))).toBe(0);
    expect(mesh.faceVertices(0).toArray()).toEqual(corners);
    expectRefused(() => mesh.addFace(corners), 'duplicate-face');
  });

  test('is refused where the result would be no surface', () => {
    using mesh = build(tetrahedron());
    const refusal = expectRefused(() => mesh.addFace([0, 2, 1]), 'duplicate-face');
    expect(refusal.witness.faces).toEqual([0]);
    expect(mesh.checkAddFace([0, 2, 1])).toEqual(refusal);
    const fifth = mesh.addVertex();
    expectRefused(() => mesh.addFace([0, 2, fifth]), 'edge-with-many-faces');
    expectRefused(() => mesh.addFace([0, fifth]), 'degree-below-three');
    expect(mesh.checkAddFace([0, 1, 1])?.witness.vertices).toEqual([1]);
    using disk = build(twoTriangles());
    disk.addVertex();
    expectRefused(() => disk.addFace([0, 1, 4]), 'opposite-orientation');
  });

  test('tells which corner is none', () => {
    using mesh = build(oneSquare());
    for (const name of ['addFace', 'checkAddFace'] as const) {
      expect(() => mesh[name]([0, 1, 9])).toThrow(
        'vertices[2] is 9; expected a vertex from 0 to 3.',
      );
      expect(() => mesh[name]([0, 1.5, 2])).toThrow('vertices[1] is 1.5; expected a vertex');
      expect(() => mesh[name]([0, '1', 2] as never)).toThrow(TypeError);
      expect(() => mesh[name](7 as never)).toThrow('vertices is 7; expected an array of vertices.');
      expect(() => mesh[name]({ length: 2 ** 31 })).toThrow('vertices[0] is undefined');
    }
    mesh.deleteFace(0, { keepIsolatedVertices: true });
    mesh.deleteVertex(2);
    expect(() => mesh.addFace([0, 1, 2])).toThrow('vertices[2] is vertex 2, which was deleted');
  });

  test('takes a long list by index, whatever iterator it has', () => {
    using mesh = HalfedgeMesh.grid(20, 20);
    const indices = Array.from({ length: 100 }, (_, i) => i);
    const list = Object.assign([...indices], { *[Symbol.iterator]() {} });
    expect(mesh.checkAddFace(list)).toEqual(mesh.checkAddFace(indices));
  });

  test('survives a list that changes the mesh while it is read', () => {
    using mesh = build(twoTriangles());
    const list = [1, 0, 0];
    Object.defineProperty(list, 2, {
      get: () => {
        if (!mesh.disposed && mesh.faceCount > 0) mesh.clear();
        return 0;
      },
    });
    expect(() => mesh.addFace(list)).toThrow(RangeError);
    expect(mesh.validate()).toEqual([]);
  });
});

describe('Deletion', () => {
  test('of a face takes what has nothing else, or keeps vertices', () => {
    using mesh = build(twoTriangles());
    mesh.deleteFace(0);
    expect(facesOf(mesh)).toEqual([[0, 2, 3]]);
    expect([mesh.vertexCount, mesh.edgeCount, mesh.faceCount]).toEqual([3, 3, 1]);
    expect(() => mesh.valence(1)).toThrow('v is vertex 1, which was deleted');
    using other = build(twoTriangles());
    other.deleteFace(0, { keepIsolatedVertices: true });
    expect(other.vertexCount).toBe(4);
    expect(other.deleteIsolatedVertices()).toBe(1);
    expect(other.vertexCount).toBe(3);
  });

  test('of an edge and of a vertex takes their faces', () => {
    using mesh = build(quadGrid());
    mesh.deleteEdge(mesh.findEdge(5, 6));
    expect(mesh.faceCount).toBe(7);
    using other = build(quadGrid());
    other.deleteVertex(5);
    expect([other.vertexCount, other.faceCount]).toEqual([12, 5]); // 0, 1 and 4 had no other faces
    expect(mesh.validate().concat(other.validate())).toEqual([]);
  });

  test('is refused where a face lies on both sides of an edge', () => {
    using mesh = new HalfedgeMesh();
    mesh.makeSegment();
    const before = mesh.toBytes();
    for (const name of ['Vertex', 'Edge', 'Face'] as const) {
      expect(mesh[`checkDelete${name}`](0)?.code).toBe('same-loop');
      expect(() => mesh[`delete${name}`](0)).toThrow('lie in the same loop');
    }
    expect(mesh.toBytes()).toEqual(before);
  });

  test('is never refused elsewhere, but of what is deleted already', () => {
    using mesh = build(twoTriangles());
    expect([mesh.checkDeleteVertex(0), mesh.checkDeleteEdge(0), mesh.checkDeleteFace(0)]).toEqual([
      null,
      null,
      null,
    ]);
    mesh.deleteFace(0);
    for (const name of ['deleteFace', 'checkDeleteFace'] as const) {
      expect(() => mesh[name](0)).toThrow('f is face 0, which was deleted; expected a live one.');
    }
    for (const name of ['deleteVertex', 'deleteEdge', 'deleteFace'] as const) {
      const gone = HalfedgeMesh.cube();
      const next: HalfedgeMesh[] = []; // one of them lies where the first one lay
      const disposing = {
        get keepIsolatedVertices() {
          gone.dispose();
          for (let i = 0; i < 8; i++) next.push(HalfedgeMesh.cube());
          return true;
        },
      };
      expect(() => gone[name](0, disposing)).toThrow(/disposed/);
      for (const cube of next) {
        expect([...cube.toPolygons().sizes]).toEqual([4, 4, 4, 4, 4, 4]);
        cube.dispose();
      }
    }
    expect(() => mesh.deleteFace(1, { keepIsolatedVertices: 1 as never })).toThrow(
      'keepIsolatedVertices is 1; expected true or false.',
    );
    expect(() => mesh.deleteFace(1, null as never)).toThrow('options is null');
  });

  test('of components', () => {
    using mesh = build(tetrahedron());
    const islands = [4, 5].map((size) => {
      const corners = Array.from({ length: size }, (_, i) => mesh.addVertex([i, size, 0]));
      return mesh.addFace(corners);
    });
    mesh.addVertex();
    expect(mesh.deleteComponent('face', islands[0])).toBe(1);
    expect(mesh.faceCount).toBe(5);
    expect(mesh.keepLargestComponents()).toBe(1);
    expect([mesh.vertexCount, mesh.faceCount]).toEqual([5, 1]);
    expect(() => mesh.deleteComponent('loop' as never, 0)).toThrow('kind is "loop"');
    expect(() => mesh.keepLargestComponents(-1)).toThrow(
      'count is -1; expected an integer from 0.',
    );
  });
});

describe('compact', () => {
  test('closes the gaps, and says where items went', () => {
    using mesh = build(quadGrid());
    mesh.attributes.add('vertex', 'id').set(Array.from({ length: 16 }, (_, i) => i));
    mesh.deleteVertex(5);
    const before = facesOf(mesh);
    const ends = mesh
      .edges()
      .toArray()
      .map((e) => mesh.edgeVertices(e).toArray());
    const edges = mesh.edges().toArray();
    const maps = mesh.compact();
    expect([mesh.vertexSlots, mesh.edgeSlots, mesh.faceSlots]).toEqual([
      mesh.vertexCount,
      mesh.edgeCount,
      mesh.faceCount,
    ]);
    const { vertices } = maps;
    expect(facesOf(mesh)).toEqual(before.map((face) => face.map((v) => vertices[v])));
    edges.forEach((e, i) => {
      expect(mesh.edgeVertices(maps.edges[e]).toArray()).toEqual(ends[i].map((v) => vertices[v]));
      expect(maps.halfedges[2 * e + 1]).toBe(2 * maps.edges[e] + 1);
    });
    expect(() => mesh.degree(mesh.faceSlots)).toThrow(RangeError);
    expect(() => mesh.valence(mesh.vertexSlots)).toThrow(RangeError);
    expect(() => mesh.toVertex(mesh.halfedgeSlots)).toThrow(RangeError);
    expect([vertices[5], vertices[15], vertices.length]).toEqual([NONE, 11, 16]);
    expect(mesh.attributes.get('vertex', 'id')[11]).toBe(15);
    expect(mesh.validate()).toEqual([]);
  });

  test('can be undone', () => {
    using mesh = build(quadGrid());
    mesh.history.enabled = true;
    mesh.deleteVertex(5);
    const before = stateOf(mesh);
    mesh.compact();
    mesh.history.undo();
    expect(stateOf(mesh)).toEqual(before);
    expect(() => mesh.next(mesh.halfedgeSlots)).toThrow(RangeError);
    mesh.history.redo();
    for (const h of mesh.halfedges()) mesh.next(h);
    expect(() => mesh.next(mesh.halfedgeSlots)).toThrow(RangeError);
    expect(() => mesh.valence(mesh.vertexSlots)).toThrow(RangeError);
    expect(() => mesh.degree(mesh.faceSlots)).toThrow(RangeError);
  });
});

describe('reserve and clear', () => {
  test('room is made ahead, and nothing is seen of it', () => {
    using mesh = build(oneSquare());
    mesh.reserve(1000, 2000, 500);
    const { next, faceHalfedge } = mesh.connectivity;
    expect([next.length, faceHalfedge.length, mesh.positions.length]).toEqual([8, 1, 12]);
    expect(mesh.halfedges().toArray().length).toBe(8);
    for (const read of [() => mesh.next(8), () => mesh.face(9), () => mesh.vertexHalfedge(4)]) {
      expect(read).toThrow(/expected a (halfedge|vertex) from 0 to [73]/);
    }
    expect(() => mesh.faceHalfedge(1)).toThrow('f is 1; expected a face from 0 to 0.');
    expect(() => mesh.isBoundaryEdge(4)).toThrow(RangeError);
    expect(() => mesh.faceVertices(1)).toThrow(RangeError);
    expect(() => mesh.circulate('vertexVertices', 4)).toThrow(RangeError);
    expect(() => mesh.reserve(1, -1, 1)).toThrow('edges is -1; expected an integer from 0.');
    expectRefused(() => mesh.reserve(2 ** 31 - 1, 1, 1), 'out-of-memory');
  });

  test('what moves then is followed by views and attributes', () => {
    using mesh = build(twoTriangles());
    mesh.attributes.add('vertex', 'a');
    const { connectivity, positions } = mesh;
    const ends = connectivity.toVertex.slice();
    mesh.reserve(10_000, 20_000, 10_000);
    expect(mesh.connectivity).not.toBe(connectivity);
    expect(mesh.positions).not.toBe(positions);
    const e = mesh.findEdge(0, 2);
    const view = mesh.attributes.get('vertex', 'a');
    view[3] = 7;
    mesh.positions[0] = 6;
    expect(mesh.connectivity.toVertex).toEqual(ends);
    mesh.flipEdge(e);
    mesh.addVertex();
    expect(mesh.attributes.get('vertex', 'a')[3]).toBe(7);
    expect(mesh.position(0)).toEqual([6, 0, 0]);
    expect([mesh.toVertex(2 * e), mesh.toVertex(2 * e + 1)].sort()).toEqual([1, 3]);
    expect(mesh.connectivity.toVertex[2 * e]).toBe(mesh.toVertex(2 * e));
    expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
  });

  test('clear leaves an empty mesh that can be used', () => {
    using mesh = build(quadGrid());
    mesh.clear();
    expect([mesh.vertexSlots, mesh.halfedgeSlots, mesh.faceSlots]).toEqual([0, 0, 0]);
    expect(() => mesh.next(0)).toThrow(RangeError);
    expect(mesh.addVertex([1, 2, 3])).toBe(0);
    expect(mesh.position(0)).toEqual([1, 2, 3]);
  });
});
