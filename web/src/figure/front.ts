import { Vector3 } from 'three';
import { UP, type UpAxis, uprightOf } from '../scene/up.js';

/** Surfaces that are flatter than this, in the unit sphere, are looked at from the front. */
const FLAT = 0.05;

/** The direction to look from: flat surfaces are seen best from the front, others from the side and from above. */
export function frontOf(points: Float32Array, up: UpAxis): Vector3 {
  const extent = [0, 1, 2].map((k) => {
    let most = 0;
    for (let i = k; i < points.length; i += 3) most = Math.max(most, Math.abs(points[i]));
    return most;
  });
  const [width, height, depth] = up === 'y' ? extent : [extent[0], extent[2], extent[1]];
  return view(width, height, depth).applyQuaternion(uprightOf(UP[up]).invert());
}

/** The same where y points up. */
function view(width: number, height: number, depth: number): Vector3 {
  if (depth < FLAT) return new Vector3(0, 0, 1);
  if (height < FLAT) return new Vector3(0, 1, 0.001);
  if (width < FLAT) return new Vector3(1, 0, 0);
  return new Vector3(0.45, 0.35, 1);
}
