import { BufferAttribute, BufferGeometry, DoubleSide, type Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { Drawn } from './change.js';

/** With more triangles than this beside the tree, it is built anew. */
const MOST_LOOSE = 3000;

export interface RayHit {
  readonly face: number;
  readonly distance: number;
}

/**
 * Finds the face that a ray hits first. A tree over the triangles is built once; after an edit, the
 * triangles of the faces that changed are taken out of it, and those that came instead lie loose
 * beside it. So an edit costs what it touched, whatever the size of the mesh.
 */
export class RayTree {
  readonly #faceOf: Uint32Array;
  readonly #triangles: Uint32Array;
  readonly #bvh: MeshBVH | null;
  /** By face that changed: nine coordinates of each of its triangles. */
  readonly #loose = new Map<number, Float32Array>();
  readonly #corners = [new Vector3(), new Vector3(), new Vector3()] as const;
  readonly #point = new Vector3();

  constructor({ points, triangles, faceOf }: Drawn) {
    this.#faceOf = faceOf;
    this.#triangles = triangles.slice();
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(points.slice(), 3));
    geometry.setIndex(new BufferAttribute(this.#triangles, 1));
    // Indirect: the tree must not reorder the triangles, because `faceOf` follows their order.
    this.#bvh = faceOf.length > 0 ? new MeshBVH(geometry, { indirect: true }) : null;
  }

  /** Takes over faces that changed. False if there are too many by now: then a new tree is due. */
  update(faces: Iterable<number>, now: Drawn): boolean {
    for (const face of faces) {
      const [from, to] = rangeOf(this.#faceOf, face);
      // Three times the same vertex: a triangle that no ray hits.
      this.#triangles.fill(0, 3 * from, 3 * to);
      const [first, last] = rangeOf(now.faceOf, face);
      if (last === first) this.#loose.delete(face);
      else this.#loose.set(face, coordinates(now, first, last));
    }
    return this.#loose.size <= MOST_LOOSE;
  }

  /** The face that the ray hits first, from either side. */
  cast(ray: Ray): RayHit | null {
    const hit = this.#bvh?.raycastFirst(ray, DoubleSide);
    let found: RayHit | null = hit
      ? { face: this.#faceOf[hit.faceIndex as number], distance: hit.distance }
      : null;
    const [a, b, c] = this.#corners;
    for (const [face, corners] of this.#loose) {
      for (let i = 0; i < corners.length; i += 9) {
        a.fromArray(corners, i);
        b.fromArray(corners, i + 3);
        c.fromArray(corners, i + 6);
        if (!ray.intersectTriangle(a, b, c, false, this.#point)) continue;
        const distance = this.#point.distanceTo(ray.origin);
        if (!found || distance < found.distance) found = { face, distance };
      }
    }
    return found;
  }
}

/** Where the triangles of a face begin and end; `faceOf` is in ascending order. */
function rangeOf(faceOf: Uint32Array, face: number): [from: number, to: number] {
  let low = 0;
  let high = faceOf.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (faceOf[middle] < face) low = middle + 1;
    else high = middle;
  }
  let end = low;
  while (faceOf[end] === face) end += 1;
  return [low, end];
}

function coordinates({ points, triangles }: Drawn, first: number, last: number): Float32Array {
  const xyz = new Float32Array(9 * (last - first));
  for (let i = 3 * first; i < 3 * last; i++) {
    for (let k = 0; k < 3; k++) xyz[3 * (i - 3 * first) + k] = points[3 * triangles[i] + k];
  }
  return xyz;
}
