import { type CirculatorKind, type HalfedgeMesh, init, NONE } from 'halfedge';
import {
  aroundEdges,
  aroundFaces,
  aroundVertices,
  directed,
  directions,
  range,
} from './support/circulators.js';
import { moveArrays } from './support/core.js';
import {
  bowTie,
  build,
  type Input,
  pillow,
  quadGrid,
  randomPolygons,
  tetrahedron,
  triangleAndIsolatedVertex,
} from './support/meshes.js';

beforeAll(() => init());

describe('The example of the specification', () => {
  // Halfedges as `from>to`, `*` marks boundary halfedges.
  const table: [query: string, kind: CirculatorKind, item: number, cw: string, ccw: string][] = [
    ['outgoing(5)', 'vertexOutgoingHalfedges', 5, '5>6 5>1 5>4 5>9', '5>9 5>4 5>1 5>6'],
    ['outgoing(1)', 'vertexOutgoingHalfedges', 1, '1>0* 1>5 1>2', '1>2 1>5 1>0*'],
    ['incoming(1)', 'vertexIncomingHalfedges', 1, '0>1 5>1 2>1*', '2>1* 5>1 0>1'],
    ['vertices(1)', 'vertexVertices', 1, '0 5 2', '2 5 0'],
    ['faces(1)', 'vertexFaces', 1, '0 1', '1 0'],
    ['face faces(0)', 'faceFaces', 0, '3 1', '1 3'],
    ['face faces(4)', 'faceFaces', 4, '7 5 1 3', '3 1 5 7'],
    ['face vertices(4)', 'faceVertices', 4, '9 10 6 5', '5 6 10 9'],
  ];
  test.each(table)('%s', (_, kind, item, cw, ccw) => {
    using mesh = build(quadGrid());
    const names = (items: Iterable<number>) =>
      Array.from(items, (index) => {
        if (!kind.endsWith('Halfedges')) return String(index);
        const mark = mesh.isBoundaryHalfedge(index) ? '*' : '';
        return `${mesh.fromVertex(index)}>${mesh.toVertex(index)}${mark}`;
      }).join(' ');
    expect(names(range(mesh, kind)(item, 'cw'))).toBe(cw);
    expect(names(range(mesh, kind)(item, 'ccw'))).toBe(ccw);
    expect(names(range(mesh, kind)(item))).toBe(ccw);
  });
});

describe.each([
  ['a grid', quadGrid()],
  ['a closed mesh', tetrahedron()],
  ['a pillow', pillow()],
  ['a pinched vertex', bowTie()],
  ['an isolated vertex', triangleAndIsolatedVertex()],
  ...[51, 52, 53, 54, 55, 56].map((seed): [string, Input] => [
    `random polygons (seed ${seed})`,
    randomPolygons(seed),
  ]),
])('On %s', (_, input) => {
  let mesh: HalfedgeMesh;
  beforeAll(() => {
    mesh = build(input);
  });
  afterAll(() => mesh.dispose());

  test.each(directed)('%s are those of all rings', (kind, around, all) => {
    const count = around === 'vertex' ? mesh.vertexCount : mesh.faceCount;
    for (const direction of directions) {
      const { offsets, items } = all(mesh, direction);
      for (let i = 0; i < count; i++) {
        const ring = Array.from(items.subarray(offsets[i], offsets[i + 1]));
        expect([i, ...range(mesh, kind)(i, direction)]).toEqual([i, ...ring]);
      }
    }
  });

  test('the edge circulators are those of all rings', () => {
    const all = {
      edgeVertices: mesh.allEdgeVertices(),
      edgeHalfedges: mesh.allEdgeHalfedges(),
      edgeFaces: mesh.allEdgeFaces(),
    };
    for (const kind of aroundEdges) {
      const { offsets, items } = all[kind];
      for (let e = 0; e < mesh.edgeCount; e++) {
        const ring = Array.from(items.subarray(offsets[e], offsets[e + 1]));
        expect([...mesh[kind](e)]).toEqual(ring);
      }
    }
  });

  test('with a start both directions begin at it', () => {
    for (let h = 0; h < mesh.halfedgeCount; h++) {
      const [v, f] = [mesh.fromVertex(h), mesh.face(h)];
      const outgoing = [...mesh.vertexOutgoingHalfedges(v, 'cw')];
      const turned = [...outgoing.slice(outgoing.indexOf(h as never))];
      turned.push(...outgoing.slice(0, outgoing.length - turned.length));
      expect([...mesh.vertexOutgoingHalfedges(v, 'cw', h)]).toEqual(turned);
      const [first, ...rest] = turned;
      const reverse = [first, ...rest.reverse()];
      expect([...mesh.vertexOutgoingHalfedges(v, 'ccw', h)]).toEqual(reverse);
      expect([...mesh.vertexIncomingHalfedges(v, 'ccw', h)]).toEqual(reverse.map((g) => g ^ 1));
      expect([...mesh.vertexIncomingHalfedges(v, 'ccw', h ^ 1)]).toEqual(reverse.map((g) => g ^ 1));
      expect([...mesh.vertexVertices(v, 'ccw', h)]).toEqual(reverse.map((g) => mesh.toVertex(g)));
      expect([...mesh.vertexEdges(v, 'ccw', h)]).toEqual(reverse.map((g) => g >> 1));
      const faces = reverse.map((g) => mesh.face(g)).filter((g) => g !== NONE);
      expect([...mesh.vertexFaces(v, 'ccw', h)]).toEqual(faces);

      const loop: number[] = [h];
      for (let g = mesh.next(h); g !== h; g = mesh.next(g)) loop.push(g);
      const backwards = [h, ...loop.slice(1).reverse()];
      expect([...mesh.halfedgeLoop(h)]).toEqual(loop);
      expect([...mesh.halfedgeLoop(h, 'cw')]).toEqual(backwards);
      if (f === NONE) continue;
      expect([...mesh.faceHalfedges(f, 'ccw', h)]).toEqual(loop);
      expect([...mesh.faceHalfedges(f, 'cw', h)]).toEqual(backwards);
      expect([...mesh.faceVertices(f, 'cw', h)]).toEqual(backwards.map((g) => mesh.toVertex(g)));
      expect([...mesh.faceEdges(f, 'cw', h)]).toEqual(backwards.map((g) => g >> 1));
      const across = backwards.map((g) => mesh.face(g ^ 1)).filter((g) => g !== NONE);
      expect([...mesh.faceFaces(f, 'cw', h)]).toEqual(across);
    }
  });

  test('a buffer is filled with what a loop sees', () => {
    const buffer = new Int32Array(mesh.vertexCount + mesh.faceCount);
    for (const [kinds, count] of [
      [aroundVertices, mesh.vertexCount],
      [aroundFaces, mesh.faceCount],
      [aroundEdges, mesh.edgeCount],
      [['halfedgeLoop'], mesh.halfedgeCount],
    ] as const) {
      for (const kind of kinds) {
        for (let item = 0; item < count; item++) {
          for (const direction of directions) {
            const lap = range(mesh, kind)(item, direction);
            const filled = buffer.fill(-7).subarray(0, lap.into(buffer));
            expect([...filled]).toEqual([...lap]);
            expect(buffer[filled.length]).toBe(-7);
          }
        }
      }
    }
  });

  test('the endless form goes round and round, and back', () => {
    const items: [readonly CirculatorKind[], number][] = [
      [aroundVertices, mesh.vertexCount],
      [aroundFaces, mesh.faceCount],
      [aroundEdges, mesh.edgeCount],
      [['halfedgeLoop'], mesh.halfedgeCount],
    ];
    for (const [kinds, count] of items) {
      for (const kind of kinds) {
        for (let item = 0; item < count; item++) {
          for (const direction of directions) {
            const ring = [...range(mesh, kind)(item, direction)];
            const circulator = mesh.circulate(kind, item, direction);
            const sameByOptions = mesh.circulate(kind, item, { direction });
            expect(sameByOptions.current).toBe(circulator.current);
            expect(sameByOptions.next()).toBe(circulator.next());
            circulator.prev();
            if (ring.length === 0) {
              expect([circulator.current, circulator.next(), circulator.prev()]).toEqual([
                -1, -1, -1,
              ]);
              expect(circulator.halfedge).toBe(NONE);
              continue;
            }
            const twice = [...ring, ...ring];
            expect(twice.map((_, i) => (i === 0 ? circulator.current : circulator.next()))).toEqual(
              twice,
            );
            circulator.next();
            expect(circulator.current).toBe(ring[0]);
            const back = [...twice].reverse();
            expect(back.map(() => circulator.prev())).toEqual(back);
          }
        }
      }
    }
  });

  test('vertices(), halfedges(), edges() and faces() list all of them', () => {
    const upTo = (count: number) => Array.from({ length: count }, (_, i) => i);
    expect([...mesh.vertices()]).toEqual(upTo(mesh.vertexCount));
    expect([...mesh.halfedges()]).toEqual(upTo(mesh.halfedgeCount));
    expect([...mesh.edges()]).toEqual(upTo(mesh.edgeCount));
    expect([...mesh.faces()]).toEqual(upTo(mesh.faceCount));
  });

  test('boundaryLoops() names one halfedge of each loop', () => {
    const loops = [...mesh.boundaryLoops()].map((h) => [...mesh.halfedgeLoop(h)]);
    const boundary = [...mesh.halfedges()].filter((h) => mesh.isBoundaryHalfedge(h));
    expect(loops.flat().sort((a, b) => a - b)).toEqual(boundary);
    expect(loops.map((loop) => Math.min(...loop))).toEqual(loops.map(([first]) => first));
  });
});

describe('A range', () => {
  test('can be walked any number of times', () => {
    using mesh = build(quadGrid());
    for (const items of [
      mesh.vertexVertices(5),
      mesh.vertexFaces(1),
      mesh.edgeFaces(1),
      mesh.faces(),
    ]) {
      const once = [...items];
      expect(once.length).toBeGreaterThan(0);
      expect([...items]).toEqual(once);
      expect(items.toArray()).toEqual(once);
    }
  });

  test('can be walked by several loops at the same time', () => {
    using mesh = build(quadGrid());
    const ring = mesh.vertexFaces(5);
    const couples: number[][] = [];
    for (const a of ring) for (const b of ring) couples.push([a, b]);
    const faces = [3, 0, 1, 4];
    expect(couples).toEqual(faces.flatMap((a) => faces.map((b) => [a, b])));
    expect(new Set(ring)).toEqual(new Set(faces));
  });

  test('can be nested in others of the same mesh, and of other meshes', () => {
    using mesh = build(quadGrid());
    using other = build(tetrahedron());
    let corners = 0;
    for (const v of mesh.vertices()) {
      for (const f of mesh.vertexFaces(v)) {
        for (const w of mesh.faceVertices(f)) {
          for (const u of other.vertexVertices(w % 4)) corners += Number(u >= 0);
          corners += w === v ? 1000 : 0;
        }
      }
    }
    expect(corners).toBe(4 * 9 * (1000 + 4 * 3));
  });

  test.each(['vertices', 'halfedges', 'edges', 'faces'] as const)(
    '%s() goes by the arrays of now, once `reserve` has moved them in the middle',
    (items) => {
      using mesh = build(quadGrid(20, 20));
      for (const v of [50, 100, 150, 200, 210, 220, 230]) mesh.deleteVertex(v);
      const expected = [...mesh[items]()];
      const seen: number[] = [];
      for (const item of mesh[items]()) {
        seen.push(item);
        if (seen.length === 100) moveArrays(mesh);
      }
      expect(seen).toEqual(expected);
    },
  );

  test('can be left early, and begins anew', () => {
    using mesh = build(quadGrid());
    const ring = mesh.vertexVertices(5);
    for (let i = 0; i < 3; i++) {
      const seen: number[] = [];
      for (const w of ring) {
        seen.push(w);
        if (seen.length === 2) break;
      }
      expect(seen).toEqual([9, 4]);
    }
    const [first] = ring;
    expect(first).toBe(9);
    expect(() => {
      for (const _ of ring) throw new Error('from the body');
    }).toThrow('from the body');
    expect([...ring]).toEqual([9, 4, 1, 6]);
  });

  test('stays at its end', () => {
    using mesh = build(quadGrid());
    for (const items of [
      mesh.vertexVertices(0),
      mesh.vertexFaces(0),
      mesh.edgeVertices(0),
      mesh.faces(),
    ]) {
      const iterator = items[Symbol.iterator]();
      while (!iterator.next().done);
      expect(iterator.next().done).toBe(true);
      expect(iterator.next()).toEqual({ value: NONE, done: true });
    }
  });

  test.each([Int32Array, Uint32Array])('fills a buffer (%p)', (Kind) => {
    using mesh = build(quadGrid());
    const buffer = new Kind(6).fill(77);
    expect(mesh.vertexVertices(5).into(buffer)).toBe(4);
    expect([...buffer]).toEqual([9, 4, 1, 6, 77, 77]);
    expect(mesh.vertexFaces(1, 'cw').into(buffer)).toBe(2);
    expect([...buffer]).toEqual([0, 1, 1, 6, 77, 77]);
    expect(mesh.vertexVertices(5).into(new Kind(4))).toBe(4);
  });

  test('says how much room a buffer lacks', () => {
    using mesh = build(quadGrid());
    expect(() => mesh.vertexVertices(5).into(new Int32Array(3))).toThrow(
      new RangeError('buffer has length 3; expected at least 4.'),
    );
    expect(() => mesh.vertexFaces(5).into(new Int32Array(0))).toThrow(RangeError);
    for (const kind of [...aroundVertices, ...aroundEdges]) {
      const lap = [...range(mesh, kind)(1)];
      const items = mesh[kind](1);
      expect(items.into(new Int32Array(lap.length))).toBe(lap.length);
      expect(() => items.into(new Int32Array(lap.length - 1))).toThrow(
        `buffer has length ${lap.length - 1}; expected at least ${lap.length}.`,
      );
    }
    for (const buffer of [
      null,
      4,
      'four',
      {},
      [0, 0, 0, 0],
      new Float32Array(4),
      new Uint8Array(4),
    ]) {
      for (const lap of [mesh.vertexVertices(5), mesh.edgeVertices(5)]) {
        expect(() => lap.into(buffer as never)).toThrow(TypeError);
        expect(() => lap.into(buffer as never)).toThrow(
          /^buffer is .*; expected an Int32Array or a Uint32Array\.$/,
        );
      }
    }
  });

  test('of an isolated vertex is empty in every form', () => {
    using mesh = build(triangleAndIsolatedVertex());
    for (const kind of aroundVertices) {
      for (const direction of directions) {
        expect([...mesh[kind](3, direction)]).toEqual([]);
        expect(mesh[kind](3, direction).toArray()).toEqual([]);
        expect(mesh[kind](3, direction).into(new Int32Array(0))).toBe(0);
        expect(mesh.circulate(kind, 3, { direction }).current).toBe(NONE);
      }
      expect(() => mesh[kind](3, 'ccw', 0)).toThrow(RangeError);
    }
  });
});
