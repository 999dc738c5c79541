/** A polygon mesh as `HalfedgeMesh.fromPolygons` takes it. */
export interface Polygons {
  readonly positions: number[];
  readonly faces: number[][];
}

const GOLDEN = (1 + Math.sqrt(5)) / 2;

/** 12 vertices of valence 5, 20 triangles. */
export function icosahedron(): Polygons {
  const g = GOLDEN;
  // prettier-ignore
  const corners = [
    [-1, g, 0],
    [1, g, 0],
    [-1, -g, 0],
    [1, -g, 0],
    [0, -1, g],
    [0, 1, g],
    [0, -1, -g],
    [0, 1, -g],
    [g, 0, -1],
    [g, 0, 1],
    [-g, 0, -1],
    [-g, 0, 1],
  ];
  // prettier-ignore
  const faces = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
  ];
  return { positions: corners.flat(), faces };
}

/** An icosahedron whose triangles are split in four `levels` times, on the unit sphere. */
export function icosphere(levels: number): Polygons {
  let { positions, faces } = icosahedron();
  const radius = Math.hypot(1, GOLDEN);
  positions = positions.map((x) => x / radius);
  for (let level = 0; level < levels; level++) {
    const middles = new Map<string, number>();
    const middle = (a: number, b: number): number => {
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      const known = middles.get(key);
      if (known !== undefined) return known;
      const sum = [0, 1, 2].map((k) => positions[3 * a + k] + positions[3 * b + k]);
      const length = Math.hypot(...sum);
      const index = positions.length / 3;
      positions.push(...sum.map((x) => x / length));
      middles.set(key, index);
      return index;
    };
    faces = faces.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return [
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ];
    });
  }
  return { positions, faces };
}

/** Six quads. */
export function cube(): Polygons {
  const positions = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    i & 1 ? 1 : -1,
    i & 2 ? 1 : -1,
    i & 4 ? 1 : -1,
  ]);
  // prettier-ignore
  const faces = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  return { positions, faces };
}

/** A torus of `around` × `across` quads: genus 1. */
export function torus(around: number, across: number): Polygons {
  const positions: number[] = [];
  const faces: number[][] = [];
  for (let i = 0; i < around; i++) {
    for (let j = 0; j < across; j++) {
      const u = (2 * Math.PI * i) / around;
      const v = (2 * Math.PI * j) / across;
      const r = 1 + 0.42 * Math.cos(v);
      positions.push(r * Math.cos(u), 0.42 * Math.sin(v), -r * Math.sin(u));
      const at = (a: number, b: number) => (a % around) * across + (b % across);
      faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return { positions, faces };
}

/** 12 pentagons and 20 hexagons: the icosahedron with its corners cut off. */
export function truncatedIcosahedron(): Polygons {
  const { positions: from, faces: triangles } = icosahedron();
  const positions: number[] = [];
  const cuts = new Map<string, number>();
  /** The new vertex on the edge from a to b, a third of the way. */
  const cut = (a: number, b: number): number => {
    const key = `${a} ${b}`;
    const known = cuts.get(key);
    if (known !== undefined) return known;
    const index = positions.length / 3;
    for (let k = 0; k < 3; k++) positions.push((2 * from[3 * a + k] + from[3 * b + k]) / 3);
    cuts.set(key, index);
    return index;
  };
  const following = Array.from({ length: 12 }, () => new Map<number, number>());
  const faces = triangles.map(([a, b, c]) => {
    following[a].set(b, c);
    following[b].set(c, a);
    following[c].set(a, b);
    return [cut(a, b), cut(b, a), cut(b, c), cut(c, b), cut(c, a), cut(a, c)];
  });
  following.forEach((after, a) => {
    const ring: number[] = [];
    let b = after.keys().next().value as number;
    for (let i = 0; i < after.size; i++) {
      ring.push(cut(a, b));
      b = after.get(b) as number;
    }
    faces.push(ring);
  });
  return { positions, faces };
}

/** A gently waving sheet of `size` × `size` quads: one boundary loop. */
export function openGrid(size: number): Polygons {
  const positions: number[] = [];
  const faces: number[][] = [];
  for (let row = 0; row <= size; row++) {
    for (let column = 0; column <= size; column++) {
      const x = (2 * column) / size - 1;
      const y = (2 * row) / size - 1;
      positions.push(x, 0.16 * Math.sin(2.4 * x + 0.6) * Math.cos(2.1 * y), -y);
      if (row === size || column === size) continue;
      const a = row * (size + 1) + column;
      faces.push([a, a + 1, a + size + 2, a + size + 1]);
    }
  }
  return { positions, faces };
}

/** A flat ring of `around` × 2 quads: two boundary loops, Euler characteristic 0. */
export function annulus(around: number): Polygons {
  const positions: number[] = [];
  const faces: number[][] = [];
  for (let i = 0; i < around; i++) {
    const angle = (2 * Math.PI * i) / around;
    for (let ring = 0; ring < 3; ring++) {
      const radius = 0.45 + 0.28 * ring;
      positions.push(radius * Math.cos(angle), 0.05 * (ring % 2), -radius * Math.sin(angle));
    }
    const here = 3 * i;
    const next = 3 * ((i + 1) % around);
    for (let ring = 0; ring < 2; ring++) {
      faces.push([here + ring, here + ring + 1, next + ring + 1, next + ring]);
    }
  }
  return { positions, faces };
}

/** Three fans of triangles that meet in one vertex only: `next` of its boundary joins them. */
export function pinchedVertex(): Polygons {
  const positions = [0, 0, 0];
  const faces: number[][] = [];
  for (let fan = 0; fan < 3; fan++) {
    const first = positions.length / 3;
    const spokes = 4;
    for (let i = 0; i <= spokes; i++) {
      const angle = (2 * Math.PI * (fan + 0.62 * (i / spokes))) / 3;
      positions.push(Math.cos(angle), 0.12 * Math.sin(3 * angle), -Math.sin(angle));
      if (i < spokes) faces.push([0, first + i, first + i + 1]);
    }
  }
  return { positions, faces };
}

/** A prism over a five-pointed star: two concave ten-sided faces and ten quads. */
export function starPrism(): Polygons {
  const positions: number[] = [];
  const tips = 5;
  const corners = 2 * tips;
  for (const height of [0.22, -0.22]) {
    for (let i = 0; i < corners; i++) {
      const angle = Math.PI / 2 + (Math.PI * i) / tips;
      const radius = i % 2 === 0 ? 1 : 0.42;
      positions.push(radius * Math.cos(angle), radius * Math.sin(angle), height);
    }
  }
  const front = Array.from({ length: corners }, (_, i) => i);
  const faces = [front, front.map((i) => 2 * corners - 1 - i)];
  for (const i of front) {
    const j = (i + 1) % corners;
    faces.push([j, i, corners + i, corners + j]);
  }
  return { positions, faces };
}
