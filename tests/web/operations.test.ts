import { HalfedgeError, HalfedgeMesh, init, NONE } from 'halfedge';
import { growMemory } from './support/core.js';
import { edgesOf, expectRefused, facesOf, stateOf } from './support/editing.js';
import {
  annulus,
  bowTie,
  type Input,
  pillow,
  quadGrid,
  tetrahedron,
  torus,
} from './support/meshes.js';
import { edit } from './support/random-edits.js';

beforeAll(() => init());

const build = ({ positions, faces }: Input, options = {}) =>
  HalfedgeMesh.fromPolygons(positions, faces, options);

/** Two triangles with the edge 0-2 in common. */
const twoTriangles = () => ({
  positions: [0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0],
  faces: [
    [0, 1, 2],
    [0, 2, 3],
  ],
});
const oneSquare = () => ({ positions: twoTriangles().positions, faces: [[0, 1, 2, 3]] });
const octahedron = () => HalfedgeMesh.octahedron();

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

  test('is never refused, but of what is deleted already', () => {
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

describe('flipEdge', () => {
  test('turns the diagonal 0-2 to 1-3', () => {
    using mesh = build(twoTriangles());
    const e = mesh.findEdge(0, 2);
    const h = mesh.findHalfedge(0, 2);
    expect(mesh.checkFlipEdge(e)).toBe(null);
    expect(mesh.flipEdge(e)).toBe(e);
    expect([mesh.fromVertex(h), mesh.toVertex(h)]).toEqual([1, 3]);
    expect(facesOf(mesh)).toEqual([
      [0, 1, 3],
      [1, 2, 3],
    ]);
    for (let i = 0; i < 3; i++) mesh.flipEdge(e);
    expect([mesh.fromVertex(h), mesh.toVertex(h)]).toEqual([0, 2]);
    expect(facesOf(mesh)).toEqual(facesOf(build(twoTriangles())));
  });

  test('is refused with the reason and its witness, of as many edges as OpenMesh refuses', () => {
    const flippable = (mesh: HalfedgeMesh) =>
      mesh
        .edges()
        .toArray()
        .filter((e) => mesh.checkFlipEdge(e) === null).length;
    using disk = build(twoTriangles());
    expect(flippable(disk)).toBe(1);
    const side = disk.findEdge(0, 1);
    const refusal = expectRefused(() => disk.flipEdge(side), 'boundary-edge');
    expect(refusal.witness.edges).toEqual([side]);
    expect(refusal.message).toMatch(/^Edge \d+ lies on the boundary: halfedge \d+ has no face/);
    using closed = build(tetrahedron());
    expect(flippable(closed)).toBe(0);
    expect(closed.checkFlipEdge(0)).toMatchObject({ code: 'edge-exists' });
    using quads = build(torus());
    expectRefused(() => quads.flipEdge(0), 'not-a-triangle');
    using flat = build(pillow());
    expectRefused(() => flat.flipEdge(0), 'same-vertex');
    using eight = octahedron();
    expect(flippable(eight)).toBe(12);
  });
});

describe('splitEdge and insertVertexOnEdge', () => {
  test('cut the triangles beside an edge in two, or leave them as quads', () => {
    using mesh = build(twoTriangles());
    const w = mesh.splitEdge(mesh.findEdge(0, 2));
    expect([w, mesh.position(w), mesh.valence(w), mesh.faceCount]).toEqual([4, [1, 1, 0], 4, 4]);
    expect(edgesOf(mesh)).toEqual(['0-1', '0-3', '0-4', '1-2', '1-4', '2-3', '2-4', '3-4']);
    using other = build(twoTriangles());
    const v = other.insertVertexOnEdge(other.findEdge(0, 2), [1, 1, 5]);
    expect([other.position(v), other.valence(v), other.faceCount]).toEqual([[1, 1, 5], 2, 2]);
    const e = other.removeVertexOnEdge(v);
    expect(other.edgeVertices(e).toArray().sort()).toEqual([0, 2]);
    expect(edgesOf(other)).toEqual(edgesOf(build(twoTriangles())));
    expect(mesh.collapse(mesh.findHalfedge(w, 0))).toBe(0);
    expect(edgesOf(mesh)).toEqual(edgesOf(build(twoTriangles())));
  });

  test('are refused, or their inverse is, where two edges would join the same vertices', () => {
    using mesh = build(pillow());
    expectRefused(() => mesh.splitEdge(0), 'same-vertex');
    expect(mesh.checkInsertVertexOnEdge(0)).toBe(null);
    using disk = build(twoTriangles());
    const refusal = expectRefused(() => disk.removeVertexOnEdge(0), 'not-valence-two');
    expect(refusal.witness.vertices).toEqual([0]);
    expectRefused(() => disk.removeVertexOnEdge(1), 'degree-below-three');
  });
});

describe('collapse and splitVertex', () => {
  test('undo each other', () => {
    using mesh = octahedron();
    const before = edgesOf(mesh);
    const h = mesh.edgeHalfedge(0);
    const [a, b] = [mesh.fromVertex(h), mesh.toVertex(h)];
    const [hl, hr] = [mesh.next(h), mesh.opposite(mesh.prev(mesh.opposite(h)))];
    const position = mesh.position(b);
    expect(mesh.collapse(h)).toBe(b);
    expect([mesh.vertexCount, mesh.edgeCount, mesh.faceCount]).toEqual([5, 9, 6]);
    expect(mesh.position(b)).toEqual(position);
    const w = mesh.splitVertex(hl, hr, [9, 9, 9]);
    expect(mesh.position(w)).toEqual([9, 9, 9]);
    expect(w).toBe(a);
    expect(edgesOf(mesh)).toEqual(before);
    expect(mesh.validate()).toEqual([]);
  });

  test('collapse moves the vertex to a position', () => {
    using mesh = octahedron();
    const v = mesh.collapse(0, [1, 2, 3]);
    expect(mesh.position(v)).toEqual([1, 2, 3]);
  });

  const collapsible = (mesh: HalfedgeMesh, options = {}) =>
    mesh
      .halfedges()
      .toArray()
      .filter((h) => mesh.checkCollapse(h, undefined, options) === null).length;

  test.each([
    ['octahedron', octahedron, 24, 24],
    ['two triangles', () => build(twoTriangles()), 8, 8],
    [
      'single triangle',
      () => HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]),
      0,
      0,
    ],
    ['pillow', () => build(pillow()), 0, 0],
    ['bow-tie', () => build(bowTie()), 0, 0],
    ['tetrahedron', () => build(tetrahedron()), 0, 12],
  ])('halfedges of a %s that can be collapsed', (_, make, strict, permissive) => {
    using mesh = make();
    expect(collapsible(mesh)).toBe(strict);
    expect(collapsible(mesh, { permissive: true })).toBe(permissive);
    if (permissive > strict) mesh.collapse(0, undefined, { permissive: true });
    expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
  });

  test('refusals name what is in the way', () => {
    using mesh = build(tetrahedron());
    const refusal = expectRefused(() => mesh.collapse(0), 'leaves-pillow');
    expect(refusal.witness.faces.length).toBe(2);
    using disk = build(twoTriangles());
    expectRefused(() => disk.collapse(disk.findHalfedge(0, 2)), 'boundary-vertices');
    using eight = octahedron();
    const h = eight.vertexHalfedge(0);
    expectRefused(() => eight.splitVertex(h, h), 'same-vertex');
    expectRefused(() => eight.splitVertex(h, eight.next(h)), 'different-vertices');
    expect(eight.checkSplitVertex(h, h, undefined, { left: 'corner' })).toBe(null);
    expect(() => eight.splitVertex(h, h, undefined, { right: 'hole' as never })).toThrow(
      "right is \"hole\"; expected 'triangle' or 'corner'.",
    );
    expect(() => eight.collapse(h, undefined, { permissive: 'yes' as never })).toThrow(TypeError);
  });
});

describe('Faces', () => {
  test('are cut by an edge and joined again', () => {
    using mesh = build(oneSquare());
    const [h, g] = [mesh.findHalfedge(3, 0), mesh.findHalfedge(1, 2)];
    expect(mesh.checkInsertEdge(h, g)).toBe(null);
    const e = mesh.insertEdge(h, g);
    expect(mesh.edgeVertices(e).toArray().sort()).toEqual([0, 2]);
    expect(facesOf(mesh)).toEqual(facesOf(build(twoTriangles())));
    expectRefused(() => mesh.insertEdge(h, g), 'different-loops');
    expect(mesh.removeEdge(e)).toBe(0);
    expect(facesOf(mesh)).toEqual([[0, 1, 2, 3]]);
    expectRefused(() => mesh.insertEdge(h, h), 'same-corner');
    expectRefused(() => mesh.insertEdge(h, mesh.next(h)), 'adjacent-corners');
  });

  test('that lose an edge on the boundary are gone', () => {
    using mesh = build(quadGrid());
    expect(mesh.removeEdge(mesh.findEdge(1, 2))).toBe(NONE);
    expect(mesh.faceCount).toBe(8);
    expectRefused(() => mesh.removeEdge(mesh.findEdge(0, 4)), 'edge-without-face');
  });

  test('get a centre, which can be dissolved', () => {
    using mesh = build(oneSquare());
    const c = mesh.splitFace(0);
    expect([mesh.position(c), mesh.valence(c), mesh.faceCount]).toEqual([[1, 1, 0], 4, 4]);
    expect(mesh.dissolveVertex(c)).toBeGreaterThanOrEqual(0);
    expect(facesOf(mesh)).toEqual([[0, 1, 2, 3]]);
    mesh.addVertex();
    expectRefused(() => mesh.dissolveVertex(4), 'isolated-vertex');
  });

  test('are dissolved into one', () => {
    using mesh = build(quadGrid());
    const f = mesh.dissolveEdge(mesh.findEdge(5, 6));
    expect(mesh.degree(f)).toBe(6);
    expectRefused(() => mesh.dissolveEdge(mesh.findEdge(0, 1)), 'boundary-edge');
  });

  test('become holes that are filled', () => {
    using mesh = build(torus());
    const h = mesh.makeHole(3);
    expect([mesh.faceCount, mesh.boundaryLoops().length]).toEqual([19, 1]);
    expect(mesh.fillHole(h)).toBe(3);
    expect(facesOf(mesh)).toEqual(facesOf(build(torus())));
    expectRefused(() => mesh.fillHole(0), 'not-a-boundary-halfedge');
    using disk = build(twoTriangles());
    expectRefused(() => disk.makeHole(0), 'edge-without-face');
    expect(disk.connectivity.faceHalfedge.length).toBe(2);
    expect(disk.fillHole(disk.boundaryLoops()[0])).toBe(2);
    expect(disk.connectivity.faceHalfedge.length).toBe(3);
  });

  test('are cut into triangles', () => {
    using mesh = build(quadGrid());
    expect(mesh.triangulate(4)).toBe(1);
    expect(mesh.triangulate()).toBe(8);
    expect(
      mesh
        .faces()
        .toArray()
        .map((f) => mesh.degree(f)),
    ).toEqual(new Array(18).fill(3));
    expect(mesh.checkTriangulate()).toBe(null);
    expect(mesh.checkTriangulate(3)).toBe(null);
    expect(() => mesh.triangulate(99)).toThrow('f is 99; expected a face from 0 to 17.');
  });

  test('are extruded and inset', () => {
    using mesh = build(torus());
    expect(mesh.extrudeFace(0, 2)).toBe(0);
    expect([mesh.faceCount, mesh.degree(0)]).toEqual([24, 4]);
    expect(mesh.insetFace(1, 0.5)).toBe(1);
    expect(mesh.faceCount).toBe(28);
    expect(mesh.validate()).toEqual([]);
    expectRefused(() => mesh.insetFace(0, 2), 'out-of-range');
    expect(() => mesh.extrudeFace(0, Number.NaN)).toThrow(
      'offset is NaN; expected a finite number.',
    );
    expect(() => mesh.checkInsetFace(0, '1' as never)).toThrow(TypeError);
    const c = mesh.poke(0, 0.5);
    expect(mesh.valence(c)).toBe(4);
    using flat = new HalfedgeMesh();
    for (let i = 0; i < 3; i++) flat.addVertex();
    flat.addFace([0, 1, 2]);
    expectRefused(() => flat.extrudeFace(0, 1), 'degenerate-face');
  });
});

describe('Bevels', () => {
  test('of an edge and a vertex', () => {
    using mesh = octahedron();
    const f = mesh.bevelVertex(0, 0.25);
    expect([mesh.degree(f), mesh.vertexCount, mesh.faceCount]).toEqual([4, 9, 9]);
    using other = octahedron();
    const g = other.bevelEdge(0, 0.25);
    expect([other.degree(g), other.vertexCount, other.faceCount]).toEqual([4, 8, 9]);
    expect(mesh.validate().concat(other.validate())).toEqual([]);
    expectRefused(() => mesh.bevelVertex(0, -1), 'out-of-range');
    using disk = build(twoTriangles());
    expectRefused(() => disk.bevelEdge(disk.findEdge(0, 1), 0.5), 'boundary-edge');
    expectRefused(() => disk.bevelVertex(1, 0.5), 'valence-below-three');
  });
});

describe('Gluing and cutting', () => {
  test('an edge is cut up to the boundary and glued again', () => {
    using mesh = build(quadGrid());
    const h = mesh.findHalfedge(1, 5);
    const before = edgesOf(mesh);
    const g = mesh.cut(h);
    expect([mesh.vertexCount, mesh.edgeCount]).toEqual([17, 25]);
    expect(mesh.glue(mesh.opposite(h), g)).toBe(mesh.edge(h));
    expect(edgesOf(mesh)).toEqual(before);
    expectRefused(() => mesh.cut(mesh.findHalfedge(5, 6)), 'no-boundary-end');
    expectRefused(() => mesh.glue(h, mesh.next(h)), 'not-a-boundary-halfedge');
  });

  test('a path leaves a slit', () => {
    using mesh = build(torus());
    const path = [mesh.findHalfedge(0, 1), mesh.findHalfedge(1, 2)];
    expect(mesh.checkCutPath(path)).toBe(null);
    const last = mesh.cutPath(path);
    expect(mesh.boundaryLoops().length).toBe(1);
    expect(mesh.halfedgeLoop(last).toArray().length).toBe(4);
    mesh.gluePath(mesh.opposite(path[1]), last, 2);
    expect(facesOf(mesh)).toEqual(facesOf(build(torus())));
    expectRefused(() => mesh.cutPath([path[0], path[0]]), 'not-a-path');
    expectRefused(() => mesh.cutPath([]), 'not-a-path');
    expect(() => mesh.cutPath([path[0], 99_999])).toThrow('path[1] is 99999; expected a halfedge');
    expect(() => mesh.gluePath(0, 1, 0)).toThrow('count is 0; expected an integer from 1.');
  });

  test('a cycle around a handle is cut and closed, and joined', () => {
    using mesh = build(torus());
    const cycle = Array.from({ length: 5 }, (_, i) => mesh.findHalfedge(i, (i + 1) % 5));
    const h = mesh.splitLoop(cycle);
    expect([mesh.genus(), mesh.faceCount]).toEqual([0, 22]);
    expect(mesh.joinLoop(cycle[0], h)).toBe(cycle[0]);
    expect(mesh.genus()).toBe(1);
    expect(facesOf(mesh)).toEqual(facesOf(build(torus())));
    expectRefused(() => mesh.splitLoop([cycle[0], cycle[2]]), 'not-a-cycle');
    expectRefused(() => mesh.joinLoop(0, mesh.next(0)), 'same-loop');
  });

  test('a tube joins two faces, and is taken out', () => {
    using mesh = build(quadGrid(6, 3));
    const [h, g] = [mesh.faceHalfedge(0), mesh.faceHalfedge(9)];
    const s = mesh.bridge(h, g);
    expect([mesh.genus(), mesh.faceCount, mesh.validate()]).toEqual([1, 12, []]);
    expect(mesh.removeBridge(s)).toBe(h);
    expect(mesh.genus()).toBe(0);
    expectRefused(() => mesh.removeBridge(mesh.findHalfedge(0, 1)), 'boundary-edge');
    expectRefused(() => mesh.bridge(h, mesh.boundaryLoops()[0]), 'different-degrees');
  });

  test('orientation is reversed as a whole and by component', () => {
    using mesh = build(twoTriangles());
    const before = stateOf(mesh);
    mesh.reverse();
    expect(facesOf(mesh)).toEqual([
      [0, 2, 1],
      [0, 3, 2],
    ]);
    mesh.reverse();
    expect(stateOf(mesh)).toEqual(before);
    expect(mesh.reverseComponent(0)).toBe(5);
    expect(facesOf(mesh)[0]).toEqual([0, 2, 1]);
  });
});

describe('Whatever the operation', () => {
  /** Each with arguments that it accepts on a mesh with these items: their kinds, and what follows. */
  const operations: Record<string, [kinds: string, ...more: unknown[]]> = {
    setPosition: ['v', [0, 0, 0]],
    deleteVertex: ['v'],
    deleteEdge: ['e'],
    deleteFace: ['f'],
    flipEdge: ['e'],
    splitEdge: ['e'],
    insertVertexOnEdge: ['e'],
    removeVertexOnEdge: ['v'],
    collapse: ['h'],
    splitVertex: ['hh'],
    insertEdge: ['hh'],
    removeEdge: ['e'],
    dissolveEdge: ['e'],
    splitFace: ['f'],
    dissolveVertex: ['v'],
    makeHole: ['f'],
    fillHole: ['h'],
    glue: ['hh'],
    gluePath: ['hh', 1],
    cut: ['h'],
    joinLoop: ['hh'],
    bridge: ['hh'],
    removeBridge: ['h'],
    reverseComponent: ['h'],
    triangulate: ['f'],
    extrudeFace: ['f', 1],
    poke: ['f'],
    insetFace: ['f', 0.5],
    bevelEdge: ['e', 0.5],
    bevelVertex: ['v', 0.5],
  };

  test.each(Object.entries(operations))('%s refuses wrong items, as its check does', (name, of) => {
    const [kinds, ...more] = of;
    using mesh = build(quadGrid());
    mesh.deleteVertex(15); // face 8, edges, and their halfedges
    const deleted = { v: 15, e: 23, h: 46, f: 8 };
    const slots = { v: 16, e: 24, h: 48, f: 9 };
    expect(mesh.edgeSlots).toBe(24);
    const before = stateOf(mesh);
    for (let i = 0; i < kinds.length; i++) {
      const kind = kinds[i] as keyof typeof slots;
      const bad: [unknown, ErrorConstructor, RegExp][] = [
        [-1, RangeError, /is -1; expected an? \w+ from 0 to \d+\.$/],
        [slots[kind], RangeError, /; expected an? \w+ from 0 to \d+\.$/],
        [0.5, RangeError, /is 0\.5/],
        [Number.NaN, RangeError, /is NaN/],
        [2 ** 32, RangeError, /is 4294967296/],
        ['0', TypeError, /is "0"; expected an? \w+, which is an integer\.$/],
        [undefined, TypeError, /is undefined/],
        [deleted[kind], RangeError, /which was deleted; expected a live one\.$/],
      ];
      for (const [value, type, message] of bad) {
        if (name === 'triangulate' && value === undefined) continue; // all faces
        const list = Array.from(kinds, (_, j) => (j === i ? value : 0));
        const { run, check } = edit(mesh, name, [...list, ...more]);
        for (const call of check ? [run, check] : [run]) {
          expect(call).toThrow(type);
          expect(call).toThrow(message);
        }
      }
    }
    expect(stateOf(mesh)).toEqual(before);
  });

  const positioned = ['addVertex', 'splitEdge', 'insertVertexOnEdge', 'splitFace', 'collapse'];

  test.each([...positioned, 'setPosition'])('%s refuses what is no position', (name) => {
    using mesh = octahedron();
    const before = stateOf(mesh);
    const bad: [unknown, ErrorConstructor, string][] = [
      [[0, Number.NaN, 0], RangeError, 'position[1] is NaN; expected a finite number'],
      [[Number.POSITIVE_INFINITY, 0, 0], RangeError, 'position[0] is Infinity'],
      [[0, 0, 1e39], RangeError, 'position[2] is 1e+39; expected a finite number that fits'],
      [[0, 0], RangeError, 'position is an array of 2 elements; expected three numbers'],
      [[0, 0, '0'], TypeError, 'position[2] is "0"'],
      [{ x: 1 }, TypeError, 'position is an Object; expected three numbers, x, y and z.'],
      [null, TypeError, 'position is null'],
    ];
    for (const [position, type, message] of bad) {
      const list = name === 'addVertex' ? [position] : [0, position];
      const { run, check } = edit(mesh, name, list);
      for (const call of check ? [run, check] : [run]) {
        expect(call).toThrow(type);
        expect(call).toThrow(message);
      }
    }
    expect(stateOf(mesh)).toEqual(before);
  });

  test('circulators, orbits and lists of items that it has ended say so', () => {
    using mesh = octahedron();
    const ring = mesh.vertexVertices(0);
    const lap = ring[Symbol.iterator]();
    lap.next();
    const circulator = mesh.circulate('vertexFaces', 0);
    const items = mesh.edges();
    mesh.flipEdge(0);
    for (const use of [
      () => lap.next(),
      () => [...ring],
      () => ring.toArray(),
      () => ring.into(new Int32Array(9)),
      () => circulator.next(),
      () => circulator.current,
      () => [...items],
    ]) {
      expect(use).toThrow(HalfedgeError);
      expect(use).toThrow('after the connectivity changed');
    }
    expect(circulator.moveTo(0).current).toBeGreaterThanOrEqual(0);
    mesh.checkFlipEdge(0); // a check ends nothing
    circulator.next();
    expect(() => {
      for (const e of mesh.edges()) mesh.splitEdge(e);
    }).toThrow('after the connectivity changed');
  });

  test('views go on showing the mesh until there are more slots', () => {
    using mesh = octahedron();
    const { connectivity, positions, version } = mesh;
    mesh.flipEdge(0);
    expect(mesh.version).toBeGreaterThan(version);
    expect(mesh.connectivity).toBe(connectivity);
    expect(connectivity.toVertex[0]).toBe(mesh.toVertex(0));
    mesh.splitEdge(0);
    const { connectivity: longer, positions: more } = mesh;
    expect(longer).not.toBe(connectivity);
    expect(more).not.toBe(positions);
    expect([longer.next.length, longer.vertexHalfedge.length, longer.faceHalfedge.length]).toEqual([
      mesh.halfedgeSlots,
      mesh.vertexSlots,
      mesh.faceSlots,
    ]);
    expect(more.length).toBe(3 * mesh.vertexSlots);
    expect(mesh.connectivity).toBe(longer);
    const slots = () => [mesh.vertexSlots, mesh.halfedgeSlots, mesh.faceSlots];
    const lengths = ({ next, vertexHalfedge, faceHalfedge } = mesh.connectivity) => [
      vertexHalfedge.length,
      next.length,
      faceHalfedge.length,
    ];
    const v = mesh.addVertex(); // vertices alone
    expect(lengths()).toEqual(slots());
    mesh.deleteVertex(v);
    mesh.insertVertexOnEdge(0); // edges alone: the vertex takes that slot
    expect(lengths()).toEqual(slots());
    mesh.insertEdge(mesh.next(0), mesh.prev(0)); // edges and faces
    expect(lengths()).toEqual(slots());
    growMemory();
    expect(longer.next.length).toBe(0);
    mesh.splitEdge(1);
    expect(mesh.connectivity.next.length).toBe(mesh.halfedgeSlots);
    for (const h of mesh.halfedges()) expect(mesh.prev(mesh.next(h))).toBe(h);
    expect(mesh.validate()).toEqual([]);
  });

  test('a clone has it all and goes its own way', () => {
    using mesh = octahedron();
    for (let i = 0; i < 20; i++) mesh.splitEdge(i);
    mesh.deleteVertex(0);
    using copy = mesh.clone();
    expect(stateOf(copy)).toEqual(stateOf(mesh));
    const before = stateOf(mesh);
    copy.splitFace(copy.faces().toArray()[0]);
    expect(stateOf(mesh)).toEqual(before);
    expect(copy.allVertexVertices().offsets.length).toBe(copy.vertexSlots + 1);
  });

  test('a mesh of two annuli stays one of each kind of storage', () => {
    for (const storePrev of [true, false]) {
      using mesh = build(annulus(), { storePrev });
      const e = mesh.findEdge(0, 1);
      const w = mesh.splitEdge(e);
      expect(mesh.connectivity.prev.length).toBe(storePrev ? mesh.halfedgeSlots : 0);
      for (const h of mesh.vertexOutgoingHalfedges(w)) expect(mesh.next(mesh.prev(h))).toBe(h);
      expect(mesh.validate()).toEqual([]);
    }
  });
});
