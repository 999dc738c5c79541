// The meshes that answers are tried on: small, and each with something that programs stumble over.

import { HalfedgeMesh } from '../../api.js';

/** A mesh by its name, and what it is called in a sentence. */
export interface Sample {
  readonly name: string;
  /** `the tetrahedron` */
  readonly words: string;
  /** What there is to stumble over. */
  readonly trap: string;
  readonly make: () => HalfedgeMesh;
  /** From where it is to be looked at. */
  readonly view: readonly [x: number, y: number, z: number];
}

/** The name of a mesh on which answers are tried. */
export type MeshName =
  | 'tetrahedron'
  | 'prism'
  | 'cone'
  | 'torus'
  | 'sheet'
  | 'ring'
  | 'bow-tie'
  | 'lonely';

const TURN = 2 * Math.PI;

/** `count` points on a circle of the plane. */
function circle(count: number, radius: number, [x, y] = [0, 0], from = 0): number[] {
  return Array.from({ length: count }, (_, i) => {
    const angle = from + (TURN * i) / count;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle), 0];
  }).flat();
}

/** A triangle, two quads and a pentagon side by side, all at the boundary but one vertex. */
function sheet(): HalfedgeMesh {
  return HalfedgeMesh.fromPolygons(
    [
      ...[-1.5, -1, 0, 0, -1, 0, 1.5, -1, 0, -1.5, 0, 0, 0, 0, 0, 1.5, 0, 0],
      ...[-1.2, 1, 0, 0, 1, 0, 1.3, 0.7, 0, 0.8, 1.3, 0],
    ],
    [
      [0, 1, 4, 3],
      [1, 2, 5, 4],
      [3, 4, 7, 6],
      [4, 5, 8, 9, 7],
    ],
  );
}

/** Quads and triangles between two boundary loops. */
function ring(): HalfedgeMesh {
  const count = 6;
  const faces = Array.from({ length: count }, (_, i) => {
    const j = (i + 1) % count;
    const [a, b, c, d] = [i, j, count + j, count + i];
    return i % 2 === 0
      ? [[a, d, c, b]]
      : [
          [a, d, c],
          [a, c, b],
        ];
  }).flat();
  return HalfedgeMesh.fromPolygons([...circle(count, 0.55), ...circle(count, 1.3)], faces);
}

/** Two fans that share only their tip. */
function bowTie(): HalfedgeMesh {
  return HalfedgeMesh.fromPolygons(
    [
      ...[0, 0, 0, 1.2, -0.8, 0, 1.5, 0, 0, 1.2, 0.8, 0],
      ...[-1.2, 0.8, 0, -1.5, 0, 0, -1.2, -0.8, 0],
    ],
    [
      [0, 1, 2],
      [0, 2, 3],
      [0, 4, 5],
      [0, 5, 6],
    ],
  );
}

/** A fan of three triangles, and a vertex that nothing meets. */
function lonely(): HalfedgeMesh {
  return HalfedgeMesh.fromPolygons(
    [...[-1, -0.6, 0, 0, -0.8, 0, 1, -0.5, 0, 0.5, 0.5, 0, -0.6, 0.4, 0, 1.2, 0.7, 0]],
    [
      [0, 1, 4],
      [1, 2, 3],
      [1, 3, 4],
    ],
  );
}

const ABOVE = [0.6, 0.55, 1] as const;
/** Those in the plane are looked at straight on. */
const FRONT = [0, 0, 1] as const;

/** In the order in which they are tried: what is closed first. */
export const samples: readonly (Sample & { readonly name: MeshName })[] = [
  {
    name: 'tetrahedron',
    words: 'the tetrahedron',
    trap: 'closed, all faces triangles',
    make: () => HalfedgeMesh.tetrahedron(),
    view: ABOVE,
  },
  {
    name: 'prism',
    words: 'the prism',
    trap: 'closed, of quads and pentagons',
    make: () => HalfedgeMesh.prism(5, { height: 1.3 }),
    view: ABOVE,
  },
  {
    name: 'cone',
    words: 'the cone',
    trap: 'a vertex of valence 12, and a face of degree 12',
    make: () => HalfedgeMesh.cone(12),
    view: ABOVE,
  },
  {
    name: 'torus',
    words: 'the torus',
    trap: 'closed, with a handle',
    make: () => HalfedgeMesh.torus(5, 4),
    view: ABOVE,
  },
  {
    name: 'sheet',
    words: 'the sheet',
    trap: 'a boundary, and mixed polygons',
    make: sheet,
    view: FRONT,
  },
  { name: 'ring', words: 'the ring', trap: 'two boundary loops', make: ring, view: FRONT },
  {
    name: 'bow-tie',
    words: 'the bow tie',
    trap: 'a pinched vertex: two fans',
    make: bowTie,
    view: FRONT,
  },
  {
    name: 'lonely',
    words: 'the sheet with a lonely vertex',
    trap: 'an isolated vertex',
    make: lonely,
    view: FRONT,
  },
];

/** The samples of these names, in their own order; all without names. */
export function samplesNamed(names?: readonly string[]): readonly Sample[] {
  return names ? samples.filter(({ name }) => names.includes(name)) : samples;
}
