import { CappedMitre } from './mitre.js';

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

/** Faces whose edges are shorter, in CSS pixels, have no room for arrows. */
export const ARROWS_FROM = 28;

/** The sizes of arrows, 6.5 px inset, in units of the mesh, where one CSS pixel is `pixel` long; in `out`. */
export function arrowSizes(
  pixel: number,
  out: { -readonly [Key in keyof ArrowSizes]: number } = { inset: 0, trim: 0, barb: 0 },
): ArrowSizes {
  out.inset = 6.5 * pixel;
  out.trim = 2.5 * pixel;
  out.barb = 8 * pixel;
  return out;
}

/** Computes arrows of whole faces and of boundary halfedges; reuses its scratch memory. */
export class ArrowTracer {
  readonly #mitre = new CappedMitre();

  /**
   * Writes the arrows of a face to `out`: arrow i runs along the edge from corner i to corner
   * i + 1. `corners` holds xyz of `degree` ≥ 3 corners, counter-clockwise. Of a polygon that isn't flat, arrows lie in
   * the triangles that it is drawn as, where `across` tells, by edge, the corner across it. Returns the cap.
   */
  traceFace(
    corners: ArrayLike<number>,
    degree: number,
    sizes: ArrowSizes,
    out: Float32Array,
    offset: number,
    across?: ArrayLike<number>,
  ): number {
    if (degree === 3) this.#mitre.measureTriangle(corners, 0, 3, 6);
    else this.#mitre.measurePolygon(corners, degree, across);
    this.#mitre.place(sizes, out, offset);
    return this.#mitre.cap;
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
    this.#mitre.measureBoundary(path, normal);
    this.#mitre.placeOne(1, sizes, out, offset);
  }
}
