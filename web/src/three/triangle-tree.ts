// The only file, besides the script of its worker, that knows three-mesh-bvh: a peer dependency of
// `halfedge/three/picking`.

import { BufferAttribute, BufferGeometry, DoubleSide, type Ray } from 'three';
import { MeshBVH, type SerializedBVH } from 'three-mesh-bvh';

/** Triangles of faces. */
export interface Triangles {
  /** xyz by vertex. */
  readonly points: Float32Array;
  /** Three vertices of each triangle. */
  readonly vertices: Uint32Array;
  /** By triangle, in ascending order: the face that it is part of. */
  readonly faces: Uint32Array;
}

/** A triangle that a ray hits. */
export interface TriangleHit {
  readonly face: number;
  readonly distance: number;
}

/** Triangles that a ray is tried against: one by one, until a tree was grown over them. */
export class TriangleTree {
  readonly #triangles: Triangles;
  readonly #geometry = new BufferGeometry();
  #bvh: MeshBVH | null = null;

  /** It takes possession of the arrays. */
  constructor(triangles: Triangles) {
    this.#triangles = triangles;
    this.#geometry.setAttribute('position', new BufferAttribute(triangles.points, 3));
    this.#geometry.setIndex(new BufferAttribute(triangles.vertices, 1));
  }

  /** How many triangles there are, those removed included. */
  get size(): number {
    return this.#triangles.faces.length;
  }

  get isGrown(): boolean {
    return this.#bvh !== null;
  }

  /** Grows the tree. About a second for a million triangles, which `picking-thread` can take elsewhere. */
  grow(): void {
    if (this.size > 0) this.#bvh = new MeshBVH(this.#geometry, GROWN);
  }

  /** What was grown elsewhere, over the same triangles. */
  adopt(grown: SerializedBVH): void {
    this.#bvh = MeshBVH.deserialize(grown, this.#geometry, { setIndex: false });
  }

  /** A copy of what `grownOver` needs, for another thread. */
  get seed(): TreeSeed {
    const { points, vertices } = this.#triangles;
    return { points: points.slice(), vertices: vertices.slice() };
  }

  /** Removes the triangles of a face. */
  remove(face: number): void {
    const { faces, vertices } = this.#triangles;
    const from = firstOf(faces, face);
    let to = from;
    while (faces[to] === face) to += 1;
    // Three times the same vertex: a triangle that no ray hits.
    vertices.fill(0, 3 * from, 3 * to);
  }

  /** Moves its triangles to where these are. False if these are others; then nothing was done. */
  follow({ points, vertices, faces }: Triangles): boolean {
    const own = this.#triangles;
    if (points.length !== own.points.length) return false;
    if (!isSame(faces, own.faces) || !isSame(vertices, own.vertices)) return false;
    own.points.set(points);
    this.#bvh?.refit();
    return true;
  }

  /** The triangle that a ray hits first, from either side. */
  cast(ray: Ray): TriangleHit | null {
    if (this.#bvh === null) return this.#tryAll(ray);
    const hit = this.#bvh.raycastFirst(ray, DoubleSide);
    if (!hit) return null;
    return { face: this.#triangles.faces[hit.faceIndex as number], distance: hit.distance };
  }

  #tryAll(ray: Ray): TriangleHit | null {
    const { points, vertices, faces } = this.#triangles;
    let found = -1;
    let least = Infinity;
    for (let t = 0; t < faces.length; t++) {
      const distance = distanceToTriangle(
        ray,
        points,
        3 * vertices[3 * t],
        3 * vertices[3 * t + 1],
        3 * vertices[3 * t + 2],
      );
      if (distance >= least) continue;
      least = distance;
      found = t;
    }
    return found < 0 ? null : { face: faces[found], distance: least };
  }
}

/** Indirect: the tree must not reorder the triangles, which come in the order of their faces. */
const GROWN = { indirect: true };

/** Triangles without their faces. */
export type TreeSeed = Pick<Triangles, 'points' | 'vertices'>;

/** Grows a tree, and takes it apart to be sent; with the buffers that can be transferred. */
export function grownOver({ points, vertices }: TreeSeed): {
  grown: SerializedBVH;
  buffers: ArrayBuffer[];
} {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(points, 3));
  geometry.setIndex(new BufferAttribute(vertices, 1));
  const serialized = MeshBVH.serialize(new MeshBVH(geometry, GROWN), { cloneBuffers: false });
  const { roots, indirectBuffer } = serialized;
  const buffers = [...roots, ...(indirectBuffer ? [indirectBuffer.buffer as ArrayBuffer] : [])];
  return { grown: { ...serialized, index: null }, buffers };
}

function isSame(some: Uint32Array, others: Uint32Array): boolean {
  if (some.length !== others.length) return false;
  for (let i = 0; i < some.length; i++) if (some[i] !== others[i]) return false;
  return true;
}

/** Where a face begins in an ascending list, or would. */
function firstOf(faces: Uint32Array, face: number): number {
  let low = 0;
  let high = faces.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (faces[middle] < face) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * How far along a ray it hits the triangle whose corners are at `a`, `b` and `c` in `points`; infinite for a
 * miss. After Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
 */
export function distanceToTriangle(
  { origin, direction: d }: Ray,
  points: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
): number {
  const [ax, ay, az] = [points[a], points[a + 1], points[a + 2]];
  const [ux, uy, uz] = [points[b] - ax, points[b + 1] - ay, points[b + 2] - az];
  const [vx, vy, vz] = [points[c] - ax, points[c + 1] - ay, points[c + 2] - az];
  const [px, py, pz] = [d.y * vz - d.z * vy, d.z * vx - d.x * vz, d.x * vy - d.y * vx];
  const determinant = ux * px + uy * py + uz * pz;
  if (determinant === 0) return MISS;
  const [sx, sy, sz] = [origin.x - ax, origin.y - ay, origin.z - az];
  const s = (sx * px + sy * py + sz * pz) / determinant;
  if (!(s >= 0 && s <= 1)) return MISS;
  const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
  const t = (d.x * qx + d.y * qy + d.z * qz) / determinant;
  if (!(t >= 0 && s + t <= 1)) return MISS;
  const distance = (vx * qx + vy * qy + vz * qz) / determinant;
  return distance >= 0 ? distance : MISS;
}

const MISS = Infinity;
