import { noisyScan } from './noisy-scan.js';
import { box, type Polygons, sheet, together, toObj, toOff, welded } from './polygons.js';

/** A file with something wrong in it, made here: it is opened like any other file. */
export interface BrokenSample {
  readonly id: string;
  readonly name: string;
  /** In a few words. */
  readonly note: string;
  /** One sentence: what is wrong, what becomes of it, and what to look at. */
  readonly lesson: string;
  readonly view: readonly [number, number, number];
  file(): { readonly extension: string; readonly content: string | Uint8Array };
}

const TURN = 2 * Math.PI;

const obj = (polygons: Polygons) => ({ extension: 'obj', content: toObj(polygons) });
const off = (polygons: Polygons) => ({ extension: 'off', content: toOff(polygons) });

export const brokenSamples: readonly BrokenSample[] = [
  {
    id: 'three-faces',
    name: 'Three faces at an edge',
    note: 'an open book with three pages',
    lesson:
      'All three pages use the edges of the spine, where a surface has room for two: each page gets a copy of the spine, and becomes a sheet of its own.',
    view: [0.5, 0.6, 1],
    file: () => obj(book(3, 5)),
  },
  {
    id: 'flipped-patch',
    name: 'Flipped patch',
    note: 'a patch of a sphere turned inside out',
    lesson:
      'The faces of one patch run clockwise, so that they show their backs: they are turned over, as the majority of the sphere is right.',
    view: [0.55, 0.35, 1],
    file: () => off(flippedPatch()),
  },
  {
    id: 'moebius',
    name: 'Möbius strip',
    note: 'one side only',
    lesson:
      'However the faces are turned, two neighbours disagree somewhere: the strip is cut open along a row of edges from rim to rim, which becomes boundary on both sides.',
    view: [0.1, 1, 1],
    file: () => obj(moebius(48, 6)),
  },
  {
    id: 'klein',
    name: 'Klein bottle',
    note: 'closed, and still without an inside',
    lesson:
      'A tube whose ends are joined the wrong way round has no inside: it is cut open along a ring of as few edges as were found.',
    view: [0.4, 0.7, 1],
    file: () => off(kleinBottle(48, 16)),
  },
  {
    id: 'duplicates',
    name: 'Duplicate faces',
    note: 'faces that are there twice',
    lesson:
      'Some faces of the torus come a second time, begun at another corner or the other way round: one of each is kept, whatever its order.',
    view: [0.35, 0.7, 1],
    file: () => obj(duplicates()),
  },
  {
    id: 'touching-cubes',
    name: 'Two cubes, one corner',
    note: 'solids that share one vertex',
    lesson:
      'The cubes share one vertex and no edge, so that no single ring of faces goes around it: it is doubled, and each cube is closed by itself.',
    view: [1, 0.3, -0.9],
    file: () => obj(touchingCubes()),
  },
  {
    id: 'degenerate',
    name: 'Degenerate faces',
    note: 'two corners, or the same corner twice',
    lesson:
      'Among the squares are faces with two corners, and with the same corner twice: those that still enclose something are simplified, the others left out.',
    view: [0.25, 0.9, 0.9],
    file: () => off(degenerate()),
  },
  {
    id: 'not-there',
    name: 'Nowhere and not there',
    note: 'a position “nan”, a vertex number too high',
    lesson:
      'One vertex is at “nan”, and some faces use vertices that the file does not have: they are left out, and the holes are where they were.',
    view: [0.25, 0.9, 0.9],
    file: notThere,
  },
  {
    id: 'crack',
    name: 'Crack',
    note: 'two halves that only touch',
    lesson:
      'The halves meet in the same places but share no vertices, so that the red seam is boundary twice: “Stitch boundaries” in the Edit tab joins them.',
    view: [0.45, 0.3, 1],
    file: () => off(crackedSphere()),
  },
  {
    id: 't-junction',
    name: 'T-junctions',
    note: 'two edges along one',
    lesson:
      'Large squares lie along small ones whose middle vertices they do not use: the mesh is valid, but each red slit is boundary, as wide as nothing.',
    view: [0.2, 1, 0.8],
    file: () => obj(tJunctions()),
  },
  {
    id: 'isolated',
    name: 'Isolated vertices',
    note: 'points that no face uses',
    lesson:
      'Around the box float points that belong to no face: they are kept and do no harm; “Delete isolated” in the Edit tab removes them.',
    view: [0.7, 0.5, 1],
    file: () => obj(isolated()),
  },
  {
    id: 'scan',
    name: 'Noisy scan',
    note: '60,000 triangles of STL, and all that goes wrong',
    lesson:
      'A soup of triangles as a scanner leaves it, with triangles turned over, repeated, missing, and fins that stand out: everything but the missing ones is repaired.',
    view: [0.3, 0.3, 1],
    file: () => ({ extension: 'stl', content: noisyScan(60_000) }),
  },
  {
    id: 'cut-short',
    name: 'Cut short',
    note: 'a download that broke off: cannot be opened',
    lesson:
      'A file that ends too early can’t be opened: the sentence says where it ends, and what is missing.',
    view: [0.3, 0.3, 1],
    file: () => {
      const whole = toOff(flippedPatch());
      return { extension: 'off', content: whole.slice(0, Math.floor(0.6 * whole.length)) };
    },
  },
];

/** `pages` of `rows` squares around one spine. */
function book(pages: number, rows: number): Polygons {
  const leaves = Array.from({ length: pages }, (_, page) => {
    const angle = (TURN * page) / pages + 0.35;
    return sheet(4, rows, (u, v) => {
      const bent = angle + 0.28 * u * u;
      return [u * Math.cos(bent), 1.5 * (v - 0.5), u * Math.sin(bent)];
    });
  });
  return welded(together(...leaves));
}

const onSphere = (u: number, v: number): number[] => {
  const [around, down] = [TURN * u, Math.PI * v];
  return [Math.sin(down) * Math.cos(around), Math.cos(down), -Math.sin(down) * Math.sin(around)];
};

/** Corners in a row at the same vertex count as one: rows at the poles are triangles. */
function withoutRepeats({ positions, faces }: Polygons): Polygons {
  const ring = (face: number[]) => face.filter((v, i) => v !== face[(i + 1) % face.length]);
  return { positions, faces: faces.map(ring).filter(({ length }) => length > 2) };
}

/** Outside out: rows run down from the pole. */
function sphere(around: number, down: number): Polygons {
  const { positions, faces } = sheet(around, down, onSphere);
  return withoutRepeats(welded({ positions, faces: faces.map((face) => face.reverse()) }));
}

const middle = ({ positions }: Polygons, face: readonly number[]): number[] =>
  [0, 1, 2].map((k) => face.reduce((sum, v) => sum + positions[v][k], 0) / face.length);

function flippedPatch(): Polygons {
  const whole = sphere(32, 20);
  const towards = [0.62, 0.3, 0.72];
  const faces = whole.faces.map((face) => {
    const along = middle(whole, face).reduce((sum, x, k) => sum + x * towards[k], 0);
    return along > 0.86 ? [...face].reverse() : face;
  });
  return { positions: whole.positions, faces };
}

/** Joins the last column of a sheet to the first, upside down. */
function joinTwisted({ positions, faces }: Polygons, columns: number, rows: number): Polygons {
  const width = columns + 1;
  const joined = (v: number) =>
    v % width === columns ? (rows - Math.floor(v / width)) * width : v;
  const used = faces.map((face) => face.map(joined));
  return compacted({ positions, faces: used });
}

/** Without the vertices that no face uses. */
function compacted({ positions, faces }: Polygons): Polygons {
  const numbers = new Map<number, number>();
  for (const v of faces.flat()) if (!numbers.has(v)) numbers.set(v, numbers.size);
  return {
    positions: [...numbers.keys()].map((v) => positions[v]),
    faces: faces.map((face) => face.map((v) => numbers.get(v) as number)),
  };
}

function moebius(around: number, across: number): Polygons {
  const strip = sheet(around, across, (u, v) => {
    const [turn, off] = [TURN * u, 0.8 * (v - 0.5)];
    const out = 1 + off * Math.cos(turn / 2);
    return [out * Math.cos(turn), off * Math.sin(turn / 2), -out * Math.sin(turn)];
  });
  return joinTwisted(strip, around, across);
}

/** The figure-eight immersion: a loop like an 8 that makes half a turn on its way around. */
function kleinBottle(around: number, across: number): Polygons {
  const tube = sheet(around, across, (u, v) => {
    const [turn, way] = [TURN * u, TURN * v];
    const [along, up] = [Math.sin(way), Math.sin(2 * way)];
    const out = 1.6 + along * Math.cos(turn / 2) - 0.6 * up * Math.sin(turn / 2);
    const height = along * Math.sin(turn / 2) + 0.6 * up * Math.cos(turn / 2);
    return [out * Math.cos(turn), height, -out * Math.sin(turn)];
  });
  // The first row is the last; and after half a turn, place v of the loop is at place 1 − v.
  const width = around + 1;
  const ring = (v: number) => (v >= across * width ? v - across * width : v);
  const faces = tube.faces.map((face) =>
    face.map((v) => {
      const row = Math.floor(ring(v) / width);
      return v % width === around ? ((across - row) % across) * width : ring(v);
    }),
  );
  return compacted({ positions: tube.positions, faces });
}

function duplicates(): Polygons {
  const torus = welded(
    sheet(36, 16, (u, v) => {
      const out = 1 + 0.42 * Math.cos(TURN * v);
      return [out * Math.cos(TURN * u), 0.42 * Math.sin(TURN * v), -out * Math.sin(TURN * u)];
    }),
  );
  const again = torus.faces
    .filter((_, i) => i % 7 === 3)
    .map((face, i) => {
      const turned = [...face.slice(i % 4), ...face.slice(0, i % 4)];
      return i % 3 === 0 ? turned.reverse() : turned;
    });
  return { positions: torus.positions, faces: [...torus.faces, ...again] };
}

function touchingCubes(): Polygons {
  return welded(together(box([-1, -1, -1], [0, 0, 0]), box([0, 0, 0], [1, 1, 1])));
}

const wave = (u: number, v: number): number[] => [
  2 * u - 1,
  0.14 * Math.sin(5 * u) * Math.cos(4 * v),
  1 - 2 * v,
];

function degenerate(): Polygons {
  const { positions, faces } = sheet(10, 10, wave);
  const spoilt = faces.map(([a, b, c, d], i) => {
    if (i % 23 === 7) return [a, b, b, c, d];
    if (i % 23 === 15) return [a, c];
    if (i % 23 === 19) return [a, b, a];
    return [a, b, c, d];
  });
  return { positions, faces: spoilt };
}

function notThere() {
  const { positions, faces } = sheet(10, 10, wave);
  const spoilt = faces.map((face, i) => (i % 31 === 12 ? [...face.slice(1), 5000 + i] : face));
  const text = toOff({ positions, faces: spoilt });
  const lines = text.split('\n');
  const nowhere = 2 + 4 * 11 + 6;
  lines[nowhere] = 'nan nan nan';
  return { extension: 'off', content: lines.join('\n') };
}

/** A sphere in two halves, cut along a zigzag, that share no vertices. */
function crackedSphere(): Polygons {
  const whole = sphere(32, 20);
  const half = (upper: boolean) =>
    compacted({
      positions: whole.positions,
      faces: whole.faces.filter((face) => {
        const [x, y, z] = middle(whole, face);
        return y + 0.16 * Math.sin(5 * Math.atan2(z, x)) > 0.12 === upper;
      }),
    });
  return together(half(true), half(false));
}

/** Columns of squares, every other one twice as fine. */
function tJunctions(): Polygons {
  const columns = Array.from({ length: 6 }, (_, i) =>
    sheet(i % 2 ? 2 : 1, i % 2 ? 12 : 6, (u, v) => [(i + u) / 3 - 1, 0, 1 - 2 * v]),
  );
  return welded(together(...columns));
}

function isolated(): Polygons {
  const { positions, faces } = box([-0.6, -0.4, -0.5], [0.6, 0.4, 0.5]);
  const points = Array.from({ length: 40 }, (_, i) => {
    // Evenly over a sphere (a Fibonacci lattice).
    const [y, angle] = [1 - (2 * i + 1) / 40, 2.399963 * i];
    const out = Math.sqrt(1 - y * y);
    return [1.1 * out * Math.cos(angle), 1.1 * y, 1.1 * out * Math.sin(angle)];
  });
  return { positions: [...positions, ...points], faces };
}
