// Bounds of the vertices of a mesh that are alive and somewhere: its arrays hold others, too.

import { type Box3, type Sphere, Vector3 } from 'three';
import type { HalfedgeMesh } from '../mesh.js';

/** Calls `use` with the place of each in `positions`. */
function eachVertex({ positions, connectivity: { vertexHalfedge } }: HalfedgeMesh, use: Use): void {
  for (let v = 0; v < vertexHalfedge.length; v++) {
    if (vertexHalfedge[v] >= -1 && isSomewhere(positions, 3 * v)) use(positions, 3 * v);
  }
}

type Use = (positions: Float32Array, at: number) => void;

function isSomewhere(points: ArrayLike<number>, at: number): boolean {
  return Number.isFinite(points[at] + points[at + 1] + points[at + 2]);
}

/** Makes a box fit. */
export function fitBox(mesh: HalfedgeMesh, { min, max }: Box3): void {
  const low = new Float64Array(3).fill(Number.POSITIVE_INFINITY);
  const high = new Float64Array(3).fill(Number.NEGATIVE_INFINITY);
  eachVertex(mesh, (positions, at) => {
    for (let k = 0; k < 3; k++) {
      const x = positions[at + k];
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
  });
  min.fromArray(low);
  max.fromArray(high);
}

/** Makes a sphere around the middle of that box fit; an empty one around none. */
export function fitSphere(mesh: HalfedgeMesh, box: Box3, sphere: Sphere): void {
  fitBox(mesh, box);
  sphere.makeEmpty();
  if (box.isEmpty()) return;
  const { x, y, z } = box.getCenter(sphere.center);
  let squared = 0;
  eachVertex(mesh, (positions, at) => {
    const [dx, dy, dz] = [positions[at] - x, positions[at + 1] - y, positions[at + 2] - z];
    squared = Math.max(squared, dx * dx + dy * dy + dz * dz);
  });
  sphere.radius = Math.sqrt(squared);
}

/** Makes bounds wide enough for those of some vertices that are alive. */
export function widen(
  bounds: Box3 | Sphere | null,
  { positions, connectivity: { vertexHalfedge } }: HalfedgeMesh,
  vertices: readonly number[],
): void {
  if (bounds === null) return;
  for (const v of vertices) {
    if (!(vertexHalfedge[v] >= -1 && isSomewhere(positions, 3 * v))) continue;
    bounds.expandByPoint(point.fromArray(positions, 3 * v));
  }
}

const point = new Vector3();
