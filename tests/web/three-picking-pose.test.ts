// What a picker hits of a SkinnedMesh, compared with three.js's own rays.

import { HalfedgeMesh, init } from 'halfedge';
import { MeshGeometry } from 'halfedge/three';
import { MeshPicker } from 'halfedge/three/picking';
import * as THREE from 'three';
import { above, SIZE } from './support/picking.js';

beforeAll(() => init());

const LAYOUTS = [
  ['indexed', 'smooth'],
  ['with three vertices for each triangle', 'flat'],
] as const;

/** A strip of quads in an object beside the origin, and the bone that bends the right half of it. */
function arm(normals: 'smooth' | 'flat', length = 40) {
  const mesh = HalfedgeMesh.grid(length, 1, { width: 2, height: 0.5 });
  mesh.attributes.add('vertex', 'skinIndex', { type: 'uint16', components: 4 });
  mesh.attributes.add('vertex', 'skinWeight', { type: 'float32', components: 4 });
  for (const v of mesh.vertices()) {
    const bent = Math.min(1, Math.max(0, 2 * mesh.position(v)[0] + 0.5));
    mesh.attributes.get('vertex', 'skinIndex').set([0, 1, 0, 0], 4 * v);
    mesh.attributes.get('vertex', 'skinWeight').set([1 - bent, bent, 0, 0], 4 * v);
  }
  const geometry = new MeshGeometry(mesh, { normals });
  const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide });
  const object = new THREE.SkinnedMesh(geometry, material);
  const [shoulder, elbow] = [new THREE.Bone(), new THREE.Bone()];
  object.add(shoulder.add(elbow));
  object.bind(new THREE.Skeleton([shoulder, elbow]));
  object.position.set(0.2, -0.3, 0);
  const picker = new MeshPicker(object);
  const down = new THREE.Vector3(0, 0, -1);
  /** The faces that rays hit along the strip, -1 for none, and those that three.js's rays hit. */
  const faces = (y = 0.15) => {
    const origins = Array.from({ length: 25 }, (_, i) => new THREE.Vector3(i / 10 - 1.2, y, 5));
    const ours = origins.map((origin) => picker.cast(new THREE.Ray(origin, down))?.face ?? -1);
    object.updateMatrixWorld(true);
    object.computeBoundingSphere();
    const theirs = origins.map((origin) => {
      const [hit] = new THREE.Raycaster(origin, down).intersectObject(object);
      return geometry.face(hit?.faceIndex);
    });
    return { ours, theirs };
  };
  return { mesh, geometry, object, elbow, picker, faces };
}

describe.each(LAYOUTS)('A SkinnedMesh, %s,', (_, normals) => {
  test('is picked where its bones have moved it', () => {
    const { mesh, object, elbow, picker, faces } = arm(normals);
    const straight = faces();
    expect(straight.ours).toEqual(straight.theirs);
    for (const angle of [0.5, -0.9, 1.2]) {
      elbow.rotation.z = angle;
      for (const y of [0.15, 0.4, -0.4]) {
        const { ours, theirs } = faces(y);
        expect(ours).toEqual(theirs);
      }
    }
    expect(faces().ours).not.toEqual(straight.ours);
    // The corner of the last face, where it is seen.
    const corner = mesh.vertices().toArray().at(-1) as number;
    const { x, y } = new THREE.Vector3(1, 0.25, 0).applyMatrix4(elbow.matrixWorld);
    const view = above(0, 4);
    const item = picker.pick((0.5 + x / 4) * SIZE, (0.5 - y / 4) * SIZE, view, { mode: 'auto' });
    expect(item).toEqual({ kind: 'vertex', index: corner });
    object.position.x += 0.3;
    const moved = faces();
    expect(moved.ours).toEqual(moved.theirs);
  });

  test('is picked as edits leave it', () => {
    const { mesh, geometry, elbow, faces } = arm(normals);
    elbow.rotation.z = 0.7;
    const lower = (from: number, to: number) => {
      for (const v of mesh.vertices()) {
        const [x] = mesh.position(v);
        if (x > from && x < to) mesh.positions[3 * v + 1] -= 0.3;
      }
    };
    const same = () => {
      const { ours, theirs } = faces(-0.15);
      expect(ours).toEqual(theirs);
      return ours;
    };
    const whole = same();
    mesh.deleteFace(30);
    lower(-2, -0.5);
    geometry.update();
    expect(same()).not.toEqual(whole);
    mesh.triangulate(22);
    geometry.update();
    elbow.rotation.z = 0.2;
    same();
  });

  test('is picked as its geometry leaves it that is made anew, because few faces are left', () => {
    const { mesh, geometry, elbow, faces } = arm(normals, 2000);
    elbow.rotation.z = 0.7;
    faces();
    for (let f = 0; f < 1900; f++) mesh.deleteFace(f);
    for (const v of mesh.vertices()) mesh.positions[3 * v] -= 1;
    geometry.update();
    const { ours, theirs } = faces(-0.3);
    expect(ours).toEqual(theirs);
    expect(Math.max(...ours)).toBeGreaterThan(1899);
  });

  test('is picked as its weights are painted', () => {
    const { mesh, geometry, elbow, faces } = arm(normals);
    elbow.rotation.z = 0.9;
    const before = faces(-0.3);
    expect(before.ours).toEqual(before.theirs);
    for (let v = 4; v < 80; v++)
      mesh.attributes.get('vertex', 'skinWeight').set([0, 1, 0, 0], 4 * v);
    geometry.update();
    const painted = faces(-0.3);
    expect(painted.ours).toEqual(painted.theirs);
    expect(painted.ours).not.toEqual(before.ours);
    geometry.attributes.skinWeight.array.fill(0.5); // past the mesh
    geometry.attributes.skinWeight.needsUpdate = true;
    const equal = faces(-0.1);
    expect(equal.ours).toEqual(equal.theirs);
    expect(equal.ours).not.toEqual(faces(-0.3).ours);
  });

  test('is refused with a sentence while a vertex names a bone that is not there', () => {
    const { mesh, geometry, object, elbow, picker, faces } = arm(normals);
    const { ours } = faces();
    const write = (bones: readonly number[], weights: readonly number[]) => {
      mesh.attributes.get('vertex', 'skinIndex').set(bones, 28);
      mesh.attributes.get('vertex', 'skinWeight').set(weights, 28);
      geometry.update();
    };
    const read = (name: string) => [
      ...mesh.attributes.get('vertex', name as 'skinWeight').subarray(28, 32),
    ];
    const [bones, weights] = [read('skinIndex'), read('skinWeight')];
    write([0, 1, 9, 9], weights); // a weight of 0 may name any bone
    expect(faces().ours).toEqual(ours);
    write([0, 1, 9, 9], [0.5, 0, 0, 0.5]);
    const message =
      'skinIndex of vertex 7 names bone 9 with the weight 0.5; expected one of the 2 bones of the skeleton.';
    const down = new THREE.Ray(new THREE.Vector3(0, 0, 5), new THREE.Vector3(0, 0, -1));
    for (const angle of [0, 0.4, 0.4]) {
      elbow.rotation.z = angle;
      expect(() => picker.cast(down)).toThrow(message);
    }
    expect(() => new MeshPicker(object as never)).toThrow(message);
    write(bones, weights);
    const mended = faces();
    expect(mended.ours).toEqual(mended.theirs);
    expect(mended.ours).not.toEqual(ours);
  });

  test('is picked as it was last, once its picker is disposed of', () => {
    const { elbow, picker, faces } = arm(normals);
    elbow.rotation.z = 0.7;
    const { ours } = faces();
    picker.dispose();
    elbow.rotation.z = 0;
    expect(faces().ours).toEqual(ours);
  });
});

test('A SkinnedMesh without a skeleton, or with a geometry without weights, is picked at rest', () => {
  using mesh = HalfedgeMesh.grid(2, 2);
  const object = new THREE.SkinnedMesh(new MeshGeometry(mesh));
  const picker = new MeshPicker(object as never);
  const down = new THREE.Ray(new THREE.Vector3(0.1, 0.1, 5), new THREE.Vector3(0, 0, -1));
  expect(picker.cast(down)?.face).toBe(3);
  object.bind(new THREE.Skeleton([new THREE.Bone()]));
  expect(picker.cast(down)?.face).toBe(3);
});
