import { HalfedgeMesh, init } from 'halfedge';
import { bytesInUse } from './support/core.js';

beforeAll(() => init());

/** The volume that the faces enclose; positive if they face outwards. */
function volumeOf(mesh: HalfedgeMesh): number {
  const { positions: p } = mesh;
  const { indices } = mesh.toTriangles();
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    sum +=
      p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) +
      p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) +
      p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  return sum / 6;
}

const counts = (mesh: HalfedgeMesh) => [mesh.vertexCount, mesh.edgeCount, mesh.faceCount];
const fan = 'fan' as const;
const open = 'open' as const;

describe('A shape', () => {
  const shapes: [string, () => HalfedgeMesh, number[], loops: number, genus: number][] = [
    ['tetrahedron', () => HalfedgeMesh.tetrahedron(), [4, 6, 4], 0, 0],
    ['cube', () => HalfedgeMesh.cube(), [8, 12, 6], 0, 0],
    ['octahedron', () => HalfedgeMesh.octahedron(), [6, 12, 8], 0, 0],
    ['icosahedron', () => HalfedgeMesh.icosahedron(), [12, 30, 20], 0, 0],
    ['dodecahedron', () => HalfedgeMesh.dodecahedron(), [20, 30, 12], 0, 0],
    ['prism(5)', () => HalfedgeMesh.prism(5), [10, 15, 7], 0, 0],
    ['cone(4)', () => HalfedgeMesh.cone(4), [5, 8, 5], 0, 0],
    ['cone(4), fan', () => HalfedgeMesh.cone(4, { base: fan }), [6, 12, 8], 0, 0],
    ['cone(4), open', () => HalfedgeMesh.cone(4, { base: open }), [5, 8, 4], 1, 0],
    ['cylinder(6)', () => HalfedgeMesh.cylinder(6), [12, 18, 8], 0, 0],
    [
      'cylinder(6), rings and fans',
      () => HalfedgeMesh.cylinder(6, { rings: 2, caps: fan }),
      [20, 42, 24],
      0,
      0,
    ],
    [
      'cylinder(6), open triangles',
      () => HalfedgeMesh.cylinder(6, { caps: open, triangles: true }),
      [12, 24, 12],
      2,
      0,
    ],
    ['grid()', () => HalfedgeMesh.grid(), [121, 220, 100], 1, 0],
    ['grid(3)', () => HalfedgeMesh.grid(3), [16, 24, 9], 1, 0],
    ['grid(4, 2)', () => HalfedgeMesh.grid(4, 2, { triangles: true }), [15, 30, 16], 1, 0],
    ['torus(8, 5)', () => HalfedgeMesh.torus(8, 5), [40, 80, 40], 0, 1],
    ['torus, triangles', () => HalfedgeMesh.torus(8, 5, { triangles: true }), [40, 120, 80], 0, 1],
    ['uvSphere(8, 5)', () => HalfedgeMesh.uvSphere(8, 5), [34, 72, 40], 0, 0],
    ['icoSphere(2)', () => HalfedgeMesh.icoSphere(2), [162, 480, 320], 0, 0],
  ];
  test.each(shapes)(
    '%s has the items it promises, and faces outwards',
    (_, make, items, ...rest) => {
      const before = bytesInUse();
      const mesh = make();
      expect(counts(mesh)).toEqual(items);
      expect([mesh.boundaryLoops().length, mesh.genus()]).toEqual(rest);
      expect(mesh.validate()).toEqual([]);
      if (rest[0] === 0) expect(volumeOf(mesh)).toBeGreaterThan(0.1);
      mesh.dispose();
      expect(bytesInUse()).toBe(before);
    },
  );

  test('takes its lengths as options', () => {
    using cube = HalfedgeMesh.cube({ size: 3 });
    expect(volumeOf(cube)).toBeCloseTo(27);
    using ball = HalfedgeMesh.icoSphere(5, { radius: 2 });
    expect(volumeOf(ball)).toBeCloseTo((32 * Math.PI) / 3, 0);
    for (const v of ball.vertices()) expect(Math.hypot(...ball.position(v))).toBeCloseTo(2, 5);
    using can = HalfedgeMesh.cylinder(100, { radius: 2, height: 3, rings: 2 });
    expect(volumeOf(can)).toBeCloseTo(12 * Math.PI, 0);
    using ring = HalfedgeMesh.torus(100, 100, { radius: 3, tube: 1 });
    expect(volumeOf(ring)).toBeCloseTo(6 * Math.PI ** 2, 0);
    using sheet = HalfedgeMesh.grid(2, 2, { width: 4, height: 2 });
    expect(sheet.position(0)).toEqual([-2, -1, 0]);
    expect(sheet.position(8)).toEqual([2, 1, 0]);
  });

  test('takes the storage options', () => {
    using mesh = HalfedgeMesh.torus(4, 3, { storePrev: false });
    expect(mesh.connectivity.prev).toHaveLength(0);
    expect(mesh.genus()).toBe(1);
  });

  test('can be made through a list of functions', () => {
    const made = [HalfedgeMesh.cube, HalfedgeMesh.octahedron].map((make) => make());
    expect(made.map((mesh) => mesh.faceCount)).toEqual([6, 8]);
    for (const mesh of made) mesh.dispose();
  });

  test('refuses what is none, in sentences', () => {
    const before = bytesInUse();
    const calls: [() => unknown, Error][] = [
      [
        () => HalfedgeMesh.prism(2 ** 31),
        new RangeError('sides is 2147483648; expected an integer from 3 to 2147483647.'),
      ],
      [() => HalfedgeMesh.prism(2), new RangeError('sides is 2; expected an integer from 3 on.')],
      [
        () => HalfedgeMesh.cone(3.5),
        new RangeError('segments is 3.5; expected an integer from 3 on.'),
      ],
      [
        () => HalfedgeMesh.torus('3' as never),
        new TypeError('rings is "3"; expected an integer from 3 on.'),
      ],
      [
        () => HalfedgeMesh.cylinder(3, { rings: 0 }),
        new RangeError('options.rings is 0; expected an integer from 1 on.'),
      ],
      [
        () => HalfedgeMesh.uvSphere(3, 1),
        new RangeError('rings is 1; expected an integer from 2 on.'),
      ],
      [
        () => HalfedgeMesh.grid(2, Infinity),
        new RangeError('rows is Infinity; expected an integer from 1 on.'),
      ],
      [
        () => HalfedgeMesh.cube({ size: -1 }),
        new RangeError('options.size is -1; expected a positive number that fits a 32-bit float.'),
      ],
      [
        () => HalfedgeMesh.cube({ size: 1e-46 }),
        new RangeError(
          'options.size is 1e-46; expected a positive number that fits a 32-bit float.',
        ),
      ],
      [
        () => HalfedgeMesh.icosahedron({ radius: 1e40 }),
        new RangeError(
          'options.radius is 1e+40; expected a positive number that fits a 32-bit float.',
        ),
      ],
      [
        () => HalfedgeMesh.icosahedron({ radius: 3.4028235e38 }),
        new RangeError(
          'options.radius is 3.4028235e+38; expected a positive number that fits a 32-bit float.',
        ),
      ],
      [
        () => HalfedgeMesh.torus(3, 3, { radius: 2e38, tube: 2e38 }),
        new RangeError(
          'options.radius + options.tube is 4e+38; expected a positive number that fits a 32-bit float.',
        ),
      ],
      [
        () => HalfedgeMesh.torus(3, 3, { tube: null as never }),
        new TypeError('options.tube is null; expected a positive number that fits a 32-bit float.'),
      ],
      [
        () => HalfedgeMesh.cone(3, { base: 'round' as never }),
        new RangeError(`options.base is "round"; expected 'polygon', 'fan' or 'open'.`),
      ],
      [
        () => HalfedgeMesh.grid(3, 3, { triangles: 1 as never }),
        new TypeError('options.triangles is 1; expected true or false.'),
      ],
      [
        () => HalfedgeMesh.icosahedron(2 as never),
        new TypeError('options is 2; expected an object.'),
      ],
    ];
    for (const [call, error] of calls) {
      expect(call).toThrow(error);
      expect(call).toThrow(error.constructor as ErrorConstructor);
    }
    expect(() => HalfedgeMesh.icoSphere(13)).toThrow(
      expect.objectContaining({ code: 'too-large' }),
    );
    expect(() => HalfedgeMesh.grid(2 ** 20)).toThrow(
      expect.objectContaining({ code: 'too-large' }),
    );
    expect(bytesInUse()).toBe(before);
  });
});
