import { readFileSync } from 'node:fs';
import { HalfedgeError, HalfedgeMesh, init, type MendReport } from 'halfedge';
import { collected } from './support/collection.js';
import { bytesInUse } from './support/core.js';
import { addAttributes, expectState, stateOf } from './support/editing.js';
import { random } from './support/random.js';

beforeAll(() => init());

const errorsOf = (mesh: HalfedgeMesh) =>
  mesh.validate(4).filter(({ severity }) => severity === 'error');

const countsOf = (mesh: HalfedgeMesh) => [mesh.vertexCount, mesh.edgeCount, mesh.faceCount];

/** The same faces, of which no two share a vertex. */
function soupOf(mesh: HalfedgeMesh): HalfedgeMesh {
  const { sizes, corners } = mesh.toPolygons();
  const positions = Array.from(corners, (v) => [...mesh.positions.subarray(3 * v, 3 * v + 3)]);
  return HalfedgeMesh.fromPolygons(positions.flat(), { sizes, corners: corners.map((_, i) => i) });
}

/** What `repair` reports; the mesh is valid afterwards, and the repair one step of history. */
function mended(mesh: HalfedgeMesh, repair: (mesh: HalfedgeMesh) => MendReport): MendReport {
  if (mesh.attributes.list().length === 0) addAttributes(mesh, random(7));
  mesh.history.enabled = true;
  const before = stateOf(mesh);
  const { version } = mesh;
  const report = repair(mesh);
  const isChanged = mesh.version !== version;
  expect(errorsOf(mesh)).toEqual([]);
  const after = stateOf(mesh);
  expect(mesh.history.undo()).toBe(isChanged);
  expect(mesh.history.undo()).toBe(false);
  expectState(mesh, before);
  expect(mesh.history.redo()).toBe(isChanged);
  expectState(mesh, after);
  mesh.history.enabled = false;
  expect(report.summary).toMatch(/^[A-Z0-9].*\.$/);
  for (const problem of report.problems) expect(problem.message).toMatch(/^[A-Z].*\.$/);
  return report;
}

describe('stitchBoundaries', () => {
  test('makes the mesh again of its faces, also without prev', () => {
    using sphere = HalfedgeMesh.icoSphere(2);
    for (const storePrev of [true, false]) {
      using apart = soupOf(sphere);
      using mesh = HalfedgeMesh.fromPolygons([...apart.positions], apart.toPolygons(), {
        storePrev,
      });
      const report = mended(mesh, (m) => m.stitchBoundaries());
      expect(countsOf(mesh)).toEqual(countsOf(sphere));
      expect(report.counts).toEqual({ 'stitched-edge': 480 });
      expect(report.edges).toHaveLength(480);
      expect(new Set(report.edges).size).toBe(480);
      expect(report.summary).toBe('480 edges stitched.');
      expect(mesh.isClosed()).toBe(true);
    }
  });

  test('closes cracks no wider than the tolerance', () => {
    const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1.01, 0, 1, 0.01, 0, 1, 1, 0];
    using mesh = HalfedgeMesh.fromTriangles(positions, [0, 1, 2, 3, 4, 5]);
    expect(mended(mesh, (m) => m.stitchBoundaries()).summary).toBe('Nothing to repair.');
    const report = mended(mesh, (m) => m.stitchBoundaries({ tolerance: 0.02 }));
    expect(report.counts).toEqual({ 'stitched-edge': 1 });
    expect(countsOf(mesh)).toEqual([4, 5, 2]);
  });

  test('says what it left, and why', () => {
    const positions = [
      [0, 0, 0, 1, 0, 0, 0, 1, 0],
      [1, 0, 0, 0, 0, 0, 0, -1, 0],
      [1, 0, 0, 0, 0, 0, 0, 0, 1],
    ];
    using mesh = HalfedgeMesh.fromTriangles(positions.flat(), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
    const { problems, counts } = mended(mesh, (m) => m.stitchBoundaries());
    expect(counts).toEqual({ 'ambiguous-edge': 3 });
    expect(problems).toHaveLength(3);
    expect(problems[0]).toMatchObject({ code: 'ambiguous-edge', severity: 'warning' });
    expect(problems[0].witness?.edges).toHaveLength(1);
    expect(problems[0].message).toMatch(/lies together with 2 other boundary edges/);
  });

  test('checks its options', () => {
    using mesh = HalfedgeMesh.cube();
    expect(() => mesh.stitchBoundaries({ tolerance: -1 })).toThrow(
      'options.tolerance is -1; expected a finite number from 0.',
    );
    expect(() => mesh.stitchBoundaries({ tolerance: Number.NaN })).toThrow(RangeError);
    expect(() => mesh.stitchBoundaries({ tolerance: '1' as never })).toThrow(TypeError);
    expect(() => mesh.stitchBoundaries(null as never)).toThrow(TypeError);
  });
});

describe('splitPinchedVertices', () => {
  test('gives each fan a vertex', () => {
    const positions = Array.from({ length: 7 }, (_, i) => [i, i * i, 0]).flat();
    using mesh = HalfedgeMesh.fromTriangles(positions, [0, 1, 2, 0, 3, 4, 0, 5, 6]);
    expect(mesh.isManifoldVertex(0)).toBe(false);
    const report = mended(mesh, (m) => m.splitPinchedVertices());
    expect(countsOf(mesh)).toEqual([9, 9, 3]);
    expect(report.counts).toEqual({ 'split-vertex': 1 });
    expect([...report.vertices].sort()).toEqual([7, 8]);
    expect(mesh.validate(4)).toEqual([]);
  });
});

describe('orientOutward', () => {
  test('turns closed components over, and leaves open ones', () => {
    using mesh = HalfedgeMesh.cube();
    using open = HalfedgeMesh.grid(2, 2);
    mesh.append(open);
    mesh.reverse();
    const { counts, faces, problems } = mended(mesh, (m) => m.orientOutward());
    expect(counts).toEqual({ 'reversed-component': 1, 'open-component': 1 });
    expect([...faces]).toEqual([0, 1, 2, 3, 4, 5]);
    expect(problems[0]).toMatchObject({ code: 'open-component', kind: 'face', index: 6 });
    using cube = HalfedgeMesh.cube();
    const corners = (m: HalfedgeMesh, f: number) => [...m.faceVertices(f)].sort();
    for (const f of cube.faces()) expect(corners(mesh, f)).toEqual(corners(cube, f));
  });

  test('takes cavities for what they are, if asked to', () => {
    using mesh = HalfedgeMesh.cube({ size: 4 });
    using inner = HalfedgeMesh.cube({ size: 1 });
    mesh.append(inner);
    expect(mended(mesh, (m) => m.orientOutward()).summary).toBe('Nothing to repair.');
    expect([...mended(mesh, (m) => m.orientOutward({ nested: true })).faces]).toEqual([
      6, 7, 8, 9, 10, 11,
    ]);
    expect(() => mesh.orientOutward({ nested: 1 as never })).toThrow(
      'options.nested is 1; expected true or false.',
    );
  });
});

describe('dropSmallComponents', () => {
  test('drops what is too small in any respect', () => {
    using mesh = HalfedgeMesh.cube();
    using dust = HalfedgeMesh.tetrahedron({ radius: 0.01 });
    mesh.append(dust);
    for (const options of [{ faces: 5 }, { area: 0.1 }, { diagonal: 0.1 }]) {
      using copy = mesh.clone();
      const report = mended(copy, (m) => m.dropSmallComponents(options));
      expect(report.counts).toEqual({ 'dropped-component': 1 });
      expect([...report.faces]).toEqual([6, 7, 8, 9]);
      expect(countsOf(copy)).toEqual([8, 12, 6]);
    }
    for (const faces of [2.5, -1, Number.NaN]) {
      expect(() => mesh.dropSmallComponents({ faces })).toThrow(
        `options.faces is ${faces}; expected an integer from 0, or Infinity.`,
      );
    }
    expect(() => mesh.dropSmallComponents({ area: 2 })).toThrow(
      'options.area is 2; expected a number from 0 to 1.',
    );
  });
});

describe('removeDegenerateFaces', () => {
  test('flips the long side of a cap, and collapses an edge without length', () => {
    const positions = [
      [0, 0, 0, 4, 0, 0, 1, 0, 0],
      [2, -2, 0, 2, 3, 0],
    ];
    using mesh = HalfedgeMesh.fromTriangles(positions.flat(), [0, 1, 2, 1, 0, 3, 2, 1, 4, 0, 2, 4]);
    const caps = mended(mesh, (m) => m.removeDegenerateFaces());
    expect(caps.counts).toEqual({ 'flipped-edge': 1 });
    expect([...caps.edges]).toEqual([mesh.findEdge(2, 3)]);

    mesh.setPosition(2, [0, 0, 0]);
    const needles = mended(mesh, (m) => m.removeDegenerateFaces());
    expect(needles.counts).toEqual({ 'collapsed-edge': 1 });
    expect(needles.vertices).toHaveLength(1);
    expect(countsOf(mesh)).toEqual([4, 5, 2]);
  });

  test('says what can not be removed', () => {
    using mesh = HalfedgeMesh.tetrahedron();
    mesh.setPosition(1, mesh.positions.slice(0, 3));
    const { counts, problems } = mended(mesh, (m) => m.removeDegenerateFaces());
    expect(counts).toEqual({ 'zero-length-edge': 1, 'degenerate-face': 2 });
    const [short] = problems;
    expect(short.message).toMatch(/^Edge \d has a length of 0 but can't be collapsed: /);
    expect(short).toMatchObject({ kind: 'edge', index: short.witness.edges[0] });
    expect(() => mesh.removeDegenerateFaces({ tolerance: -1 })).toThrow(RangeError);
  });
});

describe('fillHoles', () => {
  test('closes what is open, and says which faces are new', () => {
    using mesh = HalfedgeMesh.icoSphere(3);
    for (const v of [0, 200, 400]) mesh.deleteVertex(v);
    const report = mended(mesh, (m) => m.fillHoles());
    expect(report.counts).toEqual({ 'filled-hole': 3 });
    expect(mesh.isClosed()).toBe(true);
    expect(mesh.eulerCharacteristic()).toBe(2);
    expect(report.faces.length).toBeGreaterThan(8);
    for (const f of report.faces) {
      expect(mesh.degree(f)).toBe(3);
      expect(mesh.attributes.get('face', 'group')[f]).toBe(-1);
    }
  });

  test('leaves large holes and the outline of a sheet', () => {
    using mesh = HalfedgeMesh.cylinder(8, { caps: 'open' });
    const small = mended(mesh, (m) => m.fillHoles({ maxEdges: 7 }));
    expect(small.counts).toEqual({ 'large-hole': 2 });
    const [hole] = small.problems;
    expect(hole.message).toMatch(/of 8 edges, is larger than asked for, expected 7/);
    expect(hole).toMatchObject({ kind: 'halfedge', index: hole.witness.halfedges[0] });
    using sheet = HalfedgeMesh.grid(3, 3);
    const outline = mended(sheet, (m) => m.fillHoles());
    expect(outline.counts).toEqual({ 'folding-hole': 1 });
    expect(outline.summary).toBe('1 hole left whose filling would fold over.');
    expect(mended(sheet, (m) => m.fillHoles({ maxAngle: 180 })).counts).toEqual({
      'filled-hole': 1,
    });
    expect(() => mesh.fillHoles({ maxAngle: 181 })).toThrow(
      'options.maxAngle is 181; expected a number of degrees from 0 to 180.',
    );
    expect(() => mesh.fillHoles({ maxEdges: 'all' as never })).toThrow(TypeError);
    expect(() => mesh.fillHoles({ maxEdges: 7.5 })).toThrow('options.maxEdges is 7.5; expected');
  });
});

test('a repair in a group is a part of its step', () => {
  using mesh = HalfedgeMesh.cube();
  mesh.reverse();
  mesh.history.enabled = true;
  const before = stateOf(mesh);
  mesh.history.group(() => {
    mesh.orientOutward();
    mesh.deleteFace(0);
  });
  expect(mesh.history.undo()).toBe(true);
  expectState(mesh, before);
});

test('reports cost no memory once they are made', () => {
  using sphere = HalfedgeMesh.icoSphere(1);
  const before = bytesInUse();
  for (let i = 0; i < 5; i++) {
    using mesh = soupOf(sphere);
    mesh.stitchBoundaries();
    mesh.splitPinchedVertices();
    mesh.orientOutward();
    mesh.removeDegenerateFaces();
    mesh.fillHoles();
    mesh.dropSmallComponents({ faces: 1000 });
  }
  expect(bytesInUse()).toBe(before);
});

test('a disposed mesh refuses repairs', () => {
  const mesh = HalfedgeMesh.cube();
  mesh.dispose();
  const bad = { tolerance: -1, open: 7, faces: -1, maxEdges: -1 } as never;
  for (const repair of [
    () => mesh.stitchBoundaries(),
    () => mesh.stitchBoundaries(bad),
    () => mesh.splitPinchedVertices(),
    () => mesh.orientOutward(),
    () => mesh.orientOutward(bad),
    () => mesh.dropSmallComponents({ faces: 2 }),
    () => mesh.dropSmallComponents(bad),
    () => mesh.removeDegenerateFaces(),
    () => mesh.removeDegenerateFaces(bad),
    () => mesh.fillHoles(),
    () => mesh.fillHoles(bad),
  ]) {
    expect(repair).toThrow(expect.objectContaining({ code: 'disposed' }));
  }
});

const nasty = collected('nasty');
nasty.test(
  'all repairs leave a valid mesh of every nasty file, and can be undone',
  () => {
    let meshes = 0;
    for (const file of nasty.files) {
      let mesh: HalfedgeMesh;
      try {
        mesh = HalfedgeMesh.parse(readFileSync(file)).mesh;
      } catch (error) {
        expect([file, error]).toEqual([file, expect.any(HalfedgeError)]);
        continue;
      }
      mesh.history.enabled = true;
      const before = stateOf(mesh);
      const summaries: string[] = [];
      mesh.history.group(() => {
        summaries.push(mesh.splitPinchedVertices().summary);
        summaries.push(mesh.stitchBoundaries({ tolerance: 1e-6 }).summary);
        summaries.push(mesh.removeDegenerateFaces().summary);
        summaries.push(mesh.dropSmallComponents({ diagonal: 0.01 }).summary);
        summaries.push(mesh.fillHoles({ maxEdges: 60 }).summary);
        summaries.push(mesh.orientOutward({ open: true }).summary);
      });
      expect([file, errorsOf(mesh)]).toEqual([file, []]);
      for (const summary of summaries) expect(summary).toMatch(/^[A-Z0-9].*\.$/);
      mesh.history.undo();
      expectState(mesh, before);
      mesh.dispose();
      meshes++;
    }
    expect(meshes).toBeGreaterThan(50);
  },
  120_000,
);

test('orientOutward turns what is not flat over once, and not again', () => {
  const next = random(5);
  for (let trial = 0; trial < 200; trial++) {
    const positions = Array.from({ length: 12 }, next);
    using quad = HalfedgeMesh.fromPolygons(positions, [[0, 1, 2, 3]]);
    quad.orientOutward({ open: true });
    expect(quad.orientOutward({ open: true }).summary).toBe('Nothing to repair.');
    using pillow = HalfedgeMesh.fromPolygons(positions, [
      [0, 1, 2, 3],
      [3, 2, 1, 0],
    ]);
    pillow.orientOutward();
    expect(pillow.orientOutward().summary).not.toContain('turned over');
  }
});

test('A tolerance is finite', () => {
  using mesh = HalfedgeMesh.cube();
  for (const repair of ['stitchBoundaries', 'removeDegenerateFaces'] as const) {
    expect(() => mesh[repair]({ tolerance: Infinity })).toThrow(
      new RangeError('options.tolerance is Infinity; expected a finite number from 0.'),
    );
  }
});
