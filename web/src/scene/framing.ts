import { Vector3 } from 'three';

/** How far to each side of the axis a point may be at depth 1 to be in sight. */
export interface Slopes {
  readonly x: number;
  readonly y: number;
}

/** What a camera looks at, and from how far. */
export interface Framing {
  readonly target: Vector3;
  readonly distance: number;
}

/**
 * The nearest place on the side of `direction` that has all points in sight. A point at (x, y, z) of the camera's frame
 * is in sight where |x - cx| ≤ slope (d - z), which the extremes of x ± slope z decide.
 */
export function framingOf(
  points: Float32Array,
  direction: Vector3,
  cameraUp: Vector3,
  slopes: Slopes,
): Framing {
  const back = direction.clone().normalize();
  const right = new Vector3().crossVectors(cameraUp, back);
  if (right.lengthSq() < 1e-9) right.set(1, 0, 0);
  right.normalize();
  const up = new Vector3().crossVectors(back, right);
  const limits = [
    farthest(points, slopes.x, right, back),
    farthest(points, slopes.x, right.clone().negate(), back),
    farthest(points, slopes.y, up, back),
    farthest(points, slopes.y, up.clone().negate(), back),
  ];
  if (!limits.every(Number.isFinite)) limits.fill(1);
  const distance = Math.max(
    (limits[0] + limits[1]) / (2 * slopes.x),
    (limits[2] + limits[3]) / (2 * slopes.y),
    1e-3,
  );
  const target = right
    .multiplyScalar((limits[0] - limits[1]) / 2)
    .addScaledVector(up, (limits[2] - limits[3]) / 2);
  return { target, distance };
}

/** The largest of x + slope z among points, where x and z are measured along two directions. */
function farthest(points: Float32Array, slope: number, along: Vector3, back: Vector3): number {
  const { x, y, z } = along.clone().addScaledVector(back, slope);
  let most = -Infinity;
  for (let i = 0; i < points.length; i += 3) {
    const reach = x * points[i] + y * points[i + 1] + z * points[i + 2];
    if (reach > most) most = reach;
  }
  return most;
}
