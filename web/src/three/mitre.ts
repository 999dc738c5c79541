import type { ArrowSizes } from './arrows.js';
import { newellNormal, squaredDistanceToSegment } from './polygon.js';

// Where what is measured of a polygon stands in a row of numbers: of the polygon itself,
const DEGREE = 0;
const CAP = 1;
const NORMAL = 2;
const HEAD = 5;
// and of each of its corners, from the first one on.
const PLACE = 0;
const ALONG = 3;
const LENGTH = 6;
const COT = 7;
const INWARD = 8;
const CORNER = 11;

/** xyz of the start, the end and the tip of the barb. */
export const ARROW_FLOATS = 9;

/** The inset is at most this share of the largest one that leaves all arrows some length. */
export const CAP_SHARE = 0.35;

const TRIM_SHARE = 0.12;
const BARB_SHARE = 0.4;
const BARB_SLOPE = 0.55;
/** Sine of the angle between the plane of a polygon and what is drawn of it, below which it is flat. */
const FLAT = 1e-3;

/**
 * The capped mitre (see `arrows.ts`) of one polygon after another: `measure…` first, then `place…` its arrows, in any
 * sizes. In between, a row of numbers has the cap and the unit normal of the polygon and, of each corner, its place, the
 * direction and the length of the edge that leaves it, cot(θ/2) of the angle θ, 0 where that is reflex, and where the
 * inside of the polygon is beside that edge. All of it is written to typed arrays that are used again: thousands of
 * faces take their turns in less than a millisecond.
 */
export class CappedMitre {
  #row = new Float64Array(HEAD + 16 * CORNER);

  /** How many corners were measured. */
  get degree(): number {
    return this.#row[DEGREE];
  }

  /** The largest inset that leaves all arrows some length. */
  get cap(): number {
    return this.#row[CAP];
  }

  /** Measures a triangle, counter-clockwise, whose corners have xyz at `a`, `b` and `c` of `points`. */
  measureTriangle(points: ArrayLike<number>, a: number, b: number, c: number): void {
    measureTriangle(points, a, b, c, this.#row);
  }

  /**
   * Measures a simple polygon. `corners` holds xyz of `degree` ≥ 3 corners, counter-clockwise. Where it isn't flat, its
   * arrows lie in the triangles that it is drawn as: `across` has, by edge, the corner across it (see `cornersAcross`).
   */
  measurePolygon(
    corners: ArrayLike<number>,
    degree: number,
    across: ArrayLike<number> = NOTHING,
  ): void {
    newellNormal(corners, degree, normal);
    this.#measureCorners(corners, degree, normal);
    const row = this.#row;
    row[CAP] = capOf(corners, degree, row);
    cutReflex(row, degree);
    for (let i = 0; i < across.length; i++)
      if (across[i] >= 0) lean(row, i, corners, 3 * across[i]);
  }

  /** Measures four points, of which the second edge has an arrow, in the plane of this normal. */
  measureBoundary(path: ArrayLike<number>, planeNormal: ArrayLike<number>): void {
    this.#measureCorners(path, 4, planeNormal);
    const row = this.#row;
    cutReflex(row, 4);
    const [from, to] = [HEAD + CORNER, HEAD + 2 * CORNER];
    row[CAP] = row[from + LENGTH] / Math.max(1, row[from + COT] + row[to + COT]);
  }

  /** Writes the arrows of all edges to `out`. */
  place(sizes: ArrowSizes, out: Float32Array, offset: number): void {
    placeArrows(this.#row, sizes, out, offset, 0, this.degree);
  }

  /** Writes the arrow of one edge to `out`. */
  placeOne(edge: number, sizes: ArrowSizes, out: Float32Array, offset: number): void {
    placeArrows(this.#row, sizes, out, offset, edge, edge + 1);
  }

  #measureCorners(
    corners: ArrayLike<number>,
    degree: number,
    planeNormal: ArrayLike<number>,
  ): void {
    const length = HEAD + degree * CORNER;
    if (length > this.#row.length) this.#row = new Float64Array(2 * length);
    measureCorners(corners, degree, planeNormal, this.#row);
  }
}

const normal = new Float64Array(3);
const NOTHING: ArrayLike<number> = [];

/**
 * In a triangle of semiperimeter s with the sides x, y, z and the inradius r, which is its cap, cot(θ/2) = (s − x) / r at
 * the corner across x. In one without area, arrows run along the edges.
 */
function measureTriangle(
  points: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  row: Float64Array,
): void {
  const ax = points[a];
  const ay = points[a + 1];
  const az = points[a + 2];
  const bx = points[b];
  const by = points[b + 1];
  const bz = points[b + 2];
  const cx = points[c];
  const cy = points[c + 1];
  const cz = points[c + 2];
  const abx = bx - ax;
  const aby = by - ay;
  const abz = bz - az;
  const bcx = cx - bx;
  const bcy = cy - by;
  const bcz = cz - bz;
  const cax = ax - cx;
  const cay = ay - cy;
  const caz = az - cz;
  const nx = aby * bcz - abz * bcy;
  const ny = abz * bcx - abx * bcz;
  const nz = abx * bcy - aby * bcx;
  const ab = Math.sqrt(abx * abx + aby * aby + abz * abz); // many times faster than Math.hypot
  const bc = Math.sqrt(bcx * bcx + bcy * bcy + bcz * bcz);
  const ca = Math.sqrt(cax * cax + cay * cay + caz * caz);
  const n = Math.sqrt(nx * nx + ny * ny + nz * nz);
  const perimeter = ab + bc + ca;
  const perAb = ab > 0 ? 1 / ab : 0;
  const perBc = bc > 0 ? 1 / bc : 0;
  const perCa = ca > 0 ? 1 / ca : 0;
  const perN = n > 0 ? 1 / n : 0;
  const half = 0.5 * perimeter;
  const perCap = perimeter * perN;
  row[DEGREE] = 3;
  row[CAP] = perimeter > 0 ? n / perimeter : 0;
  row[NORMAL] = nx * perN;
  row[NORMAL + 1] = ny * perN;
  row[NORMAL + 2] = nz * perN;
  const A = HEAD;
  row[A + PLACE] = ax;
  row[A + PLACE + 1] = ay;
  row[A + PLACE + 2] = az;
  row[A + ALONG] = abx * perAb;
  row[A + ALONG + 1] = aby * perAb;
  row[A + ALONG + 2] = abz * perAb;
  row[A + LENGTH] = ab;
  row[A + COT] = Math.max(0, half - bc) * perCap;
  const B = A + CORNER;
  row[B + PLACE] = bx;
  row[B + PLACE + 1] = by;
  row[B + PLACE + 2] = bz;
  row[B + ALONG] = bcx * perBc;
  row[B + ALONG + 1] = bcy * perBc;
  row[B + ALONG + 2] = bcz * perBc;
  row[B + LENGTH] = bc;
  row[B + COT] = Math.max(0, half - ca) * perCap;
  const C = B + CORNER;
  row[C + PLACE] = cx;
  row[C + PLACE + 1] = cy;
  row[C + PLACE + 2] = cz;
  row[C + ALONG] = cax * perCa;
  row[C + ALONG + 1] = cay * perCa;
  row[C + ALONG + 2] = caz * perCa;
  row[C + LENGTH] = ca;
  row[C + COT] = Math.max(0, half - ab) * perCap;
  for (let corner = A; corner <= C; corner += CORNER) writeInward(row, corner);
}

/** The direction to the left of the edge that leaves a corner, in the plane of the polygon. */
function writeInward(row: Float64Array, corner: number): void {
  const nx = row[NORMAL];
  const ny = row[NORMAL + 1];
  const nz = row[NORMAL + 2];
  const tx = row[corner + ALONG];
  const ty = row[corner + ALONG + 1];
  const tz = row[corner + ALONG + 2];
  row[corner + INWARD] = ny * tz - nz * ty;
  row[corner + INWARD + 1] = nz * tx - nx * tz;
  row[corner + INWARD + 2] = nx * ty - ny * tx;
}

/** Turns the inside beside an edge to the point that has xyz at `apex` of `points`, unless it lies nearly there. */
function lean(row: Float64Array, edge: number, points: ArrayLike<number>, apex: number): void {
  const at = HEAD + CORNER * edge;
  const tx = row[at + ALONG];
  const ty = row[at + ALONG + 1];
  const tz = row[at + ALONG + 2];
  const x = points[apex] - row[at + PLACE];
  const y = points[apex + 1] - row[at + PLACE + 1];
  const z = points[apex + 2] - row[at + PLACE + 2];
  const along = x * tx + y * ty + z * tz;
  const ix = x - along * tx;
  const iy = y - along * ty;
  const iz = z - along * tz;
  const length = Math.sqrt(ix * ix + iy * iy + iz * iz);
  const height = row[NORMAL] * ix + row[NORMAL + 1] * iy + row[NORMAL + 2] * iz;
  if (!(Math.abs(height) > FLAT * length)) return;
  row[at + INWARD] = ix / length;
  row[at + INWARD + 1] = iy / length;
  row[at + INWARD + 2] = iz / length;
}

/** Measures all of a polygon but its cap. */
function measureCorners(
  corners: ArrayLike<number>,
  degree: number,
  n: ArrayLike<number>,
  row: Float64Array,
): void {
  row[DEGREE] = degree;
  for (let k = 0; k < 3; k++) row[NORMAL + k] = n[k];
  const last = HEAD + CORNER * (degree - 1);
  for (let a = HEAD, p = 0; a <= last; a += CORNER, p += 3) {
    const q = a === last ? 0 : p + 3;
    const x = corners[q] - corners[p];
    const y = corners[q + 1] - corners[p + 1];
    const z = corners[q + 2] - corners[p + 2];
    const length = Math.sqrt(x * x + y * y + z * z);
    const scale = length > 0 ? 1 / length : 0;
    row[a + PLACE] = corners[p];
    row[a + PLACE + 1] = corners[p + 1];
    row[a + PLACE + 2] = corners[p + 2];
    row[a + ALONG] = x * scale;
    row[a + ALONG + 1] = y * scale;
    row[a + ALONG + 2] = z * scale;
    row[a + LENGTH] = length;
  }
  for (let a = HEAD, before = last; a <= last; before = a, a += CORNER) {
    row[a + COT] = halfAngleCot(row, before + ALONG, a + ALONG);
    writeInward(row, a);
  }
}

/** cot(θ/2) for θ in (0, 2π), from the direction at `u` to that at `t`: positive below π, negative at reflex corners. */
function halfAngleCot(row: Float64Array, u: number, t: number): number {
  const ux = row[u];
  const uy = row[u + 1];
  const uz = row[u + 2];
  const tx = row[t];
  const ty = row[t + 1];
  const tz = row[t + 2];
  const cos = -(ux * tx + uy * ty + uz * tz);
  const sin =
    row[NORMAL] * (uy * tz - uz * ty) +
    row[NORMAL + 1] * (uz * tx - ux * tz) +
    row[NORMAL + 2] * (ux * ty - uy * tx);
  const flat = 1e-9;
  if (Math.abs(sin) > flat) return (1 + cos) / sin;
  return cos > 0 ? 1 / flat : 0;
}

/** Shafts end where their edges do at reflex corners, and not beyond. */
function cutReflex(row: Float64Array, degree: number): void {
  for (let i = 0; i < degree; i++) {
    const cot = HEAD + CORNER * i + COT;
    if (row[cot] < 0) row[cot] = 0;
  }
}

function capOf(corners: ArrayLike<number>, degree: number, row: Float64Array): number {
  let cap = Infinity;
  for (let i = 0; i < degree; i++) {
    const a = HEAD + CORNER * i;
    const b = i + 1 === degree ? HEAD : a + CORNER;
    const span = Math.max(0, row[a + COT]) + Math.max(0, row[b + COT]);
    if (span > 0) cap = Math.min(cap, row[a + LENGTH] / span);
    if (degree === 3 || row[a + COT] >= 0) continue;
    for (let j = 0; j < degree; j++) {
      const end = j + 1 === degree ? 0 : j + 1;
      if (j === i || end === i) continue;
      const squared = squaredDistanceToSegment(corners, 3 * i, 3 * j, 3 * end);
      cap = Math.min(cap, Math.sqrt(squared) / 2);
    }
  }
  return cap;
}

/** The arrows of the edges from corner `first` on, before corner `end`. */
function placeArrows(
  row: Float64Array,
  { inset, trim, barb }: ArrowSizes,
  out: Float32Array,
  offset: number,
  first: number,
  end: number,
): void {
  const cap = row[CAP];
  const last = HEAD + CORNER * (row[DEGREE] - 1);
  const d = Math.min(inset, CAP_SHARE * cap);
  const widest = 0.6 * (cap - d);
  const stop = HEAD + CORNER * end;
  let o = offset;
  for (let a = HEAD + CORNER * first; a < stop; a += CORNER, o += ARROW_FLOATS) {
    const b = a === last ? HEAD : a + CORNER;
    const length = row[a + LENGTH];
    const startCot = row[a + COT];
    const endCot = row[b + COT];
    const gap = Math.min(trim, TRIM_SHARE * length);
    const from = startCot * d + gap;
    const to = length - endCot * d - gap;
    // The tip of the barb must stay between the same bisectors as the shaft.
    const back = Math.min(barb, BARB_SHARE * (to - from));
    const tip = to - back;
    let width = Math.min(BARB_SLOPE * back, widest);
    if (width * endCot > back + gap) width = (back + gap) / endCot;
    if (width * startCot > tip - from + gap) width = (tip - from + gap) / startCot;
    const tx = row[a + ALONG];
    const ty = row[a + ALONG + 1];
    const tz = row[a + ALONG + 2];
    const ix = row[a + INWARD];
    const iy = row[a + INWARD + 1];
    const iz = row[a + INWARD + 2];
    const x = row[a + PLACE] + d * ix;
    const y = row[a + PLACE + 1] + d * iy;
    const z = row[a + PLACE + 2] + d * iz;
    out[o] = x + from * tx;
    out[o + 1] = y + from * ty;
    out[o + 2] = z + from * tz;
    out[o + 3] = x + to * tx;
    out[o + 4] = y + to * ty;
    out[o + 5] = z + to * tz;
    out[o + 6] = x + tip * tx + width * ix;
    out[o + 7] = y + tip * ty + width * iy;
    out[o + 8] = z + tip * tz + width * iz;
  }
}
