import { type CirculatorKind, type Direction, HalfedgeMesh, init, NONE, type Rows } from 'halfedge';
import { changeConnectivity, growMemory } from './support/core.js';
import {
  bowTie,
  type Input,
  pillow,
  quadGrid,
  randomPolygons,
  tetrahedron,
  triangleAndIsolatedVertex,
} from './support/meshes.js';

beforeAll(() => init());

const build = ({ positions, faces }: Input) => HalfedgeMesh.fromPolygons(positions, faces);

type Around = 'vertex' | 'face';
const aroundVertices = [
  'vertexVertices',
  'vertexOutgoingHalfedges',
  'vertexIncomingHalfedges',
  'vertexEdges',
  'vertexFaces',
] as const;
const aroundFaces = ['faceVertices', 'faceHalfedges', 'faceEdges', 'faceFaces'] as const;
const aroundEdges = ['edgeVertices', 'edgeHalfedges', 'edgeFaces'] as const;
const directions: Direction[] = ['ccw', 'cw'];

/** All kinds in one row each: what they circulate around, and how to list them at once. */
const directed: [CirculatorKind, Around, (mesh: HalfedgeMesh, direction: Direction) => Rows][] = [
  ['vertexVertices', 'vertex', (mesh, way) => mesh.allVertexVertices(way)],
  ['vertexOutgoingHalfedges', 'vertex', (mesh, way) => mesh.allVertexOutgoingHalfedges(way)],
  ['vertexIncomingHalfedges', 'vertex', (mesh, way) => mesh.allVertexIncomingHalfedges(way)],
  ['vertexEdges', 'vertex', (mesh, way) => mesh.allVertexEdges(way)],
  ['vertexFaces', 'vertex', (mesh, way) => mesh.allVertexFaces(way)],
  ['faceVertices', 'face', (mesh, way) => mesh.allFaceVertices(way)],
  ['faceHalfedges', 'face', (mesh, way) => mesh.allFaceHalfedges(way)],
  ['faceEdges', 'face', (mesh, way) => mesh.allFaceEdges(way)],
  ['faceFaces', 'face', (mesh, way) => mesh.allFaceFaces(way)],
];

type Range = (item: number, direction?: Direction, start?: number) => Iterable<number>;
const range = (mesh: HalfedgeMesh, kind: CirculatorKind): Range => (mesh[kind] as Range).bind(mesh);

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
            const circulator = mesh.circulate(kind, item, { direction });
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
      expect(() => mesh.vertexVertices(5).into(buffer as never)).toThrow(TypeError);
      expect(() => mesh.vertexVertices(5).into(buffer as never)).toThrow(
        /^buffer is .*; expected an Int32Array or a Uint32Array\.$/,
      );
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

describe('After the connectivity has changed,', () => {
  const sentence =
    'This circulator was used after the connectivity changed under it; expected a new one.';
  const use: [string, (mesh: HalfedgeMesh, change: () => void) => unknown][] = [
    [
      'the next step of a loop',
      (mesh, change) => {
        for (const _ of mesh.vertexVertices(5)) change();
      },
    ],
    [
      'the next step of a loop over faces',
      (mesh, change) => {
        for (const _ of mesh.vertexFaces(5)) change();
      },
    ],
    [
      'the next step of a loop over an edge',
      (mesh, change) => {
        for (const _ of mesh.edgeVertices(5)) change();
      },
    ],
    [
      'the next step of a loop over all faces',
      (mesh, change) => {
        for (const _ of mesh.faces()) change();
      },
    ],
    [
      'a range',
      (mesh, change) => {
        const ring = mesh.vertexVertices(5);
        change();
        return [...ring];
      },
    ],
    [
      'an array of a range',
      (mesh, change) => {
        const ring = mesh.vertexFaces(5);
        change();
        return ring.toArray();
      },
    ],
    [
      'filling a buffer',
      (mesh, change) => {
        const ring = mesh.vertexFaces(5);
        change();
        return ring.into(new Int32Array(4));
      },
    ],
    ...(['current', 'halfedge'] as const).map(
      (name): [string, (mesh: HalfedgeMesh, change: () => void) => unknown] => [
        `${name} of a circulator`,
        (mesh, change) => {
          const circulator = mesh.circulate('vertexVertices', 5);
          change();
          return circulator[name];
        },
      ],
    ),
    ...(['next', 'prev'] as const).map(
      (name): [string, (mesh: HalfedgeMesh, change: () => void) => unknown] => [
        `${name}() of a circulator`,
        (mesh, change) => {
          const circulator = mesh.circulate('vertexVertices', 5);
          change();
          return circulator[name]();
        },
      ],
    ),
  ];
  test.each(use)('%s throws', (_, use) => {
    using mesh = build(quadGrid());
    expect(() => use(mesh, () => changeConnectivity(mesh))).toThrow(
      expect.objectContaining({ code: 'stale-circulator', message: sentence }),
    );
    expect(() => use(mesh, () => {})).not.toThrow();
  });

  test('new circulators work', () => {
    using mesh = build(quadGrid());
    changeConnectivity(mesh);
    expect([...mesh.vertexVertices(5)]).toEqual([9, 4, 1, 6]);
  });
});

describe('With corrupted links', () => {
  // Each of these makes vertex 5 of the grid a walk that never comes back to where it began.
  const corruptions: [string, (views: Record<string, Int32Array>, anchor: number) => void][] = [
    [
      'a cycle that misses the anchor',
      ({ prev, next }, anchor) => {
        const second = prev[prev[anchor] ^ 1] ^ 1;
        prev[second] = second ^ 1;
        next[second ^ 1] = second;
      },
    ],
    [
      'an index out of range',
      ({ prev, next }, anchor) => {
        prev[prev[anchor] ^ 1] = 1 << 29;
        next[next[anchor ^ 1] ^ 1] = 1 << 29;
      },
    ],
    [
      'the mark of a deleted item',
      ({ prev, next }, anchor) => {
        prev[prev[anchor] ^ 1] = -5;
        next[next[anchor ^ 1] ^ 1] = -5;
      },
    ],
    [
      'an anchor out of range',
      ({ vertexHalfedge }) => {
        vertexHalfedge[5] = 999;
      },
    ],
  ];
  test.each(corruptions)('(%s) every form throws', (_, corrupt) => {
    using mesh = build(quadGrid());
    corrupt(mesh.connectivity as never, mesh.vertexHalfedge(5));
    for (const kind of aroundVertices) {
      for (const direction of directions) {
        for (const walk of [
          () => [...mesh[kind](5, direction)],
          () => mesh[kind](5, direction).toArray(),
          () => mesh[kind](5, direction).into(new Int32Array(100)),
        ]) {
          expect(walk).toThrow(expect.objectContaining({ code: 'corrupt-connectivity' }));
        }
      }
    }
  });

  test('a circulator that shows nothing any more throws', () => {
    using mesh = build(quadGrid());
    const circulator = mesh.circulate('vertexFaces', 5);
    mesh.connectivity.face.fill(NONE);
    expect(circulator.next()).toBe(NONE);
    expect([...mesh.vertexFaces(5)]).toEqual([]);
    mesh.connectivity.face.fill(-7);
    expect(() => mesh.circulate('vertexFaces', 5)).toThrow('corrupt');
    expect(() => [...mesh.vertexFaces(5)]).toThrow('corrupt');
    mesh.connectivity.toVertex.fill(-7);
    expect(() => [...mesh.vertexVertices(5)]).toThrow('corrupt');
  });
});

describe('The endless form', () => {
  test('stands on a halfedge', () => {
    using mesh = build(quadGrid());
    const circulator = mesh.circulate('vertexFaces', 1, { direction: 'cw' });
    expect(mesh.face(circulator.halfedge)).toBe(0);
    expect(mesh.fromVertex(circulator.halfedge)).toBe(1);
    const { halfedge } = circulator;
    circulator.next();
    expect(circulator.halfedge).not.toBe(halfedge);
    expect(mesh.face(circulator.halfedge)).toBe(1);
  });

  test('moves to another item of its kind', () => {
    using mesh = build(triangleAndIsolatedVertex());
    for (const direction of directions) {
      const ring = mesh.circulate('vertexVertices', 3, { direction });
      expect(ring.current).toBe(NONE);
      for (const v of [0, 1, 2, 3, 0]) {
        expect(ring.moveTo(v)).toBe(ring);
        const fresh = mesh.circulate('vertexVertices', v, { direction });
        for (let i = 0; i < 5; i++) {
          expect([ring.halfedge, ring.current]).toEqual([fresh.halfedge, fresh.current]);
          expect(ring.next()).toBe(fresh.next());
        }
      }
      const start = mesh.findHalfedge(1, 2);
      expect(ring.moveTo(1, start).halfedge).toBe(start);
      expect(() => ring.moveTo(2, start)).toThrow(RangeError);
      expect(() => ring.moveTo(4)).toThrow('expected a vertex from 0 to 3');
    }
  });

  test('can move on after the connectivity has changed', () => {
    using mesh = build(quadGrid());
    const ring = mesh.circulate('vertexFaces', 0);
    changeConnectivity(mesh);
    expect(() => ring.current).toThrow('after the connectivity changed');
    expect(ring.moveTo(0).current).toBe(0);
  });

  test.each(['vertexOutgoingHalfedges', 'vertexFaces', 'faceVertices', 'edgeFaces'] as const)(
    '%s moves on in the views of after a change, and of after growth of the memory',
    (kind) => {
      using mesh = build(quadGrid());
      for (const direction of directions) {
        const ring = mesh.circulate(kind, 0, { direction });
        for (const disturb of [() => changeConnectivity(mesh), growMemory]) {
          disturb();
          for (const item of [5, 1, 8]) {
            ring.moveTo(item);
            const lap = [...range(mesh, kind)(item, direction)];
            const items = lap.map((_, i) => (i === 0 ? ring.current : ring.next()));
            expect([item, ...items]).toEqual([item, ...lap]);
            disturb();
            expect(() => ring.moveTo(48)).toThrow('expected a');
          }
        }
      }
    },
  );

  test('refuses an anchor that is out of range', () => {
    using mesh = build(quadGrid());
    mesh.connectivity.vertexHalfedge[5] = 999;
    const ring = mesh.circulate('vertexOutgoingHalfedges', 1, { direction: 'cw' });
    expect(() => ring.moveTo(5)).toThrow(expect.objectContaining({ code: 'corrupt-connectivity' }));
  });

  test('begins at a start', () => {
    using mesh = build(quadGrid());
    const start = mesh.findHalfedge(5, 1);
    for (const direction of directions) {
      expect(mesh.circulate('vertexVertices', 5, { direction, start }).current).toBe(1);
    }
  });

  test.each([
    [
      'one that is none',
      'vertexHoles',
      RangeError,
      'kind is "vertexHoles"; expected one of vertexVertices, ',
    ],
    ['a property of objects', 'constructor', RangeError, 'kind is "constructor"; expected one of'],
    ['no string', 7, TypeError, 'kind is 7; expected one of'],
  ])('refuses a kind that is %s', (_, kind, type, message) => {
    using mesh = build(quadGrid());
    const call = () => mesh.circulate(kind as CirculatorKind, 0);
    expect(call).toThrow(type);
    expect(call).toThrow(message);
  });
});

describe('A circulator', () => {
  const kinds = [...aroundVertices, ...aroundFaces, ...aroundEdges, 'halfedgeLoop'] as const;

  test.each(kinds)('%s refuses an item that is not there', (kind) => {
    using mesh = build(quadGrid());
    for (const item of [-1, 48, 0.5, Number.NaN, 2 ** 32]) {
      expect(() => range(mesh, kind)(item)).toThrow(RangeError);
      expect(() => mesh.circulate(kind, item)).toThrow(RangeError);
    }
    for (const item of ['0', null, undefined, {}, 1n, [0]]) {
      expect(() => range(mesh, kind)(item as number)).toThrow(TypeError);
      expect(() => mesh.circulate(kind, item as number)).toThrow(TypeError);
    }
  });

  test.each([...aroundVertices, ...aroundFaces, 'halfedgeLoop'] as const)(
    '%s refuses a direction that is none',
    (kind) => {
      using mesh = build(quadGrid());
      expect(() => range(mesh, kind)(0, 'left' as 'cw')).toThrow(
        new RangeError(`direction is "left"; expected 'ccw' or 'cw'.`),
      );
      expect(() => range(mesh, kind)(0, 5 as never)).toThrow(TypeError);
      expect(() => mesh.circulate(kind, 0, { direction: null as never })).toThrow(TypeError);
    },
  );

  test.each(aroundVertices)('%s refuses a start that is not at the vertex', (kind) => {
    using mesh = build(quadGrid());
    const start = mesh.findHalfedge(4, 0);
    expect(() => range(mesh, kind)(1, 'cw', start)).toThrow(
      new RangeError(
        kind === 'vertexIncomingHalfedges'
          ? `start is halfedge ${start}, which goes from vertex 4 to 0; expected one that arrives at vertex 1.`
          : `start is halfedge ${start}, which leaves vertex 4; expected one that leaves vertex 1.`,
      ),
    );
    expect(() => range(mesh, kind)(0, 'cw', 48)).toThrow(
      'start is 48; expected a halfedge from 0 to 47.',
    );
    expect(() => range(mesh, kind)(0, 'cw', null as never)).toThrow(TypeError);
    expect(() => mesh.circulate(kind, 1, { start })).toThrow(RangeError);
  });

  test.each(aroundFaces)('%s refuses a start that does not lie in the face', (kind) => {
    using mesh = build(quadGrid());
    const inner = mesh.findHalfedge(0, 1);
    expect(() => range(mesh, kind)(1, 'cw', inner)).toThrow(
      new RangeError(
        `start is halfedge ${inner}, which lies in face 0; expected one that lies in face 1.`,
      ),
    );
    expect(() => range(mesh, kind)(0, 'cw', mesh.opposite(inner))).toThrow('which lies in no face');
  });

  test.each([...aroundEdges, 'halfedgeLoop'] as const)('%s refuses a start in options', (kind) => {
    using mesh = build(quadGrid());
    expect(() => mesh.circulate(kind, 0, { start: 1 })).toThrow(RangeError);
    expect(() => mesh.circulate(kind, 0, { start: 1 })).toThrow(
      /^start is 1; expected none, because/,
    );
  });

  test('goes on after growth of the memory', () => {
    using mesh = build(quadGrid());
    const seen: number[] = [];
    for (const v of mesh.vertexVertices(5)) {
      growMemory();
      seen.push(v);
    }
    expect(seen).toEqual([9, 4, 1, 6]);
    const circulator = mesh.circulate('vertexVertices', 5);
    const walked = [circulator.current];
    for (let i = 0; i < 4; i++) {
      growMemory();
      walked.push(circulator.next());
    }
    expect(walked).toEqual([9, 4, 1, 6, 9]);
    growMemory();
    expect(circulator.prev()).toBe(6);
    growMemory();
    expect([...mesh.vertices()]).toHaveLength(16);
    let count = 0;
    for (const _ of mesh.faces()) {
      growMemory();
      count += 1;
    }
    expect(count).toBe(9);
  });

  test('throws when its mesh was disposed of', () => {
    const mesh = build(quadGrid());
    const circulator = mesh.circulate('vertexVertices', 5);
    const ranges = [mesh.vertexVertices(5), mesh.vertexFaces(5), mesh.faces()];
    const underway = ranges.map((items) => items[Symbol.iterator]());
    mesh.dispose();
    for (const use of [
      ...ranges.map((items) => () => [...items]),
      ...ranges.map((items) => () => items.toArray()),
      ...underway.map((iterator) => () => iterator.next()),
      () => mesh.vertexVertices(5),
      () => mesh.vertices(),
      () => mesh.circulate('vertexVertices', 5),
      () => circulator.next(),
      () => circulator.prev(),
      () => circulator.current,
    ]) {
      expect(use).toThrow('This mesh was disposed');
    }
  });
});
