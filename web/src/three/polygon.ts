/**
 * The area-weighted (Newell) normal of a closed polygon, as a unit vector in `out`.
 * `corners` holds xyz of `degree` corners. A polygon without area gives (0, 0, 0).
 */
export function newellNormal(
  corners: ArrayLike<number>,
  degree: number,
  out: Float64Array,
): Float64Array {
  let x = 0;
  let y = 0;
  let z = 0;
  for (let a = 3 * (degree - 1), b = 0; b < 3 * degree; a = b, b += 3) {
    x += (corners[a + 1] - corners[b + 1]) * (corners[a + 2] + corners[b + 2]);
    y += (corners[a + 2] - corners[b + 2]) * (corners[a] + corners[b]);
    z += (corners[a] - corners[b]) * (corners[a + 1] + corners[b + 1]);
  }
  const length = Math.sqrt(x * x + y * y + z * z);
  const scale = length > 0 ? 1 / length : 0;
  out[0] = x * scale;
  out[1] = y * scale;
  out[2] = z * scale;
  return out;
}

/** Squared distance from the point at `p` to the segment between the points at `a` and `b`. */
export function squaredDistanceToSegment(
  points: ArrayLike<number>,
  p: number,
  a: number,
  b: number,
): number {
  const dx = points[b] - points[a];
  const dy = points[b + 1] - points[a + 1];
  const dz = points[b + 2] - points[a + 2];
  let x = points[p] - points[a];
  let y = points[p + 1] - points[a + 1];
  let z = points[p + 2] - points[a + 2];
  const length = dx * dx + dy * dy + dz * dz;
  const t = length > 0 ? Math.min(1, Math.max(0, (x * dx + y * dy + z * dz) / length)) : 0;
  x -= t * dx;
  y -= t * dy;
  z -= t * dz;
  return x * x + y * y + z * z;
}
