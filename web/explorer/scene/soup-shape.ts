import type { FileSoup, Problem } from 'halfedge';
import { type Sight, triangulateRing } from 'halfedge/scene';
import { newellNormal } from 'halfedge/three';
import { type Matrix4, Vector3 } from 'three';
import { cornersFrom, hasPosition } from '../app/diagnosis.js';

/** A problem with more faces than this is not outlined whole. */
const MOST_FACES = 500;

/** What a soup is drawn as. */
export interface DrawnSoup {
  /** Three vertices of each triangle, and two of each edge. */
  readonly triangles: Uint32Array;
  readonly edges: Uint32Array;
  /** By triangle: the face of the file. */
  readonly faceOf: Uint32Array;
}

/** Where a problem is: what is lit of it, and how to look at it. */
export interface Place extends Sight {
  /** Corners of each face in the witness. */
  readonly rings: readonly (readonly number[])[];
  readonly vertices: readonly number[];
}

/** The polygons of a file, placed in the scene beside the mesh that was made of them. */
export class SoupShape {
  /** xyz by vertex; the origin for those without a finite position. */
  readonly points: Float32Array;
  readonly typicalEdge: number;
  readonly #soup: FileSoup;
  /** See `cornersFrom`. */
  readonly #first: Uint32Array;

  constructor(soup: FileSoup, placement: Matrix4) {
    this.#soup = soup;
    this.points = soup.positions.slice();
    const point = new Vector3();
    for (let i = 0; i < this.points.length; i += 3) {
      point.fromArray(soup.positions, i).applyMatrix4(placement);
      if (!Number.isFinite(point.x + point.y + point.z)) point.set(0, 0, 0);
      point.toArray(this.points, i);
    }
    this.#first = cornersFrom(soup);
    this.typicalEdge = this.#typicalEdge();
  }

  /** Whether there is such a vertex, at a finite position. */
  isPlaced(vertex: number): boolean {
    return hasPosition(this.#soup, vertex);
  }

  /** The corners of a face that can be drawn, without those that repeat the one before. */
  ring(face: number): number[] {
    const { corners } = this.#soup.faces;
    const all = corners.subarray(this.#first[face], this.#first[face + 1]);
    const ring = [...all].filter((v) => this.isPlaced(v));
    const distinct = ring.filter((v, i) => v !== ring[(i || ring.length) - 1]);
    return distinct.length > 0 ? distinct : ring.slice(0, 1);
  }

  /** All that can be drawn of it. */
  drawn(): DrawnSoup {
    const triangles: number[] = [];
    const faceOf: number[] = [];
    const edges: number[] = [];
    for (let f = 0; f + 1 < this.#first.length; f++) {
      const ring = this.ring(f);
      for (let i = 0; i < ring.length; i++) edges.push(ring[i], ring[(i + 1) % ring.length]);
      if (ring.length < 3) continue;
      const pieces = triangulateRing(ring, this.points);
      for (const v of pieces) triangles.push(v);
      for (let i = 0; i < pieces.length; i += 3) faceOf.push(f);
    }
    return {
      triangles: new Uint32Array(triangles),
      edges: new Uint32Array(edges),
      faceOf: new Uint32Array(faceOf),
    };
  }

  /** Where a problem is; null if nothing that it names has a place. */
  place({ witness }: Problem): Place | null {
    const vertices = (witness?.vertices ?? []).filter((v) => this.isPlaced(v));
    const faces = (witness?.faces ?? []).slice(0, MOST_FACES);
    const rings = faces.map((f) => this.ring(f)).filter(({ length }) => length > 0);
    const all = [...rings.flat(), ...vertices].map((v) => this.#point(v));
    if (all.length === 0) return null;
    // An edge or a vertex is what the sentence is about; otherwise the faces are.
    const middle = vertices.length > 0 ? vertices.map((v) => this.#point(v)) : all;
    const centre = middle.reduce((sum, p) => sum.add(p), new Vector3());
    centre.divideScalar(middle.length);
    const far = all.reduce((most, p) => Math.max(most, p.distanceTo(centre)), 0);
    const radius = Math.min(1, Math.max(far, this.typicalEdge));
    return { rings, vertices, centre, radius, normal: this.#normal(rings, centre) };
  }

  /** The faces' mean normal; away from the middle of the mesh, as faces may be the wrong way round. */
  #normal(rings: readonly (readonly number[])[], centre: Vector3): Vector3 {
    const sum = new Vector3();
    for (const ring of rings) {
      if (ring.length < 3) continue;
      const corners = ring.flatMap((v) => [...this.points.subarray(3 * v, 3 * v + 3)]);
      const normal = new Vector3().fromArray(
        newellNormal(corners, ring.length, new Float64Array(3)),
      );
      sum.addScaledVector(normal, normal.dot(sum) < 0 ? -1 : 1);
    }
    return sum.dot(centre) < 0 ? sum.negate() : sum;
  }

  #point(vertex: number): Vector3 {
    return new Vector3().fromArray(this.points, 3 * vertex);
  }

  /** The median over a sample of faces. */
  #typicalEdge(): number {
    const lengths: number[] = [];
    const faces = this.#first.length - 1;
    for (let f = 0; f < faces; f += Math.max(1, Math.floor(faces / 500))) {
      const [a, b] = this.ring(f);
      if (a !== undefined && b !== undefined) {
        lengths.push(this.#point(a).distanceTo(this.#point(b)));
      }
    }
    lengths.sort((p, q) => p - q);
    return lengths[lengths.length >> 1] ?? 0.1;
  }
}
