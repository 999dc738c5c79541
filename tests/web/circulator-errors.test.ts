import { type HalfedgeMesh, init, NONE } from 'halfedge';
import {
  aroundEdges,
  aroundFaces,
  aroundVertices,
  directions,
  range,
} from './support/circulators.js';
import { changeConnectivity, growMemory } from './support/core.js';
import { build, quadGrid } from './support/meshes.js';

beforeAll(() => init());

describe('After the connectivity has changed,', () => {
  const sentence =
    'This circulator was used after the connectivity changed under it; expected a new one.';
  const use: [string, (mesh: HalfedgeMesh, change: () => void) => unknown][] = [
    ...[...aroundVertices, ...aroundFaces].flatMap((kind) =>
      directions.map((direction): [string, (mesh: HalfedgeMesh, change: () => void) => unknown] => [
        `the next step of a loop (${kind}, ${direction})`,
        (mesh, change) => {
          for (const _ of mesh[kind](4, direction)) change();
        },
      ]),
    ),
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
    [
      'filling a buffer from an edge',
      (mesh, change) => {
        const ends = mesh.edgeVertices(5);
        change();
        return ends.into(new Int32Array(2));
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
  test.each(corruptions)('(%s) a loop sees no item that is none', (_, corrupt) => {
    using mesh = build(quadGrid());
    corrupt(mesh.connectivity as never, mesh.vertexHalfedge(5));
    for (const kind of aroundVertices) {
      for (const direction of directions) {
        const seen: number[] = [];
        expect(() => {
          for (const item of mesh[kind](5, direction)) seen.push(item);
        }).toThrow(expect.objectContaining({ code: 'corrupt-connectivity' }));
        const sound = seen.filter((i) => Number.isInteger(i) && i >= 0 && i < mesh.halfedgeSlots);
        expect(seen).toEqual(sound);
      }
    }
  });

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

  const open = corruptions.filter(([name]) => name !== 'a cycle that misses the anchor');
  test.each(open)('(%s) a buffer is left alone past what a lap reached', (_, corrupt) => {
    using mesh = build(quadGrid());
    corrupt(mesh.connectivity as never, mesh.vertexHalfedge(5));
    for (const kind of aroundVertices) {
      for (const direction of directions) {
        const buffer = new Int32Array(100).fill(12345);
        expect(() => mesh[kind](5, direction).into(buffer)).toThrow('corrupt');
        expect([...buffer.subarray(mesh.halfedgeSlots)].every((item) => item === 12345)).toBe(true);
      }
    }
  });

  test('a lap without any face that does not close ends', () => {
    using mesh = build(quadGrid());
    const { face, next, prev } = mesh.connectivity;
    face.fill(NONE);
    for (const links of [next, prev]) links.fill(7);
    for (const direction of directions) {
      expect(() => mesh.vertexFaces(5, direction).into(new Int32Array(9))).toThrow('corrupt');
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
    for (const direction of directions) {
      expect(() => mesh.vertexVertices(5, direction).into(new Int32Array(9))).toThrow('corrupt');
    }
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
      expect(() => mesh.circulate(kind, 0, 'left' as 'cw')).toThrow(
        new RangeError(`direction is "left"; expected 'ccw' or 'cw'.`),
      );
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
