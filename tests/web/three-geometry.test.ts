import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { fromBufferGeometry, MeshGeometry, toBufferGeometry } from 'halfedge/three';
import * as THREE from 'three';
import { concavePolygon } from './support/concave.js';
import { bytesInUse } from './support/core.js';
import { GEOMETRIES } from './support/three-geometries.js';

beforeAll(() => init());

const topologyOf = (mesh: HalfedgeMesh) => [
  mesh.vertexCount,
  mesh.edgeCount,
  mesh.faceCount,
  mesh.genus(),
  mesh.boundaryLoops().length,
];

/** The values of a corner, in the order of the names. */
function corner(geometry: THREE.BufferGeometry, names: string[], row: number): number[] {
  return names.flatMap((name) => {
    const attribute = geometry.getAttribute(name);
    return Array.from({ length: attribute.itemSize }, (_, k) => attribute.getComponent(row, k));
  });
}

const rowAt = ({ index }: THREE.BufferGeometry, i: number) => (index ? index.getX(i) : i);

/** The corners of a triangle, beginning with the least: where it begins doesn't matter. */
function triangle(geometry: THREE.BufferGeometry, names: string[], at: number): string {
  const corners = [0, 1, 2].map((k) => corner(geometry, names, rowAt(geometry, 3 * at + k)).join());
  const least = corners.indexOf([...corners].sort()[0]);
  return [0, 1, 2].map((k) => corners[(least + k) % 3]).join(' | ');
}

/** A square of two triangles, with changes. */
function square(change: (geometry: THREE.BufferGeometry) => void = () => {}): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  const xyz = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(xyz), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  change(geometry);
  return geometry;
}

function thrownBy(call: () => unknown): HalfedgeError {
  try {
    call();
  } catch (error) {
    return error as HalfedgeError;
  }
  throw new Error('It did not throw.');
}

describe.each(GEOMETRIES)('%s', (_name, make, topology) => {
  test('becomes the mesh that it looks like', () => {
    const { mesh } = fromBufferGeometry(make());
    expect(mesh.validate()).toEqual([]);
    expect(topologyOf(mesh)).toEqual(topology);
    expect(mesh.components()).toHaveLength(1);
    expect(mesh.attributes.has('face', 'group')).toBe(make().groups.length > 0);
    mesh.dispose();
  });

  test.each([
    ['as it is', (geometry: THREE.BufferGeometry) => geometry],
    [
      'without an index',
      (geometry: THREE.BufferGeometry) => (geometry.index ? geometry.toNonIndexed() : geometry),
    ],
  ])('comes back with each corner as it was, read %s', (_, change) => {
    const geometry = change(make());
    const { mesh, maps } = fromBufferGeometry(geometry);
    expect(topologyOf(mesh)).toEqual(topology);
    const { geometry: back, faces } = toBufferGeometry(mesh);
    const names = ['normal', 'uv'];
    const triangleOf = new Map(Array.from(faces, (f, i) => [f as number, i]));
    maps.faces.forEach((f, input) => {
      if (f < 0) return; // degenerate: lathes and capsules have such at their poles
      expect(triangle(back, names, triangleOf.get(f) as number)).toBe(
        triangle(geometry, names, input),
      );
      expect(maps.triangles[f]).toBe(input);
    });
    expect(faces).toHaveLength(mesh.faceCount);
    mesh.dispose();
  });

  test('has maps between its vertices and the corners of the mesh', () => {
    const geometry = make();
    const { mesh, maps } = fromBufferGeometry(geometry);
    const at = geometry.getAttribute('position');
    for (const h of mesh.halfedges()) {
      const row = maps.corners[h];
      if (mesh.isBoundaryHalfedge(h)) expect(row).toBe(-1);
      else {
        expect(maps.vertices[row]).toBe(mesh.toVertex(h));
        const [x, y, z] = mesh.position(mesh.toVertex(h));
        const apart = Math.hypot(at.getX(row) - x, at.getY(row) - y, at.getZ(row) - z);
        expect(apart).toBeLessThan(1e-5);
        const { offsets, items } = maps.halfedges;
        expect([...items.subarray(offsets[row], offsets[row + 1])]).toContain(h);
      }
    }
    expect(maps.halfedges.items).toHaveLength(3 * mesh.faceCount);
    mesh.dispose();
  });
});

describe('fromBufferGeometry', () => {
  test('reads a CapsuleGeometry, whose numbers of rings differ between versions', () => {
    const { mesh } = fromBufferGeometry(new THREE.CapsuleGeometry(1, 2, 4, 8));
    expect(mesh.validate()).toEqual([]);
    expect([mesh.isClosed(), mesh.genus(), mesh.components().length]).toEqual([true, 0, 1]);
  });

  test('leaves vertices apart if asked to, or joins those within a distance', () => {
    const box = new THREE.BoxGeometry();
    expect(fromBufferGeometry(box, { weld: false }).mesh.components()).toHaveLength(6);
    expect(fromBufferGeometry(box, { weld: 0 }).mesh.vertexCount).toBe(8);
    // The seam of a sphere is not closed exactly: sin(2π) is not 0.
    expect(fromBufferGeometry(new THREE.SphereGeometry(), { weld: 0 }).mesh.isClosed()).toBe(false);
    expect(fromBufferGeometry(new THREE.SphereGeometry(), { weld: 1e-9 }).mesh.isClosed()).toBe(
      true,
    );
  });

  test('reads interleaved attributes and such of integers', () => {
    const geometry = square((g) => {
      const rows = [0, 1, 2, 3].map((i) => [
        ...[0, 1, 2].map((k) => g.attributes.position.getComponent(i, k)),
        i / 4,
        1 - i / 4,
      ]);
      const buffer = new THREE.InterleavedBuffer(new Float32Array(rows.flat()), 5);
      g.setAttribute('position', new THREE.InterleavedBufferAttribute(buffer, 3, 0));
      g.setAttribute('uv', new THREE.InterleavedBufferAttribute(buffer, 2, 3));
      g.setAttribute(
        'normal',
        new THREE.BufferAttribute(
          new Int8Array([0, 0, 127, 0, 127, 0, -127, 0, 0, 0, 0, 127]),
          3,
          true,
        ),
      );
      g.setAttribute(
        'color',
        new THREE.BufferAttribute(
          new Uint8Array(16).map((_, i) => 10 * i),
          4,
          true,
        ),
      );
      g.setAttribute(
        'skinIndex',
        new THREE.BufferAttribute(
          new Uint16Array(16).map((_, i) => 1000 * i),
          4,
        ),
      );
      g.setAttribute(
        'weight',
        new THREE.Float16BufferAttribute(
          [0, 1, 2, 3].map((x) => THREE.DataUtils.toHalfFloat(x / 2)),
          1,
        ),
      );
    });
    const { mesh } = fromBufferGeometry(geometry);
    expect([...mesh.positions]).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    const get = (name: string) => [...mesh.attributes.get('vertex', name)];
    expect(get('uv')).toEqual([0, 1, 0.25, 0.75, 0.5, 0.5, 0.75, 0.25]);
    expect(get('normal')).toEqual([0, 0, 1, 0, 1, 0, -1, 0, 0, 0, 0, 1]);
    expect(get('color')).toEqual(Array.from({ length: 16 }, (_, i) => 10 * i));
    expect(get('skinIndex')).toEqual(Array.from({ length: 16 }, (_, i) => 1000 * i));
    expect(get('weight')).toEqual([0, 0.5, 1, 1.5]);
    const kinds = mesh.attributes
      .list()
      .map(({ name, type, onSplit }) => `${name} ${type} ${onSplit}`);
    expect(kinds).toContain('color uint8 interpolate');
    expect(kinds).toContain('skinIndex uint16 copy');
    expect(kinds).toContain('normal float32 normalize');
    const back = toBufferGeometry(mesh).geometry;
    expect(back.attributes.color).toMatchObject({
      normalized: true,
      array: new Uint8Array(get('color')),
    });
    expect(back.attributes.skinIndex).toMatchObject({
      normalized: false,
      array: new Uint16Array(get('skinIndex')),
    });
  });

  test('takes colours in other integers than bytes as the numbers that they are', () => {
    const geometry = square((g) => {
      const numbers = Array.from({ length: 12 }, (_, i) => 10 * i - 40);
      g.setAttribute('color', new THREE.Int16BufferAttribute(numbers, 3));
      g.morphAttributes.color = [new THREE.Int16BufferAttribute(new Array(12).fill(60), 3)];
    });
    using mesh = fromBufferGeometry(geometry).mesh;
    const back = toBufferGeometry(mesh).geometry;
    expect(back.attributes.color.normalized).toBe(false);
    expect(back.attributes.color.getX(0)).toBe(-40);
    expect(back.morphAttributes.color?.[0].getX(0)).toBe(100);
    expect(new MeshGeometry(mesh).attributes.color.normalized).toBe(false);
  });

  test('leaves a vertex that is made between two the bones of one of them, with their weights', () => {
    const geometry = square((g) => {
      const bones = [0, 1, 2, 3].flatMap((i) => [2 * i, 2 * i + 1, 0, 0]);
      const weights = [0, 1, 2, 3].flatMap((i) => (i % 2 ? [0.25, 0.75, 0, 0] : [1, 0, 0, 0]));
      g.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(bones, 4));
      g.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4));
    });
    const { mesh } = fromBufferGeometry(geometry);
    const bound = (v: number) =>
      ['skinIndex', 'skinWeight'].map((name) => mesh.attributes.values('vertex', name, v));
    const [a, b] = mesh.edgeVertices(mesh.findEdge(0, 1));
    const ends = [bound(a), bound(b)];
    expect(ends).toContainEqual(bound(mesh.splitEdge(mesh.findEdge(0, 1))));
  });

  test('leaves labels at their corners, along a seam too', () => {
    const corners = [0, 1, 2, 0, 2, 3];
    const geometry = new THREE.BufferGeometry();
    const positions = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
    const rows = corners.flatMap((v) => positions.slice(3 * v, 3 * v + 3));
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(rows, 3));
    const labels = [0, 1, 2, 99, 2, 3];
    geometry.setAttribute('label', new THREE.Uint16BufferAttribute(labels, 1));
    const { mesh } = fromBufferGeometry(geometry);
    expect(mesh.attributes.list()).toMatchObject([{ kind: 'halfedge', onSplit: 'copy-corner' }]);
    mesh.flipEdge(mesh.findEdge(0, 2));
    const at = (v: number) =>
      [...mesh.vertexIncomingHalfedges(v)]
        .filter((h) => !mesh.isBoundaryHalfedge(h))
        .map((h) => mesh.attributes.values('halfedge', 'label', h)[0]);
    expect(at(1)).toEqual([1, 1]);
    expect(at(3)).toEqual([3, 3]);
  });

  test('reads interleaved attributes of more than four components, normalised or not', () => {
    const rows = Int8Array.from({ length: 40 }, (_, i) => (i % 10 < 5 ? i : 127));
    const buffer = new THREE.InterleavedBuffer(rows, 10);
    const geometry = square((g) => {
      g.setAttribute('plain', new THREE.InterleavedBufferAttribute(buffer, 5, 0));
      g.setAttribute('unit', new THREE.InterleavedBufferAttribute(buffer, 5, 5, true));
    });
    const { mesh } = fromBufferGeometry(geometry);
    const plain = [0, 1, 2, 3].flatMap((row) => [0, 1, 2, 3, 4].map((k) => 10 * row + k));
    expect([...mesh.attributes.get('vertex', 'plain')]).toEqual(plain);
    expect([...mesh.attributes.get('vertex', 'unit')]).toEqual(Array(20).fill(1));
  });

  test('gives faces the material of their group', () => {
    const { mesh, maps } = fromBufferGeometry(new THREE.BoxGeometry());
    const group = mesh.attributes.get('face', 'group');
    maps.faces.forEach((f, i) => {
      expect(group[f]).toBe(Math.floor(i / 2));
    });
    const { geometry } = toBufferGeometry(mesh);
    expect(geometry.groups).toEqual(new THREE.BoxGeometry().groups);
    expect(toBufferGeometry(mesh, { groups: false }).geometry.groups).toEqual([]);
  });

  test('puts the triangles of groups in their order, those of none last', () => {
    const mesh = HalfedgeMesh.tetrahedron();
    mesh.attributes.add('face', 'group', { type: 'int32' }).set([1, -1, 0, 1]);
    const { geometry, faces } = toBufferGeometry(mesh);
    expect([...faces]).toEqual([2, 0, 3, 1]);
    expect(geometry.groups).toEqual([
      { start: 0, count: 3, materialIndex: 0 },
      { start: 3, count: 6, materialIndex: 1 },
    ]);
  });

  test('reads what is drawn only', () => {
    const geometry = square((g) => g.setDrawRange(3, 3));
    const { mesh, maps } = fromBufferGeometry(geometry, { dropIsolated: true });
    expect([mesh.vertexCount, mesh.faceCount]).toEqual([3, 1]);
    expect([...maps.vertices]).toEqual([0, -1, 1, 2]);
    const whole = square((g) => g.setDrawRange(0, Infinity));
    expect(fromBufferGeometry(whole).mesh.faceCount).toBe(2);
  });

  test('counts from a start before the first as three.js does', () => {
    const geometry = square((g) => g.setDrawRange(-3, 6));
    const drawn = fromBufferGeometry(geometry, { dropIsolated: true });
    expect([...drawn.maps.vertices]).toEqual([0, 1, 2, -1]);
    expect(drawn.mesh.faceCount).toBe(1);
    const nothing = square((g) => g.setDrawRange(-6, 3));
    expect(fromBufferGeometry(nothing).mesh.faceCount).toBe(0);
  });

  test.each([false, true])('reads morph targets and gives them back, relative: %s', (relative) => {
    const geometry = square((g) => {
      const base = g.attributes.position.array;
      const moved = Float32Array.from(base, (x, i) => (relative ? 0 : x) + (i % 3 === 2 ? 0.5 : 0));
      g.morphAttributes.position = [new THREE.BufferAttribute(moved, 3)];
      g.morphTargetsRelative = relative;
    });
    const { mesh } = fromBufferGeometry(geometry);
    const by = mesh.attributes.get('vertex', 'morph position 0');
    expect([...by]).toEqual([0, 0, 0.5, 0, 0, 0.5, 0, 0, 0.5, 0, 0, 0.5]);
    const v = mesh.splitEdge(mesh.findEdge(0, 2));
    expect(mesh.attributes.values('vertex', 'morph position 0', v)).toEqual([0, 0, 0.5]);
    const back = toBufferGeometry(mesh).geometry;
    expect(back.morphTargetsRelative).toBe(true);
    expect(back.morphAttributes.position).toHaveLength(1);
    expect(back.morphAttributes.position?.[0].getZ(4)).toBe(0.5);
    expect(back.attributes).not.toHaveProperty('morph position 0');
  });

  const wrong: [string, string, RegExp, (g: THREE.BufferGeometry) => void][] = [
    [
      'no positions',
      'no-positions',
      /attributes\.position is missing; expected/,
      (g) => g.deleteAttribute('position'),
    ],
    [
      'positions of two numbers',
      'no-positions',
      /position has 2 components; expected 3/,
      (g) => g.setAttribute('position', new THREE.BufferAttribute(new Float32Array(6), 2)),
    ],
    [
      'a position and a part of one',
      'truncated',
      /attributes\.position has 8 numbers; expected a multiple of 3, for whole rows/,
      (g) => g.setAttribute('position', new THREE.BufferAttribute(new Float32Array(8), 3)),
    ],
    [
      'too few rows',
      'truncated',
      /attributes\.uv has 2 rows; expected 4/,
      (g) => g.setAttribute('uv', new THREE.BufferAttribute(new Float32Array(4), 2)),
    ],
    [
      'half a triangle',
      'truncated',
      /geometry\.index has 5 elements to be drawn; expected a multiple of 3/,
      (g) => g.setIndex([0, 1, 2, 0, 2]),
    ],
    [
      'groups across triangles',
      'bad-group',
      /groups\[0\] goes from 1 to 4; expected whole/,
      (g) => g.addGroup(1, 3),
    ],
    [
      'groups that overlap',
      'bad-group',
      /groups\[1\] has triangle 1, which an earlier one has/,
      (g) => {
        g.addGroup(0, 6, 0);
        g.addGroup(3, 3, 1);
      },
    ],
    [
      'attributes of instances',
      'unsupported-attribute',
      /attributes\.offset is one of instances/,
      (g) => g.setAttribute('offset', new THREE.InstancedBufferAttribute(new Float32Array(12), 3)),
    ],
    [
      'attributes without an array',
      'unsupported-attribute',
      /attributes\.uv has no array/,
      (g) =>
        g.setAttribute(
          'uv',
          new THREE.GLBufferAttribute({} as WebGLBuffer, 5126, 2, 4, 4) as never,
        ),
    ],
    [
      'an index without an array',
      'unsupported-attribute',
      /^geometry\.index has no array \(a GLBufferAttribute/,
      (g) => g.setIndex(new THREE.GLBufferAttribute({} as WebGLBuffer, 5125, 1, 4, 6) as never),
    ],
    [
      'an index in rows of three',
      'unsupported-attribute',
      /^geometry\.index has 3 components; expected 1, a vertex for each corner\.$/,
      (g) => g.setIndex(new THREE.BufferAttribute(new Uint16Array([0, 1, 2, 0, 2, 3, 0, 1, 3]), 3)),
    ],
    [
      'morph targets of another size',
      'unsupported-attribute',
      /morphAttributes\.normal\[0\] has 3 components; expected those of geometry\.attributes\.normal/,
      (g) => {
        g.morphAttributes.normal = [new THREE.BufferAttribute(new Float32Array(12), 3)];
      },
    ],
  ];

  test('gives no morph targets behind one that is missing', () => {
    using mesh = HalfedgeMesh.cube();
    const add = (i: number) =>
      mesh.attributes.add('vertex', `morph position ${i}`, { components: 3 });
    for (const i of [3, 1, 0]) add(i);
    const { geometry } = toBufferGeometry(mesh);
    expect(Object.keys(geometry.morphAttributes.position as object)).toEqual(['0', '1']);
    expect(geometry.attributes).toHaveProperty('morph position 3');
    geometry.computeBoundingSphere();
    mesh.attributes.remove('vertex', 'morph position 0');
    expect(toBufferGeometry(mesh).geometry.morphAttributes).toEqual({});
  });

  test.each(wrong)(
    'refuses %s with a sentence, and leaves no memory behind',
    (_, code, sentence, change) => {
      const before = bytesInUse();
      const error = thrownBy(() => fromBufferGeometry(square(change)));
      expect(error).toBeInstanceOf(HalfedgeError);
      expect([error.code, error.message]).toEqual([code, expect.stringMatching(sentence)]);
      expect(bytesInUse()).toBe(before);
    },
  );

  test('refuses what is no geometry, or one of instances', () => {
    for (const wrong of [null, 5, {}, new THREE.Mesh()]) {
      expect(() => fromBufferGeometry(wrong as never)).toThrow(
        /^geometry is .*; expected a BufferGeometry of three\.js\.$/,
      );
    }
    expect(() => fromBufferGeometry(new THREE.InstancedBufferGeometry())).toThrow(
      /InstancedBufferGeometry; expected/,
    );
    expect(() => fromBufferGeometry(square(), { repair: 1 } as never)).toThrow(
      /options\.repair is 1; expected true or false\./,
    );
  });

  test('mends what makes no manifold, or refuses it if asked to', () => {
    const fin = square((g) => g.setIndex([0, 1, 2, 0, 2, 3, 0, 2, 1]));
    expect(fromBufferGeometry(fin).report.problems.length).toBeGreaterThan(0);
    const before = bytesInUse();
    const error = thrownBy(() => fromBufferGeometry(fin, { repair: false }));
    expect(error).toBeInstanceOf(HalfedgeError);
    expect(error.message).toMatch(/^This can't be built without repair, which says: /);
    expect(error.problems).toMatchObject([{ code: error.code, severity: 'error' }]);
    expect(bytesInUse()).toBe(before);
  });
});

describe('toBufferGeometry', () => {
  test('cuts polygons, concave ones too, and tells the face of each triangle', () => {
    for (let seed = 1; seed <= 20; seed++) {
      const { positions, faces } = concavePolygon(seed);
      const mesh = HalfedgeMesh.fromPolygons(positions, faces);
      const { geometry, faces: faceOf } = toBufferGeometry(mesh);
      const index = geometry.index?.array as Uint32Array;
      expect(faceOf).toHaveLength(faces[0].length - 2);
      let area = 0;
      for (let i = 0; i < index.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map((k) => mesh.position(index[i + k]));
        const twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        expect(twice).toBeGreaterThan(-1e-6); // none folds over, seed in the loop
        area += twice / 2;
      }
      const whole = faces[0].reduce((sum, v, i) => {
        const [p, q] = [3 * v, 3 * faces[0][(i + 1) % faces[0].length]];
        return sum + (positions[p] * positions[q + 1] - positions[p + 1] * positions[q]) / 2;
      }, 0);
      expect({ seed, area }).toEqual({ seed, area: expect.closeTo(whole, 4) });
      mesh.dispose();
    }
  });

  test('maps triangles of mixed polygons to faces, deleted slots aside', () => {
    const mesh = HalfedgeMesh.prism(5);
    mesh.makeHole(1);
    const { geometry, faces, vertices } = toBufferGeometry(mesh);
    const degrees = new Map<number, number>();
    for (const f of faces) degrees.set(f, (degrees.get(f) ?? 0) + 1);
    expect([...degrees]).toEqual(
      mesh
        .faces()
        .toArray()
        .map((f) => [f, mesh.degree(f) - 2]),
    );
    faces.forEach((f, i) => {
      for (let k = 0; k < 3; k++) {
        const v = vertices[rowAt(geometry, 3 * i + k)];
        expect(mesh.faceVertices(f).toArray()).toContain(v);
      }
    });
  });

  test('has smooth normals, flat ones, or none', () => {
    const cube = HalfedgeMesh.cube({ size: 2 });
    const smooth = toBufferGeometry(cube).geometry.attributes;
    expect(smooth.position.count).toBe(8);
    for (let i = 0; i < 24; i++)
      expect(smooth.normal.array[i]).toBeCloseTo(smooth.position.array[i] / Math.sqrt(3));
    const flat = toBufferGeometry(cube, { normals: 'flat' });
    expect(flat.geometry.attributes.position.count).toBe(24);
    flat.faces.forEach((f, i) => {
      const normal = new THREE.Vector3().fromBufferAttribute(
        flat.geometry.attributes.normal,
        rowAt(flat.geometry, 3 * i),
      );
      const centre = cube
        .faceVertices(f)
        .toArray()
        .reduce((sum, v) => sum.add(new THREE.Vector3(...cube.position(v))), new THREE.Vector3());
      expect(normal.distanceTo(centre.divideScalar(4))).toBeLessThan(1e-6);
    });
    expect(toBufferGeometry(cube, { normals: 'none' }).geometry.attributes).not.toHaveProperty(
      'normal',
    );
    expect(() => toBufferGeometry(cube, { normals: 'soft' } as never)).toThrow(
      "options.normals is \"soft\"; expected 'smooth', 'flat' or 'none'.",
    );
  });

  test('shows the attributes that are named', () => {
    const { mesh } = fromBufferGeometry(new THREE.BoxGeometry());
    const names = (options: object) =>
      Object.keys(toBufferGeometry(mesh, options).geometry.attributes).sort();
    expect(names({})).toEqual(['normal', 'position', 'uv']);
    expect(names({ attributes: [], normals: 'none' })).toEqual(['position']);
    expect(toBufferGeometry(mesh, { attributes: [], normals: 'none' }).vertices).toHaveLength(8);
    expect(() => names({ attributes: ['uv', 'heat'] })).toThrow(
      'options.attributes names "heat"; expected attributes of the vertices or halfedges of the mesh.',
    );
  });

  test('leaves the mesh as it was, and no memory behind', () => {
    const mesh = HalfedgeMesh.dodecahedron();
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    const [before, { version }] = [bytesInUse(), mesh];
    const bytes = mesh.toBytes();
    toBufferGeometry(mesh);
    expect(bytesInUse()).toBe(before);
    expect([mesh.version, mesh.toBytes()]).toEqual([version, bytes]);
    mesh.dispose();
    expect(() => toBufferGeometry(mesh)).toThrow(/disposed/);
    expect(() => toBufferGeometry({} as never)).toThrow(
      'mesh is an Object; expected a HalfedgeMesh.',
    );
  });

  test('reads back as the mesh it was made of', () => {
    const mesh = HalfedgeMesh.torus(12, 7);
    const { geometry } = toBufferGeometry(mesh, { normals: 'flat' });
    const { mesh: back } = fromBufferGeometry(geometry);
    expect(topologyOf(back)).toEqual([84, 252, 168, 1, 0]);
    expect(back.attributes.list().map(({ kind, name }) => [kind, name])).toEqual([
      ['halfedge', 'normal'],
    ]);
  });
});
