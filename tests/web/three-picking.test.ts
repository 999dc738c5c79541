import { HalfedgeMesh, init } from 'halfedge';
import { MeshGeometry } from 'halfedge/three';
import {
  type FaceHit,
  FaceTree,
  type FaceTreeOptions,
  MeshPicker,
  type PickOptions,
} from 'halfedge/three/picking';
import * as THREE from 'three';
import { grownOver, type TreeSeed } from '../../dist/three/triangle-tree.js';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

const SIZE = 400;

/** A camera above the origin of a square canvas, that sees `width` of the world. */
function above(x: number, width: number) {
  const half = width / 2;
  const camera = new THREE.OrthographicCamera(-half, half, half, -half, 0.1, 10);
  camera.position.set(x, 0, 3);
  camera.updateMatrixWorld();
  return { camera, width: SIZE, height: SIZE };
}

/** A grid of four quads of 100 pixels, seen from above, as part of an object that is moved and scaled. */
function scene(mesh: HalfedgeMesh = HalfedgeMesh.grid(2, 2, { width: 1, height: 1 })) {
  const object = new THREE.Mesh(new MeshGeometry(mesh));
  object.position.set(5, 0, 0);
  object.scale.setScalar(2);
  const view = above(5, 4);
  const picker = new MeshPicker(object);
  /** Picks at a point of the world, from the middle of the object. */
  const pick = (x: number, y: number, options: PickOptions = {}) =>
    picker.pick((0.5 + x / 4) * SIZE, (0.5 - y / 4) * SIZE, view, options);
  return { mesh, object, picker, pick, view };
}

/** Somewhere in a cube around the origin. */
const somewhere = (next: () => number) =>
  new THREE.Vector3(next() - 0.5, next() - 0.5, next() - 0.5);

/** What a ray hits, tried against all triangles. */
function hitByThree({ geometry, matrixWorld }: THREE.Mesh<MeshGeometry>, ray: THREE.Ray) {
  const plain = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
  plain.matrixWorld.copy(matrixWorld);
  const [hit] = new THREE.Raycaster(ray.origin, ray.direction).intersectObject(plain);
  return hit && { face: geometry.face(hit.faceIndex as number), distance: hit.distance };
}

/**
 * A tree over a mesh as `shown`, which counts how often all triangles are asked for. `move` puts it below the
 * plane z = 0, and `hit` tells how far from z = 5 a ray hits it.
 */
function moving(mesh: HalfedgeMesh, options: FaceTreeOptions = {}) {
  const { indices, faces } = mesh.toTriangles();
  const shown = {
    asked: 0,
    points: mesh.positions.slice(),
    allTriangles() {
      shown.asked += 1;
      return { points: shown.points.slice(), vertices: indices.slice(), faces: faces.slice() };
    },
    triangleVertices: (face: number) => indices.slice(3 * face, 3 * face + 3),
  };
  const tree = new FaceTree(shown, options);
  const all = mesh.faces().toArray();
  const move = (depth: number, changed: Iterable<number> = all) => {
    for (let i = 2; i < shown.points.length; i += 3) shown.points[i] = -depth;
    tree.update(changed, shown);
  };
  const down = new THREE.Ray(new THREE.Vector3(0.01, 0.02, 5), new THREE.Vector3(0, 0, -1));
  return { tree, shown, move, hit: () => Math.round(tree.cast(down)?.distance as number) };
}

/** Does in its own time what the thread does. */
class FakeWorker {
  isTerminated = false;
  #seed: TreeSeed | undefined;
  #listener: (event: { data: unknown }) => void = () => {};

  addEventListener(type: string, listener: (event: { data: unknown }) => void): void {
    if (type === 'message') this.#listener = listener;
  }
  postMessage(seed: TreeSeed): void {
    this.#seed = seed;
  }
  answer(data: unknown = structuredClone(grownOver(this.#seed as TreeSeed).grown)): void {
    this.#listener({ data });
  }
  terminate(): void {
    this.isTerminated = true;
  }
}

describe('MeshPicker', () => {
  test('picks what is nearest: a vertex, an edge, an arrow or the face', () => {
    const { mesh, pick } = scene();
    expect(pick(0.03, 0.04)).toEqual({ kind: 'vertex', index: 4 });
    expect(pick(0.5, 0.01)).toEqual({ kind: 'edge', index: mesh.findEdge(4, 5) });
    // The arrow of the halfedge lies in its face, 6.5 pixels from the edge.
    expect(pick(0.5, 0.07)).toEqual({ kind: 'halfedge', index: mesh.findHalfedge(4, 5) });
    expect(pick(0.5, -0.07)).toEqual({ kind: 'halfedge', index: mesh.findHalfedge(5, 4) });
    expect(pick(0.5, 0.5)).toEqual({ kind: 'face', index: 3 });
    expect(pick(1.5, 0)).toBe(null);
  });

  test('picks items of one kind, wherever in the face the pointer is', () => {
    const { mesh, pick } = scene();
    expect(pick(0.3, 0.2, { mode: 'vertex' })).toEqual({ kind: 'vertex', index: 4 });
    expect(pick(0.6, 0.9, { mode: 'vertex' })).toEqual({ kind: 'vertex', index: 8 });
    expect(pick(0.5, 0.2, { mode: 'edge' })).toEqual({ kind: 'edge', index: mesh.findEdge(4, 5) });
    const halfedge = { kind: 'halfedge', index: mesh.findHalfedge(4, 5) };
    expect(pick(0.5, 0.2, { mode: 'halfedge' })).toEqual(halfedge);
    expect(pick(0.001, 0.001, { mode: 'face' })).toEqual({ kind: 'face', index: 3 });
  });

  test('still means vertices, edges and the outer halfedges from just beside the outline', () => {
    const { mesh, pick } = scene();
    expect(pick(1.04, 1.04)).toEqual({ kind: 'vertex', index: 8 });
    expect(pick(1.03, 0.5)).toEqual({ kind: 'edge', index: mesh.findEdge(5, 8) });
    const outer = mesh.findHalfedge(8, 5);
    expect(mesh.isBoundaryHalfedge(outer)).toBe(true);
    expect(pick(1.03, 0.5, { mode: 'halfedge' })).toEqual({ kind: 'halfedge', index: outer });
    expect(pick(1.03, 0.5, { mode: 'face' })).toBe(null);
    expect(pick(1.2, 0.5)).toBe(null);
  });

  test('picks the arrows of boundary halfedges that are drawn, outside of the surface', () => {
    const { mesh, pick } = scene();
    const outer = mesh.findHalfedge(8, 5);
    const boundary = mesh
      .halfedges()
      .toArray()
      .filter((h) => mesh.isBoundaryHalfedge(h));
    expect(pick(1.065, 0.5)).toBe(null);
    expect(pick(1.065, 0.5, { boundary })).toEqual({ kind: 'halfedge', index: outer });
  });

  test('picks vertices without edges, unless the surface hides them', () => {
    const mesh = HalfedgeMesh.grid(2, 2, { width: 1, height: 1 });
    const { picker, pick, object } = scene(mesh);
    const beside = mesh.addVertex([0.7, 0.2, 0]);
    const below = mesh.addVertex([0.2, 0.25, -0.1]);
    const before = mesh.addVertex([0.2, 0.25, 0.1]);
    object.geometry.update();
    expect(pick(1.42, 0.41)).toEqual({ kind: 'vertex', index: beside });
    expect(pick(1.42, 0.41, { mode: 'edge' })).toBe(null);
    expect(pick(0.4, 0.5)).toEqual({ kind: 'vertex', index: before });
    mesh.deleteVertex(before);
    object.geometry.update();
    expect(pick(0.4, 0.5)).toEqual({ kind: 'face', index: 3 });
    expect(mesh.valence(below)).toBe(0);
    picker.dispose();
  });

  test('tells where a ray has hit, in the world, and what the surface hides', () => {
    const { picker, view } = scene();
    const hit = picker.faceAt(150, 175, view);
    expect(hit?.face).toBe(2);
    expect(hit?.point.toArray()).toEqual([4.5, 0.25, 0].map((x) => expect.closeTo(x)));
    expect(hit?.distance).toBeCloseTo(3);
    const ray = new THREE.Ray(new THREE.Vector3(4.5, 0.25, -2), new THREE.Vector3(0, 0, 1));
    expect(picker.cast(ray)).toMatchObject({ face: 2, distance: expect.closeTo(2) });
    expect(picker.hides(new THREE.Vector3(4.5, 0.25, -1), view.camera)).toBe(true);
    expect(picker.hides(new THREE.Vector3(4.5, 0.25, 0), view.camera)).toBe(false);
    expect(picker.hides(new THREE.Vector3(4.5, 0.25, 1), view.camera)).toBe(false);
  });

  test('tells what is hidden from where a camera has been put since its last picture', () => {
    const { picker } = scene();
    const camera = new THREE.PerspectiveCamera(60, 1, 0.1, 100);
    const point = new THREE.Vector3(4.5, 0.25, -1);
    camera.position.z = 3;
    expect(picker.hides(point, camera)).toBe(false); // it is seen past the grid
    camera.position.x = 5;
    expect(picker.hides(point, camera)).toBe(true);
  });

  describe('with a camera without perspective', () => {
    const OFF = 1.5; // of the middle, so that from where the camera stands, a point is seen past the surface
    const at = (x: number, y: number, z: number) => new THREE.Vector3(x, y, z);

    test.each([3, 1000])('tells what the surface hides along parallel rays, %i away', (height) => {
      const { picker, view } = scene();
      view.camera.position.set(5 + OFF, 0, height);
      view.camera.far = 2 * height;
      view.camera.updateProjectionMatrix();
      expect(picker.hides(at(4.1, 0.25, -1), view.camera)).toBe(true);
      expect(picker.hides(at(4.1, 0.25, -0.1), view.camera)).toBe(true);
      expect(picker.hides(at(4.1, 0.25, 0), view.camera)).toBe(false);
      expect(picker.hides(at(4.1, 0.25, 1), view.camera)).toBe(false);
      expect(picker.hides(at(3.9, 0.25, -1), view.camera)).toBe(false); // beside it
    });

    test('picks vertices without edges unless the surface hides them', () => {
      const mesh = HalfedgeMesh.grid(2, 2, { width: 1, height: 1 });
      mesh.addVertex([0.4, 0.1, -0.5]); // below
      mesh.addVertex([0.6, 0.1, 2]); // behind the camera
      const { pick, view } = scene(mesh);
      view.camera.position.x += OFF;
      expect(pick(0.8 - OFF, 0.2)).toEqual({ kind: 'face', index: 3 });
      expect(pick(1.2 - OFF, 0.2)).toBe(null);
    });

    test.each([-OFF, 0, OFF])('picks boundary arrows unless the surface hides them: %d', (x) => {
      const square = (half: number, z: number) =>
        [-half, -half, z, half, -half, z, half, half, z, -half, half, z] as const;
      const mesh = HalfedgeMesh.fromPolygons(
        [...square(0.5, 0), ...square(0.3, 0.02), ...square(0.4, -0.1)],
        [0, 4, 8].map((v) => [v, v + 1, v + 2, v + 3]),
      );
      const { pick, view } = scene(mesh);
      view.camera.position.x += x;
      const boundary = mesh
        .halfedges()
        .toArray()
        .filter((h) => mesh.isBoundaryHalfedge(h));
      const above = { kind: 'halfedge', index: mesh.findHalfedge(6, 5) };
      expect(pick(0.66 - x, 0, { boundary })).toEqual(above);
      expect(pick(0.865 - x, 0, { boundary })).toEqual({ kind: 'face', index: 0 });
    });

    test('picks what it sees behind where it stands', () => {
      const { picker, view, pick } = scene();
      view.camera.position.z = -2;
      view.camera.near = -10;
      view.camera.updateProjectionMatrix();
      expect(pick(0.5, 0.5)).toEqual({ kind: 'face', index: 3 });
      expect(pick(0.03, 0.04)).toEqual({ kind: 'vertex', index: 4 });
      expect(picker.hides(at(4.5, 0.25, -1), view.camera)).toBe(true);
      expect(picker.hides(at(4.5, 0.25, 1), view.camera)).toBe(false);
    });
  });

  test('hides, for a camera with a parallel projection, what lies behind along that', () => {
    const mesh = HalfedgeMesh.grid(2, 2, { width: 1, height: 1 });
    const { picker, object, pick } = scene(mesh);
    const { camera } = above(5, 20);
    expect(picker.hides(new THREE.Vector3(6.2, 0, -2), camera)).toBe(false); // seen beside the grid
    expect(picker.hides(new THREE.Vector3(5.9, 0, -2), camera)).toBe(true);
    const beside = mesh.addVertex([0.6, 0, -0.5]);
    mesh.addVertex([0.6, 0.2, 2]); // behind the camera
    object.geometry.update();
    expect(pick(1.2, 0)).toEqual({ kind: 'vertex', index: beside });
    expect(pick(1.2, 0.4)).toBe(null);
  });

  test('picks the arrow before a surface that lies behind it, with a parallel projection', () => {
    const { mesh } = HalfedgeMesh.fromSoup(
      [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1, 9, 0, -1, 0, 9, -1],
      [0, 1, 2, 3, 4, 5],
    );
    const picker = new MeshPicker(new THREE.Mesh(new MeshGeometry(mesh)));
    const view = above(-3, 8);
    const { x, y } = new THREE.Vector3(0.6, 0.6, 0).project(view.camera);
    const outer = mesh.findHalfedge(2, 1);
    const picked = picker.pick(SIZE * (0.5 + x / 2), SIZE * (0.5 - y / 2), view, {
      boundary: [outer],
    });
    expect(picked).toEqual({ kind: 'halfedge', index: outer });
  });

  test.each([
    ['perspective', new THREE.PerspectiveCamera(90, 1, 0.5, 10)],
    ['parallel projection', new THREE.OrthographicCamera(-2, 2, 2, -2, 0.5, 10)],
  ])('passes through what lies nearer than a camera sees: %s', (what, camera) => {
    const mesh = HalfedgeMesh.cube({ size: 2 });
    const picker = new MeshPicker(new THREE.Mesh(new MeshGeometry(mesh)));
    camera.position.z = 1.25; // before the cube, of which it sees the inside
    const view = { camera, width: SIZE, height: SIZE };
    const { point, distance } = picker.faceAt(220, 230, view) as FaceHit;
    expect(point.z).toBeCloseTo(-1);
    const expected = what === 'perspective' ? point.distanceTo(camera.position) : 2.25;
    expect(distance).toBeCloseTo(expected);
    expect(picker.hides(new THREE.Vector3(0.1, 0.2, 0.5), camera)).toBe(false);
    expect(picker.hides(new THREE.Vector3(0.1, 0.2, -1.5), camera)).toBe(true);
  });

  test('picks edges that begin behind the camera', () => {
    const floor = [-10, 0, -10, -10, 0, 10, 10, 0, 10, 10, 0, -10];
    const mesh = HalfedgeMesh.fromPolygons(floor, [[0, 1, 2, 3]]);
    const picker = new MeshPicker(new THREE.Mesh(new MeshGeometry(mesh)));
    const camera = new THREE.PerspectiveCamera(60, 1, 0.1, 100);
    camera.position.set(9, 1, 0);
    camera.updateMatrixWorld();
    const { x, y } = new THREE.Vector3(10, 0, -4).project(camera);
    const place = [SIZE * (0.5 + x / 2) - 1, SIZE * (0.5 - y / 2)] as const;
    const view = { camera, width: SIZE, height: SIZE };
    const side = { kind: 'edge', index: mesh.findEdge(2, 3) };
    expect(picker.pick(...place, view)).toEqual(side);
    expect(picker.pick(...place, view, { mode: 'edge' })).toEqual(side);
  });

  test('picks a concave polygon as the one face that it is', () => {
    const mesh = HalfedgeMesh.fromPolygons([0, 0, 0, 1, -1, 0, 0, 1, 0, -1, -1, 0], [[0, 1, 2, 3]]);
    const { pick } = scene(mesh);
    for (const [x, y] of [
      [-1, -0.7],
      [1, -0.7],
      [0, 1],
    ]) {
      expect(pick(x, y, { mode: 'face' })).toEqual({ kind: 'face', index: 0 });
    }
    expect(pick(0, -0.8, { mode: 'face' })).toBe(null);
  });

  test('reaches further for a finger', () => {
    const { pick } = scene();
    expect(pick(0.15, 0.09)?.kind).not.toBe('vertex');
    expect(pick(0.15, 0.09, { reach: 2 })?.kind).toBe('vertex');
  });

  test('refuses wrong arguments with a sentence', () => {
    expect(() => new MeshPicker(new THREE.Mesh() as never)).toThrow(
      /^object is a.*; expected a Mesh with a MeshGeometry\.$/,
    );
    expect(() => scene().pick(0, 0, { mode: 'corner' as never })).toThrow(
      /options\.mode is "corner"; expected 'auto'/,
    );
  });

  test.each([
    [[undefined], 'x is undefined; expected a number of pixels.'],
    [[1, '2'], 'y is "2"; expected a number of pixels.'],
    [[1, 2], 'view is undefined; expected an object.'],
    [[1, 2, new THREE.Scene()], 'view.camera is undefined; expected a Camera of three.js.'],
    [
      [1, 2, { camera: new THREE.Camera() }],
      'view.width is undefined; expected a number of pixels.',
    ],
    [
      [1, 2, { camera: new THREE.Camera(), width: SIZE, height: SIZE }],
      'view.camera is a Camera; expected a PerspectiveCamera or an OrthographicCamera.',
    ],
    [[1, 2, above(0, 1), { reach: 0 }], 'options.reach is 0; expected a positive number.'],
    [[1, 2, above(0, 1), 2], 'options is 2; expected an object.'],
    [
      [1, 2, above(0, 1), { boundary: 3 }],
      'options.boundary is 3; expected halfedges to iterate over.',
    ],
  ])('refuses to pick at what is no place: %#', (list, message) => {
    const { picker } = scene();
    expect(() => (picker.pick as (...list: unknown[]) => unknown).apply(picker, list)).toThrow(
      message,
    );
  });

  test('refuses what is no ray', () => {
    const { picker } = scene();
    expect(() => picker.cast(new THREE.Raycaster() as never)).toThrow(
      'ray is a Raycaster; expected a Ray of three.js, such as raycaster.ray.',
    );
    expect(() => picker.cast(undefined as never)).toThrow(/^ray is undefined; expected a Ray/);
  });
});

describe('After edits, MeshPicker', () => {
  test.each([1, 2])('hits what three.js hits: seed %i', (seed) => {
    const next = random(seed);
    const mesh = HalfedgeMesh.icoSphere(3);
    mesh.history.enabled = true;
    const object = new THREE.Mesh(new MeshGeometry(mesh, seed % 2 ? {} : { normals: 'flat' }));
    const picker = new MeshPicker(object);
    const done: string[] = [];
    for (let i = 0; i < 40; i++) {
      const way = next();
      if (way < 0.1) done.push(`undo ${mesh.history.undo()}`);
      else if (way < 0.15) mesh.compact();
      else if (way < 0.3 && mesh.vertexCount > 0) {
        const [v] = mesh.vertices();
        for (let k = 0; k < 3; k++) mesh.positions[3 * v + k] *= 1.1;
      } else {
        const edit = randomEdit(mesh, next);
        refusalOf(edit);
        done.push(edit.name);
      }
      object.geometry.update();
      for (let r = 0; r < 4; r++) {
        const origin = somewhere(next).setLength(5);
        const to = somewhere(next);
        const ray = new THREE.Ray(origin, to.sub(origin).normalize());
        const [hit, expected] = [picker.cast(ray), hitByThree(object, ray)];
        const what = `seed ${seed}, step ${i}: ${done.slice(-3).join('; ')}`;
        // Where two faces lie upon each other, either will do.
        expect([what, hit?.distance]).toEqual([
          what,
          expected && expect.closeTo(expected.distance, 4),
        ]);
        if (hit) expect(mesh.connectivity.faceHalfedge[hit.face]).toBeGreaterThanOrEqual(0);
      }
    }
    picker.dispose();
    mesh.dispose();
  });

  test.each([1, 2, 3])('hits what three.js hits where most faces move: seed %i', (seed) => {
    const next = random(seed);
    const mesh = HalfedgeMesh.icoSphere(4); // of more faces than are kept beside the tree
    mesh.history.enabled = true;
    const object = new THREE.Mesh(new MeshGeometry(mesh, seed % 2 ? {} : { normals: 'flat' }));
    const picker = new MeshPicker(object);
    let hits = 0;
    for (let i = 0; i < 30; i++) {
      const way = next();
      if (way < 0.7) {
        const { positions } = mesh;
        for (let k = 0; k < positions.length; k++) positions[k] += 0.02 * (next() - 0.5);
      } else if (way < 0.8) {
        const flips = mesh.edges().toArray();
        for (const e of flips) if (next() < 0.5 && !mesh.checkFlipEdge(e)) mesh.flipEdge(e);
      } else if (way < 0.9) refusalOf(randomEdit(mesh, next));
      else mesh.history.undo();
      object.geometry.update();
      if (next() < 0.5) continue;
      for (let r = 0; r < 10; r++) {
        const origin = somewhere(next).setLength(5);
        const to = somewhere(next);
        const ray = new THREE.Ray(origin, to.sub(origin).normalize());
        const [hit, expected] = [picker.cast(ray), hitByThree(object, ray)];
        expect([seed, i, hit?.distance]).toEqual([
          seed,
          i,
          expected && expect.closeTo(expected.distance, 4),
        ]);
        if (hit) hits += 1;
      }
    }
    expect(hits).toBeGreaterThan(20);
    picker.dispose();
    mesh.dispose();
  });

  test('waits for a ray where most faces move, and then takes them up once', () => {
    const { tree, shown, move, hit } = moving(HalfedgeMesh.grid(60, 60, { triangles: true }));
    expect(shown.asked).toBe(1);
    for (let i = 1; i <= 10; i++) move(i);
    expect(shown.asked).toBe(1);
    expect([hit(), hit()]).toEqual([5 + 10, 5 + 10]);
    expect(shown.asked).toBe(2);
    move(20);
    move(30, [0]); // while the others are not taken up yet
    expect(hit()).toBe(5 + 30);
    move(40);
    tree.update(null, shown);
    expect(hit()).toBe(5 + 40);
    expect(shown.asked).toBe(4);
  });

  test('passes over boundary halfedges that are gone, or have a face now', () => {
    const { mesh, object, pick } = scene();
    mesh.history.enabled = true;
    const outer = mesh.findHalfedge(8, 5);
    const boundary = [mesh.findHalfedge(1, 0), outer];
    mesh.deleteFace(0);
    object.geometry.update();
    expect(pick(1.065, 0.5, { boundary })).toEqual({ kind: 'halfedge', index: outer });
    mesh.history.undo();
    mesh.fillHole(outer);
    object.geometry.update();
    expect(pick(1.065, 0.5, { boundary })).not.toEqual({ kind: 'halfedge', index: outer });
  });

  test('stays with its geometry where the object has got another one', () => {
    const { mesh, object, picker, pick } = scene();
    const { geometry } = object;
    for (const other of [new THREE.BoxGeometry(), new MeshGeometry(HalfedgeMesh.cube())]) {
      object.geometry = other as MeshGeometry;
      expect(pick(0.03, 0.04)).toEqual({ kind: 'vertex', index: 4 });
    }
    mesh.deleteFace(3);
    geometry.update();
    expect(pick(0.5, 0.5)).toBe(null);
    picker.dispose();
  });

  test('no longer follows once it is disposed of', () => {
    const { mesh, object, picker, pick } = scene();
    picker.dispose();
    mesh.deleteFace(3);
    object.geometry.update();
    expect(pick(0.5, 0.5, { mode: 'face' })).toBe(null); // gone, though the tree does not know
    expect(pick(-0.5, -0.5, { mode: 'face' })).toEqual({ kind: 'face', index: 0 });
  });
});

describe('Of many faces, MeshPicker', () => {
  const ROWS = 180; // of more triangles than are taken up at once

  function many(worker: () => never, others: { begin?: () => Promise<void> } = {}) {
    const mesh = HalfedgeMesh.grid(ROWS, ROWS, { width: 2, height: 2, triangles: true });
    const object = new THREE.Mesh(new MeshGeometry(mesh, { normals: 'none' }));
    const picker = new MeshPicker(object, { worker, ...others });
    const view = above(0, 2);
    /** In one half of a square of the grid, in pixels. */
    const faceAt = (column: number, row: number) =>
      picker.pick((SIZE * (column + 0.6)) / ROWS, SIZE * (1 - (row + 0.3) / ROWS), view, {
        mode: 'face',
      })?.index;
    return { mesh, object, picker, faceAt };
  }

  test('finds the one that is there, before and after an edit', () => {
    const { mesh, object, picker, faceAt } = many(() => null as never);
    const face = faceAt(100, 90) as number;
    expect(face >> 1).toBe(90 * ROWS + 100);
    mesh.makeHole(face);
    object.geometry.update();
    expect(faceAt(100, 90)).toBe(undefined);
    expect((faceAt(101, 90) as number) >> 1).toBe(90 * ROWS + 101);
    picker.dispose();
    mesh.dispose();
  });

  test('works before a worker has grown the tree, and takes up edits made meanwhile', async () => {
    const thread = new FakeWorker();
    const { mesh, object, picker, faceAt } = many(() => thread as never);
    mesh.history.enabled = true;
    const face = faceAt(100, 90) as number;
    expect(face >> 1).toBe(90 * ROWS + 100);
    mesh.makeHole(face);
    object.geometry.update();
    expect(faceAt(100, 90)).toBe(undefined);
    expect(thread.isTerminated).toBe(false);
    thread.answer();
    await picker.ready;
    expect(thread.isTerminated).toBe(true);
    expect(faceAt(100, 90)).toBe(undefined);
    expect((faceAt(101, 90) as number) >> 1).toBe(90 * ROWS + 101);
    mesh.history.undo();
    object.geometry.update();
    expect(faceAt(100, 90)).toBe(face);
    picker.dispose();
    mesh.dispose();
  });

  describe('when all of them change at once,', () => {
    function changing() {
      const threads: FakeWorker[] = [];
      const { mesh, object, picker } = many(() => {
        threads.push(new FakeWorker());
        return threads.at(-1) as never;
      });
      const next = random(7);
      const hitsWhatThreeHits = (what: string) => {
        for (let r = 0; r < 4; r++) {
          const origin = new THREE.Vector3(next() - 0.5, next() - 0.5, 4);
          const to = new THREE.Vector3(next() - 0.5, (next() - 0.5) / 20, 0);
          const ray = new THREE.Ray(origin, to.sub(origin).normalize());
          const [hit, expected] = [picker.cast(ray), hitByThree(object, ray)];
          const distance = expected && expect.closeTo(expected.distance, 4);
          expect([what, hit?.distance, hit?.face]).toEqual([what, distance, expected?.face]);
        }
      };
      const move = (to: (x: number, y: number) => [number, number, number]) => {
        const { positions } = mesh;
        for (let i = 0; i < positions.length; i += 3) {
          positions.set(to(positions[i], positions[i + 1]), i);
        }
        object.geometry.update();
      };
      const grow = () => {
        threads.at(-1)?.answer();
        return picker.ready;
      };
      const end = () => {
        picker.dispose();
        mesh.dispose();
      };
      return { mesh, object, threads, hitsWhatThreeHits, move, grow, end };
    }

    test('keeps the tree of those that only move, while it grows and after', async () => {
      const { threads, hitsWhatThreeHits, move, grow, end } = changing();
      move((x, y) => [x, y, Math.sin(7 * x)]);
      hitsWhatThreeHits('a wave, before the tree has grown');
      await grow(); // over the plane that it was
      hitsWhatThreeHits('the wave');
      move((x, y) => [-y, x, Math.cos(5 * y)]);
      hitsWhatThreeHits('a wave across');
      move((x, y) => [x + 5, y, 0]);
      hitsWhatThreeHits('out of reach');
      move((x, y) => [x - 5, y, 2 + x * y]);
      hitsWhatThreeHits('a saddle');
      expect(threads.length).toBe(1);
      end();
    });

    test('grows another tree over other triangles', async () => {
      const { mesh, object, threads, hitsWhatThreeHits, move, grow, end } = changing();
      await grow();
      for (let f = 0; f < 8000; f += 2) {
        for (const e of [...mesh.faceEdges(f)]) {
          const [one, other] = mesh.edgeFaces(e);
          if (one + other === f + (f + 1)) mesh.flipEdge(e); // between the two of a square
        }
      }
      object.geometry.update();
      hitsWhatThreeHits('as many others');
      expect(threads.length).toBe(2);
      await grow();
      mesh.deleteFace(77);
      object.geometry.update();
      move((x, y) => [x, y, Math.sin(7 * x)]);
      hitsWhatThreeHits('a wave with a hole');
      expect(threads.length).toBe(3);
      await grow();
      mesh.compact(); // to the same triangles, of faces with other numbers
      object.geometry.update();
      hitsWhatThreeHits('the same of other faces');
      expect(threads.length).toBe(4);
      end();
    });

    test('forgets those beside the tree', async () => {
      const { mesh, object, threads, hitsWhatThreeHits, move, grow, end } = changing();
      await grow();
      const middle = mesh.faceCount / 2;
      const pokes = [...mesh.faces()].slice(middle - 1000, middle + 1000);
      while (pokes.length > 0) {
        for (const f of pokes.splice(-1000)) mesh.poke(f);
        object.geometry.update();
      }
      hitsWhatThreeHits('few at a time');
      expect(threads.length).toBe(2); // over which a tree grows now
      move((x, y) => [x, y, Math.sin(7 * x)]);
      hitsWhatThreeHits('a wave');
      await grow();
      hitsWhatThreeHits('a wave with a tree');
      expect(threads.length).toBe(3);
      end();
    });
  });

  test('grows the tree itself where the worker answers something else', async () => {
    const thread = new FakeWorker();
    const { mesh, picker, faceAt } = many(() => thread as never);
    thread.answer(null);
    await picker.ready;
    expect(thread.isTerminated).toBe(true);
    expect((faceAt(100, 90) as number) >> 1).toBe(90 * ROWS + 100);
    picker.dispose();
    mesh.dispose();
  });

  test('follows faces that move while a worker grows the tree, and grows another in time', async () => {
    const threads: FakeWorker[] = [];
    const worker = () => {
      threads.push(new FakeWorker());
      return threads.at(-1) as never;
    };
    const mesh = HalfedgeMesh.grid(ROWS, ROWS, { triangles: true });
    const { tree, move, hit } = moving(mesh, { worker });
    move(1);
    expect(hit()).toBe(6);
    expect(tree.isGrown).toBe(false);
    move(2);
    threads[0].answer();
    await tree.ready;
    expect(tree.isGrown).toBe(true);
    expect(hit()).toBe(7);
    expect(threads.length).toBe(1);
    for (let i = 0; i < 100; i++) {
      move(i);
      expect(hit()).toBe(5 + i);
    }
    expect(threads.length).toBe(2);
    move(3);
    expect(hit()).toBe(8);
    threads[1].answer();
    expect(hit()).toBe(8);
    move(4);
    expect(hit()).toBe(9);
    move(5);
    tree.dispose();
    expect(hit()).toBe(9);
    mesh.dispose();
  });

  test('lets a worker begin when it may', async () => {
    const thread = new FakeWorker();
    let asked = 0;
    const begin = () => {
      asked += 1;
      return Promise.resolve();
    };
    const { mesh, picker } = many(() => thread as never, { begin });
    expect(asked).toBe(1);
    picker.dispose();
    mesh.dispose();
  });
});
