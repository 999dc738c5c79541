import { newArray } from '../arguments.js';
import { type Surface, writeFaceNormal } from '../measures.js';
import type { HalfedgeMesh } from '../mesh.js';

/** The views as they are now: they are good until something allocates. */
export function surfaceOf(mesh: HalfedgeMesh): Surface {
  const { next, toVertex, face, vertexHalfedge, faceHalfedge } = mesh.connectivity;
  return { next, toVertex, face, vertexHalfedge, faceHalfedge, positions: mesh.positions };
}

/** By halfedge slot, the normal of its face: zeros on the boundary. O(halfedges). */
export function cornerNormals(mesh: HalfedgeMesh): Float32Array {
  const surface = surfaceOf(mesh);
  const { next, faceHalfedge } = surface;
  const normals = newArray('the normals', Float32Array, 3 * next.length);
  for (let f = 0; f < faceHalfedge.length; f++) {
    const first = faceHalfedge[f];
    if (first < 0) continue;
    writeFaceNormal(surface, f, normals, 3 * first);
    for (let h = next[first]; h !== first; h = next[h])
      normals.copyWithin(3 * h, 3 * first, 3 * first + 3);
  }
  return normals;
}
