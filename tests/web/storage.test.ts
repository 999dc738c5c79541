import { type Direction, HalfedgeMesh, init, NONE } from 'halfedge';
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

const inputs: [string, Input][] = [
  ['a tetrahedron', tetrahedron()],
  ['a grid of quads', quadGrid()],
  ['a pinched vertex', bowTie()],
  ['a pillow', pillow()],
  ['an isolated vertex', triangleAndIsolatedVertex()],
  ...[1, 2, 3, 4, 5].map((seed): [string, Input] => [`seed ${seed}`, randomPolygons(seed)]),
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

const both = ({ positions, faces }: Input) => ({
  whole: HalfedgeMesh.fromPolygons(positions, faces),
  mesh: HalfedgeMesh.fromPolygons(positions, faces, { storePrev: false }),
});

describe.each(inputs)('Without prev, %s', (_, input) => {
  let whole: HalfedgeMesh;
  let mesh: HalfedgeMesh;
  beforeAll(() => {
    ({ whole, mesh } = both(input));
  });

  test('answers every accessor as with it', () => {
    for (const h of whole.halfedges()) {
      expect(mesh.prev(h)).toBe(whole.prev(h));
      expect(mesh.rotateCcw(h)).toBe(whole.rotateCcw(h));
      expect(mesh.rotateCw(h)).toBe(whole.rotateCw(h));
      expect(mesh.prevOnVertex(h)).toBe(whole.prevOnVertex(h));
      expect(mesh.halfedgeLoop(h, 'cw').toArray()).toEqual(whole.halfedgeLoop(h, 'cw').toArray());
      expect(mesh.halfedgeLoop(h).toArray()).toEqual(whole.halfedgeLoop(h).toArray());
    }
    for (const e of whole.edges()) {
      expect(mesh.edgeVertices(e).toArray()).toEqual(whole.edgeVertices(e).toArray());
      expect(mesh.edgeFaces(e).toArray()).toEqual(whole.edgeFaces(e).toArray());
    }
  });

  test.each([...aroundVertices, ...aroundFaces])('shows the same %s', (kind) => {
    const isFace = kind.startsWith('face');
    const buffer = new Int32Array(mesh.halfedgeCount);
    const items: number[] = (isFace ? whole.faces() : whole.vertices()).toArray();
    for (const item of items) {
      const starts = isFace ? whole.faceHalfedges(item) : whole.vertexOutgoingHalfedges(item);
      for (const direction of directions) {
        for (const start of [undefined, ...starts.toArray()]) {
          const expected = whole[kind](item, direction, start).toArray() as number[];
          expect(mesh[kind](item, direction, start).toArray()).toEqual(expected);
          expect(mesh[kind](item, direction, start).into(buffer)).toBe(expected.length);
          expect([...buffer.subarray(0, expected.length)]).toEqual(expected);
        }
        const circulator = mesh.circulate(kind, item, { direction });
        const model = whole.circulate(kind, item, { direction });
        for (let i = 0; i < 5; i++) {
          expect(circulator.current).toBe(model.current);
          expect(circulator.next()).toBe(model.next());
        }
        for (let i = 0; i < 9; i++) expect(circulator.prev()).toBe(model.prev());
      }
    }
  });

  test('gives the same lists in one call, and the same numbers', () => {
    for (const direction of directions) {
      expect(mesh.allVertexVertices(direction)).toEqual(whole.allVertexVertices(direction));
      expect(mesh.allVertexFaces(direction)).toEqual(whole.allVertexFaces(direction));
      expect(mesh.allFaceVertices(direction)).toEqual(whole.allFaceVertices(direction));
      expect(mesh.allFaceFaces(direction)).toEqual(whole.allFaceFaces(direction));
    }
    expect(mesh.validate()).toEqual(whole.validate());
    expect(mesh.genus()).toBe(whole.genus());
    expect(mesh.components()).toEqual(whole.components());
    expect(mesh.boundaryLoops()).toEqual(whole.boundaryLoops());
    expect(mesh.toPolygons()).toEqual(whole.toPolygons());
  });
});

describe('The option storePrev', () => {
  test('leaves the array out, and its memory', () => {
    const { positions, faces } = quadGrid();
    const { mesh, whole } = both({ positions, faces });
    expect(mesh.connectivity.prev.length).toBe(0);
    expect(whole.connectivity.prev.length).toBe(whole.halfedgeCount);
    expect(mesh.connectivity.next).toEqual(whole.connectivity.next);
  });

  test('stays with clones, and is there for files and empty meshes', () => {
    using mesh = HalfedgeMesh.parse('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', {
      storePrev: false,
    }).mesh;
    using copy = mesh.clone();
    using empty = new HalfedgeMesh({ storePrev: false });
    for (const one of [mesh, copy, empty]) expect(one.connectivity.prev.length).toBe(0);
    expect(copy.prev(copy.next(0))).toBe(0);
    expect(empty.validate()).toEqual([]);
  });

  test('survives growth of the memory in the middle of a lap', () => {
    const { mesh, whole } = both(tetrahedron());
    const lap = mesh.vertexVertices(0)[Symbol.iterator]();
    const items: number[] = [lap.next().value];
    growMemory();
    for (let step = lap.next(); !step.done; step = lap.next()) items.push(step.value);
    expect(items).toEqual(whole.vertexVertices(0).toArray());
  });

  test('lets stale circulators and corrupt links be told', () => {
    const { mesh } = both(tetrahedron());
    const lap = mesh.vertexVertices(0)[Symbol.iterator]();
    lap.next();
    changeConnectivity(mesh);
    expect(() => lap.next()).toThrow(/connectivity changed/);

    const { mesh: broken } = both(tetrahedron());
    broken.connectivity.next.fill(1);
    expect(() => broken.prev(4)).toThrow(/corrupt/);
    expect(() => broken.vertexVertices(0).toArray()).toThrow(/corrupt/);
    broken.connectivity.next.fill(NONE);
    expect(() => broken.vertexVertices(0).toArray()).toThrow(/corrupt/);
  });

  test.each([0, 'no', null])('refuses %p', (storePrev) => {
    const options = { storePrev } as never;
    const sentence = /options\.storePrev is .*; expected true or false\./;
    expect(() => HalfedgeMesh.fromTriangles([], [], options)).toThrow(sentence);
    expect(() => HalfedgeMesh.fromPolygons([], [], options)).toThrow(sentence);
    expect(() => HalfedgeMesh.parse('', options)).toThrow(sentence);
    expect(() => new HalfedgeMesh(options)).toThrow(sentence);
  });
});
