// Polygons with very many corners, and vertices with very many faces: a step for each corner that looks at all the
// others takes seconds.

import { HalfedgeMesh, init } from 'halfedge';
import { writeGltf } from 'halfedge/gltf';
import { type GeometryOptions, MeshGeometry, toBufferGeometry } from 'halfedge/three';

beforeAll(() => init());

const MANY = 30_000;

/** In milliseconds. */
function timeOf(run: () => unknown): number {
  const began = performance.now();
  run();
  return performance.now() - began;
}

/** Whether it takes about as long as something linear, which a busy machine slows down as well. */
const expectLinear = (run: () => unknown, linear: () => unknown) => {
  const least = Math.min(timeOf(linear), timeOf(linear));
  expect(timeOf(run)).toBeLessThan(30 * least + 300);
};

const LAYOUTS: [string, GeometryOptions][] = [
  ['indexed', { attributes: [] }],
  ['with flat normals', { attributes: [], normals: 'flat' }],
  ['with seams and smooth normals', { attributes: ['uv'] }],
];

describe.each(LAYOUTS)('A MeshGeometry %s', (_, options) => {
  test('of a cone is made in linear time', () => {
    const mesh = HalfedgeMesh.cone(MANY);
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    expectLinear(
      () => new MeshGeometry(mesh, options),
      () => new MeshGeometry(mesh, { ...options, normals: 'none' }),
    );
    mesh.dispose();
  });

  test.each([1, MANY / 10])('follows %d corners of a large polygon in linear time', (moved) => {
    const mesh = HalfedgeMesh.cone(MANY);
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    const geometry = new MeshGeometry(mesh, options);
    for (let v = 0; v < moved; v++) mesh.positions[3 * v + 1] += 0.01;
    expectLinear(
      () => geometry.update(),
      () => new MeshGeometry(mesh, options),
    );
    const anew = new MeshGeometry(mesh, options);
    const { array } = geometry.attributes.normal;
    const end = 3 * (geometry.index ? mesh.vertexSlots : geometry.drawRange.count);
    let worst = 0;
    for (let i = 0; i < end; i++)
      worst = Math.max(worst, Math.abs(array[i] - anew.attributes.normal.array[i]));
    expect(worst).toBeLessThan(1e-6);
    mesh.dispose();
  });
});

describe('toBufferGeometry', () => {
  test('finds the copies of a vertex with many in linear time', () => {
    const mesh = HalfedgeMesh.cone(MANY);
    expectLinear(
      () => toBufferGeometry(mesh, { normals: 'flat' }),
      () => toBufferGeometry(mesh),
    );
    mesh.dispose();
  });

  test('doubles a vertex once for all corners that are alike, however many others there are', async () => {
    const sides = 300;
    const mesh = HalfedgeMesh.cone(sides);
    const [tip] = [...mesh.vertices()].filter((v) => mesh.position(v)[1] > 0);
    const uv = mesh.attributes.add('halfedge', 'uv', { components: 2 });
    [...mesh.vertexIncomingHalfedges(tip)].forEach((h, i) => {
      uv[2 * h] = i % 100;
      uv[2 * h + 1] = i % 2 === 0 ? 0 : -0; // which are alike
    });
    const { geometry, vertices } = toBufferGeometry(mesh, { normals: 'none' });
    const rows = [...vertices.keys()].filter((row) => vertices[row] === tip);
    const values = rows.map((row) => geometry.attributes.uv.getX(row));
    expect([...values].sort((a, b) => a - b)).toEqual(Array.from({ length: 100 }, (_, i) => i));
    // Each corner has its own values.
    const { halfedges } = cornersOf(mesh);
    halfedges.forEach((h, i) => {
      expect(geometry.attributes.uv.getX(geometry.index?.getX(i) ?? -1)).toBe(uv[2 * h]);
    });
    expect((await writeGltf(mesh)).length).toBeGreaterThan(0);
    mesh.dispose();
  });
});

/** By corner of the triangles that a mesh is drawn as: the halfedge that ends there. */
function cornersOf(mesh: HalfedgeMesh): { halfedges: number[] } {
  const { indices, faces } = mesh.toTriangles();
  return {
    halfedges: Array.from(indices, (v, i) => {
      const face = faces[Math.floor(i / 3)];
      const h = [...mesh.faceHalfedges(face)].find((g) => mesh.toVertex(g) === v);
      return h ?? -1;
    }),
  };
}
