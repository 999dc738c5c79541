import { type CompactMaps, HalfedgeMesh, type ItemKind, init, NONE } from 'halfedge';
import { bytesInUse, withLeft } from './support/core.js';
import { addAttributes, expectState, stateOf } from './support/editing.js';
import { quadGrid, randomPolygons } from './support/meshes.js';
import { random } from './support/random.js';

beforeAll(() => init());

const KINDS = { vertex: 'vertices', halfedge: 'halfedges', edge: 'edges', face: 'faces' } as const;

/** A mesh with gaps, attributes of all kinds, and positions that say nothing of the order. */
function scattered(seed: number): HalfedgeMesh {
  const next = random(seed);
  const { positions, faces } = randomPolygons(seed);
  const mesh = HalfedgeMesh.fromPolygons(positions, faces);
  mesh.positions.forEach((_, i, all) => {
    all[i] = 1000 * next();
  });
  for (const f of mesh.faces().toArray()) if (next() < 0.2) mesh.deleteFace(f);
  addAttributes(mesh, next);
  return mesh;
}

/** That `mesh` is `before`, whose items are where the maps say. */
function expectSameMesh(mesh: HalfedgeMesh, before: HalfedgeMesh, maps: CompactMaps): void {
  expect([mesh.vertexSlots, mesh.edgeSlots, mesh.faceSlots]).toEqual([
    before.vertexCount,
    before.edgeCount,
    before.faceCount,
  ]);
  expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
  const { vertices, halfedges, edges, faces } = maps;
  for (const [kind, map] of Object.entries(maps)) {
    const live = new Set<number>(before[kind as keyof CompactMaps]());
    const gone = [...map.keys()].filter((item) => !live.has(item));
    expect(gone.map((item) => map[item])).toEqual(gone.map(() => NONE));
  }
  const linksOf = (m: HalfedgeMesh, h: number) => [m.next(h), m.prev(h)];
  for (const h of before.halfedges()) {
    const to = halfedges[h];
    expect(linksOf(mesh, to)).toEqual(linksOf(before, h).map((other) => halfedges[other]));
    expect(mesh.toVertex(to)).toBe(vertices[before.toVertex(h)]);
    expect(mesh.face(to)).toBe(before.isBoundaryHalfedge(h) ? NONE : faces[before.face(h)]);
    expect(mesh.edge(to)).toBe(edges[before.edge(h)]);
  }
  for (const v of before.vertices()) {
    const anchor = before.vertexHalfedge(v);
    expect(mesh.vertexHalfedge(vertices[v])).toBe(anchor === NONE ? NONE : halfedges[anchor]);
    const place = (m: HalfedgeMesh, w: number) => m.positions.slice(3 * w, 3 * w + 3);
    expect(place(mesh, vertices[v])).toEqual(place(before, v));
  }
  for (const { kind, name, components } of before.attributes.list()) {
    const now = mesh.attributes.get(kind, name);
    const was = before.attributes.get(kind, name);
    for (const item of itemsOf(before, kind)) {
      const to = components * maps[KINDS[kind]][item];
      const from = components * item;
      expect(now.slice(to, to + components)).toEqual(was.slice(from, from + components));
    }
  }
}

const itemsOf = (mesh: HalfedgeMesh, kind: ItemKind): number[] => mesh[KINDS[kind]]().toArray();

/** How far it is in memory from a halfedge to the next one, on average. */
function meanStep(mesh: HalfedgeMesh): number {
  const { next } = mesh.connectivity;
  return next.reduce((sum, n, h) => sum + Math.abs(n - h), 0) / next.length;
}

describe('reorder', () => {
  test.each(['morton', 'breadth-first'] as const)('%s leaves the same mesh', (order) => {
    for (let seed = 0; seed < 12; seed++) {
      using mesh = scattered(seed);
      using before = mesh.clone();
      expectSameMesh(mesh, before, mesh.reorder(order));
    }
  });

  test('brings together what is close together', () => {
    const { positions, faces } = quadGrid(60, 60);
    const next = random(3);
    const sorted = [...positions.keys()].filter((i) => i % 3 === 0).map((i) => i / 3);
    const names = sorted.map((v) => ({ v, key: next() })).sort((a, b) => a.key - b.key);
    const name = new Map(names.map(({ v }, i) => [v, i]));
    const moved = names.flatMap(({ v }) => [...positions.slice(3 * v, 3 * v + 3)]);
    const renamed = faces.map((face) => face.map((v) => name.get(v) as number));
    for (const order of ['morton', 'breadth-first'] as const) {
      using mesh = HalfedgeMesh.fromPolygons(moved, renamed);
      const before = meanStep(mesh);
      mesh.reorder(order);
      expect(meanStep(mesh)).toBeLessThan(before / 5);
    }
  });

  test('goes through the eight parts of a cube in turn', () => {
    using mesh = new HalfedgeMesh();
    const corners = [7, 0, 5, 2, 1, 4, 3, 6].map((i) => [i >> 2, (i >> 1) & 1, i & 1]);
    for (const corner of corners) mesh.addVertex(corner as [number, number, number]);
    const { vertices } = mesh.reorder();
    expect([...vertices]).toEqual([7, 0, 5, 2, 1, 4, 3, 6]);
    expect([...mesh.positions.slice(0, 9)]).toEqual([0, 0, 0, 0, 0, 1, 0, 1, 0]);
  });

  test('goes from neighbour to neighbour, whatever the positions are, if it is asked to', () => {
    // A strip of triangles, whose vertices are numbered along it, and lie in random places.
    const faces = Array.from({ length: 18 }, (_, i) =>
      i % 2 ? [i, i + 2, i + 1] : [i, i + 1, i + 2],
    );
    const next = random(9);
    const places = Array.from({ length: 60 }, () => next());
    using along = HalfedgeMesh.fromPolygons(places, faces);
    const seen: number[] = [0];
    for (const v of seen) {
      for (const w of along.vertexVertices(v, 'cw')) if (!seen.includes(w)) seen.push(w);
    }
    const { vertices } = along.reorder('breadth-first');
    expect(seen.map((v) => vertices[v])).toEqual(seen.map((_, i) => i));
    using other = HalfedgeMesh.fromPolygons(places, faces);
    expect(other.reorder('morton').vertices).not.toEqual(vertices);
  });

  test('of a mesh in order changes nothing, and is no step of history', () => {
    using mesh = scattered(4);
    mesh.reorder();
    const { version } = mesh;
    const before = stateOf(mesh);
    mesh.history.enabled = true;
    const maps = mesh.reorder();
    expectState(mesh, before);
    expect(mesh.version).toBe(version);
    expect(mesh.history.canUndo).toBe(false);
    for (const kind of Object.values(KINDS)) {
      expect(maps[kind].every((to, from) => to === from)).toBe(true);
    }
  });

  test('can be undone and redone, alone and in a group', () => {
    using mesh = scattered(5);
    mesh.history.enabled = true;
    mesh.generations.enabled = true;
    const reference = mesh.generations.reference('vertex', 0);
    const before = stateOf(mesh);
    mesh.history.group(() => {
      const { vertices } = mesh.reorder();
      mesh.setPosition(vertices[0], [1, 2, 3]);
    });
    const after = stateOf(mesh);
    expect(mesh.generations.isCurrent(reference)).toBe(false);
    expect(mesh.history.undo()).toBe(true);
    expectState(mesh, before);
    expect(mesh.generations.isCurrent(reference)).toBe(true);
    expect(mesh.history.redo()).toBe(true);
    expectState(mesh, after);
    for (const h of mesh.halfedges()) mesh.next(h);
    expect(() => mesh.next(mesh.halfedgeSlots)).toThrow(RangeError);
  });

  test('takes positions that are no numbers, and no items at all', () => {
    using mesh = HalfedgeMesh.icosahedron();
    mesh.positions.fill(Number.NaN, 0, 6).fill(Infinity, 6, 12);
    mesh.reorder();
    expect(mesh.validate(3)).toEqual([]);
    using empty = new HalfedgeMesh();
    expect(empty.reorder().halfedges.length).toBe(0);
    expect(empty.reorder('breadth-first').vertices.length).toBe(0);
  });

  test('refuses other orders, and meshes that were disposed', () => {
    const mesh = HalfedgeMesh.icosahedron();
    expect(() => mesh.reorder('hilbert' as never)).toThrow(
      "order is \"hilbert\"; expected 'morton' or 'breadth-first'.",
    );
    expect(() => mesh.reorder(0 as never)).toThrow(TypeError);
    mesh.dispose();
    expect(() => mesh.reorder()).toThrow('disposed');
    expect(() => mesh.reorder('hilbert' as never)).toThrow('disposed');
  });

  test('without memory is refused, changes nothing and leaks nothing', () => {
    const inUse = bytesInUse();
    {
      using mesh = HalfedgeMesh.icoSphere(5);
      mesh.positions.reverse();
      mesh.history.enabled = true;
      const before = stateOf(mesh);
      withLeft(100_000, () => {
        for (const order of ['morton', 'breadth-first'] as const) {
          const refused = expect.objectContaining({ code: 'out-of-memory' });
          expect(() => mesh.reorder(order)).toThrow(refused);
        }
      });
      expectState(mesh, before);
      expect(mesh.history.canUndo).toBe(false);
      mesh.reorder();
      expect(mesh.validate()).toEqual([]);
    }
    expect(bytesInUse()).toBe(inUse);
  });
});
