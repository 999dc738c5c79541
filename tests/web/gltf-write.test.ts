import { HalfedgeMesh, init } from 'halfedge';
import { readGltf, writeGltf } from 'halfedge/gltf';
import { REVISION } from 'three';
import { withFullHeap } from './support/core.js';
import { rejection } from './support/gltf.js';

beforeAll(() => init());

describe('writeGltf', () => {
  const shown = (mesh: HalfedgeMesh) => ({
    positions: [...mesh.positions],
    triangles: [...mesh.toTriangles().indices],
    attributes: mesh.attributes.list().map(({ kind, name }) => [kind, name]),
  });

  test.each(['glb', 'gltf'] as const)('writes %s that reads back bit for bit', async (format) => {
    const mesh = HalfedgeMesh.icoSphere(3);
    mesh.positions.forEach((x, i) => {
      mesh.positions[i] = x * Math.fround(Math.PI) + 1e-7 * i;
    });
    const written = await writeGltf(mesh, { format });
    expect(typeof written).toBe(format === 'glb' ? 'object' : 'string');
    const again = await readGltf(written);
    expect(again.report.format).toBe(format);
    expect(shown(again.mesh)).toEqual(shown(mesh));
  });

  test('keeps attributes, with their seams and their types', async () => {
    const mesh = HalfedgeMesh.icosahedron();
    const normal = mesh.attributes.add('vertex', 'normal', { components: 3, onSplit: 'normalize' });
    normal.set(
      mesh.positions.map((x, i, p) => {
        const v = i - (i % 3);
        return x / Math.hypot(p[v], p[v + 1], p[v + 2]);
      }),
    );
    const uv = mesh.attributes.add('halfedge', 'uv', { components: 2 });
    uv.forEach((_, i) => {
      uv[i] = Math.fround((i >> 3) / 30);
    });
    const color = mesh.attributes.add('vertex', 'color', { type: 'uint8', components: 4 });
    color.forEach((_, i) => {
      color[i] = (37 * i) % 256;
    });
    const { mesh: again } = await readGltf(await writeGltf(mesh));
    expect(again.vertexCount).toBe(12);
    expect([...again.toTriangles().indices]).toEqual([...mesh.toTriangles().indices]);
    expect([...again.attributes.get('vertex', 'normal')]).toEqual([...normal]);
    expect([...again.attributes.get('vertex', 'color')]).toEqual([...color]);
    const corners = (of: HalfedgeMesh) => {
      const values = of.attributes.get('halfedge', 'uv');
      return [...of.faces()].map((f) =>
        [...of.faceHalfedges(f)].map((h) => [of.toVertex(h), values[2 * h], values[2 * h + 1]]),
      );
    };
    expect(corners(again)).toEqual(corners(mesh));
  });

  test.each(['uint8', 'uint16'] as const)('keeps colours of the type %s', async (type) => {
    const mesh = HalfedgeMesh.tetrahedron();
    const color = mesh.attributes.add('vertex', 'color', { type, components: 3 });
    color.set([0, 1, 2, 128, 200, 255]);
    const isWide = Number.parseInt(REVISION, 10) < 163; // three.js would write rows of three wrongly
    const one = type === 'uint8' ? 255 : 65535;
    const components = isWide ? 4 : 3;
    const kept = Array.from({ length: 4 * components }, (_, i) => {
      const [row, k] = [Math.floor(i / components), i % components];
      return k < 3 ? color[3 * row + k] : one;
    });
    const notes: string[] = [];
    const file = await writeGltf(mesh, { onNote: (sentence) => notes.push(sentence) });
    expect(notes).toHaveLength(isWide ? 1 : 0);
    const again = (await readGltf(file)).mesh;
    expect(again.attributes.list()).toMatchObject([{ name: 'color', type, components }]);
    expect([...again.attributes.get('vertex', 'color')]).toEqual(kept);
    again.dispose();
    mesh.dispose();
  });

  test('keeps seams and colours also where making the buffers lets the memory grow', async () => {
    const mesh = HalfedgeMesh.icoSphere(5);
    const color = mesh.attributes.add('halfedge', 'color', { type: 'uint8', components: 4 });
    color.forEach((_, i) => {
      color[i] = (i >> 2) % 251;
    });
    const kept = color.slice();
    const again = await readGltf(await withFullHeap(() => writeGltf(mesh)));
    const read = again.mesh.attributes.get('halfedge', 'color');
    expect(read.length).toBe(kept.length);
    const corner = (of: HalfedgeMesh, values: ArrayLike<number>, a: number, b: number) =>
      values[4 * of.findHalfedge(a, b)];
    for (let h = 0; h < mesh.halfedgeSlots; h += 97) {
      const [a, b] = [mesh.fromVertex(h), mesh.toVertex(h)];
      expect(corner(again.mesh, read, a, b)).toBe(corner(mesh, kept, a, b));
    }
    again.mesh.dispose();
    mesh.dispose();
  });

  test('cuts polygons into triangles, and leaves the mesh as it is', async () => {
    const mesh = HalfedgeMesh.cube();
    const before = mesh.toBytes();
    const { mesh: again } = await readGltf(await writeGltf(mesh));
    expect([again.vertexCount, again.faceCount, again.isClosed()]).toEqual([8, 12, true]);
    expect(mesh.toBytes()).toEqual(before);
  });

  test('writes meshes without faces, without vertices, and with deleted slots', async () => {
    const holes = HalfedgeMesh.icoSphere(1);
    holes.deleteVertex(0);
    const { mesh } = await readGltf(await writeGltf(holes));
    expect([mesh.vertexCount, mesh.faceCount]).toEqual([holes.vertexCount, holes.faceCount]);
    const point = new HalfedgeMesh();
    expect((await readGltf(await writeGltf(point))).mesh.faceCount).toBe(0);
    point.addVertex([1, 2, 3]);
    expect((await readGltf(await writeGltf(point))).mesh.faceCount).toBe(0);
  });

  test('leaves the globals of Node alone, also when two write at once', async () => {
    const meshes = [HalfedgeMesh.cube(), HalfedgeMesh.icosahedron()];
    const written = await Promise.all(meshes.map((mesh) => writeGltf(mesh)));
    expect(written.map(({ length }) => length > 100)).toEqual([true, true]);
    expect(globalThis.FileReader).toBeUndefined();
  });

  test('cuts faces whose diagonals are those of others as well', async () => {
    // Both diagonals of the quad are edges of triangles, which it touches in single vertices.
    const corners = [0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, 1, 1, 1, 2, 1, 1, -1, 1, 1, -2];
    const fins = [
      [0, 2, 4],
      [2, 0, 5],
      [1, 3, 6],
      [3, 1, 7],
    ];
    const mesh = HalfedgeMesh.fromPolygons(corners, [...fins, [0, 1, 2, 3]]);
    expect(mesh.checkTriangulate()?.code).toBe('no-triangulation');
    const { report, mesh: read } = await readGltf(await writeGltf(mesh));
    expect(report.faceMap.length).toBe(6);
    mesh.dispose();
    read.dispose();
  });

  test('says what is not in the file', async () => {
    const mesh = HalfedgeMesh.cube();
    for (const { kind, name } of mesh.attributes.list()) mesh.attributes.remove(kind, name);
    const notesOf = async () => {
      const notes: string[] = [];
      await writeGltf(mesh, { onNote: (note) => notes.push(note) });
      return notes;
    };
    const cut = 'Cut 6 faces into 12 triangles: glTF has no polygons.';
    expect(await notesOf()).toEqual([cut]);
    mesh.attributes.add('vertex', 'uv', { components: 2, type: 'float64' });
    mesh.attributes.add('vertex', 'color', { components: 3, type: 'int8' });
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    mesh.attributes.add('halfedge', 'color', { components: 1 });
    mesh.attributes.add('face', 'material', { type: 'int32', onSplit: 'copy' });
    expect(await notesOf()).toEqual([
      cut,
      'Wrote the vertex attribute "uv" as 32-bit floats.',
      'Left out the vertex attribute "color": in glTF it has no values of int8.',
      'Left out the vertex attribute "uv": halfedges have it as well.',
      'Left out the halfedge attribute "color": in glTF it has 3 or 4 components, not 1.',
      'Left out the face attribute "material": glTF has no place for it.',
    ]);
    for (const f of [...mesh.faces()]) mesh.deleteFace(f);
    mesh.addVertex([1, 2, 3]);
    expect((await notesOf())[0]).toMatch(/^Left out \d+ vert(ex|ices): there are no faces\.$/);
    mesh.dispose();
  });

  test('does not say of a mesh without faces that its attributes were written', async () => {
    const point = [
      'ply\nformat ascii 1.0\nelement vertex 1',
      ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
      ...['nx', 'ny', 'nz', 'red', 'green', 'blue'].map((name) => `property double ${name}`),
      'end_header\n0 0 0 2 0 0 3 0 nan\n',
    ].join('\n');
    using mesh = HalfedgeMesh.parse(point).mesh;
    const names = mesh.attributes.list().map(({ name, type }) => `${name}: ${type}`);
    expect(names).toEqual(['normal: float64', 'color: float64']);
    const notes: string[] = [];
    await writeGltf(mesh, { onNote: (note) => notes.push(note) });
    expect(notes).toEqual(['Left out 1 vertex: there are no faces.']);
  });

  test('refuses positions that are not finite, of polygons too', async () => {
    for (const mesh of [HalfedgeMesh.tetrahedron(), HalfedgeMesh.cube()]) {
      mesh.positions[4] = Infinity;
      const error = await rejection(writeGltf(mesh));
      expect(error).toMatchObject({ code: 'non-finite-position', witness: { vertices: [1] } });
      expect(error.message).toMatch(
        /^Vertex 1 has the position \S+, Infinity, \S+, expected finite numbers in glTF\.$/,
      );
      mesh.dispose();
    }
  });

  test('brings normals to length 1, clears what is not finite, and says so', async () => {
    const warn = import.meta.jest.spyOn(console, 'warn').mockImplementation(() => {});
    using mesh = HalfedgeMesh.tetrahedron();
    mesh.addVertex(); // without a corner, and so without a normal of one
    const normal = mesh.attributes.add('halfedge', 'normal', { components: 3 });
    for (let h = 0; h < mesh.halfedgeSlots; h++) normal.set([0, 0, 1], 3 * h);
    const written = async () => {
      const notes: string[] = [];
      const bytes = await writeGltf(mesh, { onNote: (note) => notes.push(note) });
      return { notes, again: (await readGltf(bytes)).mesh };
    };
    expect((await written()).notes).toEqual([]);
    mesh.attributes.remove('halfedge', 'normal');
    mesh.attributes.add('vertex', 'normal', { components: 3 }).set([0, 3, 4, Number.NaN], 3);
    mesh.attributes.add('vertex', 'uv', { components: 2 }).set([Number.NaN, 1]);
    const { notes, again } = await written();
    expect(notes).toEqual([
      'Wrote the vertex attribute "normal" brought to length 1: glTF has no other normals.',
      'Wrote 0 where the vertex attribute "uv" is no finite number: glTF has no others.',
    ]);
    const read = Array.from(again.attributes.get('vertex', 'normal').subarray(0, 9));
    expect(read).toEqual([1, 0, 0, 0, Math.fround(0.6), Math.fround(0.8), 1, 0, 0]);
    expect([...again.attributes.get('vertex', 'uv').subarray(0, 2)]).toEqual([0, 1]);
    expect(warn).not.toHaveBeenCalled();
    warn.mockRestore();
  });

  test('brings colours between 0 and 1, and says so', async () => {
    using mesh = HalfedgeMesh.tetrahedron();
    const color = mesh.attributes.add('vertex', 'color', { components: 3 });
    const written = async () => {
      const notes: string[] = [];
      const bytes = await writeGltf(mesh, { onNote: (note) => notes.push(note) });
      using again = (await readGltf(bytes)).mesh;
      return { notes, read: [...again.attributes.get('vertex', 'color')] };
    };
    color.set([0, 1, 0.5, 1e-45]);
    expect(await written()).toEqual({ notes: [], read: [...color] });
    color.set([-1, 2.5, 0.5, -1e-45, 1 + 2 ** -23, 1]);
    const { notes, read } = await written();
    expect(notes).toEqual([
      'Wrote the vertex attribute "color" brought between 0 and 1: glTF has no other colours.',
    ]);
    expect(read).toEqual([0, 1, 0.5, 0, 1, 1, 0, 0, 0, 0, 0, 0]);
    expect(color[0]).toBe(-1);
  });

  test('leaves out triangles with a vertex at two corners, and no others', async () => {
    using mesh = new HalfedgeMesh();
    mesh.insertVertexOnEdge(mesh.edge(mesh.makeSegment())); // a face around a path, of four corners
    const corners = [0, 1, 2].map((i) => mesh.addVertex([i, i * i, 1]));
    mesh.addFace(corners);
    const notes: string[] = [];
    const bytes = await writeGltf(mesh, { onNote: (note) => notes.push(note) });
    expect(notes).toEqual([
      'Cut 2 faces into 3 triangles: glTF has no polygons.',
      'Left out 2 triangles with a vertex at two corners.',
    ]);
    using again = (await readGltf(bytes)).mesh;
    expect(again.faceCount).toBe(1);
    const places = again
      .faceVertices(0)
      .toArray()
      .map((v) => [...again.position(v)]);
    expect(places).toEqual(corners.map((v) => [...mesh.position(v)]));
  });

  test.each(['glb', 'gltf'] as const)(
    'fails where its own bytes can not be read back: %s',
    async (format) => {
      const mesh = HalfedgeMesh.cube();
      const reading = import.meta.jest
        .spyOn(Blob.prototype, 'arrayBuffer')
        .mockRejectedValue(new Error('No memory left.'));
      const error = await rejection(writeGltf(mesh, { format }));
      reading.mockRestore();
      expect(error).toMatchObject({
        code: 'write-error',
        message: "three.js can't write the mesh: No memory left.",
      });
      expect(globalThis.FileReader).toBeUndefined();
      expect((await writeGltf(mesh, { format })).length).toBeGreaterThan(100);
      mesh.dispose();
    },
  );

  test('refuses what is no mesh, and no format', async () => {
    expect((await rejection(writeGltf({} as HalfedgeMesh))).message).toMatch(/^mesh is an Object/);
    const bad = writeGltf(HalfedgeMesh.cube(), { format: 'doc' as 'glb' });
    expect((await rejection(bad)).message).toBe(
      "options.format is \"doc\"; expected 'glb' or 'gltf'.",
    );
  });
});
