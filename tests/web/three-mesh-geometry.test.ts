import { HalfedgeMesh, init } from 'halfedge';
import {
  fromBufferGeometry,
  type GeometryOptions,
  MeshGeometry,
  toBufferGeometry,
} from 'halfedge/three';
import * as THREE from 'three';
import { withLeft } from './support/core.js';
import { addAttributes } from './support/editing.js';
import { randomPolygons } from './support/meshes.js';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

const LAYOUTS: [string, GeometryOptions][] = [
  ['indexed, with smooth normals', { attributes: [] }],
  ['indexed, without normals', { attributes: ['tone'], normals: 'none' }],
  ['with flat normals', { attributes: [], normals: 'flat' }],
  ['with texture coordinates and smooth normals', { attributes: ['uv', 'tone'] }],
];

/** By face, its triangles as it shows them: all values of all corners. */
function facesOf(geometry: MeshGeometry): Map<number, number[][]> {
  const faces = new Map<number, number[][]>();
  const names = Object.keys(geometry.attributes).sort();
  const { start, count } = geometry.drawRange;
  for (let at = start; at < start + count; at += 3) {
    const corners = [0, 1, 2].map((k) => geometry.index?.getX(at + k) ?? at + k);
    const values = corners.flatMap((row) =>
      names.flatMap((name) => {
        const { itemSize, array } = geometry.attributes[name] as THREE.BufferAttribute;
        return [...array.subarray(row * itemSize, (row + 1) * itemSize)];
      }),
    );
    const face = geometry.face(at / 3);
    if (face >= 0) faces.set(face, [...(faces.get(face) ?? []), values]);
    else if (geometry.index) expect(new Set(corners).size).toBe(1);
    else expect(new Set([0, 3, 6].map((k) => positionAt(geometry, at + k / 3))).size).toBe(1);
  }
  return faces;
}

const positionAt = ({ attributes: { position } }: THREE.BufferGeometry, row: number) =>
  [position.getX(row), position.getY(row), position.getZ(row)].join();

/** What a graphics card holds, which is sent whole buffers once and ranges from then on. */
class Card {
  readonly #copies = new Map<THREE.BufferAttribute, { array: Float32Array; version: number }>();

  upload({ attributes, index }: THREE.BufferGeometry): void {
    for (const attribute of [
      ...Object.values(attributes),
      ...(index ? [index] : []),
    ] as THREE.BufferAttribute[]) {
      const copy = this.#copies.get(attribute);
      if (copy === undefined) {
        this.#copies.set(attribute, {
          array: attribute.array.slice() as Float32Array,
          version: attribute.version,
        });
        continue;
      }
      if (copy.version === attribute.version) continue;
      for (const { start, count } of attribute.updateRanges) {
        copy.array.set(attribute.array.subarray(start, start + count), start);
      }
      attribute.clearUpdateRanges();
      copy.version = attribute.version;
    }
  }

  /** Whether it has all that is drawn. */
  expectUpToDate({ attributes, index }: THREE.BufferGeometry): void {
    for (const attribute of [
      ...Object.values(attributes),
      ...(index ? [index] : []),
    ] as THREE.BufferAttribute[]) {
      const { array } = this.#copies.get(attribute) as { array: Float32Array };
      const different = array.findIndex((value, i) => !Object.is(value, attribute.array[i]));
      expect(different).toBe(-1);
    }
  }
}

/** Equal, but for rounding of normals. */
function expectSame(
  geometry: MeshGeometry,
  mesh: HalfedgeMesh,
  options: GeometryOptions,
  what: string,
): void {
  const fresh = new MeshGeometry(mesh, options);
  const [shown, expected] = [facesOf(geometry), facesOf(fresh)];
  expect([what, [...shown.keys()].sort()]).toEqual([what, [...expected.keys()].sort()]);
  for (const [face, triangles] of expected) {
    const mine = (shown.get(face) as number[][]).flat();
    const other = triangles.flat();
    const wrong = other.findIndex(
      (value, i) => !(Math.abs(value - mine[i]) <= 1e-5 * (1 + Math.abs(value))),
    );
    if (wrong >= 0 || mine.length !== other.length)
      expect([what, face, mine]).toEqual([what, face, other]);
  }
}

describe.each(LAYOUTS)('MeshGeometry, %s,', (_name, options) => {
  test.each(Array.from({ length: 8 }, (_, i) => i + 1))(
    'shows what a fresh one shows after random edits, undone and done again: seed %i',
    (seed) => {
      const next = random(seed);
      const { positions, faces } = randomPolygons(seed);
      const { mesh } = HalfedgeMesh.fromSoup(positions, faces);
      addAttributes(mesh, next);
      mesh.attributes
        .add('vertex', 'tone', { type: 'float64', components: 3 })
        .forEach((_, i, view) => {
          view[i] = next();
        });
      mesh.history.enabled = true;
      const geometry = new MeshGeometry(mesh, options);
      const card = new Card();
      card.upload(geometry);
      for (let i = 0; i < 30; i++) {
        const some = 1 + Math.floor(3 * next());
        const done: string[] = [];
        for (let k = 0; k < some; k++) {
          const way = next();
          const { history } = mesh;
          if (way < 0.15) done.push(`undo ${history.undo()}`);
          else if (way < 0.25) done.push(`redo ${history.redo()}`);
          else if (way < 0.3 && mesh.vertexCount > 0) {
            const every = next() < 0.5 ? 1 : mesh.vertexSlots;
            const moved = mesh.vertices().toArray();
            for (let at = 0; at < moved.length; at += every)
              mesh.positions[3 * moved[at] + 1] += 0.25 + 0.1 * next();
            done.push(`moved one in ${every}`);
          } else {
            const made = randomEdit(mesh, next);
            refusalOf(made);
            done.push(made.name);
          }
        }
        geometry.update();
        const what = `seed ${seed}, step ${i}: ${done.join('; ')}`;
        expectSame(geometry, mesh, options, what);
        expect(geometry.update()).toEqual({ faces: 0, bytes: 0 });
        card.upload(geometry);
        card.expectUpToDate(geometry);
      }
      mesh.dispose();
    },
  );

  test.each([1, 3, 4, 5, 100])(
    'shows what a fresh one shows after one vertex in %i of a mesh with gaps has moved',
    (every) => {
      using mesh = HalfedgeMesh.torus(9, 6);
      addAttributes(mesh, random(1));
      mesh.attributes.add('vertex', 'tone').fill(0.5);
      mesh.triangulate(7);
      for (const f of [1, 20, 21, 40]) mesh.deleteFace(f);
      mesh.deleteVertex(30);
      const geometry = new MeshGeometry(mesh, options);
      const card = new Card();
      card.upload(geometry);
      const told: number[] = [];
      geometry.onChange((faces) => told.push(...(faces ?? [])));
      const moved = mesh.vertices().toArray();
      for (const v of moved) if (v % every === 0) mesh.positions[3 * v + 2] += Math.sin(v + 1);
      expect(geometry.update().faces).toBeLessThan(mesh.faceCount);
      expectSame(geometry, mesh, options, `one in ${every}`);
      const around = moved.filter((v) => v % every === 0).flatMap((v) => [...mesh.vertexFaces(v)]);
      expect(new Set(told)).toEqual(new Set(around));
      expect(told).toHaveLength(new Set(around).size); // each once
      expect(geometry.update()).toEqual({ faces: 0, bytes: 0 });
      card.upload(geometry);
      card.expectUpToDate(geometry);
    },
  );

  test('draws what toBufferGeometry draws', () => {
    const { mesh } = fromBufferGeometry(new THREE.TorusGeometry(1, 0.4, 6, 9));
    mesh.attributes.add('vertex', 'tone');
    const geometry = new MeshGeometry(mesh, options);
    const { geometry: other, faces } = toBufferGeometry(mesh, options);
    const shown = facesOf(geometry);
    expect(Object.keys(geometry.attributes).sort()).toEqual(Object.keys(other.attributes).sort());
    faces.forEach((f, i) => {
      const names = Object.keys(other.attributes).sort();
      const values = [0, 1, 2].flatMap((k) => {
        const row = (other.index as THREE.BufferAttribute).getX(3 * i + k);
        return names.flatMap((name) => {
          const { itemSize, array } = other.attributes[name] as THREE.BufferAttribute;
          return [...array.subarray(row * itemSize, (row + 1) * itemSize)];
        });
      });
      expect(shown.get(f)).toEqual([values]);
    });
  });
});

describe('MeshGeometry', () => {
  test('keeps bounds around what moves, and none around what is not there', () => {
    const mesh = HalfedgeMesh.cube({ size: 2 });
    const geometry = new MeshGeometry(mesh);
    geometry.computeBoundingSphere();
    geometry.computeBoundingBox();
    expect(geometry.boundingSphere?.radius).toBeCloseTo(Math.sqrt(3));
    mesh.setPosition(0, [-5, 0, 0]);
    geometry.update();
    expect(geometry.boundingBox?.min.x).toBe(-5);
    expect(geometry.boundingSphere?.containsPoint(new THREE.Vector3(-5, 0, 0))).toBe(true);
    mesh.deleteVertex(0);
    geometry.update();
    geometry.computeBoundingBox();
    expect(geometry.boundingBox?.min.x).toBe(-1);
  });

  test.each(LAYOUTS)('keeps bounds around vertices that come back: %s', (_, options) => {
    using mesh = HalfedgeMesh.cube();
    mesh.attributes.add('vertex', 'tone');
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    mesh.setPosition(0, [-5, 0, 0]);
    mesh.history.enabled = true;
    const geometry = new MeshGeometry(mesh, options);
    mesh.deleteVertex(0);
    geometry.update();
    geometry.computeBoundingBox();
    geometry.computeBoundingSphere();
    mesh.history.undo();
    geometry.update();
    expect(geometry.boundingBox?.min.x).toBe(-5);
    expect(geometry.boundingSphere?.containsPoint(new THREE.Vector3(-5, 0, 0))).toBe(true);
  });

  test('keeps bounds away from what was deleted after it had moved', () => {
    using mesh = HalfedgeMesh.cube({ size: 2 });
    const geometry = new MeshGeometry(mesh);
    geometry.computeBoundingBox();
    mesh.setPosition(0, [-5, 0, 0]);
    mesh.deleteVertex(0);
    geometry.update();
    expect(geometry.boundingBox?.min.x).toBe(-1);
  });

  test('keeps bounds around what moves while most of it is deleted', () => {
    using mesh = HalfedgeMesh.icoSphere(4);
    const geometry = new MeshGeometry(mesh);
    geometry.computeBoundingBox();
    geometry.computeBoundingSphere();
    for (const f of mesh.faces().toArray().slice(0, 4000)) mesh.deleteFace(f);
    const [v] = mesh.faceVertices(mesh.faces().toArray()[0]);
    mesh.setPosition(v, [-5, 0, 0]);
    geometry.update();
    expect(geometry.boundingBox?.min.x).toBe(-5);
    expect(geometry.boundingSphere?.containsPoint(new THREE.Vector3(-5, 0, 0))).toBe(true);
  });

  test('follows the faces behind the first, which is deleted and compacted away in one go', () => {
    using mesh = HalfedgeMesh.tetrahedron();
    const geometry = new MeshGeometry(mesh);
    mesh.deleteFace(0);
    mesh.compact();
    geometry.update();
    expect(facesOf(geometry)).toEqual(facesOf(new MeshGeometry(mesh)));
  });

  test('is picked by triangles, which tell their face', () => {
    const mesh = HalfedgeMesh.dodecahedron();
    const geometry = new MeshGeometry(mesh);
    expect(geometry.triangles(3)).toEqual({ first: 9, count: 3 });
    const ray = new THREE.Raycaster(
      new THREE.Vector3(0, 0, 5),
      new THREE.Vector3(0.03, 0.02, -1).normalize(),
    );
    const [hit] = ray.intersectObject(new THREE.Mesh(geometry));
    const face = geometry.face(hit.faceIndex as number);
    expect(mesh.faceVertices(face).toArray()).toContain(hit.face?.a);
    expect(geometry.face(1e6)).toBe(-1);
  });

  test('grows, and takes up room again that was freed', () => {
    const mesh = HalfedgeMesh.icoSphere(2);
    const geometry = new MeshGeometry(mesh);
    const { position } = geometry.attributes;
    let disposed = 0;
    geometry.addEventListener('dispose', () => {
      disposed += 1;
    });
    for (let i = 0; i < 400; i++) mesh.splitEdge(i);
    geometry.update();
    expect(disposed).toBe(1);
    expect(geometry.attributes.position).not.toBe(position);
    expectSame(geometry, mesh, {}, 'after growth');
    const end = geometry.drawRange.count;
    for (const f of mesh.faces().toArray()) if (mesh.checkMakeHole(f) === null) mesh.makeHole(f);
    geometry.update();
    for (const h of mesh.boundaryLoops().slice(0, 5)) mesh.fillHole(h);
    geometry.update();
    expect(geometry.drawRange.count).toBe(end);
    expectSame(geometry, mesh, {}, 'after holes');
  });

  test('Listeners are told every face that an edit has changed, each once', () => {
    using mesh = HalfedgeMesh.icosahedron();
    const geometry = new MeshGeometry(mesh);
    const told: unknown[] = [];
    const ascending = (faces: Iterable<number>) => [...faces].sort((a, b) => a - b);
    geometry.onChange((faces) => told.push(ascending(faces ?? [])));
    const flipped = ascending(mesh.edgeFaces(12));
    mesh.flipEdge(12);
    geometry.update();
    const v = mesh.splitFace(7);
    geometry.update();
    expect(told).toEqual([flipped, ascending(mesh.vertexFaces(v))]);
  });

  test('is made anew where most of it shows nothing', () => {
    const mesh = HalfedgeMesh.icoSphere(4);
    const geometry = new MeshGeometry(mesh, { normals: 'flat' });
    for (const f of mesh.faces().toArray().slice(0, 4000)) mesh.deleteFace(f);
    expect(geometry.update().faces).toBe(4000);
    expect(geometry.drawRange.count).toBe(3 * mesh.faceCount);
    mesh.compact();
    geometry.update();
    expectSame(geometry, mesh, { normals: 'flat' }, 'after compact()');
  });

  test.each(LAYOUTS)('has nothing to be seen beyond its draw range: %s', (_, options) => {
    using mesh = HalfedgeMesh.icoSphere(4);
    mesh.attributes.add('vertex', 'tone');
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    const geometry = new MeshGeometry(mesh, options);
    for (const f of mesh.faces().toArray().slice(0, 4000)) mesh.deleteFace(f);
    geometry.update(); // which makes it anew
    const { attributes } = geometry.index ? geometry.toNonIndexed() : geometry;
    const triangle = new THREE.Triangle();
    let count = 0;
    for (let row = 0; row < attributes.position.count; row += 3) {
      triangle.setFromAttributeAndIndices(attributes.position, row, row + 1, row + 2);
      if (triangle.getArea() > 0) count += 1;
    }
    expect(count).toBe(mesh.faceCount);
  });

  test.each(LAYOUTS)('takes up later what an update had no room for: %s', (_, options) => {
    using mesh = HalfedgeMesh.dodecahedron();
    mesh.attributes.add('vertex', 'tone');
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    const geometry = new MeshGeometry(mesh, options);
    geometry.computeBoundingBox();
    const told: unknown[] = [];
    geometry.onChange((faces) => told.push(faces));
    mesh.setPosition(0, [3, 3, 3]);
    mesh.poke(7);
    withLeft(0, () => expect(() => geometry.update()).toThrow(/^There is no room/));
    expect(told).toEqual([]);
    expect(geometry.update().faces).toBe(mesh.faceCount);
    expect(told).toEqual([null]);
    expectSame(geometry, mesh, options, 'after an update that failed');
    expect(geometry.boundingBox?.max.x).toBe(3);
    expect(geometry.update()).toEqual({ faces: 0, bytes: 0 });
  });

  test('tells all listeners of an update, and throws what the first of them throws', () => {
    using mesh = HalfedgeMesh.cube();
    const geometry = new MeshGeometry(mesh);
    const told: unknown[] = [];
    geometry.onChange(() => {
      throw new Error('The first of them is busy.');
    });
    geometry.onChange((faces) => {
      told.push(faces);
      throw new Error('The second as well.');
    });
    geometry.onChange((faces) => told.push(faces));
    mesh.poke(0);
    expect(() => geometry.update()).toThrow('The first of them is busy.');
    expect(told).toHaveLength(2);
    expect(geometry.update()).toEqual({ faces: 0, bytes: 0 });
    expect(told).toHaveLength(2);
  });

  test.each(['smooth', 'flat'] as const)(
    'has no attributes of morph targets, unless they are named: %s',
    (normals) => {
      const box = new THREE.BoxGeometry();
      const twice = [...box.attributes.position.array].map((x) => 2 * x);
      box.morphAttributes.position = [new THREE.Float32BufferAttribute(twice, 3)];
      using mesh = fromBufferGeometry(box).mesh;
      const name = 'morph position 0';
      expect(mesh.attributes.list().map((info) => info.name)).toContain(name);
      expect(new MeshGeometry(mesh, { normals }).attributes).not.toHaveProperty([name]);
      const named = new MeshGeometry(mesh, { normals, attributes: [name] });
      expect(named.attributes).toHaveProperty([name]);
      // An ordinary geometry has them as targets.
      const { data } = new MeshGeometry(mesh, { normals }).toJSON();
      expect(data).toHaveProperty('morphAttributes.position');
    },
  );

  test('refuses to show an attribute that is gone or another, until it is back', () => {
    using mesh = HalfedgeMesh.cube();
    const { attributes } = mesh;
    attributes.add('vertex', 'tone', { components: 2 });
    const geometry = new MeshGeometry(mesh);
    const refused = (what: string) =>
      expect(() => geometry.update()).toThrow(
        `The vertex attribute "tone" ${what}; expected 2 × float32, as when the geometry was made: make another one.`,
      );
    attributes.remove('vertex', 'tone');
    mesh.poke(2);
    refused('is gone');
    attributes.add('vertex', 'tone', { components: 3 });
    refused('has 3 × float32');
    attributes.remove('vertex', 'tone');
    attributes.add('vertex', 'tone', { components: 2, type: 'uint8' });
    refused('has 2 × uint8');
    attributes.remove('vertex', 'tone');
    attributes.add('vertex', 'tone', { components: 2, default: 1 });
    geometry.update();
    expectSame(geometry, mesh, {}, 'with the attribute again');
  });

  test('refuses what is no living mesh', () => {
    expect(() => new MeshGeometry({} as never)).toThrow(
      'mesh is an Object; expected a HalfedgeMesh.',
    );
    const mesh = HalfedgeMesh.cube();
    const geometry = new MeshGeometry(mesh);
    const copy = geometry.clone();
    expect([copy.mesh === mesh, copy.drawRange.count]).toEqual([true, 36]);
    mesh.dispose();
    expect(() => geometry.update()).toThrow(/disposed/);
  });

  test('copies itself with the options that it was given, inherited ones among them', () => {
    using mesh = HalfedgeMesh.cube();
    const flat = new MeshGeometry(mesh, Object.create({ normals: 'flat' }));
    Object.assign(flat, { name: 'box', userData: { id: 7 } });
    const copy = flat.clone();
    expect([flat.index, copy.index]).toEqual([null, null]);
    expect([copy.name, copy.userData]).toEqual(['box', { id: 7 }]);
  });

  test('refuses to copy another geometry, and is copied by ordinary ones', () => {
    using mesh = HalfedgeMesh.cube();
    using other = HalfedgeMesh.grid(2);
    const geometry = new MeshGeometry(mesh);
    const before = geometry.attributes.position;
    for (const source of [new MeshGeometry(other), new THREE.BoxGeometry(), geometry]) {
      expect(() => geometry.copy(source)).toThrow(
        "A MeshGeometry can't copy another geometry, because it shows its own mesh",
      );
    }
    expect(geometry.attributes.position).toBe(before);
    expectSame(geometry, mesh, {}, 'after a copy that was refused');
    const copy = new THREE.BufferGeometry().copy(geometry);
    expect(copy.drawRange).toEqual(geometry.drawRange);
    expect(copy.attributes.position.array).toEqual(before.array);
  });

  test('refuses what is no list of names, and no listener', () => {
    using mesh = HalfedgeMesh.cube();
    mesh.attributes.add('vertex', 'uv', { components: 2 });
    expect(() => new MeshGeometry(mesh, { attributes: 'uv' as never })).toThrow(
      'options.attributes is "uv"; expected an array of names.',
    );
    expect(() => new MeshGeometry(mesh).onChange({} as never)).toThrow(
      'listener is an Object; expected a function.',
    );
  });
});

describe('MeshGeometry of a million faces', () => {
  const EDITS: [string, (mesh: HalfedgeMesh) => unknown][] = [
    ['a flip', (mesh) => mesh.flipEdge(mesh.edge(mesh.faceHalfedge(500_000)))],
    ['a split', (mesh) => mesh.splitEdge(mesh.edge(mesh.faceHalfedge(400_000)))],
    ['a collapse', (mesh) => mesh.collapse(mesh.faceHalfedge(300_000))],
    ['an undo', (mesh) => mesh.history.undo()],
    ['a vertex that moves', (mesh) => mesh.setPosition(1000, [0, 0, 0.1])],
  ];

  test.each([
    ['indexed', {}],
    ['with flat normals', { normals: 'flat' }],
  ] as [string, GeometryOptions][])('%s, uploads kilobytes after an edit', (name, options) => {
    const mesh = HalfedgeMesh.grid(708, 708, { triangles: true });
    expect(mesh.faceCount).toBeGreaterThan(1_000_000);
    mesh.history.enabled = true;
    const geometry = new MeshGeometry(mesh, options);
    const lines: string[] = [];
    for (const [what, run] of EDITS) {
      run(mesh);
      const began = performance.now();
      const { faces, bytes } = geometry.update();
      const took = performance.now() - began;
      const marked = [...Object.values(geometry.attributes), geometry.index ?? []]
        .flatMap((attribute) => (attribute as THREE.BufferAttribute).updateRanges ?? [])
        .reduce((sum, { count }) => sum + 4 * count, 0);
      for (const attribute of [...Object.values(geometry.attributes), geometry.index])
        (attribute as THREE.BufferAttribute | null)?.clearUpdateRanges();
      lines.push(`${what}: ${faces} faces, ${bytes} bytes, ${took.toFixed(1)} ms`);
      expect(marked).toBe(bytes);
      expect(bytes).toBeGreaterThan(0);
      expect(bytes).toBeLessThan(8192);
    }
    console.log(`A million faces, ${name}\n${lines.join('\n')}`);
    mesh.dispose();
  });
});

test.each(['Float32Array', 'Uint32Array'] as const)(
  'An update that JavaScript has no room for is an error, and is made up for: %s',
  (name) => {
    using mesh = HalfedgeMesh.torus(12, 8, { triangles: true });
    const geometry = new MeshGeometry(mesh);
    mesh.positions.forEach((x, i, positions) => {
      positions[i] = 2 * x;
    });
    const Kind = globalThis[name];
    const full = new Proxy(Kind, {
      construct(target, given, newTarget) {
        if (given[0] > 0) throw new RangeError('Array buffer allocation failed');
        return Reflect.construct(target, given, newTarget);
      },
    });
    Object.assign(globalThis, { [name]: full });
    try {
      expect(() => geometry.update()).toThrow(/needs room for \d+ numbers, more than JavaScript/);
    } finally {
      Object.assign(globalThis, { [name]: Kind });
    }
    geometry.update();
    expectSame(geometry, mesh, {}, 'after an update that failed');
  },
);

describe('The JSON of a scene', () => {
  test.each(LAYOUTS)('holds an ordinary geometry: %s', (_, options) => {
    using mesh = HalfedgeMesh.cube();
    mesh.attributes.add('vertex', 'tone', { type: 'float64', components: 3, default: 0.5 });
    mesh.attributes.add('halfedge', 'uv', { components: 2 }).fill(1, 0, 10);
    const geometry = new MeshGeometry(mesh, options);
    mesh.deleteFace(3);
    mesh.poke(2, 0.5); // which the geometry doesn't know yet
    geometry.name = 'box';
    geometry.userData.id = 7;
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial()));
    const json = JSON.parse(JSON.stringify(scene.toJSON()));
    const [read] = new THREE.ObjectLoader().parse(json).children as THREE.Mesh[];
    expect(read.geometry.type).toBe('BufferGeometry');
    expect(read.geometry.uuid).toBe(geometry.uuid);
    expect(read.geometry.name).toBe('box');
    expect(read.geometry.userData).toEqual({ id: 7 });
    const expected = toBufferGeometry(mesh, { ...options, groups: false }).geometry;
    expect(read.geometry.index?.array).toEqual(expected.index?.array);
    expect(Object.keys(read.geometry.attributes)).toEqual(Object.keys(expected.attributes));
    for (const name of Object.keys(expected.attributes)) {
      expect(read.geometry.attributes[name].array).toEqual(expected.attributes[name].array);
    }
  });
});

test.each(LAYOUTS)(
  'Buffers are of the usage that is uploaded only when it changes: %s',
  (_, options) => {
    using mesh = HalfedgeMesh.cube();
    mesh.attributes.add('vertex', 'tone', { components: 3 });
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    const geometry = new MeshGeometry(mesh, options);
    const usages = () =>
      [...Object.values(geometry.attributes), geometry.index].map(
        (attribute) => (attribute as THREE.BufferAttribute | null)?.usage ?? THREE.StaticDrawUsage,
      );
    expect(new Set(usages())).toEqual(new Set([THREE.StaticDrawUsage]));
    for (let i = 0; i < 4; i++) for (const f of [...mesh.faces()]) mesh.poke(f);
    geometry.update(); // in longer buffers
    expect(new Set(usages())).toEqual(new Set([THREE.StaticDrawUsage]));
  },
);
