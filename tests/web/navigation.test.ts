import { HalfedgeError, HalfedgeMesh, init, NONE } from 'halfedge';
import { growMemory } from './support/core.js';
import {
  bowTie,
  build,
  pillow,
  quadGrid,
  randomPolygons,
  tetrahedron,
  triangleAndIsolatedVertex,
} from './support/meshes.js';
import { Reference } from './support/reference.js';

beforeAll(() => init());

describe('The links', () => {
  test('of a grid are those of its quads', () => {
    using mesh = build(quadGrid());
    expect(mesh.vertexCount).toBe(16);
    expect(mesh.edgeCount).toBe(24);
    expect(mesh.halfedgeCount).toBe(48);
    expect(mesh.faceCount).toBe(9);
    expect([mesh.vertexSlots, mesh.edgeSlots, mesh.halfedgeSlots, mesh.faceSlots]).toEqual([
      16, 24, 48, 9,
    ]);
    const h = mesh.findHalfedge(0, 1);
    expect(mesh.fromVertex(h)).toBe(0);
    expect(mesh.toVertex(h)).toBe(1);
    expect(mesh.face(h)).toBe(0);
    expect(mesh.toVertex(mesh.next(h))).toBe(5);
    expect(mesh.fromVertex(mesh.prev(h))).toBe(4);
    expect(mesh.face(mesh.opposite(h))).toBe(NONE);
    expect(mesh.edge(h)).toBe(mesh.edge(mesh.opposite(h)));
    expect(mesh.findHalfedge(0, 5)).toBe(NONE);
    expect(mesh.findEdge(0, 5)).toBe(NONE);
    expect(mesh.findEdge(1, 0)).toBe(mesh.edge(h));
    expect(mesh.toVertex(mesh.faceHalfedge(0))).toBe(0);
    expect(mesh.edgeHalfedge(mesh.edge(h), 0) ^ mesh.edgeHalfedge(mesh.edge(h), 1)).toBe(1);
    expect(mesh.edgeHalfedge(3)).toBe(6);
    expect(mesh.isBoundaryEdge(mesh.edge(h))).toBe(true);
    expect(mesh.isBoundaryHalfedge(h)).toBe(false);
    expect(mesh.isBoundaryHalfedge(mesh.opposite(h))).toBe(true);
    expect(mesh.isBoundaryVertex(0)).toBe(true);
    expect(mesh.isBoundaryVertex(5)).toBe(false);
    expect(mesh.isBoundaryFace(0)).toBe(true);
    expect(mesh.isBoundaryFace(4)).toBe(false);
    expect(mesh.valence(0)).toBe(2);
    expect(mesh.valence(5)).toBe(4);
    expect(mesh.degree(4)).toBe(4);
  });

  test('of a closed mesh have no boundary', () => {
    using mesh = build(tetrahedron());
    for (let h = 0; h < mesh.halfedgeCount; h++) expect(mesh.isBoundaryHalfedge(h)).toBe(false);
    for (let v = 0; v < 4; v++) expect(mesh.isBoundaryVertex(v)).toBe(false);
    for (let e = 0; e < 6; e++) expect(mesh.isBoundaryEdge(e)).toBe(false);
  });

  test('between hubs and their neighbours are found from either side', () => {
    const n = 40_000;
    const faces = Array.from({ length: n }, (_, i) => [0, 1 + i, 1 + ((i + 1) % n)]);
    using mesh = HalfedgeMesh.fromFaces(faces);
    // Around the hub alone these would be more than a thousand million steps.
    for (let v = 1; v <= n; v++) {
      const h = mesh.findHalfedge(0, v);
      if (h === NONE || mesh.fromVertex(h) !== 0 || mesh.toVertex(h) !== v) fail(0, v, h);
      if (mesh.findHalfedge(v, 0) !== mesh.opposite(h)) fail(v, 0, mesh.findHalfedge(v, 0));
    }
    expect(mesh.findHalfedge(1, 3)).toBe(NONE);
    function fail(from: number, to: number, found: number): never {
      throw new Error(`the halfedge from ${from} to ${to} is not ${found}`);
    }
  });

  test('tell an isolated vertex from the others', () => {
    using mesh = build(triangleAndIsolatedVertex());
    expect(mesh.isIsolatedVertex(3)).toBe(true);
    expect(mesh.isIsolatedVertex(0)).toBe(false);
    expect(mesh.vertexHalfedge(3)).toBe(NONE);
    expect(mesh.valence(3)).toBe(0);
    expect(mesh.isBoundaryVertex(3)).toBe(true);
    expect(mesh.isManifoldVertex(3)).toBe(true);
    expect(mesh.findHalfedge(3, 0)).toBe(NONE);
    expect(mesh.findHalfedge(0, 3)).toBe(NONE);
  });

  test('tell live items from deleted ones, and from what was never there', () => {
    using mesh = HalfedgeMesh.octahedron();
    mesh.history.enabled = true;
    const kinds = [
      ['isLiveVertex', () => mesh.vertices()],
      ['isLiveHalfedge', () => mesh.halfedges()],
      ['isLiveEdge', () => mesh.edges()],
      ['isLiveFace', () => mesh.faces()],
    ] as const;
    const none = [NONE, 30, 0.5, Number.NaN, -0.5, -2, 2 ** 32, Infinity];
    const expectThese = () => {
      for (const [isLive, items] of kinds) {
        const found = [...Array(30).keys()].filter((i) => mesh[isLive](i));
        expect([isLive, found]).toEqual([isLive, items().toArray()]);
        expect([isLive, none.filter((i) => mesh[isLive](i))]).toEqual([isLive, []]);
      }
    };
    expectThese();
    mesh.deleteVertex(2);
    expect(mesh.isLiveVertex(2)).toBe(false);
    expectThese();
    mesh.history.undo();
    expectThese();
    mesh.collapse(0);
    growMemory();
    expectThese();
    mesh.compact();
    expectThese();
    mesh.clear();
    expectThese();
    expect(() => mesh.isLiveEdge('0' as never)).toThrow(
      new TypeError('e is "0"; expected an edge, which is an integer.'),
    );
    mesh.dispose();
    expect(() => mesh.isLiveFace(0)).toThrow(/disposed/);
  });

  test('let a loop that edits pass over what earlier steps have deleted', () => {
    using mesh = HalfedgeMesh.icoSphere(2);
    let collapsed = 0;
    for (const e of mesh.edges().toArray()) {
      if (!mesh.isLiveEdge(e)) continue;
      const h = mesh.edgeHalfedge(e);
      if (mesh.checkCollapse(h) !== null) continue;
      mesh.collapse(h);
      collapsed += 1;
    }
    expect(collapsed).toBeGreaterThan(100);
    expect(mesh.validate()).toEqual([]);
  });

  test('tell a pinched vertex from the others', () => {
    using mesh = build(bowTie());
    expect(mesh.isManifoldVertex(2)).toBe(false);
    expect(mesh.isManifoldVertex(0)).toBe(true);
    expect(mesh.valence(2)).toBe(4);
  });

  test('of a pillow join its two faces along all three edges', () => {
    using mesh = build(pillow());
    expect(mesh.edgeCount).toBe(3);
    for (let h = 0; h < 6; h++) expect(mesh.face(mesh.opposite(h))).toBe(1 - mesh.face(h));
  });

  test.each([1, 2, 3, 4, 5, 6, 7, 8])(
    'keep their invariants and match the faces (seed %i)',
    (seed) => {
      const input = randomPolygons(seed);
      using mesh = build(input);
      const reference = new Reference(input);
      expect(mesh.vertexCount).toBe(reference.vertexCount);
      expect(mesh.edgeCount).toBe(reference.edgeCount());
      expect(mesh.faceCount).toBe(input.faces.length);
      for (let h = 0; h < mesh.halfedgeSlots; h++) {
        const [from, to] = [mesh.fromVertex(h), mesh.toVertex(h)];
        expect(mesh.face(h)).toBe(reference.faceOf(from, to));
        expect(mesh.opposite(h)).toBe(h ^ 1);
        expect(mesh.edge(h)).toBe(h >> 1);
        expect(mesh.prev(mesh.next(h))).toBe(h);
        expect(mesh.fromVertex(mesh.next(h))).toBe(to);
        expect(mesh.face(mesh.next(h))).toBe(mesh.face(h));
        expect(mesh.rotateCw(h)).toBe(mesh.next(mesh.opposite(h)));
        expect(mesh.rotateCcw(h)).toBe(mesh.opposite(mesh.prev(h)));
        expect(mesh.nextOnVertex(h)).toBe(mesh.opposite(mesh.next(h)));
        expect(mesh.prevOnVertex(h)).toBe(mesh.prev(mesh.opposite(h)));
        expect(mesh.findHalfedge(from, to)).toBe(h);
        expect(mesh.findEdge(from, to)).toBe(h >> 1);
      }
      for (let v = 0; v < mesh.vertexSlots; v++) {
        const spokes = reference.spokesCw(v);
        const gaps = spokes.filter(({ face }) => face < 0).length;
        expect(mesh.valence(v)).toBe(spokes.length);
        expect(mesh.isBoundaryVertex(v)).toBe(gaps > 0 || spokes.length === 0);
        expect(mesh.isManifoldVertex(v)).toBe(gaps <= 1);
        if (spokes.length > 0) expect(mesh.toVertex(mesh.vertexHalfedge(v))).toBe(spokes[0].to);
      }
      input.faces.forEach((face, f) => {
        expect(mesh.degree(f)).toBe(face.length);
        const onBoundary = reference.sidesCcw(f).some(([a, b]) => reference.faceOf(b, a) < 0);
        expect(mesh.isBoundaryFace(f)).toBe(onBoundary);
      });
    },
  );
});

describe('A wrong index', () => {
  type Call = (mesh: HalfedgeMesh, index: number) => unknown;
  const calls: Record<string, [argument: string, kind: string, slots: number, call: Call]> = {
    next: ['h', 'halfedge', 48, (mesh, h) => mesh.next(h)],
    prev: ['h', 'halfedge', 48, (mesh, h) => mesh.prev(h)],
    opposite: ['h', 'halfedge', 48, (mesh, h) => mesh.opposite(h)],
    edge: ['h', 'halfedge', 48, (mesh, h) => mesh.edge(h)],
    face: ['h', 'halfedge', 48, (mesh, h) => mesh.face(h)],
    toVertex: ['h', 'halfedge', 48, (mesh, h) => mesh.toVertex(h)],
    fromVertex: ['h', 'halfedge', 48, (mesh, h) => mesh.fromVertex(h)],
    rotateCcw: ['h', 'halfedge', 48, (mesh, h) => mesh.rotateCcw(h)],
    rotateCw: ['h', 'halfedge', 48, (mesh, h) => mesh.rotateCw(h)],
    nextOnVertex: ['h', 'halfedge', 48, (mesh, h) => mesh.nextOnVertex(h)],
    prevOnVertex: ['h', 'halfedge', 48, (mesh, h) => mesh.prevOnVertex(h)],
    isBoundaryHalfedge: ['h', 'halfedge', 48, (mesh, h) => mesh.isBoundaryHalfedge(h)],
    vertexHalfedge: ['v', 'vertex', 16, (mesh, v) => mesh.vertexHalfedge(v)],
    isBoundaryVertex: ['v', 'vertex', 16, (mesh, v) => mesh.isBoundaryVertex(v)],
    isIsolatedVertex: ['v', 'vertex', 16, (mesh, v) => mesh.isIsolatedVertex(v)],
    isManifoldVertex: ['v', 'vertex', 16, (mesh, v) => mesh.isManifoldVertex(v)],
    valence: ['v', 'vertex', 16, (mesh, v) => mesh.valence(v)],
    'findHalfedge from': ['a', 'vertex', 16, (mesh, v) => mesh.findHalfedge(v, 0)],
    'findHalfedge to': ['b', 'vertex', 16, (mesh, v) => mesh.findHalfedge(0, v)],
    'findEdge from': ['a', 'vertex', 16, (mesh, v) => mesh.findEdge(v, 0)],
    edgeHalfedge: ['e', 'edge', 24, (mesh, e) => mesh.edgeHalfedge(e)],
    isBoundaryEdge: ['e', 'edge', 24, (mesh, e) => mesh.isBoundaryEdge(e)],
    faceHalfedge: ['f', 'face', 9, (mesh, f) => mesh.faceHalfedge(f)],
    isBoundaryFace: ['f', 'face', 9, (mesh, f) => mesh.isBoundaryFace(f)],
    degree: ['f', 'face', 9, (mesh, f) => mesh.degree(f)],
  };

  describe.each(Object.entries(calls))('for %s', (_, [argument, kind, slots, call]) => {
    const article = kind === 'edge' ? 'an' : 'a';
    let mesh: HalfedgeMesh;
    beforeAll(() => {
      mesh = build(quadGrid());
    });
    afterAll(() => mesh.dispose());

    test.each([
      -1,
      -2,
      0.5,
      1.5,
      Number.NaN,
      Infinity,
      -Infinity,
      2 ** 31,
      2 ** 32,
      2 ** 32 + 1,
      1e300,
      -(2 ** 31),
      5e-324,
    ])('of %d is a RangeError that says so', (index) => {
      const message = `${argument} is ${index}; expected ${article} ${kind} from 0 to ${slots - 1}.`;
      expect(() => call(mesh, index)).toThrow(new RangeError(message));
      expect(() => call(mesh, index)).toThrow(RangeError);
    });

    test('just out of range is a RangeError, the last one is not', () => {
      expect(() => call(mesh, slots)).toThrow(RangeError);
      expect(() => call(mesh, slots + 1)).toThrow(RangeError);
      expect(() => call(mesh, slots - 1)).not.toThrow();
    });

    test.each([
      ['a string', '5'],
      ['the name of a property', 'length'],
      ['undefined', undefined],
      ['null', null],
      ['a boolean', true],
      ['an array', [1]],
      ['an object', { valueOf: () => 1 }],
      ['a bigint', 1n],
    ])('that is %s is a TypeError', (_what, value) => {
      expect(() => call(mesh, value as number)).toThrow(TypeError);
      expect(() => call(mesh, value as number)).toThrow(
        `expected ${article} ${kind}, which is an integer`,
      );
    });
  });

  test('for a side of an edge names the sides', () => {
    using mesh = build(quadGrid());
    expect(() => mesh.edgeHalfedge(0, 2 as 1)).toThrow('side is 2; expected 0 or 1.');
    expect(() => mesh.edgeHalfedge(0, '1' as unknown as 1)).toThrow(TypeError);
  });

  test('in an empty mesh says that there is none', () => {
    using mesh = new HalfedgeMesh();
    expect(() => mesh.next(0)).toThrow('h is 0; expected a halfedge, but this mesh has none.');
    expect(mesh.vertexCount + mesh.halfedgeCount + mesh.faceCount).toBe(0);
    expect(mesh.validate()).toEqual([]);
  });
});

describe('A disposed mesh', () => {
  test('throws whatever it is asked, and can be disposed again', () => {
    const mesh = build(quadGrid());
    expect(mesh.disposed).toBe(false);
    mesh.dispose();
    mesh.dispose();
    expect(mesh.disposed).toBe(true);
    const names = Object.getOwnPropertyNames;
    const asked = new Set<string>();
    for (let at = Object.getPrototypeOf(mesh); at !== Object.prototype; ) {
      for (const name of names(at)) {
        if (['constructor', 'dispose', 'disposed'].includes(name) || asked.has(name)) continue;
        asked.add(name);
        let thrown: unknown;
        try {
          const member = Reflect.get(at, name, mesh);
          // Kinds for those that take one; 0 is an item of each kind.
          if (name === 'circulate') member.call(mesh, 'vertexVertices', 0);
          else if (typeof member === 'function')
            member.call(
              mesh,
              ...(name === 'validate' ? [] : [0, 0].slice(0, Math.min(member.length, 2))),
            );
        } catch (error) {
          thrown = error;
        }
        expect([name, (thrown as HalfedgeError)?.code]).toEqual([name, 'disposed']);
        expect(thrown).toBeInstanceOf(HalfedgeError);
      }
      at = Object.getPrototypeOf(at);
    }
    expect(asked.size).toBeGreaterThan(50);
  });
});
