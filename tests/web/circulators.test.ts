import { type CirculatorKind, type Direction, HalfedgeMesh, init, NONE, type Rows } from 'halfedge';
import { growMemory } from './support/core.js';
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

  test.each(aroundVertices)('%s refuses a start that does not leave the vertex', (kind) => {
    using mesh = build(quadGrid());
    const start = mesh.findHalfedge(0, 1);
    expect(() => range(mesh, kind)(1, 'cw', start)).toThrow(
      new RangeError(
        `start is halfedge ${start}, which leaves vertex 0; expected one that leaves vertex 1.`,
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
    mesh.dispose();
    for (const use of [
      () => circulator.next(),
      () => circulator.prev(),
      () => circulator.current,
    ]) {
      expect(use).toThrow('This mesh was disposed');
    }
  });
});
