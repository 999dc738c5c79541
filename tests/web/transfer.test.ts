import { HalfedgeMesh, init } from 'halfedge';
import { bytesInUse } from './support/core.js';
import { expectRefused } from './support/editing.js';
import { random } from './support/random.js';

beforeAll(() => init());

/** Corners of each face, from the smallest on. */
function facesOf(mesh: HalfedgeMesh): number[][] {
  return [...mesh.faces()].map((f) => {
    const corners: number[] = [...mesh.faceVertices(f)];
    const at = corners.indexOf(Math.min(...corners));
    return [...corners.slice(at), ...corners.slice(0, at)];
  });
}

function arraysOf(mesh: HalfedgeMesh): number[][] {
  const views = Object.values(mesh.connectivity) as Int32Array[];
  return [...views, mesh.positions].map((view) => Array.from<number>(view));
}

describe('append', () => {
  test('adds a copy, and tells where its items are', () => {
    using mesh = HalfedgeMesh.cube();
    using other = HalfedgeMesh.torus(4, 3);
    const before = facesOf(mesh);
    const { vertices, halfedges, edges, faces } = mesh.append(other);
    expect(mesh.validate()).toEqual([]);
    expect([mesh.vertexCount, mesh.edgeCount, mesh.faceCount]).toEqual([20, 36, 18]);
    expect(mesh.components().map(({ genus }) => genus)).toEqual([0, 1]);
    expect(facesOf(mesh).slice(0, 6)).toEqual(before);
    for (const h of other.halfedges()) {
      expect(halfedges[h] >> 1).toBe(edges[other.edge(h)]);
      expect(mesh.next(halfedges[h])).toBe(halfedges[other.next(h)]);
      expect(mesh.prev(halfedges[h])).toBe(halfedges[other.prev(h)]);
      expect(mesh.toVertex(halfedges[h])).toBe(vertices[other.toVertex(h)]);
      expect(mesh.face(halfedges[h])).toBe(faces[other.face(h)]);
    }
    for (const v of other.vertices()) {
      expect(mesh.position(vertices[v])).toEqual(other.position(v));
    }
  });

  test('doubles a mesh that is appended to itself, again and again', () => {
    using mesh = HalfedgeMesh.grid(2, 2, { storePrev: false });
    for (let i = 0; i < 8; i++) mesh.append(mesh);
    expect(mesh.faceCount).toBe(4 * 256);
    expect(mesh.components()).toHaveLength(256);
    expect(mesh.validate()).toEqual([]);
  });

  test('is one step of history, and ends circulators', () => {
    using mesh = HalfedgeMesh.cube();
    using other = HalfedgeMesh.octahedron();
    const before = arraysOf(mesh);
    mesh.history.enabled = true;
    const vertices = mesh.vertices();
    mesh.append(other);
    expect(() => [...vertices]).toThrow();
    const after = arraysOf(mesh);
    mesh.history.undo();
    expect(arraysOf(mesh)).toEqual(before);
    mesh.history.redo();
    expect(arraysOf(mesh)).toEqual(after);
  });

  test('copies the attributes that both have', () => {
    using mesh = HalfedgeMesh.cube();
    using other = HalfedgeMesh.tetrahedron();
    mesh.attributes.add('vertex', 'colour', { type: 'uint8', components: 3, default: 7 });
    mesh.attributes.add('face', 'label', { type: 'int16' });
    other.attributes.add('vertex', 'colour', { type: 'uint8', components: 3 }).fill(200);
    other.attributes.add('face', 'label', { type: 'float32' }).fill(1);
    other.attributes.add('edge', 'crease').fill(1);
    mesh.append(other);
    expect(Array.from(mesh.attributes.get('vertex', 'colour').subarray(18, 30))).toEqual([
      ...Array(6).fill(7),
      ...Array(6).fill(200),
    ]);
    expect(Array.from(mesh.attributes.get('face', 'label'))).toEqual(Array(10).fill(0));
    expect(mesh.attributes.has('edge', 'crease')).toBe(false);
  });

  test('refuses what is no mesh, or a corrupt one, and changes nothing', () => {
    using mesh = HalfedgeMesh.cube();
    using other = HalfedgeMesh.cube();
    const before = arraysOf(mesh);
    const bytes = bytesInUse();
    expect(() => mesh.append({} as never)).toThrow(
      new TypeError('other is an Object; expected a HalfedgeMesh.'),
    );
    other.connectivity.next[5] = 1000;
    expect(() => mesh.append(other)).toThrow(
      expect.objectContaining({
        code: 'corrupt-connectivity',
        message: expect.stringContaining('he next of halfedge 5'),
      }),
    );
    other.dispose();
    for (const ask of [() => mesh.append(other), () => mesh.checkAppend(other)]) {
      expect(ask).toThrow(/^other was disposed: its memory is freed/);
    }
    expect(() => other.append(mesh)).toThrow(/^This mesh was disposed: its memory is freed/);
    expect(arraysOf(mesh)).toEqual(before);
    expect(bytesInUse()).toBeLessThan(bytes);
  });
});

describe('extract', () => {
  test('makes a mesh of some faces, and tells what its items are copies of', () => {
    using mesh = HalfedgeMesh.torus(8, 5, { storePrev: false });
    mesh.deleteFace(3 as never);
    const before = arraysOf(mesh);
    const { mesh: part, vertices, edges, faces } = mesh.extract([12, 17, 11, 12]);
    using _ = part;
    expect(part.validate()).toEqual([]);
    expect(part.connectivity.prev).toHaveLength(0);
    expect(Array.from(faces)).toEqual([11, 12, 17]);
    expect([part.vertexCount, part.edgeCount, part.faceCount]).toEqual([8, 10, 3]);
    const original = (h: number) => 2 * edges[h >> 1] + (h & 1);
    for (const h of part.halfedges()) {
      expect(vertices[part.toVertex(h)]).toBe(mesh.toVertex(original(h)));
      if (part.face(h) === -1) continue;
      expect(faces[part.face(h)]).toBe(mesh.face(original(h)));
      expect(original(part.next(h))).toBe(mesh.next(original(h)));
    }
    for (const v of part.vertices()) expect(part.position(v)).toEqual(mesh.position(vertices[v]));
    expect(arraysOf(mesh)).toEqual(before);
  });

  test('takes components apart, which appended to each other are the mesh again', () => {
    using mesh = HalfedgeMesh.icoSphere(2);
    using torus = HalfedgeMesh.torus(7, 6);
    mesh.append(torus);
    const parts = mesh.components().map(({ faces }) => mesh.extract(faces).mesh);
    expect(parts.map((part) => part.genus())).toEqual([0, 1]);
    using again = new HalfedgeMesh();
    for (const part of parts) {
      again.append(part);
      part.dispose();
    }
    expect(arraysOf(again)).toEqual(arraysOf(mesh));
  });

  test('carries attributes over', () => {
    using mesh = HalfedgeMesh.cube();
    const uv = mesh.attributes.add('halfedge', 'uv', { components: 2 });
    uv.forEach((_, i) => {
      uv[i] = i;
    });
    mesh.attributes.add('face', 'label', { type: 'int16', default: -3, onSplit: 'copy' })[4] = 9;
    const { mesh: part, edges } = mesh.extract(Uint32Array.of(1, 4));
    using _ = part;
    const copied = part.attributes.get('halfedge', 'uv');
    for (const h of part.halfedges()) {
      expect(copied[2 * h + 1]).toBe(2 * (2 * edges[h >> 1] + (h & 1)) + 1);
    }
    expect(Array.from(part.attributes.get('face', 'label'))).toEqual([-3, 9]);
    expect(part.attributes.list()).toEqual(mesh.attributes.list());
  });

  test('names the face that is none, keeps no memory, and changes nothing', () => {
    using mesh = HalfedgeMesh.cube();
    const bytes = bytesInUse();
    mesh.extract([0, 1, 2]).mesh.dispose();
    mesh.deleteFace(2 as never);
    expect(() => mesh.extract([0, 6])).toThrow('faces[1] is 6; expected a face');
    expect(() => mesh.extract([0, 2])).toThrow('faces[1] is face 2, which was deleted');
    expect(() => mesh.extract(['0'] as never)).toThrow(TypeError);
    expect(() => mesh.extract(undefined as never)).toThrow('faces is undefined; expected');
    mesh.connectivity.next[mesh.faceHalfedge(4 as never)] = -1;
    const before = arraysOf(mesh);
    expect(() => mesh.extract([0, 4])).toThrow(
      expect.objectContaining({ code: 'corrupt-connectivity' }),
    );
    expect(bytesInUse()).toBe(bytes);
    expect(arraysOf(mesh)).toEqual(before);
    mesh.dispose();
    expect(() => mesh.extract([0])).toThrow(/disposed/);
  });
});

describe('dual', () => {
  test('exchanges the regular solids', () => {
    for (const [make, faces, degree] of [
      [HalfedgeMesh.tetrahedron, 4, 3],
      [HalfedgeMesh.cube, 8, 3],
      [HalfedgeMesh.octahedron, 6, 4],
      [HalfedgeMesh.icosahedron, 12, 5],
      [HalfedgeMesh.dodecahedron, 20, 3],
    ] as const) {
      using mesh = make();
      using dual = mesh.dual();
      using again = dual.dual();
      expect(dual.faceCount).toBe(faces);
      for (const f of dual.faces()) expect(dual.degree(f)).toBe(degree);
      expect(dual.validate()).toEqual([]);
      expect(facesOf(again)).toEqual(facesOf(mesh));
    }
  });

  test('has its vertices in the centroids, and no face around a boundary vertex', () => {
    using mesh = HalfedgeMesh.grid(3, 3, { width: 3, height: 3, storePrev: false });
    using dual = mesh.dual();
    expect(facesOf(dual)).toEqual([
      [0, 1, 4, 3],
      [1, 2, 5, 4],
      [3, 4, 7, 6],
      [4, 5, 8, 7],
    ]);
    expect(dual.position(5)).toEqual([1, 0, 0]);
    expect(dual.connectivity.prev).toHaveLength(0);
  });

  test('is refused with what stands in the way', () => {
    using pillow = HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2, 2, 1, 0]);
    const before = bytesInUse();
    expect(() => pillow.dual()).toThrow(
      expect.objectContaining({
        code: 'degree-below-three',
        message:
          'Vertex 0 has valence 2: its face in the dual would have as many corners, expected 3 or more.',
        witness: expect.objectContaining({ vertices: [0] }),
      }),
    );
    expect(bytesInUse()).toBe(before);
  });

  test('is checked beforehand', () => {
    using pillow = HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2, 2, 1, 0]);
    using cube = HalfedgeMesh.cube();
    const before = bytesInUse();
    expect(cube.checkDual()).toBeNull();
    const refusal = pillow.checkDual();
    expect(expectRefused(() => pillow.dual(), 'degree-below-three')).toMatchObject({ ...refusal });
    expect(Object.keys(refusal ?? {})).toEqual(['code', 'message', 'witness']);
    expect(bytesInUse()).toBe(before);
    cube.dispose();
    expect(() => cube.checkDual()).toThrow(/disposed/);
  });
});

describe('toBytes and fromBytes', () => {
  const sample = (storePrev: boolean) => {
    const mesh = HalfedgeMesh.torus(6, 5, { triangles: true, storePrev });
    mesh.flipEdge(7);
    mesh.attributes.add('vertex', 'Größe', {
      type: 'float64',
      components: 2,
      default: [1, -1],
    })[5] = 0.1;
    mesh.attributes.add('face', 'label', { type: 'uint8', onSplit: 'copy' }).fill(9);
    return mesh;
  };

  test.each([true, false])('keep everything (storePrev: %p)', (storePrev) => {
    const before = bytesInUse();
    const mesh = sample(storePrev);
    const bytes = mesh.toBytes();
    expect(bytes).toBeInstanceOf(Uint8Array);
    const again = HalfedgeMesh.fromBytes(bytes);
    expect(arraysOf(again)).toEqual(arraysOf(mesh));
    expect(Array.from(again.attributes.get('vertex', 'Größe'))).toEqual(
      Array.from(mesh.attributes.get('vertex', 'Größe')),
    );
    expect(Array.from(again.attributes.get('face', 'label'))).toEqual(Array(60).fill(9));
    expect(again.toBytes()).toEqual(bytes);
    again.flipEdge(3);
    mesh.flipEdge(3);
    expect(again.toBytes()).toEqual(mesh.toBytes());
    mesh.dispose();
    again.dispose();
    expect(bytesInUse()).toBe(before);
  });

  test('take an ArrayBuffer and any view', () => {
    using mesh = HalfedgeMesh.cube();
    const bytes = mesh.toBytes();
    const shifted = new Uint8Array(bytes.length + 3);
    shifted.set(bytes, 3);
    for (const form of [
      bytes.buffer as ArrayBuffer,
      new DataView(shifted.buffer, 3),
      shifted.subarray(3),
    ]) {
      using again = HalfedgeMesh.fromBytes(form);
      expect(again.faceCount).toBe(6);
    }
  });

  test('refuse what is none, in sentences', () => {
    using mesh = HalfedgeMesh.cube();
    const bytes = mesh.toBytes();
    const inUse = bytesInUse();
    const reading = (form: unknown) => () => HalfedgeMesh.fromBytes(form as Uint8Array);
    expect(reading('halfedge')).toThrow(
      new TypeError('bytes is "halfedge"; expected an ArrayBuffer or a Uint8Array.'),
    );
    expect(reading(new Uint8Array(0))).toThrow(expect.objectContaining({ code: 'unknown-format' }));
    expect(reading(bytes.subarray(0, 100))).toThrow(
      expect.objectContaining({
        code: 'truncated',
        message: 'The bytes end at 100, expected a section of 96 bytes at 72.',
      }),
    );
    const newer = bytes.slice();
    newer[8] = 2;
    expect(reading(newer)).toThrow('The bytes are of version 2 of the format, expected 1.');
    expect(bytesInUse()).toBe(inUse);
  });

  test.each([1, 2, 3, 4])('survive flipped bytes (seed %i)', (seed) => {
    const mesh = sample(seed % 2 === 0);
    const sound = mesh.toBytes();
    mesh.dispose();
    const before = bytesInUse();
    const next = random(seed);
    let refused = 0;
    for (let round = 0; round < 500; round++) {
      const bytes = sound.slice();
      // Half of the time among the first links, where it matters most.
      const at = Math.floor(next() * (round % 2 === 0 ? bytes.length : 1000));
      bytes[at] = Math.floor(next() * 256);
      try {
        using read = HalfedgeMesh.fromBytes(bytes);
        for (const v of read.vertices()) for (const w of read.vertexVertices(v)) read.valence(w);
        expect(read.validate(2)).toEqual([]);
        read.append(read);
      } catch (error) {
        expect(error).toMatchObject({
          name: 'HalfedgeError',
          message: expect.stringMatching(/\.$/),
        });
        refused += 1;
      }
    }
    expect(refused).toBeGreaterThan(100);
    expect(bytesInUse()).toBe(before);
  });
});
