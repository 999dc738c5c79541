import { newArray } from '../arguments.js';
import { HalfedgeMesh } from '../mesh.js';

/** Triangles of faces: for each the three halfedges that end in its corners, and its face. */
export interface FaceTriangles {
  /** Three for each triangle, counter-clockwise. */
  readonly halfedges: Uint32Array;
  /** By triangle, in the order of the faces asked for. */
  readonly faces: Uint32Array;
}

/** Polygons are cut up so many corners at a time, which bounds the memory it takes. */
const BATCH = 2 ** 16;

/**
 * The triangles of the live ones among `faces`, in that order: n - 2 of a face of degree n. Polygons may be
 * concave: they are cut as `mesh.triangulate()` cuts them, each for itself. The mesh is not changed.
 */
export function triangulateFaces(mesh: HalfedgeMesh, faces: Iterable<number>): FaceTriangles {
  const { next, faceHalfedge } = mesh.connectivity;
  const live: number[] = [];
  const degrees: number[] = [];
  let count = 0;
  for (const f of faces) {
    const first = faceHalfedge[f];
    if (!(first >= 0)) continue;
    let degree = 0;
    let h = first;
    do {
      degree += 1;
      h = next[h];
    } while (h !== first);
    if (degree < 3) continue; // a corrupt mesh: nothing to be drawn
    live.push(f);
    degrees.push(degree);
    count += degree - 2;
  }
  const halfedges = newArray('the triangles', Uint32Array, 3 * count);
  const faceOf = newArray('the triangles', Uint32Array, count);
  const cutter = new PolygonCutter(mesh);
  let at = 0;
  live.forEach((f, i) => {
    faceOf.fill(f, at, at + degrees[i] - 2);
    const a = faceHalfedge[f];
    if (degrees[i] === 3) {
      halfedges[3 * at] = a;
      halfedges[3 * at + 1] = next[a];
      halfedges[3 * at + 2] = next[next[a]];
    } else {
      cutter.add(a, degrees[i], 3 * at);
    }
    at += degrees[i] - 2;
  });
  cutter.cut(halfedges);
  return { halfedges, faces: faceOf };
}

/** Collects polygons, and has the core cut them up. */
class PolygonCutter {
  readonly #toVertex: Int32Array;
  readonly #next: Int32Array;
  readonly #positions: Float32Array;
  readonly #polygons: { readonly corners: number[]; readonly at: number }[] = [];

  constructor(mesh: HalfedgeMesh) {
    this.#toVertex = mesh.connectivity.toVertex;
    this.#next = mesh.connectivity.next;
    this.#positions = mesh.positions;
  }

  /** Notes the polygon of a loop, whose triangles belong to `at` of the output. */
  add(first: number, degree: number, at: number): void {
    const corners: number[] = [];
    for (let h = first; corners.length < degree; h = this.#next[h]) corners.push(h);
    this.#polygons.push({ corners, at });
  }

  cut(out: Uint32Array): void {
    // All that is read of the mesh is copied before the core allocates, which can detach its views.
    const points = this.#polygons.map(({ corners }) => this.#pointsOf(corners));
    for (let from = 0; from < this.#polygons.length; ) {
      let to = from;
      let size = 0;
      do size += this.#polygons[to++].corners.length;
      while (to < this.#polygons.length && size + this.#polygons[to].corners.length <= BATCH);
      this.#cutSome(this.#polygons.slice(from, to), points.slice(from, to), out);
      from = to;
    }
  }

  #pointsOf(corners: number[]): Float32Array {
    const points = new Float32Array(3 * corners.length);
    corners.forEach((h, i) => {
      const v = 3 * this.#toVertex[h];
      for (let k = 0; k < 3; k++) {
        const x = this.#positions[v + k];
        points[3 * i + k] = Number.isFinite(x) ? x : 0;
      }
    });
    return points;
  }

  /** As a mesh in which no two polygons touch, so that none is in the way of another's diagonals. */
  #cutSome(
    polygons: readonly { readonly corners: number[]; readonly at: number }[],
    points: readonly Float32Array[],
    out: Uint32Array,
  ): void {
    const ends = polygons.map(({ at }) => at);
    const simple: number[] = [];
    polygons.forEach(({ corners, at }, i) => {
      const diagonal = corners.length === 4 ? quadDiagonal(points[i]) : -1;
      if (diagonal < 0) simple.push(i);
      else {
        const order = diagonal === 0 ? [0, 1, 2, 0, 2, 3] : [0, 1, 3, 1, 2, 3];
        order.forEach((corner, k) => {
          out[at + k] = corners[corner];
        });
      }
    });
    if (simple.length === 0) return;
    const sizes = simple.map((i) => polygons[i].corners.length);
    const total = sizes.reduce((sum, size) => sum + size, 0);
    const positions = new Float32Array(3 * total);
    const polygonOf = new Uint32Array(total);
    const halfedgeOf = new Uint32Array(total);
    let first = 0;
    for (const i of simple) {
      positions.set(points[i], 3 * first);
      polygonOf.fill(i, first, first + polygons[i].corners.length);
      halfedgeOf.set(polygons[i].corners, first);
      first += polygons[i].corners.length;
    }
    const apart = HalfedgeMesh.fromPolygons(positions, {
      sizes,
      corners: polygonOf.map((_, i) => i),
    });
    try {
      apart.triangulate();
      const { indices } = apart.toTriangles();
      for (let i = 0; i < indices.length; i += 3) {
        const polygon = polygonOf[indices[i]];
        for (let k = 0; k < 3; k++) out[ends[polygon]++] = halfedgeOf[indices[i + k]];
      }
    } finally {
      apart.dispose();
    }
  }
}

/** 0 or 1: the corner from which the shorter diagonal of a convex quad goes; -1 of any other. */
function quadDiagonal(p: Float32Array): number {
  const a = normalOf(p, 0, 1, 2);
  const b = normalOf(p, 2, 3, 0);
  const c = normalOf(p, 1, 2, 3);
  const d = normalOf(p, 3, 0, 1);
  if (!(dot(a, b) > 0 && dot(c, d) > 0 && dot(a, c) > 0 && dot(b, d) > 0)) return -1;
  return squaredDistance(p, 0, 6) <= squaredDistance(p, 3, 9) ? 0 : 1;
}

type Vector = readonly [number, number, number];

function normalOf(p: Float32Array, i: number, j: number, k: number): Vector {
  const [a, b, c] = [3 * i, 3 * j, 3 * k];
  const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
  const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

const dot = (u: Vector, v: Vector) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];

const squaredDistance = (p: Float32Array, a: number, b: number) =>
  (p[a] - p[b]) ** 2 + (p[a + 1] - p[b + 1]) ** 2 + (p[a + 2] - p[b + 2]) ** 2;
