import { noOrbit } from '../measures.js';
import type { HalfedgeMesh } from '../mesh.js';
import { cornersAcross } from './across.js';
import { type ArrowSizes, ArrowTracer } from './arrows.js';
import { ARROW_FLOATS } from './mitre.js';
import { newellNormal } from './polygon.js';

/** A mesh, and where its vertices are drawn: its positions, or others. */
export interface DrawnMesh {
  readonly mesh: HalfedgeMesh;
  /** xyz by vertex. */
  readonly points: ArrayLike<number>;
  /** Three vertices for each triangle that a face is drawn as. Left out, its arrows lie in one plane. */
  triangleVertices?(face: number): ArrayLike<number>;
}

/** Traces the half-arrows of the halfedges of a mesh, a face or a boundary halfedge at a time. */
export class HalfedgeGlyphs {
  /** xyz of start, end and tip of the barb of each arrow, after `face`, `boundary` or `halfedge`. */
  arrows: Float32Array = new Float32Array(16 * ARROW_FLOATS);
  readonly #drawn: DrawnMesh;
  readonly #tracer = new ArrowTracer();
  readonly #corners: number[] = [];
  readonly #vertices: number[] = [];
  readonly #path = new Float64Array(12);
  readonly #normal = new Float64Array(3);
  /** How many corners the face has whose corners were read last. */
  #degree = 0;
  /** Which arrow of its face was traced last. */
  #place = 0;

  constructor(drawn: DrawnMesh) {
    this.#drawn = drawn;
  }

  /**
   * The arrows of a face, the first for the halfedge after `faceHalfedge`. Returns its degree.
   *
   * @throws HalfedgeError `corrupt-connectivity` where its halfedges form no loop
   */
  face(face: number, sizes: ArrowSizes): number {
    const degree = this.#readCorners(face);
    if (this.arrows.length < degree * ARROW_FLOATS) {
      this.arrows = new Float32Array(2 * degree * ARROW_FLOATS);
    }
    const triangles = degree > 3 ? this.#drawn.triangleVertices?.(face) : undefined;
    const across = triangles && cornersAcross(this.#vertices, degree, triangles);
    this.#tracer.traceFace(this.#corners, degree, sizes, this.arrows, 0, across);
    return degree;
  }

  /**
   * The arrow of a boundary halfedge, outside of the face across its edge and in the plane of it. `before` is the
   * halfedge that was traced just before, on a surface that has stayed as it was: what both have in common is measured
   * once. Left out, there is none.
   */
  boundary(h: number, sizes: ArrowSizes, before = -1): void {
    const { mesh, points } = this.#drawn;
    const { toVertex, next, face } = mesh.connectivity;
    const read = (i: number, v: number) => {
      for (let k = 0; k < 3; k++) this.#path[3 * i + k] = points[3 * v + k];
    };
    read(0, toVertex[mesh.prev(h) ^ 1]);
    read(1, toVertex[h ^ 1]);
    read(2, toVertex[h]);
    read(3, toVertex[next[h]]);
    if (!(before >= 0 && face[before] < 0 && face[before ^ 1] === face[h ^ 1])) {
      const degree = this.#readCorners(face[h ^ 1]);
      newellNormal(this.#corners, degree, this.#normal);
    }
    this.#tracer.traceBoundary(this.#path, this.#normal, sizes, this.arrows, 0);
  }

  /** The arrow of any halfedge; returns its offset in `arrows`. `before` is as for `boundary`, with the same sizes. */
  halfedge(h: number, sizes: ArrowSizes, before = -1): number {
    const { face, next, faceHalfedge } = this.#drawn.mesh.connectivity;
    if (face[h] < 0) {
      this.boundary(h, sizes, before);
      return 0;
    }
    // Corner i is the to-vertex of the i-th halfedge, so arrow i belongs to the one after it.
    const first = next[faceHalfedge[face[h]]];
    if (!(before >= 0 && face[before] === face[h])) this.face(face[h], sizes);
    else if (h !== first && next[before] === h) return ++this.#place * ARROW_FLOATS;
    else if (before !== first && next[h] === before) return --this.#place * ARROW_FLOATS;
    this.#place = 0;
    for (let at = first; at !== h; at = next[at]) {
      this.#place += 1;
      if (this.#place === this.#degree) throw noOrbit(); // it is not in the loop of its face
    }
    return this.#place * ARROW_FLOATS;
  }

  /** Writes the corners of a face, and xyz of them; returns its degree. */
  #readCorners(face: number): number {
    const { mesh, points } = this.#drawn;
    const { next, toVertex, faceHalfedge } = mesh.connectivity;
    const first = faceHalfedge[face];
    let degree = 0;
    let h = first;
    // Links that were written over may lead into a loop without `first`: it would be passed again and again.
    let passed = first;
    let lookAgainAt = 4;
    do {
      this.#vertices[degree] = toVertex[h];
      for (let k = 0; k < 3; k++) this.#corners[3 * degree + k] = points[3 * toVertex[h] + k];
      degree += 1;
      h = next[h];
      if (h === passed && h !== first) throw noOrbit();
      if (degree === lookAgainAt) {
        passed = h;
        lookAgainAt *= 2;
      }
    } while (h !== first);
    this.#degree = degree;
    return degree;
  }
}
