import {
  type DirectedCirculator,
  DirectedEdgesMesh,
  type DirectedOrbit,
  type Direction,
  HalfedgeError,
  HalfedgeMesh,
  init,
  NONE,
} from 'halfedge';
import { bytesInUse, detach, growMemory, withLeft } from './support/core.js';
import {
  annulus,
  bowTie,
  fans,
  type Input,
  pillow,
  puncturedTorus,
  quadGrid,
  randomPolygons,
  tetrahedron,
  torus,
  triangleAndIsolatedVertex,
} from './support/meshes.js';
import { random } from './support/random.js';

beforeAll(() => init());

/** Positions and an index buffer. */
const triangulated = (input: Input) => ({ positions: input.positions, indices: fans(input) });

/** Those of the random meshes whose faces can be cut without making an edge twice. */
function randomTriangles(): [string, Input][] {
  const seeds = Array.from({ length: 40 }, (_, seed) => seed);
  return seeds
    .map((seed): [string, Input] => [`seed ${seed}`, randomPolygons(seed)])
    .filter(([, input]) => {
      const { indices } = triangulated(input);
      const sides = indices.map((v, i) => `${v} ${indices[i % 3 === 2 ? i - 2 : i + 1]}`);
      return new Set(sides).size === sides.length;
    })
    .slice(0, 4);
}

const shapes: [string, Input][] = [
  ['a tetrahedron', tetrahedron()],
  ['a grid', quadGrid()],
  ['a torus', torus()],
  ['a punctured torus', puncturedTorus()],
  ['an annulus', annulus()],
  ['a pinched vertex', bowTie()],
  ['a pillow', pillow()],
  ['an isolated vertex', triangleAndIsolatedVertex()],
];

const directions: Direction[] = ['ccw', 'cw'];
const aroundVertices = [
  'vertexVertices',
  'vertexOutgoingHalfedges',
  'vertexIncomingHalfedges',
  'vertexEdges',
  'vertexFaces',
] as const;
const aroundFaces = ['faceVertices', 'faceHalfedges', 'faceEdges', 'faceFaces'] as const;
const aroundEdges = ['edgeVertices', 'edgeHalfedges', 'edgeFaces'] as const;
const kinds = [...aroundVertices, ...aroundFaces, ...aroundEdges, 'halfedgeLoop'] as const;

/** The same mesh in both structures, and what the halfedges of the one are called in the other. */
class Both {
  readonly whole: HalfedgeMesh;
  readonly mesh: DirectedEdgesMesh;

  constructor(input: Input) {
    const { positions, indices } = triangulated(input);
    this.whole = HalfedgeMesh.fromTriangles(positions, indices);
    this.mesh = DirectedEdgesMesh.fromTriangles(positions, indices);
  }
  halfedge(h: number): number {
    return this.whole.findHalfedge(this.mesh.fromVertex(h), this.mesh.toVertex(h));
  }
  edge(e: number): number {
    return this.whole.edge(this.halfedge(e));
  }
  /** Items of one circulator in terms of the full mesh. */
  named(kind: string, items: number[]): number[] {
    if (/Halfedge/.test(kind)) return items.map((h) => this.halfedge(h));
    if (!/Edges/.test(kind)) return items;
    // An edge has the index of the smaller of its halfedges.
    for (const e of items) expect(this.mesh.edge(e)).toBe(e);
    return items.map((e) => this.edge(e));
  }
}

describe('Directed Edges, as the full mesh', () => {
  describe.each([...shapes, ...randomTriangles()])('%s', (_, input) => {
    let both: Both;
    beforeAll(() => {
      both = new Both(input);
    });

    test('counts', () => {
      const { mesh, whole } = both;
      for (const count of ['vertexCount', 'halfedgeCount', 'edgeCount', 'faceCount'] as const) {
        expect(mesh[count]).toBe(whole[count]);
      }
      expect(mesh.vertices().toArray()).toEqual(whole.vertices().toArray());
      expect(mesh.faces().toArray()).toEqual(whole.faces().toArray());
      expect(mesh.halfedges().toArray()).toHaveLength(whole.halfedgeCount);
      const edges = mesh.edges().toArray();
      expect(edges.map((e) => both.edge(e)).sort((a, b) => a - b)).toEqual(whole.edges().toArray());
      expect(edges).toEqual([...edges].sort((a, b) => a - b));
      expect(mesh.eulerCharacteristic()).toBe(whole.eulerCharacteristic());
      expect(mesh.positions).toEqual(whole.positions);
      for (const v of mesh.vertices()) expect(mesh.position(v)).toEqual(whole.position(v));
      expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
    });

    test('answers every accessor', () => {
      const { mesh, whole } = both;
      for (const h of mesh.halfedges()) {
        const w = both.halfedge(h);
        for (const step of [
          'next',
          'prev',
          'opposite',
          'rotateCcw',
          'rotateCw',
          'nextOnVertex',
          'prevOnVertex',
        ] as const) {
          expect(both.halfedge(mesh[step](h))).toBe(whole[step](w));
        }
        expect(mesh.face(h)).toBe(whole.face(w));
        expect(mesh.isBoundaryHalfedge(h)).toBe(whole.isBoundaryHalfedge(w));
        expect(mesh.findHalfedge(mesh.fromVertex(h), mesh.toVertex(h))).toBe(h);
        expect(mesh.findEdge(mesh.fromVertex(h), mesh.toVertex(h))).toBe(mesh.edge(h));
        for (const direction of directions) {
          expect(both.named('Halfedge', mesh.halfedgeLoop(h, direction).toArray())).toEqual(
            whole.halfedgeLoop(w, direction).toArray(),
          );
        }
      }
      for (const e of mesh.edges()) {
        expect(mesh.edgeHalfedge(e)).toBe(e);
        expect(mesh.edgeHalfedge(e, 1)).toBe(mesh.opposite(e as number));
        expect(mesh.isBoundaryEdge(e)).toBe(whole.isBoundaryEdge(both.edge(e)));
      }
      for (const v of mesh.vertices()) {
        for (const question of [
          'isBoundaryVertex',
          'isIsolatedVertex',
          'isManifoldVertex',
          'valence',
        ] as const) {
          expect(mesh[question](v)).toBe(whole[question](v));
        }
        const anchor = mesh.vertexHalfedge(v);
        expect(anchor === NONE ? NONE : both.halfedge(anchor)).toBe(whole.vertexHalfedge(v));
      }
      for (const f of mesh.faces()) {
        expect(both.halfedge(mesh.faceHalfedge(f))).toBe(whole.faceHalfedge(f));
        expect(mesh.isBoundaryFace(f)).toBe(whole.isBoundaryFace(f));
        expect(mesh.degree(f)).toBe(3);
      }
      expect(
        both.named('Halfedge', mesh.boundaryLoops()).map((h) => smallestOfLoop(whole, h)),
      ).toEqual(expect.arrayContaining(whole.boundaryLoops()));
      expect(mesh.boundaryLoops()).toHaveLength(whole.boundaryLoops().length);
    });

    test.each([...aroundVertices, ...aroundFaces])('shows the same %s', (kind) => {
      const { mesh, whole } = both;
      const isFace = kind.startsWith('face');
      const buffer = new Int32Array(mesh.halfedgeCount);
      const items: number[] = (isFace ? mesh.faces() : mesh.vertices()).toArray();
      for (const item of items) {
        const starts = isFace ? mesh.faceHalfedges(item) : mesh.vertexOutgoingHalfedges(item);
        for (const direction of directions) {
          for (const start of [undefined, ...starts.toArray()]) {
            const wholeStart = start === undefined ? undefined : both.halfedge(start);
            const expected = whole[kind](item, direction, wholeStart).toArray() as number[];
            const lap = mesh[kind](item, direction, start);
            const shown = lap.toArray() as number[];
            expect(both.named(kind, shown)).toEqual(expected);
            expect(lap.into(buffer)).toBe(shown.length);
            expect([...buffer.subarray(0, shown.length)]).toEqual(shown);
          }
          const circulator = mesh.circulate(kind, item, item % 2 === 0 ? direction : { direction });
          const model = whole.circulate(kind, item, { direction });
          const compare = (shown: number, expected: number) =>
            expect(shown === NONE ? NONE : both.named(kind, [shown])[0]).toBe(expected);
          for (let i = 0; i < 5; i++) {
            compare(circulator.current, model.current);
            compare(circulator.next(), model.next());
          }
          for (let i = 0; i < 9; i++) {
            compare(circulator.prev(), model.prev());
            compare(circulator.current, model.current);
            const { halfedge } = circulator;
            expect(halfedge === NONE ? NONE : both.halfedge(halfedge)).toBe(model.halfedge);
          }
        }
      }
    });

    test.each([...aroundVertices, ...aroundFaces])('moves a circulator of %s', (kind) => {
      const { mesh } = both;
      const isFace = kind.startsWith('face');
      const items: number[] = (isFace ? mesh.faces() : mesh.vertices()).toArray();
      for (const direction of directions) {
        const moved = mesh.circulate(kind, items[0], direction);
        for (const item of [...items, ...items.reverse()]) {
          const starts = isFace ? mesh.faceHalfedges(item) : mesh.vertexOutgoingHalfedges(item);
          for (const start of [undefined, ...starts.toArray()]) {
            const fresh = mesh.circulate(kind, item, { direction, start });
            expect(moved.moveTo(item, start)).toBe(moved);
            const places = [moved, fresh].map((circulator) => [
              placeOf(circulator),
              [circulator.next(), placeOf(circulator)],
              [circulator.prev(), circulator.prev(), placeOf(circulator)],
            ]);
            expect(places[0]).toEqual(places[1]);
          }
        }
      }
    });

    test.each(aroundEdges)('shows the same %s, from its own side 0 on', (kind) => {
      const { mesh, whole } = both;
      for (const e of mesh.edges()) {
        const expected = whole[kind](both.edge(e)).toArray() as number[];
        if (both.halfedge(e) !== whole.edgeHalfedge(both.edge(e))) expected.reverse();
        expect(both.named(kind, mesh[kind](e).toArray() as number[])).toEqual(expected);
        for (const direction of directions) {
          const circulator = mesh.circulate(kind, e, direction);
          const seen = [circulator.current, circulator.next(), circulator.next()];
          seen.push(circulator.prev(), circulator.prev(), circulator.prev());
          const around = [0, 1, 2, 1, 0, 1].map((i) => expected[i % expected.length]);
          expect(both.named(kind, seen as number[])).toEqual(around);
        }
      }
    });

    test('goes around every loop, on and back', () => {
      const { mesh, whole } = both;
      for (const h of mesh.halfedges()) {
        for (const direction of directions) {
          const circulator = mesh.circulate('halfedgeLoop', h, direction);
          const model = whole.circulate('halfedgeLoop', both.halfedge(h), direction);
          for (const step of ['next', 'next', 'next', 'next', 'prev', 'prev'] as const) {
            expect(both.halfedge(circulator.current)).toBe(model.current);
            expect(both.halfedge(circulator[step]())).toBe(model[step]());
          }
        }
      }
    });

    test('converts both ways without a change', () => {
      const { mesh, whole } = both;
      using there = DirectedEdgesMesh.fromMesh(whole);
      expect(there.connectivity).toEqual(mesh.connectivity);
      expect(there.positions).toEqual(mesh.positions);
      using back = there.toMesh();
      expect(back.connectivity).toEqual(whole.connectivity);
      expect(back.positions).toEqual(whole.positions);
    });
  });
});

const placeOf = ({ current, halfedge }: DirectedCirculator) => ({ current, halfedge });

function smallestOfLoop(mesh: HalfedgeMesh, h: number): number {
  return Math.min(...mesh.halfedgeLoop(h).toArray());
}

const grid = () => triangulated(quadGrid());
const gridMesh = () => {
  const { positions, indices } = grid();
  return DirectedEdgesMesh.fromTriangles(positions, indices);
};

describe('Directed Edges', () => {
  test('hold the index buffer itself, zero-copy', () => {
    const { positions, indices } = grid();
    using mesh = gridMesh();
    expect([...mesh.indices]).toEqual(indices);
    expect(mesh.indices.buffer).toBe(mesh.connectivity.toVertex.buffer);
    expect([...mesh.positions]).toEqual(positions);
    mesh.positions[0] = 7;
    expect(mesh.positions[0]).toBe(7);
  });

  test('take 64 bytes a vertex, and none after dispose', () => {
    const { positions, indices } = triangulated(torus(60, 50));
    const before = bytesInUse();
    const mesh = DirectedEdgesMesh.fromTriangles(positions, indices);
    const bytes = bytesInUse() - before;
    expect(bytes).toBeGreaterThanOrEqual(64 * mesh.vertexCount);
    expect(bytes).toBeLessThan(64 * mesh.vertexCount + 500);
    mesh.dispose();
    expect(bytesInUse()).toBe(before);
  });

  test('leave nothing behind when something is refused', () => {
    const before = bytesInUse();
    using quads = HalfedgeMesh.fromPolygons(quadGrid().positions, quadGrid().faces);
    const withQuads = bytesInUse();
    expect(() => DirectedEdgesMesh.fromMesh(quads)).toThrow(HalfedgeError);
    expect(() => DirectedEdgesMesh.fromTriangles([0, 0, 0], [0, 0, 0])).toThrow(HalfedgeError);
    expect(() => DirectedEdgesMesh.fromTriangles([0, 0, 0], [0, 0.5, 0])).toThrow(RangeError);
    const mesh = gridMesh();
    mesh.connectivity.opposite[0] = 9;
    expect(() => mesh.toMesh()).toThrow(HalfedgeError);
    mesh.dispose();
    expect(bytesInUse()).toBe(withQuads);
    quads.dispose();
    expect(bytesInUse()).toBe(before);
  });

  test.each([
    ['positions', ['x', [0, 1, 2]]],
    ['a number of positions', [[0, 0], []]],
    [
      'a number of indices',
      [
        [0, 0, 0],
        [0, 0],
      ],
    ],
    ['an index out of range', [new Float32Array(9), [0, 1, 3]]],
    ['a negative index', [new Float32Array(9), Int32Array.of(0, 1, -2)]],
    ['a face twice', [new Float32Array(9), [0, 1, 2, 0, 1, 2]]],
    [
      'no finite position',
      [
        [0, 0, Number.NaN, 1, 0, 0, 0, 1, 0],
        [0, 1, 2],
      ],
    ],
  ] as [string, [ArrayLike<number>, ArrayLike<number>]][])(
    'refuse %s in the words of the full mesh',
    (_, [positions, indices]) => {
      const [expected, error] = [HalfedgeMesh, DirectedEdgesMesh].map((Mesh) =>
        caught(() => Mesh.fromTriangles(positions, indices)),
      );
      expect(error).toBeInstanceOf(Error);
      expect(error.constructor).toBe(expected.constructor);
      expect(error.message).toBe(expected.message);
      expect((error as HalfedgeError).problems).toEqual((expected as HalfedgeError).problems);
    },
  );

  test('are made of triangle meshes only', () => {
    using quads = HalfedgeMesh.fromPolygons(quadGrid().positions, quadGrid().faces);
    const error = caught(() => DirectedEdgesMesh.fromMesh(quads)) as HalfedgeError;
    expect(error.code).toBe('not-a-triangle');
    expect(error.message).toBe('Face 0 has 4 corners; Directed Edges hold triangles only.');
    expect(error.witness.faces).toEqual([0]);
    expect(() => DirectedEdgesMesh.fromMesh({} as HalfedgeMesh)).toThrow(
      new TypeError('mesh is an Object; expected a HalfedgeMesh.'),
    );
  });

  test('are made of a mesh without prev', () => {
    const { positions, indices } = grid();
    using without = HalfedgeMesh.fromTriangles(positions, indices, { storePrev: false });
    using mesh = DirectedEdgesMesh.fromMesh(without);
    using direct = gridMesh();
    expect(mesh.connectivity).toEqual(direct.connectivity);
  });

  test('survive growth of the memory, also in the middle of a lap', () => {
    using mesh = gridMesh();
    const expected = mesh.vertexFaces(5).toArray();
    const kept = mesh.connectivity;
    const lap = mesh.vertexFaces(5)[Symbol.iterator]();
    const circulator = mesh.circulate('vertexFaces', 5);
    const shown: number[] = [lap.next().value];
    growMemory();
    expect(kept.opposite).toHaveLength(0);
    for (let step = lap.next(); !step.done; step = lap.next()) shown.push(step.value);
    expect(shown).toEqual(expected);
    growMemory();
    expect(circulator.next()).toBe(expected[1]);
    growMemory();
    expect(mesh.opposite(0)).toBe(mesh.connectivity.opposite[0]);
    expect(mesh.connectivity).not.toBe(kept);
    growMemory();
    expect(mesh.edges().toArray()).toHaveLength(mesh.edgeCount);
    growMemory();
    expect(mesh.vertexVertices(5).into(new Int32Array(8))).toBe(mesh.valence(5));
    growMemory();
    expect(mesh.indices).toHaveLength(3 * mesh.faceCount);
  });

  test.each(kinds.flatMap((kind) => directions.map((direction) => [kind, direction] as const)))(
    'find their memory wherever it has gone: %s, %s',
    (kind, direction) => {
      using mesh = gridMesh();
      const lap = () =>
        (mesh[kind] as (item: number, way: Direction) => Iterable<number>)(5, direction);
      const expected = [...lap()];
      const circulate = () => mesh.circulate(kind, 5 as never, direction) as DirectedCirculator;
      const detached = (use: () => unknown): unknown => {
        detach(mesh);
        return use();
      };
      const [first, last] = [expected[0], expected.at(-1)];
      const [kept, model] = [circulate(), circulate()];
      expect(kept.current).toBe(first);
      const { halfedge } = kept;
      expect(detached(() => kept.current)).toBe(first);
      expect(detached(() => kept.halfedge)).toBe(halfedge);
      expect(detached(() => kept.prev())).toBe(last);
      expect(detached(() => kept.next())).toBe(first);
      expect(detached(() => kept.moveTo(5) === kept && kept.current)).toBe(first);
      expect(detached(() => circulate().current)).toBe(first);
      expect(detached(() => model.next())).toBe(expected[1 % expected.length]);
      expect(detached(() => [...lap()])).toEqual(expected);
      const underway = lap()[Symbol.iterator]();
      for (const item of expected) expect(detached(() => underway.next().value)).toBe(item);
      expect(detached(() => underway.next().done)).toBe(true);
      const buffer = new Int32Array(expected.length + 1).fill(77);
      expect(detached(() => (lap() as never as { into(b: Int32Array): number }).into(buffer))).toBe(
        expected.length,
      );
      expect([...buffer]).toEqual([...expected, 77]);
      mesh.dispose();
      for (const use of [
        () => kept.current,
        () => kept.halfedge,
        () => kept.next(),
        () => kept.prev(),
        () => kept.moveTo(5),
        () => underway.next(),
      ]) {
        expect((caught(use) as HalfedgeError).code).toBe('disposed');
      }
    },
  );

  test('say what is wrong with an argument', () => {
    using mesh = gridMesh();
    const cases: [() => unknown, Error][] = [
      [() => mesh.next(99), new RangeError('h is 99; expected a halfedge from 0 to 65.')],
      [() => mesh.prev(-1), new RangeError('h is -1; expected a halfedge from 0 to 65.')],
      [() => mesh.opposite(0.5), new RangeError('h is 0.5; expected a halfedge from 0 to 65.')],
      [
        () => mesh.face('0' as never),
        new TypeError('h is "0"; expected a halfedge, which is an integer.'),
      ],
      [() => mesh.faceHalfedge(18), new RangeError('f is 18; expected a face from 0 to 17.')],
      [() => mesh.valence(16), new RangeError('v is 16; expected a vertex from 0 to 15.')],
      [
        () => mesh.edgeVertices(4),
        new RangeError('e is 4, which is no edge; expected the smaller of its two halfedges, 0.'),
      ],
      [() => mesh.edgeHalfedge(0, 2 as 1), new RangeError('side is 2; expected 0 or 1.')],
      [() => mesh.edgeHalfedge(0, '1' as never), new TypeError('side is "1"; expected 0 or 1.')],
      [
        () => mesh.vertexFaces(0, 'up' as Direction),
        new RangeError("direction is \"up\"; expected 'ccw' or 'cw'."),
      ],
      [
        () => mesh.vertexFaces(0, 'cw', mesh.faceHalfedge(17)),
        new RangeError(
          'start is halfedge 51, which leaves vertex 14; expected one that leaves vertex 0.',
        ),
      ],
      [
        () => mesh.faceFaces(0, 'cw', mesh.faceHalfedge(17)),
        new RangeError(
          'start is halfedge 51, which lies in face 17; expected one that lies in face 0.',
        ),
      ],
      [
        () => mesh.circulate('halfedgeLoop', 0, { start: 1 }),
        new RangeError('start is 1; expected none, because a loop begins at its halfedge.'),
      ],
      [
        () => mesh.vertexFaces(5).into(new Int32Array(2)),
        new RangeError('buffer has length 2; expected at least 6.'),
      ],
      [
        () => mesh.vertexFaces(5).into([] as never),
        new TypeError('buffer is an array of 0 elements; expected an Int32Array or a Uint32Array.'),
      ],
      [
        () => mesh.validate(5 as number),
        new RangeError('level is 5; expected an integer from 0 to 4.'),
      ],
    ];
    for (const [act, error] of cases) {
      const actual = caught(act);
      expect(actual.message).toBe(error.message);
      expect(actual.constructor).toBe(error.constructor);
    }
    expect(() => mesh.circulate('constructor' as never, 0)).toThrow(/kind is "constructor"/);
    expect(() => mesh.circulate(['faceFaces'] as never, 0)).toThrow(
      /kind is an array of 1 element/,
    );
    expect(() => mesh.circulate('vertexFaces', 5, 'left' as 'cw')).toThrow(/direction is "left"/);
  });

  test('are not made by new', () => {
    using mesh = HalfedgeMesh.tetrahedron();
    for (const given of [[], [mesh], [{}]]) {
      expect(() => Reflect.construct(DirectedEdgesMesh, given)).toThrow(
        new TypeError(
          'A DirectedEdgesMesh is not made by `new`; expected DirectedEdgesMesh.fromTriangles(positions, indices) or fromMesh(mesh).',
        ),
      );
    }
  });

  test('cannot be used after dispose', () => {
    const mesh = gridMesh();
    const lap = mesh.vertexFaces(5)[Symbol.iterator]();
    const edges = mesh.edges()[Symbol.iterator]();
    const faces = mesh.faces()[Symbol.iterator]();
    const circulator = mesh.circulate('vertexFaces', 5);
    const orbit = mesh.vertexFaces(5);
    const isolated = DirectedEdgesMesh.fromTriangles(new Float32Array(12), [0, 1, 2]);
    const nothing = isolated.vertexFaces(3);
    isolated.dispose();
    mesh.dispose();
    mesh.dispose();
    expect(mesh.disposed).toBe(true);
    const uses: (() => unknown)[] = [
      () => mesh.next(0),
      () => mesh.opposite(0),
      () => mesh.face(0),
      () => mesh.fromVertex(0),
      () => mesh.vertexHalfedge(0),
      () => mesh.faceHalfedge(0),
      () => mesh.faceCount,
      () => mesh.edgeSlots,
      () => mesh.version,
      () => mesh.connectivity,
      () => mesh.positions,
      () => mesh.indices,
      () => mesh.vertexFaces(5),
      () => mesh.edges(),
      () => mesh.boundaryLoops(),
      () => mesh.validate(),
      () => mesh.toMesh(),
      () => lap.next(),
      () => edges.next(),
      () => faces.next(),
      () => circulator.next(),
      () => circulator.current,
      () => orbit.toArray(),
      () => orbit.into(new Int32Array(9)),
      () => nothing.into(new Int32Array(9)),
    ];
    for (const use of uses) expect((caught(use) as HalfedgeError).code).toBe('disposed');
  });

  test('say so where memory ends', () => {
    const { positions, indices } = triangulated(torus(200, 200));
    using whole = HalfedgeMesh.fromTriangles(positions, indices);
    using mesh = DirectedEdgesMesh.fromTriangles(positions, indices);
    const before = bytesInUse();
    withLeft(2 ** 20, () => {
      for (const act of [
        () => DirectedEdgesMesh.fromTriangles(positions, indices),
        () => DirectedEdgesMesh.fromMesh(whole),
        () => mesh.toMesh(),
      ]) {
        expect((caught(act) as HalfedgeError).code).toBe('out-of-memory');
      }
    });
    expect(bytesInUse()).toBe(before);
  });

  test('with corrupt links end every walk, with an answer or a sentence', () => {
    for (let seed = 1; seed <= 300; seed++) {
      const next = random(seed);
      using mesh = gridMesh();
      const views = Object.values(mesh.connectivity) as Int32Array[];
      for (let i = 0; i < 3; i++) {
        const view = views[Math.floor(next() * views.length)];
        view[Math.floor(next() * view.length)] = Math.floor(next() * 80) - 8;
      }
      for (const act of [
        () => mesh.boundaryLoops(),
        () => mesh.validate(),
        () => mesh.toMesh().dispose(),
        ...[...mesh.vertices()].flatMap((v) => [
          () => mesh.valence(v),
          () => mesh.isManifoldVertex(v),
          () => mesh.findEdge(v, 0),
          () => mesh.vertexFaces(v, 'cw').toArray(),
          () => mesh.vertexEdges(v).into(new Int32Array(99)),
          () => mesh.circulate('vertexFaces', v).prev(),
          ...(seed % 5 === 0 ? aroundVertices.flatMap((kind) => uses(mesh, kind, v)) : []),
        ]),
        ...[...mesh.faces()].flatMap((f) => [
          () => mesh.faceFaces(f).toArray(),
          () => mesh.faceEdges(f, 'cw').toArray(),
          () => mesh.isBoundaryFace(f),
          ...(seed % 5 === 0 ? aroundFaces.flatMap((kind) => uses(mesh, kind, f)) : []),
        ]),
      ]) {
        try {
          act();
        } catch (error) {
          expect(`${(error as HalfedgeError).code ?? (error as Error).name}`).toMatch(
            /^(corrupt-connectivity|RangeError)$/,
          );
        }
      }
    }
  });
});

/** All ways around an item, which end. */
const uses = (mesh: DirectedEdgesMesh, kind: (typeof kinds)[number], item: number) =>
  directions.flatMap((direction) => {
    const lap = () =>
      (mesh[kind] as (item: number, way: Direction) => DirectedOrbit<number>)(item, direction);
    const circulate = () => mesh.circulate(kind, item as never, direction) as DirectedCirculator;
    const walk = (step: 'next' | 'prev') => () => {
      const circulator = circulate();
      const shown = Array.from({ length: 9 }, () => circulator[step]());
      shown.push(circulator.moveTo(item).halfedge);
      expect(Math.min(...shown)).toBeGreaterThanOrEqual(NONE);
    };
    return [
      () => lap().toArray(),
      () => lap().into(new Int32Array(99)),
      walk('next'),
      walk('prev'),
    ];
  });

function caught(act: () => unknown): Error {
  try {
    act();
  } catch (error) {
    return error as Error;
  }
  throw new Error('nothing was thrown');
}
