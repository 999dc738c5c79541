import type { MeshGeometry } from 'halfedge/three';
import * as THREE from 'three';

/** Of the canvas, in pixels. */
export const SIZE = 400;

/** A camera above the origin of a square canvas, that sees `width` of the world. */
export function above(x: number, width: number) {
  const half = width / 2;
  const camera = new THREE.OrthographicCamera(-half, half, half, -half, 0.1, 10);
  camera.position.set(x, 0, 3);
  camera.updateMatrixWorld();
  return { camera, width: SIZE, height: SIZE };
}

const somewhere = (next: () => number) =>
  new THREE.Vector3(next() - 0.5, next() - 0.5, next() - 0.5);

/** A ray from 5 away of the origin to a point of the cube of length 1 around it. */
export function randomRay(next: () => number): THREE.Ray {
  const origin = somewhere(next).setLength(5);
  return new THREE.Ray(origin, somewhere(next).sub(origin).normalize());
}

/** What a ray hits, tried against all triangles. */
export function hitByThree({ geometry, matrixWorld }: THREE.Mesh<MeshGeometry>, ray: THREE.Ray) {
  const plain = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
  plain.matrixWorld.copy(matrixWorld);
  const [hit] = new THREE.Raycaster(ray.origin, ray.direction).intersectObject(plain);
  return hit && { face: geometry.face(hit.faceIndex as number), distance: hit.distance };
}
