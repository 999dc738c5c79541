import { newArray } from '../arguments.js';
import type { HalfedgeMesh } from '../mesh.js';

/** Views of a mesh that normals are computed from. */
export interface Shape {
  readonly next: Int32Array;
  readonly toVertex: Int32Array;
  readonly face: Int32Array;
  readonly vertexHalfedge: Int32Array;
  readonly faceHalfedge: Int32Array;
  readonly positions: Float32Array;
}

/** The views as they are now: they are good until something allocates. */
export function shapeOf(mesh: HalfedgeMesh): Shape {
  const { next, toVertex, face, vertexHalfedge, faceHalfedge } = mesh.connectivity;
  return { next, toVertex, face, vertexHalfedge, faceHalfedge, positions: mesh.positions };
}

/** Adds the normal of a loop, as long as twice its area (Newell), to `sum`, and its length to `sum[3]`. */
export function addFaceNormal(
  { next, toVertex, positions }: Shape,
  first: number,
  sum: Float64Array,
): void {
  let [x, y, z] = [0, 0, 0];
  // Relative to one corner: far from the origin, nothing is lost to rounding.
  const o = 3 * toVertex[first];
  const [ox, oy, oz] = [positions[o], positions[o + 1], positions[o + 2]];
  let h = first;
  let [ax, ay, az] = [0, 0, 0];
  do {
    h = next[h];
    const b = 3 * toVertex[h];
    const [bx, by, bz] = [positions[b] - ox, positions[b + 1] - oy, positions[b + 2] - oz];
    x += ay * bz - az * by;
    y += az * bx - ax * bz;
    z += ax * by - ay * bx;
    [ax, ay, az] = [bx, by, bz];
  } while (h !== first);
  sum[0] += x;
  sum[1] += y;
  sum[2] += z;
  sum[3] += Math.hypot(x, y, z);
}

const sum = new Float64Array(4);
/** Of the sum of normals that cancel each other to less than this share, rounding alone is left. */
const LEAST = 1e-10;

/** Writes the unit normal of a face to `out`; zeros where it has no area. */
export function writeFaceNormal(shape: Shape, f: number, out: Float32Array, at: number): void {
  sum.fill(0);
  addFaceNormal(shape, shape.faceHalfedge[f], sum);
  writeUnit(out, at);
}

/** Writes the unit normal of a vertex, the mean of those of its faces weighted by area. */
export function writeVertexNormal(shape: Shape, v: number, out: Float32Array, at: number): void {
  sum.fill(0);
  const { vertexHalfedge, next, face } = shape;
  const first = vertexHalfedge[v];
  if (first >= 0) {
    let h = first;
    do {
      if (face[h] >= 0) addFaceNormal(shape, h, sum);
      h = next[h ^ 1];
    } while (h !== first);
  }
  writeUnit(out, at);
}

function writeUnit(out: Float32Array, at: number): void {
  const length = Math.hypot(sum[0], sum[1], sum[2]);
  const isGood = length > LEAST * sum[3] && length < Number.POSITIVE_INFINITY;
  const scale = isGood ? 1 / length : 0;
  for (let k = 0; k < 3; k++) out[at + k] = sum[k] * scale;
}

/** By vertex slot, the normals of all vertices. O(halfedges). */
export function vertexNormals(mesh: HalfedgeMesh): Float32Array {
  const shape = shapeOf(mesh);
  const { next, toVertex, faceHalfedge } = shape;
  const vertices = shape.vertexHalfedge.length;
  const sums = newArray('the normals', Float64Array, 4 * vertices);
  for (let f = 0; f < faceHalfedge.length; f++) {
    const first = faceHalfedge[f];
    if (first < 0) continue;
    sum.fill(0);
    addFaceNormal(shape, first, sum);
    let h = first;
    do {
      const v = 4 * toVertex[h];
      for (let k = 0; k < 4; k++) sums[v + k] += sum[k];
      h = next[h];
    } while (h !== first);
  }
  const normals = newArray('the normals', Float32Array, 3 * vertices);
  for (let v = 0; v < vertices; v++) {
    sum.set(sums.subarray(4 * v, 4 * v + 4));
    writeUnit(normals, 3 * v);
  }
  return normals;
}

/** By halfedge slot, the normal of its face: zeros on the boundary. O(halfedges). */
export function cornerNormals(mesh: HalfedgeMesh): Float32Array {
  const shape = shapeOf(mesh);
  const { next, faceHalfedge } = shape;
  const normals = new Float32Array(3 * next.length);
  for (let f = 0; f < faceHalfedge.length; f++) {
    const first = faceHalfedge[f];
    if (first < 0) continue;
    writeFaceNormal(shape, f, normals, 3 * first);
    for (let h = next[first]; h !== first; h = next[h])
      normals.copyWithin(3 * h, 3 * first, 3 * first + 3);
  }
  return normals;
}
