/** No segment is cut into more dashes. */
export const MOST_DASHES = 200;

/**
 * How many dashes the segment from xyz at `a` to xyz at `b` of `points` has: each is about `period` long, the first `duty`
 * of it drawn. The last one ends where the segment does, so that both ends of it can be seen.
 */
export function dashCount(
  points: ArrayLike<number>,
  a: number,
  b: number,
  period: number,
  duty: number,
): number {
  const x = points[b] - points[a];
  const y = points[b + 1] - points[a + 1];
  const z = points[b + 2] - points[a + 2];
  const length = Math.sqrt(x * x + y * y + z * z);
  return Math.max(1, Math.min(MOST_DASHES, Math.round(length / period - duty) + 1));
}

/** Writes so many dashes of a segment to `out`: xyz of both ends of each. */
export function placeDashes(
  points: ArrayLike<number>,
  a: number,
  b: number,
  dashes: number,
  duty: number,
  out: { [index: number]: number },
  offset: number,
): void {
  const pitch = 1 / (dashes - 1 + duty);
  const part = dashes > 1 ? duty * pitch : 1;
  for (let k = 0; k < 3; k++) {
    const from = points[a + k];
    const span = points[b + k] - from;
    for (let i = 0, o = offset + k; i < dashes; i++, o += 6) {
      out[o] = from + span * i * pitch;
      out[o + 3] = from + span * (i * pitch + part);
    }
  }
}
