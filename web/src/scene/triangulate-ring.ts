import { ShapeUtils, Vector2 } from 'three';
import { newellNormal } from '../three/index.js';

/** The triangles of a polygon: ear clipping in its plane; a fan where it has no area. */
export function triangulateRing(ring: number[], points: Float32Array): number[] {
  if (ring.length === 3) return ring;
  const corners = ring.flatMap((v) => [points[3 * v], points[3 * v + 1], points[3 * v + 2]]);
  const normal = newellNormal(corners, ring.length, new Float64Array(3));
  const flat = flatten(corners, normal);
  const pieces = ShapeUtils.triangulateShape(flat, []);
  if (pieces.length === ring.length - 2) return pieces.flat().map((i) => ring[i]);
  return ring.slice(2).flatMap((v, i) => [ring[0], ring[i + 1], v]);
}

/** The points seen along the normal, counter-clockwise where the face is. */
function flatten(corners: readonly number[], normal: Float64Array): Vector2[] {
  const [x, y, z] = normal;
  // A unit vector across the normal (Duff et al., "Building an Orthonormal Basis, Revisited").
  const sign = z >= 0 ? 1 : -1;
  const a = -1 / (sign + z);
  const b = x * y * a;
  const u = [1 + sign * x * x * a, sign * b, -sign * x];
  const v = [b, sign + y * y * a, -y];
  const flat: Vector2[] = [];
  for (let i = 0; i < corners.length; i += 3) {
    const dot = (w: readonly number[]) =>
      w[0] * corners[i] + w[1] * corners[i + 1] + w[2] * corners[i + 2];
    flat.push(new Vector2(dot(u), dot(v)));
  }
  return flat;
}
