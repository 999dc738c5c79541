import { Quaternion, Vector3 } from 'three';
import { Flight, type Pose } from '../../dist/scene/flight.js';

const pose = (x: number, y: number, z: number, target = new Vector3()): Pose => ({
  target,
  position: new Vector3(x, y, z).add(target),
});

/** Where the camera is on its way, at some moments from the beginning to the end. */
function wayOf(flight: Flight, from = 0): Pose[] {
  const way: Pose[] = [];
  for (let now = from, goes = true; goes; now += 20) {
    const at = pose(0, 0, 1);
    goes = flight.at(now, at);
    way.push(at);
  }
  return way;
}

const heading = ({ target, position }: Pose) => position.clone().sub(target).normalize();
const degrees = (a: Pose, b: Pose) => (heading(a).angleTo(heading(b)) * 180) / Math.PI;

test.each([
  ['half around', pose(0, 1, 5), pose(0, 1, -5)],
  ['almost half around, and nearer', pose(0.1, 0, 5), pose(0, 0, -2)],
  ['from below to above', pose(0, -5, 0.5), pose(0, 5, -0.5, new Vector3(1, 2, 3))],
])('A flight %s turns step by step, and ends where it leads', (_, from, goal) => {
  const way = wayOf(new Flight(from, goal, 0));
  expect(way.at(-1)?.position.distanceTo(goal.position)).toBeLessThan(1e-9);
  expect(way.at(-1)?.target.distanceTo(goal.target)).toBeLessThan(1e-9);
  for (const [i, each] of way.entries()) {
    if (i > 0) expect(degrees(way[i - 1], each)).toBeLessThan(20);
    const distance = each.position.distanceTo(each.target);
    expect(distance).toBeGreaterThan(1.99);
    expect(distance).toBeLessThan(5.2);
  }
});

test('A flight goes around the shorter way', () => {
  const [east, west] = [pose(3, 0, -4), pose(-3, 0, -4)];
  for (const way of [wayOf(new Flight(east, west, 0)), wayOf(new Flight(west, east, 0))]) {
    for (const { position } of way) expect(position.z).toBeLessThan(0);
  }
});

test('A flight begins gently, unless the camera is moving already', () => {
  const [from, goal] = [pose(0, 0, 5), pose(5, 0, 0)];
  const moved = (isUnderWay: boolean) => {
    const [first, second] = wayOf(new Flight(from, goal, 0, { isUnderWay }));
    return degrees(first, second);
  };
  expect(moved(false)).toBeLessThan(1);
  expect(moved(true)).toBeGreaterThan(6);
});

test('A flight where z points up is the same, laid on its side', () => {
  const upright = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(0, 1, 0));
  const down = upright.clone().invert();
  const laid = ({ target, position }: Pose): Pose => ({
    target: target.clone().applyQuaternion(down),
    position: position.clone().applyQuaternion(down),
  });
  const [from, goal] = [pose(0.2, 1, 5), pose(1, 2, -4, new Vector3(1, 2, 3))];
  const [usual, turned] = [
    wayOf(new Flight(from, goal, 0)),
    wayOf(new Flight(laid(from), laid(goal), 0, { upright })),
  ];
  expect(turned).toHaveLength(usual.length);
  usual.map(laid).forEach(({ target, position }, i) => {
    expect(turned[i].position.distanceTo(position)).toBeLessThan(1e-9);
    expect(turned[i].target.distanceTo(target)).toBeLessThan(1e-9);
  });
});
