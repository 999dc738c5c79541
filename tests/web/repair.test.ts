import { readFileSync } from 'node:fs';
import { HalfedgeError, HalfedgeMesh, init, type RepairReport, type SoupOptions } from 'halfedge';
import { collected } from './support/collection.js';
import { bytesInUse, withLeft } from './support/core.js';
import { random, shuffle } from './support/random.js';

beforeAll(() => init());

/** Positions without any two alike. */
const points = (count: number): number[] =>
  Array.from({ length: count }, (_, i) => [i, i * i, i ** 3]).flat();

const TETRAHEDRON = [
  [0, 2, 1],
  [0, 1, 3],
  [0, 3, 2],
  [1, 2, 3],
];
const CORNERS = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];

const facesOf = (mesh: HalfedgeMesh): number[][] =>
  [...mesh.faces()].map((f) => [...mesh.faceVertices(f)]);

const errorsOf = (mesh: HalfedgeMesh) =>
  mesh.validate(4).filter(({ severity }) => severity === 'error');

/** Each face of the input is there, or its verdict says why not. */
function expectNothingLost(report: RepairReport, faces: number, mesh: HalfedgeMesh): void {
  expect(errorsOf(mesh)).toEqual([]);
  expect(report.faceMap).toHaveLength(faces);
  const dropped = new Set(report.verdicts.filter(({ kept }) => !kept).map(({ face }) => face));
  const lost = Array.from(report.faceMap).flatMap((f, face) => (f < 0 ? [face] : []));
  expect(lost).toEqual([...dropped]);
  expect(faces - dropped.size).toBe(mesh.faceCount);
  expect(report.vertexOrigin).toHaveLength(mesh.vertexCount);
}

describe('fromSoup', () => {
  test('makes of a manifold the mesh that fromPolygons makes', () => {
    using strict = HalfedgeMesh.fromPolygons(CORNERS, TETRAHEDRON);
    const { mesh, report } = HalfedgeMesh.fromSoup(CORNERS, TETRAHEDRON);
    expect(mesh.connectivity).toEqual(strict.connectivity);
    expect(report).toEqual({
      problems: [],
      counts: {},
      unlisted: {},
      verdicts: [],
      vertexMap: Int32Array.of(0, 1, 2, 3),
      vertexOrigin: Uint32Array.of(0, 1, 2, 3),
      faceMap: Int32Array.of(0, 1, 2, 3),
      summary: 'Nothing to repair.',
    });
    mesh.dispose();
  });

  test('takes index buffers and { sizes, corners } as well, and changes none of them', () => {
    const triangles = Int32Array.from(TETRAHEDRON.flat());
    const forms = [
      triangles,
      Array.from(triangles),
      Float64Array.from(triangles),
      { sizes: [3, 3, 3, 3], corners: triangles },
    ];
    for (const faces of forms) {
      const { mesh } = HalfedgeMesh.fromSoup(Float64Array.from(CORNERS), faces, { weld: true });
      expect(facesOf(mesh)).toEqual(TETRAHEDRON);
      mesh.dispose();
    }
    expect(triangles).toEqual(Int32Array.from(TETRAHEDRON.flat()));
    expect(HalfedgeMesh.fromSoup([], []).mesh.vertexCount).toBe(0);
  });

  test.each([
    [Uint32Array.of(0, 1, 2 ** 32 - 1), '4294967295'],
    [Uint32Array.of(0, 1, 2 ** 31), '2147483648'],
    [Int32Array.of(0, 1, -1), '-1'],
    [Int8Array.of(0, 1, -3), '-3'],
    [Float64Array.of(0, 1, -4), '-4'],
    [Float64Array.of(0, 1, 2 ** 32 - 4), '4294967292'],
    [[0, 1, -5], '-5'],
    [[0, 1, 2 ** 32 - 5], '4294967291'],
    [[[0, 1, -6]], '-6'],
    [[[0, 1, 2 ** 32 - 6]], '4294967290'],
    [{ sizes: [3], corners: Int32Array.of(0, 1, -7) }, '-7'],
    [{ sizes: [3], corners: [0, 1, 2 ** 32 - 7] }, '4294967289'],
    [[0, 1, 2 ** 32], '4294967296'],
    [[0, 1, -(2 ** 31) - 1], '-2147483649'],
    [[[0, 1, 1e10, -1]], '10000000000'],
    [[[0, -1, 2 ** 32 - 1]], '-1'],
    [[[0, 2 ** 32 - 1, -1]], '4294967295'],
    [Float64Array.of(0, 1, -1e300), '-1e+300'],
    [{ sizes: [3], corners: [0, 1, 2 ** 53] }, '9007199254740992'],
  ])('names vertices as they were given: %j', (faces, name) => {
    const { mesh, report } = HalfedgeMesh.fromSoup(CORNERS, faces);
    expect(report.problems[0]?.message).toBe(
      `Face 0 uses vertex ${name}, but the last one is 3: it was left out.`,
    );
    mesh.dispose();
  });

  test('names the missing vertices of a hundred faces as they were given', () => {
    const faces = Array.from({ length: 300 }, (_, f) => [0, f % 2 === 0 ? 1 : 9, 2 ** 40 + f]);
    const { mesh, report } = HalfedgeMesh.fromSoup(CORNERS, faces);
    expect(report.counts['index-out-of-range']).toBe(300);
    const missing = report.problems.filter(({ code }) => code === 'index-out-of-range');
    expect(missing.map(({ message }) => message)).toEqual(
      faces.slice(0, 100).map(([, second, last], f) => {
        const vertex = second === 9 ? 9 : last;
        return `Face ${f} uses vertex ${vertex}, but the last one is 3: it was left out.`;
      }),
    );
    mesh.dispose();
  });

  const rows: [string, number[][], object, string, RepairReport['verdicts']][] = [
    [
      'indices out of range',
      [...TETRAHEDRON, [0, 1, 4], [-1, 2, 3], [1, 2, 2 ** 40]],
      { 'index-out-of-range': 3 },
      '3 faces with an index out of range left out.',
      [4, 5, 6].map((face) => ({ face, kept: false, codes: ['index-out-of-range'] })),
    ],
    [
      'faces with fewer than three corners',
      [...TETRAHEDRON, [], [1, 2]],
      { 'degree-below-three': 2 },
      '2 faces with fewer than 3 corners left out.',
      [4, 5].map((face) => ({ face, kept: false, codes: ['degree-below-three'] })),
    ],
    [
      'repeated vertices',
      [[0, 2, 2, 1], ...TETRAHEDRON.slice(1), [1, 3, 1]],
      { 'repeated-vertex': 2 },
      '1 face that used a vertex twice left out, 1 face that used a vertex twice simplified.',
      [
        { face: 0, kept: true, codes: ['repeated-vertex'] },
        { face: 4, kept: false, codes: ['repeated-vertex'] },
      ],
    ],
    [
      'duplicate faces',
      [...TETRAHEDRON, [2, 1, 0], [0, 1, 2]],
      { 'duplicate-face': 2 },
      '2 duplicate faces left out.',
      [4, 5].map((face) => ({ face, kept: false, codes: ['duplicate-face'] })),
    ],
    [
      'a flipped face',
      [...TETRAHEDRON.slice(0, 3), [3, 2, 1]],
      { 'opposite-orientation': 1 },
      '1 face turned over.',
      [{ face: 3, kept: true, codes: ['opposite-orientation'] }],
    ],
  ];
  test.each(rows)('mends %s', (_, faces, counts, summary, verdicts) => {
    expect(() => HalfedgeMesh.fromPolygons(CORNERS, faces)).toThrow();
    const { mesh, report } = HalfedgeMesh.fromSoup(CORNERS, faces);
    expect(report.counts).toEqual(counts);
    expect(report.summary).toBe(summary);
    expect(report.verdicts).toEqual(verdicts);
    expectNothingLost(report, faces.length, mesh);
    expect(mesh.vertexCount).toBe(4);
    expect([mesh.faceCount, mesh.genus(), mesh.boundaryLoops().length]).toEqual([4, 0, 0]);
    for (const problem of report.problems) {
      expect(problem).toMatchObject({ severity: 'warning', kind: 'face' });
      expect(problem.message).toMatch(/^Face \d+ .*\.$/);
    }
    mesh.dispose();
  });

  test('doubles an edge of two solids, and says which vertices are copies', () => {
    const faces = [...TETRAHEDRON, [0, 1, 4], [0, 5, 1], [1, 5, 4], [5, 0, 4]];
    const { mesh, report } = HalfedgeMesh.fromSoup(points(6), faces);
    expect(mesh.components()).toHaveLength(2);
    expect(mesh.boundaryLoops()).toEqual([]);
    expect(report.counts).toEqual({ 'edge-with-many-faces': 1 });
    expect(Array.from(report.vertexOrigin.slice(6)).sort()).toEqual([0, 1]);
    expect(Array.from(report.vertexMap)).toEqual([0, 1, 2, 3, 4, 5]);
    expect(report.problems[0].witness).toMatchObject({ vertices: [0, 1], faces: [0, 1, 4, 5] });
    mesh.dispose();
  });

  test('names each edge of two faces that it cuts, and cuts no more than it has to', () => {
    const positions = [
      0.04, 0.97, 0.12, 0.14, 0.25, 0.55, 1, 0.77, 0.53, 0.47, 0.55, 0.29, 0.93, 0.82, 0.6,
    ];
    const faces = [
      [3, 1, 2],
      [4, 2, 3],
      [2, 4, 0],
      [2, 4, 1],
      [4, 1, 0],
      [0, 2, 3],
      [3, 0, 4],
    ];
    const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces);
    const crowded = report.problems.filter(({ code }) => code === 'edge-with-many-faces');
    const cut = report.problems.filter(({ code }) => code === 'neighbours-cut');
    expect(cut.length).toBe(report.counts['neighbours-cut']);
    expect(report.summary).toContain(
      `${cut.length} edge${cut.length === 1 ? '' : 's'} beside such`,
    );
    const named = [...crowded, ...cut].map(({ witness }) => witness?.vertices.join());
    // Sides of faces that are joined in the mesh, by the edge of the input that they were.
    const open = new Set<string>();
    for (const h of mesh.halfedges()) {
      if (!mesh.isBoundaryHalfedge(h)) continue;
      const ends = [mesh.fromVertex(h), mesh.toVertex(h)].map((v) => report.vertexOrigin[v]);
      open.add(ends.sort((a, b) => a - b).join());
    }
    const count = (edge: string) =>
      faces.filter((face) =>
        face.some((v, i) => [v, face[(i + 1) % 3]].sort((a, b) => a - b).join() === edge),
      ).length;
    for (const edge of open) if (count(edge) > 1) expect(named).toContain(edge);
    for (const { witness } of cut) {
      for (const face of witness?.faces ?? []) {
        const verdict = report.verdicts.find((it) => it.face === face);
        expect(verdict?.codes).toContain('neighbours-cut');
      }
    }
    mesh.dispose();
  });

  test('takes a number that is too large for a position as one that is none, in any array', () => {
    const positions = [1e39, 0, 0, 1, 0, 0, 0, 1, 0];
    for (const given of [positions, Float64Array.from(positions)]) {
      const { mesh, report } = HalfedgeMesh.fromSoup(given, [0, 1, 2]);
      expect(report.counts).toEqual({ 'non-finite-position': 1, 'isolated-vertex': 2 });
      mesh.dispose();
    }
    expect(() => HalfedgeMesh.fromSoup(['1'] as never, [0, 1, 2])).toThrow('positions[0] is "1"');
  });

  test('doubles a pinched vertex', () => {
    const faces = [...TETRAHEDRON, ...TETRAHEDRON.map((face) => face.map((v) => v && v + 3))];
    const { mesh, report } = HalfedgeMesh.fromSoup(points(7), faces);
    expect(mesh.components()).toHaveLength(2);
    expect(report.counts).toEqual({ 'pinched-vertex': 1 });
    expect(report.vertexOrigin[7]).toBe(0);
    expect(report.problems[0]).toMatchObject({ kind: 'vertex', index: 0 });
    mesh.dispose();
  });

  test('cuts a one-sided surface', () => {
    const strip = Array.from({ length: 7 }, (_, i) => [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]);
    const faces = [...strip, [14, 1, 0, 15]];
    const { mesh, report } = HalfedgeMesh.fromSoup(points(16), faces);
    expect(report.counts).toEqual({ 'non-orientable': 1 });
    expect([mesh.faceCount, mesh.eulerCharacteristic()]).toEqual([8, 1]);
    mesh.dispose();
  });

  test('leaves out what has no finite position, and isolated vertices if asked', () => {
    const positions = [...CORNERS, Number.NaN, 0, 0, 5, 5, 5, Infinity, 0, 0];
    const faces = [...TETRAHEDRON, [0, 1, 4]];
    const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces);
    expect(Array.from(report.vertexMap)).toEqual([0, 1, 2, 3, -1, 4, -1]);
    expect(report.counts).toEqual({ 'non-finite-position': 2, 'isolated-vertex': 1 });
    expect(report.problems.at(-1)).toMatchObject({ severity: 'info', code: 'isolated-vertex' });
    expectNothingLost(report, 5, mesh);
    const smaller = HalfedgeMesh.fromSoup(positions, faces, { dropIsolated: true });
    expect(Array.from(smaller.report.vertexOrigin)).toEqual([0, 1, 2, 3]);
    mesh.dispose();
    smaller.mesh.dispose();
  });

  test('welds exactly, within a tolerance, or not at all', () => {
    const soup = TETRAHEDRON.flat().flatMap((v) => CORNERS.slice(3 * v, 3 * v + 3));
    const faces = Uint32Array.from({ length: 12 }, (_, i) => i);
    const count = (positions: number[], options: SoupOptions = {}) => {
      const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces, options);
      expectNothingLost(report, 4, mesh);
      return [mesh.vertexCount, mesh.boundaryLoops().length, report.summary];
    };
    expect(count(soup)).toEqual([12, 4, 'Nothing to repair.']);
    expect(count(soup, { weld: false })).toEqual([12, 4, 'Nothing to repair.']);
    expect(count(soup, { weld: true })).toEqual([4, 0, '8 vertices welded to others.']);
    expect(count(soup, { weld: 0 })).toEqual([4, 0, '8 vertices welded to others.']);
    const shaken = soup.map((x, i) => x + 1e-4 * ((i * 7919) % 5));
    expect(count(shaken, { weld: true })[0]).toBeGreaterThan(4);
    expect(count(shaken, { weld: 1e-3 }).slice(0, 2)).toEqual([4, 0]);
  });

  test('does not weld a unit grid with tolerance 1', () => {
    const grid = Array.from({ length: 125 }, (_, i) => [i % 5, ((i / 5) | 0) % 5, (i / 25) | 0]);
    const { mesh } = HalfedgeMesh.fromSoup(grid.flat(), [], { weld: 1 });
    expect(mesh.vertexCount).toBe(125);
    mesh.dispose();
  });

  test.each([
    [[0, 0], [], {}, RangeError, 'positions has 2 elements'],
    [CORNERS, [0, 1], {}, RangeError, 'faces has 2 numbers'],
    [CORNERS, [[0, 1.5, 2]], {}, RangeError, 'faces[0][1] is 1.5; expected an index'],
    [CORNERS, [0, 1, Number.NaN], {}, RangeError, 'faces[2] is NaN'],
    [CORNERS, null, {}, TypeError, 'faces is null; expected an array of faces, an index buffer or'],
    [CORNERS, [], { weld: -1 }, RangeError, 'options.weld is -1; expected true, false or a finite'],
    [CORNERS, [], { weld: 'yes' }, TypeError, 'options.weld is "yes"'],
    [CORNERS, [], { weld: Number.NaN }, RangeError, 'options.weld is NaN'],
    [CORNERS, [], { dropIsolated: 1 }, TypeError, 'options.dropIsolated is 1'],
    [CORNERS, { sizes: [4], corners: [0, 1, 2] }, {}, HalfedgeError, 'The face sizes add up to 4'],
    [
      CORNERS,
      { sizes: Int32Array.of(-1), corners: [0] },
      {},
      RangeError,
      'sizes[0] is -1; expected',
    ],
  ])('refuses wrong arguments: %j, %j, %j', (positions, faces, options, kind, message) => {
    const call = () => HalfedgeMesh.fromSoup(positions, faces as never, options as never);
    expect(call).toThrow(kind as never);
    expect(call).toThrow(message);
  });

  test('works without prev', () => {
    const { mesh } = HalfedgeMesh.fromSoup(CORNERS, [...TETRAHEDRON, [0, 1, 2]], {
      storePrev: false,
    });
    expect(errorsOf(mesh)).toEqual([]);
    expect(mesh.connectivity.prev).toHaveLength(0);
    mesh.dispose();
  });

  test('leaves no byte behind', () => {
    const faces = [...TETRAHEDRON, [0, 1, 2], [9, 9, 9], [3, 1, 0]];
    const go = () => {
      HalfedgeMesh.fromSoup(CORNERS, faces, { weld: true }).mesh.dispose();
      expect(() => HalfedgeMesh.fromSoup(CORNERS, { sizes: [9], corners: [0] })).toThrow();
    };
    go();
    const before = bytesInUse();
    for (let i = 0; i < 50; i++) go();
    expect(bytesInUse()).toBe(before);
  });

  test('says so where memory is exhausted, and goes on working', () => {
    const next = random(1);
    const positions = new Float32Array(300_000).map(next);
    const faces = new Uint32Array(300_000).map(() => next() * 100_000);
    for (const bytes of [1, 4, 12, 20].map((megabytes) => megabytes << 20)) {
      withLeft(bytes, () => {
        expect(() => HalfedgeMesh.fromSoup(positions, faces, { weld: true })).toThrow(
          expect.objectContaining({ code: 'out-of-memory' }),
        );
      });
    }
    const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces, { weld: true });
    expectNothingLost(report, 100_000, mesh);
    mesh.dispose();
  });

  test.each([1, 2, 3])('gives the same shape in any order of faces (seed %i)', (seed) => {
    const next = random(seed);
    const positions = Array.from({ length: 60 }, () => next());
    const faces = Array.from({ length: 70 }, () => [0, 1, 2].map(() => (next() * 20) | 0));
    const shape = (list: number[][]) => {
      const { mesh, report } = HalfedgeMesh.fromSoup(positions, list);
      expectNothingLost(report, list.length, mesh);
      const cycles = facesOf(mesh).map((face) => {
        const at = face.indexOf(Math.min(...face));
        return [...face.slice(at), ...face.slice(0, at)].join();
      });
      mesh.dispose();
      return cycles.sort();
    };
    const expected = shape(faces);
    for (let i = 0; i < 5; i++) expect(shape(shuffle([...faces], next))).toEqual(expected);
  });
});

describe('parse with repair', () => {
  const vertices = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n';
  const broken = `${vertices}f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 3 2 1\nf 2 2 2\n`;

  test('mends by default, and names the lines', () => {
    const { mesh, report } = HalfedgeMesh.parse(broken);
    expectNothingLost(report, 6, mesh);
    expect(report.format).toBe('obj');
    expect(report.summary).toBe(
      'OBJ: 4 vertices, 6 edges, 4 faces. 1 face that used a vertex twice left out, 1 duplicate face left out.',
    );
    expect(report.problems.map(({ message }) => message)).toEqual([
      'Face 5 uses vertex 1 more than once, and encloses nothing: it was left out. (Line 10)',
      'Face 0 has the vertices of face 4, which was left out. (Lines 5, 9)',
    ]);
    mesh.dispose();
  });

  test('names few of many lines', () => {
    const { mesh, report } = HalfedgeMesh.parse(`${'v 5 5 5\n'.repeat(30)}${vertices}f 31 32 33\n`);
    expect(
      report.problems.map(({ message, witness }) => [message, witness?.vertices.length]),
    ).toEqual([
      [
        '31 vertices have no faces: 0, 1, 2, 3, 4, 5, 6, 7 and others. (Lines 1, 2, 3, 4, 5, 6, 7, 8 and others)',
        31,
      ],
    ]);
    mesh.dispose();
  });

  test('refuses with repair: false', () => {
    expect(() => HalfedgeMesh.parse(broken, { repair: false })).toThrow(
      expect.objectContaining({ code: 'repeated-vertex' }),
    );
    const { mesh, report } = HalfedgeMesh.parse(vertices, { repair: false });
    expect(report.vertexMap).toEqual(Int32Array.of(0, 1, 2, 3));
    mesh.dispose();
  });
});

const nasty = collected('nasty');
nasty.test('every nasty file becomes a mesh, or its text is no file', () => {
  let meshes = 0;
  for (const file of nasty.files) {
    try {
      const { mesh, report } = HalfedgeMesh.parse(readFileSync(file));
      expectNothingLost(report, report.faceMap.length, mesh);
      mesh.dispose();
      meshes++;
    } catch (error) {
      // What can't be read is told so; faces that make no manifold are never the reason.
      expect([file, error]).toEqual([file, expect.any(HalfedgeError)]);
      expect([file, (error as HalfedgeError).code]).toEqual([
        file,
        expect.stringMatching(
          /^(parse-error|truncated|index-out-of-range|non-finite-position|unknown-format|unsupported-format|not-text|too-large)$/,
        ),
      ]);
    }
  }
  expect(meshes).toBeGreaterThan(45);
});

const good = collected('good');
good.test('repair changes nothing in a good file', () => {
  for (const file of good.files) {
    const bytes = readFileSync(file);
    if (bytes.length > 1.5e6) continue; // the large ones show nothing else
    const { mesh, report } = HalfedgeMesh.parse(bytes);
    const { mesh: strict } = HalfedgeMesh.parse(bytes, { repair: false });
    expect([file, report.verdicts]).toEqual([file, []]);
    expect(Buffer.compare(view(mesh.connectivity.next), view(strict.connectivity.next))).toBe(0);
    mesh.dispose();
    strict.dispose();
  }
});

const view = (array: Int32Array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength);

test('A report tells how many problems it does not list', () => {
  const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, ...new Array(3 * 120).fill(9)];
  const faces = new Array(151).fill([0, 1, 2]);
  const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces);
  expect(report.counts).toEqual({ 'duplicate-face': 150, 'isolated-vertex': 120 });
  expect(report.unlisted).toEqual({ 'duplicate-face': 50 }); // one sentence is about all vertices
  mesh.dispose();
});
