import { type BuildOptions, HalfedgeMesh } from 'halfedge';
import { random, shuffle } from './random.js';

/** Positions and faces, as `fromPolygons` takes them. */
export interface Input {
  positions: number[];
  faces: number[][];
}

/** An index buffer of triangles: each face as a fan around its first corner. */
export function fans({ faces }: Input): number[] {
  return faces.flatMap((face) =>
    face.slice(2).flatMap((_, i) => [face[0], face[i + 1], face[i + 2]]),
  );
}

/** The mesh of polygons; throws what `fromPolygons` throws. */
export function build({ positions, faces }: Input, options: BuildOptions = {}): HalfedgeMesh {
  return HalfedgeMesh.fromPolygons(positions, faces, options);
}

/** 4x4 vertices row by row, 9 quads: the example of the circulators' order. */
export function quadGrid(columns = 4, rows = 4): Input {
  const positions: number[] = [];
  for (let y = 0; y < rows; y++) for (let x = 0; x < columns; x++) positions.push(x, y, 0);
  const faces: number[][] = [];
  for (let y = 0; y + 1 < rows; y++) {
    for (let x = 0; x + 1 < columns; x++) {
      const v = y * columns + x;
      faces.push([v, v + 1, v + columns + 1, v + columns]);
    }
  }
  return { positions, faces };
}

/** Quads around a tube, closed in both directions. */
export function torus(columns = 5, rows = 4): Input {
  const { positions } = quadGrid(columns, rows);
  const at = (x: number, y: number) => (y % rows) * columns + (x % columns);
  const faces: number[][] = [];
  for (let y = 0; y < rows; y++) {
    for (let x = 0; x < columns; x++) {
      faces.push([at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
    }
  }
  return { positions, faces };
}

export function tetrahedron(): Input {
  return {
    positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
    faces: [
      [0, 2, 1],
      [0, 1, 3],
      [1, 2, 3],
      [2, 0, 3],
    ],
  };
}

/** A ring of quads with a boundary loop on either side. */
export function annulus(columns = 6): Input {
  const { positions, faces } = torus(columns, 3);
  return { positions, faces: faces.slice(0, 2 * columns) };
}

export function puncturedTorus(): Input {
  const { positions, faces } = torus();
  return { positions, faces: faces.slice(1) };
}

/** Two triangles that meet in vertex 2 only. */
export function bowTie(): Input {
  return {
    positions: [0, 0, 0, 0, 1, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0],
    faces: [
      [0, 2, 1],
      [2, 3, 4],
    ],
  };
}

/** Two faces over the same three vertices. */
export function pillow(): Input {
  return {
    positions: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    faces: [
      [0, 1, 2],
      [2, 1, 0],
    ],
  };
}

/** A triangle, and a vertex that nothing uses. */
export function triangleAndIsolatedVertex(): Input {
  return { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5], faces: [[0, 1, 2]] };
}

/**
 * A grid or a torus of triangles, quads and larger polygons, with faces missing: boundaries, holes,
 * several components, pinched and isolated vertices; vertices and faces in random order, and each face
 * beginning anywhere.
 */
export function randomPolygons(seed: number): Input {
  const next = random(seed);
  const columns = 3 + Math.floor(next() * 8);
  const rows = 3 + Math.floor(next() * 8);
  const { positions, faces } = next() < 0.5 ? quadGrid(columns, rows) : torus(columns, rows);
  const missing = next() * 0.4;
  let kept = joinSome(faces, columns, next)
    .filter(() => next() >= missing)
    .flatMap((face) => (face.length === 4 ? cut(face, next) : [face]));
  const vertexCount = positions.length / 3;
  const renamed = shuffle(
    Array.from({ length: vertexCount }, (_, v) => v),
    next,
  );
  kept = shuffle(kept, next).map((face) => {
    const begin = Math.floor(next() * face.length);
    return face.map((_, i) => renamed[face[(begin + i) % face.length]]);
  });
  return { positions: Array.from(positions, () => next()), faces: kept };
}

/** Some quads become hexagons together with the one to their right: `a b . . / d c . .`. */
function joinSome(quads: number[][], columns: number, next: () => number): number[][] {
  const faces: number[][] = [];
  for (let i = 0; i < quads.length; i++) {
    const [a, b, c, d] = quads[i];
    const right = quads[i + 1];
    const joined = columns > 3 && right?.[0] === b && right[3] === c && next() < 0.2;
    if (joined) i += 1;
    faces.push(joined ? [a, b, right[1], right[2], c, d] : [a, b, c, d]);
  }
  return faces;
}

/** A quad as it is, or cut along either diagonal. */
function cut([a, b, c, d]: number[], next: () => number): number[][] {
  const way = next();
  if (way < 0.4) return [[a, b, c, d]];
  return way < 0.7
    ? [
        [a, b, c],
        [a, c, d],
      ]
    : [
        [b, c, d],
        [b, d, a],
      ];
}

/** Two triangles with the edge 0-2 in common. */
export const twoTriangles = () => ({
  positions: [0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0],
  faces: [
    [0, 1, 2],
    [0, 2, 3],
  ],
});

/** The same square as one face. */
export const oneSquare = () => ({ positions: twoTriangles().positions, faces: [[0, 1, 2, 3]] });

/** A random mesh, cut into triangles. Not all can be without joining two vertices twice. */
export function randomTriangles(seed: number): HalfedgeMesh {
  for (let attempt = 0; ; attempt++) {
    const mesh = build(randomPolygons(100 * seed + attempt));
    if (mesh.checkTriangulate() !== null) continue;
    mesh.triangulate();
    return mesh;
  }
}
