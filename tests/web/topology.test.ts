import { type Edge, type Face, HalfedgeMesh, init, type Vertex } from 'halfedge';
import { concavePolygon } from './support/concave.js';
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

/** Each from its least corner on, in order. */
function inOrder(indices: Uint32Array): string[] {
  const triangles: string[] = [];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = indices.subarray(i, i + 3);
    triangles.push([[a, b, c].join(), [b, c, a].join(), [c, a, b].join()].sort()[0]);
  }
  return triangles.sort();
}

describe('An export of triangles', () => {
  test('cuts polygons along short diagonals, and names their faces', () => {
    using mesh = HalfedgeMesh.fromPolygons(
      [0, 0, 0, 2, 0, 0, 3, 1, 0, 1, 2, 0, -1, 1, 0, 1, -1, 0],
      [
        [0, 1, 2, 3, 4],
        [5, 1, 0],
      ],
    );
    const { indices, faces } = mesh.toTriangles();
    expect(inOrder(indices)).toEqual(['0,1,3', '0,3,4', '0,5,1', '1,2,3']);
    expect(Array.from(faces)).toEqual([0, 0, 0, 1]);
    expect(Array.from(indices.subarray(9))).toEqual([5, 1, 0]);
  });

  test('covers concave faces, never folds over, and changes nothing', () => {
    for (let seed = 1; seed <= 50; seed++) {
      using mesh = build(concavePolygon(seed));
      const bytes = mesh.toBytes();
      const { indices, faces } = mesh.toTriangles();
      expect(faces).toEqual(new Uint32Array(mesh.degree(0 as Face) - 2));
      let area = 0;
      for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = Array.from(indices.subarray(i, i + 3), (v) => mesh.position(v as Vertex));
        const twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        expect({ seed, isUpright: twice > 0 }).toEqual({ seed, isUpright: true });
        area += twice / 2;
      }
      expect({ seed, area }).toEqual({ seed, area: expect.closeTo(mesh.area(), 4) });
      expect(mesh.toBytes()).toEqual(bytes);
      mesh.triangulate();
      expect(inOrder(indices)).toEqual(inOrder(mesh.toTriangles().indices));
    }
  });

  test('refuses no mesh for its diagonals', () => {
    // Two darts with the same four corners, back to back.
    using mesh = HalfedgeMesh.fromPolygons(
      [0, 0, 0, 4, 0, 0, 1, 1, 0, 0, 4, 0],
      [
        [0, 1, 2, 3],
        [3, 2, 1, 0],
      ],
    );
    expect(() => mesh.triangulate()).toThrow(/which one across another face will join/);
    const { indices, faces } = mesh.toTriangles();
    expect(inOrder(indices)).toEqual(['0,1,2', '0,2,1', '0,2,3', '0,3,2']);
    expect(Array.from(faces)).toEqual([0, 0, 1, 1]);
  });

  test('leaves out deleted faces and those of loops', () => {
    using mesh = HalfedgeMesh.prism(6);
    mesh.makeLoop();
    mesh.deleteFace(2 as Face);
    const { indices, faces } = mesh.toTriangles();
    const expected = mesh
      .faces()
      .toArray()
      .flatMap((f) => Array(Math.max(0, mesh.degree(f) - 2)).fill(f));
    expect(Array.from(faces)).toEqual(expected);
    faces.forEach((f, i) => {
      const corners = mesh.faceVertices(f as Face).toArray();
      for (const v of indices.subarray(3 * i, 3 * i + 3)) expect(corners).toContain(v);
    });
  });

  test('tells in a sentence where links are broken', () => {
    using mesh = build(quadGrid());
    const { next, toVertex, faceHalfedge } = mesh.connectivity;
    for (const [links, at] of [
      [next, faceHalfedge[1]],
      [toVertex, faceHalfedge[1]],
      [faceHalfedge, 1],
    ] as const) {
      const was = links[at];
      links[at] = 9999;
      expect(() => mesh.toTriangles()).toThrow(
        expect.objectContaining({
          code: 'corrupt-connectivity',
          message: expect.stringMatching(/^The ring around face 1 does not close, or leads to /),
        }),
      );
      links[at] = was;
    }
    expect(mesh.validate()).toEqual([]);
  });
});
