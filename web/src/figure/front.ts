import { Vector3 } from 'three';

/** Surfaces that are flatter than this, in the unit sphere, are looked at from the front. */
const FLAT = 0.05;

/** The direction to look from: flat surfaces are seen best from the front, others from the side and from above. */
export function frontOf(points: Float32Array): Vector3 {
  const extent = [0, 1, 2].map((k) => {
    let most = 0;
    for (let i = k; i < points.length; i += 3) most = Math.max(most, Math.abs(points[i]));
    return most;
  });
  if (extent[2] < FLAT) return new Vector3(0, 0, 1);
  if (extent[1] < FLAT) return new Vector3(0, 1, 0.001);
  if (extent[0] < FLAT) return new Vector3(1, 0, 0);
  return new Vector3(0.45, 0.35, 1);
}
