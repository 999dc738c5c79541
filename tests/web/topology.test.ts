import { type Edge, HalfedgeMesh, init } from 'halfedge';
import {
  annulus,
  bowTie,
  build,
  type Input,
  pillow,
  puncturedTorus,
  quadGrid,
  randomPolygons,
  tetrahedron,
  torus,
  triangleAndIsolatedVertex,
} from './support/meshes.js';

beforeAll(() => init());

/** Two inputs side by side, sharing nothing. */
function together(a: Input, b: Input): Input {
  const first = a.positions.length / 3;
  const faces = [...a.faces, ...b.faces.map((face) => face.map((v) => v + first))];
  return { positions: [...a.positions, ...b.positions], faces };
}

describe('Topology numbers', () => {
  const shapes: [string, Input, euler: number, genus: number, loops: number][] = [
    ['a disk', quadGrid(), 1, 0, 1],
    ['an annulus', annulus(), 0, 0, 2],
    ['a torus', torus(), 0, 1, 0],
    ['a punctured torus', puncturedTorus(), -1, 1, 1],
    ['a sphere', tetrahedron(), 2, 0, 0],
    ['a pillow', pillow(), 2, 0, 0],
    ['two tori', together(torus(), torus()), 0, 2, 0],
    ['a torus and an annulus', together(torus(), annulus()), 0, 1, 2],
    ['nothing', { positions: [], faces: [] }, 0, 0, 0],
  ];
  test.each(shapes)('of %s', (_, input, euler, genus, loops) => {
    using mesh = build(input);
    expect(mesh.eulerCharacteristic()).toBe(euler);
    expect(mesh.genus()).toBe(genus);
    expect(mesh.boundaryLoops()).toHaveLength(loops);
    expect(mesh.validate()).toEqual([]);
    for (const h of mesh.boundaryLoops()) expect(mesh.isBoundaryHalfedge(h)).toBe(true);
  });
});

describe('Components', () => {
  test('are told apart with all their items', () => {
    using mesh = build(together(torus(5, 4), annulus(6)));
    const [a, b, ...others] = mesh.components();
    expect(others).toEqual([]);
    expect(a).toMatchObject({
      edgeCount: 40,
      eulerCharacteristic: 0,
      boundaryLoopCount: 0,
      genus: 1,
    });
    expect(Array.from(a.vertices)).toEqual(Array.from({ length: 20 }, (_, v) => v));
    expect(Array.from(a.faces)).toEqual(Array.from({ length: 20 }, (_, f) => f));
    expect(b).toMatchObject({
      edgeCount: 30,
      eulerCharacteristic: 0,
      boundaryLoopCount: 2,
      genus: 0,
    });
    expect(b.vertices[0]).toBe(20);
    expect(b.faces).toHaveLength(12);
  });

  test('hold together at a pinched vertex, and leave isolated vertices out', () => {
    using tie = build(bowTie());
    expect(tie.components()).toHaveLength(1);
    using lonely = build(triangleAndIsolatedVertex());
    expect(lonely.components().map(({ vertices }) => Array.from(vertices))).toEqual([[0, 1, 2]]);
  });

  test.each([41, 42, 43, 44])('agree with a flood over the faces (seed %i)', (seed) => {
    const input = randomPolygons(seed);
    using mesh = build(input);
    const label = Array.from({ length: input.positions.length / 3 }, (_, v) => v);
    for (let changed = true; changed; ) {
      changed = false;
      for (const face of input.faces) {
        const least = Math.min(...face.map((v) => label[v]));
        for (const v of face) {
          changed ||= label[v] !== least;
          label[v] = least;
        }
      }
    }
    const used = new Set(input.faces.flat());
    const expected = new Map<number, number[]>();
    for (const v of [...used].sort((a, b) => a - b)) {
      expected.set(label[v], [...(expected.get(label[v]) ?? []), v]);
    }
    const components = mesh.components();
    expect(components.map(({ vertices }) => Array.from(vertices))).toEqual([...expected.values()]);
    expect(components.reduce((sum, { genus }) => sum + genus, 0)).toBe(mesh.genus());
    expect(components.reduce((sum, { boundaryLoopCount: n }) => sum + n, 0)).toBe(
      mesh.boundaryLoops().length,
    );
  });
});

describe('validate', () => {
  test('tells isolated and pinched vertices, as no error', () => {
    using lonely = build(triangleAndIsolatedVertex());
    expect(lonely.validate()).toEqual([
      {
        code: 'isolated-vertex',
        severity: 'info',
        kind: 'vertex',
        index: 3,
        message: expect.stringMatching(/^Vertex 3 .*\.$/),
      },
    ]);
    using tie = build(bowTie());
    expect(tie.validate()).toMatchObject([
      { code: 'pinched-vertex', severity: 'warning', index: 2 },
    ]);
    expect(tie.validate(3)).toEqual([]);
  });

  test('finds what was written into the live views', () => {
    using mesh = build(quadGrid());
    const { connectivity } = mesh;
    const [before] = connectivity.next;
    connectivity.next[0] = connectivity.next[2];
    expect(mesh.validate().map(({ code }) => code)).toContain('next-prev-mismatch');
    expect(mesh.validate(0)).not.toEqual([]);
    connectivity.next[0] = before;
    expect(mesh.validate()).toEqual([]);
    connectivity.toVertex[0] = 99;
    expect(mesh.validate(0)).toMatchObject([
      { code: 'index-out-of-range', kind: 'halfedge', index: 0 },
    ]);
  });

  test("at the level 'geometry' tells where the vertices lie, beside all others", () => {
    using mesh = HalfedgeMesh.cube();
    const found = () =>
      mesh
        .validate('geometry')
        .map(({ severity, code, kind, index }) => [severity, code, kind, index]);
    expect(found()).toEqual([]);
    const [a, b] = mesh.edgeVertices(3 as Edge);
    mesh.positions.copyWithin(3 * b, 3 * a, 3 * a + 3);
    expect(found()).toEqual([['warning', 'zero-length-edge', 'edge', 3]]);
    mesh.positions[3 * b] = Number.NaN;
    mesh.addVertex([9, 9, 9]);
    expect(found()).toEqual([
      ['info', 'isolated-vertex', 'vertex', 8],
      ['error', 'non-finite-position', 'vertex', b],
    ]);
    expect(mesh.validate()).toHaveLength(1);
    using lean = HalfedgeMesh.fromTriangles([0, 0, 0, 2, 0, 0, 1, 0, 0], [0, 1, 2], {
      storePrev: false,
    });
    expect(lean.validate('geometry')).toEqual([
      {
        code: 'degenerate-face',
        severity: 'warning',
        kind: 'face',
        index: 0,
        message: 'Face 0 has no area to speak of: it is 2 long and 0 wide.',
      },
    ]);
  });

  test.each([
    [5, RangeError],
    [-1, RangeError],
    [1.5, RangeError],
    [Number.NaN, RangeError],
    ['4', TypeError],
    [null, TypeError],
  ])('refuses level %p', (level, kind) => {
    using mesh = build(quadGrid());
    expect(() => mesh.validate(level as number)).toThrow(kind);
    expect(() => mesh.validate(level as number)).toThrow(
      "expected an integer from 0 to 4, or 'geometry'.",
    );
  });
});

describe('An export', () => {
  test('of triangles cuts polygons into fans, and names their faces', () => {
    using mesh = HalfedgeMesh.fromPolygons(
      [0, 0, 0, 2, 0, 0, 3, 1, 0, 1, 2, 0, -1, 1, 0, 1, -1, 0],
      [
        [0, 1, 2, 3, 4],
        [5, 1, 0],
      ],
    );
    const { indices, faces } = mesh.toTriangles();
    expect(Array.from(indices)).toEqual([0, 1, 2, 0, 2, 3, 0, 3, 4, 5, 1, 0]);
    expect(Array.from(faces)).toEqual([0, 0, 0, 1]);
  });
});
