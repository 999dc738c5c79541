import { newellNormal, squaredDistanceToSegment } from './polygon.js';

/**
 * Where the half-arrow of a halfedge is drawn: a shaft inside the face, parallel to the edge, and
 * one barb on the face side.
 *
 *        p_{i+1} <───────────────────────── p_i         edge
 *            \    end ◂──────────── start    /          shaft, at height d inside the face
 *             \      ╲ barb                 /           the mitre: shafts end on the bisectors
 *
 * All arrows of a face keep the distance d of a *capped mitre*: with c = cot(θ/2) of the corner
 * angles, an edge of length L has a shaft of length L − (c_i + c_{i+1}) d, which vanishes at
 * d = L / (c_i + c_{i+1}). `cap` is the least of these (the inradius of a triangle), and d stays
 * below a fixed share of it, so that no shaft vanishes. Each arrow lies between its edge and the
 * bisectors at the ends of it, and these cells do not overlap: that is why arrows never cross,
 * however thin the face. At a reflex corner the shaft would reach out beyond its edge; it is
 * cut there, and half the distance from that corner to any other edge bounds the cap too.
 */
export interface ArrowSizes {
  /** Wanted distance between edge and shaft. */
  readonly inset: number;
  /** Wanted gap between the bisector and each end of the shaft. */
  readonly trim: number;
  /** Wanted length of the barb along the shaft. */
  readonly barb: number;
}

/** xyz of the start, the end and the tip of the barb. */
export const ARROW_FLOATS = 9;

/** The inset is at most this share of the largest one that leaves all arrows some length. */
export const CAP_SHARE = 0.35;

/** Faces whose edges are shorter, in CSS pixels, have no room for arrows. */
export const ARROWS_FROM = 28;

const TRIM_SHARE = 0.12;
const BARB_SHARE = 0.4;
const BARB_SLOPE = 0.55;

/** The sizes of spec: 6.5 px inset, in units of the mesh, where one CSS pixel is `pixel` long. */
export function arrowSizes(pixel: number): ArrowSizes {
  return { inset: 6.5 * pixel, trim: 2.5 * pixel, barb: 8 * pixel };
}

/** Computes arrows of whole faces and of boundary halfedges; reuses its scratch memory. */
export class ArrowTracer {
  #cots = new Float64Array(16);
  #lengths = new Float64Array(16);
  #tangents = new Float64Array(48);
  readonly #normal = new Float64Array(3);
  readonly #strip = new Float64Array(12);

  /**
   * Writes the arrows of a face to `out`: arrow i runs along the edge from corner i to corner
   * i + 1. `corners` holds xyz of `degree` ≥ 3 corners, counter-clockwise. Returns the cap.
   */
  traceFace(
    corners: ArrayLike<number>,
    degree: number,
    sizes: ArrowSizes,
    out: Float32Array,
    offset: number,
  ): number {
    this.#measure(corners, degree, newellNormal(corners, degree, this.#normal));
    const cap = this.#faceCap(corners, degree);
    for (let i = 0; i < degree; i++) {
      const to = (i + 1) % degree;
      this.#write(corners, i, this.#cots[i], this.#cots[to], cap, sizes, out, offset);
      offset += ARROW_FLOATS;
    }
    return cap;
  }

  /**
   * Writes the arrow of the boundary halfedge from `b` to `c`, drawn outside the surface, in the
   * plane of the face on the other side, whose unit normal is `normal`. `path` holds xyz of four
   * points a, b, c, d: along the boundary loop, a comes before b and d after c.
   */
  traceBoundary(
    path: ArrayLike<number>,
    normal: ArrayLike<number>,
    sizes: ArrowSizes,
    out: Float32Array,
    offset: number,
  ): void {
    const strip = this.#strip;
    strip.set(path as ArrayLike<number>, 0);
    this.#normal[0] = normal[0];
    this.#normal[1] = normal[1];
    this.#normal[2] = normal[2];
    this.#measure(strip, 4, this.#normal);
    const span = Math.max(0, this.#cots[1]) + Math.max(0, this.#cots[2]);
    const cap = this.#lengths[1] / Math.max(1, span);
    this.#write(strip, 1, this.#cots[1], this.#cots[2], cap, sizes, out, offset);
  }

  /** Lengths and directions of the edges, and cot(θ/2) of the angles on their left. */
  #measure(corners: ArrayLike<number>, degree: number, normal: Float64Array): void {
    if (this.#cots.length < degree) {
      this.#cots = new Float64Array(2 * degree);
      this.#lengths = new Float64Array(2 * degree);
      this.#tangents = new Float64Array(6 * degree);
    }
    const t = this.#tangents;
    for (let i = 0; i < degree; i++) {
      const a = 3 * i;
      const b = 3 * ((i + 1) % degree);
      const x = corners[b] - corners[a];
      const y = corners[b + 1] - corners[a + 1];
      const z = corners[b + 2] - corners[a + 2];
      const length = Math.sqrt(x * x + y * y + z * z); // many times faster than Math.hypot
      const scale = length > 0 ? 1 / length : 0;
      this.#lengths[i] = length;
      t[a] = x * scale;
      t[a + 1] = y * scale;
      t[a + 2] = z * scale;
    }
    for (let i = 0; i < degree; i++) {
      const u = 3 * i;
      const w = 3 * ((i + degree - 1) % degree);
      const cos = -(t[u] * t[w] + t[u + 1] * t[w + 1] + t[u + 2] * t[w + 2]);
      const sin =
        normal[0] * (t[w + 1] * t[u + 2] - t[w + 2] * t[u + 1]) +
        normal[1] * (t[w + 2] * t[u] - t[w] * t[u + 2]) +
        normal[2] * (t[w] * t[u + 1] - t[w + 1] * t[u]);
      this.#cots[i] = halfAngleCot(cos, sin);
    }
  }

  #faceCap(corners: ArrayLike<number>, degree: number): number {
    let cap = Number.POSITIVE_INFINITY;
    for (let i = 0; i < degree; i++) {
      const span = Math.max(0, this.#cots[i]) + Math.max(0, this.#cots[(i + 1) % degree]);
      if (span > 0) cap = Math.min(cap, this.#lengths[i] / span);
      if (degree === 3 || this.#cots[i] >= 0) continue;
      for (let j = 0; j < degree; j++) {
        const end = (j + 1) % degree;
        if (j === i || end === i) continue;
        cap = Math.min(
          cap,
          Math.sqrt(squaredDistanceToSegment(corners, 3 * i, 3 * j, 3 * end)) / 2,
        );
      }
    }
    return cap;
  }

  #write(
    corners: ArrayLike<number>,
    edge: number,
    startCot: number,
    endCot: number,
    cap: number,
    sizes: ArrowSizes,
    out: Float32Array,
    offset: number,
  ): void {
    const length = this.#lengths[edge];
    const d = Math.min(sizes.inset, CAP_SHARE * cap);
    const trim = Math.min(sizes.trim, TRIM_SHARE * length);
    const start = Math.max(0, startCot) * d + trim;
    const end = length - Math.max(0, endCot) * d - trim;
    // The tip of the barb must stay between the same bisectors as the shaft.
    const barb = Math.min(sizes.barb, BARB_SHARE * (end - start));
    const width = Math.max(
      0,
      Math.min(
        BARB_SLOPE * barb,
        (cap - d) * 0.6,
        endCot > 0 ? (barb + trim) / endCot : Number.POSITIVE_INFINITY,
        startCot > 0 ? (end - barb - start + trim) / startCot : Number.POSITIVE_INFINITY,
      ),
    );
    const a = 3 * edge;
    const t = this.#tangents;
    const n = this.#normal;
    for (let k = 0; k < 3; k++) {
      const along = t[a + k];
      const u = (k + 1) % 3;
      const w = (k + 2) % 3;
      // Inwards: to the left of the edge, in the plane of the face.
      const inward = n[u] * t[a + w] - n[w] * t[a + u];
      const foot = corners[a + k] + d * inward;
      out[offset + k] = foot + start * along;
      out[offset + 3 + k] = foot + end * along;
      out[offset + 6 + k] = foot + (end - barb) * along + width * inward;
    }
  }
}

/** cot(θ/2) for θ in (0, 2π): positive below π, negative at reflex corners. */
function halfAngleCot(cos: number, sin: number): number {
  const flat = 1e-9;
  if (Math.abs(sin) > flat) return (1 + cos) / sin;
  return cos > 0 ? 1 / flat : 0;
}
