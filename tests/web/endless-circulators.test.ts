import { type CirculatorKind, init, NONE } from 'halfedge';
import { aroundFaces, aroundVertices, directions, range } from './support/circulators.js';
import { changeConnectivity, growMemory, moveArrays } from './support/core.js';
import { annulus, build, quadGrid, triangleAndIsolatedVertex } from './support/meshes.js';

beforeAll(() => init());

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

  test('moves to faces with few neighbours', () => {
    // Faces 0 and 2 have one, face 1: beyond each of the sides of face 0 in turn.
    for (const corners of [3, 4, 6]) {
      const round = Array.from({ length: corners }, (_, i) => i);
      for (const turned of round) {
        const face = round.map((i) => (i + turned) % corners);
        using mesh = build({
          positions: [...round, corners, corners + 1].flatMap((i) => [i, i * i, 0]),
          faces: [face, [1, 0, corners], [corners, 0, corners + 1]],
        });
        for (const direction of directions) {
          const ring = mesh.circulate('faceFaces', 2, direction);
          for (const f of [0, 2, 0]) {
            expect(ring.moveTo(f).current).toBe(1);
            expect(mesh.face(ring.halfedge)).toBe(f);
            expect(mesh.face(mesh.opposite(ring.halfedge))).toBe(1);
            expect([ring.next(), ring.prev()]).toEqual([1, 1]);
          }
        }
      }
    }
  });

  test.each(directions)(
    'refuses all but moveTo after the connectivity has changed: %s',
    (direction) => {
      const kinds = [
        'vertexVertices',
        'vertexFaces',
        'vertexEdges',
        'faceFaces',
        'edgeFaces',
      ] as const;
      for (const kind of kinds) {
        using mesh = build(quadGrid());
        const ring = mesh.circulate(kind, 4, direction);
        changeConnectivity(mesh);
        const uses = [
          () => ring.current,
          () => ring.halfedge,
          () => ring.next(),
          () => ring.prev(),
        ];
        for (const use of uses) expect(use).toThrow('after the connectivity changed');
        expect(ring.moveTo(4).halfedge).toBe(mesh.circulate(kind, 4, direction).halfedge);
      }
    },
  );

  test.each(directions)(
    'goes by the links of now, once the mesh has outgrown its arrays: %s',
    (direction) => {
      using mesh = build(quadGrid());
      const rings = (['vertexVertices', 'vertexFaces', 'vertexEdges'] as const).map((kind) => ({
        kind,
        ring: mesh.circulate(kind, 4, direction),
      }));
      for (let i = 0; i < 1000; i++) mesh.addVertex([i, 0, 0]);
      mesh.deleteVertex(0);
      for (const { kind, ring } of rings) {
        expect(() => ring.moveTo(0)).toThrow('v is vertex 0, which was deleted');
        ring.moveTo(8);
        const lap = [...mesh[kind](8, direction)] as number[];
        expect(lap.map((_, i) => (i === 0 ? ring.current : ring.next()))).toEqual(lap);
      }
    },
  );

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

  test.each([...aroundVertices, ...aroundFaces])(
    '%s goes by the arrays of now, once `reserve` has moved them',
    (kind) => {
      using mesh = build(quadGrid(30, 30));
      const rings = directions.map((direction) => ({
        direction,
        ring: mesh.circulate(kind, 0, direction),
      }));
      moveArrays(mesh);
      for (const { direction, ring } of rings) {
        const lap = [...range(mesh, kind)(200, direction)];
        for (const moved of [ring.moveTo(200), mesh.circulate(kind, 200, direction)]) {
          expect(lap.map((_, i) => (i === 0 ? moved.current : moved.next()))).toEqual(lap);
        }
      }
    },
  );

  test.each([...aroundVertices, ...aroundFaces])('%s begins where a lap begins', (kind) => {
    using mesh = build(annulus());
    const items = kind.startsWith('vertex') ? mesh.vertexCount : mesh.faceCount;
    for (const direction of directions) {
      for (let item = 0; item < items; item++) {
        const lap = [...range(mesh, kind)(item, direction)];
        const made = mesh.circulate(kind, item, direction);
        const moved = mesh.circulate(kind, 0, { direction }).moveTo(item);
        expect([made.current, moved.current]).toEqual([lap[0], lap[0]]);
        expect(moved.halfedge).toBe(made.halfedge);
        expect(lap.map((_, i) => (i === 0 ? made.current : made.next()))).toEqual(lap);
        expect(made.next()).toBe(lap[0]);
        expect(made.current).toBe(lap[0]);
        expect(made.prev()).toBe(lap.at(-1));
        expect(made.current).toBe(lap.at(-1));
      }
    }
  });

  test.each(aroundVertices)('%s moves to an isolated vertex, and on', (kind) => {
    using mesh = build(triangleAndIsolatedVertex());
    const isolated = mesh.vertexSlots - 1;
    for (const direction of directions) {
      for (const ring of [
        mesh.circulate(kind, isolated, direction),
        mesh.circulate(kind, 0, direction).moveTo(isolated),
      ]) {
        expect([ring.current, ring.halfedge, ring.next(), ring.prev()]).toEqual([-1, -1, -1, -1]);
        expect([ring.current, ring.halfedge]).toEqual([-1, -1]);
        const fresh = mesh.circulate(kind, 1, direction);
        expect(ring.moveTo(1).current).toBe(fresh.current);
        expect(ring.halfedge).toBe(fresh.halfedge);
      }
    }
  });

  test.each(directions)('refuses an anchor that is out of range: %s', (direction) => {
    using mesh = build(quadGrid());
    mesh.connectivity.vertexHalfedge[5] = 999;
    for (const kind of ['vertexOutgoingHalfedges', 'vertexVertices'] as const) {
      const ring = mesh.circulate(kind, 1, { direction });
      expect(() => ring.moveTo(5)).toThrow(
        expect.objectContaining({ code: 'corrupt-connectivity' }),
      );
    }
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
    [
      'one that is longer than all',
      'vertexOutgoingHalfedgesOf',
      RangeError,
      'kind is "vertexOutgoingHalfedgesOf"; expected one of',
    ],
    ['a property of objects', 'constructor', RangeError, 'kind is "constructor"; expected one of'],
    ['no string', 7, TypeError, 'kind is 7; expected one of'],
    ['a list with one', ['vertexFaces'], TypeError, 'kind is an array of 1 element; expected one'],
  ])('refuses a kind that is %s', (_, kind, type, message) => {
    using mesh = build(quadGrid());
    const call = () => mesh.circulate(kind as CirculatorKind, 0);
    expect(call).toThrow(type);
    expect(call).toThrow(message);
  });
});
