// Bounds of the vertices of a mesh that are alive and somewhere: its arrays hold others, too.

import { type Box3, type Sphere, Vector3 } from 'three';
import type { HalfedgeMesh } from '../mesh.js';

/** Makes a box fit; an empty one around none. */
export function fitBox(mesh: HalfedgeMesh, box: Box3): void {
  const found = mesh.boundingBox();
  box.makeEmpty();
  if (found === null) return;
  box.min.fromArray(found.min);
  box.max.fromArray(found.max);
}

/** Makes a sphere around the middle of that box fit; an empty one around none. */
export function fitSphere(mesh: HalfedgeMesh, box: Box3, sphere: Sphere): void {
  fitBox(mesh, box);
  sphere.makeEmpty();
  if (box.isEmpty()) return;
  const { x, y, z } = box.getCenter(sphere.center);
  const { positions, connectivity } = mesh;
  const { vertexHalfedge } = connectivity;
  let squared = 0;
  for (let v = 0; v < vertexHalfedge.length; v++) {
    if (!isSomewhere(vertexHalfedge, positions, v)) continue;
    const at = 3 * v;
    const [dx, dy, dz] = [positions[at] - x, positions[at + 1] - y, positions[at + 2] - z];
    squared = Math.max(squared, dx * dx + dy * dy + dz * dz);
  }
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
    if (!isSomewhere(vertexHalfedge, positions, v)) continue;
    bounds.expandByPoint(point.fromArray(positions, 3 * v));
  }
}

const point = new Vector3();

/** Whether a vertex is alive, and has a place. */
function isSomewhere(vertexHalfedge: Int32Array, positions: Float32Array, v: number): boolean {
  const at = 3 * v;
  if (!(vertexHalfedge[v] >= -1)) return false;
  return Number.isFinite(positions[at] + positions[at + 1] + positions[at + 2]);
}
