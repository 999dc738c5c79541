import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { DirectedEdgesMesh, type HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { BufferAttribute, BufferGeometry } from 'three';
import { collected } from './support/collection.js';
import { growMemory, growSilently } from './support/core.js';
import {
  annulus,
  bowTie,
  fans,
  type Input,
  pillow,
  puncturedTorus,
  quadGrid,
  randomTriangles,
  tetrahedron,
  torus,
  triangleAndIsolatedVertex,
} from './support/meshes.js';
import { random } from './support/random.js';

beforeAll(() => init());

const good = collected('good');

const perFace = ['faceNormal', 'faceArea', 'faceCentroid'] as const;
const perEdge = ['edgeLength', 'edgeMidpoint', 'dihedralAngle', 'cotanWeight'] as const;
const perVertex = ['vertexNormal', 'vertexArea', 'angleDefect'] as const;
const ALL = {
  faceNormal: 'allFaceNormals',
  faceArea: 'allFaceAreas',
  faceCentroid: 'allFaceCentroids',
  edgeLength: 'allEdgeLengths',
  edgeMidpoint: 'allEdgeMidpoints',
  dihedralAngle: 'allDihedralAngles',
  cotanWeight: 'allCotanWeights',
  cornerAngle: 'allCornerAngles',
  vertexNormal: 'allVertexNormals',
  vertexArea: 'allVertexAreas',
  angleDefect: 'allAngleDefects',
} as const;
type Measure = keyof typeof ALL;
const measures = Object.keys(ALL) as Measure[];
const points: Measure[] = ['faceNormal', 'faceCentroid', 'edgeMidpoint', 'vertexNormal'];

/** One of the measures, of a mesh of either kind. */
const measured = (mesh: HalfedgeMesh | DirectedEdgesMesh, measure: Measure, item: number) =>
  [mesh[measure](item)].flat();

/** Looked up once: in Jest, each look at a global name takes longer than the comparison. */
const { is } = Object;

/** What tells values apart that toEqual takes for one: nothing. NaN is NaN, and 0 is not -0. */
function expectSame(found: ArrayLike<number>, expected: ArrayLike<number>, what: string): void {
  const length = Math.max(found.length, expected.length);
  for (let i = 0; i < length; i++) {
    if (!is(found[i], expected[i])) {
      throw new Error(`${what}: at ${i} is ${found[i]}; expected ${expected[i]}.`);
    }
  }
}

/** Compares all measures of all items with those of the full mesh of the same triangles, to the last bit. */
function expectAsWhole(positions: ArrayLike<number>, indices: ArrayLike<number>): void {
  using whole = HalfedgeMesh.fromTriangles(positions, indices);
  using mesh = DirectedEdgesMesh.fromTriangles(positions, indices);
  expectSameMeasures(mesh, whole);
}

function expectSameMeasures(mesh: DirectedEdgesMesh, whole: HalfedgeMesh): void {
  // The halfedges of a face begin with the one that leads to its first corner, in both.
  const halfedges = mesh.halfedges().toArray() as number[];
  const sides = mesh
    .faces()
    .toArray()
    .flatMap((f) => whole.faceHalfedges(f).toArray()) as number[];
  const theirs = halfedges.map((h) => sides[h] ?? whole.opposite(sides[mesh.opposite(h)]));
  expect(new Set(theirs).size).toBe(whole.halfedgeCount);
  const edges = mesh.edges().toArray();
  expect(edges).toHaveLength(whole.edgeCount);

  const compare = (measure: Measure, slots: number, items: number[], to: (i: number) => number) => {
    const all = mesh[ALL[measure]]();
    const reference = whole[ALL[measure]]();
    const size = points.includes(measure) ? 3 : 1;
    const expected = points.includes(measure)
      ? new Float32Array(3 * slots)
      : new Float64Array(slots);
    const stride = Math.ceil(items.length / 500); // of a large mesh not each by itself
    for (const i of items) {
      for (let k = 0; k < size; k++) expected[size * i + k] = reference[size * to(i) + k];
      if (i % stride !== 0) continue;
      const [found, wanted] = [measured(mesh, measure, i), measured(whole, measure, to(i))];
      expectSame(found, wanted, `${measure}(${i})`);
    }
    expect(all.constructor).toBe(reference.constructor);
    expectSame(all, expected, `${ALL[measure]}()`);
  };
  const itself = (i: number) => i;
  for (const m of perFace) compare(m, mesh.faceSlots, mesh.faces().toArray(), itself);
  for (const m of perVertex) compare(m, mesh.vertexSlots, mesh.vertices().toArray(), itself);
  for (const m of perEdge) {
    compare(m, mesh.edgeSlots, edges, (e) => whole.edge(theirs[e]) as number);
  }
  compare('cornerAngle', mesh.halfedgeSlots, halfedges, (h) => theirs[h]);

  expect(mesh.area()).toBe(whole.area());
  expect(mesh.boundingBox()).toEqual(whole.boundingBox());
  if (whole.boundaryLoops().length === 0) expect(mesh.volume()).toBe(whole.volume());
  else {
    const [ours, words] = [mesh, whole].map((each) => caught(() => each.volume()) as HalfedgeError);
    expect(ours.code).toBe('open-surface');
    expect(ours.message).toBe(words.message.replace('fillHoles()', 'fillHoles() of toMesh()'));
  }
}

function caught(act: () => unknown): Error {
  try {
    act();
  } catch (error) {
    return error as Error;
  }
  throw new Error('nothing was thrown');
}

const meshOf = (input: Input) => DirectedEdgesMesh.fromTriangles(input.positions, fans(input));

describe('The measures of Directed Edges are those of the full mesh', () => {
  test.each([
    ['a tetrahedron', tetrahedron()],
    ['a grid', quadGrid()],
    ['a torus', torus()],
    ['a punctured torus', puncturedTorus()],
    ['an annulus', annulus()],
    ['a pinched vertex', bowTie()],
    ['a pillow', pillow()],
    ['an isolated vertex', triangleAndIsolatedVertex()],
    ['nothing', { positions: [], faces: [] }],
  ] as [string, Input][])('of %s', (_, input) => {
    expectAsWhole(input.positions, fans(input));
  });

  test.each([1, 2, 3, 4, 5, 6])('of random triangles, with holes (seed %i)', (seed) => {
    const next = random(seed);
    let [pinched, open, closed] = [0, 0, 0];
    for (let round = 0; round < 12; round++) {
      // Any triangles may be left out of a torus: vertices have several holes then, or no face.
      const input = torus(3 + round, 5);
      const positions = input.positions.map((x) => x + next());
      const share = round % 4 === 0 ? 0 : 0.25;
      const triangles = fans(input);
      const gone = triangles.map(() => next() < share);
      const indices = triangles.filter((_, i) => !gone[i - (i % 3)]);
      expectAsWhole(positions, indices);
      using mesh = DirectedEdgesMesh.fromTriangles(positions, indices);
      if (mesh.boundaryLoops().length > 0) open++;
      else closed++;
      for (const v of mesh.vertices()) if (!mesh.isManifoldVertex(v)) pinched++;
    }
    expect(Math.min(pinched, open, closed)).toBeGreaterThan(0);
  });

  test.each([1, 2, 3, 4, 5, 6, 7, 8])('of random polygons, cut (seed %i)', (seed) => {
    using cut = randomTriangles(seed);
    cut.compact();
    using mesh = DirectedEdgesMesh.fromMesh(cut);
    using whole = mesh.toMesh();
    expectSameMeasures(mesh, whole);
  });

  const files = good.files.map((path) => [basename(path), path]);
  good.test.each(files.length > 0 ? files : [['', '']])('of %s', (_, path) => {
    const { mesh: cut } = HalfedgeMesh.parse(readFileSync(path));
    cut.triangulate();
    cut.compact();
    using mesh = DirectedEdgesMesh.fromMesh(cut);
    cut.dispose();
    using whole = mesh.toMesh();
    expectSameMeasures(mesh, whole);
  });

  test.each([1, 2, 3, 4, 5, 6])('where places are strange (seed %i)', (seed) => {
    const next = random(seed);
    const strange = [0, -0, 1, -1, 1e-38, 3e38, -3e38, Number.NaN, Infinity, -Infinity];
    for (const input of [tetrahedron(), quadGrid(), pillow(), bowTie(), torus()]) {
      using mesh = meshOf(input);
      using whole = HalfedgeMesh.fromTriangles(input.positions, fans(input));
      for (let i = 0; i < mesh.positions.length; i++) {
        if (next() < 0.3) mesh.positions[i] = strange[Math.floor(next() * strange.length)];
      }
      whole.positions.set(mesh.positions);
      expectSameMeasures(mesh, whole);
    }
  });
});

describe('Of Directed Edges', () => {
  /** A cube around the origin, with sides of length 1. */
  const cube = () => {
    using whole = HalfedgeMesh.cube();
    whole.triangulate();
    whole.compact();
    return DirectedEdgesMesh.fromMesh(whole);
  };

  test('that are a cube, everything is known', () => {
    using mesh = cube();
    expect(mesh.area()).toBe(6);
    expect(mesh.volume()).toBeCloseTo(1, 12);
    expect(mesh.boundingBox()).toEqual({ min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5] });
    expect([...mesh.allFaceAreas()]).toEqual(Array(12).fill(0.5));
    for (const f of mesh.faces()) {
      // The normal leads to the side that the triangle is half of.
      const [normal, centre] = [mesh.faceNormal(f), mesh.faceCentroid(f)];
      expect(normal.map(Math.abs).sort()).toEqual([0, 0, 1]);
      expect(normal.reduce((sum, x, k) => sum + x * centre[k], 0)).toBeCloseTo(0.5, 12);
    }
    for (const e of mesh.edges()) {
      const isDiagonal = mesh.edgeLength(e) > 1;
      expect(mesh.edgeLength(e)).toBe(isDiagonal ? Math.SQRT2 : 1);
      expect(mesh.dihedralAngle(e)).toBe(isDiagonal ? 0 : Math.PI / 2);
      expect(mesh.cotanWeight(e)).toBeCloseTo(isDiagonal ? 0 : 1, 12);
    }
    for (const v of mesh.vertices()) {
      expect(mesh.angleDefect(v)).toBeCloseTo(Math.PI / 2, 12);
    }
  });

  test('normals are those of three.js, which draws the arrays as they are', () => {
    using mesh = meshOf(puncturedTorus());
    const geometry = new BufferGeometry();
    geometry.setIndex(new BufferAttribute(mesh.indices, 1));
    geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
    geometry.computeVertexNormals();
    const theirs = geometry.getAttribute('normal').array;
    mesh.allVertexNormals().forEach((x, i) => void expect(x).toBeCloseTo(theirs[i], 5));
  });

  test('where there is little to measure, zeros are left', () => {
    using line = DirectedEdgesMesh.fromTriangles([0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 1, 2]);
    expect(line.faceNormal(0)).toEqual([0, 0, 0]);
    expect(line.vertexNormal(1)).toEqual([0, 0, 0]);
    expect([...line.allFaceNormals(), ...line.allVertexNormals()]).toEqual(Array(12).fill(0));
    expect([line.faceArea(0), line.cotanWeight(0), line.dihedralAngle(0)]).toEqual([0, 0, 0]);
    using folded = meshOf(pillow());
    expect([...folded.allVertexNormals()]).toEqual(Array(3 * folded.vertexCount).fill(0));
    for (const e of folded.edges()) expect(folded.dihedralAngle(e)).toBe(Math.PI);
    using loose = meshOf(triangleAndIsolatedVertex());
    expect([loose.vertexNormal(3), loose.vertexArea(3)]).toEqual([[0, 0, 0], 0]);
    expect(loose.angleDefect(3)).toBe(2 * Math.PI);
    using none = DirectedEdgesMesh.fromTriangles([], []);
    expect([none.area(), none.volume(), none.boundingBox()]).toEqual([0, 0, null]);
    for (const measure of measures) expect(none[ALL[measure]]()).toHaveLength(0);
  });

  test('arrays have zeros where no edge is', () => {
    using mesh = meshOf(quadGrid());
    const isEdge = new Set<number>(mesh.edges());
    const size = { edgeLength: 1, edgeMidpoint: 3, dihedralAngle: 1, cotanWeight: 1 };
    for (const measure of perEdge) {
      const into = new Float64Array(size[measure] * mesh.edgeSlots).fill(7);
      expect(mesh[ALL[measure]](into)).toBe(into);
      into.forEach((x, i) => {
        const e = Math.floor(i / size[measure]);
        if (isEdge.has(e)) expect(x).not.toBe(7);
        else expect(x).toBe(0);
      });
    }
    expect(isEdge.size).toBeLessThan(mesh.edgeSlots);
  });

  test.each(measures)('%s is written to any array of floats that is long enough', (measure) => {
    using mesh = meshOf(quadGrid());
    const all = ALL[measure];
    const expected = mesh[all](new Float64Array(0));
    expect(expected).toBeInstanceOf(Float64Array);
    const { length } = expected;
    for (const Floats of [Float32Array, Float64Array]) {
      const exact = new Floats(length).fill(7);
      expect(mesh[all](exact)).toBe(exact);
      expect([...exact]).toEqual([...Floats.from(expected)]);
      const long = new Floats(length + 1).fill(7);
      const part = mesh[all](long);
      expect(part.buffer).toBe(long.buffer);
      expect([...long]).toEqual([...Floats.from(expected), 7]);
      expect(part).toHaveLength(length);
      const short = new Floats(length - 1).fill(7);
      expect([...mesh[all](short)]).toEqual([...Floats.from(expected)]);
      expect(new Set(short)).toEqual(new Set([7]));
    }
    for (const [into, found] of [
      [[], 'an array of 0 elements'],
      [new Uint32Array(length), `a Uint32Array of ${length} elements`],
      [null, 'null'],
    ] as [never, string][]) {
      expect(() => mesh[all](into)).toThrow(
        new TypeError(`into is ${found}; expected a Float32Array or a Float64Array.`),
      );
    }
    expect(() => mesh[all](mesh.positions)).toThrow(
      'expected another array than that of the positions.',
    );
  });

  test('normals are written into live memory: an attribute of the full mesh', () => {
    using mesh = meshOf(torus());
    using whole = mesh.toMesh();
    const view = whole.attributes.add('vertex', 'normal', { components: 3 }) as Float32Array;
    expect(mesh.allVertexNormals(view)).toBe(view);
    expect(whole.attributes.values('vertex', 'normal', 7)).toEqual(
      Array.from(mesh.vertexNormal(7), Math.fround),
    );
    // One that growth of the memory has detached is too short, as any other.
    growMemory();
    expect(mesh.allVertexNormals(view)).not.toBe(view);
    expect(mesh.allVertexNormals(view)).toEqual(mesh.allVertexNormals());
  });

  test('measures see vertices that were moved', () => {
    using mesh = meshOf(tetrahedron());
    const before = mesh.volume();
    for (let i = 0; i < mesh.positions.length; i++) mesh.positions[i] *= 2;
    expect(mesh.volume()).toBeCloseTo(8 * before, 6);
  });

  test('what is asked for has to exist', () => {
    using mesh = meshOf(quadGrid()); // 18 faces, 66 halfedges
    const cases: [() => unknown, Error][] = [
      [() => mesh.faceNormal(18), new RangeError('f is 18; expected a face from 0 to 17.')],
      [() => mesh.faceArea(-1), new RangeError('f is -1; expected a face from 0 to 17.')],
      [() => mesh.faceCentroid(0.5), new RangeError('f is 0.5; expected a face from 0 to 17.')],
      [
        () => mesh.faceArea(1 / 3),
        new RangeError('f is 0.3333333333333333; expected a face from 0 to 17.'),
      ],
      [() => mesh.edgeLength(54), new RangeError('e is 54; expected an edge from 0 to 53.')],
      ...perEdge.map((measure): [() => unknown, Error] => [
        () => mesh[measure](4),
        new RangeError('e is 4, which is no edge; expected the smaller of its two halfedges, 0.'),
      ]),
      [() => mesh.cornerAngle(66), new RangeError('h is 66; expected a halfedge from 0 to 65.')],
      [() => mesh.vertexNormal(16), new RangeError('v is 16; expected a vertex from 0 to 15.')],
      [
        () => mesh.vertexArea('1' as never),
        new TypeError('v is "1"; expected a vertex, which is an integer.'),
      ],
      [
        () => mesh.angleDefect(undefined as never),
        new TypeError('v is undefined; expected a vertex, which is an integer.'),
      ],
      [
        () => mesh.volume(),
        new Error(
          'This mesh has 1 boundary loop; expected a closed surface, which has none: fillHoles() of toMesh() closes them.',
        ),
      ],
    ];
    for (const [act, expected] of cases) {
      const error = caught(act);
      expect(error.message).toBe(expected.message);
      expect(error).toBeInstanceOf(expected.constructor);
    }
  });

  /** All that measures a mesh. */
  const questions = (mesh: DirectedEdgesMesh): (() => unknown)[] => [
    ...measures.flatMap((measure) => [() => mesh[measure](0), () => mesh[ALL[measure]]()]),
    () => mesh.area(),
    () => mesh.volume(),
    () => mesh.boundingBox(),
  ];

  test('nothing is measured after dispose', () => {
    const mesh = meshOf(tetrahedron());
    mesh.dispose();
    for (const ask of questions(mesh)) {
      expect((caught(ask) as HalfedgeError).code).toBe('disposed');
    }
  });

  test.each([growMemory, growSilently])('all is there when memory has grown: %p', (grow) => {
    using mesh = meshOf(tetrahedron());
    const expected = questions(mesh).map((ask) => ask());
    // A mesh for each question: the first one mends the views.
    const meshes = expected.map(() => meshOf(tetrahedron()));
    const { buffer } = mesh.positions;
    grow();
    expect(buffer.byteLength).toBe(0);
    expect(meshes.map((each, i) => questions(each)[i]())).toEqual(expected);
    for (const each of meshes) each.dispose();
  });

  test.each([1000, -5])('a walk that leaves the links is told: opposite is %i', (opposite) => {
    using mesh = meshOf(quadGrid());
    mesh.connectivity.opposite[mesh.rotateCw(mesh.vertexHalfedge(5))] = opposite;
    for (const measure of perVertex) {
      const error = caught(() => mesh[measure](5)) as HalfedgeError;
      expect(error.code).toBe('corrupt-connectivity');
      expect(error.message).toContain('The halfedges around an item form no closed orbit');
    }
  });

  test('with corrupt links, all ends with an answer or a sentence', () => {
    let sentences = 0;
    for (let seed = 1; seed <= 200; seed++) {
      const next = random(seed);
      using mesh = meshOf(quadGrid());
      const views = Object.values(mesh.connectivity) as Int32Array[];
      for (let i = 0; i < 3; i++) {
        const view = views[Math.floor(next() * views.length)];
        view[Math.floor(next() * view.length)] = Math.floor(next() * 80) - 8;
      }
      const each = [...mesh.vertices()].flatMap((v) =>
        perVertex.map((measure) => () => mesh[measure](v)),
      );
      for (const ask of [...questions(mesh), ...each]) {
        try {
          ask();
        } catch (error) {
          const { code, name } = error as HalfedgeError;
          expect([seed, code ?? name]).toEqual([
            seed,
            expect.stringMatching(/^(corrupt-connectivity|open-surface|RangeError)$/),
          ]);
          if (code === 'corrupt-connectivity') sentences++;
        }
      }
    }
    expect(sentences).toBeGreaterThan(0);
  });
});
