import { Vector3 } from 'three';
import { framingOf } from '../../dist/scene/framing.js';
import { random } from './support/random.js';

const Y = new Vector3(0, 1, 0);

/** How far out of the axis each point is seen, as a share of what is in sight: 1 at the edge of the picture. */
function sharesOf(
  points: Float32Array,
  direction: Vector3,
  slopes: { x: number; y: number },
): { x: number[]; y: number[] } {
  const { target, distance } = framingOf(points, direction, Y, slopes);
  const back = direction.clone().normalize();
  const right = new Vector3().crossVectors(Y, back).normalize();
  const up = new Vector3().crossVectors(back, right);
  const position = target.clone().addScaledVector(back, distance);
  const shares = { x: [] as number[], y: [] as number[] };
  for (let i = 0; i < points.length; i += 3) {
    const way = new Vector3().fromArray(points, i).sub(position);
    const depth = -way.dot(back);
    shares.x.push(way.dot(right) / depth / slopes.x);
    shares.y.push(way.dot(up) / depth / slopes.y);
  }
  return shares;
}

test.each(Array.from({ length: 20 }, (_, seed) => seed))(
  'All points are in sight, and fill the picture on one axis (seed %i)',
  (seed) => {
    const next = random(seed);
    const points = Float32Array.from({ length: 3 * 12 }, () => 4 * next() - 2);
    const direction = new Vector3(next() - 0.5, next() - 0.5, next() - 0.5);
    const { x, y } = sharesOf(points, direction, { x: 0.2 + next(), y: 0.2 + next() });
    const reach = (shares: number[]) => [Math.min(...shares), Math.max(...shares)];
    for (const [least, most] of [reach(x), reach(y)]) {
      expect(least).toBeGreaterThan(-1 - 1e-5);
      expect(most).toBeLessThan(1 + 1e-5);
    }
    const isFilled = [reach(x), reach(y)].map(
      ([least, most]) => least + 1 < 1e-5 && most > 1 - 1e-5,
    );
    expect(isFilled).toContain(true);
  },
);

test('From straight above, and of nothing or of a point, there is a picture all the same', () => {
  const slopes = { x: 0.3, y: 0.3 };
  const above = framingOf(new Float32Array([1, 0, 0, -1, 0, 0]), Y, Y, slopes);
  expect(above.target.toArray()).toEqual([0, 0, 0]);
  expect(above.distance).toBeCloseTo(1 / 0.3);
  const ahead = new Vector3(0, 0, 1);
  const nothing = framingOf(new Float32Array(), ahead, Y, slopes);
  expect(nothing.target.toArray()).toEqual([0, 0, 0]);
  expect(nothing.distance).toBeCloseTo(1 / 0.3);
  const point = framingOf(new Float32Array([1, 2, 0]), ahead, Y, slopes);
  expect(point.target.toArray()).toEqual([1, 2, 0]);
  expect(point.distance).toBe(1e-3);
});
