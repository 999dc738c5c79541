import { HalfedgeMesh, init, NONE } from 'halfedge';
import { edgesOf, expectRefused, facesOf, stateOf } from './support/editing.js';
import {
  bowTie,
  build,
  oneSquare,
  pillow,
  quadGrid,
  tetrahedron,
  torus,
  twoTriangles,
} from './support/meshes.js';

beforeAll(() => init());

const octahedron = () => HalfedgeMesh.octahedron();

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

  test.each([
    ['an open grid', () => HalfedgeMesh.grid(3, 3, { triangles: true })],
    ['a cube', () => HalfedgeMesh.cube()],
    ['two triangles', () => HalfedgeMesh.grid(1, 1, { triangles: true })],
    ['an octahedron', () => HalfedgeMesh.octahedron()],
    ['open quads', () => HalfedgeMesh.grid(3, 2)],
  ])('splitVertex takes back every collapse of %s, told what has vanished', (_, make) => {
    using mesh = make();
    const sidesOf = (h: number) => {
      const isTriangle = (side: number) =>
        !mesh.isBoundaryHalfedge(side) && mesh.degree(mesh.face(side)) === 3;
      return {
        left: isTriangle(h) ? 'triangle' : 'corner',
        right: isTriangle(h ^ 1) ? 'triangle' : 'corner',
      } as const;
    };
    /** Corners of faces, by position: the vertex may come back with another number. */
    const facesOf = (it: HalfedgeMesh) =>
      [...it.faces()]
        .map((f) => {
          const corners = [...it.faceVertices(f)].map((v) => it.position(v).join(' '));
          const first = corners.indexOf([...corners].sort()[0]);
          return [...corners.slice(first), ...corners.slice(0, first)].join(', ');
        })
        .sort();
    const before = facesOf(mesh);
    let tried = 0;
    for (const h of mesh.halfedges().toArray()) {
      using copy = mesh.clone();
      if (copy.checkCollapse(h) !== null) continue;
      const position = copy.position(copy.fromVertex(h));
      const [hl, hr] = [copy.next(h), copy.opposite(copy.prev(copy.opposite(h)))];
      const sides = sidesOf(h);
      copy.collapse(h);
      copy.splitVertex(hl, hr, position, sides);
      expect(facesOf(copy)).toEqual(before);
      expect(copy.validate()).toEqual([]);
      tried++;
    }
    expect(tried).toBeGreaterThan(0);
  });

  test('refusals name what is in the way', () => {
    using mesh = build(tetrahedron());
    const refusal = expectRefused(() => mesh.collapse(0), 'leaves-pillow');
    expect(refusal.witness.faces.length).toBe(2);
    using disk = build(twoTriangles());
    expectRefused(() => disk.collapse(disk.findHalfedge(0, 2)), 'boundary-vertices');
    using eight = octahedron();
    const h = eight.vertexHalfedge(0);
    const twice = expectRefused(() => eight.splitVertex(h, h), 'same-vertex');
    expect(twice.message).toContain(`Halfedge ${h} is given for both sides`);
    expect(twice.witness).toMatchObject({
      vertices: [eight.toVertex(h)],
      halfedges: [h],
      edges: [],
    });
    expect(() => eight.checkDeleteVertex(0, { keepIsolated: true } as never)).toThrow(TypeError);
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
    for (const offsetBy of [
      (far: number) => mesh.extrudeFace(0, far),
      (far: number) => mesh.checkExtrudeFace(0, far),
      (far: number) => mesh.poke(0, far),
      (far: number) => mesh.checkPoke(0, far),
    ]) {
      expect(() => offsetBy(1e39)).toThrow(
        new RangeError('offset is 1e+39; expected a number that fits a 32-bit float.'),
      );
    }
    const refusal = mesh.checkExtrudeFace(0, 3.4e38) ?? mesh.extrudeFace(0, 3.4e38);
    expect(refusal).toBe(0);
    expectRefused(() => mesh.extrudeFace(0, 3.4e38), 'not-finite');
    expect(mesh.checkPoke(0, 3.4e38)).toMatchObject({
      code: 'not-finite',
      witness: { faces: [0] },
    });
    expect(mesh.extrudeFace(0, -3.4e38)).toBe(0);
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

  /** `mesh` after its vertex 0 was cut off, and the sides towards it collapsed one after the other. */
  function bevelledAndBack(mesh: HalfedgeMesh, vertexCount: number): HalfedgeMesh {
    const sides = mesh.faceEdges(mesh.bevelVertex(0, 0.25)).toArray();
    while (mesh.vertexCount > vertexCount) {
      const ends = sides.flatMap((e) =>
        mesh.isLiveEdge(e) ? mesh.edgeHalfedges(e).toArray() : [],
      );
      mesh.collapse(ends.find((h) => mesh.toVertex(h) === 0) ?? NONE);
    }
    return mesh;
  }

  test('of a vertex is undone by collapses, but at a pinched vertex only by undo', () => {
    using mesh = octahedron();
    using corner = HalfedgeMesh.grid(3, 3, { triangles: true });
    for (const m of [mesh, corner]) {
      const before = facesOf(m);
      expect(facesOf(bevelledAndBack(m, m.vertexCount))).toEqual(before);
    }
    using pinched = HalfedgeMesh.fromFaces([
      [0, 1, 2],
      [0, 3, 4],
    ]);
    expectRefused(() => bevelledAndBack(pinched, 5), 'boundary-vertices');
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

  test('a tree of edges leaves one slit, whatever their order', () => {
    using mesh = build(quadGrid(5, 5));
    mesh.history.enabled = true;
    const before = stateOf(mesh);
    const ends = [
      [12, 17],
      [11, 12],
      [12, 13],
    ];
    const edges = ends.map(([a, b]) => mesh.findEdge(a, b));
    expect(mesh.checkCutEdges(edges)).toBe(null);
    expect(stateOf(mesh)).toEqual(before);
    const copies = mesh.cutEdges(edges);
    expect([mesh.vertexCount, mesh.edgeCount]).toEqual([27, 43]);
    expect(mesh.validate()).toEqual([]);
    expect(new Set(mesh.halfedgeLoop(copies[0]))).toEqual(
      new Set([...copies, ...edges.map((e) => mesh.opposite(mesh.edgeHalfedge(e)))]),
    );
    for (const [i, e] of edges.entries()) {
      const h = mesh.edgeHalfedge(e);
      expect(mesh.isBoundaryHalfedge(copies[i])).toBe(true);
      expect(mesh.position(mesh.toVertex(copies[i]))).toEqual(mesh.position(mesh.toVertex(h)));
      expect(mesh.position(mesh.fromVertex(copies[i]))).toEqual(mesh.position(mesh.fromVertex(h)));
    }
    const after = stateOf(mesh);
    mesh.history.undo();
    expect(stateOf(mesh)).toEqual(before);
    expect(mesh.history.canUndo).toBe(false);
    expect(mesh.cutEdges(Int32Array.from(edges).reverse())).toEqual([...copies].reverse());
    expect(stateOf(mesh)).toEqual(after);
  });

  test('a long list of edges takes all faces apart', () => {
    using mesh = HalfedgeMesh.torus(20, 20);
    const edges = mesh.edges().toArray();
    const copies = mesh.cutEdges(edges);
    expect(copies.length).toBe(800);
    expect(copies.every((g) => mesh.isBoundaryHalfedge(g))).toBe(true);
    expect(mesh.components().length).toBe(400);
    const across = edges.map((e) => mesh.face(mesh.opposite(mesh.edgeHalfedge(e))));
    expect(across).toEqual(edges.map(() => NONE));
    expect(new Set(copies.map((g) => mesh.edge(g))).size).toBe(800);
    expect(mesh.validate()).toEqual([]);
  });

  test('a closed surface is cut to a disk', () => {
    using mesh = build(torus());
    // As docs/editing.md does.
    const crossed = new Set<number>();
    const reached = new Set<number>(mesh.faces().toArray().slice(0, 1));
    for (const f of reached) {
      for (const h of mesh.faceHalfedges(f)) {
        const g = mesh.face(mesh.opposite(h));
        if (g === NONE || reached.has(g)) continue;
        reached.add(g);
        crossed.add(mesh.edge(h));
      }
    }
    const inner = mesh.edges().toArray();
    const seam = new Set(inner.filter((e) => !crossed.has(e) && !mesh.isBoundaryEdge(e)));
    using net = mesh.clone();
    net.cutEdges(seam);
    const queue: number[] = mesh.vertices().toArray();
    for (const v of queue) {
      const atVertex = mesh
        .vertexEdges(v)
        .toArray()
        .filter((e) => seam.has(e));
      if (atVertex.length !== 1) continue;
      seam.delete(atVertex[0]);
      queue.push(...mesh.edgeVertices(atVertex[0]));
    }
    const { vertexCount } = mesh;
    expect(mesh.cutEdges(seam).length).toBe(seam.size);
    for (const disk of [net, mesh]) {
      expect([disk.eulerCharacteristic(), disk.boundaryLoops().length]).toEqual([1, 1]);
      expect(disk.validate()).toEqual([]);
    }
    // A graph with one vertex less than edges has become a boundary with two vertices for each edge.
    expect(mesh.vertexCount).toBe(vertexCount + seam.size + 1);
    expect(net.vertexCount).toBeGreaterThan(mesh.vertexCount);
  });

  test('lists of edges that are refused', () => {
    using mesh = build(quadGrid(5, 5));
    const before = stateOf(mesh);
    const [a, b, c] = [mesh.findEdge(6, 7), mesh.findEdge(7, 8), mesh.findEdge(16, 17)];
    expectRefused(() => mesh.cutEdges([a, b, a]), 'repeated-edge');
    expectRefused(() => mesh.cutEdges([a, b, c]), 'no-boundary-end');
    expectRefused(() => mesh.cutEdges([a, b, mesh.findEdge(0, 1)]), 'boundary-edge');
    expect(mesh.checkCutEdges([c])?.witness.edges).toEqual([c]);
    expect(mesh.checkCutEdges([c])?.message).toBe(
      `Edge ${c} would become two edges between vertex 16 and vertex 17, which are both inside, expected an end on the boundary, or at another edge of the list.`,
    );
    for (const call of ['cutEdges', 'checkCutEdges'] as const) {
      expect(() => mesh[call]([a, 99_999])).toThrow('edges[1] is 99999; expected an edge from 0');
      expect(() => mesh[call]([0.5])).toThrow(RangeError);
      expect(() => mesh[call](['1' as never])).toThrow(TypeError);
      expect(() => mesh[call](5 as never)).toThrow('edges is 5; expected an array of edges');
    }
    const slots = mesh.edgeSlots; // a halfedge has this number, but no edge
    expect(() => mesh.cutEdges([a, slots])).toThrow(
      `edges[1] is ${slots}; expected an edge from 0`,
    );
    expect(mesh.cutEdges([])).toEqual([]);
    expect(stateOf(mesh)).toEqual(before);
    mesh.removeEdge(a);
    expect(() => mesh.cutEdges([b, a])).toThrow(`edges[1] is edge ${a}, which was deleted`);
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
