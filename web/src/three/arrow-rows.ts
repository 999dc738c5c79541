import type { ArrowSizes } from './arrows.js';
import { newellNormal, squaredDistanceToSegment } from './polygon.js';

const DEGREE = 0;
const CAP = 1;
const HEAD = 2;
const PLACE = 0;
const ALONG = 3;
const INWARD = 6;
const LENGTH = 9;
const COT = 10;
const TAN = 11;
const CORNER = 12;

/** xyz of the start, the end and the tip of the barb. */
export const ARROW_FLOATS = 9;

/** An arrow as two segments, of which the second, the barb, begins where the first ends. */
export const SEGMENTS_OF_ARROW = 2;

/** The inset is at most this share of the largest one that leaves all arrows some length. */
export const CAP_SHARE = 0.35;

const TRIM_SHARE = 0.12;
const BARB_SHARE = 0.4;
const BARB_SLOPE = 0.55;

/** How many numbers the row of a polygon has. */
export function rowLength(degree: number): number {
  return HEAD + CORNER * degree;
}

/**
 * What of polygons their arrows depend on, whatever their sizes, as rows of numbers: measured once, and kept as long as
 * the corners stay, they are what arrows are placed by whenever the camera moves. Of each corner a row has, in this
 * order, its place, the direction of the edge that leaves it, the direction from there into the face, the length of
 * that edge, cot(θ/2) of the angle θ or 0 if that is reflex, and the inverse of that.
 */
export class ArrowRows {
  #data = new Float64Array(rowLength(16));

  /** Makes room for so many numbers; what is there stays. */
  reserve(length: number): void {
    if (length <= this.#data.length) return;
    const grown = new Float64Array(2 * length);
    grown.set(this.#data);
    this.#data = grown;
  }

  degree(at: number): number {
    return this.#data[at + DEGREE];
  }

  cap(at: number): number {
    return this.#data[at + CAP];
  }

  /** Writes the row of a face. `corners` holds xyz of `degree` ≥ 3 corners, counter-clockwise. */
  measureFace(at: number, corners: ArrayLike<number>, degree: number): void {
    this.reserve(at + rowLength(degree));
    const data = this.#data;
    measureCorners(corners, degree, newellNormal(corners, degree, normal), data, at);
    data[at + CAP] = faceCap(corners, degree, data, at);
    cutReflex(data, at);
  }

  /** Writes the row of four points, of which the second edge has an arrow, in the plane of this normal. */
  measureBoundary(at: number, path: ArrayLike<number>, planeNormal: ArrayLike<number>): void {
    this.reserve(at + rowLength(4));
    const data = this.#data;
    measureCorners(path, 4, planeNormal, data, at);
    const [from, to] = [at + HEAD + CORNER, at + HEAD + 2 * CORNER];
    const span = Math.max(0, data[from + COT]) + Math.max(0, data[to + COT]);
    data[at + CAP] = data[from + LENGTH] / Math.max(1, span);
    cutReflex(data, at);
  }

  /** Writes the arrows of all edges of a row to `out`. Returns how many there are. */
  place(at: number, sizes: ArrowSizes, out: Float32Array, offset: number): number {
    const degree = this.#data[at + DEGREE];
    placeArrows(this.#data, at, sizes, out, offset, 3, 0, degree);
    return degree;
  }

  /** Writes the arrows of all edges of a row to `out`, as two segments each: xyz of both ends of shaft and barb. */
  placeSegments(at: number, sizes: ArrowSizes, out: Float32Array, offset: number): void {
    placeArrows(this.#data, at, sizes, out, offset, 6, 0, this.#data[at + DEGREE]);
  }

  /** Writes the arrow of one edge of a row to `out`. */
  placeOne(at: number, edge: number, sizes: ArrowSizes, out: Float32Array, offset: number): void {
    placeArrows(this.#data, at, sizes, out, offset, 3, edge, edge + 1);
  }
}

/** The arrows of the edges from corner `first` on, before corner `end`. Of each, the barb is written from `barbAt` on. */
function placeArrows(
  row: Float64Array,
  at: number,
  { inset, trim, barb }: ArrowSizes,
  out: Float32Array,
  offset: number,
  barbAt: number,
  first: number,
  end: number,
): void {
  const cap = row[at + CAP];
  const last = at + HEAD + CORNER * (row[at + DEGREE] - 1);
  const d = Math.min(inset, CAP_SHARE * cap);
  const widest = 0.6 * (cap - d);
  const stop = at + HEAD + CORNER * end;
  let o = offset;
  for (let a = at + HEAD + CORNER * first; a < stop; a += CORNER, o += barbAt + 6) {
    const b = a === last ? at + HEAD : a + CORNER;
    const length = row[a + LENGTH];
    const gap = Math.min(trim, TRIM_SHARE * length);
    const from = row[a + COT] * d + gap;
    const to = length - row[b + COT] * d - gap;
    // The tip of the barb must stay between the same bisectors as the shaft.
    const back = Math.min(barb, BARB_SHARE * (to - from));
    const slope = Math.min(BARB_SLOPE * back, widest);
    const room = Math.min((back + gap) * row[b + TAN], (to - back - from + gap) * row[a + TAN]);
    const width = Math.max(0, Math.min(slope, room));
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
    const b1 = o + barbAt;
    out[o + 3] = out[b1] = x + to * tx;
    out[o + 4] = out[b1 + 1] = y + to * ty;
    out[o + 5] = out[b1 + 2] = z + to * tz;
    const tip = to - back;
    out[b1 + 3] = x + tip * tx + width * ix;
    out[b1 + 4] = y + tip * ty + width * iy;
    out[b1 + 5] = z + tip * tz + width * iz;
  }
}

const normal = new Float64Array(3);
/** Instead of infinity, which times nothing is no number. */
const UNBOUNDED = 1e30;

function measureCorners(
  corners: ArrayLike<number>,
  degree: number,
  n: ArrayLike<number>,
  row: Float64Array,
  at: number,
): void {
  row[at + DEGREE] = degree;
  const first = at + HEAD;
  const last = first + CORNER * (degree - 1);
  for (let a = first, p = 0; a <= last; a += CORNER, p += 3) {
    const q = a === last ? 0 : p + 3;
    const x = corners[q] - corners[p];
    const y = corners[q + 1] - corners[p + 1];
    const z = corners[q + 2] - corners[p + 2];
    const length = Math.sqrt(x * x + y * y + z * z); // many times faster than Math.hypot
    const scale = length > 0 ? 1 / length : 0;
    const [tx, ty, tz] = [x * scale, y * scale, z * scale];
    row[a + PLACE] = corners[p];
    row[a + PLACE + 1] = corners[p + 1];
    row[a + PLACE + 2] = corners[p + 2];
    row[a + ALONG] = tx;
    row[a + ALONG + 1] = ty;
    row[a + ALONG + 2] = tz;
    // To the left of the edge, in the plane of the face.
    row[a + INWARD] = n[1] * tz - n[2] * ty;
    row[a + INWARD + 1] = n[2] * tx - n[0] * tz;
    row[a + INWARD + 2] = n[0] * ty - n[1] * tx;
    row[a + LENGTH] = length;
  }
  for (let a = first, before = last; a <= last; before = a, a += CORNER) {
    const cot = halfAngleCot(
      -dot(row, a + ALONG, before + ALONG),
      dot(row, a + ALONG, before + INWARD),
    );
    row[a + COT] = cot;
    row[a + TAN] = cot > 0 ? 1 / cot : UNBOUNDED;
  }
}

/** Shafts end where their edges do at reflex corners, and not beyond. */
function cutReflex(row: Float64Array, at: number): void {
  for (let i = 0; i < row[at + DEGREE]; i++) {
    const cot = at + HEAD + CORNER * i + COT;
    if (row[cot] < 0) row[cot] = 0;
  }
}

function dot(row: Float64Array, a: number, b: number): number {
  return row[a] * row[b] + row[a + 1] * row[b + 1] + row[a + 2] * row[b + 2];
}

/** cot(θ/2) for θ in (0, 2π): positive below π, negative at reflex corners. */
function halfAngleCot(cos: number, sin: number): number {
  const flat = 1e-9;
  if (Math.abs(sin) > flat) return (1 + cos) / sin;
  return cos > 0 ? 1 / flat : 0;
}

function faceCap(
  corners: ArrayLike<number>,
  degree: number,
  row: Float64Array,
  at: number,
): number {
  let cap = Number.POSITIVE_INFINITY;
  for (let i = 0; i < degree; i++) {
    const a = at + HEAD + CORNER * i;
    const b = i + 1 === degree ? at + HEAD : a + CORNER;
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
