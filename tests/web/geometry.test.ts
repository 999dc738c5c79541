import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { HalfedgeMesh, init, type XYZ } from 'halfedge';
import { BufferAttribute, BufferGeometry, Matrix4, Triangle, Vector3 } from 'three';
import { collected } from './support/collection.js';
import { at, expectNear, sum } from './support/measures.js';
import { build, randomPolygons, randomTriangles } from './support/meshes.js';
import { type Point, randomSimplePolygon } from './support/polygons.js';
import { random } from './support/random.js';

beforeAll(() => init());

const good = collected('good');

/** A polygon as the only face of a mesh, turned and moved by `matrix`. */
function only(polygon: readonly Point[], matrix = new Matrix4()): HalfedgeMesh {
  const positions = polygon.flatMap(([x, y]) =>
    new Vector3(x, y, 0).applyMatrix4(matrix).toArray(),
  );
  return HalfedgeMesh.fromPolygons(positions, [polygon.map((_, i) => i)]);
}

/** The angle from direction `a` to direction `b`, counter-clockwise, from 0 to a full turn. */
function turn([ax, ay]: Point, [bx, by]: Point): number {
  const angle = Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
  return angle < 0 ? angle + 2 * Math.PI : angle;
}

describe('Of a cube', () => {
  let cube: HalfedgeMesh;
  beforeAll(() => {
    cube = HalfedgeMesh.cube();
  });

  test('faces', () => {
    expect([...cube.allFaceAreas()]).toEqual([1, 1, 1, 1, 1, 1]);
    for (const f of cube.faces()) {
      // A cube around the origin: its normals lead to the middles of its faces.
      const centre = cube.faceCentroid(f);
      expect(Math.hypot(...centre)).toBe(0.5);
      expectNear(
        cube.faceNormal(f),
        centre.map((x) => 2 * x),
        0,
      );
    }
  });

  test('no normal has a -0', () => {
    using cut = cube.clone();
    cut.triangulate();
    using inside = cut.clone();
    inside.reverse();
    for (const mesh of [cube, cut, inside]) {
      const all = [
        ...mesh.allFaceNormals(),
        ...mesh
          .faces()
          .toArray()
          .flatMap((f) => mesh.faceNormal(f)),
      ];
      expect(all.filter((x) => Object.is(x, -0))).toEqual([]);
    }
  });

  test('edges', () => {
    for (const e of cube.edges()) {
      expect(cube.edgeLength(e)).toBe(1);
      expect(cube.dihedralAngle(e)).toBe(Math.PI / 2);
      const [a, b] = [...cube.edgeVertices(e)].map((v) => cube.position(v));
      expect(cube.edgeMidpoint(e)).toEqual(a.map((x, k) => (x + b[k]) / 2));
    }
  });

  test('corners and vertices', () => {
    for (const h of cube.halfedges()) expect(cube.cornerAngle(h)).toBe(Math.PI / 2);
    for (const v of cube.vertices()) {
      expect(cube.angleDefect(v)).toBe(Math.PI / 2);
      expect(cube.vertexArea(v)).toBe(0.75);
      expectNear(cube.vertexNormal(v), at(cube, v).normalize().toArray(), 1e-15);
    }
  });

  test('all of it', () => {
    expect(cube.area()).toBe(6);
    expect(cube.volume()).toBe(1);
    expect(cube.boundingBox()).toEqual({ min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5] });
  });

  test('turned inside out', () => {
    using inside = cube.clone();
    inside.reverse();
    expect(inside.volume()).toBe(-1);
    expect(inside.area()).toBe(6);
    expectNear(
      inside.allFaceNormals(),
      cube.allFaceNormals().map((x) => -x),
      0,
    );
    expectNear(
      inside.allDihedralAngles(),
      cube.allDihedralAngles().map((x) => -x),
      0,
    );
  });
});

describe('Of any plane polygon', () => {
  test.each([1, 2, 3, 4, 5, 6])('in any place (seed %i)', (seed) => {
    const next = random(seed);
    for (let round = 0; round < 40; round++) {
      const polygon = randomSimplePolygon(3 + Math.floor(next() * 9), next);
      const axis = new Vector3(next() - 0.5, next() - 0.5, next() - 0.5).normalize();
      const matrix = new Matrix4()
        .makeRotationAxis(axis, 7 * next())
        .setPosition(next(), next(), next());
      using mesh = only(polygon, matrix);
      const { length } = polygon;

      const shoelace = polygon.map(([x, y], i) => {
        const [u, w] = polygon[(i + 1) % length];
        return (x * w - u * y) / 2;
      });
      expect(mesh.faceArea(0)).toBeCloseTo(sum(shoelace), 6);
      expect(mesh.area()).toBe(mesh.faceArea(0));
      const normal = new Vector3(0, 0, 1).transformDirection(matrix);
      expectNear(mesh.faceNormal(0), normal.toArray(), 1e-4);
      for (const v of mesh.vertices()) expect(mesh.vertexNormal(v)).toEqual(mesh.faceNormal(0));
      expectNear(
        mesh.allVertexAreas(),
        polygon.map(() => mesh.faceArea(0) / length),
        1e-15,
      );

      const angles = [...mesh.faceHalfedges(0)].map((h) => {
        const i = mesh.toVertex(h);
        const [x, y] = polygon[i];
        const from = polygon[(i + length - 1) % length];
        const to = polygon[(i + 1) % length];
        const angle = turn([to[0] - x, to[1] - y], [from[0] - x, from[1] - y]);
        expect(mesh.cornerAngle(h)).toBeCloseTo(angle, 2);
        expect(mesh.cornerAngle(mesh.opposite(h))).toBe(0);
        expect(mesh.angleDefect(i)).toBeCloseTo(Math.PI - mesh.cornerAngle(h), 12);
        return mesh.cornerAngle(h);
      });
      expect(sum(angles)).toBeCloseTo((length - 2) * Math.PI, 4);
    }
  });

  test('also if it lies far away', () => {
    const square: Point[] = [
      [0, 0],
      [2, 0],
      [2, 2],
      [0, 2],
    ];
    using mesh = only(square, new Matrix4().makeTranslation(2 ** 22, -(2 ** 22), 2 ** 22));
    expect(mesh.faceArea(0)).toBe(4);
    expect(mesh.faceNormal(0)).toEqual([0, 0, 1]);
    expect(mesh.faceCentroid(0)).toEqual([2 ** 22 + 1, 1 - 2 ** 22, 2 ** 22]);
    expect(mesh.cornerAngle(mesh.faceHalfedge(0))).toBe(Math.PI / 2);
  });
});

describe('Of any triangle mesh of the collection, as three.js has it:', () => {
  const files = good.files.filter((path) => /\.(obj|off|ply|stl)$/.test(path));

  good.test.each(files.length > 0 ? files.map((path) => [basename(path), path]) : [['', '']])(
    '%s',
    (_, path) => {
      const { mesh } = HalfedgeMesh.parse(readFileSync(path));
      mesh.triangulate();
      mesh.compact();
      const { indices } = mesh.toTriangles();
      const box = mesh.boundingBox();
      const size = box ? Math.hypot(...box.max.map((x, k) => x - box.min[k])) : 0;

      const geometry = new BufferGeometry();
      // Of doubles, relative to the middle: three.js adds up what floats have left of large coordinates.
      const middle = box ? box.min.map((x, k) => (x + box.max[k]) / 2) : [0, 0, 0];
      const points = Float64Array.from(mesh.positions, (x, i) => x - middle[i % 3]);
      geometry.setAttribute('position', new BufferAttribute(points, 3));
      geometry.setAttribute('normal', new BufferAttribute(new Float64Array(points.length), 3));
      geometry.setIndex(new BufferAttribute(indices, 1));
      geometry.computeVertexNormals();
      geometry.computeBoundingBox();

      const [normals, areas] = [mesh.allFaceNormals(), mesh.allFaceAreas()];
      const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
      const triangle = new Triangle(a, b, c);
      let [volume, worstNormal, worstArea] = [0, 0, 0];
      for (let f = 0; f < areas.length; f++) {
        triangle.setFromAttributeAndIndices(
          geometry.getAttribute('position'),
          indices[3 * f],
          indices[3 * f + 1],
          indices[3 * f + 2],
        );
        volume += a.dot(b.clone().cross(c)) / 6;
        worstArea = Math.max(worstArea, Math.abs(areas[f] - triangle.getArea()));
        if (areas[f] < 1e-12 * size * size) continue; // a needle: its normal is a matter of rounding
        const normal = triangle.getNormal(new Vector3());
        worstNormal = Math.max(
          worstNormal,
          normal.distanceTo(new Vector3().fromArray(normals, 3 * f)),
        );
      }
      expect(worstArea).toBeLessThan(1e-9 * size * size);
      expect(worstNormal).toBeLessThan(1e-5);
      if (mesh.boundaryLoops().length === 0) {
        expect(Math.abs(mesh.volume() - volume)).toBeLessThan(1e-9 * size ** 3);
      } else {
        expect(() => mesh.volume()).toThrow(
          /^This mesh has \d+ boundary loops?; expected a closed/,
        );
      }
      const smooth = mesh.allVertexNormals();
      const theirs = geometry.getAttribute('normal');
      const shares = mesh.allVertexAreas();
      let worst = 0;
      for (const v of mesh.vertices()) {
        // Where the normals around a vertex nearly cancel, or it has no area, rounding decides.
        if (shares[v] < 1e-10 * size * size || mesh.isIsolatedVertex(v)) continue;
        const sumOfAreas = new Vector3();
        for (const f of mesh.vertexFaces(v)) {
          sumOfAreas.addScaledVector(new Vector3().fromArray(normals, 3 * f), areas[f]);
        }
        if (sumOfAreas.length() < 1e-3 * shares[v]) continue;
        const found = new Vector3().fromArray(smooth, 3 * v);
        worst = Math.max(worst, found.distanceTo(new Vector3().fromBufferAttribute(theirs, v)));
      }
      expect(worst).toBeLessThan(1e-4);
      expect(Math.abs(sum(shares) - mesh.area())).toBeLessThan(1e-9 * size * size);
      expect(Math.abs(sum(areas) - mesh.area())).toBeLessThan(1e-9 * size * size);
      mesh.dispose();
    },
  );
});

describe('On random meshes', () => {
  const seeds = [1, 2, 3, 4, 5, 6, 7, 8];

  test.each(seeds)(
    'angle defects add up to 2π times the Euler characteristic (seed %i)',
    (seed) => {
      for (let round = 0; round < 20; round++) {
        using mesh = randomTriangles(100 * seed + round);
        const total = sum(mesh.allAngleDefects());
        expect(total).toBeCloseTo(2 * Math.PI * mesh.eulerCharacteristic(), 8);
      }
    },
  );

  test.each(seeds)('all at once is one by one, also where items are deleted (seed %i)', (seed) => {
    const next = random(seed);
    using mesh = build(randomPolygons(seed));
    for (const f of mesh.faces().toArray()) if (next() < 0.2) mesh.deleteFace(f);
    const three = (slots: number, items: Iterable<number>, value: (item: number) => XYZ) => {
      const all = new Float32Array(3 * slots);
      for (const item of items) all.set(value(item), 3 * item);
      return all;
    };
    const one = (slots: number, items: Iterable<number>, value: (item: number) => number) => {
      const all = new Float64Array(slots);
      for (const item of items) all[item] = value(item);
      return all;
    };
    const { vertexSlots, halfedgeSlots, edgeSlots, faceSlots } = mesh;
    expect(mesh.faceCount).toBeLessThan(faceSlots);
    const faces = mesh.faces().toArray();
    const edges = mesh.edges().toArray();
    const vertices = mesh.vertices().toArray();
    const halfedges = mesh.halfedges().toArray();
    expect(mesh.allFaceNormals()).toEqual(three(faceSlots, faces, (f) => mesh.faceNormal(f)));
    expect(mesh.allFaceCentroids()).toEqual(three(faceSlots, faces, (f) => mesh.faceCentroid(f)));
    expect(mesh.allFaceAreas()).toEqual(one(faceSlots, faces, (f) => mesh.faceArea(f)));
    expect(mesh.allEdgeLengths()).toEqual(one(edgeSlots, edges, (e) => mesh.edgeLength(e)));
    expect(mesh.allEdgeMidpoints()).toEqual(three(edgeSlots, edges, (e) => mesh.edgeMidpoint(e)));
    expect(mesh.allDihedralAngles()).toEqual(one(edgeSlots, edges, (e) => mesh.dihedralAngle(e)));
    expect(mesh.allCornerAngles()).toEqual(
      one(halfedgeSlots, halfedges, (h) => mesh.cornerAngle(h)),
    );
    expect(mesh.allAngleDefects()).toEqual(one(vertexSlots, vertices, (v) => mesh.angleDefect(v)));
    // Two ways to add them up.
    const areas = one(vertexSlots, vertices, (v) => mesh.vertexArea(v));
    expectNear(mesh.allVertexAreas(), areas, 1e-12);
    const normals = three(vertexSlots, vertices, (v) => mesh.vertexNormal(v));
    expectNear(mesh.allVertexNormals(), normals, 1e-5);
    using cut = randomTriangles(seed);
    expect(cut.allCotanWeights()).toEqual(
      one(cut.edgeSlots, cut.edges(), (e) => cut.cotanWeight(e)),
    );
  });

  test.each(seeds)(
    'edges bend by the angle between normals, outwards if convex (seed %i)',
    (seed) => {
      using mesh = randomTriangles(seed);
      let [ridges, valleys] = [0, 0];
      for (const e of mesh.edges()) {
        if (mesh.isBoundaryEdge(e)) {
          expect(mesh.dihedralAngle(e)).toBe(0);
          continue;
        }
        const [f, g] = [...mesh.edgeFaces(e)].map((face) => new Vector3(...mesh.faceNormal(face)));
        expect(Math.abs(mesh.dihedralAngle(e))).toBeCloseTo(f.angleTo(g), 5);
        // Convex: the far corner of one face lies below the plane of the other.
        const h = mesh.edgeHalfedge(e);
        const far = at(mesh, mesh.toVertex(mesh.next(mesh.opposite(h))));
        const height = far.sub(at(mesh, mesh.toVertex(h))).dot(f);
        if (Math.abs(height) < 1e-6) continue;
        expect(Math.sign(mesh.dihedralAngle(e))).toBe(-Math.sign(height));
        if (height < 0) ridges++;
        else valleys++;
      }
      expect(Math.min(ridges, valleys)).toBeGreaterThan(0);
    },
  );

  test.each(seeds)('cotangent weights are those of the angles (seed %i)', (seed) => {
    using mesh = randomTriangles(seed);
    for (const e of mesh.edges()) {
      let twice = 0;
      for (const h of mesh.edgeHalfedges(e)) {
        if (!mesh.isBoundaryHalfedge(h)) twice += 1 / Math.tan(mesh.cornerAngle(mesh.next(h)));
      }
      expect(mesh.cotanWeight(e) / (1 + Math.abs(twice))).toBeCloseTo(
        twice / 2 / (1 + Math.abs(twice)),
        9,
      );
    }
  });

  test.each(seeds)('the volume is that of the poked mesh, wherever it lies (seed %i)', (seed) => {
    const next = random(seed);
    using mesh = HalfedgeMesh.torus(9, 7);
    for (const v of mesh.vertices()) {
      const [x, y, z] = mesh.position(v);
      mesh.setPosition(v, [x + 0.2 * next(), y + 0.2 * next(), z + 0.2 * next()]); // warps the quads
    }
    using poked = mesh.clone();
    for (const f of mesh.faces()) poked.poke(f, 0);
    expect(poked.volume()).toBeCloseTo(mesh.volume(), 5);
    let tetrahedra = 0;
    const { indices } = poked.toTriangles();
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => at(poked, indices[i + k]));
      tetrahedra += a.dot(b.cross(c)) / 6;
    }
    expect(poked.volume()).toBeCloseTo(tetrahedra, 9);
    expect(tetrahedra).toBeGreaterThan(0.1);
    const volume = mesh.volume();
    for (let i = 0; i < mesh.positions.length; i++) mesh.positions[i] += 1024;
    expect(mesh.volume()).toBeCloseTo(volume, 3);
  });
});
