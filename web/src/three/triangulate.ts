import { withInputs } from '../memory.js';
import type { HalfedgeMesh } from '../mesh.js';
import { linksOf } from '../navigation.js';
import { unwrap } from '../reports.js';
import { take } from '../rings.js';

/** Triangles of faces: for each the three halfedges that end in its corners, and its face. */
export interface FaceTriangles {
  /** Three for each triangle, counter-clockwise. */
  readonly halfedges: Uint32Array;
  /** By triangle, in the order of the faces asked for. */
  readonly faces: Uint32Array;
}

/** What corners of triangles are named by, in C++. */
const AS_HALFEDGES = 1;

/**
 * The triangles of the live ones among `faces`, in that order, or of all faces: those of `mesh.toTriangles()`. The
 * core allocates, which can detach views.
 */
export function triangulateFaces(mesh: HalfedgeMesh, faces?: ArrayLike<number>): FaceTriangles {
  const { core, address } = linksOf(mesh);
  const raw =
    faces === undefined
      ? core.toTriangles(address, AS_HALFEDGES, 0, 0)
      : withInputs(core, (inputs) => {
          const list = inputs.indices('the faces', Uint32Array.from(faces));
          return core.toTriangles(address, AS_HALFEDGES, list.address, list.count);
        });
  const triangles = unwrap(raw);
  const [halfedges, faceOf] = take(core, triangles.corners, triangles.faces);
  return { halfedges, faces: faceOf };
}

/** Three vertices for each of the two triangles of a convex quad, cut in the same way; none of any other face. */
export function quadVertices(mesh: HalfedgeMesh, face: number): number[] {
  const { next, faceHalfedge, toVertex } = mesh.connectivity;
  const first = faceHalfedge[face];
  const corners = [toVertex[first]];
  for (let h = next[first]; h !== first && corners.length <= 4; h = next[h]) {
    corners.push(toVertex[h]);
  }
  if (corners.length !== 4) return [];
  const [a, b, c, d] = corners;
  const diagonal = quadDiagonal(mesh.positions, a, b, c, d);
  if (diagonal === NO_DIAGONAL) return [];
  return diagonal === 0 ? [a, b, c, a, c, d] : [a, b, d, b, c, d];
}

const NO_DIAGONAL = -1;

/**
 * 0 or 1: the corner from which the shorter diagonal of a convex quad goes; none of any other. As in C++, it is seen
 * without the coordinate in which its normal is largest.
 */
function quadDiagonal(p: Float32Array, a: number, b: number, c: number, d: number): number {
  /** The area of a triangle, twice, seen along an axis. */
  const area = (axis: number, i: number, j: number, k: number): number => {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    return (
      (p[3 * j + u] - p[3 * i + u]) * (p[3 * k + v] - p[3 * i + v]) -
      (p[3 * j + v] - p[3 * i + v]) * (p[3 * k + u] - p[3 * i + u])
    );
  };
  const whole = (axis: number) => area(axis, a, b, c) + area(axis, a, c, d);
  let axis = 2;
  for (const i of [0, 1]) if (Math.abs(whole(i)) > Math.abs(whole(axis))) axis = i;
  const sign = Math.sign(whole(axis));
  const isConvex =
    sign * area(axis, a, b, c) > 0 &&
    sign * area(axis, b, c, d) > 0 &&
    sign * area(axis, c, d, a) > 0 &&
    sign * area(axis, d, a, b) > 0;
  if (!isConvex) return NO_DIAGONAL;
  return distance(p, a, c) < distance(p, b, d) ? 0 : 1;
}

function distance(p: Float32Array, a: number, b: number): number {
  const [x, y, z] = [p[3 * a] - p[3 * b], p[3 * a + 1] - p[3 * b + 1], p[3 * a + 2] - p[3 * b + 2]];
  return Math.sqrt(x * x + y * y + z * z);
}
