import type { HalfedgeMesh } from '../api.js';

/** Where a mesh lies, and how large it is. */
export interface Bounds {
  readonly centre: readonly number[];
  readonly scale: number;
}

/** The middle of the bounding box, and the scale that makes everything fit into the unit sphere. */
export function boundsOf(positions: Float32Array): Bounds {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const x = positions[i + k];
      if (!Number.isFinite(x)) continue;
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
  }
  const centre = low.map((x, k) => (Number.isFinite(x) ? (x + high[k]) / 2 : 0));
  const [cx, cy, cz] = centre;
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i] - cx, positions[i + 1] - cy, positions[i + 2] - cz];
    const r = x * x + y * y + z * z;
    if (r > squared && Number.isFinite(r)) squared = r;
  }
  return { centre, scale: squared > 0 ? 1 / Math.sqrt(squared) : 1 };
}

/** The median over a sample of the edges: enough to tell what is worth drawing. */
export function medianEdge(mesh: HalfedgeMesh, points: Float32Array): number {
  const { toVertex } = mesh.connectivity;
  const lengths: number[] = [];
  const stride = 2 * Math.max(1, Math.floor(toVertex.length / 2 / 1000));
  for (let h = 0; h + 1 < toVertex.length; h += stride) {
    const [a, b] = [3 * toVertex[h], 3 * toVertex[h + 1]];
    if (a < 0 || b < 0) continue;
    lengths.push(
      Math.hypot(
        points[a] - points[b],
        points[a + 1] - points[b + 1],
        points[a + 2] - points[b + 2],
      ),
    );
  }
  lengths.sort((p, q) => p - q);
  return lengths[lengths.length >> 1] ?? 0;
}
