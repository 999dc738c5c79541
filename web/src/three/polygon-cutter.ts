import { HalfedgeMesh } from '../mesh.js';

/** Polygons are cut up so many corners at a time, which bounds the memory it takes. */
const BATCH = 2 ** 16;

/** A polygon, and where its triangles belong. */
interface Polygon {
  readonly halfedges: readonly number[];
  readonly at: number;
  /** xyz of each corner. */
  readonly points: Float32Array;
}

/**
 * Collects polygons, and has the core cut them up. What it needs of the mesh is copied: the core allocates, which
 * can detach views.
 */
export class PolygonCutter {
  readonly #toVertex: Int32Array;
  readonly #next: Int32Array;
  readonly #positions: Float32Array;
  readonly #polygons: Polygon[] = [];

  constructor(mesh: HalfedgeMesh) {
    this.#toVertex = mesh.connectivity.toVertex;
    this.#next = mesh.connectivity.next;
    this.#positions = mesh.positions;
  }

  /** Notes the polygon of a loop, whose triangles belong to `at` of the output. */
  add(first: number, degree: number, at: number): void {
    const halfedges: number[] = [];
    const points = new Float32Array(3 * degree);
    for (let h = first; halfedges.length < degree; h = this.#next[h]) {
      const to = 3 * halfedges.length;
      for (let k = 0; k < 3; k++) {
        const x = this.#positions[3 * this.#toVertex[h] + k];
        points[to + k] = Number.isFinite(x) ? x : 0;
      }
      halfedges.push(h);
    }
    this.#polygons.push({ halfedges, at, points });
  }

  /** Writes the halfedges that end in the corners of the triangles. */
  cut(out: Uint32Array): void {
    for (let from = 0; from < this.#polygons.length; ) {
      let to = from;
      let size = 0;
      do size += this.#polygons[to++].halfedges.length;
      while (to < this.#polygons.length && size + this.#polygons[to].halfedges.length <= BATCH);
      cutSome(this.#polygons.slice(from, to), size, out);
      from = to;
    }
  }
}

/** As a mesh in which no two polygons touch, so that none is in the way of another's diagonals. */
function cutSome(polygons: readonly Polygon[], size: number, out: Uint32Array): void {
  const positions = new Float32Array(3 * size);
  const polygonOf = new Uint32Array(size);
  const halfedgeOf = new Uint32Array(size);
  let first = 0;
  polygons.forEach(({ halfedges, points }, i) => {
    positions.set(points, 3 * first);
    polygonOf.fill(i, first, first + halfedges.length);
    halfedgeOf.set(halfedges, first);
    first += halfedges.length;
  });
  const apart = HalfedgeMesh.fromPolygons(positions, {
    sizes: polygons.map(({ halfedges }) => halfedges.length),
    corners: Uint32Array.from({ length: size }, (_, i) => i),
  });
  try {
    apart.triangulate();
    const { indices } = apart.toTriangles();
    const ends = polygons.map(({ at }) => at);
    for (let i = 0; i < indices.length; i += 3) {
      const polygon = polygonOf[indices[i]];
      for (let k = 0; k < 3; k++) out[ends[polygon]++] = halfedgeOf[indices[i + k]];
    }
  } finally {
    apart.dispose();
  }
}
