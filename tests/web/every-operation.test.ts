import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { Vector2, Vector3 } from 'three';
import { growMemory } from './support/core.js';
import { stateOf } from './support/editing.js';
import { annulus, build, quadGrid } from './support/meshes.js';
import { edit } from './support/random-edits.js';

beforeAll(() => init());

const octahedron = () => HalfedgeMesh.octahedron();

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
    const h = mesh.findHalfedge(14, 15);
    const deleted = { v: 15, e: mesh.edge(h), h, f: 8 };
    mesh.deleteVertex(15); // face 8, edges, and their halfedges
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

  test('there is a check of it', () => {
    using mesh = octahedron();
    const names = [
      ...Object.keys(operations),
      'addVertex',
      'addFace',
      'deleteComponent',
      'compact',
      'reorder',
    ];
    names.push(
      'cutPath',
      'cutEdges',
      'splitLoop',
      'reverse',
      'dual',
      'append',
      'makeLoop',
      'makeSegment',
    );
    names.push('deleteIsolatedVertices', 'keepLargestComponents');
    const checks = names.map((name) => `check${name[0].toUpperCase()}${name.slice(1)}`);
    const missing = checks.filter((check) => !(check in mesh) && check !== 'checkSetPosition');
    expect(missing).toEqual([]);
    const { version } = mesh;
    expect(mesh.checkAddVertex([0, 1, 2])).toBeNull();
    expect(mesh.checkDeleteComponent('edge', 3)).toBeNull();
    expect(mesh.checkCompact()).toBeNull();
    expect(mesh.checkReorder('breadth-first')).toBeNull();
    expect(mesh.checkCutEdges([])).toBeNull();
    expect(mesh.checkReverse()).toBeNull();
    expect(mesh.checkReverseComponent(5)).toBeNull();
    expect(mesh.checkMakeLoop()).toBeNull();
    expect(mesh.checkMakeSegment()).toBeNull();
    expect(mesh.checkDeleteIsolatedVertices()).toBeNull();
    expect(mesh.checkKeepLargestComponents()).toBeNull();
    expect(mesh.checkAppend(mesh)).toBeNull();
    expect(mesh.version).toBe(version);
    expect(() => mesh.checkKeepLargestComponents(-1)).toThrow('count is -1; expected an integer');
    expect(() => mesh.checkAppend({} as never)).toThrow('other is an Object; expected a Halfedge');
    expect(() => mesh.checkDeleteComponent('loop' as never, 0)).toThrow('kind is "loop"');
    expect(() => mesh.checkDeleteComponent('edge', 12)).toThrow('item is 12; expected an edge');
    expect(() => mesh.checkReorder('hilbert' as never)).toThrow('order is "hilbert"; expected');
    mesh.dispose();
    expect(() => mesh.checkCompact()).toThrow(/disposed/);
    expect(() => mesh.checkReverse()).toThrow(/disposed/);
    expect(() => mesh.checkMakeLoop()).toThrow(/disposed/);
    expect(() => mesh.checkAppend(mesh)).toThrow(/disposed/);
  });

  test('the check of append tells of the mesh that would be added', () => {
    using mesh = octahedron();
    using other = octahedron();
    other.connectivity.next[0] = 99;
    const before = stateOf(mesh);
    const refusal = mesh.checkAppend(other);
    expect(refusal).toMatchObject({ code: 'corrupt-connectivity' });
    expect(() => mesh.append(other)).toThrow(refusal?.message);
    expect(stateOf(mesh)).toEqual(before);
  });

  const positioned = ['addVertex', 'splitEdge', 'insertVertexOnEdge', 'splitFace', 'collapse'];

  test.each([...positioned, 'setPosition'])('%s refuses what is no position', (name) => {
    using mesh = octahedron();
    const before = stateOf(mesh);
    const bad: [unknown, ErrorConstructor, string][] = [
      [[0, Number.NaN, 0], RangeError, 'position[1] is NaN; expected a finite number'],
      [[Infinity, 0, 0], RangeError, 'position[0] is Infinity'],
      [[0, 0, 1e39], RangeError, 'position[2] is 1e+39; expected a finite number that fits'],
      [[0, 0], RangeError, 'position is an array of 2 elements; expected three numbers'],
      [[0, 0, '0'], TypeError, 'position[2] is "0"'],
      [{ x: 1 }, TypeError, 'position is an Object; expected three numbers, x, y and z.'],
      [null, TypeError, 'position is null'],
    ];
    if (name === 'setPosition') bad.push([undefined, TypeError, 'position is undefined; expected']);
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

  test.each([...positioned, 'setPosition'])('%s takes a vector of three.js', (name) => {
    using mesh = octahedron();
    using same = octahedron();
    const at = (place: unknown) => (name === 'addVertex' ? [place] : [0, place]);
    edit(mesh, name, at(new Vector3(0.5, 1, 2))).run();
    edit(same, name, at([0.5, 1, 2])).run();
    expect(stateOf(mesh)).toEqual(stateOf(same));
    using other = octahedron();
    expect(edit(other, name, at(new Vector2(0.5, 1))).run).toThrow(
      /^position is an array of 2 elements; expected three numbers, x, y and z/,
    );
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
