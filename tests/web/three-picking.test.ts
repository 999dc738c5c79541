import { HalfedgeMesh, init } from 'halfedge';
import { MeshGeometry } from 'halfedge/three';
import { type FaceHit, MeshPicker, type PickOptions } from 'halfedge/three/picking';
import * as THREE from 'three';
import { above, SIZE } from './support/picking.js';

beforeAll(() => init());

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
    [
      [1, 2, above(0, 1), { boundary: [0, 'h3'] }],
      'options.boundary[1] is "h3"; expected an index, an integer from 0 to 4294967294.',
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
    const likeOne = { origin: new THREE.Vector3(), direction: new THREE.Vector3(0, 0, 1) };
    expect(() => picker.cast(likeOne as never)).toThrow(/^ray is an Object; expected a Ray/);
  });

  test.each([
    [[undefined], 'point is undefined; expected a Vector3 of three.js.'],
    [
      [[0, 0, 0], new THREE.PerspectiveCamera()],
      'point is an array of 3 elements; expected a Vector3',
    ],
    [
      [new THREE.Vector3()],
      'camera is undefined; expected a PerspectiveCamera or an OrthographicCamera.',
    ],
    [[new THREE.Vector3(), new THREE.Camera()], 'camera is a Camera; expected a PerspectiveCamera'],
  ])('does not tell whether the surface hides what is no point: %#', (list, message) => {
    const { picker } = scene();
    expect(() => (picker.hides as (...list: unknown[]) => unknown).apply(picker, list)).toThrow(
      message,
    );
  });
});

describe('After edits, MeshPicker', () => {
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
