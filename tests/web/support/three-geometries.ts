import * as THREE from 'three';

const square = () => {
  const corners = [
    [0, 0],
    [4, 0],
    [4, 3],
    [0, 3],
  ];
  return new THREE.Shape(corners.map(([x, y]) => new THREE.Vector2(x, y)));
};

const squareWithHole = () => {
  const shape = square();
  const corners = [
    [1, 1],
    [1, 2],
    [2, 2],
    [2, 1],
  ];
  shape.holes.push(new THREE.Path(corners.map(([x, y]) => new THREE.Vector2(x, y))));
  return shape;
};

const curve = (points: number[][], closed: boolean) =>
  new THREE.CatmullRomCurve3(
    points.map(([x, y, z]) => new THREE.Vector3(x, y, z)),
    closed,
  );
const arc = () =>
  curve(
    [
      [0, 0, 0],
      [1, 1, 0],
      [2, 0, 1],
    ],
    false,
  );
const circle = () =>
  curve(
    [
      [1, 0, 0],
      [0, 1, 0],
      [-1, 0, 0],
      [0, -1, 0],
    ],
    true,
  );
const profile = (points: number[][]) => points.map(([x, y]) => new THREE.Vector2(x, y));

/** V, E, F, genus, boundary loops: of what the geometry shows, not of its buffers. */
type Topology = [vertices: number, edges: number, faces: number, genus: number, loops: number];

/** Each of three.js's own geometries, and what it is. */
export const GEOMETRIES: [string, () => THREE.BufferGeometry, Topology][] = [
  ['BoxGeometry', () => new THREE.BoxGeometry(1, 2, 3, 2, 3, 4), [54, 156, 104, 0, 0]],
  ['SphereGeometry', () => new THREE.SphereGeometry(1, 8, 6), [42, 120, 80, 0, 0]],
  [
    'SphereGeometry, a part',
    () => new THREE.SphereGeometry(1, 8, 6, 0, Math.PI, 0.5, 1),
    [63, 158, 96, 0, 1],
  ],
  ['TorusGeometry', () => new THREE.TorusGeometry(1, 0.4, 6, 9), [54, 162, 108, 1, 0]],
  [
    'TorusGeometry, an arc',
    () => new THREE.TorusGeometry(1, 0.4, 6, 9, Math.PI),
    [60, 168, 108, 0, 2],
  ],
  ['TorusKnotGeometry', () => new THREE.TorusKnotGeometry(1, 0.3, 32, 5), [160, 480, 320, 1, 0]],
  ['CylinderGeometry', () => new THREE.CylinderGeometry(1, 1, 2, 8, 3), [34, 96, 64, 0, 0]],
  [
    'CylinderGeometry, open',
    () => new THREE.CylinderGeometry(1, 1, 2, 8, 3, true),
    [32, 80, 48, 0, 2],
  ],
  ['ConeGeometry', () => new THREE.ConeGeometry(1, 2, 7, 3), [23, 63, 42, 0, 0]],
  ['ConeGeometry, open', () => new THREE.ConeGeometry(1, 2, 7, 3, true), [22, 56, 35, 0, 1]],
  [
    'LatheGeometry, closed by the axis',
    () =>
      new THREE.LatheGeometry(
        profile([
          [0, -1],
          [1, 0],
          [0, 1],
        ]),
        9,
      ),
    [11, 27, 18, 0, 0],
  ],
  [
    'LatheGeometry, open',
    () =>
      new THREE.LatheGeometry(
        profile([
          [1, -1],
          [2, 0],
          [1, 1],
        ]),
        9,
      ),
    [27, 63, 36, 0, 2],
  ],
  [
    'ExtrudeGeometry',
    () => new THREE.ExtrudeGeometry(square(), { depth: 1, bevelEnabled: false, steps: 2 }),
    [12, 30, 20, 0, 0],
  ],
  [
    'ExtrudeGeometry with a hole',
    () => new THREE.ExtrudeGeometry(squareWithHole(), { depth: 1, bevelEnabled: false }),
    [16, 48, 32, 1, 0],
  ],
  [
    'ExtrudeGeometry with a hole and bevels',
    () => new THREE.ExtrudeGeometry(squareWithHole(), { depth: 1, bevelSegments: 2 }),
    [48, 144, 96, 1, 0],
  ],
  ['TubeGeometry', () => new THREE.TubeGeometry(arc(), 10, 0.2, 6, false), [66, 186, 120, 0, 2]],
  [
    'TubeGeometry, closed',
    () => new THREE.TubeGeometry(circle(), 12, 0.2, 6, true),
    [72, 216, 144, 1, 0],
  ],
  ['TetrahedronGeometry', () => new THREE.TetrahedronGeometry(1), [4, 6, 4, 0, 0]],
  ['OctahedronGeometry', () => new THREE.OctahedronGeometry(1, 2), [38, 108, 72, 0, 0]],
  ['IcosahedronGeometry', () => new THREE.IcosahedronGeometry(1, 3), [162, 480, 320, 0, 0]],
  ['DodecahedronGeometry', () => new THREE.DodecahedronGeometry(1), [20, 54, 36, 0, 0]],
  [
    'PolyhedronGeometry',
    () =>
      new THREE.PolyhedronGeometry(
        [1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1],
        [2, 1, 0, 0, 3, 2, 1, 3, 0, 2, 3, 1],
        1,
        2,
      ),
    [20, 54, 36, 0, 0],
  ],
  ['PlaneGeometry', () => new THREE.PlaneGeometry(1, 1, 4, 3), [20, 43, 24, 0, 1]],
  ['RingGeometry', () => new THREE.RingGeometry(0.5, 1, 8, 2), [24, 56, 32, 0, 2]],
  ['RingGeometry, a part', () => new THREE.RingGeometry(0.5, 1, 8, 2, 0, 1), [27, 58, 32, 0, 1]],
  ['CircleGeometry', () => new THREE.CircleGeometry(1, 8), [9, 16, 8, 0, 1]],
  ['CircleGeometry, a part', () => new THREE.CircleGeometry(1, 8, 0, 1), [10, 17, 8, 0, 1]],
  ['ShapeGeometry', () => new THREE.ShapeGeometry(square()), [4, 5, 2, 0, 1]],
  ['ShapeGeometry with a hole', () => new THREE.ShapeGeometry(squareWithHole()), [8, 16, 8, 0, 2]],
];
