import { newArray } from '../arguments.js';
import type { HalfedgeMesh } from '../mesh.js';
import { PolygonCutter } from './polygon-cutter.js';

/** Triangles of faces: for each the three halfedges that end in its corners, and its face. */
export interface FaceTriangles {
  /** Three for each triangle, counter-clockwise. */
  readonly halfedges: Uint32Array;
  /** By triangle, in the order of the faces asked for. */
  readonly faces: Uint32Array;
}

/** The faces that are there, in ascending order. */
export function liveFaces(mesh: HalfedgeMesh): Uint32Array {
  const { faceHalfedge } = mesh.connectivity;
  const faces = newArray('the faces', Uint32Array, mesh.faceCount);
  let count = 0;
  for (let f = 0; f < faceHalfedge.length; f++) if (faceHalfedge[f] >= 0) faces[count++] = f;
  return faces.subarray(0, count);
}

/**
 * The triangles of the live ones among `faces`, in that order: n - 2 of a face of degree n. Polygons may be
 * concave: they are cut as `mesh.triangulate()` cuts them, each for itself. The mesh is not changed.
 */
export function triangulateFaces(mesh: HalfedgeMesh, faces: ArrayLike<number>): FaceTriangles {
  const { next, faceHalfedge, toVertex } = mesh.connectivity;
  const { positions } = mesh;
  let count = 0;
  for (let i = 0; i < faces.length; i++) count += trianglesIn(next, faceHalfedge[faces[i]]);
  const halfedges = newArray('the triangles', Uint32Array, 3 * count);
  const faceOf = newArray('the triangles', Uint32Array, count);
  const cutter = new PolygonCutter(mesh);
  let at = 0;
  for (let i = 0; i < faces.length; i++) {
    const a = faceHalfedge[faces[i]];
    const triangles = trianglesIn(next, a);
    if (triangles === 0) continue;
    const b = next[a];
    const c = next[b];
    const diagonal =
      triangles === 2
        ? quadDiagonal(positions, toVertex[a], toVertex[b], toVertex[c], toVertex[next[c]])
        : NO_DIAGONAL;
    if (triangles === 1 || diagonal === 0) writeTriangle(halfedges, at, a, b, c);
    else if (diagonal === 1) writeTriangle(halfedges, at, a, b, next[c]);
    else cutter.add(a, triangles + 2, 3 * at);
    if (diagonal === 0) writeTriangle(halfedges, at + 1, a, c, next[c]);
    if (diagonal === 1) writeTriangle(halfedges, at + 1, b, c, next[c]);
    for (const end = at + triangles; at < end; at++) faceOf[at] = faces[i];
  }
  cutter.cut(halfedges);
  return { halfedges, faces: faceOf };
}

/** Three vertices for each of the two triangles of a convex quad, cut in the same way; none of any other face. */
export function quadVertices(mesh: HalfedgeMesh, face: number): number[] {
  const { next, faceHalfedge, toVertex } = mesh.connectivity;
  if (trianglesIn(next, faceHalfedge[face]) !== 2) return [];
  const corners: number[] = [];
  for (let h = faceHalfedge[face]; corners.length < 4; h = next[h]) corners.push(toVertex[h]);
  const [a, b, c, d] = corners;
  const diagonal = quadDiagonal(mesh.positions, a, b, c, d);
  if (diagonal === NO_DIAGONAL) return [];
  return diagonal === 0 ? [a, b, c, a, c, d] : [a, b, d, b, c, d];
}

/** How many triangles a face becomes, by one of its halfedges; 0 for one that can't be drawn. */
function trianglesIn(next: Int32Array, first: number): number {
  if (!(first >= 0)) return 0;
  let degree = 1;
  for (let h = next[first]; h !== first; h = next[h]) degree += 1;
  return Math.max(0, degree - 2);
}

function writeTriangle(out: Uint32Array, at: number, a: number, b: number, c: number): void {
  out[3 * at] = a;
  out[3 * at + 1] = b;
  out[3 * at + 2] = c;
}

const NO_DIAGONAL = -1;
/** The normals of the corners of a quad, counter-clockwise. */
const normals = new Float64Array(12);

/** 0 or 1: the corner from which the shorter diagonal of a convex quad goes; none of any other. */
function quadDiagonal(p: Float32Array, a: number, b: number, c: number, d: number): number {
  writeNormal(p, d, a, b, 0);
  writeNormal(p, a, b, c, 3);
  writeNormal(p, b, c, d, 6);
  writeNormal(p, c, d, a, 9);
  // The triangles on both sides of a diagonal face the same way, whichever it is.
  const isConvex = dot(3, 9) > 0 && dot(6, 0) > 0 && dot(3, 6) > 0 && dot(9, 0) > 0;
  if (!isConvex) return NO_DIAGONAL;
  return squaredDistance(p, a, c) <= squaredDistance(p, b, d) ? 0 : 1;
}

/** Writes the normal at corner `j` between its neighbours, as long as the parallelogram is large. */
function writeNormal(p: Float32Array, i: number, j: number, k: number, at: number): void {
  const [ux, uy, uz] = [
    p[3 * j] - p[3 * i],
    p[3 * j + 1] - p[3 * i + 1],
    p[3 * j + 2] - p[3 * i + 2],
  ];
  const [vx, vy, vz] = [
    p[3 * k] - p[3 * i],
    p[3 * k + 1] - p[3 * i + 1],
    p[3 * k + 2] - p[3 * i + 2],
  ];
  normals[at] = uy * vz - uz * vy;
  normals[at + 1] = uz * vx - ux * vz;
  normals[at + 2] = ux * vy - uy * vx;
}

function dot(i: number, j: number): number {
  return (
    normals[i] * normals[j] + normals[i + 1] * normals[j + 1] + normals[i + 2] * normals[j + 2]
  );
}

function squaredDistance(p: Float32Array, a: number, b: number): number {
  const [x, y, z] = [p[3 * a] - p[3 * b], p[3 * a + 1] - p[3 * b + 1], p[3 * a + 2] - p[3 * b + 2]];
  return x * x + y * y + z * z;
}
