// Measures where there is little to measure, the arrays that they are written to, and what is refused.

import { HalfedgeMesh, init } from 'halfedge';
import { growMemory, growSilently, isDetached } from './support/core.js';
import { at, expectNear, sum } from './support/measures.js';
import {
  bowTie,
  build,
  oneSquare,
  quadGrid,
  tetrahedron,
  triangleAndIsolatedVertex,
} from './support/meshes.js';

beforeAll(() => init());

describe('Where there is little to measure,', () => {
  test('a face without area has no normal', () => {
    using mesh = HalfedgeMesh.fromTriangles([0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 1, 2]);
    expect(mesh.faceNormal(0)).toEqual([0, 0, 0]);
    expect(mesh.faceArea(0)).toBe(0);
    expect(mesh.vertexNormal(1)).toEqual([0, 0, 0]);
    expect(mesh.cotanWeight(0)).toBe(0);
    expect([...mesh.allFaceNormals(), ...mesh.allVertexNormals()]).toEqual(Array(12).fill(0));
  });

  test('a side without length has no angle', () => {
    using mesh = HalfedgeMesh.fromTriangles([0, 0, 0, 0, 0, 0, 1, 0, 0], [0, 1, 2]);
    expect(sum(mesh.allCornerAngles())).toBe(0);
    expect(mesh.dihedralAngle(0)).toBe(0);
  });

  test('normals that cancel each other leave none', () => {
    using pillow = HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2, 0, 2, 1]);
    expect(pillow.vertexNormal(0)).toEqual([0, 0, 0]);
    expect([...pillow.allVertexNormals()]).toEqual(Array(9).fill(0));
    expect([...pillow.allDihedralAngles()]).toEqual([Math.PI, Math.PI, Math.PI]);
    expect(pillow.volume()).toBe(0);
  });

  test.each([
    [[0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]],
    [[0.1, 0.2, 0.3, 1.1, 1.3, 1.7, 1.4, 2.5, 1.9, 0.3, 1.2, 0.5]], // rounding leaves something of them
  ])('also those of quads: %p', (positions) => {
    const sides = [
      [0, 1, 2, 3],
      [1, 0, 3, 2],
    ];
    using pillow = HalfedgeMesh.fromPolygons(positions, sides);
    expect(pillow.vertexNormal(0)).toEqual([0, 0, 0]);
    expect([...pillow.allVertexNormals()]).toEqual(Array(12).fill(0));
  });

  test.each([[[0, 1, 2, 1, 0, 2]], [[1, 0, 2, 0, 1, 2]], [[2, 0, 1, 0, 2, 1]]])(
    'also when rounding leaves something of them: %p',
    (indices) => {
      const positions = [0.1, 0.2, 0.3, 1.1, 1.3, 1.7, 0.3, 1.2, 0.5];
      using pillow = HalfedgeMesh.fromTriangles(positions, indices);
      expect([...pillow.allVertexNormals()]).toEqual(Array(9).fill(0));
      for (const v of pillow.vertices()) expect(pillow.vertexNormal(v)).toEqual([0, 0, 0]);
      expectNear(pillow.allDihedralAngles(), [Math.PI, Math.PI, Math.PI], 1e-6);
      // Nor does the sign of a zero put a fold at -π.
      pillow.positions.set([0, 0, 0, 1, 1, 1, 1, 0, 0]);
      expect([...pillow.allDihedralAngles()]).toEqual([Math.PI, Math.PI, Math.PI]);
    },
  );

  test('small faces beside huge ones still have normals', () => {
    using mesh = HalfedgeMesh.tetrahedron({ radius: 1e-10 });
    using huge = HalfedgeMesh.tetrahedron({ radius: 1e10 });
    mesh.append(huge);
    const normals = mesh.allVertexNormals();
    for (const v of mesh.vertices()) {
      expectNear(normals.subarray(3 * v, 3 * v + 3), at(mesh, v).normalize().toArray(), 1e-6);
    }
  });

  test('an isolated vertex has a full turn, a place and nothing else', () => {
    using mesh = build(triangleAndIsolatedVertex());
    expect(mesh.vertexNormal(3)).toEqual([0, 0, 0]);
    expect(mesh.vertexArea(3)).toBe(0);
    expect(mesh.angleDefect(3)).toBe(2 * Math.PI);
    mesh.setPosition(3, [7, -8, 9]);
    expect(mesh.boundingBox()).toEqual({ min: [0, -8, 0], max: [7, 1, 9] });
    mesh.deleteVertex(3);
    expect(mesh.boundingBox()).toEqual({ min: [0, 0, 0], max: [1, 1, 0] });
  });

  test('a pinched vertex has a gap for each of its fans', () => {
    using tie = build(bowTie());
    expect(tie.isManifoldVertex(2)).toBe(false);
    const angles = [...tie.vertexIncomingHalfedges(2)].map((h) => tie.cornerAngle(h));
    expect(tie.angleDefect(2)).toBeCloseTo(-sum(angles), 12);
  });

  test('an empty mesh has an area of 0, and no box', () => {
    using mesh = new HalfedgeMesh();
    expect(mesh.area()).toBe(0);
    expect(mesh.volume()).toBe(0);
    expect(mesh.boundingBox()).toBeNull();
    expect(mesh.allVertexNormals()).toHaveLength(0);
    expect(mesh.allFaceAreas()).toHaveLength(0);
  });

  test('vertices that lie nowhere are left out of the box, and their faces have no normals', () => {
    using mesh = build(tetrahedron());
    mesh.positions[4] = Number.NaN;
    mesh.positions[11] = Infinity;
    expect(mesh.boundingBox()).toEqual({ min: [0, 0, 0], max: [0, 1, 0] });
    expect(mesh.faceNormal(0)).toEqual([0, 0, 0]);
    expect([...mesh.allVertexNormals()]).toEqual(Array(12).fill(0));
    mesh.positions.fill(Number.NaN);
    expect(mesh.boundingBox()).toBeNull();
    using far = HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 1], [0, 1, 2]);
    far.positions[3] = Infinity;
    expect(far.faceNormal(0)).toEqual([0, 0, 0]);
    far.positions.set([-3e38, 0, 0, 3e38, 0, 0, 0, 3e38, 0]);
    expect(far.faceNormal(0)).toEqual([0, 0, 1]);
  });
});

describe('The array to write to', () => {
  test('may be one of either kind, or a live view of an attribute', () => {
    using mesh = build(quadGrid());
    const singles = new Float32Array(mesh.faceSlots);
    expect(mesh.allFaceAreas(singles)).toBe(singles);
    expect(singles).toEqual(new Float32Array(9).fill(1));
    const doubles = new Float64Array(3 * mesh.vertexSlots);
    expect(mesh.allVertexNormals(doubles)).toBe(doubles);
    mesh.attributes.add('vertex', 'normal', { type: 'float32', components: 3 });
    mesh.allVertexNormals(mesh.attributes.get('vertex', 'normal') as Float32Array);
    expect([...mesh.attributes.values('vertex', 'normal', 5)]).toEqual([0, 0, 1]);
  });

  test('is filled, whatever was in it', () => {
    using mesh = build(quadGrid());
    mesh.deleteFace(4);
    expect(mesh.allFaceAreas(new Float64Array(9).fill(7))[4]).toBe(0);
    expect([...mesh.allFaceNormals(new Float32Array(27).fill(7)).subarray(12, 15)]).toEqual([
      0, 0, 0,
    ]);
    expect(mesh.allVertexAreas(new Float64Array(16).fill(7))).toEqual(mesh.allVertexAreas());
    expect(mesh.allCornerAngles(new Float64Array(mesh.halfedgeSlots).fill(7))).toEqual(
      mesh.allCornerAngles(),
    );
  });

  test('may be too long or too short', () => {
    using mesh = build(quadGrid());
    const long = new Float64Array(12).fill(7);
    const areas = mesh.allFaceAreas(long);
    expect(areas).toHaveLength(9);
    expect(areas.buffer).toBe(long.buffer);
    expect([...long]).toEqual([...Array(9).fill(1), 7, 7, 7]);
    const short = new Float32Array(8);
    const others = mesh.allFaceAreas(short);
    expect(others).toEqual(new Float32Array(9).fill(1));
    expect(short).toEqual(new Float32Array(8));
  });

  test('is refused if it is anything else', () => {
    using mesh = build(quadGrid());
    expect(() => mesh.allFaceAreas([] as never)).toThrow(
      new TypeError('into is an array of 0 elements; expected a Float32Array or a Float64Array.'),
    );
    expect(() => mesh.allVertexNormals(new Uint32Array(48) as never)).toThrow(
      'into is a Uint32Array of 48 elements; expected a Float32Array or a Float64Array.',
    );
    expect(() => mesh.allFaceNormals(Float32Array as never)).toThrow(
      'into is a function; expected a Float32Array or a Float64Array.',
    );
  });

  test('is refused if the positions lie there, which are read meanwhile', () => {
    using mesh = HalfedgeMesh.icoSphere(1);
    const before = mesh.positions.slice();
    for (const all of [
      'allFaceCentroids',
      'allFaceNormals',
      'allVertexNormals',
      'allVertexAreas',
    ] as const) {
      expect(() => mesh[all](mesh.positions)).toThrow(
        `into is a Float32Array of ${before.length} elements; expected another array than that of the positions.`,
      );
    }
    const { buffer, byteOffset } = mesh.positions;
    expect(() => mesh.allFaceAreas(new Float32Array(buffer, byteOffset - 400, 101))).toThrow(
      'expected another array',
    );
    expect(() => mesh.allFaceAreas(new Float32Array(buffer, byteOffset + 4, 400))).toThrow(
      'expected another array',
    );
    expect(mesh.positions).toEqual(before);
  });
});

describe('What is asked for', () => {
  test('has to exist', () => {
    using mesh = build(quadGrid());
    expect(() => mesh.faceNormal(9)).toThrow(
      new RangeError('f is 9; expected a face from 0 to 8.'),
    );
    expect(() => mesh.edgeLength(-1)).toThrow(RangeError);
    expect(() => mesh.cornerAngle(1.5)).toThrow('h is 1.5; expected a halfedge');
    expect(() => mesh.vertexArea('1' as never)).toThrow(TypeError);
    mesh.deleteFace(4);
    expect(() => mesh.faceArea(4)).toThrow('f is face 4, which was deleted; expected a live one.');
    const h = mesh.vertexHalfedge(0);
    mesh.deleteVertex(0);
    const deleted = /^. is (vertex|halfedge|edge) \d+, which was deleted; expected a live one\.$/;
    expect(() => mesh.angleDefect(0)).toThrow(deleted);
    expect(() => mesh.cornerAngle(h)).toThrow(deleted);
    expect(() => mesh.edgeLength(h >> 1)).toThrow(deleted);
    expect(() => mesh.edgeLength(20.5)).toThrow('e is 20.5; expected an edge');
    expect(() => mesh.edgeLength(2 ** 32)).toThrow('e is 4294967296; expected an edge');
    mesh.dispose();
    for (const ask of [
      () => mesh.faceArea(0),
      () => mesh.allFaceAreas(),
      () => mesh.allVertexNormals(),
      () => mesh.area(),
      () => mesh.volume(),
      () => mesh.boundingBox(),
    ]) {
      expect(ask).toThrow(/^This mesh was disposed/);
    }
  });

  test('has to be a triangle for a cotangent weight', () => {
    using mesh = build(oneSquare());
    const e = mesh.edge(mesh.faceHalfedge(0));
    expect(() => mesh.cotanWeight(e)).toThrow(
      new RangeError(`e is edge ${e}, beside which face 0 has 4 corners; expected triangles.`),
    );
    expect(() => mesh.allCotanWeights()).toThrow(
      new RangeError(
        'This mesh has edge 0, beside which face 0 has 4 corners; expected triangles.',
      ),
    );
  });

  test('has to be closed for a volume', () => {
    using mesh = build(quadGrid());
    expect(() => mesh.volume()).toThrow(
      'This mesh has 1 boundary loop; expected a closed surface, which has none: fillHoles() closes them.',
    );
    expect(() => mesh.volume()).toThrow(expect.objectContaining({ code: 'open-surface' }));
  });

  test.each([growMemory, growSilently])('is there when memory has grown: %p', (grow) => {
    using mesh = HalfedgeMesh.cube();
    for (const ask of [
      () => mesh.faceArea(0),
      () => mesh.edgeLength(0),
      () => mesh.vertexArea(0) / 0.75,
      () => mesh.angleDefect(0) / (Math.PI / 2),
      () => mesh.area() / 6,
      () => mesh.volume(),
      () => sum(mesh.allFaceAreas()) / 6,
      () => sum(mesh.allVertexAreas()) / 6,
      () => Math.hypot(...mesh.allVertexNormals().subarray(0, 3)),
      () => mesh.boundingBox()?.max[0] ?? 0,
    ]) {
      expect(ask()).toBeCloseTo(ask === undefined ? 0 : ask(), 12);
      grow();
      if (grow === growSilently) expect(isDetached(mesh)).toBe(true);
      expect(ask()).toBeGreaterThan(0.49);
    }
  });
});
