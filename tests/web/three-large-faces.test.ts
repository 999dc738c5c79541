// Polygons with very many corners, and vertices with very many faces: a step for each corner that looks at all the
// others takes seconds.

import { HalfedgeMesh, init } from 'halfedge';
import { writeGltf } from 'halfedge/gltf';
import {
  CirculatorHelper,
  type GeometryOptions,
  HalfedgeGlyphs,
  HalfedgesHelper,
  MeshGeometry,
  type MeshHelper,
  toBufferGeometry,
} from 'halfedge/three';
import type { LineSegments2 } from 'three/addons/lines/LineSegments2.js';

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

/** A face of many corners and nothing else, seen from above. */
function plate(corners: number): HalfedgeMesh {
  const positions = Float32Array.from({ length: 3 * corners }, (_, i) => {
    const angle = (2 * Math.PI * Math.floor(i / 3)) / corners;
    return [Math.cos(angle), Math.sin(angle), 0][i % 3];
  });
  return HalfedgeMesh.fromPolygons(positions, [Array.from({ length: corners }, (_, v) => v)]);
}

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

const endsOf = (helper: MeshHelper) => {
  const { instanceStart } = (helper.children[0] as LineSegments2).geometry.attributes;
  return Array.from({ length: helper.segments }, (_, i) => [
    instanceStart.getX(i),
    instanceStart.getY(i),
    instanceStart.getZ(i),
  ]);
};

describe('Helpers', () => {
  test('draw the arrows of a large face and of its boundary in linear time', () => {
    const mesh = plate(8000);
    const glyphs = new HalfedgeGlyphs({ mesh, points: mesh.positions });
    const once = () => glyphs.face(0, { inset: 1e-6, trim: 1e-6, barb: 1e-6 });
    const [outside] = mesh.boundaryLoops();
    expectLinear(() => new HalfedgesHelper(mesh), once);
    expectLinear(() => new CirculatorHelper(mesh, 'halfedgeLoop', outside), once);
    expectLinear(() => new CirculatorHelper(mesh, 'faceHalfedges', 0), once);
    mesh.dispose();
  });

  test.each(['ccw', 'cw'] as const)('draw each arrow as it is alone, %s', (direction) => {
    const mesh = HalfedgeMesh.cone(7);
    mesh.deleteFace(2);
    const [outside] = mesh.boundaryLoops();
    const traces: CirculatorHelper[] = [
      new CirculatorHelper(mesh, 'halfedgeLoop', outside, { direction }),
      ...mesh
        .faces()
        .toArray()
        .map((f) => new CirculatorHelper(mesh, 'faceHalfedges', f, { direction })),
      ...mesh
        .vertices()
        .toArray()
        .map((v) => new CirculatorHelper(mesh, 'vertexOutgoingHalfedges', v, { direction })),
    ];
    for (const trace of traces) {
      const alone = trace
        .trace()
        .flatMap((h) => endsOf(new CirculatorHelper(mesh, 'halfedgeLoop', h, { steps: 1 })));
      expect(endsOf(trace)).toEqual(alone);
    }
    mesh.dispose();
  });
});
