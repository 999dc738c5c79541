import type { HalfedgeMesh } from 'halfedge';
import { Vector3 } from 'three';

/** Where a vertex lies. */
export const at = (mesh: HalfedgeMesh, v: number) => new Vector3(...mesh.position(v));

export const sum = (values: Iterable<number>) => Array.from(values).reduce((a, b) => a + b, 0);

export function expectNear(
  found: ArrayLike<number>,
  expected: ArrayLike<number>,
  within = 1e-6,
): void {
  expect(found.length).toBe(expected.length);
  let worst = 0;
  for (let i = 0; i < found.length; i++) {
    const difference = Math.abs(found[i] - expected[i]);
    worst = Math.max(difference, worst);
  }
  expect(worst).toBeLessThanOrEqual(within);
}
